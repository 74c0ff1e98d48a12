// The replay's robot, and a browser that cannot show it.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { spoil, withData } from "./batch.mjs";
import { Browser } from "./browser.mjs";
import { readTrace } from "./dobtrace.mjs";
import { assertHasData, drawn } from "./looks.mjs";
import { ReplayPart } from "./replay.mjs";
import { largestFootDistance } from "./robot_model.mjs";
import { choose, open, openTab, report, shot } from "./suite.mjs";

test("the replay's feet are where those of the simulation were", async () => {
  const folder = join(report.work, "run", "traces");
  const traces = readdirSync(folder);
  const of = (scenario) => traces.filter((name) => new RegExp(`^\\d+_${scenario}_tip`).test(name)).slice(0, 2);
  const chosen = ["case1", "quad12_case1"].flatMap((scenario) => of(scenario).map((name) => ({ scenario, name })));
  assert.equal(chosen.length, 4);
  for (const { scenario, name } of chosen) {
    const { robot } = report.data.scenarios.find((s) => s.scenario === scenario);
    const distance = await largestFootDistance(report.data.robots[robot], readTrace(join(folder, name)));
    assert.ok(distance < 2e-5, `${name}: ${distance} m`);
  }
});

test("without a robot the replay is a sentence and the plots are there", async () => {
  const page = await open(undefined, spoil(report.file, "robotless", (text) => withData(text, (data) => data.scenarios.forEach((s) => (s.robot = null)))));
  await choose(page, "case1/tip_lateral");
  await page.locator("#replay").scrollIntoViewIfNeeded();
  await page.locator(".replay-none", { hasText: "The robot of this scenario could not be read." }).waitFor();
  await assertHasData(page, "com_error");
  await openTab(page, "balance");
  assert.equal(await (await drawn(page, "support")).getAttribute("data-state"), "missing");
});

test("blocks of another seed are not drawn, and the replay says so", async () => {
  const otherSeed = (data) => data.scenarios.forEach((scenario) => (scenario.seed = 99));
  for (const [file, notes] of [[report.file, 0], [spoil(report.file, "ground", (text) => withData(text, otherSeed)), 1]]) {
    const page = await open(undefined, file);
    await choose(page, "case6");
    const replay = new ReplayPart(page);
    await replay.ready();
    await replay.seek(1);
    await shot(page, `blocks-${notes}`);
    assert.equal(await replay.root.getByText("The blocks of seed 99 are not those of this run: not drawn.").count(), notes);
  }
});

test("without WebGL the replay is a sentence and the plots are there", async () => {
  const blind = await Browser.start(report.chromium, false);
  try {
    const page = await blind.open(report.file);
    await page.locator("#app[data-ready]").waitFor();
    await choose(page, "case1/tip_lateral");
    await page.locator("#replay").scrollIntoViewIfNeeded();
    await page.locator(".replay-none").waitFor();
    await assertHasData(page, "com_error");
    assert.deepEqual(blind.faults, []);
  } finally {
    await blind.close();
  }
});
