#include <string>
#include <utility>
#include <vector>

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

// Options and routing into the tables `options` and `routing` of the document.
void lay_observer(Node& document, const ObserverConfig& o, const std::string& options, const std::string& routing) {
  for (const auto& [key, value] : o.options) set(document, options + key, std::visit(ToNode{}, value));
  const auto route = [&](const char* key, const Node& value) { set(document, routing + key, value); };
  route("wrench_17", {o.routing.wrench_17, {}});
  route("dynamics_18", {o.routing.dynamics_18, {}});
  route("wrench_source", {std::string(word(o.routing.wrench_source)), {}});
  route("torque_36", {o.routing.torque_36, {}});
  route("swing_31", {std::string(word(o.routing.swing_31)), {}});
}

Node observer_document(const ObserverConfig& observer) {
  Node document{Table{}, {}};
  set(document, "observer", {observer.observer, {}});
  lay_observer(document, observer, "options.", "routing.");
  return document;
}

}  // namespace

std::string observer_toml(const ObserverConfig& observer, const std::vector<ObserverConfig>& shadows) {
  Node document = observer_document(observer);
  Array list;
  for (const ObserverConfig& shadow : shadows) list.push_back(observer_document(shadow));
  if (!list.empty()) set(document, "shadow", {std::move(list), {}});
  return to_toml(document);
}

std::string profile_toml(const std::vector<ObserverConfig>& observers, const std::string& base) {
  Node document{Table{}, {}};
  const Node kinds = base.empty() ? Node{Table{}, {}} : parse_file(profile_file(base));
  for (const char* kind : kRoutedKinds) {
    if (const Node* routing = kinds.find(kind)) set(document, kind, *routing);
  }
  for (const ObserverConfig& o : observers) {
    lay_observer(document, o, o.observer + ".", o.observer + ".routing.");
  }
  return to_toml(document);
}

}  // namespace dob
