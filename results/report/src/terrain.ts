// The ground of a run, as far as the report has it: of one seed and one setting per scenario.
import type { Box, Report, ScenarioInfo } from "./data";
import { plural, seconds } from "./format";
import { robotOf } from "./kinematics";

interface RunOf {
  setting: number;
  seed: number;
}

// Gains and planner leave the ground and the duration as they are; overrides may not.
function isOfSetting(report: Report, scenario: ScenarioInfo, setting: number): boolean {
  const overrides = (id: number): string => report.settings.find((s) => s.id === id)?.overrides ?? "";
  return scenario.setting === undefined || overrides(scenario.setting) === overrides(setting);
}

// The blocks to draw for a run; `note` says why there are none where there should be some.
export function blocksOf(report: Report, run: RunOf & { scenario_id: string }): { boxes: Box[]; note: string } {
  const scenario = report.scenarios.find((s) => s.id === run.scenario_id);
  if (!scenario || scenario.duration_s === null) return { boxes: [], note: "The scenario could not be read: blocks are not drawn." };
  if (!isOfSetting(report, scenario, run.setting)) return { boxes: [], note: "The ground of this run\u2019s overrides is not on this page: blocks are not drawn." };
  if (scenario.boxes.length > 0 && scenario.seed !== run.seed) {
    return { boxes: [], note: `The blocks of seed ${scenario.seed} are not those of this run: not drawn.` };
  }
  return { boxes: scenario.boxes, note: "" };
}

// What stands below a scenario's summary.
export function scenarioFacts(report: Report, scenario: ScenarioInfo, run: RunOf): string[] {
  const seed = `seed ${run.seed}`;
  if (scenario.duration_s === null) return ["the scenario could not be read: its duration and ground are not known", seed];
  const leg = scenario.metric_leg === "all" ? [] : [`leg ${scenario.metric_leg}`];
  const robot = robotOf(report, scenario.id);
  const who = robot ? [`${robot.name}, ${robot.mass_kg.toFixed(1)} kg`] : [];
  if (!isOfSetting(report, scenario, run.setting)) return [...who, ...leg, "duration and ground as the overrides have them", seed];
  const friction = scenario.friction === null ? [] : [`friction ${scenario.friction}`];
  const ground = scenario.boxes.length > 0 ? plural(scenario.boxes.length, "block") : "level ground";
  return [...who, seconds(scenario.duration_s), ...leg, ...friction, ground, seed];
}
