// Parts of a plan that are computed by themselves: `--shard i/n`, later merged (results/merge.h).
#pragma once

#include <string>

#include "bench/batch_plan.h"

namespace dob {

struct ShardChoice {
  int number = 1;
  int count = 1;
};

inline constexpr int kMostShards = 100'000;

// "i/n" with 1 <= i <= n. Throws InputError.
ShardChoice parse_shard(const std::string& text);

// Leaves the cells of shard `number` in the plan, and says of what plan they are: every `count`-th one, or, of a
// campaign, those of every `count`-th curve, since what is tried next on a curve depends on its other cells. A shard
// may be left without any.
void take_shard(BatchPlan& plan, const ShardChoice& choice);

}  // namespace dob
