#include "scenarios/stored_observer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "observers/factory.h"
#include "scenarios/loader.h"

namespace dob::stored_observer_test {
namespace {

using ::testing::HasSubstr;

void expect_same(const ObserverConfig& a, const ObserverConfig& b) {
  EXPECT_EQ(a.observer, b.observer);
  EXPECT_EQ(a.options, b.options) << a.observer;
  EXPECT_EQ(observer_toml(a), observer_toml(b));
}

TEST(StoredObserver, EveryObserverInEveryProfileReadsBack) {
  int options = 0;
  for (const ObserverInfo& info : built_in_observers()) {
    for (const std::string& profile : list_profiles()) {
      const ObserverConfig config = load_observer(info.name, profile);
      expect_same(read_observer_toml(observer_toml(config), "store").observer, config);
      options += static_cast<int>(config.options.size());
    }
  }
  EXPECT_GT(options, 10);
}

TEST(StoredObserver, OptionsOfEveryTypePairsAndShadowsReadBack) {
  ObserverConfig observer = load_observer("legs=momentum,com=com_wrench,legs.gain_scale=0.1", "paper");
  observer.options["a_flag"] = true;
  observer.options["a_text"] = std::string("1.5 \"quoted\"\n");
  observer.options["a_number"] = 0.1 + 0.2;
  observer.options["legs.a_list"] = std::vector<double>{1.0, -0.0, 1e-300};
  observer.routing.swing_31 = Routing::Swing::kDirect;
  observer.routing.wrench_source = Routing::WrenchSource::kAllLegs;
  const std::vector<ObserverConfig> shadows{load_observer("momentum:gain_scale=2", "matched"),
                                            load_observer("none", "paper")};
  const StoredObservers back =
      read_observer_toml("# /tmp/a.so holds 0123\n" + observer_toml(observer, shadows), "store");
  expect_same(back.observer, observer);
  ASSERT_EQ(back.shadows.size(), 2U);
  expect_same(back.shadows[0], shadows[0]);
  expect_same(back.shadows[1], shadows[1]);
}

std::string error_of(const std::string& text) {
  try {
    read_observer_toml(text, "store");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(StoredObserver, WhatIsNotOneIsRefusedWithItsPlace) {
  EXPECT_THAT(error_of(""), HasSubstr("observer: allowed: an observer's name"));
  EXPECT_THAT(error_of("observer = 3"), HasSubstr("observer: allowed: an observer's name"));
  EXPECT_THAT(error_of("observer = \"a\"\nhidden = 1"), HasSubstr("store:2:1: hidden: unknown"));
  EXPECT_THAT(error_of("observer = \"a\"\noptions = 1"), HasSubstr("options: 1; allowed: a table"));
  EXPECT_THAT(error_of("observer = \"a\"\nshadow = 1"), HasSubstr("shadow: allowed: a list of tables"));
  EXPECT_THAT(error_of("observer = \"a\"\n[routing]\nswing_31 = \"up\""), HasSubstr("one of off, projected, direct"));
  EXPECT_THAT(error_of("observer = \"a"), HasSubstr("store:1:"));
}

}  // namespace
}  // namespace dob::stored_observer_test
