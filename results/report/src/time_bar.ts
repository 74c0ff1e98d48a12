// The cursor and the zoom that all plots over time share, for the keyboard too.
import { h } from "./dom";
import { time, timeRange } from "./state";

// `end` tells how long the scenario shown is [s].
export function timeBar(end: () => number): { element: HTMLElement; update: () => void } {
  const slider = h("input", {
    type: "range",
    min: 0,
    step: 0.04,
    value: 0,
    "aria-label": "Cursor, time in seconds",
    "data-test": "time-cursor",
    oninput: () => time.set(Number(slider.value)),
  });
  const readout = h("output", { class: "readout", "data-test": "time-readout" });
  const show = (): void => {
    slider.value = String(time.get());
    slider.setAttribute("aria-valuetext", `${time.get().toFixed(2)} seconds`);
    readout.textContent = `${time.get().toFixed(2)} s`;
  };
  const update = (): void => {
    slider.max = String(end());
    if (time.get() > end()) time.set(0);
    show();
  };
  time.subscribe(show);
  const zoom = (text: string, label: string, factor: number | null): HTMLElement =>
    h("button", { type: "button", class: "quiet", "aria-label": label, title: label, "data-test": label.toLowerCase().replaceAll(" ", "-"), onclick: () => zoomBy(factor, end()) }, text);
  const element = h(
    "div",
    { class: "time-bar" },
    slider,
    readout,
    zoom("\u2212", "Zoom out", 2),
    zoom("+", "Zoom in", 0.5),
    zoom("All", "Zoom to all", null),
  );
  update();
  return { element, update };
}

// About the cursor.
function zoomBy(factor: number | null, end: number): void {
  if (factor === null) {
    timeRange.set(null);
    return;
  }
  const [low, high] = timeRange.get() ?? [0, end];
  const width = Math.max(0.2, factor * (high - low));
  if (width >= end) {
    timeRange.set(null);
    return;
  }
  const from = Math.min(Math.max(0, time.get() - width / 2), end - width);
  timeRange.set([from, from + width]);
}
