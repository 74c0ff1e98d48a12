#include "observers/sliding_mode.h"

namespace dob {

SlidingModeOptions read_sliding_mode_options(OptionReader& reader, const std::string& prefix) {
  SlidingModeOptions options;
  options.rate = reader.number(prefix + "rate", options.rate, {.above = 0.0, .max = 1e9});
  options.linear = reader.number(prefix + "linear_rad_s", options.linear, kGainOrNone);
  return options;
}

}  // namespace dob
