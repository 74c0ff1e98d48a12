// The ZMP optimisation against its own conditions, and against ALGLIB on the same program written down anew.
#include "controller/zmp_plan.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "controller/motion_planner.h"
#include "test/oracles/alglib_qp.h"

namespace dob::zmp_plan_test {
namespace {

constexpr double kHeight = 0.40;
const PerLeg<Vec2> kFeet{Vec2(0.287, 0.187), Vec2(0.287, -0.187), Vec2(-0.287, 0.187), Vec2(-0.287, -0.187)};
constexpr PerLeg<bool> kAll{true, true, true, true};

// Stance, swing on LF-RH's counterpart, stance, swing on the other diagonal, stance: the horizon of two footsteps.
ZmpTask trot_task(const ZmpOptions& o, const Motion<Vec2>& start) {
  ZmpTask task;
  task.start = start;
  task.end = Vec2(0.03, 0.0);
  task.height = {kHeight, 0.0, kHeight, 0.15};
  const auto add = [&](double duration, const PerLeg<bool>& stance, int pieces) {
    task.phase[static_cast<std::size_t>(task.phases++)] = {duration, pieces,
                                                           support_polygon(stance, kFeet, o.line_half_width), 0.0};
  };
  add(0.15, kAll, kStancePieces);
  add(0.115, {false, true, true, false}, kSwingPieces);
  add(0.15, kAll, kStancePieces);
  add(0.115, {true, false, false, true}, kSwingPieces);
  add(0.15, kAll, kStancePieces);
  return task;
}

ComTrajectory straight_path(const Motion<Vec2>& start, const Vec2& end) {
  ComTrajectory path;
  path.start(start.p, start.v);
  path.append_cubic(0.68, end, Vec2::Zero());
  return path;
}

Vec2 zmp(const Motion<Vec2>& m) {
  return m.p - kHeight / kGravity * m.a;
}

// Largest distance of the ZMP outside its polygon over the samples [m].
double violation(const ZmpTask& task, const ComTrajectory& motion) {
  double worst = 0.0, t0 = 0.0;
  for (int i = 0; i < task.phases; ++i) {
    const ZmpPhase& phase = task.phase[static_cast<std::size_t>(i)];
    const int samples = static_cast<int>(std::ceil(phase.duration / 0.01 - 1e-9));
    for (int k = 1; k <= samples; ++k) {
      const Motion<Vec2> m = motion.at(t0 + k * phase.duration / samples - 1e-12);
      worst = std::max(worst, -phase.polygon.margin(zmp(m)));
    }
    t0 += phase.duration;
  }
  return worst;
}

const Motion<Vec2> kCalm{Vec2(-0.02, 0.0), Vec2(0.12, 0.0), Vec2::Zero()};
const Motion<Vec2> kPushed{Vec2(-0.02, 0.0), Vec2(0.12, 0.25), Vec2::Zero()};

TEST(ZmpPlan, MeetsStartAndEndAndIsSmooth) {
  const ZmpOptions options;
  ZmpOptimizer optimizer(options, 2);
  const ZmpTask task = trot_task(options, kPushed);
  ComTrajectory motion;
  ASSERT_EQ(optimizer.solve(task, straight_path(kPushed, task.end), motion).status, QpStatus::kOptimal);
  EXPECT_NEAR((motion.at(0.0).p - kPushed.p).norm(), 0.0, 1e-12);
  EXPECT_NEAR((motion.at(0.0).v - kPushed.v).norm(), 0.0, 1e-12);
  EXPECT_NEAR((motion.at(0.0).a - kPushed.a).norm(), 0.0, 1e-12);
  EXPECT_NEAR(motion.duration(), 0.68, 1e-12);
  EXPECT_NEAR((motion.end().p - task.end).norm(), 0.0, 1e-8);
  EXPECT_NEAR(motion.end().v.norm(), 0.0, 1e-7);
  EXPECT_NEAR(motion.end().a.norm(), 0.0, 1e-6);
  for (double t = 0.001; t < 0.679; t += 0.001) {
    EXPECT_LT((motion.at(t + 1e-6).a - motion.at(t - 1e-6).a).norm(), 1e-3) << t;  // jerk below 500 m/s^3
  }
}

TEST(ZmpPlan, KeepsTheZmpInsideWhereTheRegularisedPathDoesNot) {
  const ZmpOptions options;
  ZmpOptimizer optimizer(options, 2);
  const ZmpTask task = trot_task(options, kPushed);
  const ComTrajectory path = straight_path(kPushed, task.end);
  ComTrajectory motion;
  const ZmpReport report = optimizer.solve(task, path, motion);
  EXPECT_GT(report.active_rows, 3);
  EXPECT_GT(violation(task, path), 0.02);
  EXPECT_LT(violation(task, motion), report.slack + 1e-7);
  EXPECT_LT(report.slack, 1e-7);
}

TEST(ZmpPlan, WithoutAPushNoRowIsActive) {
  ZmpOptions options;
  options.line_half_width = 0.05;
  ZmpOptimizer optimizer(options, 2);
  const ZmpTask task = trot_task(options, kCalm);
  ComTrajectory motion;
  const ZmpReport report = optimizer.solve(task, straight_path(kCalm, task.end), motion);
  ASSERT_EQ(report.status, QpStatus::kOptimal);
  EXPECT_EQ(report.active_rows, 0);
  EXPECT_LT(violation(task, motion), 1e-9);
}

TEST(ZmpPlan, AnImpossiblePushIsSolvedWithSlackAndNeverRefused) {
  const ZmpOptions options;
  ZmpOptimizer optimizer(options, 2);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double largest = 0.0;
  for (int i = 0; i < 300; ++i) {
    const auto vector = [&](double scale) { return Vec2(scale * Vec2{uniform(random), uniform(random)}); };
    const Motion<Vec2> start{vector(0.2), vector(2.0), vector(10.0)};
    const ZmpTask task = trot_task(options, start);
    ComTrajectory motion;
    const ZmpReport report = optimizer.solve(task, straight_path(start, task.end), motion);
    ASSERT_EQ(report.status, QpStatus::kOptimal) << i << " " << to_string(report.status);
    ASSERT_LT(violation(task, motion), report.slack + 1e-6);
    largest = std::max(largest, report.slack);
  }
  EXPECT_GT(largest, 0.1);
}

TEST(ZmpPlan, RefusesAHorizonItHasNoProgramFor) {
  EXPECT_THROW(ZmpOptimizer(ZmpOptions{}, 0), std::invalid_argument);
  EXPECT_THROW(ZmpOptimizer(ZmpOptions{}, kMaxHorizon + 1), std::invalid_argument);
}

// The same optimum from a formulation that shares nothing with ours: positions, velocities and accelerations at the
// ends of the pieces as further variables, tied together by equality rows, solved by ALGLIB.
class Oracle {
 public:
  Oracle(const ZmpOptions& o, const ZmpTask& task, const ComTrajectory& path) {
    for (int i = 0; i < task.phases; ++i) {
      for (int k = 0; k < task.phase[i].pieces; ++k) length_.push_back(task.phase[i].duration / task.phase[i].pieces);
    }
    n_ = static_cast<int>(length_.size());
    const int variables = 8 * n_ + 1;  // per piece and coordinate: jerk, end position, velocity, acceleration
    qp_.H = Eigen::MatrixXd::Zero(variables, variables);
    qp_.g = Eigen::VectorXd::Zero(variables);
    double total = 0.0;
    for (const double l : length_) total += l;
    for (int k = 0; k < n_; ++k) {
      for (int c = 0; c < 2; ++c) qp_.H(jerk(k, c), jerk(k, c)) = length_[k] / total;
    }
    qp_.H(8 * n_, 8 * n_) = 1e6;
    qp_.g[8 * n_] = 1e3;
    ties(task);
    double t0 = 0.0;
    int first = 0;
    for (int i = 0; i < task.phases; ++i) {
      const ZmpPhase& phase = task.phase[i];
      const int samples = static_cast<int>(std::ceil(phase.duration / o.sample - 1e-9));
      for (int s = 1; s <= samples; ++s)
        sample(o, task, path, phase, first, t0, s * phase.duration / samples, total, phase.duration / samples);
      first += phase.pieces;
      t0 += phase.duration;
    }
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(variables);
    unit[8 * n_] = 1.0;
    row(unit, 0.0, WbcInfinity());
    qp_.C.resize(static_cast<Eigen::Index>(rows_.size()), variables);
    qp_.lower.resize(qp_.C.rows());
    qp_.upper.resize(qp_.C.rows());
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      qp_.C.row(static_cast<Eigen::Index>(r)) = rows_[r];
      qp_.lower[static_cast<Eigen::Index>(r)] = lower_[r];
      qp_.upper[static_cast<Eigen::Index>(r)] = upper_[r];
    }
  }

