// The tests of the tests: pages that are spoilt on purpose.
import assert from "node:assert/strict";
import { test } from "node:test";
import { spoil } from "./batch.mjs";
import { assertHasData } from "./looks.mjs";
import { choose, open, report } from "./suite.mjs";

test("these tests notice empty time series", async () => {
  const empty = spoil(report.file, "empty", (text) => text.replace(/(<script type="text\/plain" id="trace-\d+">)[^<]*/g, "$1"));
  const page = await open(undefined, empty);
  report.faultsExpected = true;
  await choose(page, "case1/tip_lateral");
  await assert.rejects(assertHasData(page, "com_error"), assert.AssertionError);
});

test("these tests notice console errors, exceptions and requests", async () => {
  const bad = 'console.error("spoilt"); fetch("https://example.org/x").catch(() => {}); setTimeout(() => { throw new Error("spoilt"); });';
  const page = await open(undefined, spoil(report.file, "loud", (text) => text.replace("</body>", `<script>${bad}</script></body>`)));
  report.faultsExpected = true;
  await page.waitForTimeout(300);
  for (const kind of [/^console error: spoilt/, /^request: https:\/\/example\.org/, /^exception: .*spoilt/]) {
    assert.ok(report.browser.faults.some((fault) => kind.test(fault)), `${kind} in ${JSON.stringify(report.browser.faults)}`);
  }
});
