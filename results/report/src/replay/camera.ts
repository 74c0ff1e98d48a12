// The camera: turns about its target, which may follow the robot.
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

// Offsets from the target [m]; x points in the direction of travel, y to the left, z up. Those that look from the right
// are mirrored when what matters is on the left.
export const kCameraPresets = {
  orbit: { label: "Orbit", offset: new Vector3(-1.05, -1.6, 1.15) },
  side: { label: "Side", offset: new Vector3(0, -2.3, 0.3) },
  front: { label: "Front", offset: new Vector3(2.2, 0, 0.4) },
  top: { label: "Top", offset: new Vector3(0, -0.001, 3.0) },
} as const;

export type CameraPreset = keyof typeof kCameraPresets;

export class FollowCamera {
  readonly camera = new PerspectiveCamera(30, 1, 0.05, 60);
  following = true;
  private readonly orbit: OrbitControls;
  private readonly robot = new Vector3();
  private preset: CameraPreset = "orbit";
  private fromLeft = false;

  constructor(canvas: HTMLCanvasElement, onChange: () => void) {
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.minDistance = 0.5;
    this.orbit.maxDistance = 20;
    this.orbit.maxPolarAngle = 0.5 * Math.PI - 0.02; // stays above the ground
    this.orbit.enableDamping = false;
    // The wheel and a finger's stroke scroll the page until the canvas has the focus.
    this.orbit.enableZoom = false;
    canvas.addEventListener("focus", () => (this.orbit.enableZoom = true));
    canvas.addEventListener("blur", () => (this.orbit.enableZoom = false));
    canvas.style.touchAction = "pan-y";
    this.orbit.addEventListener("change", onChange);
    this.use("orbit");
  }

  use(preset: CameraPreset): void {
    this.preset = preset;
    const offset = kCameraPresets[preset].offset.clone();
    if (this.fromLeft && offset.y < -0.1) offset.y *= -1;
    this.orbit.target.copy(this.robot);
    this.camera.position.copy(this.robot).add(offset);
    this.orbit.update();
  }

  /** The side of the robot that is to be seen. A change takes the camera back to its preset. */
  lookFromLeft(left: boolean): void {
    if (left === this.fromLeft) return;
    this.fromLeft = left;
    this.use(this.preset);
  }

  /** Where the robot is now: the camera goes along by the same way if it follows. */
  track(position: Vector3): void {
    const way = position.clone().sub(this.robot);
    this.robot.copy(position);
    if (!this.following || way.lengthSq() === 0) return;
    this.orbit.target.add(way);
    this.camera.position.add(way);
    this.orbit.update();
  }

  /** Looks at the robot from where it would if it had followed all the time. */
  follow(on: boolean): void {
    this.following = on;
    if (!on) return;
    const offset = this.camera.position.clone().sub(this.orbit.target);
    this.orbit.target.copy(this.robot);
    this.camera.position.copy(this.robot).add(offset);
    this.orbit.update();
  }

  zoom(factor: number): void {
    const offset = this.camera.position.clone().sub(this.orbit.target).multiplyScalar(factor);
    this.camera.position.copy(this.orbit.target).add(offset);
    this.orbit.update();
  }

  turn(angle: number): void {
    const offset = this.camera.position.clone().sub(this.orbit.target).applyAxisAngle(this.camera.up, angle);
    this.camera.position.copy(this.orbit.target).add(offset);
    this.orbit.update();
  }

  dispose(): void {
    this.orbit.dispose();
  }
}
