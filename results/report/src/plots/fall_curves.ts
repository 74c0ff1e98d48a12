// Falls and errors over the level of an axis: a curve per observer, and beneath it where 50 % and 5 % fall.
import type { PlotLayout, PlotTrace } from "./plotly";
import { ascends, axisTitle, type Block, campaignStyles, comText, fallsText, levelText, observerOf, openInterval, thresholdText, withUnit } from "../campaign/blocks";
import type { ObserverStyle } from "../colors";
import type { Campaign, CampaignAxis, CampaignCurve, FallThreshold, Interval, LevelResult, Report } from "../data";
import { shortName } from "../format";
import type { Theme } from "../state";
import type { Drawing, Missing } from "./figure";
import { axis, baseLayout, palette } from "./layout";

export interface CurvesScope {
  report: Report;
  campaign: Campaign;
  block: Block;
}

interface Lane {
  curve: CampaignCurve;
  name: string;
  style: ObserverStyle;
  place: number; // -0.5 ... 0.5: among the observers, side by side within a level
  y: number;
}

const kNarrow = 520; // px: names on two lines
const kLane_px = 26;
const kSpread = 0.26; // of the smallest step between levels, for all observers together
const kMargin = 0.04; // of the axis, on either side

function lanesOf({ report, campaign, block }: CurvesScope, theme: Theme, width: number): Lane[] {
  const styles = campaignStyles(report, campaign, theme);
  const n = block.curves.length;
  return block.curves.map((curve, i) => {
    const { id } = observerOf(campaign, curve);
    const name = width < kNarrow ? shortName(id, 24).replace("@", "<br>@") : shortName(id, 28);
    return { curve, name, style: styles.get(id)!, place: (i + 0.5) / n - 0.5, y: n - 1 - i };
  });
}

// Places along the axis: its numbers, or their logarithms to the base of ten as plotly has them.
class Scale {
  private readonly at: number[];
  private readonly step: number;

  constructor(readonly axis: CampaignAxis) {
    this.at = axis.levels.map((level) => this.of(level));
    const steps = this.at.slice(1).map((x, i) => Math.abs(x - this.at[i]!));
    this.step = (ascends(axis) ? 1 : -1) * Math.min(...steps);
  }

  of(level: number): number {
    return this.axis.logarithmic ? Math.log10(level) : level;
  }

  value(place: number): number {
    return this.axis.logarithmic ? 10 ** place : place;
  }

  beside(lane: Lane, level: number): number {
    return this.value(this.at[level]! + kSpread * this.step * lane.place);
  }

  // From the mildest level, on the left, to the hardest.
  range(part = kMargin): Interval {
    const [first, last] = [this.at[0]!, this.at[this.at.length - 1]!];
    const margin = part * (last - first);
    return [first - margin, last + margin];
  }

  // Just within the range, so that what is there is drawn.
  rims(): { low: number; high: number } {
    const [a, b] = this.range(0.95 * kMargin);
    return { low: this.value(Math.min(a, b)), high: this.value(Math.max(a, b)) };
  }

  layout(theme: Theme, width: number, more: PlotLayout = {}): PlotLayout {
    const every = Math.ceil(this.at.length / Math.max(2, Math.floor(width / 60)));
    const ticks = this.axis.levels.filter((_, i) => i % every === 0);
    return axis(theme, axisTitle(this.axis), {
      type: this.axis.logarithmic ? "log" : "linear",
      range: this.range(),
      tickmode: "array",
      tickvals: ticks,
      ticktext: ticks.map(levelText),
      tickangle: 0,
      zeroline: false,
      ...more,
    });
  }
}

interface Point {
  level: LevelResult;
  y: number;
  ci: Interval | null;
}

function curveTrace(lane: Lane, scale: Scale, points: readonly Point[]): PlotTrace {
  const { color, dash, symbol } = lane.style;
  const texts = points.map(({ level }) => [`${scale.axis.name} ${withUnit(scale.axis.levels[level.level[0]]!, scale.axis)}`, fallsText(level), comText(level)].filter(Boolean).join("<br>"));
  return {
    type: "scatter",
    mode: "lines+markers",
    x: points.map(({ level }) => scale.beside(lane, level.level[0])),
    y: points.map(({ y }) => y),
    error_y: {
      type: "data",
      symmetric: false,
      array: points.map(({ y, ci }) => ci && ci[1] - y),
      arrayminus: points.map(({ y, ci }) => ci && y - ci[0]),
      color,
      thickness: 1,
      width: 2.5,
    },
    text: texts,
    name: shortName(lane.curve.observer_id),
    legendgroup: lane.curve.observer_id,
    line: { color, dash, width: 1.6 },
    marker: { symbol, size: 7, color },
    hovertemplate: `%{text}<extra>${shortName(lane.curve.observer_id)}</extra>`,
  };
}

function pointsOf(curve: CampaignCurve, value: (level: LevelResult) => { y: number; ci: Interval | null } | null): Point[] {
  return curve.levels.flatMap((level) => {
    const point = value(level);
    return point ? [{ level, ...point }] : [];
  });
}

const scaledBy = (ci: Interval | null, factor: number): Interval | null => ci && [factor * ci[0], factor * ci[1]];

