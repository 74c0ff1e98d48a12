// The Open Dynamics Engine (ODE 0.16) world of one quadruped on a terrain.
//
// 13 rigid bodies and 12 hinges, stepped by ODE's direct solver (dWorldStep): a semi-implicit Euler step of
// first order, velocities first. In one step() the contacts are found at the pose BEFORE the step, the
// torques and forces act over it, and the forces reported are those that acted over it.
//
// Contact: every foot is a sphere with one contact point per surface touched; the trunk and the links of the legs
// are solids that touch ground and boxes. The robot never touches itself. The friction coefficient mu is the
// smaller of the two surfaces'.
//
// Friction is a PYRAMID, not a cone (dContactApprox1): |f_1| <= mu n and |f_2| <= mu n separately, with the
// directions 1, 2 along x and y of W on level ground (x of W projected into the tangent plane elsewhere), so that a
// push along the diagonal holds up to sqrt(2) mu n. And n is the normal force that dWorldStep finds BEFORE it adds
// friction, not the final f_n. Measured on a sled (the standing robot with locked joints):
//  - all feet together are right while friction moves little load: mu = 0.1 along an axis, within 0.15 % of mu m g;
//  - one foot that friction loads or unloads is not: there up to 1.3 mu f_n, and with mu = 0.4 up to 2.4 mu f_n;
//  - near tipping (a foot with n = 0) even the total is up to a quarter too high.
//
// Determinism: the same calls give the same bits, also after reset() of a used simulator. dWorldStep draws no
// random numbers (in ODE 0.16 only the iterative dWorldQuickStep and self-tests call dRand), so ODE's global
// seed is left alone. Threads: ODE keeps process-wide state; use all simulators of a process from one thread.
// Memory: step() itself allocates nothing; ODE does, for its own work space.
#pragma once

#include <memory>
#include <span>

#include "robot/description.h"
#include "robot/types.h"
#include "sim/applied_force.h"
#include "sim/payload.h"
#include "sim/terrain.h"

namespace dob {

struct SimOptions {
  double dt = 1e-3;             // [s] step
  double erp = 0.2;             // [-] share of a hinge's position error removed per step
  double cfm = 1e-10;           // [s/kg] softness of the hinges: velocity given way per force
  double contact_erp = 0.2;     // [-] share of the penetration removed per step
  double contact_cfm = 1e-5;    // [s/kg] the same of contacts; at rest they sink f_n dt contact_cfm / contact_erp
  double gravity = kGravity;    // [m/s^2] along -z of W
  double robot_friction = 1.0;  // [-] of feet, legs and trunk; the terrain's decides wherever that is <= 1
  bool contacts = true;         // false: the robot falls through everything
  bool joint_stops = false;     // hinges stop at the joint limits. Off: a stop is a constraint force that no
                                // model here knows, so that a limit is the controller's business

  // Throws std::invalid_argument naming the option, the value and what is allowed.
  void validate() const;
};

inline PerLeg<Vec3> zero_vectors() {
  return {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
}

// What happened during one step.
struct StepResult {
  Vec12 joint_torque = Vec12::Zero();          // [N m] applied: the command within the joints' effort limits
  PerLeg<Vec3> foot_force_W = zero_vectors();  // [N] ground on foot
  PerLeg<Vec3> foot_slip_W = zero_vectors();   // [m/s] tangential velocity of the foot's contact point at the end
                                               // of the step; of several contacts the fastest
  PerLeg<bool> foot_contact{};                 // the foot's sphere touches a surface
  bool trunk_contact = false;                  // the trunk touches a surface
  bool leg_contact = false;                    // a link of a leg, other than its foot, touches a surface
};

class Simulator {
 public:
  // The robot stands at RobotState{} until reset(). Throws std::invalid_argument for options, a terrain or
  // inertias that are not physical.
  Simulator(const RobotDescription& robot, const Terrain& terrain, const SimOptions& options = {});
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) noexcept;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  // One more load that step() puts on the trunk when its time has come. Throws std::invalid_argument for a payload that
  // is not physical.
  void add_payload(const Payload& payload);

  // Puts the robot into the state, time 0, without its loads. Nothing of what happened before remains.
  void reset(const RobotState& state);

  // One step of options.dt. Torques are held, and clamped to the effort limits; forces act on their points.
  // Throws std::invalid_argument for a non-finite torque or force, or a leg that does not exist, and
  // std::bad_alloc when ODE has no memory; the world is then as before the call, save for forces already
  // added.
  StepResult step(const Vec12& commanded_torque, std::span<const AppliedForce> forces = {});

  // True state at the end of the last step; joint angles in (-pi, pi]. R_WB is orthonormal to rounding. ODE
  // works in maximal coordinates: q and qd are the hinges' angles and rates, whose drift options.erp keeps
  // small.
  RobotState state() const;

  double time() const noexcept;  // [s] since reset()

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace dob
