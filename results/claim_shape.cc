#include "results/claim_shape.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/claim_keys.h"
#include "results/metric_fields.h"

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
  const std::vector<Sample> samples = samples_of(groups, claim.metric);
  const std::optional<double> one = largest(samples), other = largest(samples_of(groups, claim.than));
  if (!one || !other) {
    const std::size_t missing = one ? claim.than : claim.metric;
    return no_data(fmt::format("{} has no {}", view.name_of(claim.observer), kMetricFields.at(missing).name));
  }
  Finding finding;
  count_falls(groups, finding);
  finding.median = median_of(samples);
  finding.worst = one;
  finding.measured = fmt::format("{} against {}", describe(claim.metric, *one), describe(claim.than, *other));
  add_falls(finding);
  finding.verdict = *one > *other ? Verdict::kYes : Verdict::kNo;
  return finding;
}

Finding evaluate(const GrowsClaim& claim, const ClaimView& view) {
  const std::vector<const CellGroup*> groups = view.groups(claim.observer);
  std::vector<double> medians;
  std::vector<std::string> shown;
  for (const CellGroup* group : groups) {
    const std::optional<double> median = median_of(samples_of({group}, claim.metric));
    if (!median) return no_data(fmt::format("no figure of {}", case_name(group->key)));
    medians.push_back(*median);
    shown.push_back(describe(claim.metric, *median));
  }
  if (medians.size() < 2)
    return no_data(fmt::format("{} has not been run in two of the cases", view.name_of(claim.observer)));
  Finding finding;
  count_falls(groups, finding);
  finding.median = medians.front();
  finding.worst = medians.back();
  finding.measured = fmt::format("{}", fmt::join(shown, " -> "));
  add_falls(finding);
  const bool grows = std::adjacent_find(medians.begin(), medians.end(), std::greater_equal<>()) == medians.end();
  finding.verdict = grows ? Verdict::kYes : Verdict::kNo;
  return finding;
}

}  // namespace dob
