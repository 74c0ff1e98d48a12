// A plot as a file: SVG, or PNG at three times the size.
import { loadPlotly, type PlotElement, type PlotLayout, type PlotTrace } from "./plotly";

interface Picture {
  data: PlotTrace[];
  layout: PlotLayout;
  width: number;
  height: number;
  title: string;
}

export async function saveImage(shown: PlotElement | null, picture: Picture, format: "svg" | "png", name: string): Promise<void> {
  const { width, title } = picture;
  const height = picture.height + 40;
  const figure = { data: picture.data.map((trace, i) => ({ ...trace, visible: shown?.data?.[i]?.["visible"] ?? true })), layout: withTitle(withRanges(picture.layout, shown), title) };
  const plotly = await loadPlotly();
  const url = await plotly.toImage({ ...figure, layout: { ...figure.layout, width, height } }, { format, width, height, scale: format === "png" ? 3 : 1 });
  const link = document.createElement("a");
  link.href = url;
  link.download = `${name}.${format}`;
  link.click();
}

// The stretch that is on the screen.
function withRanges(layout: PlotLayout, shown: PlotElement | null): PlotLayout {
  const result = { ...layout };
  for (const name of Object.keys(layout).filter((key) => /^[xy]axis\d*$/.test(key))) {
    const axis = shown?.layout?.[name] as { range?: unknown; autorange?: unknown } | undefined;
    if (axis?.range && axis.autorange !== true) result[name] = { ...(layout[name] as object), range: axis.range, autorange: false };
  }
  return result;
}

function withTitle(layout: PlotLayout, title: string): PlotLayout {
  const margin = { ...(layout["margin"] as Record<string, number>) };
  return { ...layout, margin: { ...margin, t: (margin["t"] ?? 0) + 36 }, title: { text: title, font: { size: 14 }, x: 0.01, xanchor: "left", y: 0.985, yanchor: "top" } };
}
