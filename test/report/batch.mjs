// The batch whose page is tested: real runs, a few seconds long, with falls, blocks, two robots, two profiles and two
// seeds. All with the gains of one set, which the verdict shows together; quad12 would have its own.
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const kRun = [
  "run", "case1/tip_lateral", "case1_no_swing/tip_lateral", "case5/plus_30", "case6", "quad12_case1/tip_lateral",
  ...["none", "momentum", "momentum_com"].flatMap((name) => ["--observer", name]),
  "--gains", "paper", "--profile", "paper", "--profile", "tuned", "--seeds", "2", "--set", "duration_s=4", "--jobs", "2",
];

function dobbench(program, args) {
  execFileSync(program, args, { stdio: ["ignore", "ignore", "inherit"] });
}

/** Runs the batch in `work`, measures it, writes its page; the page's path. */
export function makePage(program, work) {
  const run = join(work, "run");
  const page = join(work, "report.html");
  rmSync(run, { recursive: true, force: true });
  rmSync(page, { force: true });
  dobbench(program, [...kRun, "--out", run]);
  dobbench(program, ["timing", "--out", run, "--seconds", "0.5"]);
  dobbench(program, ["report", run, "-o", page]);
  return page;
}

/** The data of a page as `dobbench report` wrote it. */
export function dataOf(page) {
  const text = readFileSync(page, "utf8").match(/<script type="application\/json" id="report-data">(.*?)<\/script>/s)?.[1];
  if (!text) throw new Error(`${page} holds no data`);
  return JSON.parse(text);
}

/** What `change` makes of the data of a page's text; for spoil(). */
export function withData(text, change) {
  const at = /(<script type="application\/json" id="report-data">)(.*?)(<\/script>)/s;
  return text.replace(at, (_, begin, json, end) => {
    const data = JSON.parse(json);
    change(data);
    return begin + JSON.stringify(data).replaceAll("<", "\\u003c") + end;
  });
}

/** A copy of the page, spoilt on purpose: the tests of the tests. */
export function spoil(page, name, change) {
  const copy = page.replace(/\.html$/, `-${name}.html`);
  writeFileSync(copy, change(readFileSync(page, "utf8")));
  return copy;
}
