// A robot description: what is taken is a robot with finite figures.
#include <cmath>

#include "robot/description.h"
#include "test/fuzz/harness.h"

namespace {

bool usable(const dob::LinkInertia& inertia) {
  return inertia.mass > 0.0 && std::isfinite(inertia.mass) && inertia.com.allFinite() && inertia.inertia.allFinite();
}

bool usable(const dob::JointDescription& joint) {
  return joint.origin.allFinite() && std::abs(joint.axis.norm() - 1.0) < 1e-9 && joint.lower < joint.upper &&
         joint.effort_limit > 0.0 && joint.velocity_limit > 0.0;
}

void check(const dob::RobotDescription& robot) {
  bool good = usable(robot.trunk.inertia);
  for (const dob::LegDescription& leg : robot.legs) {
    for (const dob::JointDescription& joint : leg.joints) good = good && usable(joint);
    for (const dob::LinkDescription& link : leg.links) good = good && usable(link.inertia);
    good = good && leg.foot_center.allFinite() && leg.foot_radius > 0.0;
  }
  if (!good) dob::fuzz::finding("a robot that cannot be");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const dob::fuzz::InputFile file("input.urdf");
  const std::string& path = file.write(dob::fuzz::text_of(data, size));
  try {
    check(dob::load_robot(path, dob::Forward::kMinusY));
  } catch (const dob::DescriptionError& error) {
    dob::fuzz::check_refusal(error.what(), {path});
  }
  return 0;
}
