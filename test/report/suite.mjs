// What all tests share: the page, what it holds, the browser. A test opens the page afresh, so none depends on another.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, afterEach, before } from "node:test";
import { dataOf, makePage } from "./batch.mjs";
import { Browser } from "./browser.mjs";

const { DOB_CHROMIUM, DOB_PROGRAM, DOB_WORK, DOB_SHOTS } = process.env;

export const report = {
  chromium: DOB_CHROMIUM,
  work: DOB_WORK,
  shots: DOB_SHOTS,
  file: "", // the page
  data: null, // what it holds
  browser: null,
  faultsExpected: false, // a test of the tests sets this
};

before(async () => {
  report.file = makePage(DOB_PROGRAM, DOB_WORK);
  report.data = dataOf(report.file);
  report.browser = await Browser.start(DOB_CHROMIUM);
});
after(() => report.browser?.close());
afterEach(() => {
  const faults = report.faultsExpected ? [] : (report.browser?.faults ?? []);
  report.faultsExpected = false;
  assert.deepEqual(faults, [], "console errors, exceptions and requests of the page");
});

export async function open(size, file = report.file) {
  const page = await report.browser.open(file, size);
  await page.locator("#app[data-ready]").waitFor();
  return page;
}

/** Shows a scenario, "case1/tip_lateral". */
export async function choose(page, scenario) {
  await page.getByTestId("scenario-select").selectOption(scenario);
}

export async function shot(page, name, whole = false) {
  await page.screenshot({ path: join(report.shots, `${name}.png`), fullPage: whole });
}

/** The tabs of a scenario and their plots that are to have data in the batch. */
export const kTabs = {
  tracking: ["com_error", "path_error", "orientation"],
  estimates: ["force", "joint_torque", "com_wrench"],
  feet: ["foot_error", "grf"],
  balance: ["support", "zmp_margin", "zmp_time"],
  timing: ["tick", "qp"],
};

export async function openTab(page, id) {
  await page.getByTestId(`tab-${id}`).click();
}
