// Estimate against truth: the force where it acts, the torques at a leg's joints, the wrench about the CoM.
import type { PlotLayout, PlotTrace } from "./plotly";
import { significant } from "../format";
import type { Theme } from "../state";
import { type Context, endOf, fileName, loadShown, noTrace, pointsBefore, type Shown } from "./context";
import { type Drawing, Figure, type Missing } from "./figure";
import { axis, baseLayout, palette, stacked, timeAxis } from "./layout";

interface Component {
  title: string; // of the axis
  estimate: string;
  truth: string;
  unit: string;
  scale?: string; // components of one name share the range of their axes
}

const kAxes = ["x", "y", "z"] as const;

export function estimateFigures(context: Context): Figure[] {
  const figure = (id: string, title: string, note: string, components: () => Component[], columns = 1): Figure =>
    new Figure({
      id,
      title,
      note,
      timeAxes: columns === 1 ? ["xaxis"] : ["xaxis", "xaxis2"],
      fileName: () => fileName(context, id),
      draw: async (theme, width) => draw(context, components(), await loadShown(context, theme), theme, columns === 2 && width >= 640),
    });
  return [
    figure("force", "Force where it acts", "estimate mapped back to the point of application; world axes", forceComponents),
    figure("joint_torque", "Disturbance at the joints of the leg", "what the observer estimates, and the true forces mapped to the joints", () => jointComponents(context.selection.leg.get())),
    figure("com_wrench", "Wrench about the CoM", "sum of all acting forces; world axes", wrenchComponents, 2),
  ];
}

function forceComponents(): Component[] {
  return kAxes.map((a) => ({ title: `F${a} [N]`, estimate: `force_estimate/${a}_N`, truth: `force_true/${a}_N`, unit: "N", scale: "force" }));
}

function jointComponents(leg: string): Component[] {
  return ["hip", "upper", "lower"].map((joint) => ({
    title: `${leg} ${joint} [Nm]`,
    estimate: `${leg}/${joint}/estimate_Nm`,
    truth: `${leg}/${joint}/true_disturbance_Nm`,
    unit: "Nm",
  }));
}

// Column by column: forces, then moments.
function wrenchComponents(): Component[] {
  const of = (kind: string, letter: string, unit: string): Component[] =>
    kAxes.map((a) => ({ title: `${letter}${a} [${unit}]`, estimate: `com_${kind}_estimate/${a}_${unit}`, truth: `com_${kind}_true/${a}_${unit}`, unit, scale: kind }));
  return [...of("force", "F", "N"), ...of("moment", "M", "Nm")];
}

function draw(context: Context, components: Component[], shown: Shown[], theme: Theme, twoColumns: boolean): Drawing | Missing {
  if (shown.length === 0) return noTrace(context);
  const { layout, axes } = twoColumns ? grid(theme, components) : single(theme, components);
  const data: PlotTrace[] = [];
  const estimating = shown.filter((s) => components.some((c) => hasValues(s.trace.plot(c.estimate))));
  const truth = shown.find((s) => components.some((c) => hasValues(s.trace.plot(c.truth))));
  if (estimating.length === 0 && !truth) return { missing: "Neither a true value nor an estimate of this kind in these runs." };
  components.forEach((c, i) => {
    for (const s of estimating) data.push(line(s, s.trace.plot(c.estimate), axes[i]!, c, i === 0));
    if (truth) data.push(truthLine(shown, c, axes[i]!, theme, i === 0));
  });
  setRanges(layout, components, shown);
  const height = twoColumns ? 460 : 130 * components.length + 70;
  return { data, layout: baseLayout(theme, layout), height, end: endOf(shown), summary: summary(components, estimating) };
}

// Axes that hold estimates and truth up to one second before a fall: what an estimate does in a fall would press all else
// flat. Forces share one range, moments too, so that what is large looks large.
function setRanges(layout: PlotLayout, components: Component[], shown: Shown[]): void {
  const ranges = components.map((c) => rangeOf(c, shown));
  components.forEach((c, i) => {
    const own = ranges.filter((_, j) => j === i || (c.scale !== undefined && components[j]!.scale === c.scale));
    const [low, high] = [Math.min(...own.map((r) => r[0])), Math.max(...own.map((r) => r[1]))];
    if (!(high > low)) return;
    const pad = 0.06 * (high - low);
    Object.assign(layout[i === 0 ? "yaxis" : `yaxis${i + 1}`] as object, { range: [low - pad, high + pad] });
  });
}

