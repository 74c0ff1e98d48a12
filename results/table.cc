#include "results/table.h"

#include <iterator>
#include <stdexcept>

#include "results/table_formats.h"
#include "results/table_reference.h"

namespace dob {
namespace {

struct Page {
  std::vector<TableBlock> blocks;
  std::vector<std::string> legend;

  void add(std::vector<TableBlock> more, std::vector<std::string> meaning) {
    if (more.empty()) return;
    blocks.insert(blocks.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    legend.insert(legend.end(), std::make_move_iterator(meaning.begin()), std::make_move_iterator(meaning.end()));
  }
};

std::string render(const Page& page, TableFormat format) {
  switch (format) {
    case TableFormat::kMarkdown:
      return table_markdown(page.blocks, page.legend);
    case TableFormat::kLatex:
      return table_latex(page.blocks, page.legend);
    default:
      return table_text(page.blocks, page.legend);
  }
}

std::string render_comparison(const Run& run, const TableOptions& options) {
  std::vector<TableRow> rows = build_rows(run, options.order);
  compare_with_reference(rows, run, options.reference);
  if (options.format == TableFormat::kJson) return table_json(rows, options.timing);
  if (options.format == TableFormat::kCsv) return table_csv(rows, options.timing);
  Page page;
  page.add(comparison_blocks(rows, options.order), comparison_legend(rows));
  if (options.timing) page.add(timing_blocks(rows, options.order), timing_legend());
  if (options.format != TableFormat::kLatex) page.add(summary_blocks(rows), summary_legend());
  return render(page, options.format);
}

std::string render_shadows(const Run& run, const TableOptions& options) {
  const std::vector<ShadowRow> rows = build_shadow_rows(run, options.order);
  if (rows.empty()) throw std::invalid_argument("no shadow observers in this run; `run --shadow NAME` adds them");
  if (options.format == TableFormat::kJson) return shadow_json(rows);
  if (options.format == TableFormat::kCsv) return shadow_csv(rows);
  return render({shadow_blocks(rows), shadow_legend()}, options.format);
}

}  // namespace

std::string render_table(const Run& run, const TableOptions& options) {
  return options.shadow ? render_shadows(run, options) : render_comparison(run, options);
}

}  // namespace dob
