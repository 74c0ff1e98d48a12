// One trial: the block diagram of the paper's Fig. 2, closed around the simulator.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bench/recorder.h"
#include "bench/shadows.h"
#include "bench/tick_clock.h"
#include "controller/locomotion_controller.h"
#include "observers/observer.h"
#include "results/cell.h"
#include "robot/model.h"
#include "scenarios/scenario.h"
#include "sim/disturbance_schedule.h"
#include "sim/simulator.h"

namespace dob {

class Trial {
 public:
  // Builds everything and stands the robot up. `shadows` watch the trial without a part in it. Throws std::exception
  // with a message for the user.
  Trial(const Scenario& scenario, const ObserverConfig& observer, int seed,
        const std::vector<ObserverConfig>& shadows = {});
  ~Trial();

  using Sink = std::function<void(const TickRecord&)>;

  // Runs to the scenario's end or a fall. The result's key holds what the trial knows of it. `sink` sees every tick.
  // Throws std::runtime_error when it came to its end but a disturbance never came to its trigger: it would be taken
  // for a trial under that disturbance; and when the robot stands but the observer's estimate, or what is measured of
  // the trial, is not finite: it would be taken for a trial with that observer.
  CellResult run(const Sink& sink = {});

  // Measures the ticks from now on; the clock must outlive the trial. Changes nothing else.
  void time_ticks(TickClock& clock);

  // One control tick and simulation step; false when the robot has fallen. For run() and benchmarks.
  bool tick();

  double time() const noexcept { return static_cast<double>(tick_) * scenario_.sim.dt; }  // [s]
  const TickRecord& record() const noexcept { return record_; }
  std::span<const AppliedForce> forces() const noexcept { return disturbances_.forces(); }  // over the last step
  const LocomotionController& controller() const noexcept { return controller_; }
  const Estimate& estimate() const noexcept { return estimate_; }   // for the next tick
  const ModelTerms& model_terms() const noexcept { return *now_; }  // that controller and observer compute with

 private:
  void draw_disturbances();
  void apply_seed(RobotState& initial);
  void start_moving(RobotState& initial);
  void sense(const StepResult& step);
  void observe(const SensorReading& reading) noexcept;
  bool has_fallen(const StepResult& step) noexcept;
  // Of the simulated robot in its true state: what the metrics and the truth about disturbances are computed with.
  const ModelTerms& true_terms() const noexcept { return truth_ ? truth_->terms : *now_; }

  struct Truth {
    Model model;
    ModelTerms terms;
  };

  Scenario scenario_;
  ObserverConfig observer_config_;
  int seed_;
  RobotDescription robot_;      // the simulated one
  Model model_;                 // that controller and observer compute with
  std::optional<Truth> truth_;  // only where that, or the state it is told, differs from the simulated robot
  Simulator simulator_;
  Sensors sensors_;
  Sensing sensing_;
  std::unique_ptr<DisturbanceObserver> observer_;
  bool oracle_;  // the truth takes the place of the observer's estimate
  Shadows shadows_;
  LocomotionController controller_;
  double initial_footstep_time_ = 0.0;
  int first_step_ = 0;

  std::array<ModelTerms, 2> terms_;  // at the start and at the end of a control interval, swapped every tick
  ModelTerms* start_ = &terms_[0];
  ModelTerms* now_ = &terms_[1];
  Vec12 foot_force_ = Vec12::Zero();  // [N] measured over the last step
  Estimate estimate_;
  DisturbanceSchedule disturbances_;
  long tick_ = 0;
  double nominal_height_ = 0.0;
  const char* fall_reason_ = "";
  Recorder recorder_;
  TickRecord record_;
  TickClock* clock_ = nullptr;
};

}  // namespace dob
