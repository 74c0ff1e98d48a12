// What the page uses of plotly.js.
declare module "plotly.js-cartesian-dist-min" {
  export type Datum = number | string | null;
  export interface PlotTrace {
    [key: string]: unknown;
  }
  export interface PlotLayout {
    [key: string]: unknown;
  }
  export interface Axis {
    _offset: number;
    _length: number;
    range: [number, number];
    l2p(value: number): number;
  }
  export interface PlotElement extends HTMLDivElement {
    data?: PlotTrace[];
    layout?: PlotLayout;
    _fullLayout?: Record<string, unknown> & { _size?: { t: number; h: number } };
    on(event: string, listener: (event: Record<string, unknown>) => void): void;
  }
  export interface Plotly {
    react(element: HTMLElement, data: PlotTrace[], layout: PlotLayout, config?: object): Promise<PlotElement>;
    relayout(element: HTMLElement, change: PlotLayout): Promise<PlotElement>;
    purge(element: HTMLElement): void;
    toImage(figure: object, options: object): Promise<string>;
  }
  const plotly: Plotly;
  export default plotly;
}
