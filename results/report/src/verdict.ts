// The verdict in one screen: scenarios down, observers across; how many runs survived, and how far off the rest were.
import type { ObserverInfo, Report, Row } from "./data";
import { breakable, choiceButtons, h, replaceContent, select } from "./dom";
import { millimetres, plural, settingName, shortName } from "./format";
import { kStateText, stateIcon } from "./icons";
import { selectScenario, type Selection, variantToShow } from "./selection";
import { type Column, focusHeading, headings, type Order, sorted } from "./sortable";
import { type CellSummary, comparable, inProfile, type Line, linesOf, lostShare, profilesOf, summarise, value, verdictSentence } from "./summary";

export class Verdict {
  readonly element = h("section", { id: "verdict", "aria-labelledby": "verdict-heading" });
  private readonly sentence = h("p", { class: "sentence", "data-test": "verdict-sentence", "aria-live": "polite" });
  private readonly tables = h("div", {});
  private readonly open = new Set<string>();
  private order: Order | null = null;
  private othersOpen = false;

  constructor(
    private readonly report: Report,
    private readonly selection: Selection,
    private readonly opened: () => void, // the reader asked for a scenario
  ) {
    this.element.append(h("h2", { id: "verdict-heading" }, "Verdict"), this.sentence, this.filters(), this.tables, legend());
    selection.profile.subscribe(() => this.draw());
    selection.setting.subscribe(() => this.draw());
    this.draw();
  }

  private filters(): HTMLElement {
    const { report, selection } = this;
    const profiles = profilesOf(report);
    const choices = [...profiles.map((p) => ({ value: p, text: p })), { value: "", text: "all" }];
    const settings = report.settings.map((s) => ({ value: String(s.id), text: settingName(s) }));
    return h(
      "div",
      { class: "bar" },
      profiles.length > 0 &&
        choiceButtons("Profile", choices, selection.profile.get() ?? "", (v) => selection.profile.set(v || null), "profile-filter"),
      settings.length > 1
        ? select("Gains, planner", settings, String(selection.setting.get()), (v) => selection.setting.set(Number(v)), "setting-filter")
        : h("span", { class: "field" }, h("span", {}, "Gains, planner"), settings[0]?.text ?? "\u2013"),
    );
  }

  private draw(): void {
    const { report, selection } = this;
    const setting = report.rows.filter((row) => row.setting === selection.setting.get());
    const main = comparable(setting);
    const byProfile = (rows: Row[]): Row[] => rows.filter((row) => inProfile(row, selection.profile.get()));
    const lines = linesOf(report, byProfile(main));
    const names = new Set(main.map((row) => row.scenario));
    this.sentence.textContent = verdictSentence(lines, names.size);
    const others = setting.filter((row) => !names.has(row.scenario));
    const parts = [matrix(this, lines, "verdict-table", "Verdict by scenario and observer")];
    if (others.length > 0) parts.push(this.otherScenarios(others));
    replaceContent(this.tables, ...parts);
  }

  // Scenarios with observers of their own.
  private otherScenarios(rows: Row[]): HTMLElement {
    const names = [...new Set(rows.map((row) => row.scenario))];
    return h(
      "details",
      { class: "others", open: this.othersOpen, ontoggle: (event) => (this.othersOpen = (event.target as HTMLDetailsElement).open) },
      h("summary", {}, `With observers of their own: ${names.join(", ")}`),
      ...names.map((name) =>
        matrix(this, linesOf(this.report, rows.filter((row) => row.scenario === name)), `verdict-${name}`, `Verdict of ${name}`),
      ),
    );
  }

  sortBy(order: Order | null, table: string): void {
    const column = order?.column ?? this.order?.column ?? "";
    this.order = order;
    this.draw();
    const drawn = document.querySelector(`[data-test="${CSS.escape(table)}"]`);
    if (drawn) focusHeading(drawn, column);
  }

  currentOrder(): Order | null {
    return this.order;
  }

  isOpen(scenario: string): boolean {
    return this.open.has(scenario);
  }

  toggle(scenario: string): void {
    if (!this.open.delete(scenario)) this.open.add(scenario);
    this.draw();
    document.querySelector<HTMLElement>(`button.expand[data-scenario="${CSS.escape(scenario)}"]`)?.focus();
  }

