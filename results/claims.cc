#include "results/claims.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace dob {
namespace {

bool asks_for(const Claim& claim, const std::string& observer) {
  return std::find(claim.observers.begin(), claim.observers.end(), observer) != claim.observers.end();
}

// Cells of the claim's observers that have not run.
int missing_runs(const Claim& claim, const ClaimView& view) {
  int missing = 0;
  for (const std::string& observer : claim.observers) {
    for (const CellGroup* group : view.groups(observer))
      missing += group->planned - static_cast<int>(group->ran.size());
  }
  // The case that an offset is compared with belongs to no row.
  if (const auto* offset = std::get_if<OffsetClaim>(&claim.test)) {
    const CellGroup* reference = view.group(offset->reference, offset->observer);
    if (reference != nullptr) missing += reference->planned - static_cast<int>(reference->ran.size());
  }
  return missing;
}

bool is_about_falls(const Claim& claim) {
  return std::holds_alternative<FallClaim>(claim.test) || std::holds_alternative<SurviveClaim>(claim.test);
}

// Of "KEY=VALUE; KEY=VALUE": a trial lasts for duration_s or else as long as its path.
bool change_duration(const std::string& overrides) {
  for (std::size_t begin = 0; begin < overrides.size();) {
    const std::string key = overrides.substr(begin, overrides.find('=', begin) - begin);
    if (key.starts_with("duration_s") || key.starts_with("path")) return true;
    const std::size_t end = overrides.find("; ", begin);
    begin = end == std::string::npos ? overrides.size() : end + 2;
  }
  return false;
}

// A claim holds, or does not, when all its runs say so; only what a single run decides is decided earlier.
Finding finding_of(const Claim& claim, const ClaimView& view) {
  if (is_about_falls(claim) && change_duration(view.setting().overrides)) {
    return no_data("does not last as long as the paper's");
  }
  Finding finding = std::visit([&](const auto& test) { return evaluate(test, view); }, claim.test);
  const int missing = missing_runs(claim, view);
  if (missing == 0) return finding;
  finding.remark += fmt::format("{}{} runs are missing", finding.remark.empty() ? "" : "; ", missing);
  if (!finding.settled) finding.verdict = Verdict::kNoData;
  return finding;
}

// In the order of the run.
std::vector<Setting> settings_of(const Claim& claim, const std::vector<std::string>& cases, const CellGroups& cells) {
  std::vector<Setting> settings, without_profile;
  for (const CellGroup& group : cells.all()) {
    const CellKey& key = group.key;
    if (!asks_for(claim, key.observer) || std::find(cases.begin(), cases.end(), case_name(key)) == cases.end())
      continue;
    const Setting setting{key.profile, key.gains, key.planner, key.overrides};
    std::vector<Setting>& list = key.profile == "-" ? without_profile : settings;
    if (std::find(list.begin(), list.end(), setting) == list.end()) list.push_back(setting);
  }
  return settings.empty() ? without_profile : settings;
}

// Every pattern a list of its own, or all in one.
std::vector<std::vector<std::string>> rows_of(const Claim& claim) {
  if (claim.along) return {claim.cells};
  std::vector<std::vector<std::string>> rows;
  for (const std::string& pattern : claim.cells) rows.push_back({pattern});
  return rows;
}

std::string shown_cells(const std::vector<std::string>& patterns) {
  return patterns.size() < 3 ? fmt::format("{}", fmt::join(patterns, ", "))
                             : fmt::format("{} to {}", patterns.front(), patterns.back());
}

std::vector<std::string> cases_of(const std::vector<std::string>& patterns, const CellGroups& cells) {
  std::vector<std::string> cases;
  for (const std::string& pattern : patterns) {
    const std::vector<std::string> names = cells.cases(pattern);
    cases.insert(cases.end(), names.begin(), names.end());
  }
  return cases;
}

std::string name_of(const Contrast& contrast) {
  std::vector<std::string> parts;
  if (!contrast.observer.empty()) parts.push_back(contrast.observer);
  if (!contrast.profile.empty()) parts.push_back("profile " + contrast.profile);
  if (!contrast.gains.empty()) parts.push_back("gains " + contrast.gains);
  if (!contrast.planner.empty()) parts.push_back("planner " + contrast.planner);
  if (!contrast.overrides.empty()) parts.push_back(contrast.overrides);
  return fmt::format("{}", fmt::join(parts, ", "));
}

Setting with(const Contrast& contrast, Setting setting) {
  if (!contrast.profile.empty()) setting.profile = contrast.profile;
  if (!contrast.gains.empty()) setting.gains = contrast.gains;
  if (!contrast.planner.empty()) setting.planner = contrast.planner;
  if (!contrast.overrides.empty()) setting.overrides = contrast.overrides;
  return setting;
}

struct Source {
  CellGroups cells;
  bool recorded;
};

// nullopt: no run knows, or it would be the row itself.
std::optional<ContrastFinding> ask(const Claim& claim, const std::string& subject, const Contrast& contrast,
                                   const ClaimRow& row, const std::vector<std::string>& patterns,
                                   const std::vector<Source>& sources) {
  if (!contrast.observer.empty() && !asks_for(claim, subject)) return std::nullopt;
  const Setting setting = with(contrast, row.setting);
  if (contrast.observer.empty() && setting == row.setting) return std::nullopt;
  for (const Source& source : sources) {
    ClaimView view(source.cells, cases_of(patterns, source.cells), setting);
    if (!contrast.observer.empty()) view.substitute(subject, contrast.observer);
    Finding finding = finding_of(claim, view);
    if (finding.verdict != Verdict::kNoData) return ContrastFinding{name_of(contrast), source.recorded, finding};
  }
  return std::nullopt;
}

std::string described(const std::vector<ContrastFinding>& contrasts, Verdict verdict, const std::string& words) {
  std::vector<std::string> parts;
  for (const ContrastFinding& contrast : contrasts) {
    if (contrast.finding.verdict != verdict) continue;
    parts.push_back(
        fmt::format("{} ({}{})", contrast.name, contrast.finding.measured, contrast.recorded ? ", recorded" : ""));
  }
  return parts.empty() ? "" : fmt::format("{} {}", words, fmt::join(parts, ", "));
}

std::string note_of(const ClaimRow& row) {
  std::vector<std::string> parts{row.finding.remark, described(row.contrasts, Verdict::kNo, "also fails with"),
                                 described(row.contrasts, Verdict::kYes, "holds with")};
  std::erase(parts, "");
  return fmt::format("{}", fmt::join(parts, "; "));
}

// Where to look: the run in question, then recorded ones.
using Sources = std::vector<Source>;

ClaimRow row_of(const ClaimSet& set, const Claim& claim, const std::vector<std::string>& patterns,
                const Setting& setting, const Sources& sources) {
  ClaimRow row{.claim = &claim, .cells = shown_cells(patterns), .setting = setting, .planned = true};
  const CellGroups& cells = sources.front().cells;
  ClaimView view(cells, cases_of(patterns, cells), setting);
  row.finding = finding_of(claim, view);
  if (asks_for(claim, set.subject)) {
    view.substitute(set.subject, set.ours);
    row.ours = finding_of(claim, view);
  }
  if (row.finding.verdict == Verdict::kNo) {
    for (const Contrast& contrast : claim.contrasts) {
      auto found = ask(claim, set.subject, contrast, row, patterns, sources);
      if (found) row.contrasts.push_back(std::move(*found));
    }
  }
  row.note = note_of(row);
  return row;
}

ClaimRow absent_row(const Claim& claim, const std::vector<std::string>& patterns) {
  ClaimRow row{.claim = &claim, .cells = shown_cells(patterns), .finding = no_data("not part of this run")};
  row.note = row.finding.remark;
  return row;
}

}  // namespace

std::vector<ClaimRow> evaluate_claims(const ClaimSet& set, const Run& run, const std::vector<Run>& recorded) {
  Sources sources{{CellGroups(run), false}};
  for (const Run& other : recorded) sources.push_back({CellGroups(other), true});
  const CellGroups& cells = sources.front().cells;

  std::vector<ClaimRow> rows;
  for (const Claim& claim : set.claims) {
    for (const std::vector<std::string>& patterns : rows_of(claim)) {
      const std::vector<Setting> settings = settings_of(claim, cases_of(patterns, cells), cells);
      if (settings.empty()) rows.push_back(absent_row(claim, patterns));
      for (const Setting& setting : settings) rows.push_back(row_of(set, claim, patterns, setting, sources));
    }
  }
  return rows;
}

}  // namespace dob
