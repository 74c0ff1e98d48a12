#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "bench/batch.h"
#include "bench/commands.h"
#include "bench/number_between.h"
#include "bench/worker_options.h"
#include "bench/worker_pool.h"
#include "observers/analysis.h"
#include "observers/factory.h"
#include "robot/standing_pose.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

using Json = nlohmann::ordered_json;

// Section 5.1 to the letter.
constexpr const char* kAsPrinted = "momentum:gains=17.5;6.28;2.25,allow_unstable=true";

struct AnalyseArguments {
  std::vector<std::string> observers;
  std::vector<std::string> profiles;
  double tick = 0.0;  // [s] 0: that of the scenarios
  bool json = false;
  WorkerOptions workers{.memory_limit_MB = kDefaultMemoryLimit_MB};
};

struct Row {
  std::string observer, profile;
  ChannelAnalysis figures;
};

std::string channel_name(Channel channel) {
  switch (channel) {
    case Channel::kLegTorque:
      return "legs";
    case Channel::kComForce:
      return "com_force";
    case Channel::kComMoment:
      return "com_moment";
  }
  return "";
}

const char* unit(Channel channel) {
  return channel == Channel::kComForce ? "N" : "Nm";
}

double to_Hz(double rad_s) {
  return rad_s / (2.0 * std::numbers::pi);
}

std::string gains_text(const MomentumGains& gains) {
  return fmt::format("{:.6g}", fmt::join(gains.K, "; "));
}

// s^3 + 17.5 s^2 + 109.9 s + 247.3
std::string denominator_text(const std::vector<double>& c) {
  const auto power = [](std::size_t j) { return j == 0 ? "" : j == 1 ? " s" : fmt::format(" s^{}", j); };
  std::string text = power(c.size()).substr(1);
  for (std::size_t j = c.size(); j-- > 0;) text += fmt::format(" + {:.5g}{}", c[j], power(j));
  return text;
}

std::vector<double> first_column(const MomentumGains& gains) {
  std::vector<double> column;
  for (const auto& row : routh(gains).rows) column.push_back(row.front());
  return column;
}

// What the figures mean, in words; empty when there is nothing to warn of.
std::string remark(const ChannelAnalysis& a) {
  if (a.discrete_stable) return "";
  if (!a.linear) return "the answer to a step does not settle at this tick";
  if (a.stable) return "stable as a continuous filter, but the update is unstable at this tick";
  const MomentumGains& gains = a.linear->gains;
  const MomentumGains reversed{{gains.K.rbegin(), gains.K.rend()}};
  const bool printed = gains.K == std::vector<double>{17.5, 6.28, 2.25};
  const auto slowest = poles(gains).front();
  const bool marginal = std::abs(slowest.real()) < 1e-9 * std::abs(slowest);
  std::string text = fmt::format(
      "{}K = {} rad/s, are {}: poles {} rad/s", printed ? "the paper's gains as printed, " : "the gains ",
      gains_text(gains), marginal ? "marginal, an oscillation that never decays" : "unstable", format_poles(gains));
  if (routh(reversed).stable) {
    text += fmt::format(
        "; in reversed order, K = {} rad/s, they are stable, -3 dB at {:.3f} Hz ({:.3g} rad/s), natural "
        "frequency {:.3f} Hz",
        gains_text(reversed), to_Hz(bandwidth(reversed)), bandwidth(reversed), to_Hz(natural_frequency(reversed)));
  } else if (reversed.K != gains.K) {
    text += "; in reversed order they are not stable either";
  }
  return text;
}

