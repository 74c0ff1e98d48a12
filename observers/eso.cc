#include "observers/eso.h"

namespace dob {

EsoOptions read_eso_options(OptionReader& reader, const std::string& prefix) {
  EsoOptions options;
  options.bandwidth = reader.number(prefix + "bandwidth_rad_s", options.bandwidth, kGainRange);
  return options;
}

}  // namespace dob
