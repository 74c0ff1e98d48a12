// One run as the replay sees it: the signals of its trace at any time between two of its frames.
import { Quaternion, type Vector3 } from "three";
import type { Trace } from "../data";

export interface FrameGrid {
  rate_Hz: number;
  frames: number;
}

const a = new Quaternion();
const b = new Quaternion();

export class Recording {
  readonly frames: number;
  readonly rate: number; // [Hz]
  private readonly columns = new Map<string, Float32Array | null>();
  private first = 0; // the frames on both sides of the present time
  private second = 0;
  private weight = 0; // of the second one

  constructor(
    private readonly trace: Trace,
    grid: FrameGrid,
  ) {
    this.frames = grid.frames;
    this.rate = grid.rate_Hz;
  }

  /** Time of the last frame [s]. */
  get end(): number {
    return Math.max(0, this.frames - 1) / this.rate;
  }

  /** The last frame that is not later than the present time. */
  get frame(): number {
    return this.first;
  }

  has(name: string): boolean {
    return this.column(name) !== null;
  }

  /** Makes t [s] the present time; after the end it is the end. */
  seek(t: number): void {
    const last = Math.max(0, this.frames - 1);
    const at = Math.min(Math.max(t * this.rate, 0), last);
    this.first = Math.floor(at + 1e-6);
    this.second = Math.min(this.first + 1, last);
    this.weight = Math.max(0, at - this.first);
  }

  /** NaN where the signal is missing or does not apply. What applies at one side only holds until the other. */
  number(name: string): number {
    const column = this.column(name);
    if (!column) return NaN;
    const from = column[this.first] ?? NaN;
    const to = column[this.second] ?? NaN;
    return Number.isNaN(to) ? from : from + (to - from) * this.weight;
  }

  /** The plots' value nearest to the present time; NaN without one. */
  plotted(name: string): number {
    const { bucket_s } = this.trace.info.plots;
    const values = this.trace.plot(name);
    const at = Math.floor((this.first + this.weight) / this.rate / (0.5 * bucket_s));
    return values?.[Math.min(at, values.length - 1)] ?? NaN;
  }

  flag(name: string): boolean {
    return (this.column(name)?.[this.first] ?? 0) > 0.5;
  }

  /** NAME/x_UNIT, y and z, at the present time; false where they do not apply. A missing z is 0. */
  vector(name: string, unit: string, out: Vector3): boolean {
    const z = `${name}/z_${unit}`;
    out.set(this.number(`${name}/x_${unit}`), this.number(`${name}/y_${unit}`), this.has(z) ? this.number(z) : 0);
    return Number.isFinite(out.x + out.y + out.z);
  }

  /** Rotation of the trunk at the present time, on the shortest way between the two frames. */
  trunkRotation(out: Quaternion): void {
    this.rotationOf(this.first, a);
    this.rotationOf(this.second, b);
    out.slerpQuaternions(a, b, this.weight);
  }

  /** x, y (, z) of all frames, one after the other; z is `height` where the signal has none, or for all if `flat`. */
  polyline(name: string, unit: string, height: number, flat: boolean): number[] {
    const x = this.column(`${name}/x_${unit}`);
    const y = this.column(`${name}/y_${unit}`);
    if (!x || !y) return [];
    const z = flat ? null : this.column(`${name}/z_${unit}`);
    const points: number[] = [];
    for (let i = 0; i < this.frames; ++i) points.push(x[i] ?? NaN, y[i] ?? NaN, z ? (z[i] ?? NaN) : height);
    return points.every(Number.isFinite) ? points : [];
  }

  /** Largest norm of a vector over the whole run, 0 if it never applies. */
  largest(name: string, unit: string): number {
    const columns = ["x", "y", "z"].map((axis) => this.column(`${name}/${axis}_${unit}`));
    let largest = 0;
    for (let i = 0; i < this.frames; ++i) {
      const norm = Math.hypot(...columns.map((column) => column?.[i] ?? 0));
      if (norm > largest) largest = norm; // (false for NaN)
    }
    return largest;
  }

  private rotationOf(frame: number, out: Quaternion): void {
    const part = (name: string, or: number) => this.column(`trunk/${name}`)?.[frame] ?? or;
    out.set(part("qx", 0), part("qy", 0), part("qz", 0), part("qw", 1)).normalize();
  }

  private column(name: string): Float32Array | null {
    let column = this.columns.get(name);
    if (column === undefined) {
      column = this.trace.replay(name);
      this.columns.set(name, column);
    }
    return column;
  }
}