Json to_json(const Row& row, double dt) {
  const ChannelAnalysis& a = row.figures;
  const auto or_null = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  Json json{{"observer", row.observer},
            {"profile", row.profile},
            {"channel", channel_name(a.channel)},
            {"method", a.linear ? "transfer_function" : "measured"},
            {fmt::format("amplitude_{}", unit(a.channel)), a.amplitude},
            {"dt_s", dt},
            {"order", nullptr},
            {"gains_rad_s", nullptr},
            {"denominator", nullptr},
            {"poles", nullptr},
            {"stable", a.stable},
            {"routh", nullptr}};
  if (a.linear) {
    const MomentumGains& gains = a.linear->gains;
    Json pole_list = Json::array();
    for (const auto& p : poles(gains)) pole_list.push_back({p.real(), p.imag()});
    json["order"] = gains.K.size();
    json["gains_rad_s"] = gains.K;
    json["denominator"] = coefficients(gains);
    json["denominator"].push_back(1.0);
    json["poles"] = pole_list;
    json["routh"] = {{"first_column", first_column(gains)}, {"stable", routh(gains).stable}};
  }
  json["static_gain"] = or_null(a.static_gain);
  json["bandwidth_rad_s"] = or_null(a.bandwidth);
  json["delay_s"] = or_null(a.delay);
  json["overshoot"] = or_null(a.overshoot);
  json["settling_time_s"] = or_null(a.settling_time);
  json["noise_gain"] = or_null(a.noise_gain);
  json["discrete_stable"] = a.discrete_stable;
  json["max_stable_dt_s"] = or_null(a.max_stable_dt);
  json["remark"] = remark(a);
  return json;
}

std::string figure(const std::optional<double>& x, double scale, const char* form) {
  return x ? fmt::format(fmt::runtime(form), scale * *x) : "-";
}

std::string largest_tick(const ChannelAnalysis& a) {
  if (!a.max_stable_dt) return "as far as ticks of 1 s";
  if (*a.max_stable_dt == 0.0) return "at no tick";
  return fmt::format("up to {:.3g} ms", 1e3 * *a.max_stable_dt);
}

std::string answer_text(const ChannelAnalysis& a) {
  return fmt::format(
      "  answer       -3 dB {} Hz, delay {} ms, overshoot {} %, settling (2 %) {} ms, noise gain {}, static gain {}\n",
      figure(a.bandwidth, to_Hz(1.0), "{:.3f}"), figure(a.delay, 1e3, "{:.1f}"), figure(a.overshoot, 1e2, "{:.1f}"),
      figure(a.settling_time, 1e3, "{:.0f}"), figure(a.noise_gain, 1.0, "{:.4f}"),
      figure(a.static_gain, 1.0, "{:.3f}"));
}

std::string to_text(const Row& row, double dt) {
  const ChannelAnalysis& a = row.figures;
  std::string text;
  const auto line = [&text](fmt::string_view form, const auto&... values) {
    fmt::vformat_to(std::back_inserter(text), form, fmt::make_format_args(values...));
    text += '\n';
  };
  line("{}, profile {}: {} ({}, step of {:g} {})", row.observer, row.profile, channel_name(a.channel),
       a.linear ? "transfer function" : "measured", a.amplitude, unit(a.channel));
  if (a.linear) {
    const MomentumGains& gains = a.linear->gains;
    const std::vector<double> c = coefficients(gains);
    line("  gains        K = {} rad/s, order {}", gains_text(gains), gains.K.size());
    line("  G(s)         {:.5g} / ({})", c[0], denominator_text(c));
    line("  poles        {} rad/s", format_poles(gains));
    line("  Routh        first column {:.4g}: {}", fmt::join(first_column(gains), ", "),
         routh(gains).stable ? "stable" : "NOT stable");
  }
  line("  tick {:g} ms  {}, {}", 1e3 * dt, a.discrete_stable ? "stable" : "NOT stable", largest_tick(a));
  if (a.discrete_stable) text += answer_text(a);
  if (const std::string words = remark(a); !words.empty()) line("  NOTE         {}", words);
  return text + "\n";
}

// The robot of the scenarios' defaults, standing.
ModelTerms standing_robot(const Scenario& s) {
  const Model model(load_robot(s.robot.urdf, s.robot.forward));
  ModelTerms terms;
  model.compute(standing_pose(model, s.planner.com_height, s.planner.footsteps.foot_offset_x,
                              s.planner.footsteps.foot_offset_y, s.robot.posture),
                terms);
  return terms;
}

