// Where the figures come from: machine, commit, command; what the run lacks and what the page left out.
import type { Report } from "./data";
import { h } from "./dom";
import { plural } from "./format";

// One line under the title.
export function runLine(report: Report): HTMLElement {
  const { run } = report;
  const parts = [
    run.date.replace("T", " ").replace("Z", " UTC"),
    `dobbench ${run.version}, commit ${run.commit}`,
    [run.machine.cpu, run.machine.cores ? plural(run.machine.cores, "core") : ""].filter(Boolean).join(", "),
    `${run.seeds.length === 1 ? "seed" : "seeds"} ${seedText(run.seeds)}`,
    run.finished < run.planned ? `${run.finished} of ${run.planned} runs finished` : plural(run.finished, "run"),
  ];
  return h("p", { class: "run-line", "data-test": "run-line" }, ...parts.filter(Boolean).map((part) => h("span", {}, part)));
}

export function runFacts(report: Report): HTMLElement {
  const { run } = report;
  const facts: [string, string][] = [
    ["Command", run.command_line],
    ["Version, commit", `${run.version}, ${run.commit}`],
    ["Build", [run.build, run.compiler, run.flags].filter(Boolean).join(", ")],
    ["Machine", [run.machine.cpu, run.machine.cores ? plural(run.machine.cores, "core") : "", run.machine.os].filter(Boolean).join(", ")],
    ["Date", run.date],
    ["Runs", `${run.finished} of ${run.planned} finished, ${run.errors} could not be run; seeds ${seedText(run.seeds)}`],
    ["Page", `written by dobbench ${report.written_by.version}, commit ${report.written_by.commit}`],
  ];
  const list = h("dl", { class: "facts" }, ...facts.flatMap(([name, text]) => [h("dt", {}, name), h("dd", {}, text)]));
  return h(
    "section",
    { id: "run", "aria-labelledby": "run-heading", "data-test": "run-facts" },
    h("h2", { id: "run-heading" }, "This run"),
    list,
    sentences("Notes", run.notes, "notes"),
    sentences("What the run lacks", report.missing, "missing"),
    leftOut(report),
  );
}

function seedText(seeds: readonly number[]): string {
  const first = seeds[0];
  const last = seeds[seeds.length - 1];
  if (first === undefined || last === undefined) return "\u2013";
  const whole = last - first === seeds.length - 1 && seeds.length > 2;
  return whole ? `${first}\u2013${last}` : seeds.join(", ");
}

function sentences(heading: string, texts: readonly string[], test: string): HTMLElement | null {
  if (texts.length === 0) return null;
  return h("div", { "data-test": test }, h("h3", {}, heading), h("ul", {}, ...texts.map((text) => h("li", {}, text))));
}

function leftOut(report: Report): HTMLElement {
  const shown = `This page shows ${plural(report.traces.length, "time series and replay", "time series and replays")}`;
  if (report.left_out.length === 0) return h("p", { "data-test": "left-out" }, `${shown}; nothing was left out.`);
  const rows = report.left_out.map(({ what, why }) => h("tr", {}, h("td", {}, what), h("td", { class: "why" }, why)));
  return h(
    "div",
    { "data-test": "left-out" },
    h("h3", {}, "What the page left out"),
    h("p", {}, `${shown}. Left out:`),
    h(
      "div",
      { class: "scroll short", tabindex: 0, role: "region", "aria-label": "What the page left out" },
      h("table", {}, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "What"), h("th", { scope: "col" }, "Why"))), h("tbody", {}, ...rows)),
    ),
  );
}
