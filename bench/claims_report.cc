#include "bench/claims_report.h"

#include <fmt/format.h>

#include "results/claims.h"
#include "results/claims_table.h"

namespace dob {

std::string claims_report(const Run& run, TableFormat format, const std::vector<std::string>& recorded) {
  const ClaimSet set = load_claims(paper_claims_file());
  std::vector<Run> others;
  std::vector<std::string> origins;
  for (const std::string& other : recorded) {
    others.push_back(read_run(other));
    origins.push_back(fmt::format("{} ({})", others.back().info.command_line, others.back().info.commit));
  }
  return render_claims(set, evaluate_claims(set, run, others), format, origins);
}

}  // namespace dob
