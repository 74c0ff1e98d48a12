// The page as a whole: themes, keyboard, narrow windows.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertNoOverflow, drawn, tabTo } from "./looks.mjs";
import { ReplayPart } from "./replay.mjs";
import { choose, kTabs, open, openTab, shot } from "./suite.mjs";

test("light and dark", async () => {
  const page = await open();
  const theme = () => page.evaluate(() => [document.documentElement.dataset.theme, getComputedStyle(document.body).backgroundColor]);
  const light = await theme();
  await page.getByTestId("theme-toggle").click();
  const dark = await theme();
  assert.deepEqual([light[0], dark[0]], ["light", "dark"]);
  assert.notEqual(light[1], dark[1]);
  await shot(page, "dark");
  await choose(page, "case1/tip_lateral");
  const replay = new ReplayPart(page);
  await replay.ready();
  await replay.seek(3);
  await shot(page, "dark-replay");
  await page.getByTestId("theme-toggle").click();
  assert.deepEqual(await theme(), light);
});

test("the keyboard reaches and works the controls", async () => {
  const page = await open();
  const toggle = page.getByTestId("theme-toggle");
  await tabTo(page, toggle);
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  const sort = page.getByTestId("verdict-table").locator('[data-test="sort"]').first();
  await tabTo(page, sort);
  await page.keyboard.press("Space");
  assert.equal(await page.getByTestId("verdict-table").locator('th[aria-sort="ascending"]').count(), 1);
  await page.getByTestId("tab-tracking").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.getByTestId("tab-estimates").getAttribute("aria-selected"), "true");
  const replay = new ReplayPart(page);
  await replay.ready();
  await page.getByTestId("scenario-select").focus();
  await tabTo(page, replay.play);
  await page.keyboard.press("Enter");
  await replay.pause.waitFor();
  await page.keyboard.press("Space");
  await replay.play.waitFor();
});

test("in a narrow window nothing is cut off", async () => {
  const page = await open({ width: 360, height: 740 });
  await assertNoOverflow(page);
  await shot(page, "narrow");
  for (const tab of Object.keys(kTabs)) {
    await openTab(page, tab);
    await drawn(page, kTabs[tab][0]);
    await assertNoOverflow(page);
  }
  const replay = new ReplayPart(page);
  await replay.ready();
  await assertNoOverflow(page);
  await shot(page, "narrow-replay");
  await shot(page, "narrow-whole", true);
});
