// Errors over time, all observers overlaid, falls marked.
import type { PlotLayout, PlotTrace } from "./plotly";
import { seconds, significant } from "../format";
import type { Theme } from "../state";
import { type Context, endOf, fileName, loadShown, noTrace, pointsBefore, type Shown } from "./context";
import { Figure } from "./figure";
import { axis, bands, baseLayout, largest, palette, scaled, timeAxis } from "./layout";

interface Error {
  id: string;
  title: string;
  note: string;
  signal: string;
  unit: string;
  factor: number;
}

const kErrors: readonly Error[] = [
  { id: "com_error", title: "CoM error", note: "norm of CoM minus the planner\u2019s reference", signal: "com_error_m", unit: "mm", factor: 1e3 },
  { id: "path_error", title: "Path error", note: "horizontal distance from where the command wants the CoM, never re-planned", signal: "path_error_m", unit: "mm", factor: 1e3 },
  { id: "orientation", title: "Orientation error", note: "norm of the rotation vector between reference and trunk", signal: "orientation_error_rad", unit: "rad", factor: 1 },
];

export function trackingFigures(context: Context): Figure[] {
  return kErrors.map(
    (error) =>
      new Figure({
        id: error.id,
        title: error.title,
        note: error.note,
        timeAxes: ["xaxis"],
        fileName: () => fileName(context, error.id),
        draw: async (theme) => drawError(context, error, await loadShown(context, theme), theme),
      }),
  );
}

function drawError(context: Context, error: Error, shown: Shown[], theme: Theme) {
  const drawn = shown.flatMap((s) => {
    const values = s.trace.plot(error.signal);
    return values ? [{ s, values: scaled(values, error.factor) }] : [];
  });
  if (shown.length === 0) return noTrace(context);
  if (drawn.length === 0) return { missing: `These time series have no signal ${error.signal}: the run was made by an older dobbench.` };
  const top = topOf(drawn);
  const hover = `%{y:.3~g} ${error.unit}`;
  const data: PlotTrace[] = drawn.map(({ s, values }) => ({
    type: "scatter",
    mode: "lines",
    x: s.trace.plotTimes,
    y: values,
    name: s.label,
    line: { color: s.style.color, dash: s.style.dash, width: 1.4 },
    hovertemplate: `${hover}<extra>${s.short}</extra>`,
    legendgroup: s.id,
    legendrank: s.rank,
  }));
  for (const { s, values } of drawn) if (s.fall !== null) data.push(fallMark(s, Math.min(peakBeforeFall(s, values), 0.97 * top)));
  const pushes = disturbed(drawn[0]!.s, top, theme);
  if (pushes) data.unshift(pushes);
  const layout = baseLayout(theme, {
    xaxis: timeAxis(theme),
    yaxis: axis(theme, `${error.title} [${error.unit}]`, { range: [0, top], rangemode: "tozero" }),
    shapes: drawn.flatMap(({ s }) => (s.fall === null ? [] : [fallLine(s)])),
  });
  const figures = drawn.map(({ s, values }) => `${s.short} ${significant(largest(values))} ${error.unit}${s.fall === null ? "" : `, fell at ${seconds(s.fall)}`}`);
  return { data, layout, height: 300, end: endOf(shown), summary: `Largest values: ${figures.join("; ")}.` };
}

// The last second before a fall would press all else flat; double-click or zoom shows it.
function topOf(drawn: { s: Shown; values: Float32Array }[]): number {
  const tops = drawn.map(({ s, values }) => largest(values, pointsBefore(s, values.length)));
  const top = Math.max(...tops.filter(Number.isFinite));
  return Number.isFinite(top) && top > 0 ? 1.12 * top : 1;
}

// In the last second; where the mark of the fall stands.
function peakBeforeFall(s: Shown, values: Float32Array): number {
  const peak = largest(values.slice(pointsBefore(s, values.length)));
  return Number.isFinite(peak) ? peak : 0;
}

function fallMark(s: Shown, y: number): PlotTrace {
  return {
    type: "scatter",
    mode: "markers",
    x: [s.fall],
    y: [y],
    marker: { symbol: "x", size: 10, color: s.style.color, line: { width: 1, color: s.style.color } },
    cliponaxis: false,
    name: `${s.short} fell`,
    hovertemplate: `fell: ${s.cell?.reason ?? ""}<extra>${s.short}</extra>`,
    legendgroup: s.id,
    showlegend: false,
  };
}

function fallLine(s: Shown): PlotLayout {
  return { type: "line", xref: "x", x0: s.fall, x1: s.fall, yref: "paper", y0: 0, y1: 1, line: { color: s.style.color, width: 1, dash: "dot" } };
}

// The stretches in which a disturbance acts, unless that is all the time.
function disturbed(s: Shown, top: number, theme: Theme): PlotTrace | null {
  const { disturbed, end_s } = s.trace.info;
  const total = disturbed.reduce((sum, [from, to]) => sum + to - from, 0);
  if (disturbed.length === 0 || total > 0.98 * end_s) return null;
  return bands(disturbed, 0, top * 4, { name: "disturbance acts", color: palette(theme).shade });
}
