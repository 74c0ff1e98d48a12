#include "observers/momentum_exact.h"

namespace dob {

ExactFilterOptions read_exact_filter_options(OptionReader& reader, const std::string& prefix) {
  ExactFilterOptions options;
  options.gain = reader.number(prefix + "gain_rad_s", options.gain, kGainRange);
  return options;
}

}  // namespace dob
