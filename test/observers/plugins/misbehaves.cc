// A plugin that estimates nothing of use and, from its hundredth tick on, does what its option `how` says. The batch
// that runs it is to have a row with the reason, and nothing else is to change.
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include "observers/plugin_api.h"
#include "test/support/pipe_home.h"

namespace {

void write_home(const void* bytes, std::size_t size) {
  if (::write(dob::test::pipe_home(), bytes, size) < 0) std::abort();
}

// A child that lives on, with everything open that its parent had; its number is in LEFT_BEHIND.
void leave_a_child_behind(bool in_its_own_session) {
  if (const pid_t child = ::fork(); child != 0) {
    std::ofstream("LEFT_BEHIND") << child;
    return;
  }
  if (in_its_own_session) ::setsid();
  ::alarm(60);  // so that no test leaves anything behind for long
  dob::test::sleep_for_ever();
}

void exhaust_the_memory() {
  constexpr std::size_t kBlock = std::size_t{20} << 30U;  // 20 GB
  char* block = new char[kBlock];
  std::memset(block, 1, kBlock);
  std::printf("%d", block[kBlock / 2]);
}

void flood_the_pipe() {
  const std::array<char, 4096> block{};
  for (const int pipe = dob::test::pipe_home(); ::write(pipe, block.data(), block.size()) > 0;) continue;
}

void close_the_pipe_and_stay() {
  ::close(dob::test::pipe_home());
  dob::test::sleep_for_ever();
}

void misbehave(const std::string& how) {
  if (how == "segfault") std::raise(SIGSEGV);
  if (how == "abort") std::abort();
  if (how == "throw") throw std::runtime_error("out of ideas");
  if (how == "allocate") exhaust_the_memory();
  if (how == "sleep") dob::test::sleep_for_ever();
  if (how == "exit") std::exit(0);
  if (how == "fork") leave_a_child_behind(false);
  if (how == "daemon") leave_a_child_behind(true);
  if (how == "fork_and_exit") {
    leave_a_child_behind(false);
    ::_exit(0);
  }
  if (how == "garbage") write_home("garbage", 7);
  if (how == "truncate") {
    write_home("dobw+00000000000000ff", 21);
    ::_exit(0);
  }
  if (how == "flood") flood_the_pipe();
  if (how == "close") close_the_pipe_and_stay();
  if (how == "stop") std::raise(SIGSTOP);
  if (how == "leave_group") {
    ::setpgid(0, ::getpgid(::getppid()));
    dob::test::sleep_for_ever();
  }
  if (how == "print") {
    std::puts("printed by a plugin");
    std::fflush(stdout);
  }
}

class Misbehaves final : public dob::DisturbanceObserver {
 public:
  explicit Misbehaves(std::string how) : how_(std::move(how)) {}
  std::string_view name() const noexcept override { return "misbehaves"; }
  void reset(const dob::ModelTerms& /*now*/) noexcept override { ticks_ = 0; }
  dob::Estimate update(const dob::ObserverInput& /*input*/) noexcept override {
    constexpr int kBegin = 100;
    dob::Estimate estimate{.has_legs = true, .has_com = true};
    if (++ticks_ < kBegin) return estimate;
    if (ticks_ == kBegin) misbehave(how_);
    if (how_ == "nan_legs") estimate.leg_torque[3] = std::numeric_limits<double>::quiet_NaN();
    if (how_ == "nan_com") estimate.com_wrench[5] = std::numeric_limits<double>::quiet_NaN();
    if (how_ == "huge") estimate.com_wrench[5] = 1e200;
    return estimate;
  }

 private:
  std::string how_;
  int ticks_ = 0;
};

std::unique_ptr<dob::DisturbanceObserver> make(const dob::ObserverOptions& options, double /*dt*/) {
  dob::OptionReader reader("misbehaves", options);
  const std::string how = reader.choice("how", {"not",
                                                "segfault",
                                                "abort",
                                                "throw",
                                                "allocate",
                                                "sleep",
                                                "exit",
                                                "fork",
                                                "daemon",
                                                "fork_and_exit",
                                                "garbage",
                                                "truncate",
                                                "flood",
                                                "close",
                                                "stop",
                                                "leave_group",
                                                "print",
                                                "nan_legs",
                                                "nan_com",
                                                "huge",
                                                "crash_when_made",
                                                "exit_when_made",
                                                "sleep_when_made"});
  reader.refuse_unknown();
  if (how == "crash_when_made") std::raise(SIGSEGV);
  if (how == "exit_when_made") std::exit(0);
  if (how == "sleep_when_made") dob::test::sleep_for_ever();
  return std::make_unique<Misbehaves>(how);
}

}  // namespace

const dob::ObserverPlugin* dob_observer_plugin() {
  static constexpr dob::ObserverPlugin plugin{.name = "misbehaves",
                                              .summary = "for tests",
                                              .source = "here",
                                              .estimates_legs = true,
                                              .estimates_com = true,
                                              .make = make};
  return &plugin;
}
