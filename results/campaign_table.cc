#include "results/campaign_table.h"

#include "results/campaign_data.h"
#include "results/campaign_table_blocks.h"
#include "results/campaign_text.h"
#include "results/table_formats.h"

namespace dob {

std::string render_campaign(const CampaignResult& result, TableFormat format) {
  if (format == TableFormat::kJson) return campaign_json(result);
  if (format == TableFormat::kCsv) return campaign_csv(result);
  const std::string heading = campaign_heading(result);
  const std::vector<TableBlock> blocks = campaign_table_blocks(result);
  const std::vector<std::string> legend = campaign_legend(result.campaign.kind);
  switch (format) {
    case TableFormat::kMarkdown:
      return markdown_heading(heading) + table_markdown(blocks, legend);
    case TableFormat::kLatex:
      return latex_heading(heading) + table_latex(blocks, legend);
    default:
      return text_heading(heading) + table_text(blocks, legend);
  }
}

}  // namespace dob
