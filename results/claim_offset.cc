#include "results/claim_offset.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "results/claim_keys.h"
#include "results/metric_fields.h"

namespace dob {
namespace {

constexpr std::size_t kOffset = metric_index("estimate_offset_Nm");

// Over every run that survived and has an estimate, the smallest share; nullopt without any.
std::optional<double> least_share(const std::vector<const CellGroup*>& groups) {
  std::optional<double> least;
  for (const CellGroup* group : groups) {
    for (const CellResult* cell : group->ran) {
      if (cell->outcome != Outcome::kSurvived) continue;
      const CellMetrics& m = cell->metrics;
      if (!m.estimate_offset_Nm || !m.joint_estimate_rmse_Nm || !(*m.joint_estimate_rmse_Nm > 0.0)) continue;
      const double share = *m.estimate_offset_Nm / *m.joint_estimate_rmse_Nm;
      least = std::min(least.value_or(share), share);
    }
  }
  return least;
}

}  // namespace

OffsetClaim read_offset(Reader& reader, const std::string& subject) {
  OffsetClaim claim;
  claim.observer = read_observer(reader, subject);
  claim.reference = reader.text("reference");
  claim.share_at_least = reader.number("share_at_least", between(0.0, 1.0));
  return claim;
}

Finding evaluate(const OffsetClaim& claim, const ClaimView& view) {
  const std::vector<const CellGroup*> groups = view.groups(claim.observer);
  const CellGroup* reference = view.group(claim.reference, claim.observer);
  const std::vector<Sample> offsets = samples_of(groups, kOffset);
  const std::optional<double> share = least_share(groups);
  const std::vector<Sample> without = reference == nullptr ? std::vector<Sample>{} : samples_of({reference}, kOffset);
  if (offsets.empty() || !share)
    return no_data(fmt::format("no run of {} that survived has an estimate", view.name_of(claim.observer)));
  if (without.empty()) return no_data(fmt::format("no figure of {} to compare with", claim.reference));
  Finding finding;
  count_falls(groups, finding);
  finding.median = median_of(offsets);
  finding.worst =
      std::min_element(offsets.begin(), offsets.end(), [](auto& a, auto& b) { return a.value < b.value; })->value;
  finding.measured = fmt::format("offset {}, {:.0f} % of the rms error; {}: {}",
                                 describe(kOffset, *finding.median, *finding.worst, offsets.size()), 100.0 * *share,
                                 claim.reference, describe(kOffset, *median_of(without)));
  if (finding.falls > 0) finding.measured += ", " + describe_falls(finding);
  const bool holds = *finding.median > *median_of(without) && *share >= claim.share_at_least;
  finding.verdict = holds ? Verdict::kYes : Verdict::kNo;
  return finding;
}

}  // namespace dob
