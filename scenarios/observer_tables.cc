#include "scenarios/observer_tables.h"

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "scenarios/reader.h"

namespace dob {
namespace {

constexpr std::array<Choice<Routing::Swing>, 3> kSwing{
    {{"off", Routing::Swing::kOff}, {"projected", Routing::Swing::kProjected}, {"direct", Routing::Swing::kDirect}}};
constexpr std::array<Choice<Routing::WrenchSource>, 3> kWrenchSource{
    {{"com", Routing::WrenchSource::kCom},
     {"stance_legs", Routing::WrenchSource::kStanceLegs},
     {"all_legs", Routing::WrenchSource::kAllLegs}}};

OptionValue option_value(const Node& node, const std::string& key) {
  if (const auto* flag = std::get_if<bool>(&node.value)) return *flag;
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  if (const auto* text = std::get_if<std::string>(&node.value)) return *text;
  std::vector<double> list;
  if (const auto* array = std::get_if<Array>(&node.value)) {
    for (const Node& element : *array) {
      if (const auto* number = std::get_if<double>(&element.value)) list.push_back(*number);
    }
    if (list.size() == array->size()) return list;
  }
  throw InputError(node.place, key, describe(node) + "; allowed: true, false, a number, a text, a list of numbers");
}

}  // namespace

void read_option(const Node& node, const std::string& observer, const std::string& key, ObserverOptions& options) {
  const auto* table = std::get_if<Table>(&node.value);
  if (table == nullptr || table->empty()) {
    options[key] = option_value(node, fmt::format("{}.{}", observer, key));
    return;
  }
  for (const Entry& e : *table) read_option(e.node, observer, fmt::format("{}.{}", key, e.key), options);
}

Routing read_routing(const Node& node, const std::string& path) {
  Routing routing;
  Reader::read(node, path, [&](Reader& r) {
    routing.wrench_17 = r.flag("wrench_17", routing.wrench_17);
    routing.dynamics_18 = r.flag("dynamics_18", routing.dynamics_18);
    routing.wrench_source = r.choice("wrench_source", kWrenchSource, std::optional(routing.wrench_source));
    routing.torque_36 = r.flag("torque_36", routing.torque_36);
    routing.swing_31 = r.choice("swing_31", kSwing, std::optional(routing.swing_31));
  });
  return routing;
}

}  // namespace dob
