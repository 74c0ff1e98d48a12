#include "scenarios/stored_observer.h"

#include "scenarios/document.h"
#include "scenarios/input_error.h"
#include "scenarios/observer_tables.h"

namespace dob {
namespace {

constexpr const char* kOptions = "options";
constexpr const char* kShadows = "shadow";

std::string read_name(const Node& document) {
  const Node* node = document.find("observer");
  const auto* text = node == nullptr ? nullptr : std::get_if<std::string>(&node->value);
  if (text != nullptr && !text->empty()) return *text;
  throw InputError(document.place, "observer", "allowed: an observer's name");
}

ObserverConfig read_one(const Node& document, bool in_a_list) {
  ObserverConfig config{read_name(document), {}, {}, {}, {}};
  for (const Entry& e : table_of(document, "")) {
    if (e.key == kOptions) {
      for (const Entry& option : table_of(e.node, kOptions)) {
        read_option(option.node, kOptions, option.key, config.options);
      }
    } else if (e.key == kRouting) {
      config.routing = read_routing(e.node, kRouting);
    } else if (e.key != "observer" && (in_a_list || e.key != kShadows)) {
      throw InputError(e.node.place, e.key, "unknown; allowed: observer, options, routing, shadow");
    }
  }
  return config;
}

}  // namespace

StoredObservers read_observer_toml(const std::string& text, const std::string& source) {
  const Node document = parse_text(text, source);
  StoredObservers stored{read_one(document, false), {}};
  const Node* shadows = document.find(kShadows);
  if (shadows == nullptr) return stored;
  const auto* list = std::get_if<Array>(&shadows->value);
  if (list == nullptr) throw InputError(shadows->place, kShadows, "allowed: a list of tables");
  for (const Node& shadow : *list) stored.shadows.push_back(read_one(shadow, true));
  return stored;
}

}  // namespace dob
