// Disturbances and payloads that begin when the trial is over: rows that look like any other, and are undisturbed.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scenarios/schema.h"

namespace dob {
namespace {

// It has no time of its own; a push that never comes is an error of the trial.
bool waits_for_the_gait(const Node& disturbance) {
  const Node* trigger = disturbance.find("trigger");
  const auto* word = trigger == nullptr ? nullptr : std::get_if<std::string>(&trigger->value);
  return word != nullptr && *word == "gait_phase";
}

// The elements of one array of tables, which have been read without fault.
void add_late(std::vector<std::string>& late, const Node& document, const std::string& array, const std::string& key,
              double duration, double shift) {
  const Node* node = document.find(array);
  const auto* elements = node == nullptr ? nullptr : std::get_if<Array>(&node->value);
  for (std::size_t i = 0; elements != nullptr && i < elements->size(); ++i) {
    const Node& element = (*elements)[i];
    const Node* written = element.find(key);
    if (waits_for_the_gait(element)) continue;
    const double start = written == nullptr ? 0.0 : std::get<double>(written->value);
    if (start + shift < duration) continue;
    std::string message = fmt::format("{} s; the trial is over at {} s", start, duration);
    if (start < duration) message += fmt::format(", and a seed shifts it by up to {} s", shift);
    late.emplace_back(
        InputError(written == nullptr ? element.place : written->place, fmt::format("{}.{}.{}", array, i, key), message)
            .what());
  }
}

}  // namespace

std::vector<std::string> find_late_loads(const Node& document, const Scenario& scenario, bool shifted) {
  const double shift = shifted ? scenario.seed_variation.disturbance_onset : 0.0;
  std::vector<std::string> late;
  add_late(late, document, "disturbance", "start_s", scenario.duration, shift);
  add_late(late, document, "payload", "at_s", scenario.duration, shift);
  return late;
}

}  // namespace dob
