// Where the feet are, from the trunk's pose and the joint angles of a replay frame.
import { kLegs, type Report, type Robot, type Trace } from "./data";

export const kNoRobot = "The robot of this scenario could not be read.";

export type Vec = [number, number, number];
type Rotation = readonly Vec[]; // rows

const kJoints = ["hip", "upper", "lower"] as const;
const kIdentity: Rotation = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

// The robot that walked a scenario; null if it could not be read.
export function robotOf(report: Report, scenarioId: string): Robot | null {
  const place = report.scenarios.find((s) => s.id === scenarioId)?.robot ?? null;
  return place === null ? null : (report.robots[place] ?? null);
}

// Centres of the feet in the world at frame k, in the order of robot.feet; null without a robot and where the replay
// lacks a signal.
export function footPositions(robot: Robot | null, trace: Trace, k: number): Vec[] | null {
  if (!robot) return null;
  const read = (name: string): number => trace.replay(name)?.[k] ?? NaN;
  const angle = (joint: number): number => read(`${kLegs[Math.floor(joint / 3)]}/${kJoints[joint % 3]}/angle_rad`);
  const positions: Vec[] = [];
  const rotations: Rotation[] = [];
  robot.links.forEach((link) => {
    if (link.parent < 0) {
      positions.push([read("trunk/x_m"), read("trunk/y_m"), read("trunk/z_m")]);
      rotations.push(fromQuaternion(read("trunk/qw"), read("trunk/qx"), read("trunk/qy"), read("trunk/qz")));
      return;
    }
    const parent = rotations[link.parent]!;
    positions.push(add(positions[link.parent]!, rotate(parent, link.origin)));
    rotations.push(product(parent, link.joint < 0 ? kIdentity : about(link.axis, angle(link.joint))));
  });
  const feet = robot.feet.map((foot) => add(positions[foot.link]!, rotate(rotations[foot.link]!, foot.center)));
  return feet.length > 0 && feet.every((p) => p.every(Number.isFinite)) ? feet : null;
}

function fromQuaternion(w: number, x: number, y: number, z: number): Rotation {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

function about([x, y, z]: Vec, angle: number): Rotation {
  const half = angle / 2;
  const s = Math.sin(half) / Math.hypot(x, y, z);
  return fromQuaternion(Math.cos(half), s * x, s * y, s * z);
}

function rotate(r: Rotation, v: Vec): Vec {
  const row = (i: number): number => r[i]![0] * v[0] + r[i]![1] * v[1] + r[i]![2] * v[2];
  return [row(0), row(1), row(2)];
}

function product(a: Rotation, b: Rotation): Rotation {
  const column = (j: number): Vec => rotate(a, [b[0]![j]!, b[1]![j]!, b[2]![j]!]);
  const [x, y, z] = [column(0), column(1), column(2)];
  return [0, 1, 2].map((i) => [x[i]!, y[i]!, z[i]!] as Vec);
}

function add(a: Vec, b: Vec): Vec {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
