#include "observers/momentum_gains.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dob::momentum_gains_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using Complex = std::complex<double>;

const MomentumGains kPrinted{{17.5, 6.28, 2.25}};  // section 5.1
const MomentumGains kReversed{{2.25, 6.28, 17.5}};

MomentumGains random_gains(std::mt19937_64& random, int order) {
  std::uniform_real_distribution<double> decades(-1.0, 2.0);
  MomentumGains gains;
  for (int i = 0; i < order; ++i) gains.K.push_back(std::pow(10.0, decades(random)));
  return gains;
}

// G(s) by solving the block diagram of (6)-(7) instead of its polynomial:
// s gamma_1 = K_1 (F - y), s gamma_i = K_i (gamma_(i-1) - y), y = gamma_r, hence gamma_i = a_i F - b_i y.
Complex transfer(const MomentumGains& gains, Complex s) {
  Complex a = 1.0;
  Complex b = 0.0;
  for (const double K : gains.K) {
    a *= K / s;
    b = K / s * (b + 1.0);
  }
  return a / (1.0 + b);
}

// c_0 ... c_(r-1) of the polynomial with the given roots.
std::vector<double> from_roots(const std::vector<Complex>& roots) {
  std::vector<Complex> p{1.0};
  for (const Complex root : roots) {
    p.emplace_back(0.0);
    for (std::size_t j = p.size() - 1; j > 0; --j) p[j] = p[j - 1] - root * p[j];
    p[0] *= -root;
  }
  std::vector<double> c;
  for (std::size_t j = 0; j + 1 < p.size(); ++j) c.push_back(p[j].real());
  return c;
}

TEST(MomentumGains, CoefficientsAreThoseOfTheBlockDiagram) {
  std::mt19937_64 random{1};
  for (int order = 1; order <= kMaxMomentumOrder; ++order) {
    const MomentumGains gains = random_gains(random, order);
    const std::vector<double> c = coefficients(gains);
    for (const Complex s : {Complex(0.3, 2.0), Complex(5.0, -1.0), Complex(0.0, 40.0)}) {
      Complex denominator = std::pow(s, order);
      for (int j = 0; j < order; ++j) denominator += c[j] * std::pow(s, j);
      const Complex G = transfer(gains, s);
      EXPECT_LE(std::abs(c[0] / denominator - G), 1e-12 * std::abs(G)) << "order " << order;
    }
  }
}

TEST(MomentumGains, CoefficientsAndBackGiveTheSameGains) {
  std::mt19937_64 random{2};
  for (int order = 1; order <= kMaxMomentumOrder; ++order) {
    const MomentumGains gains = random_gains(random, order);
    const MomentumGains back = gains_from_coefficients(coefficients(gains));
    ASSERT_EQ(back.K.size(), gains.K.size());
    for (int i = 0; i < order; ++i) EXPECT_NEAR(back.K[i] / gains.K[i], 1.0, 1e-14);
  }
}

TEST(MomentumGains, PolesAreTheRootsTheyWereDesignedFrom) {
  const std::vector<Complex> roots{{-2.0, 0.0}, {-3.0, 7.0}, {-3.0, -7.0}, {-25.0, 1.0}, {-25.0, -1.0}, {-400.0, 0.0}};
  const std::vector<Complex> p = poles(gains_from_coefficients(from_roots(roots)));
  ASSERT_EQ(p.size(), roots.size());
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_LE(std::abs(p[i] - roots[i]), 1e-9 * std::abs(roots[i])) << i;
}

TEST(MomentumGains, PrintedGainsAreUnstableAndReversedOnesAreStable) {
  // Vieta, for s^3 + 2.25 s^2 + 2.25 6.28 s + 2.25 6.28 17.5
  const std::vector<Complex> p = poles(kPrinted);
  EXPECT_NEAR((p[0] + p[1] + p[2]).real(), -2.25, 1e-12);
  EXPECT_NEAR((p[0] * p[1] + p[1] * p[2] + p[2] * p[0]).real(), 2.25 * 6.28, 1e-12);
  EXPECT_NEAR((p[0] * p[1] * p[2]).real(), -2.25 * 6.28 * 17.5, 1e-10);
  EXPECT_NEAR(p[0].real(), 2.013, 1e-3);
  EXPECT_NEAR(p[0].imag(), 5.945, 1e-3);
  EXPECT_FALSE(routh(kPrinted).stable);
  EXPECT_LT(poles(kReversed).front().real(), 0.0);
  EXPECT_TRUE(routh(kReversed).stable);
}

