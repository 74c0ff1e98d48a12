#include "sim/simulator.h"

#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/ode_contacts.h"
#include "sim/ode_handles.h"
#include "sim/ode_payload.h"
#include "sim/ode_robot.h"
#include "sim/require.h"

namespace dob {
namespace {

void require_valid(const AppliedForce& force) {
  if (force.leg < AppliedForce::kTrunk || force.leg >= kLegs || !force.p_L.allFinite() || !force.force_W.allFinite()) {
    throw std::invalid_argument(fmt::format(
        "simulator: applied force on leg {} at ({}, {}, {}) m of ({}, {}, {}) N; the leg must be -1 (trunk) "
        "to {}, the numbers finite",
        force.leg, force.p_L.x(), force.p_L.y(), force.p_L.z(), force.force_W.x(), force.force_W.y(), force.force_W.z(),
        kLegs - 1));
  }
}

OdeWorld make_world(const SimOptions& options) {
  OdeLibrary::require();
  OdeWorld world(dWorldCreate());
  dWorldSetGravity(world.get(), 0.0, 0.0, -options.gravity);
  dWorldSetERP(world.get(), options.erp);
  dWorldSetCFM(world.get(), options.cfm);
  return world;
}

}  // namespace

void SimOptions::validate() const {
  const Require require{"simulator"};
  const auto require_share = [&](std::string_view option, double value) {
    require(value >= 0.0 && value <= 1.0, option, value, "between 0 and 1");
  };
  require.positive("dt", dt);
  require_share("erp", erp);
  require_share("contact_erp", contact_erp);
  require.not_negative("cfm", cfm);
  require.not_negative("contact_cfm", contact_cfm);
  require.not_negative("robot_friction", robot_friction);
  require.finite("gravity", gravity);
}

// Destroyed from the bottom up: contacts, then the robot's solids, then bodies and hinges with the world.
struct Simulator::World {
  SimOptions options;
  OdeWorld world;
  OdeRobot robot;
  OdeContacts contacts;
  std::vector<OdePayload> payloads;
  long steps = 0;

  World(const RobotDescription& description, const Terrain& terrain, const SimOptions& sim_options)
      : options(sim_options),
        world(make_world(options)),
        robot(world.get(), description, options.joint_stops),
        contacts(world.get(), terrain, options) {}
};

Simulator::Simulator(const RobotDescription& robot, const Terrain& terrain, const SimOptions& options) {
  options.validate();
  terrain.validate();
  world_ = std::make_unique<World>(robot, terrain, options);
}

Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

void Simulator::add_payload(const Payload& payload) {
  payload.validate();
  world_->payloads.emplace_back(world_->world.get(), payload);
}

void Simulator::reset(const RobotState& state) {
  world_->contacts.clear();
  for (OdePayload& payload : world_->payloads) payload.take_off();
  world_->robot.set_state(state);
  world_->steps = 0;
}

StepResult Simulator::step(const Vec12& commanded_torque, std::span<const AppliedForce> forces) {
  if (!commanded_torque.allFinite()) {
    throw std::invalid_argument("simulator: the commanded joint torques must be finite");
  }
  for (const AppliedForce& force : forces) require_valid(force);

  World& w = *world_;
  StepResult result;
  for (OdePayload& payload : w.payloads) {
    payload.update(time(), w.robot.trunk(), w.robot.on_trunk(payload.payload().p_B));
  }
  if (w.options.contacts) w.contacts.find(w.robot.geoms());
  result.joint_torque = w.robot.add_torques(commanded_torque);
  for (const AppliedForce& force : forces) w.robot.add_force(force);
  if (dWorldStep(w.world.get(), w.options.dt) == 0) throw std::bad_alloc();
  ++w.steps;
  w.contacts.report(result);
  return result;
}

RobotState Simulator::state() const {
  return world_->robot.state();
}

double Simulator::time() const noexcept {
  return static_cast<double>(world_->steps) * world_->options.dt;
}

}  // namespace dob
