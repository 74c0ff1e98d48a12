#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/results/campaign_run_samples.h"

namespace dob::campaign_factorial_test {
namespace {

using test::add_trials;
using test::SampleCampaign;
using ::testing::HasSubstr;

// Two observers by two sets of gains; letters as of add_trials, for none/soft, none/stiff, dob/soft, dob/stiff.
SampleCampaign factorial(const std::vector<std::string>& trials, const std::vector<double>& errors) {
  SampleCampaign sample = test::empty_campaign(CampaignKind::kFactorial, {});
  sample.campaign.factors = {"observer", "gains"};
  for (std::size_t i = 0; i < 4; ++i) {
    CellKey key = test::key("case1", "", i < 2 ? "none" : "dob", "-", 0);
    key.gains = i % 2 == 0 ? "soft" : "stiff";
    const std::size_t curve = sample.add_curve(key, {}, {key.observer, key.gains});
    add_trials(sample, curve, {0, 0}, trials[i], errors[i]);
  }
  return sample;
}

double share(const FactorialResult& result, const std::string& factor) {
  const auto found = std::find_if(result.shares.begin(), result.shares.end(),
                                  [&](const VarianceShare& share) { return share.factor == factor; });
  if (found == result.shares.end()) throw std::out_of_range("no share of " + factor);
  return found->share;
}

TEST(CampaignFactorialTest, FallsThatOneFactorDecidesAreItsShare) {
  const CampaignResult result = factorial({"ff", "ff", "ss", "ss"}, {0.1, 0.1, 0.1, 0.1}).result();
  ASSERT_EQ(result.factorial.size(), 2U);
  EXPECT_EQ(result.factorial[0].response, "falls");
  EXPECT_EQ(result.factorial[0].trials, 8);
  EXPECT_EQ(result.factorial[0].left_out, 0);
  EXPECT_NEAR(share(result.factorial[0], "observer"), 1.0, 1e-12);
  EXPECT_NEAR(share(result.factorial[0], "gains"), 0.0, 1e-12);
  EXPECT_NEAR(share(result.factorial[0], "observer x gains"), 0.0, 1e-12);
}

// log10 of the errors, the second seed twice the first one: effects of 2 (observer), 1 (gains) and log10 2 (seed),
// whose squares are their shares of the sum.
TEST(CampaignFactorialTest, ErrorsAreSharedOnALogarithmicScale) {
  const CampaignResult result = factorial({"ss", "ss", "ss", "ss"}, {1.0, 0.1, 0.01, 0.001}).result();
  EXPECT_TRUE(result.factorial[0].shares.empty());  // nobody fell
  EXPECT_EQ(result.factorial[0].trials, 8);
  const FactorialResult& errors = result.factorial[1];
  EXPECT_EQ(errors.response, "log CoM error");
  const double seed = std::pow(std::log10(2.0), 2), total = 4.0 + 1.0 + seed;
  EXPECT_NEAR(share(errors, "observer"), 4.0 / total, 1e-12);
  EXPECT_NEAR(share(errors, "gains"), 1.0 / total, 1e-12);
  EXPECT_NEAR(share(errors, "seed"), seed / total, 1e-12);
  EXPECT_NEAR(share(errors, "residual"), 0.0, 1e-12);
}

// The errors of the falls themselves, 0.5 m, are not looked at: the largest of a survivor is 0.1 m.
TEST(CampaignFactorialTest, FallCountsAsTheLargestErrorOfASurvivor) {
  const SampleCampaign with_fall = factorial({"f", "s", "s", "s"}, {9.0, 0.1, 0.01, 0.001});
  const SampleCampaign without = factorial({"s", "s", "s", "s"}, {0.1, 0.1, 0.01, 0.001});
  const CampaignResult a = with_fall.result(), b = without.result();
  EXPECT_EQ(a.factorial[1].trials, 4);
  EXPECT_EQ(a.factorial[1].left_out, 0);
  for (const char* factor : {"observer", "gains", "observer x gains"}) {
    EXPECT_DOUBLE_EQ(share(a.factorial[1], factor), share(b.factorial[1], factor)) << factor;
  }
}

TEST(CampaignFactorialTest, CellsThatCouldNotBeRunAreCountedWithTheSeedsThatTheyTakeAlong) {
  const CampaignResult result = factorial({"fsf", "ffe", "sss", "sss"}, {0.1, 0.1, 0.1, 0.1}).result();
  EXPECT_EQ(result.factorial[0].trials, 8);    // the third seed is gone
  EXPECT_EQ(result.factorial[0].left_out, 4);  // the error, and three that have no partner there
}

TEST(CampaignFactorialTest, SeedsThatHaveNotBeenRunAreLeftOut) {
  const CampaignResult result = factorial({"ff.", "ss.", "fs.", "ss."}, {0.1, 0.1, 0.1, 0.1}).result();
  EXPECT_EQ(result.factorial[0].trials, 8);
  EXPECT_EQ(result.factorial[0].left_out, 4);
  EXPECT_EQ(result.planned, 12U);
}

TEST(CampaignFactorialTest, SurvivorWithoutAnErrorHasNoValue) {
  SampleCampaign sample = factorial({"ss", "ss", "ss", "ss"}, {0.1, 0.2, 0.3, 0.4});
  sample.run.cells[1].metrics.com_error_max_m = std::nullopt;
  sample.run.cells[3].metrics.com_error_max_m = 0.0;  // has no logarithm
  const CampaignResult result = sample.result();
  EXPECT_EQ(result.factorial[0].left_out, 0);
  EXPECT_EQ(result.factorial[1].trials, 4);
  EXPECT_EQ(result.factorial[1].left_out, 4);
}

TEST(CampaignFactorialTest, CampaignWithoutATrialHasNoShares) {
  const CampaignResult result = factorial({".", ".", ".", "e"}, {0.1, 0.1, 0.1, 0.1}).result();
  for (const FactorialResult& response : result.factorial) {
    EXPECT_TRUE(response.shares.empty());
    EXPECT_EQ(response.trials, 0);
    EXPECT_EQ(response.left_out, 4);
  }
}

TEST(CampaignFactorialTest, OtherKindsHaveNone) {
  SampleCampaign sample = factorial({"s", "s", "s", "s"}, {0.1, 0.1, 0.1, 0.1});
  sample.campaign.kind = CampaignKind::kLimit;
  EXPECT_TRUE(sample.result().factorial.empty());
}

TEST(CampaignFactorialTest, RefusesCurvesThatAreNoDesign) {
  SampleCampaign sample = factorial({"s", "s", "s", "s"}, {0.1, 0.1, 0.1, 0.1});
  sample.campaign.curves[1].factors = sample.campaign.curves[0].factors;
  try {
    sample.result();
    FAIL() << "two curves at one place of the design";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("same levels of the factors: none, soft"));
  }
  sample.campaign.curves[1].factors = {"none"};
  EXPECT_THROW(sample.result(), std::invalid_argument);
}

}  // namespace
}  // namespace dob::campaign_factorial_test
