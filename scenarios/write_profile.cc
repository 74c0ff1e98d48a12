#include <fmt/format.h>

#include "scenarios/data_directory.h"
#include "scenarios/document.h"
#include "scenarios/loader.h"
#include "scenarios/profile_kinds.h"

namespace dob {
namespace {

struct ToNode {
  template <typename T>
  Node operator()(const T& value) const {
    return {value, {}};
  }
  Node operator()(const std::vector<double>& list) const {
    Array array;
    for (const double number : list) array.push_back({number, {}});
    return {std::move(array), {}};
  }
};

const char* word(Routing::Swing swing) {
  switch (swing) {
    case Routing::Swing::kOff:
      return "off";
    case Routing::Swing::kProjected:
      return "projected";
    case Routing::Swing::kDirect:
      return "direct";
  }
  return "";
}

const char* word(Routing::WrenchSource source) {
  switch (source) {
    case Routing::WrenchSource::kCom:
      return "com";
    case Routing::WrenchSource::kStanceLegs:
      return "stance_legs";
    case Routing::WrenchSource::kAllLegs:
      return "all_legs";
  }
  return "";
}

}  // namespace

std::string profile_toml(const std::vector<ObserverConfig>& observers, const std::string& base) {
  Node document{Table{}, {}};
  const Node kinds = base.empty() ? Node{Table{}, {}} : parse_file(profile_file(base));
  for (const char* kind : kRoutedKinds) {
    if (const Node* routing = kinds.find(kind)) set(document, kind, *routing);
  }
  for (const ObserverConfig& o : observers) {
    for (const auto& [key, value] : o.options) {
      set(document, fmt::format("{}.{}", o.observer, key), std::visit(ToNode{}, value));
    }
    const auto route = [&](const char* key, const Node& value) {
      set(document, fmt::format("{}.routing.{}", o.observer, key), value);
    };
    route("wrench_17", {o.routing.wrench_17, {}});
    route("dynamics_18", {o.routing.dynamics_18, {}});
    route("wrench_source", {std::string(word(o.routing.wrench_source)), {}});
    route("torque_36", {o.routing.torque_36, {}});
    route("swing_31", {std::string(word(o.routing.swing_31)), {}});
  }
  return to_toml(document);
}

}  // namespace dob
