#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "bench/campaign_plan.h"
#include "bench/commands.h"
#include "bench/slurm_scripts.h"
#include "results/plain_files.h"
#include "results/whole_file.h"
#include "robot/text_input.h"
#include "scenarios/document_limits.h"
#include "scenarios/input_error.h"

extern char** environ;  // NOLINT: as POSIX has it

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestScript = 1 << 20;  // [bytes]

struct SlurmArguments {
  fs::path file;
  SlurmOptions slurm;
  int budget = 0;  // 0: the file's
  bool submit = false;
};

// The text of the campaign's file. Throws InputError for what the tasks would refuse, one by one and hours later.
std::string read_campaign_file(const fs::path& file, long trials) {
  if (file.extension() != ".toml" || file.stem().empty())
    throw InputError({file.string()}, "", "a campaign is a file NAME.toml");
  plan_campaign(read_campaign_spec(file.string(), {}, trials));
  return read_text_file(file, kMostBytes);
}

SlurmOptions complete(const SlurmArguments& arguments) {
  SlurmOptions options = arguments.slurm;
  const std::string name = arguments.file.stem().string();
  if (options.dir.empty()) options.dir = fs::path("dobbench-results") / name;
  options.dir = fs::absolute(options.dir).lexically_normal();
  if (!options.dir.has_filename()) options.dir = options.dir.parent_path();  // of `DIR/`
  options.campaign = options.dir / "campaign" / arguments.file.filename();
  options.working_directory = fs::current_path();
  options.program = fs::read_symlink("/proc/self/exe");
  if (arguments.budget > 0) options.campaign_arguments = {"--budget", std::to_string(arguments.budget)};
  return options;
}

// New, empty, or with the scripts of this very campaign: with others, its shards would not fit together.
void require_room(const SlurmOptions& options, const std::string& campaign, const SlurmScripts& scripts) {
  require_plain_directory(options.dir);
  if (!fs::exists(options.dir) || fs::is_empty(options.dir)) return;
  const fs::path array = options.dir / "array.sbatch";
  if (!fs::exists(array))
    throw InputError({"--out"}, options.dir.string(), "is not empty; allowed: a new or empty directory");
  require_plain_file(array);
  require_plain_file(options.campaign);
  if (fs::exists(options.campaign) && read_text_file(options.campaign, kMostBytes) == campaign &&
      same_shards(read_text_file(array, kLargestScript), scripts.array))
    return;
  throw InputError({"--out"}, options.dir.string(),
                   "holds the scripts of another campaign (other file, --tasks, --cpus, --budget, program or working "
                   "directory); allowed: a new or empty directory");
}

void write_scripts(const SlurmOptions& options, const std::string& campaign, const SlurmScripts& scripts) {
  std::error_code error;
  fs::create_directories(options.dir, error);
  if (error)
    throw WriteError(fmt::format("{}: cannot create the directory: {}", options.dir.string(), error.message()));
  for (const char* name : {"campaign", "logs", "shards"}) make_plain_directory(options.dir / name);
  write_whole_file(options.campaign, campaign);
  write_whole_file(options.dir / "merge.sbatch", scripts.merge);
  write_whole_file(options.dir / "submit", scripts.submit);
  fs::permissions(options.dir / "submit", fs::perms::owner_exec, fs::perm_options::add, error);
  write_whole_file(options.dir / "array.sbatch", scripts.array);  // the last: with it, all is there
}

// Runs DIR/submit, which prints the job ids. Throws InputError if Slurm does not take the jobs.
void submit(const fs::path& dir) {
  std::fflush(stdout);
  std::string shell = "sh";
  std::string script = (dir / "submit").string();
  const std::array<char*, 3> words{shell.data(), script.data(), nullptr};
  pid_t child = 0;
  if (const int error = ::posix_spawnp(&child, "sh", nullptr, nullptr, words.data(), environ); error != 0)
    throw InputError({"--submit"}, "", fmt::format("sh cannot be started: {}", std::strerror(error)));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  throw InputError(
      {"--submit"}, "",
      fmt::format("sbatch is not there or refuses the jobs (see above); the scripts are in {}", dir.string()));
}

int run(const SlurmArguments& arguments) {
  const std::string campaign = read_campaign_file(arguments.file, arguments.budget);
  const SlurmOptions options = complete(arguments);
  validate(options);
  const SlurmScripts scripts = slurm_scripts(options);
  require_room(options, campaign, scripts);
  write_scripts(options, campaign, scripts);
  fmt::print("{}: array.sbatch ({} {}), merge.sbatch, submit\n", options.dir.string(), options.tasks,
             options.tasks == 1 ? "task" : "tasks");
  if (arguments.submit) submit(options.dir);
  return kExitOk;
}

}  // namespace

Command add_slurm_command(CLI::App& app) {
  auto arguments = std::make_shared<SlurmArguments>();
  SlurmOptions& slurm = arguments->slurm;
  CLI::App* command = app.add_subcommand("slurm", "a campaign as a job array of Slurm, and the job that merges it");
  command->add_option("file", arguments->file, "the campaign, NAME.toml")->required()->type_name("FILE");
  command->add_option("--tasks", slurm.tasks, "shards of the campaign, a task of the array for each")
      ->required()
      ->check(CLI::Range(1, 10'000))
      ->type_name("N");
  command->add_option("--out", slurm.dir, "directory for scripts, logs and results (default dobbench-results/NAME)")
      ->type_name("DIR");
  command->add_flag("--submit", arguments->submit, "hand both jobs to sbatch and print their ids");
  command->add_option("--time", slurm.time, "limit of a task, HH:MM:SS or DAYS-HH:MM:SS (default: the partition's)")
      ->type_name("LIMIT");
  command->add_option("--memory", slurm.memory_MB, "of a task [MB] (default: the cluster's)")
      ->check(CLI::Range(1L, 1'000'000'000L))
      ->type_name("MB");
  command->add_option("--partition", slurm.partition, "of the jobs (default: the cluster's)")->type_name("NAME");
  command->add_option("--cpus", slurm.cpus, "of a task, as many trials at a time (default 1)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command->add_option("--budget", arguments->budget, "trials of the whole campaign (default: what the file says)")
      ->check(CLI::Range(1, 1'000'000'000))
      ->type_name("N");
  command->footer(
      "Exit codes: 0 written, and with --submit taken by Slurm; 2 bad input, or Slurm does not take the jobs; 4 a "
      "file\n"
      "could not be written.");
  return [arguments] { return run(*arguments); };
}

}  // namespace dob
