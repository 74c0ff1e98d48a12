#include "bench/campaign_grid.h"

#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace dob {

std::vector<Combination> combinations(const CampaignSpec& spec) {
  std::vector<Combination> all;
  for (const std::string& legs : spec.legs) {
    for (const std::string& com : spec.com) {
      const std::string observer = com == "none"    ? legs
                                   : legs == "none" ? com
                                                    : fmt::format("legs={},com={}", legs, com);
      all.push_back({observer, legs, com});
    }
  }
  return all;
}

std::vector<std::vector<std::string>> grid_of(const CampaignSpec& spec) {
  std::vector<std::vector<std::string>> all{spec.set};
  for (const std::vector<std::string>& choices : spec.grid) {
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& so_far : all) {
      for (const std::string& choice : choices) {
        longer.push_back(so_far);
        longer.back().push_back(choice);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string with_level(std::string text, double level) {
  constexpr std::string_view kPlaceOfLevel = "{}";
  const std::string number = fmt::format("{}", level);
  for (std::size_t at = text.find(kPlaceOfLevel); at != std::string::npos; at = text.find(kPlaceOfLevel, at)) {
    text.replace(at, kPlaceOfLevel.size(), number);
  }
  return text;
}

}  // namespace dob
