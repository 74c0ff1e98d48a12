// Seeds, falls and pairs: how far single runs scatter, how sure a share of falls is, what an observer gains.
import type { PlotLayout, PlotTrace } from "./plotly";
import { observerStyles, type ObserverStyle } from "../colors";
import type { Cell, ObserverInfo, Report, Row } from "../data";
import { type Metric, plural, shortName, significant } from "../format";
import { type Interval, kLeastForInterval, median } from "../interval";
import { value } from "../summary";
import type { Theme } from "../state";
import type { Drawing, Missing } from "./figure";
import { axis, baseLayout, palette } from "./layout";

// What the statistics are over.
export interface Scope {
  report: Report;
  observers: ObserverInfo[];
  cells: Cell[];
  rows: Row[];
  metric: Metric;
  name: string;
}

const kRow_px = 34;
const kNarrow = 520; // px: names on two lines, fewer ticks

interface Lane {
  observer: ObserverInfo;
  name: string;
  y: number;
  style: ObserverStyle;
}

// Observers from top to bottom.
function lanes(scope: Scope, theme: Theme, width: number): Lane[] {
  const styles = observerStyles(scope.report.observers, theme);
  return scope.observers.map((observer, i) => ({
    observer,
    name: width < kNarrow ? shortName(observer.id, 24).replace("@", "<br>@") : shortName(observer.id, 28),
    y: scope.observers.length - 1 - i,
    style: styles.get(observer.id)!,
  }));
}

function laneAxis(theme: Theme, list: readonly Lane[], text: (lane: Lane) => string): PlotLayout {
  return axis(theme, "", {
    tickmode: "array",
    tickvals: list.map((lane) => lane.y),
    ticktext: list.map(text),
    range: [-0.6, list.length - 0.4],
    fixedrange: true,
    zeroline: false,
  });
}

function laneHeight(list: readonly Lane[]): number {
  return kRow_px * list.length + 90;
}

// Where points of one lane stand so that they do not hide each other: spread by their order, the same each time.
function spread(count: number, i: number): number {
  return count < 2 ? 0 : (((i * 7) % count) / (count - 1) - 0.5) * 0.42;
}

export function drawSeeds(scope: Scope, theme: Theme, width: number): Drawing | Missing {
  const { metric } = scope;
  const list = lanes(scope, theme, width);
  const data: PlotTrace[] = [];
  const summary: string[] = [];
  const counts = new Map<Lane, string>();
  for (const lane of list) {
    const own = scope.cells.filter((cell) => cell.observer_id === lane.observer.id);
    const stood = own.filter((cell) => cell.outcome === "survived" && cell[metric.field] !== null);
    const fell = own.filter((cell) => cell.outcome === "fell");
    const ran = own.filter((cell) => cell.outcome === "survived").length + fell.length;
    counts.set(lane, `${ran - fell.length}/${ran}`);
    const values = stood.map((cell) => metric.factor * cell[metric.field]!);
    if (values.length > 0) data.push(...distribution(lane, values, stood, metric));
    if (fell.length > 0) data.push(falls(lane, fell, theme));
    summary.push(`${lane.observer.id}: ${values.length > 0 ? `median ${significant(median(values))} ${metric.unit} of ${plural(values.length, "run")}` : "no run survived"}, ${fell.length} fell`);
  }
  if (data.length === 0) return { missing: `No finished run has this metric in ${scope.name}.` };
  const layout = baseLayout(theme, {
    showlegend: false,
    hovermode: "closest",
    yaxis: laneAxis(theme, list, (lane) => `${lane.name} <b>${counts.get(lane)}</b>`),
    xaxis: axis(theme, `${metric.label} [${metric.unit}]`, { domain: [0, 0.74], type: wide(data) ? "log" : "linear", rangemode: "tozero", zeroline: false, ...(wide(data) ? { dtick: width < kNarrow ? 1 : "D2" } : {}) }),
    xaxis2: axis(theme, width < kNarrow ? "fell [s]" : "fell at [s]", { domain: [0.8, 1], anchor: "y", rangemode: "tozero", zeroline: false, nticks: width < kNarrow ? 2 : 5, tickangle: 0 }),
  });
  return { data, layout, height: laneHeight(list), summary: `${scope.name}. ${summary.join("; ")}.` };
}

