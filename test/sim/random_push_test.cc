#include "sim/random_push.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::random_push_test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class RandomPushTest : public ::testing::Test {
 protected:
  RobotDescription robot =
      load_robot(std::filesystem::path(DOB_SOURCE_DIR) / "robot/dogbot/dogbot.urdf", Forward::kMinusY);
  RandomPush push{.min_N = 10.0, .max_N = 35.0, .hold_s = 2.0, .start_s = 1.0};

  std::vector<Disturbance> draw(std::uint64_t seed, double end = 31.0, std::uint32_t stream = 0) const {
    return draw_pushes(push, robot, seed, stream, end);
  }

  // Share of the way from the pitch joint over the knee to the foot; checks that the point is on that line.
  double height(const Disturbance& d) const {
    const LegDescription& leg = robot.legs[static_cast<std::size_t>(d.leg)];
    const Vec3 knee = leg.joints[2].origin;
    const Vec3 foot = leg.foot_center;
    const bool upper = d.link == LegLink::kUpper;
    EXPECT_TRUE(upper || d.link == LegLink::kLower);
    const Vec3& end = upper ? knee : foot;
    EXPECT_LT(d.p_L.cross(end).norm(), 1e-12);
    const double share = d.p_L.dot(end) / end.squaredNorm();
    EXPECT_TRUE(share >= 0.0 && share <= 1.0) << share;
    const double along = upper ? share * knee.norm() : knee.norm() + share * foot.norm();
    return along / (knee.norm() + foot.norm());
  }
};

bool equal(const Disturbance& a, const Disturbance& b) {
  return a.leg == b.leg && a.link == b.link && a.p_L == b.p_L && a.direction == b.direction && a.frame == b.frame &&
         a.profile.amplitude_N == b.profile.amplitude_N && a.profile.start_s == b.profile.start_s &&
         a.profile.duration_s == b.profile.duration_s;
}

bool equal(const std::vector<Disturbance>& a, const std::vector<Disturbance>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Disturbance& x, const Disturbance& y) { return equal(x, y); });
}

TEST_F(RandomPushTest, EveryDrawIsAValidHorizontalPushWithinItsRangeOnALeg) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Disturbance> draws = draw(seed);
    ASSERT_EQ(draws.size(), 15u);
    for (const Disturbance& d : draws) {
      EXPECT_NO_THROW(d.validate());
      EXPECT_EQ(d.profile.kind, ForceProfile::Kind::kConstant);
      EXPECT_GE(d.profile.amplitude_N, 10.0);
      EXPECT_LE(d.profile.amplitude_N, 35.0);
      EXPECT_EQ(d.direction.z(), 0.0);
      EXPECT_EQ(d.frame, Disturbance::Frame::kWorld);
      height(d);
    }
  }
}

// Over n uniform draws: the mean within 4 standard errors, 0.289 / sqrt(n), and no part of the range left out.
void expect_uniform(std::vector<double> shares) {
  const auto n = static_cast<double>(shares.size());
  double mean = 0.0;
  for (const double share : shares) mean += share / n;
  EXPECT_NEAR(mean, 0.5, 4.0 * 0.289 / std::sqrt(n));
  std::sort(shares.begin(), shares.end());
  double deviation = 0.0;  // Kolmogorov's: exceeds 1.95 / sqrt(n) once in a thousand
  for (std::size_t i = 0; i < shares.size(); ++i) {
    deviation = std::max(deviation, std::abs(shares[i] - (static_cast<double>(i) + 0.5) / n));
  }
  EXPECT_LT(deviation, 1.95 / std::sqrt(n));
}

TEST_F(RandomPushTest, LegsHeightsDirectionsAndMagnitudesAreUniform) {
  const std::vector<Disturbance> draws = draw(7, 1.0 + 2.0 * 4000);
  ASSERT_EQ(draws.size(), 4000u);
  PerLeg<int> count{};
  std::vector<double> heights, directions, magnitudes;
  for (const Disturbance& d : draws) {
    ++count[static_cast<std::size_t>(d.leg)];
    heights.push_back(height(d));
    directions.push_back(std::atan2(d.direction.y(), d.direction.x()) / (2.0 * std::numbers::pi) + 0.5);
    magnitudes.push_back((d.profile.amplitude_N - 10.0) / 25.0);
  }
  for (const int n : count) EXPECT_NEAR(n, 1000, 4 * 28);  // standard deviation sqrt(4000 / 4 * 3 / 4) = 27.4
  expect_uniform(heights);
  expect_uniform(directions);
  expect_uniform(magnitudes);
}

