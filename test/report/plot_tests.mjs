// The plots: data, choice of scenario and observers, download.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { assertHasData, drawn, plotted } from "./looks.mjs";
import { choose, kTabs, open, openTab, report, shot } from "./suite.mjs";

const kFewPoints = { tick: 2, qp: 2, support: 3 }; // histograms; corners

test("every plot of a scenario has lines with data", async () => {
  const page = await open();
  await choose(page, "case1/tip_lateral");
  const traces = report.data.traces.filter((t) => t.scenario_id === "case1/tip_lateral").length;
  assert.ok(traces >= 3, "the batch keeps time series");
  for (const [tab, plots] of Object.entries(kTabs)) {
    await openTab(page, tab);
    for (const plot of plots) {
      await assertHasData(page, plot, 1, kFewPoints[plot]);
      if (["com_error", "foot_error", "tick"].includes(plot)) await shot(page, `plot-${plot}`);
    }
  }
});

test("the plots over seeds have a mark for every run", async () => {
  const page = await open();
  for (const plot of ["seeds", "falls", "paired"]) {
    const figure = await drawn(page, plot);
    assert.equal(await figure.getAttribute("data-state"), "drawn");
    assert.ok((await plotted(figure)).length > 0, plot);
  }
});

test("another scenario and another observer are other lines", async () => {
  const page = await open();
  await choose(page, "case1/tip_lateral");
  await openTab(page, "tracking");
  const first = await assertHasData(page, "com_error");
  const chip = page.getByTestId("observers").locator('[data-observer^="momentum_com"][aria-pressed="true"]').first();
  const id = await chip.getAttribute("data-observer");
  await page.getByTestId("observers").locator(`[data-observer="${id}"]`).click();
  await page.waitForFunction(
    (count) => document.querySelector('figure[data-plot="com_error"] .js-plotly-plot').data.length < count,
    first.length,
  );
  await choose(page, "case6");
  await page.waitForTimeout(300);
  const other = await assertHasData(page, "com_error");
  assert.notDeepEqual(other, first);
});

test("a plot can be saved as SVG", async () => {
  const page = await open();
  await choose(page, "case1/tip_lateral");
  await openTab(page, "tracking");
  const figure = await drawn(page, "com_error");
  const [download] = await Promise.all([page.waitForEvent("download"), figure.getByTestId("download-svg").click()]);
  const path = join(report.shots, "com_error.svg");
  await download.saveAs(path);
  const svg = readFileSync(path, "utf8");
  assert.match(svg, /^<svg[\s>]/);
  assert.ok((svg.match(/<path/g) ?? []).length > 5, "lines");
});
