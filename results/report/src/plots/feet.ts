// Feet: their errors with the swing phases shaded, and the ground's force measured against commanded.
import type { PlotTrace } from "./plotly";
import { kLegs } from "../data";
import { significant } from "../format";
import type { Theme } from "../state";
import { type Context, endOf, fileName, focused, loadShown, noTrace, pointsBefore, type Shown } from "./context";
import { type Drawing, Figure, type Missing } from "./figure";
import { bands, baseLayout, largest, palette, scaled, stacked } from "./layout";

export function footFigures(context: Context): Figure[] {
  const figure = (id: string, title: string, note: string, draw: typeof drawErrors): Figure =>
    new Figure({ id, title, note, timeAxes: ["xaxis"], fileName: () => fileName(context, id), draw: async (theme) => draw(context, await loadShown(context, theme), theme) });
  return [
    figure("foot_error", "Foot error", "norm of the foot\u2019s distance: in swing from the spline, in stance from the planned foothold; swing phases shaded", drawErrors),
    figure("grf", "Ground reaction force, vertical", "measured (line) against commanded (dots), of the observer in detail", drawForces),
  ];
}

function drawErrors(context: Context, shown: Shown[], theme: Theme): Drawing | Missing {
  if (shown.length === 0) return noTrace(context);
  const { layout, names } = stacked(theme, kLegs.map((leg) => `${leg} [mm]`), 0.035);
  const data: PlotTrace[] = [];
  const peaks: string[] = [];
  const phases = focused(shown, context.selection)!.trace.info.swings;
  kLegs.forEach((leg, i) => {
    const lines = shown.flatMap((s) => errorLine(s, leg, names[i]!, i === 0));
    // As of the other errors: the last second before a fall would press all else flat.
    const standing = Math.max(...lines.map((l) => l.standing));
    const top = 1.08 * Math.max(1e-3, standing > 0.01 ? standing : Math.max(...lines.map((l) => l.largest))); // fell at once
    data.push(bands(phases[leg] ?? [], 0, top, { name: "swing", color: palette(theme).shade, yaxis: names[i]!, legend: i === 0 }));
    data.push(...lines.map((l) => l.line));
    Object.assign(layout[i === 0 ? "yaxis" : `yaxis${i + 1}`] as object, top > 0.01 ? { range: [0, top] } : {});
    peaks.push(`${leg}: ${lines.map((l) => `${l.name} ${significant(l.largest)}`).join(", ")}`);
  });
  return { data, layout: baseLayout(theme, layout), height: 560, end: endOf(shown), summary: `Largest values in mm. ${peaks.join("; ")}.` };
}

function errorLine(s: Shown, leg: string, yaxis: string, first: boolean) {
  const values = s.trace.plot(`${leg}/foot_error_m`);
  if (!values) return [];
  const y = scaled(values, 1e3);
  const line: PlotTrace = {
    type: "scatter",
    mode: "lines",
    x: s.trace.plotTimes,
    y,
    yaxis,
    name: s.label,
    legendgroup: s.id,
    legendrank: s.rank,
    showlegend: first,
    line: { color: s.style.color, dash: s.style.dash, width: 1.2 },
    hovertemplate: `%{y:.3~g} mm<extra>${s.short}</extra>`,
  };
  return [{ line, largest: largest(y), standing: largest(y, pointsBefore(s, y.length)), name: s.short }];
}

function drawForces(context: Context, shown: Shown[], theme: Theme): Drawing | Missing {
  const s = focused(shown, context.selection);
  if (!s) return noTrace(context);
  const { layout, names } = stacked(theme, kLegs.map((leg) => `${leg} [N]`), 0.035);
  const data: PlotTrace[] = [];
  const means: string[] = [];
  kLegs.forEach((leg, i) => {
    const [measured, commanded] = [s.trace.plot(`${leg}/force/z_N`), s.trace.plot(`${leg}/force_commanded/z_N`)];
    const common = { type: "scatter", mode: "lines", x: s.trace.plotTimes, yaxis: names[i], showlegend: i === 0 };
    const at = `<extra>${leg}, ${s.short}</extra>`;
    data.push({ ...common, y: measured ?? [], name: `measured, ${s.label}`, legendgroup: "measured", line: { color: s.style.color, width: 1.2 }, hovertemplate: `measured %{y:.3~g} N${at}` });
    data.push({ ...common, y: commanded ?? [], name: "commanded", legendgroup: "commanded", line: { color: palette(theme).truth, width: 1.2, dash: "dot" }, hovertemplate: `commanded %{y:.3~g} N${at}` });
    if (measured) means.push(`${leg} ${significant(largest(measured))} N`);
  });
  return { data, layout: baseLayout(theme, layout), height: 520, end: endOf(shown), summary: `${s.short}; largest measured: ${means.join(", ")}.` };
}
