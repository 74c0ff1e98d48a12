// The replay: time, controls, two runs, pictures.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { assertHasData, difference, drawn } from "./looks.mjs";
import { ReplayPart } from "./replay.mjs";
import { choose, open, openTab, report, shot } from "./suite.mjs";

test("scrubbing the replay moves the robot and the plots' cursor", async () => {
  const page = await open({ width: 1400, height: 900 });
  await choose(page, "case1/tip_lateral");
  const replay = new ReplayPart(page);
  await replay.ready();
  await replay.seek(0.4);
  const [before, from] = [await replay.shot(), await replay.trunk()];
  const cursor = () => page.locator('figure[data-plot="com_error"] .cursor').first().evaluate((c) => c.getBoundingClientRect().x);
  await drawn(page, "com_error");
  const left = await cursor();
  await replay.ready();
  await replay.seek(3.6);
  const [later, to] = [await replay.shot(), await replay.trunk()];
  assert.ok(to[0] - from[0] > 0.1, `the trunk goes from ${from} to ${to}`);
  const moved = await difference(page, before, later);
  assert.ok(moved > 0.01, `${(100 * moved).toFixed(2)} % of the picture changed`);
  await drawn(page, "com_error");
  assert.ok((await cursor()) > left + 20, "the plot's cursor moves to the right");
  assert.match(await page.getByTestId("time-readout").textContent(), /^3\.6/);
  await page.getByTestId("time-cursor").fill("1.2");
  await replay.waitFor(1.2);
});

test("the replay plays, pauses and steps", async () => {
  const page = await open({ width: 1400, height: 900 });
  await choose(page, "case1/tip_lateral");
  const replay = new ReplayPart(page);
  await replay.ready();
  await replay.root.getByLabel("Speed").selectOption("0.5");
  await replay.play.click();
  await page.waitForFunction((v) => Number(v.textContent.match(/^t = ([\d.]+)/)?.[1]) > 0.3, await replay.values.elementHandle());
  await replay.pause.click();
  const stopped = await replay.now();
  await page.waitForTimeout(400);
  assert.equal(await replay.now(), stopped);
  await replay.canvas.focus();
  await replay.seek(1);
  await replay.canvas.focus();
  await page.keyboard.press("ArrowRight");
  await replay.waitFor(1.04);
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  await replay.waitFor(0.96);
  await page.keyboard.press("End");
  await page.keyboard.press("Space"); // from the beginning again
  await replay.pause.waitFor();
  await page.keyboard.press("Space");
  assert.ok((await replay.now()) < 3.5);
});

test("cameras and overlays change the picture", async () => {
  const page = await open({ width: 1400, height: 900 });
  await choose(page, "case1/tip_lateral");
  const replay = new ReplayPart(page);
  await replay.ready();
  await replay.seek(1.6);
  let before = await replay.shot();
  for (const camera of ["top", "side", "front", "orbit"]) {
    await replay.root.getByLabel("Camera").selectOption(camera);
    await page.waitForTimeout(200);
    const now = await replay.shot();
    assert.ok((await difference(page, before, now)) > 0.02, camera);
    before = now;
  }
  await replay.root.getByLabel("Ground reaction forces").uncheck();
  await page.waitForTimeout(200);
  assert.ok((await difference(page, before, await replay.shot())) > 0.0005, "forces");
});

test("two runs stand side by side or as a ghost; the one that fell stays where it fell and says so", async () => {
  const page = await open({ width: 1400, height: 900 });
  const fallen = report.data.cells.find((c) => c.outcome === "fell" && c.trace !== null && c.scenario_id === "case5/plus_30");
  const standing = report.data.cells.find((c) => c.outcome === "survived" && c.trace !== null && c.scenario_id === "case5/plus_30");
  assert.ok(fallen && standing, "case 5 has a run that falls and one that does not");
  await choose(page, "case5/plus_30");
  await page.getByTestId("profile-filter").locator('[data-value=""]').click();
  for (const id of [fallen.observer_id, standing.observer_id]) {
    const chip = page.getByTestId("observers").locator(`[data-observer="${id}"]`);
    if ((await chip.getAttribute("aria-pressed")) === "false") await chip.click();
  }
  const replay = new ReplayPart(page);
  await replay.ready();
  await page.getByTestId("replay-first").selectOption(standing.observer_id);
  await page.getByTestId("replay-second").selectOption(fallen.observer_id);
  await page.waitForFunction(() => document.querySelectorAll("#replay .replay-name").length === 2);
  await replay.seek(0.2);
  assert.equal(await replay.root.getByText(/fell at/).count(), 0, "not before it falls");
  await replay.seek(2);
  const where = await replay.trunk(1);
  const words = `fell at ${fallen.fall_time_s.toFixed(2)} s`;
  await replay.root.locator(".replay-fell", { hasText: words }).waitFor();
  assert.match(await replay.canvas.getAttribute("aria-label"), new RegExp(words));
  await replay.root.scrollIntoViewIfNeeded();
  await shot(page, "replay-fallen");
  await replay.seek(3);
  assert.deepEqual(await replay.trunk(1), where);
  const side = await replay.shot();
  await page.getByTestId("replay-mode").selectOption("ghost");
  await page.waitForTimeout(300);
  assert.ok((await difference(page, side, await replay.shot())) > 0.02);
  await shot(page, "replay-ghost");
});

test("the picture of the replay can be saved", async () => {
  const page = await open({ width: 1400, height: 900 });
  await choose(page, "case1_no_swing/tip_lateral");
  const replay = new ReplayPart(page);
  await replay.ready();
  await replay.seek(3);
  const path = join(report.shots, "replay-saved.png");
  const name = await replay.savePicture(path);
  const png = readFileSync(path);
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  assert.match(name, /case1_no_swing.*3\.00s\.png$/);
  assert.ok(png.readUInt32BE(16) > 300 && png.length > 20_000, "it is not empty");
  await shot(page, "replay");
});

test("without swing compensation the pushed foot lands beside its planned foothold, as in the paper's Fig. 4", async () => {
  const page = await open({ width: 1400, height: 900 });
  const replay = new ReplayPart(page);
  const [pictures, drifts] = [[], []];
  for (const scenario of ["case1/tip_lateral", "case1_no_swing/tip_lateral"]) {
    await choose(page, scenario);
    await replay.ready();
    await page.getByTestId("replay-first").selectOption("momentum@tuned");
    await page.waitForFunction((s) => document.querySelector("#replay canvas")?.ariaLabel.includes(`${s}: momentum@tuned`), scenario);
    await replay.root.getByLabel("Camera").selectOption("front");
    await replay.seek(1.28); // the force is near its first peak, the foot near the ground
    pictures.push(await replay.shot());
    await replay.savePicture(join(report.shots, `drift-${scenario.split("/")[0]}.png`));
    await openTab(page, "feet");
    drifts.push((await assertHasData(page, "foot_error")).find((line) => line.name === "momentum@tuned").high);
  }
  assert.ok(drifts[0] < 10 && drifts[1] > 25, `largest errors of LF: ${drifts} mm`);
  assert.ok((await difference(page, ...pictures)) > 0.002);
});
