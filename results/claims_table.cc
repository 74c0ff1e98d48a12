#include "results/claims_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "results/claims_data.h"
#include "results/table_formats.h"

namespace dob {
namespace {

struct VerdictCount {
  int yes = 0, no = 0, no_data = 0;
};

VerdictCount count(const std::vector<const ClaimRow*>& rows) {
  VerdictCount count;
  for (const ClaimRow* row : rows) {
    const Verdict verdict = row->finding.verdict;
    ++(verdict == Verdict::kYes ? count.yes : verdict == Verdict::kNo ? count.no : count.no_data);
  }
  return count;
}

std::string title_of(const Setting& setting, const std::vector<const ClaimRow*>& rows) {
  const VerdictCount n = count(rows);
  return fmt::format("Profile {}, gains {}, planner {}{}: {} hold, {} do not, {} without data", setting.profile,
                     setting.gains, setting.planner,
                     setting.overrides.empty() ? "" : fmt::format(", set {}", setting.overrides), n.yes, n.no,
                     n.no_data);
}

std::string or_dash(const std::string& text) {
  return text.empty() ? "-" : text;
}

// Markdown has room for our figure and a note in the row; elsewhere the verdict has to do, and notes stand below.
enum class Width { kWide, kNarrow };

std::string ours_cell(const std::optional<Finding>& ours, Width width) {
  if (!ours) return "-";
  const std::string verdict(to_string(ours->verdict));
  return ours->measured.empty() || width == Width::kNarrow ? verdict : fmt::format("{}: {}", verdict, ours->measured);
}

constexpr std::size_t kLongestFigure = 48;  // of a narrow table; what is longer stands below

TableBlock make_block(const ClaimSet& set, const std::string& title, const std::vector<const ClaimRow*>& rows,
                      Width width) {
  TableBlock block;
  block.title = title;
  for (const std::string& heading :
       std::vector<std::string>{"case", "cells", "claim", "paper", "measured", "holds", set.ours}) {
    block.columns.push_back({heading, "", false});
  }
  if (width == Width::kWide) block.columns.push_back({"note", "", false});
  for (const ClaimRow* row : rows) {
    const Claim& claim = *row->claim;
    std::string measured = or_dash(row->finding.measured), note = row->note;
    if (width == Width::kNarrow && measured.size() > kLongestFigure) {
      note = fmt::format("{}{}{}", measured, note.empty() ? "" : "; ", note);
      measured = "below";
    }
    block.rows.push_back({claim.study, row->cells, claim.text, claim.paper, measured,
                          std::string(to_string(row->finding.verdict)), ours_cell(row->ours, width)});
    if (width == Width::kWide) {
      block.rows.back().push_back(note);
    } else if (!note.empty()) {
      block.notes.push_back(fmt::format("{}, {}: {}: {}", claim.study, row->cells, claim.text, note));
    }
  }
  return block;
}

// One line for each claim, whatever the number of its cells.
TableBlock absent_block(const std::vector<const ClaimRow*>& rows) {
  TableBlock block;
  block.title = "Not part of this run";
  for (const char* heading : {"case", "claim", "paper", "cells"}) block.columns.push_back({heading, "", false});
  const Claim* last = nullptr;
  for (const ClaimRow* row : rows) {
    if (row->claim == last) {
      block.rows.back().back() += ", " + row->cells;
    } else {
      block.rows.push_back({row->claim->study, row->claim->text, row->claim->paper, row->cells});
    }
    last = row->claim;
  }
  return block;
}

std::vector<TableBlock> make_blocks(const ClaimSet& set, const std::vector<ClaimRow>& rows, Width width) {
  std::vector<Setting> settings;
  std::vector<const ClaimRow*> absent;
  for (const ClaimRow& row : rows) {
    if (!row.planned) {
      absent.push_back(&row);
    } else if (std::find(settings.begin(), settings.end(), row.setting) == settings.end()) {
      settings.push_back(row.setting);
    }
  }
  std::vector<TableBlock> blocks;
  for (const Setting& setting : settings) {
    std::vector<const ClaimRow*> own;
    for (const ClaimRow& row : rows) {
      if (row.planned && row.setting == setting) own.push_back(&row);
    }
    blocks.push_back(make_block(set, title_of(setting, own), own, width));
  }
  if (!absent.empty()) blocks.push_back(absent_block(absent));
  return blocks;
}

std::vector<std::string> legend(const ClaimSet& set, const std::vector<std::string>& recorded) {
  std::vector<std::string> lines{
      fmt::format("Evaluated on observer {} where the claim names no other, on the worst seed; a (b): median and "
                  "worst. {}: the same question about that observer.",
                  set.subject, set.ours),
      "holds: yes or no; no data: not run, runs missing, or the metric does not apply. Notes of claims that do not "
      "hold name what the run (or a recorded one) shows when one thing is changed. Kinds and rules: "
      "docs/claims.md."};
  for (const std::string& origin : recorded) lines.push_back("recorded: " + origin);
  return lines;
}

}  // namespace

std::string render_claims(const ClaimSet& set, const std::vector<ClaimRow>& rows, TableFormat format,
                          const std::vector<std::string>& recorded) {
  switch (format) {
    case TableFormat::kJson:
      return claims_json(rows);
    case TableFormat::kCsv:
      return claims_csv(rows);
    case TableFormat::kMarkdown:
      return table_markdown(make_blocks(set, rows, Width::kWide), legend(set, recorded));
    case TableFormat::kLatex:
      return table_latex(make_blocks(set, rows, Width::kNarrow), legend(set, recorded));
    default:
      return table_text(make_blocks(set, rows, Width::kNarrow), legend(set, recorded));
  }
}

}  // namespace dob
