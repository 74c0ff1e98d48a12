// `dobbench report` as a user starts it: the page, odd directories, what is refused.
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "results/store.h"
#include "test/bench/command_line.h"
#include "test/results/report_samples.h"

namespace dob::report_command_test {
namespace {

namespace fs = std::filesystem;
using dob::test::Answer;
using dob::test::CommandLine;
using dob::test::Page;
using dob::test::read_page;

constexpr const char* kShortRun =
    "run case1/tip_lateral --observer none --observer momentum --profile tuned --seeds 2 --set duration_s=1.5 --jobs 2";

TEST_F(CommandLine, ARunIsReportedAsOnePageWithItsReplays) {
  ASSERT_EQ(dobbench(kShortRun + std::string(" --out run")).exit_code, 0);
  ASSERT_EQ(dobbench("timing --seconds 0.5 --out run").exit_code, 0);
  const Answer answer = dobbench("report run");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("run/report.html: "), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("time series of 2 cells"), std::string::npos) << answer.out;
  const Page page = read_page(dir / "run" / "report.html");
  EXPECT_EQ(page.data["missing"].size(), 0U) << page.missing();
  EXPECT_EQ(page.data["run"]["finished"], 4);
  ASSERT_EQ(page.data["scenarios"].size(), 1U);
  EXPECT_EQ(page.data["scenarios"][0]["duration_s"], 1.5) << "as it was run, not as it is shipped";
  EXPECT_EQ(page.data["scenarios"][0]["metric_leg"], "LF");
  ASSERT_EQ(page.data["robots"].size(), 1U);
  EXPECT_EQ(page.data["scenarios"][0]["robot"], 0);
  EXPECT_EQ(page.data["robots"][0]["links"].size(), 13U);
  ASSERT_EQ(page.data["timing"].size(), 2U);
  long ticks = 0;
  for (const long count : page.data["timing"][0]["tick_histogram"]["counts"]) ticks += count;
  EXPECT_EQ(ticks, 400) << "0.5 s at 1 kHz without the first 0.1 s";
  ASSERT_EQ(page.data["traces"].size(), 2U);
  EXPECT_EQ(page.trace(1).replay("LF/foothold/x_m").size(), 38U) << "1.5 s at 25 Hz";
  EXPECT_EQ(page.trace(1).replay("RH/lower/angle_rad").size(), 38U);
  EXPECT_EQ(page.trace(0).plot("LF/hip/estimate_Nm").size(), 0U) << "none estimates nothing";
  EXPECT_EQ(page.trace(1).plot("LF/hip/estimate_Nm").size(), page.trace(1).plot("com_error_m").size());
}

// A replay's robot stands on its feet: the lowest point of each foot in stance is on the ground.
void expect_on_the_ground(const Page& page, std::size_t index) {
  const dob::test::PageTrace trace = page.trace(index);
  const auto& scenario = page.data["scenarios"][index];
  ASSERT_EQ(page.data["traces"][index]["scenario_id"], scenario["id"]);
  const auto& robot = page.data["robots"][scenario["robot"].get<std::size_t>()];
  const auto vector = [](const auto& json) { return Eigen::Vector3d(json[0], json[1], json[2]); };
  int stances = 0;
  for (std::size_t frame = 0; frame < trace.replay("trunk/x_m").size(); ++frame) {
    const auto at = [&](const std::string& name) { return trace.replay(name).at(frame); };
    const Eigen::Quaterniond trunk(at("trunk/qw"), at("trunk/qx"), at("trunk/qy"), at("trunk/qz"));
    for (const auto& foot : robot["feet"]) {
      const std::string leg = foot["leg"];
      Eigen::Vector3d p = vector(foot["center"]);
      const std::array<const char*, 3> joints{"hip", "upper", "lower"};
      std::size_t link = foot["link"];
      for (int j = 2; j >= 0; --j) {  // from the foot's link to the trunk
        const auto& body = robot["links"][link];
        const double angle = at(leg + "/" + joints[static_cast<std::size_t>(j)] + "/angle_rad");
        p = vector(body["origin"]) + Eigen::AngleAxisd(angle, vector(body["axis"])) * p;
        link = body["parent"];
      }
      EXPECT_EQ(link, 0U);
      p = Eigen::Vector3d(at("trunk/x_m"), at("trunk/y_m"), at("trunk/z_m")) + trunk.normalized() * p;
      if (at(leg + "/stance") == 0.0) continue;
      ++stances;
      EXPECT_NEAR(p.z() - foot["radius"].get<double>(), 0.0, 0.006) << leg << " in frame " << frame;
    }
  }
  EXPECT_GT(stances, 50);
}

// Two robots in one run: each scenario is replayed with its own, and its gains are called its own.
TEST_F(CommandLine, TheReplaysRobotsStandOnTheGround) {
  ASSERT_EQ(dobbench("run undisturbed quad12_undisturbed --observer none --set duration_s=1 --out run").exit_code, 0);
  ASSERT_EQ(dobbench("report run -o page.html").exit_code, 0);
  const Page page = read_page(dir / "page.html");
  EXPECT_EQ(page.data["missing"].size(), 1U) << page.missing();  // no times were measured
  ASSERT_EQ(page.data["robots"].size(), 2U);
  EXPECT_EQ(page.data["robots"][1]["name"], "quad12");
  EXPECT_EQ(page.data["robots"][1]["mass_kg"], 12.776);
  EXPECT_EQ(page.data["robots"][0]["mass_kg"], 21.256);
  EXPECT_EQ(page.data["settings"][1]["gains"], "own");
  for (const std::size_t index : {0U, 1U}) expect_on_the_ground(page, index);
}

TEST_F(CommandLine, ARunThatWasStoppedIsReportedAsFarAsItIs) {
  ASSERT_EQ(dobbench(kShortRun + std::string(" --out run")).exit_code, 0);
  const dob::Run whole = dob::read_run(dir / "run");
  {
    // The same run with one of its cells only.
    const std::string name = whole.info.sources.front().scenario;
    const std::string toml = dob::test::read(dir / "run" / "scenarios" / (name + ".toml"));
    dob::RunStore store = dob::RunStore::create(dir / "part", whole.info, {{name, toml}});
    store.append(whole.cells.front());
  }
  const Answer answer = dobbench("report part");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("3 of 4 cells have not been run"), std::string::npos) << answer.out;
  EXPECT_NE(answer.out.find("traces/"), std::string::npos) << "its trace is not there: " << answer.out;
  const Page page = read_page(dir / "part" / "report.html");
  EXPECT_EQ(page.data["cells"][3]["outcome"], "pending");
  EXPECT_EQ(page.data["scenarios"][0]["duration_s"], 1.5);
}

