// One [[disturbance]]: how large, when, where and in which direction a force acts, or from what these are drawn.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "scenarios/reader.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

using Kind = ForceProfile::Kind;
using Frame = Disturbance::Frame;

constexpr Range kForce = between(-1e5, 1e5);      // [N]
constexpr Range kOnLink = between(-10.0, 10.0);   // [m] from the link's origin
constexpr Range kPhase = between(-100.0, 100.0);  // [rad]

constexpr double kShortestHold = 0.05;  // [s] of a draw: what changes faster is noise

enum class Word { kConstant, kPulse, kSine, kRamp, kChirp, kRandom };
constexpr std::array<Choice<Word>, 6> kForceProfiles{{{"constant", Word::kConstant},
                                                      {"pulse", Word::kPulse},
                                                      {"sine", Word::kSine},
                                                      {"ramp", Word::kRamp},
                                                      {"chirp", Word::kChirp},
                                                      {"random", Word::kRandom}}};
constexpr std::array<Choice<bool>, 2> kTriggers{{{"time", false}, {"gait_phase", true}}};  // is it the gait?
constexpr std::array<Choice<Leg>, kLegs> kLegWords{
    {{"LF", Leg::kLF}, {"RF", Leg::kRF}, {"LH", Leg::kLH}, {"RH", Leg::kRH}}};
constexpr const char* kAnyLeg = "any";
constexpr std::array<Choice<int>, kLegs + 1> kBodies{
    {{"LF", 0}, {"RF", 1}, {"LH", 2}, {"RH", 3}, {"trunk", AppliedForce::kTrunk}}};
constexpr std::array<Choice<LegLink>, kJointsPerLeg> kLinks{
    {{"hip", LegLink::kHip}, {"upper", LegLink::kUpper}, {"lower", LegLink::kLower}}};
constexpr std::array<Choice<Frame>, 2> kFrames{{{"world", Frame::kWorld}, {"base", Frame::kBase}}};
constexpr std::array<Choice<bool>, 2> kPoints{{{"origin", false}, {"foot", true}}};  // is it the foot?

double read_start(Reader& r, const char* key = "start_s") {
  return r.number(key, between(0.0, kLongestTime), 0.0);
}

void read_ramp(Reader& r, ForceProfile& p) {
  p.kind = Kind::kRamp;
  p.ramp_s = r.number("ramp_s", above(0.0, kLongestTime));
  if (r.has("ramp_s") && p.ramp_s > p.duration_s)
    r.refuse("ramp_s", fmt::format("at most duration_s, {}", p.duration_s));
}

// Up to half the rate of the ticks; beyond it the force would be another one. A sine likewise.
void read_chirp(Reader& r, ForceProfile& p, double dt) {
  p.kind = Kind::kChirp;
  p.f0_Hz = r.number("f0_Hz", between(0.0, 0.5 / dt));
  p.f1_Hz = r.number("f1_Hz", between(0.0, 0.5 / dt));
  p.phase_rad = r.number("phase_rad", kPhase, 0.0);
}

// Everything of the profile but when it starts.
ForceProfile read_profile(Reader& r, Word word, double dt) {
  ForceProfile p;
  p.amplitude_N = r.number("amplitude_N", kForce);
  const bool must_end = word == Word::kPulse || word == Word::kChirp;
  const auto endless = must_end ? std::nullopt : std::optional(p.duration_s);
  p.duration_s = r.number("duration_s", above(0.0, kLongestTime), endless);
  if (word == Word::kRamp) read_ramp(r, p);
  if (word == Word::kChirp) read_chirp(r, p, dt);
  if (word == Word::kSine) {
    p.kind = Kind::kSine;
    p.period_s = r.number("period_s", between(2.0 * dt, kLongestTime));
    p.phase_rad = r.number("phase_rad", kPhase, 0.0);
  }
  return p;
}

bool walks(const GaitOptions& gait) {
  const auto walking = [](const GaitPattern& pattern) { return pattern.gait != Gait::kStand; };
  return walking(gait.pattern) || std::any_of(gait.switches.begin(), gait.switches.end(),
                                              [&](const GaitSwitch& s) { return walking(s.pattern); });
}

// When the window opens: at start_s, or when a leg's swing passes a phase.
void read_trigger(Reader& r, Disturbance& d, const GaitOptions& gait) {
  if (!r.choice("trigger", kTriggers, std::optional(false))) {
    d.profile.start_s = read_start(r);
    return;
  }
  if (!walks(gait)) r.refuse("trigger", "time, as no leg swings while the gait stands");
  d.trigger = SwingTrigger{r.choice("trigger_leg", kLegWords), r.number("phase", below(0.0, 1.0))};
  d.profile.start_s = read_start(r, "not_before_s");
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

Disturbance read_written(Reader& r, Word word, const RobotDescription& robot, const Scenario& scenario) {
  Disturbance d;
  d.profile = read_profile(r, word, scenario.sim.dt);
  read_trigger(r, d, scenario.gait);
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
  push.hold_s = r.number("hold_s", between(kShortestHold, kLongestTime));
  push.start_s = read_start(r);
  push.duration_s = r.number("duration_s", above(0.0, kLongestTime), push.duration_s);
  push.legs = read_legs(r);
  return push;
}

}  // namespace

void read_disturbance(Reader& r, const RobotDescription& robot, Scenario& scenario) {
  const Word word = r.choice("profile", kForceProfiles);
  if (word == Word::kRandom) {
    scenario.random_pushes.push_back(read_random(r));
  } else {
    scenario.disturbances.push_back(read_written(r, word, robot, scenario));
  }
}

}  // namespace dob
