#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results/store.h"
#include "test/results/run_samples.h"

namespace dob::store_resume_test {
namespace {

using test::key;
using test::store_error;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// A run of three cells: the first is done, the second could not be run.
class StoreResumeTest : public ::testing::Test {
 protected:
  test::TemporaryDirectory temporary;
  std::filesystem::path dir = temporary.path() / "run";
  RunInfo info{"dobbench run s", "0.1.0", "abc", "Release", "g++ 12", "-O3", {"Some CPU", 2, "Debian 12"}, "2026", {}};
  std::vector<ResolvedScenario> scenarios{{"s", "duration_s = 1\n"}};

  StoreResumeTest() {
    for (const char* observer : {"a", "b", "c"}) {
      info.cells.push_back(key("s", "", observer, "x", 1));
      info.sources.push_back({"s", std::string("[") + observer + "]\n"});
    }
    RunStore store = RunStore::create(dir, info, scenarios);
    store.append(test::survived(info.cells[0], 1.0));
    store.append(test::failed(info.cells[1], "timeout"));
  }

  std::string refusal(const RunInfo& now, const std::vector<ResolvedScenario>& with) const {
    return store_error([&] { RunStore::resume(dir, now, with); });
  }
};

TEST_F(StoreResumeTest, TheSamePlanGoesOnWhereItWas) {
  RunStore store = RunStore::resume(dir, info, scenarios);
  EXPECT_THAT(store.outcomes(), ElementsAre(Outcome::kSurvived, Outcome::kError, std::nullopt));
  store.append(test::survived(info.cells[2], 2.0));
  EXPECT_EQ(store.outcomes()[2], Outcome::kSurvived);
  EXPECT_EQ(read_cells(dir).size(), 3U);
}

TEST_F(StoreResumeTest, OtherCellsAreRefusedWithTheDifference) {
  RunInfo other = info;
  other.cells = {info.cells[0], info.cells[1], key("s", "", "d", "x", 4)};
  EXPECT_THAT(refusal(other, scenarios),
              AllOf(StartsWith(dir.string() + ": cannot be resumed: "), HasSubstr("1 of the cells asked for"),
                    HasSubstr("s d x paper spline seed 4"), HasSubstr("1 of its cells were not asked for"),
                    HasSubstr("dobbench run s")));
  other = info;
  other.cells = {info.cells[1], info.cells[0], info.cells[2]};
  EXPECT_THAT(refusal(other, scenarios), HasSubstr("in their order"));
}

TEST_F(StoreResumeTest, OtherOptionsBehindTheSameNamesAreRefused) {
  RunInfo other = info;
  other.sources = {info.sources[0], {"s", "[b]\ngain = 2\n"}, info.sources[2]};
  EXPECT_THAT(refusal(other, scenarios), HasSubstr("the options or the library of b (x)"));
  EXPECT_THAT(refusal(info, {{"s", "duration_s = 2\n"}}), HasSubstr("the scenario s, or its robot, is not the one"));
}

TEST_F(StoreResumeTest, AnotherProgramIsRefusedAlsoForAppending) {
  RunInfo other = info;
  other.commit = "def";
  EXPECT_THAT(refusal(other, scenarios), AllOf(HasSubstr("(abc, Release"), HasSubstr("(def, Release")));
  // A timing pass resumes nothing.
  EXPECT_THAT(store_error([&] { RunStore::open(dir, other); }),
              AllOf(HasSubstr("computed by"), Not(HasSubstr("resume"))));
  other = info;
  other.flags = "-O2";
  EXPECT_THAT(refusal(other, scenarios), HasSubstr("-O2"));
}

TEST_F(StoreResumeTest, AnotherMachineIsAllowedAndNoted) {
  RunInfo other = info;
  other.machine.cpu = "Another CPU";
  RunStore::resume(dir, other, scenarios).append(test::survived(info.cells[2], 2.0));
  const auto run = read_run(dir);
  EXPECT_EQ(run.info.machine.cpu, "Some CPU");
  ASSERT_EQ(run.notes.size(), 1U);
  EXPECT_EQ(run.notes[0], "computed on several machines: Another CPU; Some CPU");
}

}  // namespace
}  // namespace dob::store_resume_test
