// Every key of the scenarios' schema and what it allows, as the program itself says when it is asked wrongly: an
// unknown key is answered with the known ones, a text in a number's place with the range.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scenarios/loader.h"
#include "test/scenarios/scratch_files.h"

namespace dob {

// A scenario in which every list of the schema has an element of each kind.
inline const std::string kEverything = kSmallest + R"(
[[disturbance]]
profile = "constant"
amplitude_N = 5.0
leg = "LF"
link = "lower"
point_m = [0, 0, 0]
direction = [0, 1, 0]
[[disturbance]]
profile = "pulse"
amplitude_N = 5.0
duration_s = 0.2
leg = "trunk"
point = "origin"
direction = [0, 1, 0]
trigger = "gait_phase"
trigger_leg = "RF"
phase = 0.1
[[disturbance]]
profile = "sine"
amplitude_N = 5.0
period_s = 1.0
leg = "LF"
link = "lower"
point = "foot"
direction = [0, 1, 0]
[[disturbance]]
profile = "ramp"
amplitude_N = 5.0
ramp_s = 1.0
leg = "LF"
link = "lower"
point = "foot"
direction = [0, 1, 0]
[[disturbance]]
profile = "chirp"
amplitude_N = 5.0
duration_s = 2.0
f0_Hz = 1.0
f1_Hz = 2.0
leg = "LF"
link = "lower"
point = "foot"
direction = [0, 1, 0]
[[disturbance]]
profile = "random"
min_N = 0.0
max_N = 1.0
hold_s = 1.0
legs = "any"
[[payload]]
at_s = 1.0
mass_kg = 1.0
point_m = [0, 0, 0]
[[gait.switch]]
at_s = 1.0
kind = "trot"
stance_s = 0.15
swing_s = 0.115
[[terrain.boxes]]
center_m = [5, 5, 0]
size_m = [1, 1, 1]
friction = 1.0
[terrain.field]
start_m = 1.2
end_m = 2.4
width_m = 0.8
tile_m = [0.15, 0.20]
heights_m = [0.015]
frictions = [0.4]
)";

class SchemaWalk {
 public:
  // What loading says with KEY=VALUE laid over; "no error".
  std::string answer(const std::string& key, const std::string& value) const {
    try {
      load_scenarios({.name = file_, .overrides = {key + "=" + value}});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  // Full dotted paths of all keys that are no tables, with what is allowed.
  std::map<std::string, std::string> keys() const {
    std::map<std::string, std::string> found;
    add("", found);
    return found;
  }

 private:
  static std::string after(const std::string& text, const std::string& mark) {
    const std::size_t at = text.rfind(mark);
    return at == std::string::npos ? "" : text.substr(at + mark.size());
  }

  void add(const std::string& table, std::map<std::string, std::string>& found) const {
    std::string list = after(answer(table + "zzzzzzzzzzzzzzzzzzzzzzzz", "1"), "; allowed: ") + ", ";
    for (std::size_t comma = 0; (comma = list.find(", ")) != std::string::npos; list.erase(0, comma + 2)) {
      if (comma == 0) continue;
      const std::string key = table + list.substr(0, comma);
      const std::string allowed = after(answer(key, "zzz"), "allowed: ");
      if (allowed == "a table") {
        if (key != "robot.posture_rad") add(key + ".", found);  // its keys are the joints of one robot
      } else if (allowed.starts_with("an array of tables")) {
        for (int i = 0; answer(key + "." + std::to_string(i) + ".x", "1").find("no element") == std::string::npos; ++i)
          add(key + "." + std::to_string(i) + ".", found);
      } else {
        found[key] = allowed;
      }
    }
  }

  ScratchFiles files_;
  std::string file_ = files_.write("everything.toml", kEverything);
};

}  // namespace dob