TEST_F(CommandLine, ARunWithoutTimeSeriesIsAPageThatSaysHowToKeepThem) {
  ASSERT_EQ(dobbench(kShortRun + std::string(" --keep none --out run")).exit_code, 0);
  const Answer answer = dobbench("report run -o page.html");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.out.find("--keep first-seed"), std::string::npos) << answer.out;
  EXPECT_TRUE(read_page(dir / "page.html").data["traces"].empty());
  EXPECT_FALSE(fs::exists(dir / "run" / "report.html"));
}

TEST_F(CommandLine, WhatCannotBeReportedIsRefusedAndNothingIsWritten) {
  expect_refused("report", {"dir"});
  expect_refused("report nowhere", {"nowhere: no such directory"});
  fs::create_directories(dir / "foreign");
  std::ofstream(dir / "foreign" / "notes.txt") << "not mine";
  expect_refused("report foreign", {"foreign: is not a run directory"});
  EXPECT_FALSE(fs::exists(dir / "foreign" / "report.html"));
  fs::create_directories(dir / "broken");
  std::ofstream(dir / "broken" / "run.sqlite") << std::string(5000, 'x');
  expect_refused("report broken", {"broken/run.sqlite: "});

  { const dob::RunStore store = dob::RunStore::create(dir / "run", {}, {}); }
  expect_refused("report run -o missing/page.html", {"missing/page.html: cannot be written"});
  expect_refused("report run -o foreign", {"-o foreign", ".html"});
  expect_refused("report run -o run/run.sqlite", {"-o run/run.sqlite", ".html"});
  expect_refused("report run --max-size 0.000001", {"report.html: the page takes", "--max-size"});
  expect_refused("report run --max-size -1", {"--max-size"});
  expect_refused("report run --max-size much", {"--max-size"});
  fs::create_directories(dir / "taken.html" / "by");
  expect_refused("report run -o taken.html", {"taken.html: cannot be written"});
  EXPECT_FALSE(fs::exists(dir / "taken.html.part"));
  EXPECT_TRUE(dob::is_run_directory(dir / "run"));
}

}  // namespace
}  // namespace dob::report_command_test
