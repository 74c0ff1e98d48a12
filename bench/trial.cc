#include "bench/trial.h"

#include <chrono>
#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/LU>
#include <fmt/format.h>

#include "bench/state_hash.h"
#include "observers/factory.h"
#include "results/metrics.h"
#include "robot/standing_pose.h"
#include "scenarios/laid_terrain.h"
#include "sim/random_stream.h"

namespace dob {
namespace {

constexpr std::uint32_t kStartStream = 0x57a7u;  // sets what apply_seed() draws apart from other draws of the seed

// What controller and observer take the robot to be.
RobotDescription believed_robot(const RobotDescription& robot, const ModelError& error) {
  if (error.none()) return robot;  // to the bit
  return scale_rotational_inertia(scale_trunk_inertia(scale_inertia(robot, error.mass_scale), error.trunk_mass_scale),
                                  error.rotational_inertia_scale);
}

LocomotionOptions locomotion_options(const Scenario& s, Routing routing) {
  if (!s.swing_compensation) routing.swing_31 = Routing::Swing::kOff;
  return {s.gait, s.planner, s.controller, routing};
}

// Share of its planned swing that has passed since each leg's lift-off; negative while it stands.
PerLeg<double> swing_phase(const GaitState& gait) noexcept {
  PerLeg<double> phase;
  for (int l = 0; l < kLegs; ++l) {
    phase[l] = gait.stands(l) ? -1.0 : gait.swing_time[l] / gait.pattern.swing_duration;
  }
  return phase;
}

std::string never_fired(const Disturbance& d) {
  return fmt::format("a disturbance waited for phase {} of a swing of {} from {:.3f} s on, and no swing came to it",
                     d.trigger->phase, kLegNames[static_cast<std::size_t>(d.trigger->leg)], d.profile.start_s);
}

bool is_finite(const Estimate& e) noexcept {
  return (!e.has_legs || e.leg_torque.allFinite()) && (!e.has_com || e.com_wrench.allFinite());
}

DisturbanceEstimate for_controller(const Estimate& e) noexcept {
  return {e.has_legs, e.leg_torque, e.has_com, e.com_wrench};
}

}  // namespace

Trial::Trial(const Scenario& scenario, const ObserverConfig& observer, int seed,
             const std::vector<ObserverConfig>& shadows)
    : scenario_(scenario),
      observer_config_(observer),
      seed_(seed),
      robot_(load_robot(scenario.robot.urdf, scenario.robot.forward)),
      model_(believed_robot(robot_, scenario.model_error)),
      simulator_(robot_, laid_terrain(scenario, seed), scenario.sim),
      sensors_(scenario.noise, static_cast<std::uint64_t>(seed)),
      sensing_(scenario.sensing, static_cast<std::uint64_t>(seed)),
      observer_(make_observer(observer.observer, observer.options, scenario.sim.dt)),
      oracle_(is_oracle(observer.observer)),
      shadows_(shadows, scenario.sim.dt),
      controller_(locomotion_options(scenario, observer.routing), ReferencePath(scenario.path), scenario.sim.dt),
      recorder_(robot_, scenario_) {
  if (!scenario_.model_error.none() || scenario_.sensing.of_state()) truth_.emplace(Truth{Model(robot_), {}});
  RobotState initial = standing_pose(truth_ ? truth_->model : model_, scenario_.planner.com_height,
                                     scenario_.planner.footsteps.foot_offset_x,
                                     scenario_.planner.footsteps.foot_offset_y, scenario_.robot.posture);
  nominal_height_ = initial.p_WB.z();
  draw_disturbances();
  apply_seed(initial);
  disturbances_ = DisturbanceSchedule(scenario_.disturbances, scenario_.payloads, scenario_.sim.gravity);
  for (const Payload& payload : scenario_.payloads) simulator_.add_payload(payload);
  start_moving(initial);
  simulator_.reset(initial);
  sensing_.reset(initial);
  model_.compute(initial, *now_);
  if (truth_) truth_->model.compute(initial, truth_->terms);
  observer_->reset(*now_);
  shadows_.reset(*now_);
  controller_.reset(*now_, initial_footstep_time_, first_step_);
}

Trial::~Trial() = default;

// Before apply_seed(), which may shift their onset like that of any other disturbance.
void Trial::draw_disturbances() {
  std::uint32_t stream = 0;
  for (const RandomPush& push : scenario_.random_pushes) {
    const auto draws = draw_pushes(push, robot_, static_cast<std::uint64_t>(seed_), stream++, scenario_.duration);
    scenario_.disturbances.insert(scenario_.disturbances.end(), draws.begin(), draws.end());
  }
}

// Seed 1 is the nominal run; the others vary the start of the gait, of the robot and of the disturbances.
void Trial::apply_seed(RobotState& initial) {
  if (seed_ == 1) return;
  std::mt19937_64 random = random_stream(static_cast<std::uint64_t>(seed_), kStartStream);
  const SeedVariation& v = scenario_.seed_variation;
  initial_footstep_time_ = v.gait_phase * uniform(random) * scenario_.gait.pattern.stance_duration;
  first_step_ = uniform(random) < 0.5 ? 1 : 0;
  for (int i = 0; i < 2; ++i) {
    initial.p_WB[i] += v.position * (2.0 * uniform(random) - 1.0);
    initial.v_WB[i] += v.velocity * (2.0 * uniform(random) - 1.0);
  }
  const double later = v.disturbance_onset * uniform(random);
  for (Disturbance& d : scenario_.disturbances) d.profile.start_s += later;
  for (Payload& p : scenario_.payloads) p.start_s += later;
}

// The trunk moves along x from the start, the feet stand: joint rates that keep the contact points at rest.
void Trial::start_moving(RobotState& initial) {
  const double speed = scenario_.robot.initial_speed;
  if (speed == 0.0) return;
  const Vec3 velocity = speed * Vec3::UnitX();
  initial.v_WB += velocity;
  model_.compute(initial, *now_);
  for (int l = 0; l < kLegs; ++l) {
    initial.qd.segment<3>(3 * l) = -now_->contact[l].J_q.partialPivLu().solve(velocity);
  }
}

void Trial::time_ticks(TickClock& clock) {
  clock_ = &clock;
  controller_.use_solver(clock.timed(make_wbc_solver()));
}

bool Trial::tick() {
  const double t = time();
  if (clock_ != nullptr) clock_->start();
  const WbcTick& command = controller_.update(*now_, foot_force_, for_controller(estimate_));
  if (clock_ != nullptr) clock_->stop();
  if (!command.torque.allFinite()) {
    fall_reason_ = "non-finite command";
    return false;
  }
  const ModelTerms& truth = true_terms();
  disturbances_.update(t, swing_phase(controller_.gait()), truth.state);

  const StepResult step = simulator_.step(command.torque, disturbances_.forces());
  shadows_.judge(recorder_);
  record_ = recorder_.record(t, truth, controller_, command, step, estimate_, disturbances_);

  sense(step);
  ++tick_;
  return !has_fallen(step);
}

// The first step ends at tick 1: until the delay lets it through there is no interval to observe.
void Trial::sense(const StepResult& step) {
  const RobotState state = simulator_.state();
  if (truth_) truth_->model.compute(state, truth_->terms);
  const Measurement& measured = sensing_.measure(state, sensors_.measure(step), step.foot_contact);
  std::swap(start_, now_);
  if (clock_ != nullptr) clock_->start();
  model_.compute(measured.state, *now_);
  if (measured.tick > 0) observe(measured.reading);
  if (clock_ != nullptr) clock_->end_tick();
}

void Trial::observe(const SensorReading& reading) noexcept {
  for (int l = 0; l < kLegs; ++l) foot_force_.segment<3>(3 * l) = reading.foot_force_W[l];
  const ObserverInput input{*start_, *now_, reading.joint_torque, foot_force_, controller_.stance(), scenario_.sim.dt};
  estimate_ = observer_->update(input);
  if (oracle_) recorder_.tell_truth(estimate_);
  shadows_.update(input, recorder_);
}

CellResult Trial::run(const Sink& sink) {
  const auto wall_start = std::chrono::steady_clock::now();
  const long ticks = std::lround(scenario_.duration / scenario_.sim.dt);
  MetricsAccumulator metrics(scenario_.metric_leg, scenario_.sim.dt, scenario_.duration);
  CellResult result;
  result.key = {.scenario = scenario_.name,
                .variant = scenario_.variant,
                .observer = observer_config_.observer,
                .profile = observer_config_.profile,
                .gains = {},
                .planner = {},
                .overrides = {},
                .seed = seed_};
  result.outcome = Outcome::kSurvived;
  std::uint64_t hash = kNoStates;
  while (tick_ < ticks) {
    const bool up = tick();
    hash = hash_state(hash, true_terms().state);
    if (up && !is_finite(estimate_)) {
      throw std::runtime_error(
          fmt::format("the estimate of {} is not finite at {:.3f} s", observer_config_.label, time()));
    }
    if (up) {
      metrics.add(record_);
      shadows_.count();
    }
    if (sink) sink(record_);
    if (!up) {
      result.outcome = Outcome::kFell;
      result.reason = fall_reason_;
      break;
    }
  }
  if (const Disturbance* d = disturbances_.waiting(); d != nullptr && result.outcome == Outcome::kSurvived) {
    throw std::runtime_error(never_fired(*d));
  }
  if (const std::string_view metric = metrics.not_finite(); !metric.empty() && result.outcome == Outcome::kSurvived) {
    throw std::runtime_error(fmt::format("{} is not finite", metric));
  }
  result.simulated_s = time();
  result.state_hash = hash;
  result.metrics = metrics.finish();
  result.checkpoints = metrics.checkpoints();
  result.shadows = shadows_.results();
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  return result;
}

bool Trial::has_fallen(const StepResult& step) noexcept {
  const RobotState& s = true_terms().state;
  const bool finite = s.p_WB.allFinite() && s.R_WB.allFinite() && s.v_WB.allFinite() && s.omega_WB.allFinite() &&
                      s.q.allFinite() && s.qd.allFinite();
  if (!finite) {
    fall_reason_ = "non-finite state";
  } else if (step.trunk_contact) {
    fall_reason_ = "trunk touches";
  } else if (s.p_WB.z() < scenario_.fall.min_height_ratio * nominal_height_) {
    fall_reason_ = "trunk low";
  } else if (std::acos(std::clamp(s.R_WB(2, 2), -1.0, 1.0)) > scenario_.fall.max_tilt) {
    fall_reason_ = "trunk tilted";
  } else {
    return false;
  }
  return true;
}

}  // namespace dob
