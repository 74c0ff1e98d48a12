#include "bench/progress.h"

#include <gtest/gtest.h>

namespace dob::progress_test {
namespace {

CellResult ended(Outcome outcome) {
  CellResult cell;
  cell.outcome = outcome;
  return cell;
}

TEST(Progress, CountsCellsFallsAndErrorsAndForeseesTheEndFromTheWorkDone) {
  Progress progress(10, 4, 60.0, false);
  EXPECT_EQ(progress.line(0.0), "4/10 cells, 0 falls, 0 errors");
  progress.add(ended(Outcome::kFell), 10.0);
  progress.add(ended(Outcome::kError), 10.0);
  EXPECT_EQ(progress.line(30.0), "6/10 cells, 1 fall, 1 error, 60 s left");
  progress.add(ended(Outcome::kSurvived), 10.0);
  EXPECT_EQ(progress.line(600.0), "7/10 cells, 1 fall, 1 error, 10 min left");
}

}  // namespace
}  // namespace dob::progress_test
