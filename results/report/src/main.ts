// The report page: reads its data, then builds the sections from top to bottom.
import { campaignSection } from "./campaign/section";
import { Claims } from "./claims";
import { type Campaign, readReport, type Report } from "./data";
import { h } from "./dom";
import { plural } from "./format";
import { runFacts, runLine } from "./run_facts";
import { ScenarioView } from "./scenario_view";
import { makeSelection } from "./selection";
import { Statistics } from "./statistics";
import { startTheme, themeToggle } from "./theme";
import { Verdict } from "./verdict";

// One part of the page, and what the link to it says.
interface Part {
  id: string;
  text: string;
  element: HTMLElement;
}

// Of a run: its tables, one scenario, the seeds.
function partsOfRun(report: Report): Part[] {
  const selection = makeSelection(report);
  const scenario = new ScenarioView(report, selection);
  return [
    { id: "verdict", text: "Verdict", element: new Verdict(report, selection, () => scenario.focus()).element },
    { id: "claims", text: "Claims", element: new Claims(report).element },
    { id: "scenario", text: "Scenario", element: scenario.element },
    { id: "statistics", text: "Seeds", element: new Statistics(report, selection).element },
  ];
}

// Of a campaign: what it has found, and single trials where there are time series. Tables by scenario would be one for
// each level.
function partsOfCampaign(report: Report, campaign: Campaign): Part[] {
  const parts = [{ id: "campaign", text: "Campaign", element: campaignSection(report, campaign) }];
  if (report.traces.length > 0) parts.push({ id: "scenario", text: "Scenario", element: new ScenarioView(report, makeSelection(report)).element });
  return parts;
}

function header(report: Report, parts: readonly Part[]): HTMLElement {
  const links = parts.map(({ id, text }) => h("a", { href: `#${id}` }, text));
  return h(
    "header",
    { class: "top" },
    h("h1", {}, h("span", { class: "product" }, "dobbench"), " ", report.title),
    h("nav", { "aria-label": "Sections" }, ...links),
    themeToggle(),
  );
}

// What the reader must know before the figures.
function warnings(report: Report): HTMLElement | null {
  const { run } = report;
  const texts: string[] = [];
  if (run.finished < run.planned && !report.campaign) texts.push(`This run is not complete: ${run.finished} of ${run.planned} runs have finished.`);
  if (run.errors > 0) texts.push(`${plural(run.errors, "run")} could not be run.`);
  if (report.missing.length > 0) texts.push(report.missing.length === 1 ? report.missing[0]! : `This run lacks ${plural(report.missing.length, "thing")}: see below.`);
  if (texts.length === 0) return null;
  return h("p", { class: "warning", "data-test": "warnings" }, ...texts.map((text) => h("span", {}, text, " ")), h("a", { href: "#run" }, "This run"));
}

function build(app: HTMLElement): void {
  const report = readReport(document);
  document.title = `dobbench report: ${report.title}`;
  startTheme();
  const parts = report.campaign ? partsOfCampaign(report, report.campaign) : partsOfRun(report);
  parts.push({ id: "run", text: "Run", element: runFacts(report) });
  app.append(header(report, parts), h("main", {}, runLine(report), warnings(report), ...parts.map((part) => part.element)));
  app.dataset["ready"] = "true";
}

const app = document.getElementById("app");
if (app) {
  try {
    build(app);
  } catch (error) {
    app.append(h("p", { class: "warning", role: "alert" }, error instanceof Error ? error.message : String(error)));
  }
}
