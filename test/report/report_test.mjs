// The report page of a real batch in a real browser. Started by report_in_a_browser.sh, which says what it needs.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { dataOf, makePage, spoil } from "./batch.mjs";
import { Browser } from "./browser.mjs";
import { assertHasData, assertNoOverflow, difference, drawn, plotted, tabTo } from "./looks.mjs";
import { readTrace } from "./dobtrace.mjs";
import { ReplayPart } from "./replay.mjs";
import { largestFootDistance } from "./robot_model.mjs";

const { DOB_CHROMIUM: chromium, DOB_PROGRAM: program, DOB_WORK: work, DOB_SHOTS: shots, DOB_REPORT_PAGE: given } = process.env;

let file; // the page
let data; // what it holds
let browser;
let faultsExpected = false;

before(async () => {
  file = given ?? makePage(program, work);
  data = dataOf(file);
  browser = await Browser.start(chromium);
});
after(() => browser?.close());
afterEach(() => {
  if (!faultsExpected) assert.deepEqual(browser.faults, [], "console errors, exceptions and requests of the page");
  faultsExpected = false;
});

async function open(size, page = file) {
  const opened = await browser.open(page, size);
  await opened.locator("#app[data-ready]").waitFor();
  return opened;
}

async function choose(page, scenario) {
  await page.getByTestId("scenario-select").selectOption(scenario);
}

async function shot(page, name, whole = false) {
  await page.screenshot({ path: join(shots, `${name}.png`), fullPage: whole });
}

const kTabs = {
  tracking: ["com_error", "path_error", "orientation"],
  estimates: ["force", "joint_torque", "com_wrench"],
  feet: ["foot_error", "grf"],
  balance: ["zmp_margin", "zmp_time"],
  timing: ["tick", "qp"],
};

async function openTab(page, id) {
  await page.getByTestId(`tab-${id}`).click();
}

test("the verdict has a cell for every scenario and observer, with the runs that survived", async () => {
  const page = await open();
  for (const { scenario, observer_id } of data.rows) {
    if (observer_id.endsWith("@paper")) continue; // the tuned ones are shown first
    const row = page.getByTestId("verdict-table").locator(`tr[data-scenario="${scenario}"]`);
    const cell = row.locator(`[data-observer="${observer_id}"]`);
    const rows = data.rows.filter((r) => r.scenario === scenario && r.observer_id === observer_id);
    const runs = rows.reduce((sum, r) => sum + r.runs, 0);
    const falls = rows.reduce((sum, r) => sum + r.falls, 0);
    assert.match(await cell.innerText(), new RegExp(`${runs - falls}/${runs}`), `${observer_id} in ${scenario}`);
  }
  await shot(page, "light");
  await shot(page, "light-whole", true);
});

test("the verdict sorts by name and by an observer's results, and says so", async () => {
  const page = await open();
  const table = page.getByTestId("verdict-table");
  const names = () => table.locator("tbody tr[data-scenario]").evaluateAll((rows) => rows.map((r) => r.dataset.scenario));
  const heading = table.locator('[data-test="sort"][data-column="scenario"]');
  await heading.click();
  const ascending = await names();
  assert.deepEqual(ascending, [...ascending].sort());
  assert.equal(await table.locator('th[aria-sort="ascending"]').count(), 1);
  await heading.click();
  assert.deepEqual(await names(), [...ascending].reverse());
  await table.locator('[data-test="sort"][data-column="none"]').click();
  const share = (name) => {
    const rows = data.rows.filter((r) => r.scenario === name && r.observer_id === "none");
    return rows.reduce((sum, r) => sum + r.falls, 0) / rows.reduce((sum, r) => sum + r.runs, 0);
  };
  const shares = (await names()).map(share);
  assert.deepEqual(shares, [...shares].sort((a, b) => a - b));
});

