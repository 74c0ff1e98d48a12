// Reproducible random numbers of a trial. Deviates are made here, because the standard leaves the algorithms of its
// distributions to the library.
#pragma once

#include <cstdint>
#include <random>

namespace dob {

// A stream of its own for every (seed, set, stream): what draws from one cannot shift another.
std::mt19937_64 random_stream(std::uint64_t seed, std::uint32_t set, std::uint32_t stream);

// Normal deviates of mean 0 and variance 1 (Box and Muller 1958), in pairs from two of the engine's numbers.
class NormalDeviates {
 public:
  explicit NormalDeviates(const std::mt19937_64& engine) : engine_(engine) {}

  double next() noexcept;

 private:
  std::mt19937_64 engine_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace dob
