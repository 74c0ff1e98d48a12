// A solid arrow from a point along a vector: shaft and head keep their thickness, the shaft takes the length.
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshStandardMaterial, Vector3 } from "three";

const kUp = new Vector3(0, 1, 0);
const direction = new Vector3();

export class Arrow {
  readonly object = new Group();
  private readonly material: MeshStandardMaterial;
  private readonly shaft: Mesh;
  private readonly head: Mesh;
  private readonly headLength: number;

  /** `radius` of the shaft [m]; `opacity` below 1 lets another arrow be seen inside. */
  constructor(color: number, radius: number, opacity = 1) {
    this.headLength = 5.5 * radius;
    this.material = new MeshStandardMaterial({
      color, roughness: 0.5, emissive: color, emissiveIntensity: 0.35, transparent: opacity < 1, opacity,
      depthWrite: opacity >= 1,
    });
    this.shaft = new Mesh(new CylinderGeometry(radius, radius, 1, 16).translate(0, 0.5, 0), this.material);
    this.head = new Mesh(new ConeGeometry(2.4 * radius, this.headLength, 20).translate(0, 0.5 * this.headLength, 0), this.material);
    this.object.add(this.shaft, this.head);
    this.object.visible = false;
  }

  /** Hides the arrow if it is shorter than a hair. */
  point(from: Vector3, vector: Vector3): void {
    const length = vector.length();
    this.object.visible = Number.isFinite(length) && length > 2e-3;
    if (!this.object.visible) return;
    this.object.position.copy(from);
    this.object.quaternion.setFromUnitVectors(kUp, direction.copy(vector).divideScalar(length));
    const head = Math.min(this.headLength, 0.5 * length);
    this.head.scale.setScalar(head / this.headLength);
    this.head.position.y = length - head;
    this.shaft.scale.set(1, length - head, 1);
  }

  hide(): void {
    this.object.visible = false;
  }

  dispose(): void {
    this.shaft.geometry.dispose();
    this.head.geometry.dispose();
    this.material.dispose();
  }
}
