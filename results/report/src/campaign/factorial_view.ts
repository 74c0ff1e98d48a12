// A factorial: what explains the variance, and every combination.
import type { Campaign, CampaignCurve, Factorial, Report } from "../data";
import { h, replaceContent } from "../dom";
import { plural, significant } from "../format";
import { Figure } from "../plots/figure";
import { drawVariance } from "../plots/variance";
import { type Column, focusHeading, headings, type Order, sorted } from "../sortable";
import { percent } from "./blocks";

export function factorialView(report: Report, campaign: Campaign): HTMLElement[] {
  const figures = campaign.factorial.map((response, i) => {
    const note = `share of the variance: sum of squares between the levels over the total; 95 % from 8 seeds on. ${plural(response.trials, "trial")}${response.left_out > 0 ? `, ${response.left_out} left out` : ""}`;
    const title = `What explains ${responseName(response)}`;
    return new Figure({ id: `variance-${i}`, title, note, fileName: () => `${report.title}-variance-${i}`, draw: async (theme, width) => drawVariance(response, theme, width) });
  });
  return [h("div", { class: "heats wide" }, ...figures.map((f) => f.element)), combinations(campaign)];
}

function responseName(response: Factorial): string {
  return response.response === "falls" ? "the falls" : `the ${response.response}`;
}

function combinations(campaign: Campaign): HTMLElement {
  const columns = columnsOf(campaign);
  const host = h("div", { class: "scroll tall", tabindex: 0, role: "region", "aria-label": "Every combination" });
  const draw = (order: Order | null): void => {
    const change = (next: Order | null): void => {
      draw(next);
      focusHeading(host, next?.column ?? order?.column ?? "");
    };
    const rows = sorted(campaign.curves, columns, order).map(combinationRow);
    replaceContent(host, h("table", { "data-test": "combinations" }, h("thead", {}, headings(columns, order, change)), h("tbody", {}, ...rows)));
  };
  draw({ column: "falls", descending: false });
  return h("div", {}, h("h3", {}, `${plural(campaign.curves.length, "combination")}`), host);
}

function columnsOf(campaign: Campaign): Column<CampaignCurve>[] {
  return [
    ...campaign.factors.map((factor, i) => ({ id: `factor-${i}`, heading: factor, key: (c: CampaignCurve) => c.factors[i] ?? "" })),
    { id: "falls", heading: "Falls", key: (c) => (c.trials > 0 ? c.falls / c.trials : null), class: "number" },
    { id: "com", heading: "CoM error [mm]", key: (c) => c.levels[0]?.com_error_m ?? null, class: "number" },
    { id: "errors", heading: "Not run", key: (c) => c.errors, class: "number" },
  ];
}

function combinationRow(curve: CampaignCurve): HTMLElement {
  const level = curve.levels[0];
  const falls = level?.falls_ci95;
  const com = level?.com_error_ci95;
  const millimetres = (x: number): string => significant(1e3 * x);
  return h(
    "tr",
    {},
    ...curve.factors.map((factor) => h("td", {}, factor || "\u2013")),
    h("td", { class: "number" }, `${curve.falls}/${curve.trials}`, falls && h("small", {}, `${percent(falls[0])} to ${percent(falls[1])}`)),
    h("td", { class: "number" }, typeof level?.com_error_m === "number" ? millimetres(level.com_error_m) : "\u2013", com && h("small", {}, `${millimetres(com[0])} to ${millimetres(com[1])}`)),
    h("td", { class: "number" }, String(curve.errors)),
  );
}
