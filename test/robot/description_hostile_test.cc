// Files that are no robot descriptions at all, broken ones, and several loads at once: an error, never a crash.
#include <array>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/description.h"
#include "test/robot/urdf_text.h"

namespace dob::description_hostile_test {
namespace {

using test::dogbot_text;
using test::load_error;
using test::replaced;
using test::TemporaryUrdf;

TEST(UnreadableFile, IsNamedWithTheReason) {
  EXPECT_THAT(load_error("/no/such/robot.urdf"),
              testing::AllOf(testing::StartsWith("/no/such/robot.urdf: "), testing::HasSubstr("No such file")));
  EXPECT_THAT(load_error(testing::TempDir()), testing::HasSubstr("is a directory"));
  EXPECT_THAT(load_error(TemporaryUrdf("").path()), testing::HasSubstr("not valid XML"));
  EXPECT_THAT(load_error(TemporaryUrdf("<robot name=\"x\"/>").path()), testing::HasSubstr("No link elements"));
}

TEST(UnreadableFile, TooLargeOrTooManyElementsIsRefusedBeforeParsing) {
  const TemporaryUrdf large(dogbot_text() + std::string(5U << 20U, ' '));
  EXPECT_THAT(load_error(large.path()), testing::HasSubstr("is larger than"));
  std::string nested;
  for (int depth = 0; depth < 200000; ++depth) {
    nested += "<a>";
  }
  EXPECT_THAT(load_error(TemporaryUrdf(nested).path()), testing::HasSubstr("200000 XML elements; at most 5000"));
}

TEST(UnreadableFile, NestedAsDeeplyAsAllowedStillEndsInAnError) {
  std::string nested = "<robot name=\"x\">";
  for (int depth = 0; depth < 4990; ++depth) {
    nested += "<a>";
  }
  EXPECT_THAT(load_error(TemporaryUrdf(nested).path()), testing::HasSubstr("not valid XML"));
}

TEST(HostileFile, CutAnywhereIsAnError) {
  const std::string text = dogbot_text();
  const std::size_t complete = text.rfind("</robot>") + std::string("</robot>").size();
  for (std::size_t size = 0; size < complete; size += 97) {
    const TemporaryUrdf file(text.substr(0, size));
    EXPECT_THAT(load_error(file.path()), testing::StartsWith(file.path().string())) << "cut to " << size << " bytes";
  }
}

TEST(HostileFile, RandomDamageEndsInARobotOrADescriptionError) {
  const std::string text = dogbot_text();
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> place(0, text.size() - 1);
  std::uniform_int_distribution<int> byte(1, 255);
  int refused = 0;
  for (int sample = 0; sample < 300; ++sample) {
    std::string damaged = text;
    for (int change = 0; change < 1 + sample % 8; ++change) {
      damaged[place(random)] = static_cast<char>(byte(random));
    }
    const TemporaryUrdf file(damaged);
    refused += load_error(file.path()).empty() ? 0 : 1;  // anything but a DescriptionError ends the test
  }
  EXPECT_GT(refused, 100);
}

TEST(ConcurrentLoads, KeepTheirMessagesApart) {
  const TemporaryUrdf good(dogbot_text(), "_good");
  const std::array<TemporaryUrdf, 2> bad{TemporaryUrdf(replaced(dogbot_text(), "revolute", "first"), "_first"),
                                         TemporaryUrdf(replaced(dogbot_text(), "revolute", "second"), "_second")};
  constexpr std::size_t kThreads = 6;
  constexpr int kLoads = 50;
  std::array<int, kThreads> wrong{};
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      for (int load = 0; load < kLoads; ++load) {
        const std::string message = load_error(i % 3 == 2 ? good.path() : bad.at(i % 3).path());
        const bool first = message.find("[first]") != std::string::npos;
        const bool second = message.find("[second]") != std::string::npos;
        wrong.at(i) += first == (i % 3 == 0) && second == (i % 3 == 1) ? 0 : 1;
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(wrong, (std::array<int, kThreads>{}));
}

}  // namespace
}  // namespace dob::description_hostile_test
