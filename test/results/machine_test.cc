#include "results/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::machine_test {
namespace {

TEST(MachineTest, NamesProcessorCoresAndSystem) {
  const Machine machine = this_machine();
  EXPECT_THAT(machine.cpu, ::testing::Not(::testing::IsEmpty()));
  EXPECT_GE(machine.cores, 1);
  EXPECT_THAT(machine.os, ::testing::HasSubstr(", Linux "));
}

TEST(MachineTest, WritesTheDateInUtc) {
  EXPECT_THAT(utc_now(),
              ::testing::MatchesRegex("20[0-9][0-9]-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5][0-9]:[0-6][0-9]Z"));
}

}  // namespace
}  // namespace dob::machine_test
