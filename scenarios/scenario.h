// One case study, fully resolved: defaults, then the scenario file, then its variant, then the gain set, then
// overrides. Plain values; the loader (scenarios/loader.h) has checked every one of them.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "controller/gait_scheduler.h"
#include "controller/motion_planner.h"
#include "controller/reference_path.h"
#include "controller/wbc_options.h"
#include "observers/options.h"
#include "robot/description.h"
#include "sim/block_field.h"
#include "sim/disturbance.h"
#include "sim/payload.h"
#include "sim/random_push.h"
#include "sim/sensing.h"
#include "sim/sensors.h"
#include "sim/simulator.h"
#include "sim/terrain.h"

namespace dob {

struct RobotConfig {
  std::filesystem::path urdf;             // absolute
  Forward forward = Forward::kMinusY;     // direction of travel in the description's base frame
  std::map<std::string, double> posture;  // [rad] joint name -> seed of the standing pose's inverse kinematics
  double initial_speed = 0.0;             // [m/s] of the trunk along x at t = 0, over feet that stand still
};

// A trial ends as a fall when one of these is exceeded, the trunk touches anything, or a state is not finite.
struct FallOptions {
  double min_height_ratio = 0.6;  // trunk height over its nominal height
  double max_tilt = 0.7;          // [rad] angle between the z axes of B and W
};

// What a seed other than 1 draws, uniformly within +- these (seed 1 is the nominal run).
struct SeedVariation {
  double gait_phase = 1.0;  // share of the first stance phase already over: 0 to this; and which diagonal first
  double position = 0.005;  // [m] initial trunk position x, y
  double velocity = 0.02;   // [m/s] initial trunk velocity x, y
  double disturbance_onset = 0.265;  // [s] later start of every disturbance: 0 to this
};

// How far the model that controller and observer compute with is from the simulated robot: factors on masses and
// inertias, 1 for a true one. Centres of mass within the links stay.
struct ModelError {
  double mass_scale = 1.0;                // of every link
  double trunk_mass_scale = 1.0;          // of the trunk, besides
  double rotational_inertia_scale = 1.0;  // of every link's inertia about its centre of mass alone, besides

  bool none() const noexcept { return mass_scale == 1.0 && trunk_mass_scale == 1.0 && rotational_inertia_scale == 1.0; }
};

struct Scenario {
  std::string name;
  std::string variant;    // "" when the file has none
  std::string summary;    // one line
  double duration = 0.0;  // [s] of the path unless given
  RobotConfig robot;
  std::vector<PathSegment> path;
  GaitOptions gait;
  PlannerOptions planner;
  WbcOptions controller;           // of the gain set
  bool swing_compensation = true;  // false: (31) without disturbance, whatever an observer's routing says
  SimOptions sim;
  Terrain terrain;
  std::optional<BlockField> block_field;  // laid out by each seed, besides the terrain's boxes
  SensorNoise noise;
  SensingErrors sensing;
  ModelError model_error;
  std::vector<Disturbance> disturbances;
  std::vector<Payload> payloads;
  std::vector<RandomPush> random_pushes;  // what each seed draws, also seed 1
  std::optional<Leg> metric_leg;          // leg whose foot and force errors are reported; else the worst of / all four
  FallOptions fall;
  SeedVariation seed_variation;
};

// An observer as one cell of the batch uses it: gains and routing come from a profile, then from the command line.
struct ObserverConfig {
  std::string observer;  // name in the factory, or the absolute path of a plugin
  std::string profile;   // "-" for an observer that has no gains and no routing
  ObserverOptions options;
  Routing routing;
  std::string label = {};  // what tables call it: the specification, with a plugin's own name in place of its path
};

}  // namespace dob
