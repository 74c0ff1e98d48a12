#include "controller/goldfarb_idnani.h"

#include <stdexcept>
#include <string>

namespace dob {

void QpOptions::validate() const {
  if (iteration_limit <= 0) {
    throw std::invalid_argument("QpOptions.iteration_limit = " + std::to_string(iteration_limit) + ", must be > 0");
  }
  if (!(kkt_tolerance > 0.0 && kkt_tolerance < 1.0)) {
    throw std::invalid_argument("QpOptions.kkt_tolerance = " + std::to_string(kkt_tolerance) +
                                ", must be between 0 and 1");
  }
}

template class GoldfarbIdnani<12, 44>;

}  // namespace dob
