#include "scenarios/document_limits.h"

#include <algorithm>

#include <fmt/format.h>

namespace dob {
namespace {

// Walks over TOML as far as it takes to know what is a string or a comment, and what is not.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        skip_to_end_of_line();
      } else if (c == '"' || c == '\'') {
        skip_string(c);
      } else {
        count(c);
        step();
      }
    }
  }

 private:
  void count(char c) {
    if (c == '.') {
      if (++dots_ >= kMostKeyParts) refuse(fmt::format("a key of more than {} parts", kMostKeyParts));
      return;
    }
    if (c == '[' || c == '{') {
      if (++depth_ > kDeepestNesting) refuse(fmt::format("nested deeper than {} levels", kDeepestNesting));
    } else if (c == ']' || c == '}') {
      depth_ = std::max(depth_ - 1, 0);
    }
    constexpr std::string_view kEndsKey = "=,\n[]{}";
    if (kEndsKey.find(c) != std::string_view::npos) dots_ = 0;
  }

  void step() {
    ++column_;
    if (text_[at_++] == '\n') {
      ++line_;
      column_ = 1;
    }
  }

  void skip_to_end_of_line() {
    while (at_ < text_.size() && text_[at_] != '\n') step();
  }

  bool starts(std::string_view with) const { return text_.substr(at_).starts_with(with); }

  // Basic strings ("), where \ takes the next character along, and literal ones ('); three quotes may span lines.
  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool long_string = starts(three);
    for (int i = 0; i < (long_string ? 3 : 1); ++i) step();
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (!long_string && (c == quote || c == '\n')) return step();
      if (long_string && starts(three)) return skip_quotes(quote);
      if (c == '\\' && quote == '"' && at_ + 1 < text_.size()) step();
      step();
    }
  }

  // Up to two quotes before the closing three belong to the string.
  void skip_quotes(char quote) {
    for (int i = 0; i < 5 && at_ < text_.size() && text_[at_] == quote; ++i) step();
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError({source_, line_, column_}, "", fmt::format("{}; no file needs that", what));
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  int depth_ = 0, dots_ = 0;
};

}  // namespace

void check_nesting(std::string_view text, const std::string& source) {
  Scanner(text, source).run();
}

void check_path(const std::string& path, const Place& place) {
  if (std::count(path.begin(), path.end(), '.') >= kMostKeyParts)
    throw InputError(place, path, fmt::format("a key of more than {} parts", kMostKeyParts));
  std::string_view rest = path;
  while (true) {
    const std::size_t dot = rest.find('.');
    const std::string_view part = rest.substr(0, dot);
    if (part.empty()) throw InputError(place, path, "a part of the key is empty");
    if (part.size() > kLongestKey)
      throw InputError(place, path, fmt::format("a part of the key is longer than {} bytes", kLongestKey));
    if (dot == std::string_view::npos) return;
    rest.remove_prefix(dot + 1);
  }
}

}  // namespace dob
