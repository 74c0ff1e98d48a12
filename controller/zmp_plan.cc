#include "controller/zmp_plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "controller/goldfarb_idnani.h"

namespace dob {
namespace {

constexpr double kSlackQuadratic = 1e6;  // [1/m^2]
constexpr double kSlackLinear = 1e3;     // [1/m]

// Cubic pieces of unit jerk: what each adds to position, velocity and acceleration at a time.
template <int Pieces>
struct Basis {
  using Row = Eigen::Matrix<double, 1, Pieces>;
  Row p, v, a;
};

// The program of a horizon of F footsteps: jerks of x, then of y, in units of sigma_jerk, then the slack.
template <int F>
class HorizonProgram {
 public:
  static constexpr int kPieces = F * (kStancePieces + kSwingPieces) + kStancePieces;
  static constexpr int kVariables = 2 * kPieces + 1;
  static constexpr int kSlack = 2 * kPieces;
  static constexpr int kEnds = 6;
  static constexpr int kMaxRows = kEnds + 1 + kMaxZmpSamples * SupportPolygon::kMaxEdges;

  explicit HorizonProgram(const ZmpOptions& options) : options_(options) {}

  ZmpReport solve(const ZmpTask& task, const ComTrajectory& path, ComTrajectory& motion) noexcept {
    lay_out_pieces(task);
    qp_.rows = 0;
    add_end(task);
    add_cost_and_rows(task, path);
    ZmpReport report;
    report.status = solver_.solve(qp_, solution_);
    report.iterations = solution_.iterations;
    if (report.status != QpStatus::kOptimal) return report;
    report.slack = solution_.x(kSlack);
    for (int k = 0; k < solution_.active.size; ++k) report.active_rows += solution_.active[k].row > kEnds ? 1 : 0;
    write(task, motion);
    return report;
  }

 private:
  using Problem = QpProblem<kVariables, kMaxRows>;
  using Row = typename Basis<kPieces>::Row;
  using Hessian = Eigen::Matrix<double, kPieces, kPieces>;

  void lay_out_pieces(const ZmpTask& task) noexcept {
    pieces_ = 0;
    double t = 0.0;
    for (int i = 0; i < task.phases; ++i) {
      const ZmpPhase& phase = task.phase[static_cast<std::size_t>(i)];
      for (int k = 0; k < phase.pieces; ++k) {
        start_[pieces_] = t;
        length_[pieces_] = phase.duration / phase.pieces;
        t += length_[pieces_++];
      }
    }
    end_ = t;
  }

  Basis<kPieces> basis(double t) const noexcept {
    Basis<kPieces> b{Row::Zero(), Row::Zero(), Row::Zero()};
    for (int k = 0; k < pieces_ && start_[k] < t; ++k) {
      const double s = std::min(t - start_[k], length_[k]);
      const double rest = t - start_[k] - s;  // since the end of the piece
      b.a[k] = options_.sigma_jerk * s;
      b.v[k] = options_.sigma_jerk * s * (0.5 * s + rest);
      b.p[k] = options_.sigma_jerk * s * (s * s / 6.0 + 0.5 * rest * (s + rest));
    }
    return b;
  }

  // Motion at zero jerk.
  static Motion<Vec2> free_motion(const Motion<Vec2>& start, double t) noexcept {
    return {start.p + t * (start.v + 0.5 * t * start.a), start.v + t * start.a, start.a};
  }

  void add_row(const Row& x, const Row& y, double slack, double lower, double upper) noexcept {
    auto row = qp_.C.row(qp_.rows);
    row.template head<kPieces>() = x;
    row.template segment<kPieces>(kPieces) = y;
    row[kSlack] = slack;
    qp_.lower[qp_.rows] = lower;
    qp_.upper[qp_.rows] = upper;
    ++qp_.rows;
  }

  void add_end(const ZmpTask& task) noexcept {
    const Basis<kPieces> b = basis(end_);
    const Motion<Vec2> free = free_motion(task.start, end_);
    const Row none = Row::Zero();
    const auto add = [&](const Row& row, const Vec2& value) {
      add_row(row, none, 0.0, value.x(), value.x());
      add_row(none, row, 0.0, value.y(), value.y());
    };
    add(b.p, task.end - free.p);
    add(b.v, -free.v);
    add(b.a, -free.a);
    add_row(none, none, 1.0, 0.0, Problem::kInfinity);
  }

