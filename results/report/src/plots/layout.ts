// How plots look, for each theme: one font, quiet grids, units on the axes.
import type { PlotLayout, PlotTrace } from "./plotly";
import type { Theme } from "../state";

export const kFont = 'system-ui, -apple-system, "Segoe UI", Roboto, "Liberation Sans", "DejaVu Sans", sans-serif';

export interface Palette {
  ink: string;
  muted: string;
  grid: string;
  zero: string;
  paper: string;
  shade: string; // swing phases, stretches under disturbance
  truth: string;
}

export function palette(theme: Theme): Palette {
  return theme === "dark"
    ? { ink: "#e4e8ec", muted: "#9aa6b2", grid: "#2a3139", zero: "#46505b", paper: "#171b20", shade: "rgba(160,175,190,0.16)", truth: "#f2f2f2" }
    : { ink: "#1b1f24", muted: "#5b6670", grid: "#e6e9ed", zero: "#c3cad1", paper: "#ffffff", shade: "rgba(90,110,130,0.13)", truth: "#111111" };
}

export function axis(theme: Theme, title: string, more: PlotLayout = {}): PlotLayout {
  const c = palette(theme);
  return {
    title: { text: title, font: { size: 12, color: c.muted }, standoff: 6 },
    gridcolor: c.grid,
    zerolinecolor: c.zero,
    linecolor: c.zero,
    tickfont: { size: 11, color: c.muted },
    automargin: true,
    showspikes: false,
    ...more,
  };
}

export function timeAxis(theme: Theme, more: PlotLayout = {}): PlotLayout {
  return axis(theme, "time [s]", { hoverformat: ".2f", unifiedhovertitle: { text: "%{x:.2f} s" }, zeroline: false, ...more });
}

export function baseLayout(theme: Theme, more: PlotLayout = {}): PlotLayout {
  const c = palette(theme);
  return {
    font: { family: kFont, size: 12, color: c.ink },
    paper_bgcolor: c.paper,
    plot_bgcolor: c.paper,
    margin: { l: 56, r: 12, t: 8, b: 40 },
    showlegend: true,
    legend: { orientation: "h", x: 0, xanchor: "left", y: 1.01, yanchor: "bottom", font: { size: 11 }, itemwidth: 30, tracegroupgap: 0, bgcolor: "rgba(0,0,0,0)" },
    hovermode: "x unified",
    hoverlabel: { bgcolor: c.paper, bordercolor: c.zero, font: { family: kFont, size: 11, color: c.ink } },
    dragmode: "zoom",
    ...more,
  };
}

// y axes one above the other over one x axis; the first is at the top.
export function stacked(theme: Theme, titles: readonly string[], gap = 0.05): { layout: PlotLayout; names: string[] } {
  const layout: PlotLayout = {};
  const names: string[] = [];
  const height = (1 - gap * (titles.length - 1)) / titles.length;
  titles.forEach((title, i) => {
    const top = 1 - i * (height + gap);
    const suffix = i === 0 ? "" : String(i + 1);
    layout[`yaxis${suffix}`] = axis(theme, title, { domain: [Math.max(0, top - height), top] });
    names.push(`y${suffix}`);
  });
  layout["xaxis"] = timeAxis(theme, { anchor: names[names.length - 1] });
  return { layout, names };
}

// A swing, a push: grey bands behind everything, as one trace, so that hundreds of them stay cheap and the legend
// can switch them off. They fill the axes `yaxis`, whose range they need.
export function bands(intervals: readonly (readonly [number, number])[], low: number, high: number, style: { name: string; color: string; yaxis?: string; group?: string; legend?: boolean }): PlotTrace {
  const x: (number | null)[] = [];
  const y: (number | null)[] = [];
  for (const [from, to] of intervals) {
    x.push(from, from, to, to, from, null);
    y.push(low, high, high, low, low, null);
  }
  return {
    type: "scatter",
    mode: "lines",
    x,
    y,
    fill: "toself",
    fillcolor: style.color,
    line: { width: 0 },
    hoverinfo: "skip",
    name: style.name,
    yaxis: style.yaxis ?? "y",
    legendgroup: style.group ?? style.name,
    showlegend: style.legend ?? true,
    legendrank: 2000,
  };
}

export function scaled(values: Float32Array, factor: number): Float32Array {
  return factor === 1 ? values : values.map((v) => factor * v);
}

export function largest(values: Float32Array, until = values.length): number {
  let max = -Infinity;
  for (let i = 0; i < until; ++i) if (values[i]! > max) max = values[i]!;
  return max;
}
