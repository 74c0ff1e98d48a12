#include "scenarios/tuning.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/data_directory.h"
#include "scenarios/document.h"
#include "scenarios/reader.h"

namespace dob {
namespace {

constexpr const char* kProcedure = "procedure";
constexpr double kLargest = 1e12;
constexpr const char* kAllowed =
    "; allowed: [low, high] with 0 < low < high <= 1e12, or a list of texts, or of true and false";

std::vector<std::string> words_of(const Array& array) {
  std::vector<std::string> words;
  for (const Node& element : array) {
    if (const auto* text = std::get_if<std::string>(&element.value)) words.push_back(*text);
    if (const auto* flag = std::get_if<bool>(&element.value)) words.emplace_back(*flag ? "true" : "false");
  }
  return words;
}

TuningParameter parameter(const Entry& e, const std::string& path) {
  const auto* array = std::get_if<Array>(&e.node.value);
  if (array != nullptr) {
    const std::vector<std::string> words = words_of(*array);
    if (!words.empty() && words.size() == array->size()) return {e.key, words};
    if (array->size() == 2) {
      const auto* low = std::get_if<double>(&(*array)[0].value);
      const auto* high = std::get_if<double>(&(*array)[1].value);
      if (low != nullptr && high != nullptr && 0.0 < *low && *low < *high && *high <= kLargest)
        return {e.key, TuningRange{*low, *high}};
    }
  }
  throw InputError(e.node.place, fmt::format("{}.{}", path, e.key), describe(e.node) + kAllowed);
}

}  // namespace

TuningProcedure load_tuning_procedure() {
  const Node document = parse_file(tuning_file());
  const Node* node = document.find(kProcedure);
  if (node == nullptr) throw InputError({tuning_file().string()}, kProcedure, "is missing");
  TuningProcedure p;
  Reader::read(*node, kProcedure, [&](Reader& r) {
    constexpr int kMostSeeds = 1000000;
    p.scenarios = r.texts("scenarios");
    p.duration = r.number("duration_s", above(0.0, 1e5));
    p.first_seed = r.integer("first_seed", 1, kMostSeeds);
    p.last_seed = r.integer("last_seed", p.first_seed, kMostSeeds);
    p.gains = r.text("gains");
    p.planner = r.text("planner");
    p.profile = r.text("profile");
    p.com_scale = r.number("com_scale_m", above(0.0, 10.0));
    p.foot_scale = r.number("foot_scale_m", above(0.0, 10.0));
  });
  return p;
}

std::vector<TuningParameter> load_tuning_space(std::string_view observer) {
  const Node document = parse_file(tuning_file());
  std::vector<std::string> known;
  for (const Entry& e : table_of(document, "")) {
    if (e.key == kProcedure) continue;
    known.push_back(e.key);
    if (e.key != observer) continue;
    std::vector<TuningParameter> space;
    for (const Entry& p : table_of(e.node, e.key)) space.push_back(parameter(p, e.key));
    return space;
  }
  throw InputError(
      {tuning_file().string()}, "",
      fmt::format("there is nothing to tune for '{}'; there is for: {}", observer, fmt::join(known, ", ")));
}

}  // namespace dob
