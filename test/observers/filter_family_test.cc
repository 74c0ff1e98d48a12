#include "observers/filter_family.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observers/momentum.h"

namespace dob::filter_family_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Complex = std::complex<double>;

constexpr double kWidth = 36.0;  // [rad/s]

TEST(FilterFamily, HasTheStatedBandwidthAtEveryOrderAndIsStable) {
  for (const FilterFamily family : {FilterFamily::kBessel, FilterFamily::kButterworth, FilterFamily::kBinomial}) {
    for (int order = 1; order <= kMaxMomentumOrder; ++order) {
      const MomentumGains gains = family_gains(family, order, kWidth);
      ASSERT_EQ(static_cast<int>(gains.K.size()), order);
      EXPECT_TRUE(routh(gains).stable);
      // |G| itself, from the coefficients of (5)
      const std::vector<double> c = coefficients(gains);
      Complex denominator = std::pow(Complex(0.0, kWidth), order);
      for (int j = 0; j < order; ++j) denominator += c[j] * std::pow(Complex(0.0, kWidth), j);
      EXPECT_NEAR(std::abs(c[0] / denominator), std::numbers::sqrt2 / 2.0, 1e-12) << "order " << order;
    }
  }
}

TEST(FilterFamily, ButterworthHasItsPolesEvenlyOnAHalfCircle) {
  for (int order = 1; order <= kMaxMomentumOrder; ++order) {
    for (const Complex pole : poles(family_gains(FilterFamily::kButterworth, order, kWidth))) {
      // s^(2n) = -(-1)^n w^(2n) for every pole
      const Complex power = std::pow(pole / kWidth, 2 * order);
      EXPECT_NEAR(std::abs(power - (order % 2 == 0 ? -1.0 : 1.0)), 0.0, 1e-10) << "order " << order;
      EXPECT_LT(pole.real(), 0.0);
    }
  }
}

// The frequency scale is the filter's own; up to it the polynomials are the tabulated ones.
void expect_coefficients(FilterFamily family, const std::vector<double>& tabulated) {
  const int order = static_cast<int>(tabulated.size());
  const std::vector<double> c = coefficients(family_gains(family, order, kWidth));
  const double scale = std::pow(c[0] / tabulated[0], 1.0 / order);
  for (int j = 0; j < order; ++j) EXPECT_NEAR(c[j] / std::pow(scale, order - j) / tabulated[j], 1.0, 1e-12) << j;
}

TEST(FilterFamily, BesselHasTheReverseBesselPolynomials) {
  expect_coefficients(FilterFamily::kBessel, {3, 3});
  expect_coefficients(FilterFamily::kBessel, {15, 15, 6});
  expect_coefficients(FilterFamily::kBessel, {105, 105, 45, 10});
  expect_coefficients(FilterFamily::kBessel, {945, 945, 420, 105, 15});
}

TEST(FilterFamily, BinomialIsRepeatedFirstOrder) {
  expect_coefficients(FilterFamily::kBinomial, {1, 2});
  expect_coefficients(FilterFamily::kBinomial, {1, 3, 3});
  expect_coefficients(FilterFamily::kBinomial, {1, 5, 10, 10, 5});
  for (int order = 1; order <= 4; ++order) {
    const double a = kWidth / std::sqrt(std::pow(2.0, 1.0 / order) - 1.0);  // of r equal poles: closed form
    const std::vector<double> c = coefficients(family_gains(FilterFamily::kBinomial, order, kWidth));
    EXPECT_NEAR(std::pow(c[0], 1.0 / order) / a, 1.0, 1e-12);
  }
}

TEST(MomentumOptions, TakeAFamily) {
  const ObserverOptions options{{"family", std::string("butterworth")}, {"order", 2.0}, {"bandwidth_rad_s", 10.0}};
  const MomentumGains gains = read_momentum_options(options).gains;
  ASSERT_EQ(gains.K.size(), 2u);
  EXPECT_NEAR(gains.K[1], 10.0 * std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(gains.K[0] * gains.K[1], 100.0, 1e-11);
}

TEST(MomentumOptions, TakeCoefficients) {
  // (s + 2)(s + 3)(s + 4)
  const ObserverOptions options{{"coefficients", std::vector<double>{24.0, 26.0, 9.0}}, {"gain_scale", 2.0}};
  const MomentumOptions read = read_momentum_options(options);
  const std::vector<Complex> p = poles(read.gains);
  ASSERT_EQ(p.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::abs(p[i] + (2.0 + i)), 0.0, 1e-10);
  EXPECT_EQ(read.gain_scale, 2.0);
}

TEST(MomentumOptions, TakeOneWayToGiveTheGainsOnly) {
  const std::vector<double> list{1.0, 2.0};
  const OptionValue bessel = std::string("bessel");
  const auto reading = [](const ObserverOptions& options) { return [options] { read_momentum_options(options); }; };
  const auto says = [](const char* one, const char* other) {
    return ThrowsMessage<OptionError>(AllOf(HasSubstr(one), HasSubstr(other)));
  };
  EXPECT_THAT(reading({{"gains", list}, {"coefficients", list}}), says("coefficients = 1;2", "gains is given as well"));
  EXPECT_THAT(reading({{"coefficients", list}, {"family", bessel}, {"order", 2.0}, {"bandwidth_rad_s", 1.0}}),
              says("family = \"bessel\"", "allowed is one of gains, coefficients, family"));
  EXPECT_THAT(reading({{"family", bessel}, {"order", 2.0}}), says("family", "needs bandwidth_rad_s"));
  EXPECT_THAT(reading({{"family", bessel}, {"bandwidth_rad_s", 2.0}}), says("family", "needs order"));
  EXPECT_THAT(reading({{"family", bessel}, {"order", 2.0}, {"bandwidth_rad_s", 2.0}, {"gain_scale", 2.0}}),
              says("gain_scale = 2", "bandwidth_rad_s"));
  EXPECT_THAT(reading({{"bandwidth_rad_s", 2.0}}), says("bandwidth_rad_s = 2", "family"));
  EXPECT_THAT(reading({{"family", std::string("chebyshev")}}), says("chebyshev", "bessel, butterworth, binomial"));
  EXPECT_THAT(reading({{"coefficients", list}, {"order", 3.0}}), says("order = 3", "c_0;...;c_2, there are 2"));
  EXPECT_THAT(reading({{"gian", 1.0}}), says("gian", "bandwidth_rad_s, coefficients, coriolis, family, gain_scale"));
}

}  // namespace
}  // namespace dob::filter_family_test
