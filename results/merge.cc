#include "results/merge.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/campaign_store.h"
#include "results/fingerprint.h"
#include "results/merge_rows.h"
#include "results/plain_files.h"
#include "results/run_directory.h"
#include "results/run_lock.h"
#include "results/run_plan.h"
#include "results/whole_file.h"
#include "robot/text_input.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

// One of the directories, and what it says of itself.
struct Part {
  fs::path dir;
  Provenance program;
  std::vector<RunShard> shards;
  std::string campaign;                          // its document, "" for none
  std::map<std::string, std::string> scenarios;  // file -> hash
  bool merged = false;                           // itself a merge
};

std::map<std::string, std::string> read_scenarios(SQLite::Database& database) {
  std::map<std::string, std::string> scenarios;
  SQLite::Statement row(database, "SELECT file, hash FROM scenario");
  while (row.executeStep()) scenarios.emplace(row.getColumn(0).getString(), row.getColumn(1).getString());
  return scenarios;
}

Part read_part(const fs::path& dir) {
  SQLite::Database database = open_database(dir);
  return with_database(dir / kDatabaseFile, [&] {
    Part part{dir,
              {},
              read_shards(database),
              campaign_document(database),
              read_scenarios(database),
              !columns_of(database, "merged").empty()};
    const std::map<long, Provenance> programs = read_programs(database);
    if (programs.empty()) throw StoreError(dir.string() + ": has no batch");
    part.program = programs.begin()->second;
    if (part.shards.empty()) {
      throw StoreError(dir.string() + ": was made before runs could be merged: it does not know its plan");
    }
    return part;
  });
}

std::string describe(const Provenance& program) {
  return fmt::format("dobbench {} ({}, {}, {}, {})", program.version, program.commit, program.build, program.compiler,
                     program.flags);
}

// The code path may differ, as machines do: reading the run notes it.
void require_same(const Part& first, const Part& part) {
  const auto refuse = [&](const std::string& why) {
    throw StoreError(fmt::format("{}: cannot be merged with {}: {}", part.dir.string(), first.dir.string(), why));
  };
  if (describe(part.program) != describe(first.program)) {
    refuse(fmt::format("it was computed by {}, that one by {}", describe(part.program), describe(first.program)));
  }
  const RunShard &a = first.shards.front(), &b = part.shards.front();
  if (a.plan != b.plan || a.planned != b.planned) {
    refuse(fmt::format("it belongs to another plan ({} of {} cells, that one to {} of {})", b.plan, b.planned, a.plan,
                       a.planned));
  }
  if (a.count != b.count) {
    refuse(fmt::format("it is of {} shards, that one of {}", b.count, a.count));
  }
  if (part.campaign != first.campaign) refuse("it belongs to another campaign");
  for (const auto& [file, hash] : part.scenarios) {
    const auto other = first.scenarios.find(file);
    if (other != first.scenarios.end() && other->second != hash) refuse("its scenario " + file + " is another one");
  }
}

std::string read_scenario_text(const fs::path& file, const std::string& hash) {
  require_plain_file(file);
  try {
    std::string text = read_text_file(file, kMostScenarioBytes);
    if (fingerprint(text) == hash) return text;
  } catch (const TextFileError& error) {
    throw StoreError(fmt::format("{}: {}", file.string(), error.what()));
  }
  throw StoreError(file.string() + ": is not the scenario that the run began with");
}

// As write_whole_file, for what may be large.
void copy_whole_file(const fs::path& from, const fs::path& to) {
  require_plain_file(to);
  const fs::path part = to.string() + ".part";
  require_plain_file(part);
  std::error_code error;
  fs::copy_file(from, part, fs::copy_options::overwrite_existing, error);
  if (!error) fs::rename(part, to, error);
  if (error) throw WriteError(fmt::format("{}: cannot be written: {}", to.string(), error.message()));
}

void copy_scenarios(const Part& part, const fs::path& out) {
  make_plain_directory(out / "scenarios");
  for (const auto& [name, hash] : part.scenarios) {
    check_names({{name, ""}});
    const fs::path file = fs::path("scenarios") / (name + ".toml");
    write_whole_file(out / file, read_scenario_text(part.dir / file, hash));
  }
}

void copy_series(const Part& part, const fs::path& out) {
  for (const char* directory : {"traces", "logs"}) {
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(part.dir / directory, error))) continue;
    make_plain_directory(out / directory);
    for (const fs::path& file : fs::directory_iterator(part.dir / directory)) {
      const bool plain = fs::is_regular_file(fs::symlink_status(file)) && is_plain_name(file.filename().string());
      if (plain && file.extension() != ".part") copy_whole_file(file, out / directory / file.filename());
    }
  }
}

