// How long a control tick and its quadratic program take: histograms of a serial pass.
import type { PlotTrace } from "./plotly";
import { observerStyles } from "../colors";
import type { Histogram, Timing } from "../data";
import { h } from "../dom";
import { shortName, significant } from "../format";
import type { Theme } from "../state";
import { type Context, fileName } from "./context";
import { type Drawing, Figure, type Missing } from "./figure";
import { axis, baseLayout } from "./layout";

export function timingFigures(context: Context): Figure[] {
  const figure = (id: "tick" | "qp", title: string, note: string): Figure =>
    new Figure({ id, title, note, fileName: () => fileName(context, `${id}_time`), draw: async (theme) => draw(context, id, theme) });
  return [
    figure("tick", "Time of a control tick", "model, observer and controller; share of ticks per bin"),
    figure("qp", "Time of the quadratic program", "share of solves per bin"),
  ];
}

function timingsOf({ report, selection }: Context): Timing[] {
  return report.timing.filter(
    (t) => t.scenario_id === selection.scenario.get() && t.setting === selection.setting.get() && selection.shown.get().has(t.observer_id),
  );
}

function howTo({ report, selection }: Context): string {
  const file = selection.scenario.get().split("/")[0];
  return `No times were measured for ${selection.scenario.get()}: runs side by side say nothing about speed. Measure them one after the other with: dobbench timing ${file} --out ${report.title}, then write this page anew.`;
}

function draw(context: Context, which: "tick" | "qp", theme: Theme): Drawing | Missing {
  const timings = timingsOf(context);
  const styles = observerStyles(context.report.observers, theme);
  const data: PlotTrace[] = [];
  const texts: string[] = [];
  for (const timing of timings) {
    const histogram = timing[`${which}_histogram`];
    if (!histogram) continue;
    const style = styles.get(timing.observer_id)!;
    const name = shortName(timing.observer_id);
    data.push({ ...steps(histogram), name, legendgroup: timing.observer_id, line: { color: style.color, dash: style.dash, width: 1.5, shape: "hv" }, hovertemplate: `%{y:.2~g} %<extra>${name}</extra>` });
    texts.push(`${name} median ${significant(timing[`${which}_p50_us`] ?? NaN)} \u00B5s, 99 % below ${significant(timing[`${which}_p99_us`] ?? NaN)} \u00B5s`);
  }
  if (timings.length === 0) return { missing: howTo(context) };
  if (data.length === 0) return { missing: "The serial pass of this run kept no histogram, only the quantiles in the table below." };
  const wide = data.some((d) => isWide(d["x"] as number[])); // bins are then narrow and wide ones: as equals on a log axis
  const layout = baseLayout(theme, {
    xaxis: axis(theme, "time [\u00B5s]", { unifiedhovertitle: { text: "from %{x:.3~g} \u00B5s" }, zeroline: false, ...(wide ? { type: "log", dtick: "D2" } : {}) }),
    yaxis: axis(theme, "share [%]", { rangemode: "tozero" }),
  });
  return { data, layout, height: 280, summary: `${texts.join("; ")}.` };
}

function isWide(edges: readonly number[]): boolean {
  return edges.length > 1 && edges[0]! > 0 && edges[edges.length - 1]! > 10 * edges[0]!;
}

function steps(histogram: Histogram): PlotTrace {
  const total = histogram.counts.reduce((a, b) => a + b, 0);
  const shares = histogram.counts.map((n) => (100 * n) / Math.max(1, total));
  return { type: "scatter", mode: "lines", x: histogram.edges_us, y: [...shares, 0] };
}

// The quantiles in figures; null without any.
export function timingTable(context: Context): HTMLElement | null {
  const timings = timingsOf(context);
  if (timings.length === 0) return null;
  const number = (x: number | null): HTMLElement => h("td", { class: "number" }, x === null ? "\u2013" : significant(x));
  const rows = timings.map((t) =>
    h("tr", {}, h("th", { scope: "row" }, shortName(t.observer_id, 60)), ...[t.tick_p50_us, t.tick_p99_us, t.tick_max_us, t.qp_p50_us, t.qp_p99_us, t.qp_max_us, t.real_time_factor].map(number)),
  );
  const names = ["Observer", "tick p50 [\u00B5s]", "p99", "max", "QP p50 [\u00B5s]", "p99", "max", "speed [\u00D7 real time]"];
  const head = h("tr", {}, ...names.map((name, i) => h("th", { scope: "col", class: i > 0 ? "number" : null }, name)));
  return h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Times of tick and QP" }, h("table", { "data-test": "timing-table" }, h("thead", {}, head), h("tbody", {}, ...rows)));
}
