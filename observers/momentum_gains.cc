#include "observers/momentum_gains.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace dob {
namespace {

using Complex = std::complex<double>;
using Rates = Eigen::EigenSolver<MomentumMatrix>::EigenvalueType;

int order(const MomentumGains& gains) {
  return static_cast<int>(gains.K.size());
}

// D = (A - I) / dt of the discrete update: no cancellation at small dt, and D(0) is the continuous filter
// (6)-(7).
MomentumMatrix rate_matrix(const MomentumGains& gains, double dt) {
  const int r = order(gains);
  MomentumMatrix D = MomentumMatrix::Zero(r, r);
  for (int i = 0; i < r; ++i) {
    if (i > 0) {
      D.row(i) = dt * D.row(i - 1);
      D(i, i - 1) += 1.0;
    }
    D(i, r - 1) -= 1.0;
    D.row(i) *= gains.K[i];
  }
  return D;
}

Rates rates(const MomentumGains& gains, double dt) {
  return Eigen::EigenSolver<MomentumMatrix>(rate_matrix(gains, dt), false).eigenvalues();
}

// |1 + dt lambda| < 1, written so that nothing cancels.
bool stable_at(const MomentumGains& gains, double dt) {
  const Rates lambda = rates(gains, dt);
  return std::all_of(lambda.begin(), lambda.end(),
                     [dt](Complex l) { return 2.0 * l.real() + dt * std::norm(l) < 0.0; });
}

double bisect(double lo, double hi, const std::function<bool(double)>& is_low) {
  for (int i = 0; i < 200; ++i) {
    const double mid = 0.5 * (lo + hi);
    if (mid <= lo || mid >= hi) break;
    (is_low(mid) ? lo : hi) = mid;
  }
  return 0.5 * (lo + hi);
}

// Coefficients in ascending powers.
double evaluate(const std::vector<double>& p, double x) {
  return std::accumulate(p.rbegin(), p.rend(), 0.0, [x](double sum, double a) { return sum * x + a; });
}

// Real roots where the polynomial changes sign in (lo, hi), ascending: between two neighbouring roots of its
// derivative it is monotone, so bisection finds every one of them.
std::vector<double> sign_changes(const std::vector<double>& p, double lo, double hi) {
  if (p.size() < 2) return {};
  std::vector<double> derivative;
  for (std::size_t i = 1; i < p.size(); ++i) derivative.push_back(static_cast<double>(i) * p[i]);
  std::vector<double> knots = sign_changes(derivative, lo, hi);
  knots.insert(knots.begin(), lo);
  knots.push_back(hi);
  std::vector<double> roots;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const bool negative = evaluate(p, knots[i - 1]) < 0.0;
    if (negative == (evaluate(p, knots[i]) < 0.0)) continue;
    roots.push_back(bisect(knots[i - 1], knots[i], [&](double x) { return (evaluate(p, x) < 0.0) == negative; }));
  }
  return roots;
}

}  // namespace

std::string check_gains(const MomentumGains& gains) {
  const int r = order(gains);
  if (r < 1 || r > kMaxMomentumOrder) return fmt::format("{} gains; allowed are 1 to {}", r, kMaxMomentumOrder);
  for (int i = 0; i < r; ++i) {
    if (std::isfinite(gains.K[i]) && gains.K[i] > 0.0) continue;
    return fmt::format("K_{} = {} rad/s; allowed are finite gains > 0", i + 1, gains.K[i]);
  }
  return {};
}

MomentumGains scale(MomentumGains gains, double factor) {
  for (double& K : gains.K) K *= factor;
  return gains;
}

std::vector<double> coefficients(const MomentumGains& gains) {
  std::vector<double> c(gains.K.size());
  double product = 1.0;
  for (int j = order(gains) - 1; j >= 0; --j) c[j] = product *= gains.K[j];
  return c;
}

MomentumGains gains_from_coefficients(const std::vector<double>& c) {
  MomentumGains gains{c};
  for (std::size_t i = 0; i + 1 < c.size(); ++i) gains.K[i] = c[i] / c[i + 1];
  return gains;
}

double natural_frequency(const MomentumGains& gains) {
  double log_sum = 0.0;
  for (const double K : gains.K) log_sum += std::log(K);
  return std::exp(log_sum / order(gains));
}

