#include "results/report_text.h"

namespace dob {
namespace {

constexpr std::string_view kBeforePath = " \t\n'\"(=,:;[";
constexpr std::string_view kAfterPath = " \t\n'\"),:;]";

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

}  // namespace

std::string without_directories(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const bool begins = text[at] == '/' && (at == 0 || kBeforePath.find(text[at - 1]) != std::string_view::npos);
    if (!begins) {
      out += text[at++];
      continue;
    }
    const std::string_view path = text.substr(at, text.find_first_of(kAfterPath, at) - at);
    out += path.size() > 1 ? path.substr(path.rfind('/') + 1) : path;
    at += path.size();
  }
  return out;
}

std::string script_json(const Json& json) {
  std::string text = one_line(json);
  replace_all(text, "<", "\\u003c");
  replace_all(text, "\xE2\x80\xA8", "\\u2028");
  replace_all(text, "\xE2\x80\xA9", "\\u2029");
  return text;
}

}  // namespace dob