MergeSummary summary_of(SQLite::Database& database) {
  const auto count = [&](const std::string& query) {
    return static_cast<std::size_t>(database.execAndGet("SELECT COUNT(*) FROM " + query).getInt64());
  };
  MergeSummary summary{.planned = 0,
                       .cells = count("cell"),
                       .finished = count("result"),
                       .errors = count("result WHERE outcome = 'error'"),
                       .shards = read_shards(database),
                       .missing = {},
                       .unfinished = {}};
  summary.planned = summary.shards.front().planned;
  summary.missing = missing_shards(summary.shards);
  summary.unfinished = unfinished_shards(summary.shards);
  return summary;
}

// By the number of their shard, so that it does not matter in which order they were named.
std::vector<Part> read_parts(const std::vector<fs::path>& dirs, const fs::path& out) {
  std::vector<Part> parts;
  for (const fs::path& dir : dirs) {
    std::error_code error;
    if (fs::equivalent(dir, out, error)) throw StoreError(dir.string() + ": is to be merged and is --out, too");
    parts.push_back(read_part(dir));
  }
  if (parts.empty()) throw StoreError("nothing to merge");
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.shards.front().number < b.shards.front().number; });
  for (const Part& part : parts) require_same(parts.front(), part);
  return parts;
}

std::optional<Part> read_earlier(const fs::path& out, const Part& first) {
  if (!is_run_directory(out)) return std::nullopt;
  Part earlier = read_part(out);
  if (!earlier.merged) throw StoreError(out.string() + ": holds a run, or a shard of one, and no merge of shards");
  require_same(first, earlier);
  return earlier;
}

// Builds the database beside the one that is there, if one is, and takes its place when it is whole.
class Merge {
 public:
  Merge(const std::vector<Part>& parts, const fs::path& out) : parts_(parts), out_(out), file_(out / kUnfinished) {}
  Merge(const Merge&) = delete;
  Merge& operator=(const Merge&) = delete;
  ~Merge() {
    std::error_code error;
    fs::remove(file_, error);
  }

  MergeSummary run() {
    const std::optional<Part> earlier = read_earlier(out_, parts_.front());
    std::error_code error;
    fs::remove(file_, error);
    MergeSummary summary;
    try {
      SQLite::Database database = create_database(file_);
      database.exec("CREATE TABLE merged(id INTEGER); PRAGMA journal_mode = OFF");
      MergedRows rows(database);
      for (const Part& part : parts_) rows.add(part.dir, part.shards);
      if (earlier) rows.add(out_, earlier->shards, true);
      summary = summary_of(database);
    } catch (const SQLite::Exception& sqlite) {
      throw WriteError(fmt::format("{}: {}", file_.string(), sqlite.what()));
    }
    for (const Part& part : parts_) {
      copy_scenarios(part, out_);
      copy_series(part, out_);
    }
    fs::rename(file_, out_ / kDatabaseFile, error);
    if (!error) return summary;
    throw WriteError(fmt::format("{}: cannot be written: {}", (out_ / kDatabaseFile).string(), error.message()));
  }

 private:
  const std::vector<Part>& parts_;
  const fs::path& out_;
  fs::path file_;
};

}  // namespace

MergeSummary merge_runs(const std::vector<fs::path>& parts, const fs::path& out) {
  const std::vector<Part> read = read_parts(parts, out);
  std::error_code error;
  const bool made = !fs::exists(out, error);
  if (!is_run_directory(out)) prepare_directory(out);
  try {
    const RunLock lock(out);
    return Merge(read, out).run();
  } catch (const StoreError&) {
    if (!is_run_directory(out)) fs::remove(out / kLockFile, error);
    if (made) fs::remove(out, error);
    throw;
  }
}

std::vector<int> missing_shards(const std::vector<RunShard>& shards) {
  std::vector<int> missing;
  for (int number = 1; !shards.empty() && number <= shards.front().count; ++number) {
    const auto is_it = [&](const RunShard& shard) { return shard.number == number; };
    if (std::none_of(shards.begin(), shards.end(), is_it)) missing.push_back(number);
  }
  return missing;
}

std::vector<int> unfinished_shards(const std::vector<RunShard>& shards) {
  std::vector<int> unfinished;
  for (const RunShard& shard : shards) {
    if (!shard.complete) unfinished.push_back(shard.number);
  }
  return unfinished;
}

}  // namespace dob
