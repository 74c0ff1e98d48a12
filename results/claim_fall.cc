#include "results/claim_fall.h"

#include <fmt/format.h>

#include "results/claim_keys.h"

namespace dob {
namespace {

Finding falls_of(const std::string& observer, const ClaimView& view) {
  Finding finding;
  count_falls(view.groups(observer), finding);
  if (finding.runs == 0) return no_data(fmt::format("{} has not been run", view.name_of(observer)));
  finding.measured = describe_falls(finding);
  return finding;
}

}  // namespace

FallClaim read_fall(Reader& reader, const std::string& subject) {
  return {read_observer(reader, subject)};
}

SurviveClaim read_survive(Reader& reader, const std::string& subject) {
  return {read_observer(reader, subject)};
}

Finding evaluate(const FallClaim& claim, const ClaimView& view) {
  Finding finding = falls_of(claim.observer, view);
  if (finding.runs > 0) finding.verdict = 2 * finding.falls > finding.runs ? Verdict::kYes : Verdict::kNo;
  return finding;
}

Finding evaluate(const SurviveClaim& claim, const ClaimView& view) {
  Finding finding = falls_of(claim.observer, view);
  if (finding.runs > 0) finding.verdict = finding.falls == 0 ? Verdict::kYes : Verdict::kNo;
  finding.settled = finding.falls > 0;
  return finding;
}

}  // namespace dob
