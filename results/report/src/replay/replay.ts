// The 3D replay of one or two runs: shows the shared time, and moves it while it plays.
import { Vector3 } from "three";
import { loadTrace, type Report, type Robot, type Trace } from "../data";
import { kNoRobot, robotOf } from "../kinematics";
import { theme, time } from "../state";
import { Actor } from "./actor";
import { AxesGizmo } from "./axes_gizmo";
import { type CameraPreset, FollowCamera } from "./camera";
import { caption } from "./caption";
import { Controls, type ReplayActions } from "./controls";
import { kOverlayNames, kOverlays, overlayColor, type OverlayName, scalesFor } from "./overlays";
import { download, pictureOf } from "./picture";
import { NoWebGl, Stage, type View } from "./scene";

export interface Shown {
  index: number; // of the trace
  label: string;
  color: string;
}

export type Mode = "side" | "ghost";

const kPicture = { width: 1280, height: 720 }; // [px] of a saved one
const kNarrow = 420; // [px] below it two runs stand one above the other

export class Replay implements ReplayActions {
  private readonly root = document.createElement("div");
  private readonly picture = document.createElement("div");
  private readonly captions = document.createElement("div");
  private readonly note = document.createElement("p"); // what of the ground is not drawn
  private readonly controls = new Controls(this);
  private readonly ends: (() => void)[] = [];
  private readonly stage: Stage | null;
  private readonly camera: FollowCamera | null = null;
  private readonly gizmo: AxesGizmo | null = null;
  private readonly overlays = new Set<OverlayName>(kOverlayNames.filter((name) => kOverlays[name].on));
  private actors: Actor[] = [];
  private mode: Mode = "side";
  private speed = 1;
  private playing = false;
  private visible = false;
  private request = 0; // of an animation frame, 0: none
  private before = 0; // [ms] time of the last animation frame
  private shows = 0; // calls of show()
  private title = "";
  private shown = ""; // what show() was last asked for

  constructor(
    host: HTMLElement,
    private readonly data: Report,
  ) {
    this.root.className = "replay-view";
    this.picture.className = "replay-picture";
    this.captions.className = "replay-captions";
    host.append(this.root);
    this.stage = this.makeStage();
    if (!this.stage) return;
    this.camera = new FollowCamera(this.stage.canvas, () => this.invalidate());
    this.gizmo = new AxesGizmo();
    this.stage.canvas.tabIndex = 0;
    this.stage.canvas.setAttribute("role", "img");
    this.picture.append(this.stage.canvas, this.captions);
    this.note.className = "replay-note";
    this.note.hidden = true;
    this.root.append(this.picture, this.note, this.controls.bar, this.controls.values, this.controls.legend);
    this.listen(this.stage.canvas);
    this.stage.paint(theme.get() === "dark");
  }

  /** Decodes the traces and shows them; the first one is what the camera follows. */
  async show(traces: Shown[], mode: Mode): Promise<void> {
    if (!this.stage) return;
    this.mode = mode;
    const asked = JSON.stringify(traces);
    if (asked !== this.shown) {
      this.shown = asked;
      const call = ++this.shows;
      try {
        const loaded = await Promise.all(traces.map((shown) => loadTrace(shown.index)));
        if (call === this.shows) this.stageRuns(traces, loaded); // else another show() came meanwhile, or dispose()
      } catch (error) {
        if (call === this.shows) this.controls.values.textContent = error instanceof Error ? error.message : String(error);
      }
    }
    this.paint();
  }

  toggle(): void {
    if (!this.playing && time.get() >= this.end - 1e-6) time.set(0);
    this.setPlaying(!this.playing);
  }

  step(frames: number): void {
    this.setPlaying(false);
    this.seek((Math.round(time.get() * this.rate) + frames) / this.rate);
  }

  seek(t: number): void {
    time.set(Math.min(Math.max(t, 0), this.end));
  }

  setSpeed(factor: number): void {
    this.speed = factor;
  }

