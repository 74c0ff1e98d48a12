// The paper's claims beside what was measured.
import type { Claim, Report } from "./data";
import { choiceButtons, h, replaceContent, select } from "./dom";
import { stateIcon } from "./icons";
import { type Column, focusHeading, headings, type Order, sorted } from "./sortable";

type Answer = "yes" | "no" | "none";

export class Claims {
  readonly element = h("section", { id: "claims", "aria-labelledby": "claims-heading" });
  private readonly bar = h("div", { class: "bar" });
  private readonly box = h("div", { class: "scroll tall", tabindex: 0, role: "region", "aria-label": "Claims of the paper" });
  private set = "";
  private answer: Answer | "all" = "all";
  private order: Order | null = null;

  constructor(private readonly report: Report) {
    this.element.append(h("h2", { id: "claims-heading" }, "The paper\u2019s claims"));
    if (report.claims.length === 0) {
      this.element.append(h("p", { class: "empty" }, "No claims were evaluated for this run."));
      return;
    }
    const sets = setsOf(report.claims);
    this.set = (sets.find((s) => s.startsWith("profile tuned")) ?? sets[0])!;
    this.element.append(overview(report.claims, sets), this.bar, this.box);
    this.draw();
  }

  private draw(): void {
    const claims = this.report.claims.filter((claim) => setOf(claim) === this.set);
    const own = this.answer === "all" ? claims : claims.filter((claim) => answerOf(claim.holds) === this.answer);
    replaceContent(this.bar, this.setChoice(), this.answerChoice(claims));
    const columns = this.columns();
    const head = h("thead", {}, headings(columns, this.order, (next) => this.sortBy(next)));
    const rows = sorted(own, columns, this.order).map(claimRow);
    const body = h("tbody", {}, ...(rows.length > 0 ? rows : [h("tr", {}, h("td", { colspan: columns.length }, "None."))]));
    replaceContent(this.box, h("table", { class: "claims", "data-test": "claims-table" }, head, body));
  }

  private sortBy(order: Order | null): void {
    const column = order?.column ?? this.order?.column ?? "";
    this.order = order;
    this.draw();
    focusHeading(this.box, column);
  }

  private setChoice(): HTMLElement {
    const choices = setsOf(this.report.claims).map((set) => ({ value: set, text: set }));
    const change = (set: string): void => {
      this.set = set;
      this.draw();
      this.bar.querySelector<HTMLElement>('[data-test="claims-set"]')?.focus();
    };
    return select("Asked of", choices, this.set, change, "claims-set");
  }

  private answerChoice(claims: Claim[]): HTMLElement {
    const count = (answer: Answer): number => claims.filter((c) => answerOf(c.holds) === answer).length;
    const choices = [
      { value: "all", text: `all ${claims.length}` },
      { value: "yes", text: `hold ${count("yes")}` },
      { value: "no", text: `fail ${count("no")}` },
      { value: "none", text: `no data ${count("none")}` },
    ];
    const change = (answer: string): void => {
      this.answer = answer as Answer | "all";
      this.draw();
      this.bar.querySelector<HTMLElement>(`[data-value="${answer}"]`)?.focus();
    };
    return choiceButtons("Show", choices, this.answer, change, "claims-filter");
  }

  private columns(): Column<Claim>[] {
    const ours = this.report.claims.some((claim) => claim.ours_measured !== null);
    return [
      { id: "holds", heading: "Holds", key: (c) => ({ yes: 0, no: 1, none: 2 })[answerOf(c.holds)] },
      { id: "case", heading: "Case", key: (c) => `${c.case} ${c.cells}` },
      { id: "claim", heading: "Claim", key: (c) => c.claim },
      { id: "paper", heading: "Paper", key: (c) => c.paper },
      { id: "measured", heading: "Measured", key: (c) => c.measured },
      ...(ours ? [{ id: "ours", heading: "Ours", key: (c: Claim) => ({ yes: 0, no: 1, none: 2 })[answerOf(c.ours_holds)] }] : []),
      { id: "note", heading: "Note" },
    ];
  }
}

function answerOf(holds: boolean | null): Answer {
  return holds === null ? "none" : holds ? "yes" : "no";
}

function setOf(claim: Claim): string {
  if (claim.profile === null && claim.gains === null) return "not part of this run";
  const parts = [`profile ${claim.profile}`, `gains ${claim.gains}`, `planner ${claim.planner}`];
  return parts.concat(claim.overrides ? [claim.overrides] : []).join(", ");
}

function setsOf(claims: Claim[]): string[] {
  const sets = [...new Set(claims.map(setOf))];
  return sets.sort((a, b) => Number(a === "not part of this run") - Number(b === "not part of this run"));
}

function overview(claims: Claim[], sets: string[]): HTMLElement {
  const lines = sets
    .filter((set) => set !== "not part of this run")
    .map((set) => {
      const own = claims.filter((claim) => setOf(claim) === set);
      const answered = own.filter((claim) => claim.holds !== null);
      return `${answered.filter((claim) => claim.holds).length} of ${answered.length} that could be answered hold with ${set}`;
    });
  return h("p", { class: "sentence", "data-test": "claims-overview" }, lines.length > 0 ? `${lines.join("; ")}.` : "None of them is part of this run.");
}

const kAnswer = { yes: ["survived", "holds"], no: ["fell", "fails"], none: ["empty", "no data"] } as const;

function answerCell(holds: boolean | null): HTMLElement {
  const [icon, text] = kAnswer[answerOf(holds)];
  return h("span", { class: "answer" }, stateIcon(icon), text);
}

function claimRow(claim: Claim): HTMLElement {
  const ours =
    claim.ours_measured === null ? null : h("td", { class: "ours" }, answerCell(claim.ours_holds), h("small", {}, claim.ours_measured));
  const columnOfOurs = ours ?? (claim.ours_holds === null ? h("td", {}, "\u2013") : h("td", {}, answerCell(claim.ours_holds)));
  return h(
    "tr",
    { "data-holds": answerOf(claim.holds) },
    h("td", {}, answerCell(claim.holds)),
    h("td", { class: "case" }, claim.case, h("small", {}, claim.cells)),
    h("td", { class: "text" }, claim.claim, h("small", {}, claim.source)),
    h("td", { class: "value" }, claim.paper),
    h("td", { class: "value" }, claim.measured || "\u2013"),
    columnOfOurs,
    h("td", { class: "text" }, h("small", {}, claim.note)),
  );
}
