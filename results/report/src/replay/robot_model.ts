// The robot as simple solids: nested frames, one for each link of the description, turned by the joints' angles.
//
// The frames are those of robot/description.h: at zero angles all have the axes of the base frame (x to the front,
// y to the left, z up), so that a joint needs its origin and its axis only.
import {
  BoxGeometry, type BufferGeometry, CylinderGeometry, Group, Matrix4, Mesh, MeshStandardMaterial, Object3D,
  SphereGeometry, Vector3,
} from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import type { Link, Robot, Shape } from "../data";
import type { Recording } from "./recording";

const kLinkNames = ["hip", "upper", "lower"]; // of a leg, from the trunk outwards
// What the description has no size for, as shares of a stretched leg.
const kDrum = { radius: 0.068, length: 0.122 };
const kRod = 0.0195; // radius

interface Joint {
  frame: Object3D;
  axis: Vector3;
  signal: string; // its angle
}

export class RobotModel {
  readonly root = new Group();
  readonly legs: string[];
  private readonly joints: Joint[] = [];
  private readonly feet: Object3D[] = [];
  private readonly body = new MeshStandardMaterial({ roughness: 0.5, metalness: 0.1 });
  private readonly limb = new MeshStandardMaterial({ roughness: 0.6, metalness: 0.2 });
  private readonly joint = new MeshStandardMaterial({ roughness: 0.45, metalness: 0.3 });
  private readonly geometries: BufferGeometry[] = [];
  private readonly leg: number; // [m] stretched

  constructor(robot: Robot) {
    this.legs = robot.feet.map((foot) => foot.leg);
    this.leg = Math.max(...robot.feet.map((foot) => Math.hypot(...(robot.links[foot.link]?.origin ?? [])) + Math.hypot(...foot.center)));
    const frames: Object3D[] = [];
    for (const link of robot.links) {
      const frame = new Group();
      frames.push(frame);
      (frames[link.parent] ?? this.root).add(frame);
      if (link.joint >= 0) this.addJoint(link, frame);
      for (const shape of link.shapes) frame.add(this.solid(shape, link.joint < 0 ? this.body : this.limb));
    }
    this.addFront(robot.links[0], frames[0]);
    for (const foot of robot.feet) {
      const frame = frames[foot.link];
      const ball = this.mesh(new SphereGeometry(foot.radius, 24, 16), this.body);
      ball.position.fromArray(foot.center);
      frame?.add(ball);
      this.addShank(foot, robot.links[foot.link], frame);
      this.feet.push(ball);
    }
  }

  /** Takes the pose of the recording's present time. */
  pose(recording: Recording): void {
    recording.vector("trunk", "m", this.root.position);
    recording.trunkRotation(this.root.quaternion);
    for (const joint of this.joints) {
      const angle = recording.number(joint.signal);
      joint.frame.quaternion.setFromAxisAngle(joint.axis, Number.isNaN(angle) ? 0 : angle);
    }
    this.root.updateMatrixWorld(true);
  }

  /** Centre of a foot's sphere in the world [m], in the present pose; `leg` counts in the order of `legs`. */
  foot(leg: number, out: Vector3): Vector3 {
    return this.feet[leg] ? this.feet[leg].getWorldPosition(out) : out.set(NaN, NaN, NaN);
  }

  /** `ghost`: see-through and without a shadow. */
  paint(color: string, dark: boolean, ghost: boolean): void {
    this.body.color.set(color);
    this.limb.color.set(dark ? 0xb4bcc6 : 0x59636e);
    this.joint.color.set(dark ? 0x76808c : 0x2c343c);
    for (const material of [this.body, this.limb, this.joint]) {
      if (ghost) material.color.lerp(this.body.color, 0.6);
      material.transparent = ghost;
      material.opacity = ghost ? 0.38 : 1;
      material.needsUpdate = true;
    }
    this.root.traverse((object) => {
      object.castShadow = !ghost;
    });
  }

  dispose(): void {
    for (const geometry of this.geometries) geometry.dispose();
    for (const material of [this.body, this.limb, this.joint]) material.dispose();
  }

  private addJoint(link: Link, frame: Object3D): void {
    frame.position.fromArray(link.origin);
    const leg = this.legs[Math.floor(link.joint / 3)];
    this.joints.push({
      frame,
      axis: new Vector3().fromArray(link.axis),
      signal: `${leg}/${kLinkNames[link.joint % 3]}/angle_rad`,
    });
    // A drive at the joint: a drum around its axis.
    const drum = this.mesh(new CylinderGeometry(kDrum.radius * this.leg, kDrum.radius * this.leg, kDrum.length * this.leg, 28), this.joint);
    drum.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), new Vector3().fromArray(link.axis).normalize());
    frame.add(drum);
  }

  // A plate at the trunk's front, so that one sees where it walks.
  private addFront(trunk: Link | undefined, frame: Object3D | undefined): void {
    const box = trunk?.shapes.find((shape) => shape.kind === "box");
    if (!box || !frame) return;
    const [length, width, height] = [0, 1, 2].map((axis) => extent(box, axis)) as [number, number, number];
    const plate = this.mesh(new RoundedBoxGeometry(0.02, 0.55 * width, 0.6 * height, 3, 0.008), this.joint);
    plate.position.fromArray(box.position);
    plate.position.x += length / 2;
    frame.add(plate);
  }

  // The collision cylinder of a lower leg ends before the foot: a thin rod closes the gap.
  private addShank(foot: Robot["feet"][number], link: Link | undefined, frame: Object3D | undefined): void {
    const cylinder = link?.shapes.find((shape) => shape.kind === "cylinder");
    if (!cylinder || !frame) return;
    const to = new Vector3().fromArray(foot.center);
    const from = new Vector3().fromArray(cylinder.position);
    const rod = this.mesh(new CylinderGeometry(kRod * this.leg, kRod * this.leg, from.distanceTo(to), 16), this.joint);
    rod.position.copy(from).lerp(to, 0.5);
    rod.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), to.sub(from).normalize());
    frame.add(rod);
  }

  private solid(shape: Shape, material: MeshStandardMaterial): Mesh {
    const mesh = this.mesh(geometryOf(shape), material);
    const [a = 1, b = 0, c = 0, d = 0, e = 1, f = 0, g = 0, h = 0, i = 1] = shape.rotation;
    mesh.quaternion.setFromRotationMatrix(new Matrix4().set(a, b, c, 0, d, e, f, 0, g, h, i, 0, 0, 0, 0, 1));
    mesh.position.fromArray(shape.position);
    return mesh;
  }

  private mesh(geometry: BufferGeometry, material: MeshStandardMaterial): Mesh {
    this.geometries.push(geometry);
    return new Mesh(geometry, material);
  }
}

// Of a box along an axis of its link [m].
function extent(box: Shape, axis: number): number {
  return box.size.reduce((sum, edge, i) => sum + Math.abs(box.rotation[3 * axis + i] ?? 0) * edge, 0);
}

function geometryOf(shape: Shape): BufferGeometry {
  const [x = 0, y = 0, z = 0] = shape.size;
  if (shape.kind === "box") {
    const edge = Math.min(x, y, z);
    return edge > 0.02 ? new RoundedBoxGeometry(x, y, z, 4, 0.18 * edge) : new BoxGeometry(x, y, z);
  }
  if (shape.kind === "sphere") return new SphereGeometry(x, 24, 16);
  return new CylinderGeometry(x, x, y, 24).rotateX(Math.PI / 2); // ours lie along z, three's along y
}
