// What a campaign has found: curves over one axis, maps over two, or shares of variance.
import type { Campaign, Report } from "../data";
import { h } from "../dom";
import { plural } from "../format";
import { CurvesView } from "./curves_view";
import { factorialView } from "./factorial_view";
import { MapView } from "./map_view";

const kKinds: Record<Campaign["kind"], string> = {
  limit: "Limits: where trials begin to fall",
  map: "Map: every level of one axis with every level of the other",
  breakdown: "Breakdown: from the mildest level until everything falls",
  factorial: "Factorial: every combination of what a trial is made of",
};

export function campaignSection(report: Report, campaign: Campaign): HTMLElement {
  return h(
    "section",
    { id: "campaign", "aria-labelledby": "campaign-heading", "data-test": "campaign", "data-kind": campaign.kind },
    h("h2", { id: "campaign-heading" }, `Campaign ${campaign.name}`),
    h("p", { class: "sentence" }, campaign.summary, h("small", {}, facts(campaign))),
    ...view(report, campaign),
    reasons(campaign),
    file(campaign),
  );
}

function facts(campaign: Campaign): string {
  const trials = `${campaign.finished} of ${plural(campaign.planned, "planned trial")} have been run`;
  const search = campaign.kind === "limit" || campaign.kind === "breakdown" ? "; a search leaves out what would tell nothing new" : "";
  return `${kKinds[campaign.kind]}. ${trials}${search}.`;
}

function view(report: Report, campaign: Campaign): HTMLElement[] {
  if (campaign.curves.length === 0) return [h("p", { class: "empty" }, "This campaign has no trials.")];
  if (campaign.kind === "factorial") return factorialView(report, campaign);
  return [campaign.kind === "map" ? new MapView(report, campaign).element : new CurvesView(report, campaign).element];
}

function reasons(campaign: Campaign): HTMLElement | null {
  if (campaign.reasons.length === 0) return null;
  const total = campaign.reasons.reduce((sum, { cells }) => sum + cells, 0);
  const rows = campaign.reasons.map(({ reason, cells }) => h("li", {}, `${plural(cells, "trial")}: ${reason}`));
  return h("details", { class: "others", "data-test": "campaign-reasons" }, h("summary", {}, `Why ${plural(total, "trial")} could not be run`), h("ul", {}, ...rows));
}

function file(campaign: Campaign): HTMLElement | null {
  if (campaign.document === "") return null;
  const text = h("pre", { class: "scroll tall", tabindex: 0, role: "region", "aria-label": "The campaign\u2019s file" }, campaign.document);
  return h("details", { class: "others" }, h("summary", {}, "The campaign\u2019s file"), text);
}
