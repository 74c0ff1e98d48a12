// One plot of the page: drawn when it comes into view, drawn anew when its data or the theme change, with a text
// alternative, download as SVG or PNG, and, over time, the zoom and cursor that all such plots share.
import { type Axis, loadPlotly, type PlotElement, type PlotLayout, type Plotly, type PlotTrace } from "./plotly";
import { h, replaceContent } from "../dom";
import { type Theme, theme, time, timeRange } from "../state";
import { saveImage } from "./download";

export interface Drawing {
  data: PlotTrace[];
  layout: PlotLayout;
  summary: string; // the text alternative, from the data
  note?: string; // instead of the figure's own
  height: number;
  end?: number; // of the time axes [s]
}

export type Missing = { missing: string };

export interface FigureOptions {
  id: string; // data-plot
  title: string;
  note?: string;
  fileName: () => string; // of a download, without the extension
  timeAxes?: readonly string[]; // names of x axes that are time: "xaxis", ...
  draw: (theme: Theme, width: number) => Promise<Drawing | Missing>;
}

const kNarrow = 560; // px: no room for plotly's own legend; the observers' chips stand in for it

const visible = new IntersectionObserver(
  (entries) => {
    for (const entry of entries) figures.get(entry.target)?.setVisible(entry.isIntersecting);
  },
  { rootMargin: "300px 0px" },
);
const resized = new ResizeObserver((entries) => {
  for (const entry of entries) figures.get(entry.target)?.refresh();
});
const figures = new Map<Element, Figure>();

export class Figure {
  readonly element: HTMLElement;
  private readonly host = h("div", { class: "plot" });
  private readonly frame: HTMLElement;
  private readonly note = h("span", { class: "note" });
  private readonly cursors: HTMLElement[];
  private readonly buttons: HTMLElement;
  private plotly: Plotly | null = null;
  private plot: PlotElement | null = null;
  private visible = false;
  private stale = true;
  private width = 0;
  private end = 0;
  private drawn = 0; // counts drawings, so that only the last one asked for appears

  constructor(private readonly options: FigureOptions) {
    const { id, title, note } = options;
    this.note.textContent = note ?? "";
    this.cursors = (options.timeAxes ?? []).map(() => h("div", { class: "cursor", hidden: true }));
    this.frame = h("div", { class: "plot-frame", role: "img", "aria-label": title }, this.host, ...this.cursors);
    this.buttons = h("span", { class: "downloads" }, this.download("svg"), this.download("png"));
    this.element = h(
      "figure",
      { class: "figure", "data-plot": id },
      h("figcaption", {}, h("h4", {}, title), this.note, this.buttons),
      this.frame,
    );
    figures.set(this.frame, this);
    visible.observe(this.frame);
    resized.observe(this.frame);
    theme.subscribe(() => this.invalidate());
    if (options.timeAxes) this.linkTime();
  }

  // The data changed: draw anew, at once if it is in view.
  invalidate(): void {
    this.stale = true;
    this.refresh();
  }

  setVisible(now: boolean): void {
    this.visible = now;
    this.refresh();
  }

  refresh(): void {
    const width = this.frame.clientWidth;
    if (!this.visible || width === 0 || (!this.stale && width === this.width)) return;
    this.stale = false;
    this.width = width;
    void this.draw(width);
  }

  private async draw(width: number): Promise<void> {
    const turn = ++this.drawn;
    const drawing = await this.options.draw(theme.get(), width).catch((error: unknown) => ({ missing: error instanceof Error ? error.message : String(error) }));
    this.plotly = await loadPlotly();
    if (turn !== this.drawn) return;
    if ("missing" in drawing) {
      this.showMissing(drawing.missing);
      return;
    }
    this.element.dataset["state"] = "drawn";
    this.frame.setAttribute("aria-label", `${this.options.title}. ${drawing.summary}`);
    if (!this.plot) replaceContent(this.host);
    this.buttons.hidden = false;
    if (drawing.note !== undefined) this.note.textContent = drawing.note;
    const layout = this.fit(drawing, width);
    const plot = await this.plotly.react(this.host, drawing.data, layout, { displayModeBar: false, responsive: false, showTips: false, doubleClick: false });
    if (!this.plot) this.listen(plot);
    this.plot = plot;
    this.placeCursors(time.get());
  }

