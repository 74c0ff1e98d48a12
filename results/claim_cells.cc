#include "results/claim_cells.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace dob {
namespace {

bool matches(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern.front() != '*') {
    return !text.empty() && pattern.front() == text.front() && matches(pattern.substr(1), text.substr(1));
  }
  return matches(pattern.substr(1), text) || (!text.empty() && matches(pattern, text.substr(1)));
}

}  // namespace

std::string case_name(const CellKey& key) {
  return key.variant.empty() ? key.scenario : key.scenario + "/" + key.variant;
}

CellGroups::CellGroups(const Run& run) {
  std::map<CellKey, std::size_t> index;
  for (CellKey key : run.info.cells) {
    key.seed = 0;
    const auto [it, added] = index.emplace(key, groups_.size());
    if (added) groups_.push_back({.key = key});
    ++groups_[it->second].planned;
  }
  for (const CellResult& cell : run.cells) {
    CellKey key = cell.key;
    key.seed = 0;
    CellGroup& group = groups_.at(index.at(key));
    if (cell.outcome == Outcome::kError) {
      ++group.errors;
    } else {
      group.ran.push_back(&cell);
    }
  }
}

const CellGroup* CellGroups::find(const std::string& name, const std::string& observer, const Setting& setting) const {
  const auto same = [&](const CellGroup& group) {
    const CellKey& key = group.key;
    return key.observer == observer && (key.profile == setting.profile || key.profile == "-") &&
           key.gains == setting.gains && key.planner == setting.planner && key.overrides == setting.overrides &&
           case_name(key) == name;
  };
  const auto found = std::find_if(groups_.begin(), groups_.end(), same);
  return found == groups_.end() ? nullptr : &*found;
}

std::vector<std::string> CellGroups::cases(const std::string& pattern) const {
  std::vector<std::string> names;
  for (const CellGroup& group : groups_) {
    const std::string name = case_name(group.key);
    if (matches(pattern, name) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

void ClaimView::substitute(std::string observer, std::string substitute) {
  observer_ = std::move(observer);
  substitute_ = std::move(substitute);
}

const std::string& ClaimView::name_of(const std::string& observer) const {
  return observer == observer_ ? substitute_ : observer;
}

std::vector<const CellGroup*> ClaimView::groups(const std::string& observer) const {
  std::vector<const CellGroup*> groups;
  for (const std::string& name : cases_) {
    if (const CellGroup* found = group(name, observer)) groups.push_back(found);
  }
  return groups;
}

const CellGroup* ClaimView::group(const std::string& name, const std::string& observer) const {
  return cells_->find(name, name_of(observer), setting_);
}

}  // namespace dob
