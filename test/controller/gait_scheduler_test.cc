#include "controller/gait_scheduler.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dob::gait_scheduler_test {
namespace {

constexpr double kDt = 1e-3;

Vec12 contact(const PerLeg<bool>& touching) {
  Vec12 f = Vec12::Zero();
  for (int l = 0; l < kLegs; ++l) f[3 * l + 2] = touching[l] ? 50.0 : 0.0;
  return f;
}

// Ideal ground: a foot touches whenever it is not swinging or its swing time is over.
PerLeg<bool> ideal(const GaitState& s, double swing_duration) {
  PerLeg<bool> touching{};
  for (int l = 0; l < kLegs; ++l) touching[l] = s.stands(l) || s.swing_time[l] >= swing_duration - 1.5 * kDt;
  return touching;
}

TEST(GaitScheduler, TrotRepeatsEveryStancePlusSwingWithAlternatingDiagonals) {
  GaitScheduler gait(GaitOptions{});
  std::vector<int> lift_off_ticks;
  std::vector<bool> lf;
  for (int k = 0; k < 2000; ++k) {
    const GaitState& s = gait.update(kDt, contact(ideal(gait.state(), 0.115)));
    EXPECT_EQ(s.stands(0), s.stands(3));
    EXPECT_EQ(s.stands(1), s.stands(2));
    EXPECT_TRUE(s.stands(0) || s.stands(1));
    if (s.lift_off[0] || s.lift_off[1]) {
      lift_off_ticks.push_back(k);
      lf.push_back(s.lift_off[0]);
    }
  }
  ASSERT_EQ(lift_off_ticks.size(), 7U);  // (2 - 0.15) / 0.265
  EXPECT_EQ(lift_off_ticks[0], 150);
  for (std::size_t i = 1; i < lift_off_ticks.size(); ++i) {
    EXPECT_EQ(lift_off_ticks[i] - lift_off_ticks[i - 1], 265);
    EXPECT_NE(lf[i], lf[i - 1]);
  }
}

TEST(GaitScheduler, ContactCountsAsTouchdownOnlyInTheLastPartOfTheSwing) {
  GaitScheduler gait(GaitOptions{});
  const PerLeg<bool> always{true, true, true, true};
  int lift_off = -1, touchdown = -1;
  for (int k = 0; k < 265 && touchdown < 0; ++k) {
    const GaitState& s = gait.update(kDt, contact(always));
    if (s.lift_off[0]) lift_off = k;
    if (s.touchdown[0]) touchdown = k;
  }
  EXPECT_EQ(lift_off, 150);
  EXPECT_EQ(touchdown - lift_off, 65);  // 0.115 - 0.05 s
}

TEST(GaitScheduler, LiftOffWaitsForALateFootButNotForEver) {
  GaitScheduler gait(GaitOptions{});
  const PerLeg<bool> never_lf{false, true, true, true};
  int second_lift_off = -1;
  for (int k = 0; k < 1000 && second_lift_off < 0; ++k) {
    const GaitState& s = gait.update(kDt, contact(never_lf));
    if (k > 300 && k < 500) {
      EXPECT_EQ(s.phase[0], LegPhase::kLate);
    }
    if (s.lift_off[1]) second_lift_off = k;
  }
  EXPECT_EQ(second_lift_off, 150 + 115 + 150 + 100);
}

TEST(GaitScheduler, InitialPhaseAndDiagonalAreWhatResetSays) {
  GaitScheduler gait(GaitOptions{});
  gait.reset(0.1, 1);
  int lift_off = -1;
  for (int k = 0; k < 100 && lift_off < 0; ++k) {
    if (gait.update(kDt, contact({true, true, true, true})).lift_off[1]) lift_off = k;
  }
  EXPECT_EQ(lift_off, 50);
}

GaitPattern crawl() {
  return {.gait = Gait::kCrawl, .stance_duration = 0.5, .swing_duration = 0.3};
}

TEST(GaitScheduler, CrawlLiftsOneFootAtATimeInTheOrderLhLfRhRf) {
  GaitScheduler gait({.pattern = crawl()});
  std::vector<int> order, ticks;
  for (int k = 0; k < 4000; ++k) {
    const GaitState& s = gait.update(kDt, contact(ideal(gait.state(), 0.3)));
    EXPECT_GE(std::count(s.phase.begin(), s.phase.end(), LegPhase::kStance), 3);
    for (int l = 0; l < kLegs; ++l) {
      if (s.lift_off[l]) order.push_back(l);
    }
    if (s.lifts_off()) ticks.push_back(k);
  }
  const int LF = 0, RF = 1, LH = 2, RH = 3;
  ASSERT_EQ(order, (std::vector<int>{LH, LF, RH, RF, LH}));
  for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_EQ(ticks[i] - ticks[i - 1], 800);
}

TEST(GaitScheduler, LiftOffWaitsForBalanceButNotForEver) {
  for (const int balanced_from : {550, 5000}) {
    GaitScheduler gait({.pattern = crawl()});
    int lift_off = -1;
    for (int k = 0; k < 1000 && lift_off < 0; ++k) {
      if (gait.update(kDt, contact({true, true, true, true}), k >= balanced_from).lifts_off()) lift_off = k;
    }
    EXPECT_EQ(lift_off, std::min(balanced_from, 600));  // late_wait is 0.1 s
  }
}

TEST(GaitScheduler, StandNeverLiftsAFoot) {
  GaitScheduler gait({.pattern = {.gait = Gait::kStand}});
  int begins = 0;
  for (int k = 0; k < 2000; ++k) {
    const GaitState& s = gait.update(kDt, contact({true, true, true, true}));
    begins += s.footstep_begins ? 1 : 0;
    EXPECT_FALSE(s.lifts_off());
  }
  EXPECT_EQ(begins, 1);
}

TEST(GaitScheduler, GaitChangesAtTheFirstFullStanceAfterTheSwitch) {
  // 0.2 s falls into the first swing (0.15 to 0.265 s); LF lands late, at 0.3 s.
  GaitScheduler gait({.switches = {{0.2, crawl()}, {3.0, {.gait = Gait::kStand}}}});
  double to_crawl = -1.0, to_stand = -1.0;
  for (int k = 0; k < 6000; ++k) {
    const double t = k * kDt;
    PerLeg<bool> touching = ideal(gait.state(), gait.state().pattern.swing_duration);
    if (t < 0.3) touching[0] = t < 0.15;
    const GaitState& s = gait.update(kDt, contact(touching));
    if (to_crawl < 0.0 && s.pattern.gait == Gait::kCrawl) {
      to_crawl = t;
      EXPECT_TRUE(s.footstep_begins);
      EXPECT_EQ(s.step, 0);
      for (int l = 0; l < kLegs; ++l) EXPECT_TRUE(s.stands(l));
    }
    if (to_stand < 0.0 && s.pattern.gait == Gait::kStand) {
      to_stand = t;
      for (int l = 0; l < kLegs; ++l) EXPECT_TRUE(s.stands(l));
    }
  }
  EXPECT_NEAR(to_crawl, 0.3, 0.002);
  EXPECT_GE(to_stand, 3.0);
  EXPECT_LT(to_stand, 3.8);
}

TEST(GaitScheduler, RefusesOptionsByName) {
  GaitOptions options;
  options.early_touchdown_window = 0.2;
  try {
    const GaitScheduler gait(options);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("early_touchdown_window_s = 0.2"), std::string::npos);
  }
}

}  // namespace
}  // namespace dob::gait_scheduler_test
