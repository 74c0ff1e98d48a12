// Campaigns as `dobbench report` puts them into a page, made by hand: one of each kind, with everything that can be odd.

const kNames = ["none@-", "momentum@tuned", "com_wrench@tuned", "momentum_com@tuned", "kalman@tuned", "oracle_full@-"];

const kObservers = kNames.map((name) => {
  const [observer, profile] = name.split("@");
  return { id: profile === "-" ? observer : name, observer, profile, oracle: observer.startsWith("oracle") };
});

const round = (x) => Number(x.toPrecision(7));

// Wilson's interval, 95 %; null below eight trials.
export function wilson(k, n) {
  if (n < 8) return null;
  const z = 1.959963984540054;
  const [center, half] = [(k / n + (z * z) / (2 * n)) / (1 + (z * z) / n), (z / (1 + (z * z) / n)) * Math.sqrt((k / n) * (1 - k / n) / n + (z * z) / (4 * n * n))];
  return [k === 0 ? 0 : round(center - half), k === n ? 1 : round(center + half)];
}

/** A level with so many trials; the CoM error [m] is that of the survivors. */
export function levelOf(level, trials, falls, com, errors = 0) {
  const stood = trials - falls;
  return {
    level, planned: trials + errors, trials, falls, errors, falls_ci95: wilson(falls, trials),
    com_error_m: stood > 0 ? round(com) : null, com_error_ci95: stood >= 8 ? [round(0.85 * com), round(1.2 * com)] : null,
    foot_error_m: stood > 0 ? round(0.4 * com) : null, foot_error_ci95: null,
  };
}

export function curveOf(scenario_id, observer_id, axes, levels, more = {}) {
  const sum = (field) => levels.reduce((total, level) => total + level[field], 0);
  return {
    scenario_id, observer_id, setting: 0, axes, factors: [], levels, fall_50: null, fall_5: null, non_monotone: [],
    seeds: Math.max(0, ...levels.map((l) => l.trials)), trials: sum("trials"), falls: sum("falls"), errors: sum("errors"), ...more,
  };
}

function campaignOf(kind, axes, curves, more = {}) {
  const planned = curves.reduce((total, curve) => total + curve.levels.reduce((n, l) => n + l.planned, 0), 0);
  return {
    kind, name: `${kind}_of_a_push`, summary: "How hard a push on a leg may be, by observer", document: `kind = "${kind}"\nseeds = 20\n`, axes, factors: [],
    planned: planned + 40, finished: planned, observers: kObservers, settings: [{ id: 0, gains: "paper", planner: "spline", overrides: "" }], curves, factorial: [], reasons: [], ...more,
  };
}

const share = (x, middle, width) => 1 / (1 + Math.exp(-(x - middle) / width));

// Falls grow with the index of the level; `strength` of an observer shifts where.
function ladder(axis, strength, trials = 20) {
  const n = axis.levels.length;
  return axis.levels.map((_, i) => levelOf([i, 0], trials, Math.round(trials * share(i, strength * (n - 1), 0.6)), 0.006 * (1 + i * i) * (1.6 - strength), i === 2 ? 1 : 0));
}

const at = (axis, place) => (axis.logarithmic ? axis.levels[0] * (axis.levels.at(-1) / axis.levels[0]) ** place : axis.levels[0] + place * (axis.levels.at(-1) - axis.levels[0]));

function threshold(axis, place, width) {
  const ends = [at(axis, place - width), at(axis, place + width)].map(round).sort((a, b) => a - b);
  return { estimate: round(at(axis, place)), ci95: ends, below: place - width < 0, above: place + width > 1 };
}

const kStrengths = [0.25, 0.5, 0.42, 0.7, 0.6, 1.3];

