// The report page: reads its data, then builds the sections from top to bottom.
import { Claims } from "./claims";
import { readReport, type Report } from "./data";
import { h } from "./dom";
import { plural } from "./format";
import { runFacts, runLine } from "./run_facts";
import { ScenarioView } from "./scenario_view";
import { makeSelection } from "./selection";
import { Statistics } from "./statistics";
import { startTheme, themeToggle } from "./theme";
import { Verdict } from "./verdict";

const kSections = [
  ["verdict", "Verdict"],
  ["claims", "Claims"],
  ["scenario", "Scenario"],
  ["statistics", "Seeds"],
  ["run", "Run"],
] as const;

function header(report: Report): HTMLElement {
  const links = kSections.map(([id, text]) => h("a", { href: `#${id}` }, text));
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
  if (run.finished < run.planned) texts.push(`This run is not complete: ${run.finished} of ${run.planned} runs have finished.`);
  if (run.errors > 0) texts.push(`${plural(run.errors, "run")} could not be run.`);
  if (report.missing.length > 0) texts.push(report.missing.length === 1 ? report.missing[0]! : `This run lacks ${plural(report.missing.length, "thing")}: see below.`);
  if (texts.length === 0) return null;
  return h("p", { class: "warning", "data-test": "warnings" }, ...texts.map((text) => h("span", {}, text, " ")), h("a", { href: "#run" }, "This run"));
}

function build(app: HTMLElement): void {
  const report = readReport(document);
  document.title = `dobbench report: ${report.title}`;
  startTheme();
  const selection = makeSelection(report);
  const scenario = new ScenarioView(report, selection);
  const verdict = new Verdict(report, selection, () => scenario.focus());
  const content = [runLine(report), warnings(report), verdict.element, new Claims(report).element, scenario.element, new Statistics(report, selection).element, runFacts(report)];
  app.append(header(report), h("main", {}, ...content));
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
