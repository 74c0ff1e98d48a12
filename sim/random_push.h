// Pushes at random points of the legs (case study 4): every hold_s a new draw of leg, height, horizontal direction and
// magnitude, which holds until the next one.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "robot/description.h"
#include "sim/disturbance.h"

namespace dob {

struct RandomPush {
  double min_N = 0.0;                                             // [N] magnitude, uniform from here
  double max_N = 0.0;                                             // [N] to here
  double hold_s = 2.0;                                            // [s] how long a draw lasts
  double start_s = 0.0;                                           // [s] of the first draw
  double duration_s = std::numeric_limits<double>::infinity();    // [s] of all draws together; may be infinite
  std::vector<Leg> legs{Leg::kLF, Leg::kRF, Leg::kLH, Leg::kRH};  // drawn with equal probability

  // Throws std::invalid_argument naming the field, the value and what is allowed.
  void validate() const;
};

// The draws that begin before end_s [s], one constant disturbance each, without gaps and without overlap. The point is
// uniform in length on the line hip pitch joint - knee - centre of the foot sphere, the direction uniform in the
// horizontal plane of W. Equal seed and `stream` give equal draws, whatever else happens in a trial; an earlier end
// only cuts the list. Throws as validate().
std::vector<Disturbance> draw_pushes(const RandomPush& push, const RobotDescription& robot, std::uint64_t seed,
                                     std::uint32_t stream, double end_s);

}  // namespace dob
