#include "sim/payload.h"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr double kTimeSlack = 1e-9;  // [s]

void require(bool allowed, std::string_view field, double value, std::string_view expected) {
  if (!allowed) throw std::invalid_argument(fmt::format("payload: {} = {}, must be {}", field, value, expected));
}

}  // namespace

void Payload::validate() const {
  require(std::isfinite(start_s), "start_s", start_s, "finite");
  require(std::isfinite(mass) && mass > 0.0, "mass", mass, "finite and > 0");
  for (const double component : p_B) require(std::isfinite(component), "p_B", component, "finite");
}

bool Payload::on(double t) const noexcept {
  return t >= start_s - kTimeSlack;
}

}  // namespace dob
