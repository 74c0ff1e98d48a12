// Seeded random numbers for what a trial draws: a stream of its own for each purpose, so that what one part of a
// scenario draws does not depend on what else the scenario has.
#pragma once

#include <cstdint>
#include <random>

namespace dob {

// Equal seed, purpose and number give the same stream. `purpose` sets the streams of one kind of draw apart from
// those of another, `number` those of several of one kind.
inline std::mt19937_64 random_stream(std::uint64_t seed, std::uint32_t purpose, std::uint32_t number = 0) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U), purpose, number};
  return std::mt19937_64(sequence);
}

// In [0, 1), made here because the standard leaves std::uniform_real_distribution's algorithm to the library.
inline double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1.0p-53;
}

}  // namespace dob