// Over scenarios as different as these a linear axis shows only the worst.
function wide(data: readonly PlotTrace[]): boolean {
  const values = data.filter((d) => d["xaxis"] !== "x2").flatMap((d) => d["x"] as number[]);
  const least = Math.min(...values);
  return least > 0 && Math.max(...values) > 30 * least;
}

function distribution(lane: Lane, values: number[], cells: Cell[], metric: Metric): PlotTrace[] {
  const text = cells.map((cell) => `${cell.scenario_id}, seed ${cell.seed}`);
  const points: PlotTrace = {
    type: "scatter",
    mode: "markers",
    x: values,
    y: values.map((_, i) => lane.y + spread(values.length, i)),
    text,
    marker: { symbol: lane.style.symbol, size: 7, color: lane.style.color, opacity: 0.75, line: { width: 0 } },
    name: lane.name,
    hovertemplate: `%{x:.3~g} ${metric.unit}<br>%{text}<extra>${shortName(lane.observer.id)}</extra>`,
  };
  const middle: PlotTrace = {
    type: "scatter",
    mode: "lines",
    x: [median(values), median(values)],
    y: [lane.y - 0.36, lane.y + 0.36],
    line: { color: lane.style.color, width: 2.5 },
    name: lane.name,
    hovertemplate: `median %{x:.3~g} ${metric.unit}<extra>${shortName(lane.observer.id)}</extra>`,
  };
  if (values.length < kLeastForInterval) return [points, middle];
  const box: PlotTrace = {
    type: "box",
    orientation: "h",
    x: values,
    y: values.map(() => lane.y),
    width: 0.62,
    boxpoints: false,
    line: { color: lane.style.color, width: 1.2 },
    fillcolor: "rgba(0,0,0,0)",
    name: lane.name,
    hoverinfo: "skip",
  };
  return [box, points];
}

function falls(lane: Lane, cells: Cell[], theme: Theme): PlotTrace {
  const color = lane.style.color;
  return {
    type: "scatter",
    mode: "markers",
    xaxis: "x2",
    x: cells.map((cell) => cell.fall_time_s),
    y: cells.map((_, i) => lane.y + spread(cells.length, i)),
    text: cells.map((cell) => `${cell.scenario_id}, seed ${cell.seed}: ${cell.reason ?? ""}`),
    marker: { symbol: "x-thin", size: 7, color, line: { width: 1.8, color: color || palette(theme).ink } },
    name: lane.name,
    hovertemplate: `fell at %{x:.2f} s<br>%{text}<extra>${shortName(lane.observer.id)}</extra>`,
  };
}

