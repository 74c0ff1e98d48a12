// The page of a campaign: curves, thresholds, maps, shares of variance, and what becomes of the rest of the page.
import assert from "node:assert/strict";
import { test } from "node:test";
import { spoil, withData } from "./batch.mjs";
import { becomesCampaign, breakdown, factorial, limit, map } from "./campaigns.mjs";
import { assertNoOverflow, drawn, plotted } from "./looks.mjs";
import { open, report, shot } from "./suite.mjs";

function pageOf(campaign) {
  return spoil(report.file, campaign.kind, (text) => withData(text, (data) => becomesCampaign(data, campaign)));
}

const kinds = { limit, breakdown, map, factorial };

test("the page of a run has no campaign", async () => {
  const page = await open();
  assert.equal(await page.getByTestId("campaign").count(), 0);
});

test("of a campaign the page shows what it has found, single trials and the run, and no tables by scenario", async () => {
  const page = await open(undefined, pageOf(limit()));
  const sections = await page.locator("main > section").evaluateAll((all) => all.map((s) => s.id));
  assert.deepEqual(sections, ["campaign", "scenario", "run"]);
  assert.match(await page.getByTestId("campaign").innerText(), /How hard a push .* of \d+ planned trials have been run/s);
  assert.match(await page.getByTestId("campaign-reasons").innerText(), /Why 18 trials could not be run/);
});

test("a curve has a point for each level with trials, its interval, and the thresholds beneath", async () => {
  const campaign = limit();
  const page = await open(undefined, pageOf(campaign));
  const figure = await drawn(page, "fall_share");
  assert.equal(await figure.getAttribute("data-state"), "drawn");
  const traces = await plotted(figure);
  for (const curve of campaign.curves.slice(0, 6)) {
    const own = traces.find((t) => t.name === curve.observer_id);
    assert.equal(own.points, curve.levels.length, curve.observer_id);
    assert.equal(own.high, Math.max(...curve.levels.map((l) => (100 * l.falls) / l.trials)));
  }
  const words = await figure.locator(".plot-frame").getAttribute("aria-label");
  assert.match(words, /momentum@tuned: \d+ of 140 fell, half of the trials at 33\.8 N \(27\.8 to 41\.0\)/);
  const names = await figure.evaluate((f) => f.querySelector(".js-plotly-plot").data.map((t) => t.yaxis ?? "y"));
  assert.ok(names.filter((axis) => axis === "y2").length >= 24, "two thresholds with two traces each for six observers");
  await shot(page, "campaign-limit");
  await shot(page, "campaign-limit-whole", true);
});

test("the table of thresholds says what is beyond the levels, and sorts from the mildest to the hardest", async () => {
  const page = await open(undefined, pageOf(limit()));
  const table = page.getByTestId("threshold-table");
  const row = (id) => table.locator(`tr[data-observer="${id}"]`).innerText();
  assert.match(await row("oracle_full"), /> 113\.9/);
  assert.match(await row("none"), /< 10/);
  await table.locator('[data-column="fall_50"]').click();
  const order = await table.locator("tbody tr").evaluateAll((rows) => rows.map((r) => r.dataset.observer));
  assert.deepEqual(order, ["none", "com_wrench@tuned", "momentum@tuned", "kalman@tuned", "momentum_com@tuned", "oracle_full"]);
  assert.equal(await table.locator('th[aria-sort="ascending"]').count(), 1);
});

test("the overview shows another block", async () => {
  const page = await open(undefined, pageOf(limit()));
  const matrix = page.getByTestId("threshold-matrix");
  assert.equal(await matrix.locator("tbody tr").count(), 3);
  await matrix.locator("button", { hasText: "case5/plus_30" }).click();
  assert.match(await page.getByTestId("campaign-block-name").innerText(), /^case5\/plus_30/);
  assert.equal(await page.getByTestId("campaign-block").inputValue(), "2");
  assert.match(await matrix.locator('tr[aria-current="true"]').innerText(), /case5/);
});

test("a breakdown has its errors over the level, and an axis that descends", async () => {
  const page = await open(undefined, pageOf(breakdown()));
  const figure = await drawn(page, "com_level");
  assert.ok((await plotted(figure)).every((t) => t.points > 0 && t.low > 0));
  const range = await figure.evaluate((f) => f.querySelector(".js-plotly-plot")._fullLayout.xaxis.range);
  assert.ok(range[0] > range[1], "friction: less is harder, and harder is to the right");
  await shot(page, "campaign-breakdown-whole", true);
});

test("a map has k/n in each cell, hatches where nothing ran, and shows errors instead", async () => {
  const page = await open(undefined, pageOf(map()));
  const heat = page.getByTestId("heat-map").and(page.locator('[data-observer="momentum@tuned"]'));
  assert.equal(await page.getByTestId("heat-map").count(), 6);
  assert.equal(await heat.locator("td[data-state=run]").count(), 29);
  const hard = heat.locator("tbody tr").first().locator("td").last();
  assert.equal(await hard.innerText(), "err");
  assert.match(await hard.getAttribute("title"), /^delay 10 ms, bandwidth 10 rad\/s: 20 trials could not be run$/);
  const mild = heat.locator("tbody tr").last().locator("td").first();
  assert.equal(await mild.innerText(), "0/20");
  assert.match(await mild.getAttribute("title"), /^delay 0 ms, bandwidth 160 rad\/s: 0 of 20 fell \(0 % to 16 %\); CoM error 4\.00 mm/);
  await shot(page, "campaign-map-whole", true);
  await page.getByTestId("heat-metric").locator('[data-value="com"]').click();
  assert.equal(await mild.innerText(), "4.0");
  await shot(page, "campaign-map-com", true);
});

test("a factorial has a bar for each share and a row for each combination", async () => {
  const page = await open(undefined, pageOf(factorial()));
  const figure = await drawn(page, "variance-0");
  assert.match(await figure.locator(".plot-frame").getAttribute("aria-label"), /leg estimator 42 % \(36 % to 47 %\)/);
  assert.equal(await figure.evaluate((f) => f.querySelector(".js-plotly-plot").data[0].x.length), 6);
  assert.equal(await page.getByTestId("combinations").locator("tbody tr").count(), 12);
  await drawn(page, "variance-1");
  await shot(page, "campaign-factorial-whole", true);
});

test("campaigns in the dark and in a narrow window", async () => {
  for (const [kind, make] of Object.entries(kinds)) {
    const page = await open({ width: 360, height: 740 }, pageOf(make()));
    await assertNoOverflow(page);
    for (const figure of await page.locator("#campaign figure[data-plot]").all()) await figure.scrollIntoViewIfNeeded();
    await page.waitForTimeout(300);
    await assertNoOverflow(page);
    await shot(page, `campaign-${kind}-narrow`, true);
    await page.setViewportSize({ width: 1280, height: 900 });
    await page.getByTestId("theme-toggle").click();
    await page.evaluate(() => window.scrollTo(0, 0));
    await page.waitForTimeout(500);
    await shot(page, `campaign-${kind}-dark`, true);
    await page.getByTestId("theme-toggle").click();
  }
});

test("the keyboard works a map's switches and an overview", async () => {
  const page = await open(undefined, pageOf(limit()));
  const button = page.getByTestId("threshold-matrix").locator("button").nth(1);
  await button.focus();
  await page.keyboard.press("Enter");
  assert.match(await page.getByTestId("campaign-block-name").innerText(), /^case1\/knee_lateral/);
  assert.equal(await page.evaluate(() => document.activeElement?.dataset.block), "1", "the focus stays");
});
