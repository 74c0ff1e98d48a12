#include "bench/state_hash.h"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace dob::state_hash_test {
namespace {

RobotState some_state() {
  RobotState s;
  s.p_WB << 0.1, -0.2, 0.3;
  s.R_WB.setIdentity();
  s.v_WB << 0.4, 0.5, -0.6;
  s.omega_WB << 0.7, -0.8, 0.9;
  for (int i = 0; i < kJoints; ++i) {
    s.q[i] = 1.0 + i;
    s.qd[i] = -1.0 - i;
  }
  return s;
}

// Every number of a state, by reference.
std::vector<double*> numbers(RobotState& s) {
  std::vector<double*> list;
  const auto add = [&list](auto& v) {
    for (int i = 0; i < v.size(); ++i) list.push_back(v.data() + i);
  };
  add(s.p_WB);
  add(s.R_WB);
  add(s.v_WB);
  add(s.omega_WB);
  add(s.q);
  add(s.qd);
  return list;
}

TEST(StateHash, TheLastBitOfEveryNumberCounts) {
  RobotState s = some_state();
  std::set<std::uint64_t> hashes{hash_state(kNoStates, s)};
  for (double* x : numbers(s)) {
    const double before = *x;
    *x = std::nextafter(before, 1e9);
    EXPECT_TRUE(hashes.insert(hash_state(kNoStates, s)).second);
    *x = before;
  }
  EXPECT_EQ(hashes.size(), 1U + 3 + 9 + 3 + 3 + 2 * kJoints);
}

// A mirrored trajectory differs in nothing but signs.
TEST(StateHash, TwoChangedSignsDoNotCancel) {
  RobotState s = some_state();
  std::set<std::uint64_t> hashes{hash_state(kNoStates, s)};
  const std::vector<double*> list = numbers(s);
  for (std::size_t i = 1; i < list.size(); ++i) {
    *list[0] = -*list[0];
    *list[i] = -*list[i];
    EXPECT_TRUE(hashes.insert(hash_state(kNoStates, s)).second) << i;
    *list[0] = -*list[0];
    *list[i] = -*list[i];
  }
}

TEST(StateHash, TheOrderOfStatesCounts) {
  const RobotState a = some_state();
  RobotState b = a;
  b.p_WB.x() = 2.0;
  EXPECT_NE(hash_state(hash_state(kNoStates, a), b), hash_state(hash_state(kNoStates, b), a));
}

}  // namespace
}  // namespace dob::state_hash_test