  setFollow(on: boolean): void {
    this.camera?.follow(on);
    this.invalidate();
  }

  setCamera(preset: CameraPreset): void {
    this.camera?.use(preset);
    this.invalidate();
  }

  turn(angle: number): void {
    this.camera?.turn(angle);
  }

  zoom(factor: number): void {
    this.camera?.zoom(factor);
  }

  setOverlay(name: OverlayName, on: boolean): void {
    if (on) this.overlays.add(name);
    else this.overlays.delete(name);
    this.paint();
  }

  savePicture(): void {
    const name = `${this.title}-${this.actors.map((actor) => actor.label).join("-")}-${this.now.toFixed(2)}s.png`;
    this.takePicture().then(
      (blob) => download(blob, name.replace(/[^\w.@-]+/g, "_")),
      (error: unknown) => (this.controls.values.textContent = String(error)),
    );
  }

  /** The picture at t [s] with its caption, as a PNG of the same size in every window. */
  takePicture(t = this.now): Promise<Blob> {
    if (!this.stage) return Promise.reject(new NoWebGl("There is no 3D picture."));
    this.draw(t, kPicture.width, kPicture.height, 1);
    const lines = [`${this.title}, t = ${t.toFixed(2)} s. ${this.controls.scales}`];
    for (const actor of this.actors) lines.push(`${actor.label}: ${actor.values(t)}`);
    lines.push(...this.notes());
    const ownColor = this.actors[0]?.color ?? "#777777";
    const keys = [...this.overlays].map((name) => ({ label: kOverlays[name].label, color: overlayColor(name) ?? ownColor }));
    const picture = pictureOf(this.stage.canvas, lines, keys, theme.get() === "dark"); // copies it before the next line
    this.render();
    return picture;
  }

  dispose(): void {
    ++this.shows;
    this.playing = false;
    cancelAnimationFrame(this.request);
    for (const end of this.ends) end();
    for (const actor of this.actors) actor.dispose();
    this.actors = [];
    this.camera?.dispose();
    this.gizmo?.dispose();
    this.stage?.dispose();
    this.root.remove();
  }

  private get end(): number {
    return Math.max(0, ...this.actors.map((actor) => actor.recording.end));
  }

  private get rate(): number {
    return this.actors[0]?.recording.rate ?? 25;
  }

  /** The shared time within this replay. */
  private get now(): number {
    const t = time.get();
    return Number.isFinite(t) ? Math.min(Math.max(t, 0), this.end) : 0;
  }

  private makeStage(): Stage | null {
    try {
      return new Stage();
    } catch (error) {
      const sentence = document.createElement("p");
      sentence.className = "replay-none";
      sentence.textContent = `No replay: ${error instanceof Error ? error.message : String(error)} The plots do not need it.`;
      this.root.append(sentence);
      return null;
    }
  }

