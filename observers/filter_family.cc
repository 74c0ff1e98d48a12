#include "observers/filter_family.h"

#include <cmath>
#include <numbers>

namespace dob {
namespace {

// Ratios c_j / c_(j+1) of neighbouring coefficients are the gains K_(j+1), so that no large coefficient is formed.
// n = order, 0 <= j < n.

// theta_n(s) = sum_j (2n - j)! / (2^(n-j) j! (n-j)!) s^j
double bessel_gain(int n, int j) {
  return 0.5 * (2 * n - j) * (j + 1) / (n - j);
}

// c_(j+1) / c_j = cos(j pi / 2n) / sin((j+1) pi / 2n)
double butterworth_gain(int n, int j) {
  const double step = std::numbers::pi / (2.0 * n);
  return std::sin((j + 1) * step) / std::cos(j * step);
}

// (s + 1)^n
double binomial_gain(int n, int j) {
  return static_cast<double>(j + 1) / (n - j);
}

}  // namespace

MomentumGains family_gains(FilterFamily family, int order, double bandwidth) {
  MomentumGains prototype;
  for (int j = 0; j < order; ++j) {
    switch (family) {
      case FilterFamily::kBessel:
        prototype.K.push_back(bessel_gain(order, j));
        break;
      case FilterFamily::kButterworth:
        prototype.K.push_back(butterworth_gain(order, j));
        break;
      case FilterFamily::kBinomial:
        prototype.K.push_back(binomial_gain(order, j));
        break;
    }
  }
  return scale(prototype, bandwidth / dob::bandwidth(prototype));
}

}  // namespace dob
