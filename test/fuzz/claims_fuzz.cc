// The file of claims: what is taken has claims that can be asked.
#include <set>

#include "results/claims.h"
#include "test/fuzz/harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const dob::fuzz::InputFile file("input.toml");
  const std::string& path = file.write(dob::fuzz::text_of(data, size));
  try {
    const dob::ClaimSet set = dob::load_claims(path);
    std::set<std::string> ids;
    for (const dob::Claim& claim : set.claims) {
      if (claim.id.empty() || !ids.insert(claim.id).second) dob::fuzz::finding("no id of its own: '" + claim.id + "'");
      if (claim.cells.empty() || claim.observers.empty()) dob::fuzz::finding("nothing to ask: " + claim.id);
    }
    const std::vector<dob::ClaimRow> rows = dob::evaluate_claims(set, {});
    if (rows.size() < set.claims.size()) dob::fuzz::finding("a claim without a row");
  } catch (const dob::InputError& error) {
    dob::fuzz::check_refusal(error.what(), {path});
  }
  return 0;
}