  private listen(canvas: HTMLCanvasElement): void {
    this.ends.push(time.subscribe(() => this.invalidate()), theme.subscribe(() => this.paint()));
    const seen = new IntersectionObserver((entries) => {
      this.visible = entries.some((entry) => entry.isIntersecting);
      this.invalidate();
    });
    seen.observe(canvas);
    const sized = new ResizeObserver(() => this.invalidate());
    sized.observe(this.picture);
    this.ends.push(() => seen.disconnect(), () => sized.disconnect());
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !this.controls.key(event.key)) return;
      event.preventDefault();
    });
    canvas.addEventListener("webglcontextrestored", () => this.invalidate());
  }

  private stageRuns(traces: Shown[], loaded: Trace[]): void {
    for (const actor of this.actors) actor.dispose();
    const scales = scalesFor(loaded);
    this.actors = loaded.map((trace, i) => new Actor(this.data, this.robotOf(trace), trace, traces[i]?.label ?? "", traces[i]?.color ?? "#777777", scales));
    for (const actor of this.actors) this.stage?.scene.add(actor.object);
    this.title = [...new Set(loaded.map((trace) => trace.info.scenario_id))].join(", ");
    const scenario = this.data.scenarios.find((s) => s.id === loaded[0]?.info.scenario_id);
    this.camera?.lookFromLeft(scenario?.metric_leg.startsWith("L") ?? false);
    this.note.textContent = this.notes().join(" ");
    this.note.hidden = this.note.textContent === "";
    this.controls.setLength(this.end, this.rate);
    this.controls.setScales(scales.contact, scales.disturbance);
    this.controls.setFollow(this.camera?.following ?? true);
  }

  private robotOf(trace: Trace): Robot {
    const robot = robotOf(this.data, trace.info.scenario_id);
    if (!robot) throw new Error(kNoRobot); // who shows a run asks first
    return robot;
  }

  private notes(): string[] {
    return [...new Set(this.actors.map((actor) => actor.note))].filter((note) => note !== "");
  }

  private setPlaying(playing: boolean): void {
    this.playing = playing;
    this.before = 0;
    this.controls.setPlaying(playing);
    this.invalidate();
  }

  private paint(): void {
    const dark = theme.get() === "dark";
    this.stage?.paint(dark);
    this.actors.forEach((actor, i) => {
      actor.setGhost(this.mode === "ghost" && i > 0);
      actor.paint(dark);
      actor.showOverlays(this.overlays);
    });
    this.invalidate();
  }

  private invalidate(): void {
    if (this.request !== 0 || !(this.visible || this.playing)) return;
    this.request = requestAnimationFrame((at) => {
      this.request = 0;
      this.advance(at);
      if (this.visible) this.render();
    });
  }

  // While it plays: the shared time goes on by the wall time since the last frame.
  private advance(at: number): void {
    if (!this.playing) return;
    const passed = this.before > 0 ? Math.min(at - this.before, 500) / 1000 : 0;
    this.before = at;
    const t = Math.min(this.now + passed * this.speed, this.end);
    time.set(t);
    if (t >= this.end) this.setPlaying(false);
    this.invalidate();
  }

  private render(): void {
    if (this.actors.length === 0) return;
    this.draw(this.now, this.picture.clientWidth, this.picture.clientHeight, Math.min(window.devicePixelRatio || 1, 2));
    this.write(this.now);
  }

  private draw(t: number, width: number, height: number, ratio: number): void {
    if (!this.stage || !this.camera || !this.gizmo) return;
    for (const actor of this.actors) actor.seek(t);
    const views = this.views();
    this.camera.track(views[0]?.target ?? new Vector3());
    this.stage.resize(width, height, ratio);
    this.stage.draw(views, this.camera.camera, this.gizmo, width, height, width < kNarrow);
  }

  private views(): View[] {
    const targets = this.actors.map((actor) => actor.target(new Vector3()));
    const first = targets[0] ?? new Vector3();
    if (this.mode === "ghost") return [{ objects: this.actors.map((a) => a.object), target: first, shift: new Vector3() }];
    return this.actors.map((actor, i) => {
      const target = targets[i] ?? first;
      return { objects: [actor.object], target, shift: this.camera?.following ? target.clone().sub(first) : new Vector3() };
    });
  }

  private write(t: number): void {
    const stacked = this.picture.clientWidth < kNarrow;
    this.controls.setTime(t, this.end);
    this.controls.values.textContent =
      `t = ${t.toFixed(2)} s. ` + this.actors.map((actor) => `${actor.label}: ${actor.values(t)}.`).join(" ");
    this.captions.dataset.layout = this.mode === "ghost" || this.actors.length < 2 ? "one" : stacked ? "rows" : "columns";
    this.captions.replaceChildren(...this.actors.map((actor) => caption(actor, t)));
    const names = this.actors.map((actor) => `${actor.label}${actor.fall(t) ? `, ${actor.fall(t)}` : ""}`);
    this.stage?.canvas.setAttribute("aria-label", `3D replay of ${this.title}: ${names.join("; ")}`);
  }
}
