// Shards of one plan, each computed by itself (--shard), as one run directory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "results/store.h"

namespace dob {

struct MergeSummary {
  std::size_t planned = 0;       // cells of the whole plan
  std::size_t cells = 0;         // of the shards that are there
  std::size_t finished = 0;      // of these
  std::size_t errors = 0;        // of the finished ones: those that could not be run
  std::vector<RunShard> shards;  // those that are there, by their number
  std::vector<int> missing;      // numbers of those that are not
  std::vector<int> unfinished;   // of those that are there: what belongs to them has not been run to the end

  bool complete() const noexcept { return missing.empty() && unfinished.empty(); }
};

// Writes what is in `parts`, and what an earlier merge of the same plan in `out` has of other shards, to `out`: new,
// empty, or such a merge, which stays as it is until the new one is whole. The order of the parts does not matter, a
// part may be there twice, and of a cell that one part could not run and another one could, the result is taken. Rows
// keep their places in the plan: when nothing is missing, tables are those of a run that was never divided, byte for
// byte. Scenarios, time series and logs are copied.
// Throws StoreError for a part that belongs to another plan, is divided into another number of shards, was computed by
// another program, is from before there were shards, or says something else about a cell than another part, and for an
// `out` that holds something else; WriteError when it cannot be written.
MergeSummary merge_runs(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& out);

// Of the numbers 1 to `count`, those that are not among `shards`, and those that are and are not complete.
std::vector<int> missing_shards(const std::vector<RunShard>& shards);
std::vector<int> unfinished_shards(const std::vector<RunShard>& shards);

}  // namespace dob
