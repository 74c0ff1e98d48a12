// The plots: data, choice of scenario and observers, download.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { assertHasData, assertRounded, drawn, plotted } from "./looks.mjs";
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
  const marks = async (plot, axis) => {
    const figure = await drawn(page, plot);
    assert.equal(await figure.getAttribute("data-state"), "drawn");
    const traces = (await plotted(figure)).filter((trace) => trace.mode === "markers" && trace.axis === axis);
    return traces.reduce((sum, trace) => sum + trace.points, 0);
  };
  const shown = (x) => !x.observer_id.endsWith("@paper"); // the tuned ones are shown first
  const [cells, rows] = [report.data.cells.filter(shown), report.data.rows.filter(shown)];
  const ended = (outcome) => cells.filter((cell) => cell.outcome === outcome).length;
  assert.ok(ended("survived") > 0 && ended("fell") > 0, "runs of the batch survive and fall");
  assert.equal(await marks("seeds", "x"), ended("survived"));
  assert.equal(await marks("seeds", "x2"), ended("fell"));
  assert.equal(await marks("falls", "x"), new Set(rows.map((row) => row.observer_id)).size);
  assert.equal(await marks("paired", "x"), rows.filter((row) => row.paired_com_error_max_m !== null).length);
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

test("the force's words state the error that the run measured", async () => {
  const page = await open();
  await choose(page, "case1/tip_lateral");
  await openTab(page, "estimates");
  const words = await (await drawn(page, "force")).locator(".plot-frame").getAttribute("aria-label");
  const told = [...words.matchAll(/(\S+) ([\d.]+) N\b/g)].map(([, id, rmse]) => [id, Number(rmse)]);
  const cells = report.data.cells.filter((c) => c.scenario_id === "case1/tip_lateral" && c.seed === 1 && c.estimate_rmse_N !== null);
  const measured = cells.filter((c) => !c.observer_id.endsWith("@paper"));
  assert.ok(measured.length > 0, "an observer estimates the force");
  assert.deepEqual(told.map(([id]) => id).sort(), measured.map((c) => c.observer_id).sort());
  for (const [id, rmse] of told) assertRounded(rmse, measured.find((c) => c.observer_id === id).estimate_rmse_N, id);
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
