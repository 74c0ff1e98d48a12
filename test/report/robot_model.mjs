// The replay's own kinematics, taken out of the page's sources, against the feet that the simulation recorded.
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";

const sources = new URL("../../results/report/", import.meta.url);
const { build } = createRequire(new URL("package.json", sources))("esbuild");

/** Largest distance [m] between a foot of the replay and of the trace, over all its rows. */
export async function largestFootDistance(robot, trace) {
  const { RobotModel, Recording, Vector3 } = await replaySources();
  const recording = new Recording({ replay: (name) => trace.columns.get(name) ?? null }, { rate_Hz: trace.rate_Hz, frames: trace.rows });
  const model = new RobotModel(robot);
  const [foot, truth] = [new Vector3(), new Vector3()];
  let largest = 0;
  for (let row = 0; row < trace.rows; ++row) {
    recording.seek(row / trace.rate_Hz);
    model.pose(recording);
    robot.feet.forEach(({ leg }, l) => {
      recording.vector(`${leg}/foot`, "m", truth);
      const distance = model.foot(l, foot).distanceTo(truth);
      if (!(distance <= largest)) largest = distance;
    });
  }
  return largest;
}

async function replaySources() {
  const contents = 'export * from "./robot_model"; export * from "./recording"; export { Vector3 } from "three";';
  const resolveDir = fileURLToPath(new URL("src/replay", sources));
  const bundled = await build({ stdin: { contents, resolveDir, loader: "ts" }, bundle: true, write: false, format: "esm", platform: "node" });
  return import(`data:text/javascript;base64,${Buffer.from(bundled.outputFiles[0].text).toString("base64")}`);
}
