// A campaign as jobs of Slurm: the text of the scripts that `dobbench slurm` writes. Every task of the array runs one
// shard; a second job merges what the shards have. The same scripts run without Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dob {

struct SlurmOptions {
  std::filesystem::path program;                     // dobbench itself
  std::filesystem::path campaign;                    // the file that the tasks read
  std::filesystem::path working_directory;           // where relative names in that file begin
  std::filesystem::path dir;                         // of the scripts, logs/, shards/ and merged/
  int tasks = 1;                                     // shards; one task of the array for each
  int cpus = 1;                                      // of a task: trials at a time
  long memory_MB = 0;                                // [MB] of a task; 0: what the cluster gives
  std::string time;                                  // limit of a task, HH:MM:SS or D-HH:MM:SS; empty: the cluster's
  std::string partition;                             // empty: the cluster's default
  std::vector<std::string> campaign_arguments = {};  // handed on to `dobbench campaign`
};

struct SlurmScripts {
  std::string array;   // array.sbatch
  std::string merge;   // merge.sbatch
  std::string submit;  // submit: hands both to sbatch
};

// Throws InputError, which names the option of the command line: a time or a partition that is none, a path that cannot
// stand in a script's #SBATCH lines.
void validate(const SlurmOptions& options);

// Of valid options, whose paths are absolute.
SlurmScripts slurm_scripts(const SlurmOptions& options);

// Whether two array scripts compute the same shards: they may differ in what they ask of Slurm only.
bool same_shards(const std::string& script, const std::string& other);

}  // namespace dob
