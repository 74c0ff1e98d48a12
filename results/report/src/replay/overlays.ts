// What is drawn around a robot: forces, disturbances and their estimates, footholds, support, traces.
import {
  type BufferGeometry, CircleGeometry, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, type Object3D, RingGeometry, SphereGeometry, Vector3,
} from "three";
import type { Trace } from "../data";
import { Arrow } from "./arrow";
import { Recording } from "./recording";
import type { RobotModel } from "./robot_model";
import { SupportPolygon } from "./support_polygon";
import { Trail } from "./trail";

// Told apart from one another and, by their place, from the observers' colours; the legend shows them.
export const kOverlays = {
  contact: { label: "Ground reaction forces", color: 0x2a9d8f, on: true },
  disturbance: { label: "True disturbance", color: 0xd62839, on: true },
  estimate: { label: "Estimated at its point", color: 0x8338ec, on: true },
  comEstimate: { label: "Estimated at the CoM", color: 0x8ab800, on: true },
  footholds: { label: "Planned footholds", color: 0xf4a300, on: true },
  support: { label: "Support polygon", color: 0x3a86d4, on: true },
  com: { label: "CoM and its trace on the ground", color: null, on: true },
  path: { label: "Commanded path", color: 0x7d8793, on: true },
  zmp: { label: "ZMP reference, centre of pressure", color: 0x14b8d4, on: false },
  feet: { label: "Traces of the feet", color: 0xa0a8b2, on: false },
} as const;

export type OverlayName = keyof typeof kOverlays;
export const kOverlayNames = Object.keys(kOverlays) as OverlayName[];

/** For CSS and canvas; null: the run's own colour. */
export function overlayColor(name: OverlayName): string | null {
  const { color } = kOverlays[name];
  return color === null ? null : `#${color.toString(16).padStart(6, "0")}`;
}

export interface Scales {
  contact: number; // [N/m]
  disturbance: number; // [N/m] of the true and the estimated one
}

const kLift = 0.004; // [m] of flat things above the ground, against flicker
const p = new Vector3();
const v = new Vector3();

export class Overlays {
  readonly object = new Group();
  private readonly layers = new Map<OverlayName, Group>();
  private readonly contacts: Arrow[];
  private readonly disturbance = new Arrow(kOverlays.disturbance.color, 0.014, 0.45);
  private readonly estimate = new Arrow(kOverlays.estimate.color, 0.0065);
  private readonly comEstimate = new Arrow(kOverlays.comEstimate.color, 0.0065);
  private readonly rings: Disc[];
  private readonly support = new SupportPolygon(kOverlays.support.color);
  private readonly comBall = new Mesh(new SphereGeometry(0.022, 20, 14), new MeshStandardMaterial({ roughness: 0.4, depthTest: false, transparent: true }));
  private readonly comTrail: Trail;
  private readonly path: Trail;
  private readonly footTrails: Trail[];
  private readonly zmp: Disc[];
  private readonly stance: Vector3[] = [];
  private readonly corners: Vector3[];

  constructor(
    private readonly robot: RobotModel,
    private readonly recording: Recording,
    private readonly scales: Scales,
  ) {
    this.contacts = robot.legs.map(() => new Arrow(kOverlays.contact.color, 0.01));
    this.corners = robot.legs.map(() => new Vector3());
    this.rings = robot.legs.map(() => disc(new RingGeometry(0.024, 0.033, 36), kOverlays.footholds.color));
    this.zmp = [disc(new RingGeometry(0.012, 0.02, 24), kOverlays.zmp.color), disc(new CircleGeometry(0.012, 24), kOverlays.zmp.color)];
    this.comTrail = new Trail(recording.polyline("com", "m", kLift, true), 3);
    this.path = new Trail(recording.polyline("path", "m", 0.5 * kLift, true), 2, 0.05);
    this.path.paint(kOverlays.path.color);
    this.path.upTo(recording.frames);
    this.footTrails = this.tracesOfFeet();
    this.comBall.renderOrder = 5;
    const layers: Record<OverlayName, Object3D[]> = {
      contact: this.contacts.map((arrow) => arrow.object),
      disturbance: [this.disturbance.object],
      estimate: [this.estimate.object],
      comEstimate: [this.comEstimate.object],
      footholds: this.rings,
      support: [this.support.object],
      com: [this.comBall, this.comTrail.object],
      path: [this.path.object],
      zmp: this.zmp,
      feet: this.footTrails.map((trail) => trail.object),
    };
    for (const name of kOverlayNames) this.addLayer(name, layers[name]);
  }

