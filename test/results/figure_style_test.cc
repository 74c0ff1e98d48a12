#include "results/figure_style.h"

#include <gtest/gtest.h>

namespace dob {
namespace {

TEST(ObserverLooks, AreThoseOfTheReportPage) {
  const auto looks = observer_looks({"none", "momentum", "kalman", "com_wrench", "eso"});
  EXPECT_EQ(looks.at("none").colour, "#777777");
  EXPECT_EQ(looks.at("momentum").colour, "#0072B2");
  EXPECT_EQ(looks.at("com_wrench").colour, "#E69F00");
  EXPECT_EQ(looks.at("nonlinear_dob").colour, "#009E73");
  EXPECT_EQ(looks.at("momentum_com").colour, "#D55E00");
  EXPECT_EQ(looks.at("oracle_full").colour, "#000000");
  EXPECT_EQ(looks.at("kalman").colour, "#CC79A7");  // the others in their order
  EXPECT_EQ(looks.at("eso").colour, "#56B4E9");
}

TEST(ObserverLooks, OfAnObserverWithOptionsTakeNoOthersLook) {
  const auto looks = observer_looks({"momentum:gains=6.28", "kalman"});
  EXPECT_EQ(looks.at("kalman").colour, "#CC79A7");
  EXPECT_EQ(looks.at("momentum:gains=6.28").colour, "#56B4E9");
}

TEST(ObserverLooks, DifferInMoreThanTheColour) {
  const auto looks = observer_looks({"a", "b", "c", "d", "e", "f"});
  for (const auto& [name, look] : looks) {
    for (const auto& [other_name, other] : looks) {
      if (name == other_name) continue;
      EXPECT_NE(look.point, other.point) << name << ", " << other_name;
    }
  }
}

TEST(NumberedLooks, DifferInColourAndDash) {
  for (std::size_t a = 0; a < 5; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_NE(numbered_look(a).colour, numbered_look(b).colour);
      EXPECT_NE(numbered_look(a).dash, numbered_look(b).dash);
    }
  }
}

}  // namespace
}  // namespace dob
