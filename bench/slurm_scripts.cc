#include "bench/slurm_scripts.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "bench/shell_words.h"
#include "scenarios/input_error.h"

namespace dob {
namespace {

constexpr std::string_view kSbatch = "#SBATCH ";

// D-HH:MM:SS, the days left out or not. An hour has 60 minutes, a day of a limit needs not have 24 hours.
bool is_time(std::string_view text) {
  const auto digits = [](std::string_view part, std::size_t least, std::size_t most) {
    return part.size() >= least && part.size() <= most &&
           std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  if (const std::size_t dash = text.find('-'); dash != std::string_view::npos) {
    if (!digits(text.substr(0, dash), 1, 3)) return false;
    text.remove_prefix(dash + 1);
  }
  const std::size_t hours = text.find(':');
  if (hours == std::string_view::npos || !digits(text.substr(0, hours), 1, 3)) return false;
  const std::string_view rest = text.substr(hours + 1);
  return rest.size() == 5 && rest[2] == ':' && digits(rest.substr(0, 2), 2, 2) && digits(rest.substr(3), 2, 2) &&
         rest[0] < '6' && rest[3] < '6';
}

bool is_partition(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_-.,").find(static_cast<char>(c)) != std::string_view::npos;
  });
}

// To sbatch a backslash anywhere in the name of a log means that %A and %a are no place holders; a line ends its
// option.
void require_path(const std::string& option, const std::filesystem::path& path) {
  const std::string text = path.string();
  const bool bad =
      std::any_of(text.begin(), text.end(), [](unsigned char c) { return c == '\\' || c < 0x20 || c == 0x7f; });
  if (bad) throw InputError({option}, text, "allowed for Slurm: a path without backslashes and control characters");
}

// A value as sbatch reads it from a #SBATCH line.
std::string sbatch_quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out.push_back('\\');
    out.push_back(c);
  }
  return out + '"';
}

// The name of a log: of a path, % would begin a place holder.
std::string log_file(const SlurmOptions& options, std::string_view name) {
  std::string out;
  for (const char c : options.dir.string()) out.append(c == '%' ? 2 : 1, c);
  return sbatch_quoted(fmt::format("{}/logs/{}", out, name));
}

std::string quoted(const std::filesystem::path& path) {
  return join_words({path.string()});
}

// What both jobs ask of Slurm. A job that is begun again on another node adds to its log.
std::string requests(const SlurmOptions& options, int cpus) {
  std::string text = fmt::format("#SBATCH --cpus-per-task={}\n", cpus);
  if (options.memory_MB > 0) text += fmt::format("#SBATCH --mem={}M\n", options.memory_MB);
  if (!options.time.empty()) text += fmt::format("#SBATCH --time={}\n", options.time);
  if (!options.partition.empty()) text += fmt::format("#SBATCH --partition={}\n", options.partition);
  return text + "#SBATCH --requeue\n#SBATCH --open-mode=append\n";
}

std::string array_script(const SlurmOptions& options) {
  std::string head =
      fmt::format("#!/bin/sh\n#SBATCH --job-name={}\n#SBATCH --array=1-{}\n#SBATCH --output={}\n",
                  sbatch_quoted(options.campaign.stem().string()), options.tasks, log_file(options, "%A_%a.out"));
  std::string more;
  if (!options.campaign_arguments.empty()) more.append(1, ' ').append(join_words(options.campaign_arguments));
  return head + requests(options, options.cpus) +
         fmt::format(R"(# One shard of a campaign, begun or gone on with; written by `dobbench slurm`.
#   all shards:      sbatch array.sbatch                (with the merge behind it: ./submit)
#   shard 3 again:   sbatch --array=3 array.sbatch      (./submit 3)
#   without Slurm:   DOB_SHARD=3 sh array.sbatch
set -eu
# How many shards there are is fixed here and not taken from SLURM_ARRAY_TASK_COUNT: of a task that is submitted again
# alone that is 1. (DOB_SHARDS: another number of shards, for an array as long and a directory without shards.)
shards=${{DOB_SHARDS:-{shards}}}
shard=${{SLURM_ARRAY_TASK_ID:-${{DOB_SHARD:?the number of a shard, 1 to $shards}}}}
out={dir}/shards/$shard
cd {working_directory}
# exec: a signal from Slurm reaches the program, which then keeps what it has finished.
exec {program} campaign {campaign} \
  --shard "$shard/$shards" --out "$out" --resume --jobs "${{SLURM_CPUS_PER_TASK:-{cpus}}}"{more}
)",
                     fmt::arg("shards", options.tasks), fmt::arg("dir", quoted(options.dir)),
                     fmt::arg("working_directory", quoted(options.working_directory)),
                     fmt::arg("program", quoted(options.program)), fmt::arg("campaign", quoted(options.campaign)),
                     fmt::arg("cpus", options.cpus), fmt::arg("more", more));
}

std::string merge_script(const SlurmOptions& options) {
  return fmt::format("#!/bin/sh\n#SBATCH --job-name={}\n#SBATCH --output={}\n",
                     sbatch_quoted(options.campaign.stem().string() + " merge"), log_file(options, "merge_%j.out")) +
         requests(options, 1) +
         fmt::format(R"(# Merges what the shards have into one run directory, merged/; written by `dobbench slurm`.
# Exit code 3: something is missing, and the log says what.   without Slurm:  sh merge.sbatch
set -eu
dir={}
for store in "$dir"/shards/*/run.sqlite; do
  [ ! -e "$store" ] || set -- "$@" "${{store%/run.sqlite}}"
done
[ $# -gt 0 ] || {{ echo "$dir/shards: no shard has begun" >&2; exit 3; }}
exec {} merge "$@" --out "$dir/merged"
)",
                     quoted(options.dir), quoted(options.program));
}

std::string submit_script(const SlurmOptions& options) {
  return fmt::format(R"(#!/bin/sh
# Submits the array and, for when all its tasks have ended, however they ended, the merge; written by `dobbench slurm`.
#   usage: submit [TASKS]     TASKS as `sbatch --array` has them, 3 or 2,5-7: these again; default: all
set -eu
cd {}
array=$(sbatch --parsable ${{1:+"--array=$1"}} array.sbatch)
array=${{array%%;*}}  # what may follow is the cluster's name
echo "array job $array"
# singleton: two merges never write at the same time.
merge=$(sbatch --parsable --dependency="afterany:$array,singleton" merge.sbatch)
echo "merge job ${{merge%%;*}}"
)",
                     quoted(options.dir));
}

std::string without_requests(const std::string& script) {
  std::istringstream in(script);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(kSbatch)) out += line + '\n';
  }
  return out;
}

}  // namespace

void validate(const SlurmOptions& options) {
  if (!options.time.empty() && !is_time(options.time))
    throw InputError({"--time"}, options.time, "allowed: HH:MM:SS or DAYS-HH:MM:SS");
  if (!is_partition(options.partition))
    throw InputError({"--partition"}, options.partition,
                     "allowed: letters, digits, '_', '-', '.' and, between names, ','");
  require_path("--out", options.dir);
  require_path("FILE", options.campaign);
}

SlurmScripts slurm_scripts(const SlurmOptions& options) {
  return {array_script(options), merge_script(options), submit_script(options)};
}

bool same_shards(const std::string& script, const std::string& other) {
  return without_requests(script) == without_requests(other);
}

}  // namespace dob
