// One [[disturbance]]: how large, when, where and in which direction a force acts.
#include <array>

#include "scenarios/reader.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

using Kind = ForceProfile::Kind;
using Frame = Disturbance::Frame;

constexpr double kLongest = 1e5;                 // [s]
constexpr Range kForce = between(-1e5, 1e5);     // [N]
constexpr Range kOnLink = between(-10.0, 10.0);  // [m] from the link's origin

constexpr std::array<Choice<Kind>, 2> kProfiles{{{"constant", Kind::kConstant}, {"sine", Kind::kSine}}};
constexpr std::array<Choice<int>, kLegs + 1> kBodies{
    {{"LF", 0}, {"RF", 1}, {"LH", 2}, {"RH", 3}, {"trunk", AppliedForce::kTrunk}}};
constexpr std::array<Choice<LegLink>, kJointsPerLeg> kLinks{
    {{"hip", LegLink::kHip}, {"upper", LegLink::kUpper}, {"lower", LegLink::kLower}}};
constexpr std::array<Choice<Frame>, 2> kFrames{{{"world", Frame::kWorld}, {"base", Frame::kBase}}};
constexpr std::array<Choice<bool>, 2> kPoints{{{"origin", false}, {"foot", true}}};  // is it the foot?

ForceProfile read_profile(Reader& r) {
  ForceProfile p;
  p.kind = r.choice("profile", kProfiles);
  p.amplitude_N = r.number("amplitude_N", kForce);
  if (p.kind == Kind::kSine) {
    p.period_s = r.number("period_s", above(0.0, kLongest));
    p.phase_rad = r.number("phase_rad", between(-100.0, 100.0), 0.0);
  }
  p.start_s = r.number("start_s", between(0.0, kLongest), 0.0);
  p.duration_s = r.number("duration_s", above(0.0, kLongest), p.duration_s);  // else to the end
  return p;
}

Vec3 read_point(Reader& r, const Disturbance& d, const RobotDescription& robot) {
  if (r.has("point_m")) {
    if (r.has("point")) r.refuse("point", "either point or point_m, not both");
    return r.vector("point_m", kOnLink);
  }
  const bool foot = r.choice("point", kPoints);
  if (!foot) return Vec3::Zero();
  if (d.leg == AppliedForce::kTrunk || d.link != LegLink::kLower)
    r.refuse("point", "foot only on the lower link of a leg; else origin");
  return robot.legs[static_cast<std::size_t>(d.leg)].foot_center;
}

}  // namespace

Disturbance read_disturbance(Reader& r, const RobotDescription& robot) {
  Disturbance d;
  d.profile = read_profile(r);
  d.leg = r.choice("leg", kBodies);
  if (d.leg != AppliedForce::kTrunk) d.link = r.choice("link", kLinks);
  d.p_L = read_point(r, d, robot);
  d.direction = r.direction("direction");
  d.frame = r.choice("frame", kFrames, std::optional(Frame::kWorld));
  return d;
}

}  // namespace dob
