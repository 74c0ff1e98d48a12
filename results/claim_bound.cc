#include "results/claim_bound.h"

#include <algorithm>

#include <fmt/format.h>

#include "results/claim_keys.h"

namespace dob {
namespace {

// How far a value lies outside the limits; negative inside.
double excess(const BoundClaim& claim, double value) {
  return std::max({claim.at_least - value, value - claim.at_most, value - claim.below});
}

bool holds(const BoundClaim& claim, double value) {
  return value >= claim.at_least && value <= claim.at_most && value < claim.below;
}

}  // namespace

BoundClaim read_bound(Reader& reader, const std::string& subject) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  BoundClaim claim;
  claim.observer = read_observer(reader, subject);
  claim.metric = read_metric(reader, "metric");
  const std::string unit = unit_of(claim.metric).empty() ? "" : fmt::format("_{}", unit_of(claim.metric));
  claim.at_least = reader.number("at_least" + unit, kAnyNumber, -kInfinity);
  claim.at_most = reader.number("at_most" + unit, kAnyNumber, kInfinity);
  claim.below = reader.number("below" + unit, kAnyNumber, kInfinity);
  if (!reader.has("at_least" + unit) && !reader.has("at_most" + unit) && !reader.has("below" + unit)) {
    reader.text("below" + unit);  // reported as missing, unless it is there under a wrong name
  }
  claim.or_fall = reader.flag("or_fall", false);
  return claim;
}

Finding evaluate(const BoundClaim& claim, const ClaimView& view) {
  const std::vector<const CellGroup*> groups = view.groups(claim.observer);
  Finding finding;
  count_falls(groups, finding);
  if (finding.runs == 0) return no_data(fmt::format("{} has not been run", view.name_of(claim.observer)));
  const std::vector<Sample> samples = samples_of(groups, claim.metric);
  const int judged_by_fall = claim.or_fall ? finding.runs : 1;  // that many falls need no figure
  if (samples.empty() && finding.falls < judged_by_fall) return no_data("the metric does not apply to any run");
  const auto worst = std::max_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
    return excess(claim, a.value) < excess(claim, b.value);
  });
  if (worst != samples.end()) {
    finding.median = median_of(samples);
    finding.worst = worst->value;
    finding.measured = describe(claim.metric, *finding.median, worst->value, samples.size());
    if (groups.size() > 1) finding.measured += fmt::format(", worst in {}", case_name(worst->group->key));
  }
  if (finding.falls > 0) finding.measured += (finding.measured.empty() ? "" : ", ") + describe_falls(finding);
  const bool kept = (claim.or_fall || finding.falls == 0) && (samples.empty() || holds(claim, *finding.worst));
  finding.verdict = kept ? Verdict::kYes : Verdict::kNo;
  finding.settled = !kept;
  return finding;
}

}  // namespace dob
