// One run on the stage: its robot, what is drawn around it, its blocks.
import { Group, Vector3 } from "three";
import type { Cell, Report, Robot, Trace } from "../data";
import { millimetres, seconds } from "../format";
import { blocksOf } from "../terrain";
import { Blocks } from "./ground";
import { kOverlayNames, Overlays, type OverlayName, type Scales } from "./overlays";
import { Recording } from "./recording";
import { RobotModel } from "./robot_model";

const kFromGhost: OverlayName[] = ["disturbance", "estimate", "comEstimate", "com", "feet"]; // what a ghost shows
const com = new Vector3();
const other = new Vector3();

export class Actor {
  readonly object = new Group();
  readonly recording: Recording;
  readonly note: string; // what of its ground is not drawn, and why
  private readonly robot: RobotModel;
  private readonly overlays: Overlays;
  private readonly blocks: Blocks;
  private readonly cell: Cell | undefined;
  private ghost = false;

  constructor(
    data: Report,
    robot: Robot,
    trace: Trace,
    readonly label: string,
    readonly color: string,
    scales: Scales,
  ) {
    this.cell = data.cells[trace.info.cell];
    this.recording = new Recording(trace, trace.info.replay);
    this.robot = new RobotModel(robot);
    this.overlays = new Overlays(this.robot, this.recording, scales);
    const { boxes, note } = blocksOf(data, trace.info);
    this.note = note;
    this.blocks = new Blocks(boxes);
    this.object.add(this.robot.root, this.overlays.object, this.blocks.object);
  }

  /** A ghost is translucent, and of what is drawn around it only the disturbance and the traces are kept. */
  setGhost(ghost: boolean): void {
    this.ghost = ghost;
    this.blocks.object.visible = !ghost;
  }

  paint(dark: boolean): void {
    this.robot.paint(this.color, dark, this.ghost);
    this.overlays.paint(this.color);
    this.blocks.paint(dark);
  }

  showOverlays(on: ReadonlySet<OverlayName>): void {
    for (const name of kOverlayNames) this.overlays.setVisible(name, on.has(name) && (!this.ghost || kFromGhost.includes(name)));
  }

  seek(t: number): void {
    this.recording.seek(t);
    this.robot.pose(this.recording);
    this.overlays.update();
  }

  /** What the camera looks at: a constant height above the ground below the trunk. */
  target(out: Vector3): Vector3 {
    this.recording.vector("trunk", "m", out);
    return out.setZ(0.3);
  }

  /** "fell at 21.3 s (reason)" from that moment on, else nothing. */
  fall(t: number): string {
    if (this.cell?.outcome !== "fell") return "";
    const fall = this.cell.fall_time_s ?? this.recording.end;
    if (t < Math.min(fall, this.recording.end)) return "";
    return `fell at ${seconds(fall)}${this.cell.reason ? ` (${this.cell.reason})` : ""}`;
  }

  /** The present values in words. */
  values(t: number): string {
    const parts: string[] = [];
    const { recording } = this;
    if (recording.vector("com", "m", com)) {
      if (recording.vector("com_reference", "m", other)) parts.push(`CoM error ${this.error("com_error_m", com.distanceTo(other))}`);
      if (recording.vector("path", "m", other)) parts.push(`path error ${this.error("path_error_m", Math.hypot(com.x - other.x, com.y - other.y))}`);
    }
    if (recording.vector("trunk", "m", com)) parts.push(`trunk at ${com.toArray().map((x) => x.toFixed(2)).join(", ")} m`);
    const pushed = recording.vector("applied/point", "m", com);
    if (pushed && recording.vector("applied/force", "N", other)) parts.push(`disturbance ${other.length().toFixed(1)} N`);
    const fall = this.fall(t);
    return [...(fall ? [fall] : []), ...parts].join(", ");
  }

  /** As the plots have it; without them from the replay's positions, whose steps of 0.5 mm give whole millimetres. */
  private error(signal: string, replayed_m: number): string {
    const plotted = this.recording.plotted(signal);
    return `${Number.isFinite(plotted) ? millimetres(plotted) : (1e3 * replayed_m).toFixed(0)} mm`;
  }

  dispose(): void {
    this.robot.dispose();
    this.overlays.dispose();
    this.blocks.dispose();
    this.object.removeFromParent();
  }
}
