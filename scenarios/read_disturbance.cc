// One [[disturbance]]: how large, when, where and in which direction a force acts, or from what these are drawn.
#include <algorithm>
#include <array>
#include <string>

#include "scenarios/reader.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

using Kind = ForceProfile::Kind;  // of a profile that is written down; a random one has none
using Frame = Disturbance::Frame;

constexpr double kLongest = 1e5;                 // [s]
constexpr Range kForce = between(-1e5, 1e5);     // [N]
constexpr Range kOnLink = between(-10.0, 10.0);  // [m] from the link's origin

constexpr double kShortestHold = 0.05;  // [s] of a draw: what changes faster is noise

constexpr std::array<Choice<std::optional<Kind>>, 3> kProfiles{
    {{"constant", Kind::kConstant}, {"sine", Kind::kSine}, {"random", std::nullopt}}};
constexpr const char* kAnyLeg = "any";
constexpr std::array<Choice<int>, kLegs + 1> kBodies{
    {{"LF", 0}, {"RF", 1}, {"LH", 2}, {"RH", 3}, {"trunk", AppliedForce::kTrunk}}};
constexpr std::array<Choice<LegLink>, kJointsPerLeg> kLinks{
    {{"hip", LegLink::kHip}, {"upper", LegLink::kUpper}, {"lower", LegLink::kLower}}};
constexpr std::array<Choice<Frame>, 2> kFrames{{{"world", Frame::kWorld}, {"base", Frame::kBase}}};
constexpr std::array<Choice<bool>, 2> kPoints{{{"origin", false}, {"foot", true}}};  // is it the foot?

// Its window: start_s and duration_s, which both kinds of disturbance have.
template <typename Windowed>
void read_window(Reader& r, Windowed& w) {
  w.start_s = r.number("start_s", between(0.0, kLongest), 0.0);
  w.duration_s = r.number("duration_s", above(0.0, kLongest), w.duration_s);  // else to the end
}

ForceProfile read_profile(Reader& r, Kind kind) {
  ForceProfile p;
  p.kind = kind;
  p.amplitude_N = r.number("amplitude_N", kForce);
  if (p.kind == Kind::kSine) {
    p.period_s = r.number("period_s", above(0.0, kLongest));
    p.phase_rad = r.number("phase_rad", between(-100.0, 100.0), 0.0);
  }
  read_window(r, p);
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

Disturbance read_written(Reader& r, Kind kind, const RobotDescription& robot) {
  Disturbance d;
  d.profile = read_profile(r, kind);
  d.leg = r.choice("leg", kBodies);
  if (d.leg != AppliedForce::kTrunk) d.link = r.choice("link", kLinks);
  d.p_L = read_point(r, d, robot);
  d.direction = r.direction("direction");
  d.frame = r.choice("frame", kFrames, std::optional(Frame::kWorld));
  return d;
}

std::vector<Leg> read_legs(Reader& r) {
  std::vector<Leg> legs;
  const std::vector<std::string> words = r.texts("legs");
  if (words == std::vector<std::string>{kAnyLeg}) return RandomPush{}.legs;
  for (const std::string& word : words) {
    const auto name = std::find(kLegNames.begin(), kLegNames.end(), word);
    const Leg leg{static_cast<int>(name - kLegNames.begin())};
    if (name == kLegNames.end() || std::find(legs.begin(), legs.end(), leg) != legs.end()) {
      r.refuse("legs", "\"any\", or a list of LF, RF, LH, RH, each at most once");
    }
    legs.push_back(leg);
  }
  return legs;
}

RandomPush read_random(Reader& r) {
  RandomPush push;
  push.min_N = r.number("min_N", between(0.0, kForce.max));
  push.max_N = r.number("max_N", between(push.min_N, kForce.max));
  push.hold_s = r.number("hold_s", between(kShortestHold, kLongest));
  read_window(r, push);
  push.legs = read_legs(r);
  return push;
}

}  // namespace

void read_disturbance(Reader& r, const RobotDescription& robot, Scenario& scenario) {
  if (const auto kind = r.choice("profile", kProfiles)) {
    scenario.disturbances.push_back(read_written(r, *kind, robot));
  } else {
    scenario.random_pushes.push_back(read_random(r));
  }
}

}  // namespace dob