export function drawFalls(scope: Scope, theme: Theme, width: number): Drawing | Missing {
  const list = lanes(scope, theme, width);
  const drawn = list.flatMap((lane) => {
    const own = scope.rows.filter((row) => row.observer_id === lane.observer.id);
    const runs = own.reduce((sum, row) => sum + row.runs, 0);
    const fell = own.reduce((sum, row) => sum + row.falls, 0);
    const interval = own.length === 1 ? own[0]!.falls_ci95 : null; // falls of several variants are no independent draws
    return runs > 0 ? [{ lane, runs, fell, interval, pooled: own.length > 1 }] : [];
  });
  if (drawn.length === 0) return { missing: `No finished run in ${scope.name}.` };
  const text = (d: (typeof drawn)[number]): string =>
    `${d.lane.observer.id}: ${d.fell} of ${d.runs} fell${d.interval ? ` (${percent(d.interval[0])} to ${percent(d.interval[1])})` : ""}`;
  const data = drawn.map((d) => withInterval(d.lane, (100 * d.fell) / d.runs, d.interval?.map((x) => 100 * x) as Interval | undefined, `${text(d)}<extra></extra>`));
  const counted = new Map(drawn.map((d) => [d.lane, `${d.fell}/${d.runs}`]));
  const layout = baseLayout(theme, {
    showlegend: false,
    hovermode: "closest",
    yaxis: laneAxis(theme, list, (lane) => `${lane.name} <b>${counted.get(lane) ?? ""}</b>`),
    xaxis: axis(theme, "share of runs that fell [%]", { range: [-3, 103], zeroline: false }),
  });
  const none = drawn.some((d) => d.pooled) ? ` ${kNoInterval}` : "";
  return { data, layout, height: laneHeight(list), summary: `${scope.name}. ${drawn.map(text).join("; ")}.${none}`, note: `share of runs that fell.${none || kInterval}` };
}

const kInterval = " Wilson interval, 95 %; none below 8 runs";
const kNoInterval = "No interval where runs are of several variants: their falls are no independent draws.";

function percent(share: number): string {
  return `${(100 * share).toFixed(0)} %`;
}

function withInterval(lane: Lane, x: number, interval: Interval | undefined, hover: string, y = lane.y, size = 9): PlotTrace {
  return {
    type: "scatter",
    mode: "markers",
    x: [x],
    y: [y],
    marker: { symbol: lane.style.symbol, size, color: lane.style.color },
    error_x: interval
      ? { type: "data", symmetric: false, array: [interval[1] - x], arrayminus: [x - interval[0]], color: lane.style.color, thickness: 1.6, width: 5 }
      : { visible: false },
    hovertemplate: hover,
  };
}

export function drawPairs(scope: Scope, theme: Theme, width: number): Drawing | Missing {
  const { metric } = scope;
  if (!metric.paired) return { missing: `${metric.label} is not compared run by run: it has no checkpoints at which both stood.` };
  const field = `paired_${metric.field}`;
  const all = lanes(scope, theme, width);
  const references = [...new Set(scope.rows.flatMap((row) => (row.reference ? [row.reference.replace(/@-$/, "")] : [])))];
  const list = all.filter((lane) => scope.rows.some((row) => row.observer_id === lane.observer.id && value(row, field) !== null));
  list.forEach((lane, i) => (lane.y = list.length - 1 - i));
  if (list.length === 0) return { missing: `No pairs of runs in ${scope.name}: the table's reference did not run there.` };
  const data: PlotTrace[] = [];
  const summary: string[] = [];
  for (const lane of list) {
    const own = scope.rows.filter((row) => row.observer_id === lane.observer.id && value(row, field) !== null);
    const medians = own.map((row) => metric.factor * value(row, field)!);
    own.forEach((row, i) => {
      const ci = row[`${field}_ci95`] as Interval | null;
      const hover = `%{x:.3~g} ${metric.unit} against ${references.join(", ")}<br>${row.scenario_id}, ${plural(row.paired_runs ?? 0, "pair")}<extra>${shortName(lane.observer.id)}</extra>`;
      data.push(withInterval(lane, medians[i]!, ci?.map((x) => metric.factor * x) as Interval | undefined, hover, lane.y + spread(own.length, i), 8));
    });
    summary.push(`${lane.observer.id} ${significant(median(medians))} ${metric.unit}`);
  }
  const layout = baseLayout(theme, {
    showlegend: false,
    hovermode: "closest",
    yaxis: laneAxis(theme, list, (lane) => lane.name),
    xaxis: axis(theme, `difference to ${references.join(", ")} [${metric.unit}]`, { zeroline: true, zerolinewidth: 2 }),
  });
  return { data, layout, height: laneHeight(list), summary: `${scope.name}. Median differences to ${references.join(", ")}: ${summary.join("; ")}. Negative is better.` };
}