// Every observer of every profile once; the paper's gains as printed beside them when nothing else was asked for.
std::vector<ObserverConfig> requested(const AnalyseArguments& arguments, double dt) {
  std::vector<std::string> names = arguments.observers;
  if (names.empty()) {
    for (const ObserverInfo& info : built_in_observers()) {
      if (!info.oracle) names.emplace_back(info.name);  // an oracle is told the truth by a trial
    }
  }
  const std::vector<std::string> profiles = arguments.profiles.empty() ? list_profiles() : arguments.profiles;
  std::vector<ObserverConfig> configs;
  std::set<std::pair<std::string, std::string>> seen;
  const auto add = [&](const std::string& name, const std::string& profile) {
    ObserverConfig config = load_observer(name, profile, dt);
    if (seen.emplace(config.label, config.profile).second) configs.push_back(std::move(config));
  };
  for (const std::string& name : names) {
    for (const std::string& profile : profiles) add(name, profile);
  }
  const bool paper = std::find(profiles.begin(), profiles.end(), "paper") != profiles.end();
  if (paper && arguments.observers.empty()) add(kAsPrinted, "paper");
  return configs;
}

// Of one observer: a JSON array of its channels, or text.
std::string analysed(const ObserverConfig& config, const ModelTerms& pose, double dt, bool as_json) {
  const auto make = [&](double tick) { return make_observer(config.observer, config.options, tick); };
  const std::vector<ChannelAnalysis> channels = analyse(make, pose, dt);
  Json rows = Json::array();
  std::string text = channels.empty() ? fmt::format("{}: estimates nothing\n\n", config.label) : "";
  for (const ChannelAnalysis& figures : channels) {
    const Row row{config.label, config.profile, figures};
    if (as_json) {
      rows.push_back(to_json(row, dt));
    } else {
      text += to_text(row, dt);
    }
  }
  return as_json ? rows.dump() : text;
}

int run(const AnalyseArguments& arguments) {
  const Scenario scenario = load_scenarios({.name = "undisturbed"}).at(0);
  const double dt = arguments.tick > 0.0 ? arguments.tick : scenario.sim.dt;
  const std::vector<ObserverConfig> configs = requested(arguments, dt);
  const ModelTerms pose = standing_robot(scenario);
  // In processes of their own, as a plugin may crash, and in the order asked for.
  std::vector<std::optional<TaskOutcome>> outcomes(configs.size());
  Json all = Json::array();
  std::size_t next = 0;
  bool failed = false;
  const auto print_what_is_there = [&] {
    for (; next < outcomes.size() && outcomes[next]; ++next) {
      const TaskOutcome& outcome = *outcomes[next];
      if (!outcome.ok) {
        failed = true;
        fmt::print(stderr, "analyse: {}, profile {}: {}\n", configs[next].label, configs[next].profile, outcome.reason);
      } else if (arguments.json) {
        for (Json& row : Json::parse(outcome.output)) all.push_back(std::move(row));
      } else {
        fmt::print("{}", outcome.output);
      }
    }
  };
  const int signal = run_in_processes(
      configs.size(), arguments.workers, [&](std::size_t i) { return analysed(configs[i], pose, dt, arguments.json); },
      [&](std::size_t i, const TaskOutcome& outcome) {
        outcomes[i] = outcome;
        print_what_is_there();
      });
  if (signal != 0) return kExitSignal + signal;
  if (arguments.json) fmt::print("{}\n", all.dump(2));
  return failed ? kExitCellErrors : kExitOk;
}

}  // namespace

Command add_analyse_command(CLI::App& app) {
  auto arguments = std::make_shared<AnalyseArguments>();
  CLI::App* command =
      app.add_subcommand("analyse", "poles, stability, bandwidth, delay, overshoot and noise gain of observers");
  command->add_option("observer", arguments->observers, "NAME[:key=value,...]; every built-in one by default");
  command->add_option("--profile", arguments->profiles, "gains of the observers; every one by default")
      ->allow_extra_args(false);
  command->add_option("--tick", arguments->tick, "control tick [s] (default: that of the scenarios)")
      ->check(number_between(1e-6, 1.0));
  command->add_flag("--json", arguments->json, "as JSON");
  add_worker_options(*command, arguments->workers, "observer");
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