  void add_cost_and_rows(const ZmpTask& task, const ComTrajectory& path) noexcept {
    Hessian H = Hessian::Zero();
    Eigen::Matrix<double, kPieces, 2> g = Eigen::Matrix<double, kPieces, 2>::Zero();
    double t0 = 0.0;
    for (int i = 0; i < task.phases; ++i) {
      const ZmpPhase& phase = task.phase[static_cast<std::size_t>(i)];
      const int samples = std::max(1, static_cast<int>(std::ceil(phase.duration / options_.sample - 1e-9)));
      const double step = phase.duration / samples;
      for (int k = 1; k <= samples; ++k) {
        const double t = t0 + k * step;
        const Basis<kPieces> b = basis(t);
        const Motion<Vec2> free = free_motion(task.start, t);
        const Motion<Vec2> wanted = path.at(t);
        const double w_p = step / end_ / (options_.sigma_position * options_.sigma_position);
        const double w_v = step / end_ / (options_.sigma_velocity * options_.sigma_velocity);
        H.noalias() += (w_p * b.p.transpose()).lazyProduct(b.p);
        H.noalias() += (w_v * b.v.transpose()).lazyProduct(b.v);
        g.noalias() += (w_p * b.p.transpose()).lazyProduct((free.p - wanted.p).transpose());
        g.noalias() += (w_v * b.v.transpose()).lazyProduct((free.v - wanted.v).transpose());
        add_zmp_rows(phase, task.height.at(t), b, free);
      }
      t0 += phase.duration;
    }
    for (int k = 0; k < kPieces; ++k) H(k, k) += k < pieces_ ? length_[k] / end_ : 1.0;
    qp_.H.setZero();
    qp_.H.template topLeftCorner<kPieces, kPieces>() = H;
    qp_.H.template block<kPieces, kPieces>(kPieces, kPieces) = H;
    qp_.H(kSlack, kSlack) = kSlackQuadratic;
    qp_.g.template head<kPieces>() = g.col(0);
    qp_.g.template segment<kPieces>(kPieces) = g.col(1);
    qp_.g[kSlack] = kSlackLinear;
  }

  // (10), (11): zmp = p - h a with h = z / (g + z_dd), z above the ground.
  void add_zmp_rows(const ZmpPhase& phase, const Motion<double>& height, const Basis<kPieces>& b,
                    const Motion<Vec2>& free) noexcept {
    const double h = height.p / (kGravity + height.a);
    const Row zmp = b.p - h * b.a;
    const Vec2 zmp_free = free.p - h * free.a;
    for (int e = 0; e < phase.polygon.edges; ++e) {
      const Vec2& n = phase.polygon.normal[static_cast<std::size_t>(e)];
      const double room = phase.polygon.offset[static_cast<std::size_t>(e)] - phase.margin - n.dot(zmp_free);
      add_row(n.x() * zmp, n.y() * zmp, -1.0, -Problem::kInfinity, room);
    }
  }

  void write(const ZmpTask& task, ComTrajectory& motion) const noexcept {
    motion.start(task.start.p, task.start.v);
    Vec2 a = task.start.a;
    for (int k = 0; k < pieces_; ++k) {
      const Vec2 jerk = options_.sigma_jerk * Vec2(solution_.x[k], solution_.x[kPieces + k]);
      motion.append_jerk(length_[k], a, jerk);
      a += length_[k] * jerk;
    }
  }

  ZmpOptions options_;
  Problem qp_;
  GoldfarbIdnani<kVariables, kMaxRows> solver_;
  QpSolution<kVariables, kMaxRows> solution_;
  int pieces_ = 0;
  std::array<double, kPieces> start_{}, length_{};  // [s]
  double end_ = 0.0;                                // [s]
};

}  // namespace

struct ZmpOptimizer::Program {
  // Built in place: too large to pass through the stack.
  template <typename T>
  Program(std::in_place_type_t<T> type, const ZmpOptions& options) : of_horizon(type, options) {}

  std::variant<HorizonProgram<1>, HorizonProgram<2>, HorizonProgram<3>> of_horizon;
};

ZmpOptimizer::ZmpOptimizer(const ZmpOptions& options, int horizon) {
  static_assert(kMaxHorizon == 3);
  switch (horizon) {
    case 1:
      program_ = std::make_unique<Program>(std::in_place_type<HorizonProgram<1>>, options);
      break;
    case 2:
      program_ = std::make_unique<Program>(std::in_place_type<HorizonProgram<2>>, options);
      break;
    case 3:
      program_ = std::make_unique<Program>(std::in_place_type<HorizonProgram<3>>, options);
      break;
    default:
      throw std::invalid_argument(fmt::format("planner: horizon = {}; allowed: 1 to {}", horizon, kMaxHorizon));
  }
}

ZmpOptimizer::~ZmpOptimizer() = default;
ZmpOptimizer::ZmpOptimizer(ZmpOptimizer&&) noexcept = default;
ZmpOptimizer& ZmpOptimizer::operator=(ZmpOptimizer&&) noexcept = default;

ZmpReport ZmpOptimizer::solve(const ZmpTask& task, const ComTrajectory& path, ComTrajectory& motion) noexcept {
  // (std::visit would be allowed to throw.)
  auto& any = program_->of_horizon;
  if (auto* program = std::get_if<HorizonProgram<1>>(&any)) return program->solve(task, path, motion);
  if (auto* program = std::get_if<HorizonProgram<2>>(&any)) return program->solve(task, path, motion);
  return std::get_if<HorizonProgram<3>>(&any)->solve(task, path, motion);
}

}  // namespace dob
