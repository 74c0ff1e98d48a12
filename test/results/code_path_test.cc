#include "results/code_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/lanes.h"

namespace dob::code_path_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(CodePath, SaysWhatTheLastBitsDependOn) {
  const CodePath here = this_code_path();
  EXPECT_EQ(here.model, kLanes == 4 ? "AVX2+FMA" : "portable");
  EXPECT_THAT(here.libraries, AllOf(HasSubstr("Eigen 3."), HasSubstr("libm.so"), Not(HasSubstr("unknown"))));
  EXPECT_NE(here.cpu_flags, "");
  EXPECT_EQ(here, this_code_path());
}

TEST(CodePath, DifferencesNameWhatDiffersAndNothingElse) {
  const Provenance a{"0.1.0", "c", "Release", "GNU 12", "-O3", {"portable", "glibc 2.36", "avx2 fma"}};
  EXPECT_EQ(differences(a, a), "");
  Provenance b = a;
  b.flags = "-O2";
  b.path.cpu_flags = "avx";
  EXPECT_EQ(differences(a, b), "flags: '-O3' there, '-O2' here; CPU flags: 'avx2 fma' there, 'avx' here");
  for (std::string* field : {&b.version, &b.commit, &b.build, &b.compiler, &b.path.model, &b.path.libraries}) {
    b = a;
    *field = "other";
    EXPECT_THAT(differences(a, b), HasSubstr("'other' here"));
  }
}

}  // namespace
}  // namespace dob::code_path_test