TEST_F(RandomPushTest, ASeedIsItsDrawsAndAnotherSeedOrStreamHasOthers) {
  EXPECT_TRUE(equal(draw(3), draw(3)));
  EXPECT_FALSE(equal(draw(3), draw(4)));
  EXPECT_FALSE(equal(draw(1), draw(2)));
  EXPECT_FALSE(equal(draw(3, 31.0, 0), draw(3, 31.0, 1)));
  EXPECT_FALSE(equal(draw(3), draw(3 + (1ULL << 32U))));
}

TEST_F(RandomPushTest, ALongerRunBeginsWithTheDrawsOfAShorterOne) {
  std::vector<Disturbance> longer = draw(5, 61.0);
  EXPECT_EQ(longer.size(), 30u);
  longer.resize(15);
  EXPECT_TRUE(equal(longer, draw(5, 31.0)));
}

TEST_F(RandomPushTest, EachDrawHoldsForExactlyItsTimeWithoutGapOrOverlap) {
  const std::vector<Disturbance> draws = draw(2);
  std::vector<int> ticks(draws.size(), 0);
  for (int k = 0; k < 31000; ++k) {
    int active = 0;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      if (!draws[i].profile.active(k * 1e-3)) continue;
      ++active;
      ++ticks[i];
    }
    ASSERT_EQ(active, k < 1000 ? 0 : 1) << "tick " << k;
  }
  for (const int n : ticks) EXPECT_EQ(n, 2000);
}

TEST_F(RandomPushTest, AWindowCutsTheLastDrawAndAnEndOnATickAddsNone) {
  push.duration_s = 5.0;
  const std::vector<Disturbance> draws = draw(2);
  ASSERT_EQ(draws.size(), 3u);
  EXPECT_EQ(draws[1].profile.duration_s, 2.0);
  EXPECT_NEAR(draws[2].profile.duration_s, 1.0, 1e-12);
  push.duration_s = 4.0;
  EXPECT_EQ(draw(2).size(), 2u);
  EXPECT_EQ(draw(2, 3.0).size(), 1u);
  EXPECT_EQ(draw(2, 1.0).size(), 0u);
}

TEST_F(RandomPushTest, OnlyTheGivenLegsAreDrawn) {
  push.legs = {Leg::kRF, Leg::kLH};
  PerLeg<int> count{};
  for (const Disturbance& d : draw(1, 801.0)) ++count[static_cast<std::size_t>(d.leg)];
  EXPECT_EQ(count[0] + count[3], 0);
  EXPECT_NEAR(count[1], 200, 40);  // 4 standard deviations of 10
  EXPECT_NEAR(count[2], 200, 40);
}

TEST_F(RandomPushTest, SaysWhatIsWrong) {
  const auto with = [this](const std::function<void(RandomPush&)>& change) {
    return [this, change] {
      RandomPush bad = push;
      change(bad);
      draw_pushes(bad, robot, 1, 0, 10.0);
    };
  };
  const auto message = [](const char* text) { return ThrowsMessage<std::invalid_argument>(HasSubstr(text)); };
  EXPECT_THAT(with([](RandomPush& p) { p.min_N = -1.0; }), message("min_N = -1, must be finite and >= 0"));
  EXPECT_THAT(with([](RandomPush& p) { p.max_N = 5.0; }), message("max_N = 5, must be finite and >= min_N"));
  EXPECT_THAT(with([](RandomPush& p) { p.hold_s = 0.0; }), message("hold_s = 0, must be finite and > 0"));
  EXPECT_THAT(with([](RandomPush& p) { p.start_s = std::nan(""); }), message("start_s = nan"));
  EXPECT_THAT(with([](RandomPush& p) { p.duration_s = 0.0; }), message("duration_s = 0, must be > 0"));
  EXPECT_THAT(with([](RandomPush& p) { p.legs.clear(); }), message("number of legs = 0"));
}

}  // namespace
}  // namespace dob::random_push_test
