// A hash of a trajectory: equal bits of every state, equal hash.
#pragma once

#include <cstdint>
#include <cstring>

#include "robot/types.h"

namespace dob {

inline constexpr std::uint64_t kNoStates = 0xcbf29ce484222325ULL;  // the hash before the first state

// FNV-1a over words. The upper half goes back into the lower one: a product carries bits upwards only, and without that
// two changed signs would cancel.
inline std::uint64_t hash_state(std::uint64_t hash, const RobotState& s) noexcept {
  const auto add = [&hash](const double* data, int count) {
    for (int i = 0; i < count; ++i) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, data + i, sizeof bits);
      hash = (hash ^ bits) * 0x100000001b3ULL;
      hash ^= hash >> 32;
    }
  };
  add(s.p_WB.data(), 3);
  add(s.R_WB.data(), 9);
  add(s.v_WB.data(), 3);
  add(s.omega_WB.data(), 3);
  add(s.q.data(), kJoints);
  add(s.qd.data(), kJoints);
  return hash;
}

}  // namespace dob
