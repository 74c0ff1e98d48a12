// The gains of the momentum observer as a linear filter: eqs (5)-(7), (9) of the paper, one joint at a time.
//
// Eqs (6)-(7) with order r give, from disturbance to estimate,
//     G(s) = K_r ... K_1 / (s^r + K_r s^(r-1) + K_r K_(r-1) s^(r-2) + ... + K_r ... K_1),
// so that c_(r-j) of (5) is the product of the LAST j gains, and k_0 = c_0 for unit static gain. Positive K
// are not enough for stability: r = 3 needs K_3 > K_1. The gains printed in section 5.1 (K_1, K_2, K_3
// = 17.5, 6.28, 2.25) are unstable; in reversed order they are stable.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace dob {

inline constexpr int kMaxMomentumOrder = 8;
using MomentumMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxMomentumOrder, kMaxMomentumOrder>;
using MomentumVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxMomentumOrder, 1>;

// Same gains for every joint. All functions below need check_gains() to be empty.
struct MomentumGains {
  std::vector<double> K;  // [rad/s] K_1 ... K_r
};

// Empty, or why these are no gains at all: 1 to kMaxMomentumOrder finite numbers > 0.
std::string check_gains(const MomentumGains& gains);

// All K times the factor: every pole and the bandwidth times the factor, shape of the response unchanged.
MomentumGains scale(MomentumGains gains, double factor);

// c_0 ... c_(r-1) of (5) [(rad/s)^(r-j)]; the leading coefficient is 1.
std::vector<double> coefficients(const MomentumGains& gains);

// The gains of a given polynomial, all c_j > 0: K_r = c_(r-1), K_i = c_(i-1) / c_i.
MomentumGains gains_from_coefficients(const std::vector<double>& c);

// (K_1 ... K_r)^(1/r) [rad/s]. For r > 1 the -3 dB bandwidth is another, usually smaller, figure.
double natural_frequency(const MomentumGains& gains);

// Smallest angular frequency at which |G| falls to 1/sqrt(2) [rad/s].
double bandwidth(const MomentumGains& gains);

// Poles of G(s) [rad/s], sorted by real part, then by imaginary part, descending.
std::vector<std::complex<double>> poles(const MomentumGains& gains);

// For messages, [rad/s]: "+2.01 +- 5.95j, -6.28".
std::string format_poles(const MomentumGains& gains);

// Routh's array of the denominator, from s^r down. It ends early at a zero in the first column, which is
// never stable.
struct RouthArray {
  std::vector<std::vector<double>> rows;
  bool stable = false;  // r + 1 rows, first column all > 0
};
RouthArray routh(const MomentumGains& gains);

// The discrete observer as programmed in momentum.cc, one joint: gamma(t) = A gamma(t - dt) + b F with
// gamma = [gamma_1 ... gamma_r] and the disturbance F constant over the interval. From
//     gamma_1 <- gamma_1 + dt K_1 (F - F_hat)
//     gamma_i <- gamma_i + dt K_i (gamma_(i-1) NEW - F_hat),   F_hat = gamma_r BEFORE the update.
MomentumMatrix state_matrix(const MomentumGains& gains, double dt);
MomentumVector input_vector(const MomentumGains& gains, double dt);

// Of state_matrix(); the discrete observer is stable when it is < 1.
double spectral_radius(const MomentumGains& gains, double dt);

// The discrete observer is stable for every 0 < dt < this [s], 0 if there is none. The spectral radius is not
// monotone in dt, so this is the first crossing from below, searched with a step of 2 % and refined by
// bisection. Never above 2 / K_r.
double largest_stable_dt(const MomentumGains& gains);

// Empty, or why the gains are refused: unstable as a continuous filter (with the poles), or at the tick dt
// [s] (with the spectral radius and the largest stable dt).
std::string check_stability(const MomentumGains& gains, double dt);

}  // namespace dob
