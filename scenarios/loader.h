// From names and files to checked values. Everything below throws InputError for the first thing that is wrong;
// nothing is ever written, and a value that is returned can be run.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/input_error.h"
#include "scenarios/scenario.h"

namespace dob {

// Text of a file with the place where it stands.
struct WrittenText {
  std::string text;
  Place place;
};

// What a batch that names no scenario runs, and what it leaves out.
enum class ScenarioSet { kPaper, kExtra };

constexpr std::string_view to_string(ScenarioSet set) noexcept {
  return set == ScenarioSet::kPaper ? "paper" : "extra";
}

struct ScenarioInfo {
  std::string name;
  std::vector<std::string> variants;  // in the order of the file; empty when it has none
  std::string summary;                // one line
  std::filesystem::path path;
  ScenarioSet set = ScenarioSet::kExtra;
  std::vector<WrittenText> observers;  // specifications of the observers that the scenario is about; empty: all
  std::vector<WrittenText> profiles;   // with which those are run; empty: all
};

// The shipped ones, sorted by name.
std::vector<ScenarioInfo> list_scenarios();
// Of a name or a file, without or with a variant.
ScenarioInfo scenario_info(const std::string& request);
std::vector<std::string> list_profiles();
std::vector<std::string> list_gain_sets();  // in the order of config/gains.toml

// What a user asks for. Layers, the later over the earlier: config/defaults.toml, the scenario that the file names as
// its base, the file, its variant, the gain set, the planner, the overrides in their order. Tables are merged key by
// key; everything else is replaced, arrays too, unless the layer names elements of theirs (`disturbance.0.phase =
// 0.3`). A file or variant that chooses another robot starts with no posture, as that names the joints of one robot.
struct ScenarioRequest {
  std::string name;          // "case1", "case1/knee_lateral", "dir/mine.toml" or "dir/mine.toml/VARIANT"
  std::string gains = {};    // a gain set; "": the scenario's own [gains], else the set "paper"
  std::string planner = {};  // planner.kind; "": the scenario's own
  // `KEY=VALUE`: a dotted path (`sim.dt_s`, `disturbance.0.amplitude_N`; elements count from 0) and a TOML
  // value; a string that is one word needs no quotes.
  std::vector<std::string> overrides = {};
};

// One for each variant of the file, or the one that was asked for, or one with variant "" when the file has none.
std::vector<Scenario> load_scenarios(const ScenarioRequest& request);

// One of these scenarios as a merged document: a file that loads, whatever the shipped files have become, to
// the same Scenario. `variant` as in the Scenario.
std::string resolved_toml(const ScenarioRequest& request, std::string_view variant);

// What of this scenario begins when the trial is over already, of the disturbances (those that wait for the gait aside)
// and payloads: one line each, with its place. `shifted`: when a seed shifts it as far as it may. Not an error of
// loading, so that anybody may run the beginning of a scenario.
std::vector<std::string> late_loads(const ScenarioRequest& request, std::string_view variant, bool shifted);

// The observer `NAME` or `NAME:key=value,key=value`, where NAME may be the path of a plugin (observers/plugin.h, its
// table in a profile is [plugin.NAME]), or the pair `legs=NAME,com=NAME` with `,legs.key=value` and
// `,com.key=value` behind it, with the profile's options and routing, over which those of the specification are laid
// (`routing.torque_36=false`, lists as `gains=1.0;2.0`). A profile may give the routing for a kind of estimate
// ([legs.routing], [com.routing], [pair.routing] for both, and for pairs), over which that of an observer's own table
// is laid; the options of a pair's parts are those of their own tables. An observer that the profile does not mention,
// or that estimates nothing, gets its built-in defaults and the profile "-"; so does an oracle, with its kind's
// routing. It is made once for a tick of dt [s], so that what it refuses (unknown options, unstable gains) is refused
// here. `place`: where the specification was written; without a source, as --observer on the command line.
ObserverConfig load_observer(std::string_view specification, const std::string& profile, double dt = SimOptions{}.dt,
                             const Place& place = {});

// Is the TOML file a profile, tables of observers, rather than a scenario?
bool is_profile(const std::filesystem::path& file);

// Every built-in observer that estimates something, with what the profile in this file makes of it.
std::vector<ObserverConfig> load_profile(const std::filesystem::path& file);

// All that a cell's observer is made of, and those that watch it, as text:
//   observer = "NAME"      in the factory, the absolute path of a plugin, or a pair
//   [options], [routing]   options of a pair's parts as legs.KEY and com.KEY
//   [[shadow]]             the same for each of the others
std::string observer_toml(const ObserverConfig& observer, const std::vector<ObserverConfig>& shadows = {});

// A profile as text: a table per observer with its options and its routing, which load_observer() reads back; with the
// routing of kinds of `base`, another profile, if one is named.
std::string profile_toml(const std::vector<ObserverConfig>& observers, const std::string& base = {});

}  // namespace dob
