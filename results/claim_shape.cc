#include "results/claim_shape.h"

#include <algorithm>

#include <fmt/format.h>

#include "results/claim_keys.h"
#include "results/claim_pairs.h"
#include "results/metric_fields.h"
#include "results/statistics.h"

namespace dob {
namespace {

constexpr std::size_t kPush = metric_index("com_peak_push_m");
constexpr std::size_t kRecovery = metric_index("com_peak_recovery_m");

bool has_two_peaks(const CellResult& cell) {
  const CellMetrics& m = cell.metrics;
  if (cell.outcome != Outcome::kSurvived || !m.com_peak_push_m || !m.com_peak_recovery_m) return false;
  return std::min(*m.com_peak_push_m, *m.com_peak_recovery_m) > m.com_peak_before_m.value_or(0.0);
}

std::optional<double> largest(const std::vector<Sample>& samples) {
  const auto less = [](const Sample& a, const Sample& b) { return a.value < b.value; };
  const auto found = std::max_element(samples.begin(), samples.end(), less);
  return found == samples.end() ? std::nullopt : std::optional(found->value);
}

void add_falls(Finding& finding) {
  if (finding.falls > 0) finding.measured += ", " + describe_falls(finding);
}

// Both metrics of one run.
struct TwoFigures {
  double one, other;
  const CellGroup* group;
};

std::vector<TwoFigures> runs_with_both(const LargerClaim& claim, const std::vector<const CellGroup*>& groups) {
  std::vector<TwoFigures> runs;
  for (const CellGroup* group : groups) {
    for (const CellResult* cell : group->ran) {
      const auto one = kMetricFields.at(claim.metric).of(cell->metrics);
      const auto other = kMetricFields.at(claim.than).of(cell->metrics);
      if (cell->outcome == Outcome::kSurvived && one && other) runs.push_back({*one, *other, group});
    }
  }
  return runs;
}

bool smaller_ratio(const TwoFigures& a, const TwoFigures& b) {
  return a.one * b.other < b.one * a.other;  // errors are not negative
}

// Too early for a figure of walking.
bool fell_at_once(const CellGroup& group) {
  constexpr double kFirst = 2.0;  // [s] the start from rest, and about a second that a fall takes
  return !group.ran.empty() && std::all_of(group.ran.begin(), group.ran.end(), [](const CellResult* cell) {
    return cell->outcome == Outcome::kFell && cell->simulated_s <= kFirst;
  });
}

// ", case5/plus_30 falls 1/3 (25.1 s)" for every case with a fall.
std::string falls_of_cases(const std::vector<const CellGroup*>& groups) {
  std::string text;
  for (const CellGroup* group : groups) {
    Finding finding;
    count_falls({group}, finding);
    if (finding.falls > 0) text += fmt::format(", {} {}", case_name(group->key), describe_falls(finding));
  }
  return text;
}

}  // namespace

TwoPeaksClaim read_two_peaks(Reader& reader, const std::string& subject) {
  return {read_observer(reader, subject)};
}

LargerClaim read_larger(Reader& reader, const std::string& subject) {
  LargerClaim claim;
  claim.observer = read_observer(reader, subject);
  claim.metric = read_metric(reader, "metric");
  claim.than = read_metric(reader, "than");
  return claim;
}

GrowsClaim read_grows(Reader& reader, const std::string& subject) {
  return {read_observer(reader, subject), read_metric(reader, "metric")};
}

Finding evaluate(const TwoPeaksClaim& claim, const ClaimView& view) {
  const std::vector<const CellGroup*> groups = view.groups(claim.observer);
  const std::vector<Sample> push = samples_of(groups, kPush), recovery = samples_of(groups, kRecovery);
  Finding finding;
  count_falls(groups, finding);
  if (finding.runs == 0) return no_data(fmt::format("{} has not been run", view.name_of(claim.observer)));
  if (push.empty() && finding.falls == 0) return no_data("no run has a pulse");
  int with = 0;
  for (const CellGroup* group : groups) {
    for (const CellResult* cell : group->ran) with += has_two_peaks(*cell) ? 1 : 0;
  }
  finding.median = median_of(push);
  finding.worst = largest(push);
  finding.measured = fmt::format("two peaks in {}/{}", with, finding.runs);
  if (!push.empty()) finding.measured += fmt::format(": {}", describe(kPush, *finding.median));
  if (!recovery.empty()) finding.measured += fmt::format(", {}", describe(kRecovery, *median_of(recovery)));
  add_falls(finding);
  finding.verdict = with == finding.runs ? Verdict::kYes : Verdict::kNo;
  finding.settled = with < finding.runs;
  return finding;
}

Finding evaluate(const LargerClaim& claim, const ClaimView& view) {
  const std::vector<const CellGroup*> groups = view.groups(claim.observer);
  const std::vector<TwoFigures> runs = runs_with_both(claim, groups);
  Finding finding;
  count_falls(groups, finding);
  if (finding.runs == 0) return no_data(fmt::format("{} has not been run", view.name_of(claim.observer)));
  if (runs.empty()) {
    return no_data(fmt::format("no run of {} that survived has both {} and {}", view.name_of(claim.observer),
                               kMetricFields.at(claim.metric).name, kMetricFields.at(claim.than).name));
  }
  std::vector<double> figures;
  figures.reserve(runs.size());
  for (const TwoFigures& run : runs) figures.push_back(run.one);
  const TwoFigures& least = *std::min_element(runs.begin(), runs.end(), smaller_ratio);
  const auto held = std::count_if(runs.begin(), runs.end(), [](const TwoFigures& run) { return run.one > run.other; });
  finding.median = median(figures);
  finding.worst = least.one;
  finding.measured = fmt::format("{} against {}", describe(claim.metric, least.one), describe(claim.than, least.other));
  if (groups.size() > 1) finding.measured += fmt::format(" in {}", case_name(least.group->key));
  if (runs.size() > 1) finding.measured += fmt::format(", larger in {}/{}", held, runs.size());
  add_falls(finding);
  finding.settled = held < std::ssize(runs);
  finding.verdict = finding.settled ? Verdict::kNo : Verdict::kYes;
  return finding;
}

Finding evaluate(const GrowsClaim& claim, const ClaimView& view) {
  const std::vector<const CellGroup*> groups = view.groups(claim.observer);
  if (groups.size() < 2) {
    return no_data(fmt::format("{} has not been run in two of the cases", view.name_of(claim.observer)));
  }
  Finding finding;
  count_falls(groups, finding);
  for (const CellGroup* group : groups) {
    if (fell_at_once(*group)) return no_data(fmt::format("all runs of {} fall at once", case_name(group->key)));
  }
  bool grows = true;
  std::string before;  // as shown last
  for (std::size_t i = 1; i < groups.size(); ++i) {
    const PairedFigures pair = pair_by_seed(*groups[i - 1], *groups[i], claim.metric);
    if (pair.a.empty()) {
      return no_data(
          fmt::format("no runs of {} and {} compare", case_name(groups[i - 1]->key), case_name(groups[i]->key)));
    }
    const double from = median(pair.a), to = median(pair.b);
    grows = grows && from < to;
    if (!finding.median) finding.median = from;
    finding.worst = to;
    if (before != describe(claim.metric, from)) {  // of other runs, or over another stretch of time
      finding.measured += (before.empty() ? "" : "; ") + describe(claim.metric, from);
    }
    before = describe(claim.metric, to);
    finding.measured += " -> " + before;
    if (pair.until) finding.measured += fmt::format(" (on common time from {:.1f} s)", *pair.until);
  }
  finding.measured += falls_of_cases(groups);
  finding.verdict = grows ? Verdict::kYes : Verdict::kNo;
  return finding;
}

}  // namespace dob