function rangeOf(c: Component, shown: Shown[]): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const s of shown) {
    for (const name of [c.estimate, c.truth]) {
      const values = s.trace.plot(name);
      const end = pointsBefore(s, values?.length ?? 0);
      for (let i = 0; i < end; ++i) {
        if (values![i]! < low) low = values![i]!;
        if (values![i]! > high) high = values![i]!;
      }
    }
  }
  return [low, high];
}

function hasValues(values: Float32Array | null): values is Float32Array {
  return values !== null && values.some(Number.isFinite);
}

function single(theme: Theme, components: Component[]) {
  const { layout, names } = stacked(theme, components.map((c) => c.title), 0.04);
  return { layout, axes: names.map((y) => ({ x: "x", y })) };
}

function grid(theme: Theme, components: Component[]) {
  const layout: PlotLayout = {};
  const axes: { x: string; y: string }[] = [];
  components.forEach((c, i) => {
    const row = i % 3;
    const right = i >= 3;
    const suffix = i === 0 ? "" : String(i + 1);
    const top = 1 - row * 0.35;
    layout[`yaxis${suffix}`] = axis(theme, c.title, { domain: [Math.max(0, top - 0.3), top], anchor: right ? "x2" : "x" });
    axes.push({ x: right ? "x2" : "x", y: `y${suffix}` });
  });
  layout["xaxis"] = timeAxis(theme, { domain: [0, 0.46], anchor: "y3" });
  layout["xaxis2"] = timeAxis(theme, { domain: [0.54, 1], anchor: "y6", matches: "x" });
  return { layout, axes };
}

function line(s: Shown, values: Float32Array | null, at: { x: string; y: string }, c: Component, first: boolean): PlotTrace {
  return {
    type: "scatter",
    mode: "lines",
    x: s.trace.plotTimes,
    y: values ?? [],
    xaxis: at.x,
    yaxis: at.y,
    name: s.label,
    legendgroup: s.id,
    legendrank: s.rank,
    showlegend: first,
    line: { color: s.style.color, dash: s.style.dash, width: 1.3 },
    hovertemplate: `%{y:.3~g} ${c.unit}<extra>${s.short}</extra>`,
  };
}

// The truth of the longest run; forces of one seed are the same for all, mapped to joints they depend a little on the
// motion.
function truthLine(shown: readonly Shown[], c: Component, at: { x: string; y: string }, theme: Theme, first: boolean): PlotTrace {
  const longest = shown.reduce((a, b) => (b.trace.info.end_s > a.trace.info.end_s ? b : a));
  return {
    type: "scatter",
    mode: "lines",
    x: longest.trace.plotTimes,
    y: longest.trace.plot(c.truth) ?? [],
    xaxis: at.x,
    yaxis: at.y,
    name: "true",
    legendgroup: "true",
    showlegend: first,
    legendrank: 1,
    line: { color: palette(theme).truth, dash: "dot", width: 2 },
    hovertemplate: `%{y:.3~g} ${c.unit}<extra>true</extra>`,
  };
}

// With the cell's figure where the run has one: lines that are decimated to extremes have no mean.
function summary(components: Component[], estimating: Shown[]): string {
  if (estimating.length === 0) return "True values only: none of the observers shown estimates this.";
  const names = `Estimates of ${estimating.map((s) => s.short).join(", ")} against the true values.`;
  const atPoint = components.some((c) => c.estimate.startsWith("force_estimate/"));
  const measured = estimating.filter((s) => typeof s.cell?.estimate_rmse_N === "number");
  if (!atPoint || measured.length === 0) return names;
  return `${names} RMSE: ${measured.map((s) => `${s.short} ${significant(s.cell!.estimate_rmse_N!)} N`).join("; ")}.`;
}
