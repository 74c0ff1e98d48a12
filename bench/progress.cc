#include "bench/progress.h"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace dob {
namespace {

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string duration(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

Progress::Progress(std::size_t cells, std::size_t done, double cost, bool visible)
    : cells_(cells), done_(done), cost_(cost), visible_(visible), start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void Progress::add(const CellResult& cell, double cost) {
  ++done_;
  falls_ += cell.outcome == Outcome::kFell ? 1 : 0;
  errors_ += cell.outcome == Outcome::kError ? 1 : 0;
  cost_done_ += cost;
  if (!visible_) return;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  fmt::print(stderr, "\r\033[K{}", line(elapsed));
  std::fflush(stderr);
}

std::string Progress::line(double elapsed_s) const {
  std::string text =
      fmt::format("{}/{} cells, {}, {}", done_, cells_, counted(falls_, "fall"), counted(errors_, "error"));
  if (cost_done_ > 0.0) text += fmt::format(", {} left", duration(elapsed_s * (cost_ - cost_done_) / cost_done_));
  return text;
}

}  // namespace dob
