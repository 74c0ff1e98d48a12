// Ownership of ODE's objects. Internal to sim/: include it from .cc files and internal headers only.
#pragma once

#include <memory>
#include <type_traits>

#include <ode/ode.h>

#include "robot/types.h"

namespace dob {

static_assert(std::is_same_v<dReal, double>, "the simulator needs ODE in double precision");

// Initialises ODE once per process, on first use, and closes it at exit.
class OdeLibrary {
 public:
  static void require() { static const OdeLibrary library; }
  OdeLibrary(const OdeLibrary&) = delete;
  OdeLibrary& operator=(const OdeLibrary&) = delete;

 private:
  OdeLibrary() {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
  }
  ~OdeLibrary() { dCloseODE(); }
};

struct OdeDelete {
  void operator()(dWorldID world) const noexcept { dWorldDestroy(world); }  // with its bodies and joints
  void operator()(dSpaceID space) const noexcept { dSpaceDestroy(space); }  // with its geoms
  void operator()(dJointGroupID group) const noexcept { dJointGroupDestroy(group); }
};
using OdeWorld = std::unique_ptr<dxWorld, OdeDelete>;
using OdeSpace = std::unique_ptr<dxSpace, OdeDelete>;
using OdeJointGroup = std::unique_ptr<dxJointGroup, OdeDelete>;

inline Vec3 from_ode(const dReal* v) noexcept {
  return {v[0], v[1], v[2]};
}

inline Mat3 rotation_from_ode(const dReal* r) noexcept {  // 3x4, row-major, last column padding
  Mat3 R;
  R << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return R;
}

struct OdeRotation {
  dMatrix3 data;
  explicit OdeRotation(const Mat3& R) noexcept
      : data{R(0, 0), R(0, 1), R(0, 2), 0.0, R(1, 0), R(1, 1), R(1, 2), 0.0, R(2, 0), R(2, 1), R(2, 2), 0.0} {}
};

}  // namespace dob
