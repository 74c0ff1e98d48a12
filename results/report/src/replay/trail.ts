// A line of constant width on the screen through the points of all frames, drawn up to the present one.
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";

export class Trail {
  readonly object: Line2;
  private readonly geometry = new LineGeometry();
  private readonly material: LineMaterial;
  private readonly segments: number;

  /** `points`: x, y, z of each frame; may be empty. `width` in pixels; `dash` [m], 0 for a full line. */
  constructor(points: number[], width: number, dash = 0, opacity = 1) {
    this.segments = Math.max(0, points.length / 3 - 1);
    this.material = new LineMaterial({
      linewidth: width, dashed: dash > 0, dashSize: dash, gapSize: dash, transparent: opacity < 1, opacity,
    });
    if (this.segments > 0) this.geometry.setPositions(points);
    this.object = new Line2(this.geometry, this.material);
    if (this.segments > 0 && dash > 0) this.object.computeLineDistances();
    this.object.frustumCulled = false;
    this.object.visible = this.segments > 0;
  }

  paint(color: string | number): void {
    this.material.color.set(color);
  }

  upTo(frame: number): void {
    this.geometry.instanceCount = Math.min(this.segments, frame);
    this.object.visible = this.geometry.instanceCount > 0;
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
