#include "test/oracles/alglib_qp.h"

#include <algorithm>
#include <optimization.h>

namespace dob::test {

namespace {

alglib::real_1d_array to_alglib(const Eigen::VectorXd& v) {
  alglib::real_1d_array array;
  array.setcontent(v.size(), v.data());
  return array;
}

alglib::real_2d_array to_alglib(const Eigen::MatrixXd& m) {
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> row_major = m;
  alglib::real_2d_array array;
  array.setcontent(m.rows(), m.cols(), row_major.data());
  return array;
}

}  // namespace

double DenseQp::violation(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd value = C * x;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    worst = std::max({worst, lower(i) - value(i), value(i) - upper(i)});
  }
  return worst;
}

struct AlglibQp::State {
  alglib::minqpstate qp;
};

AlglibQp::AlglibQp(const DenseQp& qp) : qp_(qp), state_(std::make_unique<State>()) {
  alglib::minqpcreate(qp.g.size(), state_->qp);
  alglib::minqpsetquadraticterm(state_->qp, to_alglib(qp.H));
  alglib::minqpsetlinearterm(state_->qp, to_alglib(qp.g));
  if (qp.C.rows() > 0) {
    alglib::minqpsetlc2dense(state_->qp, to_alglib(qp.C), to_alglib(qp.lower), to_alglib(qp.upper), qp.C.rows());
  }
}

AlglibQp::~AlglibQp() = default;

AlglibQp::Answer AlglibQp::solve_aul(const AlglibAul& settings) {
  alglib::minqpsetalgodenseaul(state_->qp, settings.eps_x, settings.rho, settings.outer_iterations);
  return optimize();
}

AlglibQp::Answer AlglibQp::solve_ipm(double eps) {
  alglib::minqpsetalgodenseipm(state_->qp, eps);
  return optimize();
}

AlglibQp::Answer AlglibQp::optimize() {
  alglib::minqpoptimize(state_->qp);
  alglib::real_1d_array x;
  alglib::minqpreport report;
  alglib::minqpresults(state_->qp, x, report);
  return {Eigen::Map<const Eigen::VectorXd>(x.getcontent(), x.length()), static_cast<int>(report.terminationtype)};
}

std::optional<Eigen::VectorXd> AlglibQp::solve_reference() {
  constexpr double kViolation = 1e-6;
  Answer answer = solve_aul(kAlglibAccurate);
  if (answer.termination > 0 && qp_.violation(answer.x) < kViolation) return answer.x;
  answer = solve_ipm();
  if (answer.termination > 0 && qp_.violation(answer.x) < kViolation) return answer.x;
  return std::nullopt;
}

}  // namespace dob::test
