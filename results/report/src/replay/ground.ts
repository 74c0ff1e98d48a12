// The ground: shadows on the colour of the background, a grid of 0.5 m that fades into the distance, and blocks.
import {
  BoxGeometry, Color, EdgesGeometry, Group, LineBasicMaterial, LineSegments, BufferGeometry, Float32BufferAttribute, Mesh,
  MeshStandardMaterial, PlaneGeometry, ShadowMaterial,
} from "three";
import type { Box } from "../data";

const kHalf = 30; // [m]
const kCell = 0.5; // [m]

export class Ground {
  readonly object = new Group();
  private readonly shadow = new ShadowMaterial();
  private readonly fine = new LineBasicMaterial();
  private readonly coarse = new LineBasicMaterial();
  private readonly geometries: BufferGeometry[] = [];

  constructor() {
    const plane = new Mesh(this.keep(new PlaneGeometry(2 * kHalf, 2 * kHalf)), this.shadow);
    plane.receiveShadow = true;
    this.object.add(plane, this.grid(false), this.grid(true));
  }

  paint(dark: boolean): void {
    this.shadow.opacity = dark ? 0.55 : 0.22;
    this.fine.color = new Color(dark ? 0x2b323b : 0xdbe1e7);
    this.coarse.color = new Color(dark ? 0x3d4753 : 0xbfc8d1);
  }

  dispose(): void {
    for (const geometry of this.geometries) geometry.dispose();
    for (const material of [this.shadow, this.fine, this.coarse]) material.dispose();
  }

  // Lines at whole metres, or at the halves between them.
  private grid(whole: boolean): LineSegments {
    const points: number[] = [];
    for (let at = -kHalf + (whole ? 0 : kCell); at <= kHalf; at += 2 * kCell) {
      points.push(at, -kHalf, 0, at, kHalf, 0, -kHalf, at, 0, kHalf, at, 0);
    }
    const geometry = this.keep(new BufferGeometry());
    geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
    return new LineSegments(geometry, whole ? this.coarse : this.fine);
  }

  private keep<G extends BufferGeometry>(geometry: G): G {
    this.geometries.push(geometry);
    return geometry;
  }
}

/** The blocks of a scenario; lower friction is darker. */
export class Blocks {
  readonly object = new Group();
  private readonly meshes: Mesh<BoxGeometry, MeshStandardMaterial>[] = [];
  private readonly edges: LineSegments<EdgesGeometry, LineBasicMaterial>[] = [];

  constructor(private readonly boxes: Box[]) {
    for (const box of boxes) {
      const mesh = new Mesh(new BoxGeometry(...box.size), new MeshStandardMaterial({ roughness: 0.9 }));
      mesh.position.fromArray(box.center);
      mesh.rotation.z = box.yaw;
      mesh.receiveShadow = true;
      mesh.castShadow = true;
      const edge = new LineSegments(new EdgesGeometry(mesh.geometry), new LineBasicMaterial());
      mesh.add(edge);
      this.meshes.push(mesh);
      this.edges.push(edge);
      this.object.add(mesh);
    }
  }

  paint(dark: boolean): void {
    this.meshes.forEach((mesh, i) => {
      const friction = Math.min(Math.max(this.boxes[i]?.friction ?? 0.6, 0), 1);
      mesh.material.color.set(dark ? 0x4a4238 : 0xd8c8ae).multiplyScalar(0.65 + 0.5 * friction);
      this.edges[i]?.material.color.set(dark ? 0x7d705f : 0x8f7d60);
    });
  }

  dispose(): void {
    for (const mesh of this.meshes) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    for (const edge of this.edges) {
      edge.geometry.dispose();
      edge.material.dispose();
    }
  }
}