  private fit(drawing: Drawing, width: number): PlotLayout {
    const layout: PlotLayout = { ...drawing.layout, width, height: drawing.height, autosize: false };
    if (width < kNarrow) layout["showlegend"] = false;
    this.end = drawing.end ?? 0;
    const range = timeRange.get() ?? [0, this.end];
    for (const name of this.options.timeAxes ?? []) {
      if (layout[name]) layout[name] = { ...(layout[name] as PlotLayout), range: [...range], autorange: false };
    }
    return layout;
  }

  private showMissing(text: string): void {
    if (this.plot) this.plotly?.purge(this.host);
    this.plot = null;
    this.element.dataset["state"] = "missing";
    this.frame.setAttribute("aria-label", `${this.options.title}. ${text}`);
    this.buttons.hidden = true;
    for (const cursor of this.cursors) cursor.hidden = true;
    replaceContent(this.host, h("p", { class: "empty" }, text));
  }

  private download(format: "svg" | "png"): HTMLElement {
    const name = format.toUpperCase();
    const save = (): void => void this.save(format);
    return h("button", { type: "button", class: "quiet", "data-test": `download-${format}`, "aria-label": `Download ${this.options.title} as ${name}`, onclick: save }, name);
  }

  // Always in the light theme, for paper; with the zoom and the hidden lines of the screen.
  private async save(format: "svg" | "png"): Promise<void> {
    const width = Math.max(this.width, 640);
    const drawing = await this.options.draw("light", width);
    if ("missing" in drawing) return;
    await saveImage(this.plot, { ...drawing, width, title: this.options.title }, format, this.options.fileName());
  }

  private listen(plot: PlotElement): void {
    plot.on("plotly_doubleclick", () => {
      if (this.options.timeAxes) timeRange.set(null);
      this.invalidate(); // as it was at first, its other axes too
    });
    if (!this.options.timeAxes) return;
    plot.on("plotly_click", (event) => {
      const x = (event["points"] as { x: unknown }[] | undefined)?.[0]?.x;
      if (typeof x === "number") time.set(x);
    });
    plot.on("plotly_relayout", (event) => {
      for (const name of this.options.timeAxes ?? []) {
        const [low, high] = [event[`${name}.range[0]`], event[`${name}.range[1]`]];
        if (typeof low !== "number" || typeof high !== "number") continue;
        timeRange.set(low <= 0 && high >= this.end ? null : [low, high]);
      }
      this.placeCursors(time.get());
    });
  }

  private linkTime(): void {
    timeRange.subscribe((chosen) => {
      const range = chosen ?? [0, this.end];
      if (!this.visible || !this.plot || this.stale) {
        this.stale = true;
        return;
      }
      const change: PlotLayout = {};
      for (const name of this.options.timeAxes ?? []) {
        const axis = this.plot._fullLayout?.[name] as Axis | undefined;
        if (axis && (axis.range[0] !== range[0] || axis.range[1] !== range[1])) change[`${name}.range`] = [...range];
      }
      if (Object.keys(change).length > 0) void this.plotly?.relayout(this.host, change);
    });
    time.subscribe((t) => {
      if (this.visible) this.placeCursors(t);
    });
  }

  private placeCursors(t: number): void {
    const layout = this.plot?._fullLayout;
    this.cursors.forEach((cursor, i) => {
      const axis = layout?.[this.options.timeAxes?.[i] ?? ""] as Axis | undefined;
      const size = layout?._size;
      const x = axis ? axis.l2p(t) : -1;
      cursor.hidden = !axis || !size || x < 0 || x > axis._length;
      if (!axis || !size || cursor.hidden) return;
      cursor.style.transform = `translateX(${axis._offset + x}px)`;
      cursor.style.top = `${size.t}px`;
      cursor.style.height = `${size.h}px`;
    });
  }
}
