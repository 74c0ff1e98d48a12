#include "bench/signals.h"

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "bench/cell_files.h"
#include "bench/tick_log.h"
#include "test/results/quiet_tick.h"
#include "test/results/run_samples.h"

namespace dob::signals_test {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream in(line + ",");
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

double value_of(const std::string& name, const TickRecord& tick) {
  for (const Signal& signal : tick_signals()) {
    if (signal.name == name) return signal.value(tick);
  }
  ADD_FAILURE() << "no signal " << name;
  return 0.0;
}

// A tick with a value in every field.
TickRecord some_tick() {
  TickRecord tick = test::quiet();
  tick.zmp_reference = tick.center_of_pressure = Vec2::Zero();
  tick.com_wrench_estimate = tick.com_wrench_true = Vec6::Zero();
  return tick;
}

TEST(Signals, NamesAreUniqueWithoutCommasAndTheFirstIsTheTime) {
  std::set<std::string> names;
  for (const Signal& signal : tick_signals()) {
    EXPECT_TRUE(names.insert(signal.name).second) << signal.name;
    EXPECT_EQ(signal.name.find_first_of(", \"\n"), std::string::npos) << signal.name;
    EXPECT_NE(signal.name.front(), '/');
    EXPECT_NE(signal.name.back(), '/');
  }
  EXPECT_EQ(tick_signals().front().name, "t_s");
}

TEST(Signals, HaveTheValuesOfTheTick) {
  TickRecord tick = some_tick();
  tick.t = 0.25;
  tick.com = tick.com_reference + Vec3(0.0, 0.003, 0.004);
  tick.foot[2] = Vec3(1.0, 2.0, 3.0);
  tick.foot_force[3 * 1 + 2] = 52.0;
  tick.leg_torque_estimate[3 * 3 + 1] = 7.0;
  EXPECT_NEAR(value_of("com_error_m", tick), 0.005, 1e-15);
  EXPECT_EQ(value_of("LH/foot/y_m", tick), 2.0);
  EXPECT_EQ(value_of("RF/force/z_N", tick), 52.0);
  EXPECT_TRUE(std::isnan(value_of("RH/upper/estimate_Nm", tick)));  // the observer makes none
  tick.has_leg_estimate = true;
  EXPECT_EQ(value_of("RH/upper/estimate_Nm", tick), 7.0);
  EXPECT_TRUE(std::isnan(value_of("applied/point/x_m", tick)));
}

TEST(Signals, DecimationKeepsTheFirstTickAndNeverMakesUpTicks) {
  Decimation every_fifth(200.0, 1e-3);
  std::vector<int> kept;
  for (int i = 0; i < 12; ++i) {
    if (every_fifth.keep()) kept.push_back(i);
  }
  EXPECT_EQ(kept, (std::vector<int>{0, 5, 10}));
  EXPECT_DOUBLE_EQ(every_fifth.rate(), 200.0);
  EXPECT_DOUBLE_EQ(Decimation(5000.0, 1e-3).rate(), 1000.0);
}

TEST(TickLog, HasAHeadingAndOneLinePerKeptTickWithTimesThatIncrease) {
  const test::TemporaryDirectory temporary;
  const auto file = temporary.path() / "log.csv";
  TickLog log(file, 500.0, 1e-3);
  TickRecord tick = some_tick();
  for (int i = 0; i < 10; ++i) {
    tick.t = 1e-3 * i;
    log.add(tick);
  }
  log.close();
  std::ifstream in(file);
  std::string line;
  ASSERT_TRUE(std::getline(in, line));
  const std::vector<std::string> names = split(line);
  EXPECT_EQ(names.front(), "t_s");
  EXPECT_EQ(names.size(), tick_signals().size());
  std::vector<double> times;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = split(line);
    ASSERT_EQ(values.size(), names.size());
    times.push_back(std::stod(values.front()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool applies = names[i].find("/estimate_Nm") == std::string::npos &&
                           names[i].find("_estimate/") == std::string::npos &&
                           names[i].find("applied/point/") == std::string::npos;
      EXPECT_EQ(values[i].empty(), !applies) << names[i];
      if (applies) {
        EXPECT_NO_THROW(std::stod(values[i])) << names[i];
      }
    }
  }
  EXPECT_EQ(times, (std::vector<double>{0.0, 0.002, 0.004, 0.006, 0.008}));
}

TEST(TickLog, AFileThatCannotBeMadeIsAStoreError) {
  EXPECT_THROW(TickLog("/nonexistent/log.csv", 1000.0, 1e-3), StoreError);
}

TEST(TraceRecorder, KeepsTheSignalsAtItsRate) {
  TraceRecorder recorder(250.0, 1e-3);
  TickRecord tick = some_tick();
  for (int i = 0; i < 9; ++i) {
    tick.t = 1e-3 * i;
    tick.foot[0].x() = i;
    recorder.add(tick);
  }
  EXPECT_DOUBLE_EQ(recorder.trace().rate_Hz, 250.0);
  EXPECT_EQ(recorder.trace().column("LF/foot/x_m"), (std::vector<float>{0.0F, 4.0F, 8.0F}));
}

TEST(CellFiles, NamesAreUniqueInTheRunAndSafe) {
  const CellKey a = test::key("case1", "knee", "momentum:gains=1;2", "paper", 1);
  const std::string name = cell_file_name(0, a);
  EXPECT_EQ(name, "00001_case1_knee_momentum_gains_1_2_paper_paper_spline_seed1");
  EXPECT_NE(name, cell_file_name(1, a));
  CellKey longer = a;
  longer.observer = std::string(5000, '/');
  EXPECT_LT(cell_file_name(7, longer).size(), 200U);
  EXPECT_EQ(cell_file_name(7, longer).find('/'), std::string::npos);
}

}  // namespace
}  // namespace dob::signals_test
