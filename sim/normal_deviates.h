// Normal deviates, made here because the standard leaves the algorithm of std::normal_distribution to the library.
#pragma once

#include <random>

namespace dob {

// Normal deviates of mean 0 and variance 1 (Box and Muller 1958), in pairs from two of the engine's numbers.
class NormalDeviates {
 public:
  explicit NormalDeviates(const std::mt19937_64& engine) : engine_(engine) {}

  // The next of the sequence [-]; the same engine state gives the same sequence everywhere.
  double next() noexcept;

 private:
  std::mt19937_64 engine_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace dob