test("the profile filter shows the observers of that profile, and those that have none", async () => {
  const page = await open();
  const shown = () => page.getByTestId("verdict-cell").evaluateAll((cells) => [...new Set(cells.map((c) => c.dataset.observer))]);
  const press = (profile) => page.getByTestId("profile-filter").locator(`[data-value="${profile}"]`).click();
  for (const profile of ["paper", "tuned"]) {
    await press(profile);
    const expected = data.observers.filter((o) => o.profile === profile || o.profile === "-").map((o) => o.id);
    assert.deepEqual((await shown()).sort(), expected.sort());
  }
  await press("");
  assert.equal((await shown()).length, data.observers.length);
});

test("every plot of a scenario has lines with data", async () => {
  const page = await open();
  await choose(page, "case1/tip_lateral");
  const traces = data.traces.filter((t) => t.scenario_id === "case1/tip_lateral").length;
  assert.ok(traces >= 3, "the batch keeps time series");
  for (const [tab, plots] of Object.entries(kTabs)) {
    await openTab(page, tab);
    for (const plot of plots) {
      const histogram = tab === "timing";
      await assertHasData(page, plot, 1, histogram ? 2 : 20);
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

test("a cell of the verdict opens its scenario", async () => {
  const page = await open();
  await page.getByTestId("verdict-table").locator('tr[data-scenario="case6"] [data-test="verdict-cell"]').first().click();
  assert.equal(await page.getByTestId("scenario-select").inputValue(), "case6");
});

test("the replay's feet are where those of the simulation were", async () => {
  const folder = join(work, "run", "traces");
  const traces = readdirSync(folder).slice(0, 4);
  assert.ok(traces.length > 0);
  for (const name of traces) {
    const distance = await largestFootDistance(data.robot, readTrace(join(folder, name)));
    assert.ok(distance < 2e-5, `${name}: ${distance} m`);
  }
});

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
  const fallen = data.cells.find((c) => c.outcome === "fell" && c.trace !== null && c.scenario_id === "case5/plus_30");
  const standing = data.cells.find((c) => c.outcome === "survived" && c.trace !== null && c.scenario_id === "case5/plus_30");
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
  const path = join(shots, "replay-saved.png");
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
    await replay.savePicture(join(shots, `drift-${scenario.split("/")[0]}.png`));
    await openTab(page, "feet");
    drifts.push((await assertHasData(page, "foot_error")).find((line) => line.name === "momentum@tuned").high);
  }
  assert.ok(drifts[0] < 10 && drifts[1] > 25, `largest errors of LF: ${drifts} mm`);
  assert.ok((await difference(page, ...pictures)) > 0.002);
});

test("a plot can be saved as SVG", async () => {
  const page = await open();
  await choose(page, "case1/tip_lateral");
  await openTab(page, "tracking");
  const figure = await drawn(page, "com_error");
  const [download] = await Promise.all([page.waitForEvent("download"), figure.getByTestId("download-svg").click()]);
  const path = join(shots, "com_error.svg");
  await download.saveAs(path);
  const svg = readFileSync(path, "utf8");
  assert.match(svg, /^<svg[\s>]/);
  assert.ok((svg.match(/<path/g) ?? []).length > 5, "lines");
});

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

test("without WebGL the replay is a sentence and the plots are there", async () => {
  const blind = await Browser.start(chromium, false);
  try {
    const page = await blind.open(file);
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

test("these tests notice empty time series", async () => {
  const empty = spoil(file, "empty", (text) => text.replace(/(<script type="text\/plain" id="trace-\d+">)[^<]*/g, "$1"));
  const page = await open(undefined, empty);
  faultsExpected = true;
  await choose(page, "case1/tip_lateral");
  await assert.rejects(assertHasData(page, "com_error"), assert.AssertionError);
});

test("these tests notice console errors, exceptions and requests", async () => {
  const bad = 'console.error("spoilt"); fetch("https://example.org/x").catch(() => {}); setTimeout(() => { throw new Error("spoilt"); });';
  const page = await open(undefined, spoil(file, "loud", (text) => text.replace("</body>", `<script>${bad}</script></body>`)));
  faultsExpected = true;
  await page.waitForTimeout(300);
  for (const kind of [/^console error: spoilt/, /^request: https:\/\/example\.org/, /^exception: .*spoilt/]) {
    assert.ok(browser.faults.some((fault) => kind.test(fault)), `${kind} in ${JSON.stringify(browser.faults)}`);
  }
});