TEST(MomentumGains, ReversedGainsHaveOneHertzNaturalFrequencyButLessBandwidth) {
  EXPECT_NEAR(natural_frequency(kReversed), std::cbrt(2.25 * 6.28 * 17.5), 1e-14);
  EXPECT_NEAR(natural_frequency(kReversed), 6.28, 5e-3);
  EXPECT_NEAR(bandwidth(kReversed) / (2.0 * std::numbers::pi), 0.573, 5e-4);
}

// Case 3 pushes for 0.2 s. Step response 1 + sum_k c_0 e^(p_k t) / (p_k prod_(j != k) (p_k - p_j)).
TEST(MomentumGains, ReversedGainsSeeASeventhOfAPushWithin200Milliseconds) {
  const std::vector<Complex> p = poles(kReversed);
  Complex step = 1.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    Complex residue = coefficients(kReversed)[0] / p[k];
    for (std::size_t j = 0; j < p.size(); ++j) {
      if (j != k) residue /= p[k] - p[j];
    }
    step += residue * std::exp(p[k] * 0.2);
  }
  EXPECT_NEAR(step.imag(), 0.0, 1e-12);
  EXPECT_NEAR(step.real(), 0.13924, 5e-6);  // (5) integrated by steps of 10 us, to as many digits
}

TEST(Routh, ArrayOfThirdOrderIsTheTextbookOne) {
  const RouthArray array = routh(kPrinted);
  const double c2 = 2.25, c1 = 2.25 * 6.28, c0 = 2.25 * 6.28 * 17.5;
  ASSERT_EQ(array.rows.size(), 4u);
  EXPECT_EQ(array.rows[0], (std::vector<double>{1.0, c1}));
  EXPECT_EQ(array.rows[1], (std::vector<double>{c2, c0}));
  EXPECT_NEAR(array.rows[2][0], c1 - c0 / c2, 1e-12);
  EXPECT_NEAR(array.rows[3][0], c0, 1e-10);
}

TEST(Routh, ThirdOrderNeedsTheLastGainAboveTheFirst) {
  EXPECT_TRUE(routh({{6.0, 6.28, 6.001}}).stable);
  EXPECT_FALSE(routh({{6.0, 6.28, 5.999}}).stable);
  EXPECT_FALSE(routh({{6.28, 6.28, 6.28}}).stable) << "marginal";
}

TEST(Routh, AgreesWithThePolesAtRandomGains) {
  std::mt19937_64 random{3};
  int stable = 0;
  constexpr int kTrials = 4000;
  for (int i = 0; i < kTrials; ++i) {
    const MomentumGains gains = random_gains(random, 1 + i % kMaxMomentumOrder);
    const Complex slowest = poles(gains).front();
    if (std::abs(slowest.real()) < 1e-9 * std::abs(slowest)) continue;  // too close to call for either
    EXPECT_EQ(routh(gains).stable, slowest.real() < 0.0) << slowest;
    stable += routh(gains).stable ? 1 : 0;
  }
  EXPECT_GT(stable, kTrials / 4);
  EXPECT_LT(stable, 3 * kTrials / 4);
}

TEST(Bandwidth, IsTheGainOfAFirstOrderFilter) {
  EXPECT_NEAR(bandwidth({{9.0}}), 9.0, 1e-12);
}

TEST(Bandwidth, IsTheCutoffOfAButterworthFilterOfAnyOrder) {
  for (int order = 1; order <= kMaxMomentumOrder; ++order) {
    std::vector<Complex> roots(order);
    for (int k = 0; k < order; ++k) {
      roots[k] = std::polar(30.0, std::numbers::pi * (0.5 + (2.0 * k + 1.0) / (2.0 * order)));
    }
    EXPECT_NEAR(bandwidth(gains_from_coefficients(from_roots(roots))), 30.0, 1e-9) << "order " << order;
  }
}

TEST(Bandwidth, IsTheFirstOfSeveralCrossings) {
  // A slow pole at 1 rad/s and a resonance at 10 rad/s that lifts |G| above 1/sqrt(2) again.
  const MomentumGains gains = gains_from_coefficients(from_roots({{-1.0, 0.0}, {-0.01, 10.0}, {-0.01, -10.0}}));
  const auto magnitude = [&](double w) { return std::abs(transfer(gains, {0.0, w})); };
  const double w = bandwidth(gains);
  EXPECT_NEAR(magnitude(w), std::numbers::sqrt2 / 2.0, 1e-12);
  for (int k = 0; k < 1000; ++k) EXPECT_GT(magnitude(w * (k + 0.5) / 1000.0), std::numbers::sqrt2 / 2.0);
  EXPECT_LT(magnitude(5.0), 0.5);
  EXPECT_GT(magnitude(10.0), 4.0);
}