  // The augmented-Lagrangian solver does not get far with this many ties; the interior point does.
  std::optional<Eigen::VectorXd> solve() const {
    const test::AlglibQp::Answer answer = test::AlglibQp(qp_).solve_ipm(1e-10);
    if (answer.termination <= 0 || qp_.violation(answer.x) > 1e-6) return std::nullopt;
    return answer.x;
  }
  Vec2 end_of_piece(const Eigen::VectorXd& x, int k) const { return {x[p(k, 0)], x[p(k, 1)]}; }
  int pieces() const { return n_; }
  double length(int k) const { return length_[k]; }

 private:
  static double WbcInfinity() { return QpProblem<1, 1>::kInfinity; }
  int jerk(int k, int c) const { return 8 * k + c; }
  int p(int k, int c) const { return 8 * k + 2 + c; }
  int v(int k, int c) const { return 8 * k + 4 + c; }
  int a(int k, int c) const { return 8 * k + 6 + c; }

  void row(const Eigen::VectorXd& r, double lower, double upper) {
    rows_.push_back(r);
    lower_.push_back(lower);
    upper_.push_back(upper);
  }

  static constexpr double kJerkUnit = ZmpOptions{}.sigma_jerk;  // [m/s^3] jerk variables are multiples of it

  // Position, velocity, acceleration at a time s into piece k as affine functions of the variables.
  struct Affine {
    Eigen::VectorXd p, v, a;
    double p0, v0, a0;
  };
  Affine at(const ZmpTask& task, int k, double s, int c) const {
    const int size = 8 * n_ + 1;
    Affine f{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size), 0, 0, 0};
    f.p[jerk(k, c)] = kJerkUnit * s * s * s / 6;
    f.v[jerk(k, c)] = kJerkUnit * s * s / 2;
    f.a[jerk(k, c)] = kJerkUnit * s;
    if (k == 0) {
      f.p0 = task.start.p[c] + s * task.start.v[c] + s * s / 2 * task.start.a[c];
      f.v0 = task.start.v[c] + s * task.start.a[c];
      f.a0 = task.start.a[c];
    } else {
      f.p[p(k - 1, c)] = 1;
      f.p[v(k - 1, c)] = s;
      f.p[a(k - 1, c)] = s * s / 2;
      f.v[v(k - 1, c)] = 1;
      f.v[a(k - 1, c)] = s;
      f.a[a(k - 1, c)] = 1;
    }
    return f;
  }

