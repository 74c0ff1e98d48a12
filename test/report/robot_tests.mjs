// The replay's robot, and a browser that cannot show it.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Browser } from "./browser.mjs";
import { readTrace } from "./dobtrace.mjs";
import { assertHasData } from "./looks.mjs";
import { largestFootDistance } from "./robot_model.mjs";
import { choose, report } from "./suite.mjs";

test("the replay's feet are where those of the simulation were", async () => {
  const folder = join(report.work, "run", "traces");
  const traces = readdirSync(folder).slice(0, 4);
  assert.ok(traces.length > 0);
  for (const name of traces) {
    const distance = await largestFootDistance(report.data.robot, readTrace(join(folder, name)));
    assert.ok(distance < 2e-5, `${name}: ${distance} m`);
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