  show(scenario: string, wanted: string | null, observer: ObserverInfo): void {
    const { report, selection } = this;
    selection.shown.set(new Set([...selection.shown.get(), observer.id]));
    selection.focus.set(observer.id);
    selectScenario(report, selection, variantToShow(report, selection.setting.get(), scenario, wanted, observer.id));
    this.opened();
  }

  scenariosIn(lines: readonly Line[]): string[] {
    const present = new Set(lines.flatMap((line) => line.rows.map((row) => row.scenario)));
    return [...new Set(this.report.scenarios.map((s) => s.scenario))].filter((name) => present.has(name));
  }
}

function matrix(verdict: Verdict, lines: Line[], test: string, label: string): HTMLElement {
  const cellOf = (line: Line, scenario: string): CellSummary => summarise(line.rows.filter((row) => row.scenario === scenario));
  const columns: Column<string>[] = [
    { id: "scenario", heading: "Scenario", key: (name) => name, class: "name" },
    ...lines.map((line) => ({
      id: line.observer.id,
      heading: observerHeading(line.observer),
      key: (name: string) => sortKey(cellOf(line, name)),
      class: line.observer.oracle ? "oracle" : "",
    })),
  ];
  const order = verdict.currentOrder();
  const body = h("tbody", {});
  for (const scenario of sorted(verdict.scenariosIn(lines), columns, order)) {
    const variants = [...new Set(lines.flatMap((l) => l.rows.filter((r) => r.scenario === scenario).map((r) => r.variant)))];
    body.append(scenarioRow(verdict, scenario, variants, lines, cellOf));
    if (variants.length > 1 && verdict.isOpen(scenario)) {
      for (const variant of variants) body.append(variantRow(verdict, scenario, variant, lines));
    }
  }
  const head = h("thead", {}, headings(columns, order, (next) => verdict.sortBy(next, test)));
  const table = h("table", { class: "matrix", "data-test": test, "aria-label": label }, head, body, h("tfoot", {}, totalRow(lines)));
  return h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, table);
}

function observerHeading(observer: ObserverInfo): HTMLElement {
  return h(
    "span",
    { class: "observer", title: observer.id },
    breakable(shortName(observer.observer, 64)),
    h("small", {}, observer.oracle ? "bound" : observer.profile === "-" ? "\u00A0" : observer.profile),
  );
}

// Fewer lost runs first, then the smaller CoM error; within a share of 1 the error cannot reach the next share.
function sortKey(cell: CellSummary): number | null {
  if (cell.runs + cell.errors === 0) return null;
  return lostShare(cell) * 1e6 + Math.min(1e3, value(cell.com, "com_error_max_m") ?? 1e3);
}

function scenarioRow(
  verdict: Verdict,
  scenario: string,
  variants: string[],
  lines: Line[],
  cellOf: (line: Line, scenario: string) => CellSummary,
): HTMLElement {
  const open = verdict.isOpen(scenario);
  const head =
    variants.length > 1
      ? h(
          "button",
          { type: "button", class: "expand", "data-test": "expand", "data-scenario": scenario, "aria-expanded": open, onclick: () => verdict.toggle(scenario) },
          h("span", { class: "chevron", "aria-hidden": true }, "\u25B8"),
          h("span", {}, scenario),
          h("small", {}, plural(variants.length, "variant")),
        )
      : h("span", { class: "expand" }, h("span", { class: "chevron" }), h("span", {}, scenario), variants[0] !== "" && h("small", {}, variants[0] ?? ""));
  const cells = lines.map((line) => cellOf(line, scenario));
  const best = bestOf(lines, cells);
  return h(
    "tr",
    { "data-scenario": scenario },
    h("th", { scope: "row", class: "name" }, head),
    ...lines.map((line, i) => dataCell(verdict, scenario, cells[i]!, line.observer, i === best)),
  );
}

function variantRow(verdict: Verdict, scenario: string, variant: string, lines: Line[]): HTMLElement {
  const cells = lines.map((line) => summarise(line.rows.filter((r) => r.scenario === scenario && r.variant === variant)));
  const best = bestOf(lines, cells);
  return h(
    "tr",
    { class: "variant", "data-scenario": `${scenario}/${variant}` },
    h("th", { scope: "row", class: "name" }, breakable(variant)),
    ...lines.map((line, i) => dataCell(verdict, scenario, cells[i]!, line.observer, i === best, `${scenario}/${variant}`)),
  );
}

