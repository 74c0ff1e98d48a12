#include "scenarios/gain_keys.h"

#include <algorithm>

#include "observers/momentum.h"

namespace dob {

void drop_replaced_gains(Node& table, const Node& overlay) {
  auto* entries = std::get_if<Table>(&table.value);
  if (entries == nullptr || !std::holds_alternative<Table>(overlay.value)) return;
  for (Entry& e : *entries) {
    if (const Node* part = overlay.find(e.key)) drop_replaced_gains(e.node, *part);
  }
  const auto given = [&](std::string_view key) { return overlay.find(key) != nullptr; };
  if (std::none_of(kMomentumGainKeys.begin(), kMomentumGainKeys.end(), given)) return;
  for (const std::string_view key : kMomentumGainKeys) {
    if (table.find(key) == nullptr || given(key)) continue;
    erase(table, key);
    erase(table, "order");
    erase(table, "bandwidth_rad_s");
  }
  if (given("family")) erase(table, "gain_scale");
}

}  // namespace dob
