// The errors of one foot over a trial: swing, swings that meet a disturbance at lift-off, stance, touchdown.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "results/tick_record.h"

namespace dob {

// The larger of the two; a NaN wins over everything, so that no later sample can hide it.
std::optional<double> larger(std::optional<double> a, std::optional<double> b) noexcept;

// The p99 of samples that may be empty (nullopt) or hold something not finite (NaN).
std::optional<double> p99_of(const std::vector<double>& samples);

// [m]; nullopt where there was no such tick, NaN where an error was not finite.
struct FootErrorSummary {
  std::optional<double> swing_max, swing_p99, onset_max, stance_max, foothold_max;
};

// Every swing belongs either to the swings or, if a disturbance_onset falls within its first 20 ms, to the onset
// swings: whole, from lift-off to touchdown.
class FootErrors {
 public:
  // Memory for `expected_ticks` ticks is reserved here; add() touches the heap only beyond them.
  FootErrors(int leg, double dt, std::size_t expected_ticks);

  void add(const TickRecord& tick) noexcept;

  FootErrorSummary finish() const;

  // The swing_max of finish(), without its cost.
  std::optional<double> swing_max() const noexcept { return larger(earlier_swings_max_, present_swing_max_); }

 private:
  void add_swing(const TickRecord& tick, double error) noexcept;
  void move_present_swing_to_onset() noexcept;

  std::size_t leg_;
  int onset_window_;             // [ticks] 20 ms
  std::vector<double> swing_;    // [m] one per tick of every swing that is not an onset swing
  std::size_t swing_begin_ = 0;  // of the present swing in swing_
  int swing_ticks_ = 0;          // ticks of the present swing so far
  bool in_swing_ = false;
  bool onset_swing_ = false;
  std::optional<double> earlier_swings_max_, present_swing_max_;  // of those that are not onset swings
  std::optional<double> onset_max_, stance_max_, foothold_max_;
};

}  // namespace dob