  void ties(const ZmpTask& task) {
    for (int k = 0; k < n_; ++k) {
      for (int c = 0; c < 2; ++c) {
        Affine f = at(task, k, length_[k], c);
        f.p[p(k, c)] -= 1;
        f.v[v(k, c)] -= 1;
        f.a[a(k, c)] -= 1;
        row(f.p, -f.p0, -f.p0);
        row(f.v, -f.v0, -f.v0);
        row(f.a, -f.a0, -f.a0);
        if (k + 1 < n_) continue;
        const auto fix = [&](int i, double value) {
          Eigen::VectorXd unit = Eigen::VectorXd::Zero(8 * n_ + 1);
          unit[i] = 1;
          row(unit, value, value);
        };
        fix(p(k, c), task.end[c]);
        fix(v(k, c), 0.0);
        fix(a(k, c), 0.0);
      }
    }
  }

  void sample(const ZmpOptions& o, const ZmpTask& task, const ComTrajectory& path, const ZmpPhase& phase, int first,
              double t0, double since, double total, double step) {
    int k = first;
    double s = since;
    while (k + 1 < first + phase.pieces && s > length_[k]) s -= length_[k++];
    const Motion<Vec2> wanted = path.at(t0 + since);
    const Affine x = at(task, k, s, 0), y = at(task, k, s, 1);
    const double w_p = step / total / (o.sigma_position * o.sigma_position);
    const double w_v = step / total / (o.sigma_velocity * o.sigma_velocity);
    for (int c = 0; c < 2; ++c) {
      const Affine& f = c == 0 ? x : y;
      qp_.H += w_p * f.p * f.p.transpose() + w_v * f.v * f.v.transpose();
      qp_.g += w_p * (f.p0 - wanted.p[c]) * f.p + w_v * (f.v0 - wanted.v[c]) * f.v;
    }
    const double h = kHeight / kGravity;
    for (int e = 0; e < phase.polygon.edges; ++e) {
      const Vec2& n = phase.polygon.normal[e];
      Eigen::VectorXd r = n.x() * (x.p - h * x.a) + n.y() * (y.p - h * y.a);
      r[8 * n_] = -1;
      row(r, -WbcInfinity(),
          phase.polygon.offset[e] - phase.margin - n.x() * (x.p0 - h * x.a0) - n.y() * (y.p0 - h * y.a0));
    }
  }

  int n_ = 0;
  std::vector<double> length_;
  test::DenseQp qp_;
  std::vector<Eigen::VectorXd> rows_;
  std::vector<double> lower_, upper_;
};

TEST(ZmpPlan, AgreesWithAlglibOnTheProgramWrittenDownAnew) {
  const ZmpOptions options;
  ZmpOptimizer optimizer(options, 2);
  int compared = 0;
  for (const Vec2& push : {Vec2(0.0, 0.0), Vec2(0.0, 0.25), Vec2(0.2, -0.1), Vec2(-0.3, 0.1)}) {
    const Motion<Vec2> start{Vec2(-0.02, 0.0), Vec2(0.12, 0.0) + push, Vec2(0.3, -0.2)};
    const ZmpTask task = trot_task(options, start);
    const ComTrajectory path = straight_path(start, task.end);
    ComTrajectory motion;
    ASSERT_EQ(optimizer.solve(task, path, motion).status, QpStatus::kOptimal);
    const Oracle oracle(options, task, path);
    const auto x = oracle.solve();
    if (!x) continue;  // ALGLIB found no acceptable answer; counted below
    ++compared;
    double t = 0.0;
    for (int k = 0; k < oracle.pieces(); ++k) {
      t += oracle.length(k);
      EXPECT_NEAR((motion.at(t).p - oracle.end_of_piece(*x, k)).norm(), 0.0, 1e-5) << "piece " << k;
    }
  }
  EXPECT_GE(compared, 3);
}

}  // namespace
}  // namespace dob::zmp_plan_test
