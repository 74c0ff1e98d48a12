#include "sim/payload.h"

#include "sim/require.h"

namespace dob {
namespace {

constexpr double kPickUpSlack = 1e-9;  // [s]

}  // namespace

void Payload::validate() const {
  const Require require{"payload"};
  require.finite("start_s", start_s);
  require.positive("mass", mass);
  for (const double component : p_B) require.finite("p_B", component);
}

bool Payload::on(double t) const noexcept {
  return t >= start_s - kPickUpSlack;
}

}  // namespace dob
