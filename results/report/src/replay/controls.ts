// The replay's buttons: what they are called, which keys they have, what they tell. They hold no state of the replay.
import { type CameraPreset, kCameraPresets } from "./camera";
import { kOverlayNames, kOverlays, overlayColor, type OverlayName } from "./overlays";

/** What the controls ask of the replay. */
export interface ReplayActions {
  toggle(): void; // play or pause
  step(frames: number): void;
  seek(t: number): void; // [s]
  setSpeed(factor: number): void;
  setFollow(on: boolean): void;
  setCamera(preset: CameraPreset): void;
  turn(angle: number): void; // [rad]
  zoom(factor: number): void; // of the distance
  setOverlay(name: OverlayName, on: boolean): void;
  savePicture(): void;
}

const icon = (path: string) => `<svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path fill="currentColor" d="${path}"/></svg>`;
const kIcons = {
  play: icon("M4 2l10 6-10 6z"),
  pause: icon("M3 2h4v12H3zM9 2h4v12H9z"),
  back: icon("M12 2v12L4 8zM2 2h2v12H2z"),
  on: icon("M4 2v12l8-6zM12 2h2v12h-2z"),
};

type Choice = [value: string, text: string];

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];

export class Controls {
  readonly bar = element("div", "replay-bar");
  readonly legend = element("details", "replay-legend") as HTMLDetailsElement;
  readonly values = element("p", "replay-values");
  private readonly play = button(kIcons.play, "Play", () => this.actions.toggle());
  private readonly scrub = element("input", "replay-scrub") as HTMLInputElement;
  private readonly clock = element("span", "replay-clock");
  private readonly follow: HTMLLabelElement;
  private readonly scale = element("p", "replay-scale");

  constructor(private readonly actions: ReplayActions) {
    this.scrub.type = "range";
    this.scrub.min = "0";
    this.scrub.setAttribute("aria-label", "Time");
    this.scrub.addEventListener("input", () => actions.seek(Number(this.scrub.value)));
    this.follow = checkbox("Follow", true, (on) => actions.setFollow(on));
    const speeds = kSpeeds.map((s): Choice => [String(s), `${s}×`]);
    const cameras = Object.entries(kCameraPresets).map(([name, preset]): Choice => [name, preset.label]);
    this.bar.append(
      button(kIcons.back, "One frame back", () => actions.step(-1)), this.play, button(kIcons.on, "One frame on", () => actions.step(1)),
      this.scrub, this.clock,
      select("Speed", speeds, "1", (s) => actions.setSpeed(Number(s))),
      select("Camera", cameras, "orbit", (name) => actions.setCamera(name as CameraPreset)),
      this.follow,
      button("Save picture", "Save picture", () => actions.savePicture()),
    );
    this.fillLegend();
  }

  setLength(end: number, rate: number): void {
    this.scrub.step = String(1 / rate);
    this.scrub.max = String(Math.ceil(end * rate - 1e-6) / rate);
  }

  setTime(t: number, end: number): void {
    this.scrub.value = String(t);
    this.scrub.setAttribute("aria-valuetext", `${t.toFixed(2)} seconds`);
    this.clock.textContent = `${t.toFixed(2)} / ${end.toFixed(1)} s`;
  }

  setPlaying(playing: boolean): void {
    this.play.innerHTML = playing ? kIcons.pause : kIcons.play;
    this.play.setAttribute("aria-label", playing ? "Pause" : "Play");
    this.play.title = `${playing ? "Pause" : "Play"} (space)`;
  }

  setFollow(on: boolean): void {
    const box = this.follow.querySelector("input");
    if (box) box.checked = on;
  }

  setScales(contact_N_per_m: number, disturbance_N_per_m: number): void {
    this.scale.textContent =
      `Arrows: 1 m stands for ${contact_N_per_m} N of ground reaction, and for ${disturbance_N_per_m} N of disturbance and estimate.`;
  }

  /** What the arrows' lengths mean, in words. */
  get scales(): string {
    return this.scale.textContent ?? "";
  }

  /** Keys of the whole replay; true if the key was one. */
  key(key: string): boolean {
    const { actions } = this;
    const keys: Record<string, () => void> = {
      " ": () => actions.toggle(),
      ArrowLeft: () => actions.step(-1),
      ArrowRight: () => actions.step(1),
      PageDown: () => actions.step(-25),
      PageUp: () => actions.step(25),
      Home: () => actions.seek(0),
      End: () => actions.seek(Number(this.scrub.max)),
      a: () => actions.turn(-0.15),
      d: () => actions.turn(0.15),
      "+": () => actions.zoom(0.85),
      "-": () => actions.zoom(1 / 0.85),
    };
    keys[key]?.();
    return key in keys;
  }

  private fillLegend(): void {
    const title = element("summary", "");
    title.textContent = "Legend: what is drawn";
    const list = element("div", "replay-overlays");
    for (const name of kOverlayNames) {
      const { label, on } = kOverlays[name];
      const box = checkbox(label, on, (checked) => this.actions.setOverlay(name, checked));
      const swatch = element("span", "replay-swatch");
      swatch.style.background = overlayColor(name) ?? "linear-gradient(90deg, #0072b2, #d55e00)";
      box.insertBefore(swatch, box.lastChild);
      list.append(box);
    }
    const keys = element("p", "replay-keys");
    keys.textContent =
      "Keys on the picture: space plays and pauses, left and right step a frame, page up and down a second, home and end; " +
      "a and d turn the camera, + and - bring it nearer and farther. Drag turns, the wheel zooms after a click into the picture.";
    this.legend.open = true;
    this.legend.append(title, list, this.scale, keys);
  }
}

function element(tag: string, name: string): HTMLElement {
  const made = document.createElement(tag);
  if (name) made.className = name;
  return made;
}

function button(content: string, label: string, action: () => void): HTMLButtonElement {
  const made = element("button", "quiet replay-button") as HTMLButtonElement;
  made.type = "button";
  made.innerHTML = content;
  made.title = label;
  made.setAttribute("aria-label", label);
  made.addEventListener("click", action);
  return made;
}

function checkbox(text: string, on: boolean, action: (on: boolean) => void): HTMLLabelElement {
  const label = element("label", "replay-check") as HTMLLabelElement;
  const box = element("input", "") as HTMLInputElement;
  box.type = "checkbox";
  box.checked = on;
  box.addEventListener("change", () => action(box.checked));
  label.append(box, document.createTextNode(text));
  return label;
}

function select(text: string, options: Choice[], chosen: string, action: (value: string) => void): HTMLLabelElement {
  const label = element("label", "replay-select") as HTMLLabelElement;
  const list = element("select", "") as HTMLSelectElement;
  // Not from the record's order, which sorts numbers first.
  for (const [value, name] of options) list.add(new Option(name, value, value === chosen, value === chosen));
  list.addEventListener("change", () => action(list.value));
  label.append(document.createTextNode(`${text} `), list);
  return label;
}
