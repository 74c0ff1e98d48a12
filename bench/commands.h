// The commands of dobbench. Each adds its options to the command line; the returned function runs it and returns the
// exit code: 0 done, 1 a comparison says no, 2 bad input (nothing was run), 3 some cells could not be run, 4 a file
// could not be written (what was finished is kept), 128 + n stopped by signal n.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/batch_plan.h"

namespace dob {

inline constexpr int kExitOk = 0;
inline constexpr int kExitSaysNo = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitCellErrors = 3;
inline constexpr int kExitCannotWrite = 4;
inline constexpr int kExitSignal = 128;

using Command = std::function<int()>;

// What the `dobbench run` that began the run in `dir` was asked for. Throws StoreError if it was begun otherwise,
// InputError if that would load a plugin that is not among `plugins`, those that the user has named again.
BatchRequest request_of_run(const std::filesystem::path& dir, const std::vector<std::filesystem::path>& plugins);

Command add_analyse_command(CLI::App& app);
Command add_campaign_command(CLI::App& app, const std::string& command_line);
Command add_check_command(CLI::App& app);
Command add_compare_command(CLI::App& app);
Command add_completion_command(CLI::App& app);
Command add_figures_command(CLI::App& app);
Command add_list_command(CLI::App& app);
Command add_manual_command(CLI::App& app);
Command add_merge_command(CLI::App& app);
Command add_report_command(CLI::App& app);
Command add_run_command(CLI::App& app, const std::string& command_line);
Command add_slurm_command(CLI::App& app);
Command add_table_command(CLI::App& app);
Command add_timing_command(CLI::App& app, const std::string& command_line);
Command add_tune_command(CLI::App& app, const std::string& command_line);
Command add_verify_command(CLI::App& app);

// One a line: what can stand next on the command line whose words, but for the program's name, are given
// (bench/completion.h). For shells, which call it as `dobbench __complete WORD...`.
int print_completions(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace dob