TEST(Bandwidth, ScalesWithTheGains) {
  EXPECT_NEAR(bandwidth(scale(kReversed, 20.0)) / bandwidth(kReversed), 20.0, 1e-12);
}

TEST(DiscreteStability, LimitOfFirstOrderIsTheClosedForm) {
  EXPECT_NEAR(largest_stable_dt({{50.0}}), 2.0 / 50.0, 1e-15);
}

TEST(DiscreteStability, LimitOfSecondOrderIsTheClosedForm) {
  // Jury: z^2 + (a_2 + a_1 a_2 - 2) z + 1 - a_2 with a_i = dt K_i is stable for 4 - 2 a_2 - a_1 a_2 > 0, a_2
  // < 2.
  for (const auto& [K1, K2] : {std::pair{3.0, 20.0}, {20.0, 3.0}, {7.0, 7.0}}) {
    const double closed = (-2.0 * K2 + std::sqrt(4.0 * K2 * K2 + 16.0 * K1 * K2)) / (2.0 * K1 * K2);
    EXPECT_NEAR(largest_stable_dt({{K1, K2}}) / closed, 1.0, 1e-12);
  }
}

TEST(DiscreteStability, LimitIsWhereTheSpectralRadiusReachesOne) {
  std::mt19937_64 random{4};
  int checked = 0;
  for (int i = 0; i < 80; ++i) {
    const MomentumGains gains = random_gains(random, 1 + i % 6);
    if (!routh(gains).stable) {
      EXPECT_EQ(largest_stable_dt(gains), 0.0);
      continue;
    }
    const double dt = largest_stable_dt(gains);
    EXPECT_LE(dt, 2.0 / gains.K.back() * (1.0 + 1e-12));
    EXPECT_NEAR(spectral_radius(gains, dt), 1.0, 1e-6);
    EXPECT_GT(spectral_radius(gains, 1.001 * dt), 1.0);
    for (int k = 1; k < 20; ++k) {
      EXPECT_LT(spectral_radius(gains, 0.05 * k * dt), 1.0) << "order " << gains.K.size() << " at " << 0.05 * k;
    }
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

TEST(DiscreteStability, LimitIsTheFirstCrossingWhereALargerTickIsStableAgain) {
  const MomentumGains gains{{44.02, 2.525, 76.49, 6.608}};
  EXPECT_LT(spectral_radius(gains, 0.052), 1.0);
  EXPECT_GT(spectral_radius(gains, 0.055), 1.0);
  EXPECT_LT(spectral_radius(gains, 0.058), 1.0);
  EXPECT_NEAR(largest_stable_dt(gains), 0.05225, 1e-5);
}

TEST(DiscreteStability, StateMatrixHasThePolesInItsLimit) {
  const double dt = 1e-6;
  EXPECT_NEAR((1.0 - spectral_radius(kReversed, dt)) / dt, -poles(kReversed).front().real(), 1e-4);
}

TEST(CheckStability, RefusesThePrintedGainsWithTheirPoles) {
  EXPECT_THAT(check_stability(kPrinted, 1e-3), AllOf(HasSubstr("continuous"), HasSubstr("+2.01 +- 5.95j, -6.28")));
  EXPECT_EQ(check_stability(kReversed, 1e-3), "");
}

TEST(CheckStability, RefusesGainsThatTheTickCannotHold) {
  EXPECT_EQ(check_stability(scale(kReversed, 87.0), 1e-3), "");
  EXPECT_THAT(
      check_stability(scale(kReversed, 88.0), 1e-3),
      AllOf(HasSubstr("tick of 1 ms"), HasSubstr("spectral radius 1.0"), HasSubstr("largest stable tick 0.99")));
}

TEST(CheckGains, RefusesWhatIsNoSetOfGains) {
  EXPECT_EQ(check_gains(kPrinted), "");
  EXPECT_THAT(check_gains({}), HasSubstr("0 gains"));
  EXPECT_THAT(check_gains({std::vector<double>(9, 1.0)}), HasSubstr("9 gains"));
  EXPECT_THAT(check_gains({{1.0, 0.0}}), HasSubstr("K_2 = 0"));
  EXPECT_THAT(check_gains({{std::nan("")}}), HasSubstr("K_1 = nan"));
}

}  // namespace
}  // namespace dob::momentum_gains_test