  paint(color: string): void {
    this.comTrail.paint(color);
    this.comBall.material.color.set(color);
    for (const trail of this.footTrails) trail.paint(kOverlays.feet.color);
  }

  setVisible(name: OverlayName, visible: boolean): void {
    const layer = this.layers.get(name);
    if (layer) layer.visible = visible;
  }

  /** To the recording's present time, after the robot has taken its pose. */
  update(): void {
    this.updateFeet();
    this.updateDisturbance();
    const hasCom = this.recording.vector("com", "m", p);
    this.comBall.visible = hasCom;
    if (hasCom) this.comBall.position.copy(p);
    this.comTrail.upTo(this.recording.frame);
    for (const trail of this.footTrails) trail.upTo(this.recording.frame);
    ["zmp/reference", "zmp/cop"].forEach((name, i) => this.put(this.zmp[i], name));
  }

  dispose(): void {
    for (const arrow of [...this.contacts, this.disturbance, this.estimate, this.comEstimate]) arrow.dispose();
    for (const trail of [this.comTrail, this.path, ...this.footTrails]) trail.dispose();
    for (const mesh of [...this.rings, ...this.zmp, this.comBall]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.support.dispose();
  }

  private updateFeet(): void {
    this.stance.length = 0;
    this.robot.legs.forEach((leg, l) => {
      const foot = this.robot.foot(l, this.corners[l] ?? p);
      const stands = this.recording.flag(`${leg}/stance`);
      if (stands) this.stance.push(foot);
      if (this.recording.vector(`${leg}/force`, "N", v)) this.contacts[l]?.point(foot, v.divideScalar(this.scales.contact));
      else this.contacts[l]?.hide();
      const ring = this.rings[l];
      this.put(ring, `${leg}/foothold`);
      if (ring) ring.material.opacity = stands ? 0.35 : 1;
    });
    // The polygon lies on the ground below the feet's spheres.
    for (const foot of this.stance) foot.z = 0;
    this.support.show(this.stance, kLift);
  }

  private updateDisturbance(): void {
    const { recording } = this;
    const acts = recording.vector("applied/point", "m", p);
    this.arrow(this.disturbance, acts, p, "applied/force");
    this.arrow(this.estimate, acts, p, "force_estimate");
    const com = recording.vector("com", "m", p);
    this.arrow(this.comEstimate, com, p, "com_force_estimate");
  }

  private arrow(arrow: Arrow, applies: boolean, from: Vector3, force: string): void {
    if (applies && this.recording.vector(force, "N", v)) arrow.point(from, v.divideScalar(this.scales.disturbance));
    else arrow.hide();
  }

  private put(mesh: Mesh | undefined, signal: string): void {
    if (!mesh) return;
    mesh.visible = this.recording.vector(signal, "m", p);
    if (mesh.visible) mesh.position.set(p.x, p.y, p.z + kLift + 0.002);
  }

  private tracesOfFeet(): Trail[] {
    const points: number[][] = this.robot.legs.map(() => []);
    for (let i = 0; i < this.recording.frames; ++i) {
      this.recording.seek(i / this.recording.rate);
      this.robot.pose(this.recording);
      points.forEach((list, l) => list.push(...this.robot.foot(l, p).toArray()));
    }
    return points.map((list) => new Trail(list, 1.5, 0, 0.8));
  }

  private addLayer(name: OverlayName, objects: Object3D[]): void {
    const layer = new Group();
    layer.add(...objects);
    layer.visible = kOverlays[name].on;
    this.layers.set(name, layer);
    this.object.add(layer);
  }
}

type Disc = Mesh<BufferGeometry, MeshBasicMaterial>;

function disc(geometry: BufferGeometry, color: number): Disc {
  return new Mesh(geometry, new MeshBasicMaterial({ color, transparent: true, depthWrite: false }));
}

/**
 * One for all runs that stand side by side: no true disturbance is longer than 0.6 m (an estimate that is larger than the
 * truth can be); ground reaction forces have a metre per 250 N.
 */
export function scalesFor(traces: Trace[]): Scales {
  const recordings = traces.map((trace) => new Recording(trace, trace.info.replay));
  const disturbance = Math.max(20, ...recordings.map((recording) => recording.largest("applied/force", "N")));
  return { contact: 250, disturbance: roundScale(disturbance, 0.6) };
}

/** A round number of newtons per metre with which an arrow of `largest_N` is at most `longest` m. */
function roundScale(largest_N: number, longest: number): number {
  const least = largest_N / longest;
  for (let power = 1; ; power *= 10) {
    for (const digit of [1, 2, 5]) if (digit * power >= least) return digit * power;
  }
}
