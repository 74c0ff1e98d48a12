// Shares of the variance of a response, as bars with intervals.
import { percent } from "../campaign/blocks";
import type { Factorial, VarianceShare } from "../data";
import type { Theme } from "../state";
import type { Drawing, Missing } from "./figure";
import { axis, baseLayout, palette } from "./layout";

const kBar_px = 28;
const kNarrow = 520; // px: interactions on two lines

export function drawVariance(response: Factorial, theme: Theme, width: number): Drawing | Missing {
  const { shares } = response;
  if (shares.length === 0) return { missing: "Too few trials have been run to tell." };
  const color = palette(theme);
  const name = (share: VarianceShare): string => (width < kNarrow ? share.factor.replace(" x ", "<br>\u00D7 ") : share.factor.replace(" x ", " \u00D7 "));
  const values = shares.map((share) => 100 * share.share);
  const end = (share: VarianceShare, i: number): number => (share.ci95 ? 100 * share.ci95[1] : values[i]!);
  const bar = {
    type: "bar",
    orientation: "h",
    x: values,
    y: shares.map((_, i) => -i),
    width: 0.66,
    marker: { color: shares.map((share) => (share.factor === "residual" ? color.zero : "#56B4E9")) },
    error_x: {
      type: "data",
      symmetric: false,
      array: shares.map((share, i) => share.ci95 && 100 * share.ci95[1] - values[i]!),
      arrayminus: shares.map((share, i) => share.ci95 && values[i]! - 100 * share.ci95[0]),
      color: color.ink,
      thickness: 1.2,
      width: 4,
    },
    text: shares.map(text),
    textposition: "none",
    hovertemplate: "%{text}<extra></extra>",
  };
  const figures = {
    type: "scatter",
    mode: "text",
    x: shares.map(end),
    y: shares.map((_, i) => -i),
    text: shares.map((share) => `  ${percent(share.share)}`),
    textposition: "middle right",
    textfont: { size: 11, color: color.ink },
    cliponaxis: false,
    hoverinfo: "skip",
  };
  const layout = baseLayout(theme, {
    showlegend: false,
    hovermode: "closest",
    margin: { l: 56, r: 44, t: 8, b: 40 },
    xaxis: axis(theme, "share of the variance [%]", { range: [0, Math.max(1, 1.05 * Math.max(...shares.map(end)))], zeroline: true }),
    yaxis: axis(theme, "", { tickmode: "array", tickvals: shares.map((_, i) => -i), ticktext: shares.map(name), range: [0.4 - shares.length, 0.6], fixedrange: true, zeroline: false }),
  });
  return { data: [bar, figures], layout, height: kBar_px * shares.length + 70, summary: `${shares.map(text).join("; ")}.` };
}

// "leg estimator x gains 12 % (9 % to 16 %)"
function text(share: VarianceShare): string {
  return `${share.factor} ${percent(share.share)}${share.ci95 ? ` (${percent(share.ci95[0])} to ${percent(share.ci95[1])})` : ""}`;
}
