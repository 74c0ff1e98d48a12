// What the report page computes itself, against figures worked out by hand. npm test --prefix results/report
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";

const { build } = createRequire(new URL("../../../results/report/package.json", import.meta.url))("esbuild");

let loads = 0;

// A module of its own each time: nothing is left from an earlier page.
async function load(name) {
  const entry = fileURLToPath(new URL(`../../../results/report/src/${name}.ts`, import.meta.url));
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, write: false, format: "esm", logLevel: "warning" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}#${++loads}`);
}

function near(actual, expected, tolerance) {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected}`);
}

// A page with one trace: `values` are what is left after summing up the differences, replay first.
function pageWith(values, frames, signals, points, plots) {
  const differences = values.map((column) => column.map((q, i) => q - (i > 0 ? column[i - 1] : 0))).flat();
  const bytes = Buffer.alloc(2 * differences.length);
  differences.forEach((d, i) => bytes.writeUInt16LE(((d % 65536) + 65536) % 65536, 2 * i));
  const info = { scenario_id: "s", replay: { rate_Hz: 25, frames, signals }, plots: { buckets: points / 2, bucket_s: 0.4, points, signals: plots } };
  const texts = { "report-data": JSON.stringify({ schema: 3, traces: [info] }), "trace-0": deflateSync(bytes).toString("base64") };
  return { getElementById: (id) => (id in texts ? { textContent: texts[id] } : null) };
}

const kX = { name: "x", offset: 10, scale: 0.5 };

test("a trace is decoded: differences modulo 2^16, offset and scale, what does not apply", async () => {
  globalThis.document = pageWith([[-30000, 30000, -32768], [1, 2, 3, 4]], 3, [kX], 4, [{ name: "y", offset: 0, scale: 1 }]);
  const { loadTrace } = await load("data");
  const trace = await loadTrace(0);
  assert.deepEqual([...trace.replay("x")], [-14990, 15010, NaN]);
  assert.deepEqual([...trace.plot("y")], [1, 2, 3, 4]);
  [0.1, 0.3, 0.5, 0.7].forEach((t, i) => near(trace.plotTimes[i], t, 1e-6));
  assert.equal(trace.replay("y"), null);
  await assert.rejects(loadTrace(1), /no trace 1/);
});

test("a trace of the wrong length is refused", async () => {
  globalThis.document = pageWith([[1, 2]], 3, [kX], 0, []);
  const { loadTrace } = await load("data");
  await assert.rejects(loadTrace(0), /4 bytes instead of 6/);
});

test("data of another schema, and a page without any, are refused in words", async () => {
  const { readReport } = await load("data");
  assert.throws(() => readReport({ getElementById: () => ({ textContent: '{"schema": 9}' }) }), /schema 9/);
  assert.throws(() => readReport({ getElementById: () => null }), /dobbench report DIR/);
});

test("the median of an even number lies between the middle two", async () => {
  const { median } = await load("interval");
  assert.equal(median([9, 1, 4, 2]), 3);
  assert.equal(median([5]), 5);
  assert.ok(Number.isNaN(median([])));
});

function row(observer_id, scenario, variant, seeds, falls, com, more = {}) {
  const common = { observer_id, scenario, variant, scenario_id: `${scenario}/${variant}`, setting: 0, oracle: false, seeds, runs: seeds, falls, errors: 0, com_error_max_m: com, foot_error_max_m: null, fall_time_median_s: null };
  return { ...common, ...more };
}

test("a cell shows the worst variant in which a run survived", async () => {
  const { summarise } = await load("summary");
  const rows = [row("a", "s", "mild", 3, 0, 0.01), row("a", "s", "hard", 3, 1, 0.03), row("a", "s", "deadly", 3, 3, 0.9)];
  const cell = summarise(rows);
  assert.equal(cell.com.variant, "hard");
  assert.deepEqual([cell.runs, cell.falls, cell.state], [9, 4, "some"]);
  assert.equal(cell.foot, null);
});

test("a cell tells apart survived, fell, could not be run, not run yet", async () => {
  const { summarise } = await load("summary");
  const state = (falls, more) => summarise([row("a", "s", "", 2, falls, 0.1, more)]).state;
  assert.equal(state(0), "survived");
  assert.equal(state(2), "fell");
  assert.equal(state(0, { errors: 1, runs: 1 }), "error");
  assert.equal(state(0, { runs: 0 }), "pending");
  assert.equal(summarise([]).state, "empty");
});

test("scenarios with observers of their own do not count, unless there are no others", async () => {
  const { comparable } = await load("summary");
  const shared = ["s", "t"].flatMap((scenario) => [row("a", scenario, "", 1, 0, 1), row("b", scenario, "", 1, 0, 1)]);
  const own = [row("a", "u", "", 1, 0, 1), row("c", "u", "", 1, 0, 1)];
  assert.deepEqual(comparable([...shared, ...own]), shared);
  assert.deepEqual(comparable(own), own);
});

test("the sentence names the best ranked of those that never fell, never an oracle", async () => {
  const { linesOf, verdictSentence } = await load("summary");
  const observers = ["a", "b", "c", "o"].map((id) => ({ id, observer: id, profile: "-", oracle: id === "o" }));
  const sentence = (rows) => verdictSentence(linesOf({ observers }, rows), 1);
  const [a, b, o] = [row("a", "s", "", 4, 1, 1), row("b", "s", "", 4, 0, 3), row("o", "s", "", 4, 0, 1, { oracle: true })];
  assert.match(sentence([a, b, o]), /^Of 2 observers in 1 scenario only b never fell: 4 of 4 runs survived, mean rank 1\.0\.$/);
  assert.match(sentence([a, b, row("c", "s", "", 4, 0, 2), o]), /2 never fell; c is the best ranked of them: .* mean rank 1\.0/);
  assert.match(sentence([a, o]), /none survived everything; a lost least: 3 of 4/);
  assert.match(sentence([row("a", "s", "", 4, 0, null, { runs: 0 })]), /No run .* finished/);
});

test("the sentence counts errors as lost, and names them and what has not been run yet", async () => {
  const { linesOf, verdictSentence } = await load("summary");
  const observers = ["a", "b"].map((id) => ({ id, observer: id, profile: "-", oracle: false }));
  const rows = [row("a", "s", "", 5, 0, 1, { runs: 3, errors: 1 }), row("b", "s", "", 5, 2, 1, { runs: 3, errors: 1 })];
  const sentence = verdictSentence(linesOf({ observers }, rows), 1);
  assert.match(sentence, /none survived everything; a lost least: 3 of 4 runs survived.* Of the runs shown: 2 could not be run, 2 not run yet\.$/);
});

test("ranks are among the rows that are shown, by lost runs, then CoM error, then the later fall", async () => {
  const { rankAmong } = await load("summary");
  const rows = [
    row("lost later", "s", "", 2, 2, 0.01, { fall_time_median_s: 9 }),
    row("lost sooner", "s", "", 2, 2, 0.001, { fall_time_median_s: 3 }),
    row("half", "s", "", 2, 1, 0.001),
    row("far", "s", "", 2, 0, 0.9, { rank: 7 }),
    row("near", "s", "", 2, 0, 0.1, { rank: 5 }),
    row("as near", "s", "", 2, 0, 0.1),
    row("oracle", "s", "", 2, 0, 0, { oracle: true }),
    row("not run", "s", "", 2, 0, null, { runs: 0 }),
    row("elsewhere", "t", "", 2, 0, 0.0001),
    row("otherwise", "s", "", 2, 0, 0.0001, { setting: 1 }),
  ];
  assert.deepEqual(rows.map((r) => rankAmong(r, rows)), [5, 6, 4, 3, 1, 1, null, null, 1, 1]);
  const shown = rows.filter((r) => !r.observer_id.endsWith("near"));
  assert.equal(rankAmong(rows[3], shown), 1);
});

// As many as `dobbench list observers` names.
const kObservers =
  "none momentum com_wrench momentum_com nonlinear_dob momentum_exact kalman eso sliding_mode direct contact_consistent com_momentum_exact com_kalman com_eso com_sliding_mode oracle_legs oracle_full";

test("no two observers share colour and dash, nor two profiles of one", async () => {
  const { observerStyles } = await load("colors");
  const distinct = (observers, theme) => {
    const looks = [...observerStyles(observers, theme).values()].map((style) => `${style.color} ${style.dash}`);
    assert.equal(new Set(looks).size, observers.length, looks.sort().join("\n"));
  };
  const names = kObservers.split(" ");
  assert.equal(names.length, 17);
  const named = (observer, profile) => ({ id: `${observer}@${profile}`, observer, profile, oracle: observer.startsWith("oracle") });
  for (const theme of ["light", "dark"]) {
    distinct(names.map((name) => named(name, "-")), theme);
    const profiles = (name) => (name === "none" || name.startsWith("oracle") ? ["-"] : ["paper", "tuned"]);
    distinct(names.flatMap((name) => profiles(name).map((profile) => named(name, profile))), theme);
    distinct(Array.from({ length: 24 }, (_, i) => named(`momentum:order=${i}`, "tuned")), theme);
  }
});

test("falls have an interval in one variant, and none over several", async () => {
  const { drawFalls } = await load("plots/seeds");
  const observers = [{ id: "a", observer: "a", profile: "-", oracle: false }];
  const drawn = (rows) => drawFalls({ report: { observers }, observers, cells: [], rows, metric: {}, name: "s" }, "light", 800);
  const [one, other] = ["x", "y"].map((variant) => row("a", "s", variant, 10, 5, 1, { falls_ci95: [0.2366, 0.7634] }));
  const single = drawn([one]);
  near(single.data[0].error_x.array[0], 26.34, 1e-9);
  assert.match(single.summary, /5 of 10 fell \(24 % to 76 %\)/);
  assert.doesNotMatch(single.note, /No interval/);
  const pooled = drawn([one, other]);
  assert.equal(pooled.data[0].error_x.visible, false);
  assert.match(pooled.summary, /10 of 20 fell\. No interval/);
  assert.match(pooled.note, /No interval .* no independent draws/);
});

test("blocks are drawn for the seed and the overrides that they are of", async () => {
  const { blocksOf, scenarioFacts } = await load("terrain");
  const box = { center: [0, 0, 0], size: [1, 1, 1], yaw: 0, friction: 0.5 };
  const scenario = { id: "s", seed: 1, setting: 0, duration_s: 4, metric_leg: "LF", boxes: [box], friction: 0.8, robot: 0 };
  const settings = ["", "", "duration_s=2"].map((overrides, id) => ({ id, gains: `g${id}`, planner: "zmp", overrides }));
  const of = (seed, setting, more = {}) => {
    const report = { settings, robots: [{ name: "r", mass_kg: 12.776 }], scenarios: [{ ...scenario, ...more }] };
    const { boxes, note } = blocksOf(report, { scenario_id: "s", seed, setting });
    return [boxes.length, note, scenarioFacts(report, report.scenarios[0], { seed, setting }).join(", ")];
  };
  assert.deepEqual(of(1, 0), [1, "", "r, 12.8 kg, 4.00 s, leg LF, friction 0.8, 1 block, seed 1"]);
  assert.deepEqual(of(1, 1).slice(0, 2), [1, ""]); // other gains, the same ground
  assert.deepEqual(of(2, 0).slice(0, 2), [0, "The blocks of seed 1 are not those of this run: not drawn."]);
  assert.deepEqual(of(2, 0, { boxes: [] }).slice(0, 2), [0, ""]);
  const [boxes, note, facts] = of(1, 2);
  assert.equal(boxes, 0);
  assert.match(note, /overrides.*not drawn/);
  assert.doesNotMatch(facts, /4\.00 s|friction|block/);
  assert.equal(of(1, 2, { setting: undefined })[0], 1); // a page that does not say
  assert.match(of(1, 0, { robot: null })[2], /^4\.00 s/);
});

test("of a scenario that could not be read the page says so, and nothing of its ground", async () => {
  const { blocksOf, scenarioFacts } = await load("terrain");
  const scenario = { id: "s", seed: 1, setting: 0, duration_s: null, metric_leg: "all", boxes: [], friction: null, robot: null };
  const report = { settings: [{ id: 0, overrides: "" }], robots: [], scenarios: [scenario] };
  assert.match(blocksOf(report, { scenario_id: "s", seed: 1, setting: 0 }).note, /could not be read/);
  const facts = scenarioFacts(report, scenario, { seed: 1, setting: 0 }).join(", ");
  assert.match(facts, /could not be read/);
  assert.doesNotMatch(facts, /null|level ground/);
});

test("the page begins with the setting and the seed of the first time series, and keeps to what a setting has", async () => {
  const { makeSelection, variantToShow } = await load("selection");
  const trace = (scenario_id, setting, seed) => ({ scenario_id, setting, seed, observer_id: "a" });
  const report = {
    settings: [{ id: 0 }, { id: 1 }], run: { seeds: [1] }, observers: [{ id: "a", observer: "a", profile: "-", oracle: false }],
    scenarios: ["x", "y"].map((variant) => ({ id: `s/${variant}`, scenario: "s", variant })),
    traces: [trace("s/x", 1, 4), trace("s/y", 0, 5), trace("s/x", 0, 6)],
  };
  const selection = makeSelection(report);
  assert.deepEqual([selection.setting.get(), selection.seed.get(), selection.scenario.get()], [1, 4, "s/x"]);
  selection.setting.set(0);
  assert.equal(selection.seed.get(), 6);
  assert.equal(variantToShow(report, 1, "s", "s/y", "a"), "s/x");
  assert.equal(variantToShow(report, 0, "s", "s/y", "a"), "s/y");
});

test("a scenario of other settings is shown with those, and a setting without the scenario with its first one", async () => {
  const { makeSelection, selectScenario } = await load("selection");
  const trace = (scenario_id, setting, seed) => ({ scenario_id, setting, seed, observer_id: "a" });
  const report = {
    settings: [{ id: 0 }, { id: 1 }], run: { seeds: [1] }, observers: [{ id: "a", observer: "a", profile: "-", oracle: false }],
    scenarios: ["ours", "theirs", "untold"].map((id) => ({ id, scenario: id, variant: "" })),
    traces: [trace("ours", 0, 1), trace("theirs", 1, 3)],
  };
  const selection = makeSelection(report);
  const state = () => [selection.scenario.get(), selection.setting.get(), selection.seed.get()];
  assert.deepEqual(state(), ["ours", 0, 1]);
  selectScenario(report, selection, "theirs");
  assert.deepEqual(state(), ["theirs", 1, 3]);
  selection.setting.set(0);
  assert.deepEqual(state(), ["ours", 0, 1]);
  selectScenario(report, selection, "untold");
  assert.deepEqual(state(), ["untold", 0, 1]);
});

test("a scenario whose observers were run in another profile only has them shown", async () => {
  const { makeSelection, selectScenario, shownTraces } = await load("selection");
  const observer = (name, profile) => ({ id: `${name}@${profile}`, observer: name, profile, oracle: false });
  const trace = (scenario_id, observer_id) => ({ scenario_id, observer_id, setting: 0, seed: 1 });
  const report = {
    settings: [{ id: 0 }], run: { seeds: [1] }, scenarios: [{ id: "s" }, { id: "study" }],
    observers: [observer("a", "tuned"), observer("a", "paper"), observer("b", "paper")], rows: [],
    traces: [trace("s", "a@tuned"), trace("s", "a@paper"), trace("study", "b@paper")],
  };
  const selection = makeSelection(report);
  assert.deepEqual([...selection.shown.get()], ["a@tuned"]);
  selectScenario(report, selection, "study");
  assert.deepEqual(shownTraces(report, selection).map((t) => t.info.observer_id), ["b@paper"]);
  assert.equal(selection.focus.get(), "b@paper");
  selectScenario(report, selection, "s");
  assert.deepEqual(shownTraces(report, selection).map((t) => t.info.observer_id), ["a@tuned"]);
});

test("the replay tells the plots' value at its time", async () => {
  const { Recording } = await load("replay/recording");
  const info = { plots: { bucket_s: 0.4 } };
  const recording = new Recording({ info, replay: () => null, plot: (name) => (name === "x" ? [1, 2, 3, 4] : null) }, { rate_Hz: 25, frames: 21 });
  for (const [t, expected] of [[0, 1], [0.16, 1], [0.24, 2], [0.5, 3], [0.8, 4]]) {
    recording.seek(t);
    assert.equal(recording.plotted("x"), expected, `at ${t} s`);
  }
  assert.ok(Number.isNaN(recording.plotted("y")));
});

test("what has no value is last in both orders", async () => {
  const { sorted } = await load("sortable");
  const columns = [{ id: "x", heading: "", key: (v) => v }];
  assert.deepEqual(sorted([2, null, 1], columns, { column: "x", descending: false }), [1, 2, null]);
  assert.deepEqual(sorted([2, null, 1], columns, { column: "x", descending: true }), [2, 1, null]);
  assert.deepEqual(sorted(["case10", "case9"], columns, { column: "x", descending: false }), ["case9", "case10"]);
});

test("numbers have three significant digits", async () => {
  const { significant, millimetres } = await load("format");
  assert.deepEqual([30.44, 158.2, 6.378, 0.01234, 16181, 0].map((v) => significant(v)), ["30.4", "158", "6.38", "0.0123", "16181", "0"]);
  assert.deepEqual([millimetres(0.0304), millimetres(null)], ["30.4", "\u2013"]);
});

test("the support polygon is the hull of the feet", async () => {
  const { convexHull } = await load("hull");
  const [a, b, inside, c, d] = [[0, 0], [2, 0], [1, 1], [2, 2], [0, 2]].map(([x, y]) => ({ x, y }));
  assert.deepEqual(convexHull([a, b, inside, c, d]), [a, b, c, d]);
  assert.equal(convexHull([a, inside]).length, 2);
});

test("a scenario is shown with the robot that walked it", async () => {
  const { robotOf } = await load("kinematics");
  const scenarios = [0, 1, null].map((robot, i) => ({ id: `s${i}`, robot }));
  const report = { robots: [{ name: "first" }, { name: "second" }], scenarios };
  assert.deepEqual(["s0", "s1"].map((id) => robotOf(report, id).name), ["first", "second"]);
  assert.deepEqual(["s2", "unknown"].map((id) => robotOf(report, id)), [null, null]);
});

test("a foot is where trunk and joints put it", async () => {
  const { footPositions } = await load("kinematics");
  const turn = Math.SQRT1_2; // trunk turned by 90 degrees about z, knee bent by 90 degrees about y
  const values = { "trunk/x_m": 1, "trunk/y_m": 2, "trunk/z_m": 3, "trunk/qw": turn, "trunk/qx": 0, "trunk/qy": 0, "trunk/qz": turn, "LF/hip/angle_rad": 0, "LF/lower/angle_rad": Math.PI / 2 };
  const trace = { replay: (name) => (name in values ? [values[name]] : null) };
  const links = [
    { parent: -1, joint: -1, origin: [0, 0, 0], axis: [1, 0, 0] },
    { parent: 0, joint: 0, origin: [0.5, 0, 0], axis: [1, 0, 0] },
    { parent: 1, joint: 2, origin: [0, 0, -0.3], axis: [0, 1, 0] },
  ];
  const robot = { links, feet: [{ leg: "LF", link: 2, center: [0, 0, -0.2], radius: 0.02 }] };
  const [foot] = footPositions(robot, trace, 0);
  [1, 2.5 - 0.2, 2.7].forEach((v, i) => near(foot[i], v, 1e-12));
  delete values["LF/lower/angle_rad"];
  assert.equal(footPositions(robot, trace, 0), null);
  assert.equal(footPositions(null, trace, 0), null);
});

const kAmplitude = { name: "amplitude", unit: "N", levels: [10, 20, 40, 80], logarithmic: true };
const kFriction = { name: "friction", unit: "", levels: [0.8, 0.5, 0.3], logarithmic: false };

function threshold(estimate, low, high, below = false, above = false) {
  return { estimate, ci95: [low, high], below, above };
}

function levelOf(i, trials, falls, com = null) {
  return { level: [i, 0], planned: trials, trials, falls, errors: 0, falls_ci95: trials < 8 ? null : [falls / trials - 0.1, falls / trials + 0.1], com_error_m: com, com_error_ci95: null };
}

function curveOf(observer_id, more = {}) {
  const curve = { scenario_id: "s", observer_id, setting: 0, axes: [0], factors: [], levels: [], fall_50: null, fall_5: null, non_monotone: [], trials: 0, falls: 0, errors: 0, ...more };
  return { ...curve, trials: curve.levels.reduce((n, l) => n + l.trials, 0), falls: curve.levels.reduce((n, l) => n + l.falls, 0) };
}

function campaignOf(curves, axes = [kAmplitude]) {
  const ids = [...new Set(curves.map((c) => c.observer_id))];
  const observers = ids.map((id) => ({ id, observer: id.split("@")[0], profile: id.split("@")[1] ?? "-", oracle: false }));
  return { axes, curves, observers, settings: ["", "a=1"].map((overrides, id) => ({ id, gains: "paper", planner: "zmp", overrides })) };
}

test("curves are compared over the same axes, and blocks are called by what tells them apart", async () => {
  const { blocksOf } = await load("campaign/blocks");
  const names = (curves) => blocksOf(campaignOf(curves, [kAmplitude, kFriction])).map((b) => `${b.name}: ${b.curves.map((c) => c.observer_id).join()}`);
  assert.deepEqual(names([curveOf("a"), curveOf("b")]), ["s: a,b"]);
  assert.deepEqual(names([curveOf("a"), curveOf("a", { axes: [1] }), curveOf("b")]), ["amplitude: a,b", "friction: a"]);
  assert.deepEqual(names([curveOf("a"), curveOf("a", { scenario_id: "t", setting: 1 })]), ["s; paper, zmp: a", "t; paper, zmp, a=1: a"]);
  assert.equal(blocksOf(campaignOf([curveOf("a")]))[0].whole, "s; paper, zmp; amplitude");
});

test("a threshold says what is beyond the levels, whichever way they run", async () => {
  const { thresholdText } = await load("campaign/blocks");
  assert.deepEqual(thresholdText(threshold(33.333, 25, 41.26), kAmplitude), ["33.3", "25.0 to 41.3"]);
  assert.deepEqual(thresholdText(threshold(12, 6, 20, true), kAmplitude), ["12.0", "< 10 to 20.0"]);
  assert.deepEqual(thresholdText(threshold(95, 60, 110, false, true), kAmplitude), ["> 80", "60.0 to > 80"]);
  assert.deepEqual(thresholdText(threshold(130, 95, 160, false, true), kAmplitude), ["> 80", ""]);
  assert.deepEqual(thresholdText(threshold(0.7, 0.6, 0.9, true), kFriction), ["0.700", "0.600 to > 0.8"], "more friction is milder");
  assert.deepEqual(thresholdText(threshold(0.2, 0.1, 0.4, false, true), kFriction), ["< 0.3", "< 0.3 to 0.400"]);
  assert.deepEqual(thresholdText(threshold(30, 5, 90, true, true), kAmplitude), ["30.0", "these trials do not tell"]);
  assert.deepEqual(thresholdText(null, kAmplitude), ["\u2013", ""]);
});

test("observers keep their colours on a campaign's page, unless its axis makes others of them", async () => {
  const { campaignStyles } = await load("campaign/blocks");
  const campaign = campaignOf([curveOf("kalman@tuned"), curveOf("eso@tuned")]);
  const color = (observers) => campaignStyles({ observers }, campaign, "light").get("eso@tuned").color;
  const both = campaign.observers;
  assert.equal(color([...both].reverse()), campaignStyles({ observers: [both[1]] }, campaignOf([curveOf("eso@tuned")]), "light").get("eso@tuned").color);
  const others = Array.from({ length: 7 }, (_, i) => ({ id: `kalman:rate=${i}@tuned`, observer: `kalman:rate=${i}`, profile: "tuned", oracle: false }));
  assert.equal(color(others), color(both));
});

async function drawnShares(curve, axis = kAmplitude) {
  const { drawFallShares } = await load("plots/fall_curves");
  const { blocksOf } = await load("campaign/blocks");
  const campaign = campaignOf([curve], [axis]);
  return drawFallShares({ report: { observers: campaign.observers }, campaign, block: blocksOf(campaign)[0] }, "light", 800);
}

test("a curve's points are where trials were run, with an interval from eight trials on", async () => {
  const drawn = await drawnShares(curveOf("a", { levels: [levelOf(0, 10, 0), levelOf(1, 4, 1), levelOf(2, 0, 0), levelOf(3, 10, 5)] }));
  const [curve] = drawn.data;
  [10, 20, 80].forEach((x, i) => near(curve.x[i], x, 1e-9));
  assert.deepEqual(curve.y, [0, 25, 50]);
  near(curve.error_y.array[2], 10, 1e-9);
  assert.equal(curve.error_y.array[1], null);
  assert.match(curve.text[1], /^amplitude 20 N<br>1 of 4 fell$/);
  assert.match(drawn.summary, /a: 6 of 24 fell/);
  assert.ok("missing" in (await drawnShares(curveOf("a"))));
});

test("thresholds are bars that end at the rim where they are open, with a mark that points on", async () => {
  const levels = [levelOf(0, 10, 5)];
  const bars = (drawn) => drawn.data.filter((t) => t.yaxis === "y2").map((t) => [t.mode, t.x, t.marker?.symbol]);
  const [bar, mark] = bars(await drawnShares(curveOf("a", { levels, fall_50: threshold(30, 20, 40) })));
  assert.deepEqual([bar[1], mark[1]], [[20, 40], [30]]);
  const [wide, , end] = bars(await drawnShares(curveOf("a", { levels, fall_50: threshold(70, 60, 100, false, true) })));
  assert.ok(wide[1][1] > 80 && wide[1][1] < 90);
  assert.deepEqual(end[2], ["triangle-right"]);
  const [, beyond, none] = bars(await drawnShares(curveOf("a", { levels, fall_5: threshold(3, 1, 5, true) })));
  assert.deepEqual([beyond[2], none], [["triangle-left"], undefined], "no mark at an estimate that is beyond");
  const descending = bars(await drawnShares(curveOf("a", { levels, fall_50: threshold(0.4, 0.2, 0.5, false, true) }), kFriction));
  assert.deepEqual(descending[2][2], ["triangle-right"], "harder is to the right");
});

test("shares of variance are bars, and only those with an interval have one", async () => {
  const { drawVariance } = await load("plots/variance");
  const shares = [{ factor: "gains", levels: 2, share: 0.6, ci95: [0.5, 0.65] }, { factor: "residual", levels: 0, share: 0.4, ci95: null }];
  const [bars] = drawVariance({ response: "falls", trials: 40, left_out: 0, shares }, "light", 800).data;
  assert.deepEqual(bars.x, [60, 40]);
  near(bars.error_x.arrayminus[0], 10, 1e-9);
  assert.equal(bars.error_x.array[1], null);
  assert.ok("missing" in drawVariance({ response: "falls", trials: 0, left_out: 0, shares: [] }, "light", 800));
});
