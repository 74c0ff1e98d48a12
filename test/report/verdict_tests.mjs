// The verdict: cells, sorting, filters.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertRounded } from "./looks.mjs";
import { open, report, shot } from "./suite.mjs";

test("the verdict has a cell for every scenario and observer, with the runs that survived and the errors", async () => {
  const page = await open();
  for (const { scenario, observer_id } of report.data.rows) {
    if (observer_id.endsWith("@paper")) continue; // the tuned ones are shown first
    const row = page.getByTestId("verdict-table").locator(`tr[data-scenario="${scenario}"]`);
    const cell = row.locator(`[data-observer="${observer_id}"]`);
    const rows = report.data.rows.filter((r) => r.scenario === scenario && r.observer_id === observer_id);
    const runs = rows.reduce((sum, r) => sum + r.runs, 0);
    const falls = rows.reduce((sum, r) => sum + r.falls, 0);
    const errors = rows.reduce((sum, r) => sum + r.errors, 0);
    const what = `${observer_id} in ${scenario}`;
    assert.equal((await cell.locator(".count").innerText()).trim(), `${runs - falls}/${runs + errors}`, what);
    const stood = rows.filter((r) => r.runs > r.falls);
    const figures = (await cell.locator(".errors").innerText()).trim().split(" / ");
    if (stood.length === 0) assert.deepEqual(figures, ["\u2013"], what);
    else ["com_error_max_m", "foot_error_max_m"].forEach((field, i) => assertFigure(figures[i], stood, field, what));
  }
  await shot(page, "light");
  await shot(page, "light-whole", true);
});

// In mm, the worst of the rows that have the metric; a dash if none has.
function assertFigure(text, rows, field, what) {
  const values = rows.map((row) => row[field]).filter((value) => value !== null);
  if (values.length === 0) assert.equal(text, "\u2013", `${field}, ${what}`);
  else assertRounded(Number(text), 1e3 * Math.max(...values), `${field}, ${what}`);
}

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
    const rows = report.data.rows.filter((r) => r.scenario === name && r.observer_id === "none");
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
    const expected = report.data.observers.filter((o) => o.profile === profile || o.profile === "-").map((o) => o.id);
    assert.deepEqual((await shown()).sort(), expected.sort());
  }
  await press("");
  assert.equal((await shown()).length, report.data.observers.length);
});

test("a cell of the verdict opens its scenario", async () => {
  const page = await open();
  await page.getByTestId("verdict-table").locator('tr[data-scenario="case6"] [data-test="verdict-cell"]').first().click();
  assert.equal(await page.getByTestId("scenario-select").inputValue(), "case6");
});
