// The ground from above at the cursor's time: support polygon, feet, ZMP reference and centre of pressure.
import type { PlotTrace } from "./plotly";
import type { Robot } from "../data";
import { convexHull, type Point } from "../hull";
import { footPositions, kNoRobot, robotOf } from "../kinematics";
import { type Theme, time } from "../state";
import { type Context, fileName, focused, loadShown, noTrace, type Shown } from "./context";
import { type Drawing, Figure, type Missing } from "./figure";
import { axis, baseLayout, palette } from "./layout";

const kTrail_s = 0.6; // of ZMP and centre of pressure before the cursor
const kHalf_m = 0.4; // of the window

export function groundFigure(context: Context): Figure {
  const figure = new Figure({
    id: "support",
    title: "Support polygon at the cursor",
    note: `from above, with the last ${kTrail_s} s of ZMP and centre of pressure, of the observer in detail`,
    fileName: () => fileName(context, "support"),
    draw: async (theme, width) => draw(context, focused(await loadShown(context, theme), context.selection), theme, width),
  });
  let asked = 0; // at most so often, that a replay beside it stays fluent
  time.subscribe(() => {
    asked ||= window.setTimeout(() => {
      asked = 0;
      figure.invalidate();
    }, 80);
  });
  return figure;
}

function draw(context: Context, s: Shown | undefined, theme: Theme, width: number): Drawing | Missing {
  if (!s) return noTrace(context);
  const robot = robotOf(context.report, s.trace.info.scenario_id);
  if (!robot) return { missing: `${kNoRobot} Without it nothing says where the feet are.` };
  const { rate_Hz, frames } = s.trace.info.replay;
  const k = Math.min(frames - 1, Math.max(0, Math.round(time.get() * rate_Hz)));
  const c = palette(theme);
  const cop = trail(s, "zmp/cop", k);
  const reference = trail(s, "zmp/reference", k);
  const feet = feetAt(robot, s, k);
  const standing = feet.filter((foot) => foot.stands);
  const polygon = convexHull(standing.map((foot) => foot.at));
  const data: PlotTrace[] = [
    { ...xy([...polygon, ...polygon.slice(0, 1)]), mode: "lines", fill: "toself", fillcolor: c.shade, line: { color: c.muted, width: 1.2 }, name: "support polygon", hoverinfo: "skip" },
    { ...xy(feet.map((foot) => foot.at)), mode: "markers+text", text: feet.map((f) => f.leg), textposition: "top center", textfont: { size: 11, color: c.muted }, marker: { size: 11, symbol: feet.map((f) => (f.stands ? "circle" : "circle-open")), color: c.muted, line: { width: 1.5, color: c.muted } }, name: "feet (open: swing)", hovertemplate: "%{text} %{x:.3f}, %{y:.3f} m<extra></extra>" },
    { ...xy(reference), mode: "lines+markers", line: { color: c.truth, width: 1.2, dash: "dot" }, marker: lastOnly(reference, "cross", c.truth), name: "ZMP reference", hovertemplate: "%{x:.3f}, %{y:.3f} m<extra>ZMP reference</extra>" },
    { ...xy(cop), mode: "lines+markers", line: { color: s.style.color, width: 1.4 }, marker: lastOnly(cop, s.style.symbol, s.style.color), name: `centre of pressure, ${s.short}`, hovertemplate: "%{x:.3f}, %{y:.3f} m<extra>centre of pressure</extra>" },
  ];
  const com = { x: replayed(s, "com/x_m", k), y: replayed(s, "com/y_m", k) };
  const height = Math.min(460, width);
  const layout = baseLayout(theme, {
    hovermode: "closest",
    xaxis: axis(theme, "x [m]", { range: windowAt(com.x, (width - 70) / (height - 90)), constrain: "domain" }),
    yaxis: axis(theme, "y [m]", { range: windowAt(com.y, 1), scaleanchor: "x" }),
  });
  const names = standing.map((foot) => foot.leg).join(", ");
  return { data, layout, height, summary: `${s.short} at ${(k / rate_Hz).toFixed(2)} s: ${names ? `${names} on the ground` : "no foot is known to stand"}.` };
}

function replayed(s: Shown, name: string, k: number): number {
  return s.trace.replay(name)?.[k] ?? NaN;
}

function windowAt(centre: number, aspect: number): [number, number] {
  const middle = Number.isFinite(centre) ? centre : 0;
  return [middle - kHalf_m * aspect, middle + kHalf_m * aspect];
}

function xy(points: readonly Point[]): PlotTrace {
  return { type: "scatter", x: points.map((p) => p.x), y: points.map((p) => p.y) };
}

function trail(s: Shown, name: string, k: number): Point[] {
  const [x, y] = [s.trace.replay(`${name}/x_m`), s.trace.replay(`${name}/y_m`)];
  if (!x || !y) return [];
  const points: Point[] = [];
  for (let i = Math.max(0, k - Math.round(kTrail_s * s.trace.info.replay.rate_Hz)); i <= k; ++i) {
    if (Number.isFinite(x[i]) && Number.isFinite(y[i])) points.push({ x: x[i]!, y: y[i]! });
  }
  return points;
}

function lastOnly(points: readonly Point[], symbol: string, color: string): object {
  return { symbol, color, size: points.map((_, i) => (i === points.length - 1 ? 10 : 0)) };
}

function feetAt(robot: Robot, s: Shown, k: number): { leg: string; at: Point; stands: boolean }[] {
  const positions = footPositions(robot, s.trace, k);
  if (!positions) return [];
  return robot.feet.map((foot, i) => {
    const stance = s.trace.replay(`${foot.leg}/stance`)?.[k] ?? NaN;
    return { leg: foot.leg, at: { x: positions[i]![0], y: positions[i]![1] }, stands: stance > 0.5 };
  });
}
