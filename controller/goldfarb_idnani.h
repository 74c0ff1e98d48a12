// Dual active-set solver for small strictly convex QPs: D. Goldfarb and A. Idnani, "A numerically stable dual
// method for solving strictly convex quadratic programs", Math. Programming 27 (1983).
//
// It starts at the unconstrained minimiser and adds the worst violated row, one after the other, keeping x
// optimal for the rows added so far; a row whose multiplier reaches zero on the way is dropped. Two-sided
// rows are handled as they are. Equality rows go in first and never leave.
//
// Nothing is on the heap, nothing throws, and the same input gives the same bits. The object is the workspace: reuse
// it, but not from two threads at once. An answer is kOptimal or kInfeasible only if controller/qp_certificate.h says
// so on the problem's own data; if it does not, the solve goes on, up to three times, from the active set reached, with
// fresh factors and a step of iterative refinement, and failing that ends as kInaccurate. Rows whose normals differ by
// less than about 1e-12 (in the metric of H^-1) count as parallel.
#pragma once

#include <limits>

#include <Eigen/Core>

#include "controller/active_set_factors.h"
#include "controller/qp.h"

namespace dob {

struct QpOptions {
  int iteration_limit = 1000;   // rows added plus rows dropped, > 0
  double kkt_tolerance = 1e-9;  // largest KKT residual of a kOptimal answer, in (0, 1)

  void validate() const;  // throws std::invalid_argument
};

template <int N, int MaxRows>
class GoldfarbIdnani {
  static_assert(N > 0 && MaxRows > 0);

 public:
  using Problem = QpProblem<N, MaxRows>;
  using Solution = QpSolution<N, MaxRows>;
  using ActiveSet = QpActiveSet<N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  using RowVector = Eigen::Matrix<double, MaxRows, 1>;

  explicit GoldfarbIdnani(const QpOptions& options = {}) : options_(options) { options_.validate(); }

  // Cold solve. The status is also returned. After kInvalidInput and kSingular everything else in `solution` is as it
  // was.
  QpStatus solve(const Problem& qp, Solution& solution) noexcept { return solve(qp, ActiveSet{}, solution); }

  // Warm solve from a guess of the active set, e.g. solution.active of the previous tick. Any guess is safe:
  // rows that do not exist, depend on others or push the wrong way are left out. The answer is as good as a
  // cold one's.
  QpStatus solve(const Problem& qp, const ActiveSet& guess, Solution& solution) noexcept;

 private:
  using Factors = ActiveSetFactors<N>;
  enum class Outcome { kDone, kContradiction, kIterationLimit };
  struct Blocking {
    int k = -1;  // active row whose multiplier reaches zero first
    double length = std::numeric_limits<double>::infinity();
  };

  bool prepare(const Problem& qp) noexcept;

  void start(const Problem& qp, const ActiveSet& guess, bool refined) noexcept;
  void try_append(const Problem& qp, int row, QpSide side) noexcept;
  void settle(const Problem& qp, bool refined) noexcept;
  void refine(const Problem& qp) noexcept;

  Outcome iterate(const Problem& qp) noexcept;
  double score(const Problem& qp, int row) const noexcept;
  bool is_significant(const Problem& qp, int row, double score) const noexcept;
  int most_violated(const Problem& qp) noexcept;
  Outcome add(const Problem& qp, int row, QpSide side) noexcept;
  Blocking first_blocking() const noexcept;
  void record_contradiction(const Problem& qp, int row, double scale) noexcept;

  void append(int row, QpSide side, double scale, double gap, double multiplier) noexcept;
  void remove(int k) noexcept;
  bool is_dependent() const noexcept;
  QpStatus judge(const Problem& qp, Outcome outcome, Solution& solution) const noexcept;

  QpOptions options_;
  Factors factors_;
  typename Factors::Direction step_;
  Vector x_;
  Vector reach_;      // largest |x_j| since the start: the scale of the rounding errors in x
  RowVector weight_;  // 1 / |c_i|^2; zero for zero rows and while a row is active
  RowVector farkas_;
  ActiveSet active_;
  Vector scale_;        // of active row k: +-1 / |c|, so that scale_ c is a unit normal that points inwards
  Vector gap_;          // the bound of active row k times scale_
  Vector u_;            // multiplier of active row k with that normal; >= 0 except for equalities
  int equalities_ = 0;  // the first active rows are equalities
  int iterations_ = 0;
  Eigen::Matrix<int, MaxRows, 1> candidate_;  // rows that were violated when last all were looked at
  int candidates_ = 0;
  bool has_equalities_ = false;
  int hopeless_row_ = -1;  // a zero row whose bounds exclude zero
};

}  // namespace dob

#include "controller/goldfarb_idnani_impl.h"

namespace dob {

extern template class GoldfarbIdnani<12, 44>;  // the whole-body QP

}  // namespace dob
