// DogBot in the nominal standing pose, for tests of planner and controller.
#pragma once

#include <string>

#include "controller/motion_planner.h"
#include "robot/model.h"
#include "robot/standing_pose.h"

namespace dob::test {

inline Model dogbot_model() {
  return Model(load_robot(DOB_SOURCE_DIR "/robot/dogbot/dogbot.urdf", Forward::kMinusY));
}

inline ModelTerms standing_dogbot(const Model& model, const PlannerOptions& options = {}) {
  ModelTerms m;
  model.compute(
      standing_pose(model, options.com_height, options.footsteps.foot_offset_x, options.footsteps.foot_offset_y,
                    {{"front_right_pitch", 0.886},
                     {"front_left_pitch", -0.884},
                     {"back_right_pitch", 0.886},
                     {"back_left_pitch", -0.884},
                     {"front_right_knee", 1.604},
                     {"front_left_knee", -1.604},
                     {"back_right_knee", 1.604},
                     {"back_left_knee", -1.604}}),
      m);
  return m;
}

}  // namespace dob::test