double bandwidth(const MomentumGains& gains) {
  const double w_n = natural_frequency(gains);
  std::vector<double> d = coefficients(scale(gains, 1.0 / w_n));  // d_0 = 1
  d.push_back(1.0);
  // |den(jw)|^2 - 2 as a polynomial in x = w^2: the product of den(s) and den(-s) at s^2 = -x.
  std::vector<double> p(d.size(), 0.0);
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t k = i % 2; k < d.size(); k += 2) {
      const std::size_t power = (i + k) / 2;
      p[power] += ((power + k) % 2 == 0 ? 1.0 : -1.0) * d[i] * d[k];
    }
  }
  p[0] -= 2.0;
  double bound = 1.0;  // Cauchy: no root is larger
  for (const double a : p) bound = std::max(bound, 1.0 + std::abs(a));
  return w_n * std::sqrt(sign_changes(p, 0.0, bound).front());
}

std::vector<Complex> poles(const MomentumGains& gains) {
  const double w_n = natural_frequency(gains);
  const Rates lambda = rates(scale(gains, 1.0 / w_n), 0.0);
  std::vector<Complex> p;
  for (const Complex& l : lambda) p.push_back(w_n * l);
  std::sort(p.begin(), p.end(),
            [](Complex a, Complex b) { return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag(); });
  return p;
}

std::string format_poles(const MomentumGains& gains) {
  std::vector<std::string> parts;
  for (const Complex& p : poles(gains)) {
    if (p.imag() > 0.0) parts.push_back(fmt::format("{:+.3g} +- {:.3g}j", p.real(), p.imag()));
    if (p.imag() == 0.0) parts.push_back(fmt::format("{:+.3g}", p.real()));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

RouthArray routh(const MomentumGains& gains) {
  std::vector<double> c = coefficients(gains);
  c.push_back(1.0);
  const int r = order(gains);
  RouthArray array;
  array.rows.resize(2);
  for (int j = r; j >= 0; --j) array.rows[static_cast<std::size_t>((r - j) % 2)].push_back(c[j]);
  while (array.rows.size() < static_cast<std::size_t>(r) + 1 && array.rows.back()[0] != 0.0) {
    const std::vector<double>& above = array.rows[array.rows.size() - 2];
    const std::vector<double>& last = array.rows.back();
    std::vector<double> row;
    for (std::size_t k = 1; k < above.size(); ++k) {
      const double next = k < last.size() ? last[k] : 0.0;
      row.push_back((last[0] * above[k] - above[0] * next) / last[0]);
    }
    array.rows.push_back(row);
  }
  array.stable = array.rows.size() == static_cast<std::size_t>(r) + 1 &&
                 std::all_of(array.rows.begin(), array.rows.end(), [](const auto& row) { return row[0] > 0.0; });
  return array;
}

MomentumMatrix state_matrix(const MomentumGains& gains, double dt) {
  return MomentumMatrix::Identity(order(gains), order(gains)) + dt * rate_matrix(gains, dt);
}

MomentumVector input_vector(const MomentumGains& gains, double dt) {
  MomentumVector b(order(gains));
  double product = 1.0;
  for (int i = 0; i < order(gains); ++i) b[i] = product *= dt * gains.K[i];
  return b;
}

double spectral_radius(const MomentumGains& gains, double dt) {
  double radius = 0.0;
  for (const Complex& l : rates(gains, dt)) radius = std::max(radius, std::abs(1.0 + dt * l));
  return radius;
}

double largest_stable_dt(const MomentumGains& gains) {
  if (!routh(gains).stable) return 0.0;
  const double limit = 2.0 / gains.K.back();  // det A = +-(1 - K_r dt): beyond it some eigenvalue is outside
  const auto holds = [&](double dt) { return stable_at(gains, dt); };
  double lo = 0.0;
  double hi = 1e-9 * limit;
  while (hi < limit && holds(hi)) {
    lo = hi;
    hi *= 1.02;
  }
  return bisect(lo, std::min(hi, limit), holds);
}

std::string check_stability(const MomentumGains& gains, double dt) {
  if (!routh(gains).stable) {
    return fmt::format("unstable as a continuous filter: poles {} rad/s", format_poles(gains));
  }
  if (!stable_at(gains, dt)) {
    return fmt::format("unstable at the tick of {:.4g} ms: spectral radius {:.4g}; largest stable tick {:.4g} ms",
                       1e3 * dt, spectral_radius(gains, dt), 1e3 * largest_stable_dt(gains));
  }
  return {};
}

}  // namespace dob