function curves(scenario, axes, index, strengths = kStrengths) {
  const axis = axes[index];
  return kObservers.map((o, i) =>
    curveOf(scenario, o.id, [index], ladder(axis, strengths[i]), {
      fall_50: threshold(axis, strengths[i], 0.08), fall_5: threshold(axis, strengths[i] - 0.3, 0.12),
      non_monotone: i === 1 ? [{ seed: 7, fell_at: axis.levels[2], survived_at: axis.levels[4] }] : [],
    }),
  );
}

const kAmplitude = { name: "amplitude", unit: "N", levels: [10, 15, 22.5, 33.75, 50.625, 75.9375, 113.9063], logarithmic: true };
const kFriction = { name: "friction", unit: "", levels: [0.8, 0.7, 0.6, 0.5, 0.4, 0.3], logarithmic: false };
const kDelay = { name: "delay", unit: "ms", levels: [0, 2, 4, 6, 8, 10], logarithmic: false };
const kBandwidth = { name: "bandwidth", unit: "rad/s", levels: [160, 80, 40, 20, 10], logarithmic: true };

export function limit() {
  const axes = [kAmplitude];
  const scenarios = ["case1/tip_lateral", "case1/knee_lateral", "case5/plus_30"];
  const all = scenarios.flatMap((scenario, i) => curves(scenario, axes, 0, kStrengths.map((s) => s - 0.1 * i)));
  return campaignOf("limit", axes, all, { reasons: [{ reason: "observer kalman: estimate is not finite", cells: 14 }, { reason: "time limit", cells: 4 }] });
}

export function breakdown() {
  const axes = [kFriction, kDelay];
  return campaignOf("breakdown", axes, [0, 1].flatMap((i) => curves("case1/tip_lateral", axes, i)));
}

export function map() {
  const axes = [kDelay, kBandwidth];
  const all = kObservers.map((o, k) => {
    const levels = kDelay.levels.flatMap((_, i) =>
      kBandwidth.levels.map((_, j) => {
        if (i === 5 && j === 4) return levelOf([i, j], 0, 0, 0, k === 1 ? 20 : 0); // could not be run, or was not
        return levelOf([i, j], 20, Math.round(20 * share(i + j, 10 * kStrengths[k], 0.7)), 0.004 * (1 + i + j) * (1.5 - kStrengths[k]));
      }),
    );
    return curveOf("case1/tip_lateral", o.id, [0, 1], levels);
  });
  return campaignOf("map", axes, all);
}

export function factorial() {
  const factors = ["scenario", "leg estimator", "CoM estimator", "gains"];
  const shares = (list) => list.map(([factor, levels, share, ci95 = null]) => ({ factor, levels, share, ci95 }));
  const all = ["case1", "case5"].flatMap((scenario, i) =>
    ["none", "momentum", "kalman"].flatMap((leg, j) => ["none", "wrench"].map((com, k) => curveOf(scenario, kObservers[j].id, [], [levelOf([0, 0], 20, 4 * j + 3 * i + k, 0.01 * (1 + j + k))], { factors: [scenario, leg, com, "paper"] }))),
  );
  const falls = shares([["leg estimator", 3, 0.42, [0.36, 0.47]], ["scenario", 2, 0.21, [0.16, 0.26]], ["leg estimator x scenario", 6, 0.08, [0.05, 0.12]], ["CoM estimator", 2, 0.03, [0.01, 0.06]], ["seed", 20, 0.008], ["residual", 0, 0.252]]);
  const errors = shares([["scenario", 2, 0.61, [0.55, 0.66]], ["leg estimator", 3, 0.18, [0.14, 0.22]], ["leg estimator x CoM estimator", 6, 0.04, [0.02, 0.07]], ["residual", 0, 0.17]]);
  return campaignOf("factorial", [], all, { factors, factorial: [{ response: "falls", trials: 240, left_out: 0, shares: falls }, { response: "log CoM error", trials: 150, left_out: 90, shares: errors }] });
}

/** What the data of a page are when its run is that campaign: no rows and claims. */
export function becomesCampaign(data, campaign) {
  data.campaign = campaign;
  data.rows = [];
  data.claims = [];
}
