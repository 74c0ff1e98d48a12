// The convex hull of the standing feet on the ground: a see-through area with an edge, or a line between two feet.
import {
  BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Group, Mesh, MeshBasicMaterial, type Vector3,
} from "three";
import { convexHull } from "../hull";

const kMost = 4; // corners
const kEdge = 0.006; // [m] half the width of the edge

export class SupportPolygon {
  readonly object = new Group();
  private readonly area: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly edge: Mesh<BufferGeometry, MeshBasicMaterial>;

  constructor(color: number) {
    this.area = flat(color, 0.2, kMost);
    this.edge = flat(color, 0.85, 4 * kMost);
    const fan = Array.from({ length: kMost - 2 }, (_, i) => [0, i + 1, i + 2]).flat();
    const strips = Array.from({ length: kMost }, (_, i) => [0, 1, 2, 0, 2, 3].map((k) => 4 * i + k)).flat();
    this.area.geometry.setIndex(fan);
    this.edge.geometry.setIndex(strips);
    this.object.add(this.area, this.edge);
  }

  /** `feet` in any order; heights are kept. */
  show(feet: Vector3[], lift: number): void {
    const hull = convexHull(feet);
    this.object.visible = hull.length >= 2;
    const corners = this.area.geometry.getAttribute("position") as BufferAttribute;
    hull.forEach((p, i) => corners.setXYZ(i, p.x, p.y, p.z + lift));
    corners.needsUpdate = true;
    this.area.geometry.setDrawRange(0, 3 * Math.max(0, hull.length - 2));
    const sides = hull.length > 2 ? hull.length : hull.length - 1;
    for (let i = 0; i < sides; ++i) this.setSide(i, hull[i], hull[(i + 1) % hull.length], lift);
    this.edge.geometry.setDrawRange(0, 6 * Math.max(0, sides));
  }

  dispose(): void {
    for (const mesh of [this.area, this.edge]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }

  private setSide(side: number, from: Vector3 | undefined, to: Vector3 | undefined, lift: number): void {
    if (!from || !to) return;
    const length = Math.hypot(to.x - from.x, to.y - from.y) || 1;
    const nx = (-(to.y - from.y) / length) * kEdge;
    const ny = ((to.x - from.x) / length) * kEdge;
    const corners = this.edge.geometry.getAttribute("position") as BufferAttribute;
    const z = lift + 0.001;
    corners.setXYZ(4 * side, from.x + nx, from.y + ny, from.z + z);
    corners.setXYZ(4 * side + 1, from.x - nx, from.y - ny, from.z + z);
    corners.setXYZ(4 * side + 2, to.x - nx, to.y - ny, to.z + z);
    corners.setXYZ(4 * side + 3, to.x + nx, to.y + ny, to.z + z);
    corners.needsUpdate = true;
  }
}

function flat(color: number, opacity: number, corners: number): Mesh<BufferGeometry, MeshBasicMaterial> {
  const geometry = new BufferGeometry();
  const positions = new BufferAttribute(new Float32Array(3 * corners), 3).setUsage(DynamicDrawUsage);
  geometry.setAttribute("position", positions);
  const material = new MeshBasicMaterial({ color, transparent: true, opacity, side: DoubleSide, depthWrite: false });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}
