// Balance: margin of the ZMP reference, ZMP and centre of pressure over time, and both on the ground at the cursor.
import type { PlotTrace } from "./plotly";
import { significant } from "../format";
import type { Theme } from "../state";
import { type Context, endOf, fileName, focused, loadShown, noTrace, type Shown } from "./context";
import { type Drawing, Figure, type Missing } from "./figure";
import { axis, baseLayout, palette, scaled, stacked, timeAxis } from "./layout";

export function balanceFigures(context: Context): Figure[] {
  const figure = (id: string, title: string, note: string, draw: typeof drawMargin): Figure =>
    new Figure({ id, title, note, timeAxes: ["xaxis"], fileName: () => fileName(context, id), draw: async (theme) => draw(context, await loadShown(context, theme), theme) });
  return [
    figure("zmp_margin", "ZMP margin", "distance of the ZMP reference to the edge of the support polygon; below zero it is outside", drawMargin),
    figure("zmp_time", "ZMP reference and centre of pressure", "of the observer in detail", drawZmp),
    figure("saturation", "Joints at their torque limit", "", drawSaturation),
  ];
}

function overlaid(shown: Shown[], signal: string, factor: number, unit: string): PlotTrace[] {
  return shown.flatMap((s) => {
    const values = s.trace.plot(signal);
    if (!values) return [];
    return [
      {
        type: "scatter",
        mode: "lines",
        x: s.trace.plotTimes,
        y: scaled(values, factor),
        name: s.label,
        legendgroup: s.id,
        legendrank: s.rank,
        line: { color: s.style.color, dash: s.style.dash, width: 1.2 },
        hovertemplate: `%{y:.3~g}${unit}<extra>${s.short}</extra>`,
      },
    ];
  });
}

function drawMargin(context: Context, shown: Shown[], theme: Theme): Drawing | Missing {
  if (shown.length === 0) return noTrace(context);
  const data = overlaid(shown, "zmp/margin_m", 1e3, " mm");
  if (!data.some((d) => (d["y"] as Float32Array).some(Number.isFinite))) return { missing: "No ZMP margin in these runs." };
  const layout = baseLayout(theme, { xaxis: timeAxis(theme), yaxis: axis(theme, "margin [mm]") });
  const least = data.map((d) => `${d["name"]} ${significant(smallest(d["y"] as Float32Array))} mm`);
  return { data, layout, height: 260, end: endOf(shown), summary: `Smallest margin: ${least.join("; ")}.` };
}

function smallest(values: Float32Array): number {
  return values.reduce((least, v) => (v < least ? v : least), Infinity);
}

function drawZmp(context: Context, shown: Shown[], theme: Theme): Drawing | Missing {
  const s = focused(shown, context.selection);
  if (!s) return noTrace(context);
  const { layout, names } = stacked(theme, ["x [m]", "y [m]"], 0.06);
  const data: PlotTrace[] = [];
  (["x", "y"] as const).forEach((a, i) => {
    const common = { type: "scatter", mode: "lines", x: s.trace.plotTimes, yaxis: names[i], showlegend: i === 0 };
    data.push({ ...common, y: s.trace.plot(`zmp/cop/${a}_m`) ?? [], name: `centre of pressure, ${s.label}`, legendgroup: "cop", line: { color: s.style.color, width: 1.1 }, hovertemplate: "%{y:.3f} m<extra>centre of pressure</extra>" });
    data.push({ ...common, y: s.trace.plot(`zmp/reference/${a}_m`) ?? [], name: "ZMP reference", legendgroup: "reference", line: { color: palette(theme).truth, width: 1.4, dash: "dot" }, hovertemplate: "%{y:.3f} m<extra>ZMP reference</extra>" });
  });
  return { data, layout: baseLayout(theme, layout), height: 380, end: endOf(shown), summary: `World coordinates of the ZMP reference and the centre of pressure of ${s.label}.` };
}

function drawSaturation(context: Context, shown: Shown[], theme: Theme): Drawing | Missing {
  if (shown.length === 0) return noTrace(context);
  const data = overlaid(shown, "saturated_joints", 1, " joints").filter((d) => (d["y"] as Float32Array).some((v) => v > 0));
  if (data.length === 0) return { missing: "No joint reached its torque limit in the runs shown." };
  const layout = baseLayout(theme, { xaxis: timeAxis(theme), yaxis: axis(theme, "joints", { rangemode: "tozero", dtick: 2 }) });
  const most = data.map((d) => `${d["name"]} ${Math.max(...(d["y"] as Float32Array).filter(Number.isFinite))}`);
  return { data, layout, height: 220, end: endOf(shown), summary: `Most joints at once: ${most.join("; ")}.` };
}
