// Statistics over seeds: the scatter of single runs, falls with intervals, paired differences.
import type { Report } from "./data";
import { choiceButtons, h, replaceContent, select } from "./dom";
import { kMetrics, metricOf, plural } from "./format";
import { Figure } from "./plots/figure";
import { drawFalls, drawPairs, drawSeeds, type Scope } from "./plots/seeds";
import { scenarioOf, type Selection } from "./selection";
import { comparable, inProfile, linesOf } from "./summary";

type Extent = "variant" | "scenario" | "all";

export class Statistics {
  readonly element = h("section", { id: "statistics", "aria-labelledby": "statistics-heading" });
  private readonly heading = h("p", { class: "note", "data-test": "statistics-scope" });
  private readonly figures: Figure[];
  private readonly bar = h("div", { class: "bar" });
  private extent: Extent = "all";
  private metric = kMetrics[0]!;

  constructor(
    private readonly report: Report,
    private readonly selection: Selection,
  ) {
    const figure = (id: string, title: string, note: string, draw: typeof drawSeeds): Figure =>
      new Figure({ id, title, note, fileName: () => `${report.title}-${id}-${this.metric.field}`, draw: async (theme, width) => draw(this.scope(), theme, width) });
    this.figures = [
      figure("seeds", "Runs, one by one", `a mark per run, the line is the median (a box from 8 runs on); runs that fell stand apart, by the time of their fall`, drawSeeds),
      figure("falls", "Falls", "share of runs that fell", drawFalls),
      figure("paired", "Against the reference, run by run", "same seed, on the time that both stood; left is better; a mark per variant, median over the pairs; interval from 8 pairs on", drawPairs),
    ];
    this.drawBar();
    this.element.append(h("h2", { id: "statistics-heading" }, "Over seeds"), this.bar, this.heading);
    this.element.append(h("div", { class: "grid" }, ...this.figures.map((f) => f.element)));
    for (const signal of [selection.scenario, selection.profile, selection.setting]) signal.subscribe(() => this.refresh());
    this.refresh();
  }

  private drawBar(): void {
    const metrics = kMetrics.map((m) => ({ value: m.field, text: `${m.label} [${m.unit}]` }));
    const setMetric = (field: string): void => {
      this.metric = metricOf(field);
      this.refresh();
    };
    const extents = [
      { value: "all", text: "all scenarios" },
      { value: "scenario", text: "the scenario above" },
      { value: "variant", text: "its variant" },
    ];
    const setExtent = (extent: string): void => {
      this.extent = extent as Extent;
      this.refresh();
    };
    replaceContent(this.bar, select("Metric", metrics, this.metric.field, setMetric, "metric"), choiceButtons("Over", extents, this.extent, setExtent, "extent"));
  }

  private refresh(): void {
    const { name, cells } = this.scope();
    const seeds = new Set(cells.map((cell) => cell.seed)).size;
    this.heading.textContent = `${name}: ${plural(cells.length, "run")}, ${plural(seeds, "seed")} each.`;
    for (const figure of this.figures) figure.invalidate();
  }

  private scope(): Scope {
    const { report, selection } = this;
    const scenario = scenarioOf(report, selection);
    const counted = new Set(comparable(report.rows.filter((row) => row.setting === selection.setting.get())).map((row) => row.scenario));
    const within = (id: string): boolean => {
      if (this.extent === "variant") return id === scenario?.id;
      const file = report.scenarios.find((s) => s.id === id)?.scenario ?? id;
      return this.extent === "scenario" ? file === scenario?.scenario : counted.has(file);
    };
    const chosen = report.observers.filter((o) => inProfile(o, selection.profile.get()));
    const fits = (x: { scenario_id: string; setting: number; observer_id: string }): boolean =>
      x.setting === selection.setting.get() && within(x.scenario_id) && chosen.some((o) => o.id === x.observer_id);
    const rows = report.rows.filter(fits);
    const observers = linesOf(report, rows).map((line) => line.observer);
    const name = { variant: scenario?.id ?? "", scenario: `${scenario?.scenario ?? ""}, all variants`, all: "All scenarios of the verdict" }[this.extent];
    return { report, observers, cells: report.cells.filter(fits), rows, metric: this.metric, name };
  }
}