// A bar over the interval and a mark at the estimate; a triangle at the rim where it says no more than "beyond".
function thresholdTraces(lane: Lane, scale: Scale, threshold: FallThreshold | null, share: string, y: number): PlotTrace[] {
  if (!threshold) return [];
  const broad = share === "50 %";
  const { color, symbol } = lane.style;
  const { low: rimLow, high: rimHigh } = scale.rims();
  const within = (x: number): number => Math.min(Math.max(x, rimLow), rimHigh);
  const { low, high, openLow, openHigh } = openInterval(threshold, scale.axis);
  const [from, to] = [openLow ? rimLow : within(low), openHigh ? rimHigh : within(high)];
  const text = `${share} fall at ${thresholdText(threshold, scale.axis).filter(Boolean).join("<br>")}`;
  const common = { type: "scatter", yaxis: "y2", legendgroup: lane.curve.observer_id, showlegend: false, hovertemplate: `${text}<extra>${shortName(lane.curve.observer_id)}</extra>` };
  const ends = [...(openLow ? [rimLow] : []), ...(openHigh ? [rimHigh] : [])];
  const toTheLeft = ascends(scale.axis) ? rimLow : rimHigh;
  return [
    { ...common, mode: "lines", x: [from, to], y: [y, y], line: { color, width: broad ? 5 : 1.5 }, opacity: broad ? 0.45 : 1 },
    ...(within(threshold.estimate) === threshold.estimate ? [{ ...common, mode: "markers", x: [threshold.estimate], y: [y], marker: { symbol: broad ? symbol : `${symbol}-open`, size: 8, color } }] : []),
    ...(ends.length > 0 ? [{ ...common, mode: "markers", x: ends, y: ends.map(() => y), cliponaxis: false, marker: { symbol: ends.map((x) => (x === toTheLeft ? "triangle-left" : "triangle-right")), size: 8, color } }] : []),
  ];
}

export function drawFallShares(scope: CurvesScope, theme: Theme, width: number): Drawing | Missing {
  const scale = new Scale(scope.block.axes[0]!);
  const lanes = lanesOf(scope, theme, width);
  const share = (level: LevelResult) => (level.trials > 0 ? { y: (100 * level.falls) / level.trials, ci: scaledBy(level.falls_ci95, 100) } : null);
  const drawn = lanes.map((lane) => ({ lane, points: pointsOf(lane.curve, share) }));
  if (drawn.every(({ points }) => points.length === 0)) return { missing: "No trial of these has been run yet." };
  const data = drawn.map(({ lane, points }) => curveTrace(lane, scale, points));
  for (const lane of lanes) data.push(...thresholdTraces(lane, scale, lane.curve.fall_50, "50 %", lane.y + 0.18), ...thresholdTraces(lane, scale, lane.curve.fall_5, "5 %", lane.y - 0.22));
  const [above, below] = [270, kLane_px * lanes.length + 12];
  const domain = below / (above + below);
  const layout = baseLayout(theme, {
    hovermode: "closest",
    xaxis: scale.layout(theme, width, { anchor: "y2" }),
    yaxis: axis(theme, "fell [%]", { range: [-4, 104], domain: [domain + 0.02, 1], zeroline: false }),
    yaxis2: laneAxis(theme, lanes, domain - 0.02),
    shapes: [50, 5].map((y) => ({ type: "line", xref: "paper", x0: 0, x1: 1, yref: "y", y0: y, y1: y, line: { color: palette(theme).muted, width: 1, dash: "dot" } })),
  });
  return { data, layout, height: above + below + 80, summary: summaryOf(scope, lanes) };
}

function laneAxis(theme: Theme, lanes: readonly Lane[], top: number): PlotLayout {
  return axis(theme, "", {
    domain: [0, top],
    tickmode: "array",
    tickvals: lanes.map((lane) => lane.y),
    ticktext: lanes.map((lane) => lane.name),
    range: [-0.6, lanes.length - 0.4],
    fixedrange: true,
    zeroline: false,
  });
}

function summaryOf({ block }: CurvesScope, lanes: readonly Lane[]): string {
  const own = block.axes[0]!;
  const texts = lanes.map(({ curve }) => {
    const [half, interval] = thresholdText(curve.fall_50, own);
    return `${curve.observer_id}: ${fallsText(curve)}, half of the trials at ${withUnit(half, own)}${interval ? ` (${interval})` : ""}`;
  });
  return `${block.whole}. ${texts.join("; ")}.`;
}

export function drawComErrors(scope: CurvesScope, theme: Theme, width: number): Drawing | Missing {
  const scale = new Scale(scope.block.axes[0]!);
  const lanes = lanesOf(scope, theme, width);
  const error = (level: LevelResult) => (level.com_error_m === null ? null : { y: 1e3 * level.com_error_m, ci: scaledBy(level.com_error_ci95, 1e3) });
  const drawn = lanes.map((lane) => ({ lane, points: pointsOf(lane.curve, error) })).filter(({ points }) => points.length > 0);
  if (drawn.length === 0) return { missing: "No trial of these survived." };
  const data = drawn.map(({ lane, points }) => curveTrace(lane, scale, points));
  const layout = baseLayout(theme, {
    hovermode: "closest",
    xaxis: scale.layout(theme, width),
    yaxis: axis(theme, "CoM error [mm]", { rangemode: "tozero" }),
  });
  const hardest = drawn.map(({ lane, points }) => `${lane.curve.observer_id}: ${comText(points[points.length - 1]!.level)} at ${withUnit(scale.axis.levels[points[points.length - 1]!.level.level[0]]!, scale.axis)}`);
  return { data, layout, height: 300, summary: `${scope.block.whole}. At the hardest level that any trial survived: ${hardest.join("; ")}.` };
}
