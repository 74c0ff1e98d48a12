// The solver seam: any backend gives the same robot.
#include "controller/wbc_solver.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "controller/whole_body_controller.h"
#include "test/oracles/alglib_wbc_solver.h"
#include "test/support/wbc_instances.h"

namespace dob::wbc_solver_test {
namespace {

TEST(WbcSolvers, AreMadeByTheirNames) {
  for (const WbcSolverInfo& info : wbc_solvers()) EXPECT_NE(make_wbc_solver(info.name), nullptr) << info.name;
}

TEST(WbcSolvers, ThatDoNotExistAreRefusedWithThoseThatDo) {
  try {
    make_wbc_solver("magic");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "there is no QP solver 'magic'; there are: goldfarb_idnani");
  }
  EXPECT_THROW(WholeBodyController(WbcOptions{}, Routing{}, nullptr), std::invalid_argument);
}

// ALGLIB in the place of ours, over a recorded trot with every solve due.
TEST(WbcSolvers, AlglibSendsTheSameTorquesAlongARun) {
  std::mt19937_64 random(21);
  const auto run = test::recorded_instances(0.8, random);
  ASSERT_GE(run.size(), 300U);
  const Routing routing{.dynamics_18 = true};
  WholeBodyController ours(WbcOptions{}, routing);
  WholeBodyController other(WbcOptions{}, routing, std::make_unique<test::AlglibWbcSolver>());
  long swinging = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const test::WbcInstance& in = run[i];
    const long k = 5 * static_cast<long>(i);  // multiples of 5 ms are on the grid of 400 Hz
    const WbcTick a = ours.update(k, 1e-3, in.m, in.stance, in.reference, in.estimate);
    const WbcTick b = other.update(k, 1e-3, in.m, in.stance, in.reference, in.estimate);
    ASSERT_EQ(a.event, QpEvent::kSolved);
    ASSERT_EQ(b.event, QpEvent::kSolved);
    ASSERT_LE((a.torque - b.torque).cwiseAbs().maxCoeff(), 1e-3) << "N m, solve " << i;
    swinging += in.stance[0] ? 0 : 1;
  }
  EXPECT_GT(swinging, 50);
}

}  // namespace
}  // namespace dob::wbc_solver_test
