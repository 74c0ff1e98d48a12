#include "test/support/allocation_counter.h"

#include <cstdlib>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace dob::test {
namespace {

// The pointer escapes, so that no allocation can be optimised away.
void use(const void* pointer) {
  asm volatile("" : : "g"(pointer) : "memory");
}

TEST(AllocationCounter, CountsAnEigenVectorOfRunTimeSize) {
  const AllocationCounter counter;
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(5);
  use(v.data());
  EXPECT_EQ(counter.count(), 1);
}

TEST(AllocationCounter, CountsAStandardVector) {
  const AllocationCounter counter;
  const std::vector<double> v(5, 1.0);
  use(v.data());
  EXPECT_EQ(counter.count(), 1);
}

TEST(AllocationCounter, CountsOverAlignedNew) {
  struct alignas(64) Wide {
    double x[8];
  };
  const AllocationCounter counter;
  const auto wide = std::make_unique<Wide>();
  use(wide.get());
  EXPECT_EQ(counter.count(), 1);
}

TEST(AllocationCounter, SeesNoneWhereThereIsNone) {
  const AllocationCounter counter;
  Eigen::Matrix<double, 12, 12> m = Eigen::Matrix<double, 12, 12>::Identity();
  m = m * m;
  use(&m);
  EXPECT_EQ(counter.count(), 0);
}

}  // namespace
}  // namespace dob::test
