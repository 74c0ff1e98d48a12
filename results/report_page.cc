#include "results/report_page.h"

#include <fstream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "results/report_text.h"
#include "results/store.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMarker = "<!--REPORT-DATA-->\n";

}  // namespace

std::string data_element(const Json& data) {
  return fmt::format("<script type=\"application/json\" id=\"report-data\">{}</script>\n", script_json(data));
}

std::string trace_element(std::size_t number, const std::string& base64) {
  return fmt::format("<script type=\"text/plain\" id=\"trace-{}\">{}</script>\n", number, base64);
}

PageTemplate::PageTemplate(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw StoreError(file.string() + ": the report's template cannot be read");
  const std::size_t at = text.find(kMarker);
  if (at == std::string::npos || text.find(kMarker, at + 1) != std::string::npos) {
    throw StoreError(fmt::format("{}: is no template of a report: the line {} must be there once", file.string(),
                                 kMarker.substr(0, kMarker.size() - 1)));
  }
  before_ = text.substr(0, at);
  after_ = text.substr(at + kMarker.size());
}

std::string PageTemplate::with(const Json& data, const std::vector<std::string>& traces) const {
  std::string page = before_ + data_element(data);
  for (std::size_t i = 0; i < traces.size(); ++i) page += trace_element(i, traces[i]);
  return page + after_;
}

}  // namespace dob
