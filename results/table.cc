#include "results/table.h"

#include "results/table_formats.h"

namespace dob {

std::string render_table(const Run& run, const TableOptions& options) {
  if (options.format == TableFormat::kJson || options.format == TableFormat::kCsv) {
    const std::vector<TableRow> rows = build_rows(run, options.order);
    return options.format == TableFormat::kJson ? table_json(rows, options.timing) : table_csv(rows, options.timing);
  }
  const std::vector<TableBlock> blocks = make_blocks(run, options);
  const std::vector<std::string> legend = table_legend(options);
  switch (options.format) {
    case TableFormat::kMarkdown:
      return table_markdown(blocks, legend);
    case TableFormat::kLatex:
      return table_latex(blocks, legend);
    default:
      return table_text(blocks, legend);
  }
}

}  // namespace dob