// The smallest CoM error among the observers that compete and lost nothing.
function bestOf(lines: Line[], cells: CellSummary[]): number {
  let best = -1;
  let smallest = Infinity;
  cells.forEach((cell, i) => {
    const error = value(cell.com, "com_error_max_m");
    if (lines[i]!.observer.oracle || cell.state !== "survived" || error === null || error >= smallest) return;
    best = i;
    smallest = error;
  });
  return best;
}

function dataCell(verdict: Verdict, scenario: string, cell: CellSummary, observer: ObserverInfo, best: boolean, wanted?: string): HTMLElement {
  const classes = `cell cell-${cell.state}${observer.oracle ? " oracle" : ""}`;
  if (cell.state === "empty") return h("td", { class: classes }, h("span", { class: "nothing" }, "\u2013"));
  const com = millimetres(value(cell.com, "com_error_max_m"));
  const foot = millimetres(value(cell.foot, "foot_error_max_m"));
  const target = wanted ?? cell.com?.scenario_id ?? null;
  const button = h(
    "button",
    {
      type: "button",
      "data-test": "verdict-cell",
      "data-observer": observer.id,
      "data-state": cell.state,
      "aria-label": spoken(cell, wanted ?? scenario, observer, best),
      title: spoken(cell, wanted ?? scenario, observer, best),
      onclick: () => verdict.show(scenario, target, observer),
    },
    h("span", { class: "count" }, stateIcon(cell.state), survivors(cell), cell.runs + cell.errors < cell.seeds && h("small", {}, ` of ${cell.seeds}`)),
    h("span", { class: best ? "errors best" : "errors" }, cell.com ? `${com} / ${foot}` : "\u2013"),
  );
  return h("td", { class: classes }, button);
}

// Of the runs that were to be had by now: what could not be run is lost.
function survivors(x: { runs: number; falls: number; errors: number }): string {
  return `${x.runs - x.falls}/${x.runs + x.errors}`;
}

function spoken(cell: CellSummary, name: string, observer: ObserverInfo, best: boolean): string {
  const parts = [`${observer.id} in ${name}: ${cell.runs - cell.falls} of ${plural(cell.runs + cell.errors, "run")} survived`];
  if (cell.errors > 0) parts.push(`${cell.errors} could not be run`);
  if (cell.runs + cell.errors < cell.seeds) parts.push(`${cell.seeds - cell.runs - cell.errors} not run yet`);
  if (cell.com) parts.push(`CoM error ${millimetres(value(cell.com, "com_error_max_m"))} mm (${cell.com.variant || "its only variant"})`);
  if (cell.foot) parts.push(`foot error ${millimetres(value(cell.foot, "foot_error_max_m"))} mm`);
  return parts.join("; ") + (best ? "; smallest CoM error of those that never fell here" : "");
}

function totalRow(lines: Line[]): HTMLElement {
  return h(
    "tr",
    { class: "total" },
    h("th", { scope: "row", class: "name" }, "All", h("small", {}, " survived, mean rank")),
    ...lines.map((line) =>
      h(
        "td",
        { class: line.observer.oracle ? "oracle" : "" },
        h("span", { class: "count" }, survivors(line), line.runs + line.errors < line.seeds && h("small", {}, ` of ${line.seeds}`)),
        line.errors > 0 && h("span", { class: "errors" }, plural(line.errors, "error")),
        h("span", { class: "errors" }, line.observer.oracle ? "not ranked" : line.meanRank === null ? "\u2013" : `rank ${line.meanRank.toFixed(1)}`),
      ),
    ),
  );
}

const kLegend = [
  "k/n: k of n runs survived, n with those that could not be run.",
  "Below it: CoM / foot error [mm], median over the seeds, CoM and foot error each of its own worst variant among those in which a run survived.",
  "CoM: largest error; foot: largest error in swing, without the swings that a disturbance\u2019s onset meets within 20 ms.",
  "Bold: the smallest CoM error of those that never fell.",
  "Mean rank: over the variants, each among the observers shown: by lost runs, then CoM error (where all were lost, by the time of the fall).",
  "A press shows the runs.",
].join(" ");

function legend(): HTMLElement {
  const shapes = (["survived", "some", "fell", "error", "pending"] as const).map((state) =>
    h("span", { class: "key" }, stateIcon(state), kStateText[state]),
  );
  return h(
    "p",
    { class: "note legend" },
    ...shapes,
    h("span", {}, kLegend),
  );
}
