#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "bench/verify.h"

namespace dob::draw_sample_test {
namespace {

TEST(DrawSample, IsInOrderWithoutRepetitionAndTheSameForTheSameSeed) {
  const std::vector<std::size_t> sample = draw_sample(1000, 50, 7);
  EXPECT_EQ(sample.size(), 50U);
  EXPECT_TRUE(std::is_sorted(sample.begin(), sample.end()));
  EXPECT_EQ(std::set<std::size_t>(sample.begin(), sample.end()).size(), 50U);
  EXPECT_LT(sample.back(), 1000U);
  EXPECT_EQ(sample, draw_sample(1000, 50, 7));
  EXPECT_NE(sample, draw_sample(1000, 50, 8));
}

TEST(DrawSample, ZeroOrMoreThanThereAreIsAll) {
  std::vector<std::size_t> all(5);
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(draw_sample(5, 0, 1), all);
  EXPECT_EQ(draw_sample(5, 9, 1), all);
  EXPECT_TRUE(draw_sample(0, 3, 1).empty());
}

// Five standard deviations of a binomial count around its mean, for the first, a middle and the last cell.
TEST(DrawSample, EveryCellIsDrawnAsOften) {
  constexpr int kDraws = 4000;
  std::vector<int> drawn(10, 0);
  for (int seed = 1; seed <= kDraws; ++seed) {
    for (const std::size_t cell : draw_sample(10, 3, seed)) ++drawn[cell];
  }
  for (const int count : drawn) EXPECT_NEAR(count, 0.3 * kDraws, 145);
}

}  // namespace
}  // namespace dob::draw_sample_test
