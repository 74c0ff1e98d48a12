#include "robot/text_input.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include <fmt/format.h>

namespace dob {
namespace {

constexpr std::string_view kLeftOut = " ... ";

struct CodePoint {
  char32_t value;
  std::size_t bytes;
};

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

// The first one of a text that is not empty; nullopt: no valid UTF-8, overlong forms and surrogates included.
std::optional<CodePoint> first_code_point(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return CodePoint{lead, 1};
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return std::nullopt;
  char32_t value = lead & (0x7FU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!continues(text[i])) return std::nullopt;
    value = value << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};  // that needs so many bytes
  if (value < kSmallest.at(bytes) || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF)) return std::nullopt;
  return CodePoint{value, bytes};
}

bool printable(char32_t c) {
  const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  return !control && c != 0x2028 && c != 0x2029;
}

// Leaves out the middle; cuts at no byte that continues a code point.
std::string shortened(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  std::size_t head = (longest - kLeftOut.size()) / 2;
  std::size_t tail = text.size() - (longest - kLeftOut.size() - head);
  while (head > 0 && continues(text[head])) --head;
  while (tail < text.size() && continues(text[tail])) ++tail;
  return text.substr(0, head).append(kLeftOut).append(text, tail);
}

}  // namespace

std::string read_text_file(const std::filesystem::path& file, std::size_t most) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status)) throw TextFileError("is a directory");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw TextFileError("is no regular file");
  }
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw TextFileError(fmt::format("cannot be opened: {}", std::strerror(errno)));
  std::string text;
  std::array<char, 1 << 14> piece{};
  while (in.read(piece.data(), piece.size()) || in.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most) throw TextFileError(fmt::format("is larger than {} bytes", most));
  }
  if (in.bad()) throw TextFileError("cannot be read to its end");
  return text;
}

std::string printable_line(std::string_view text, std::size_t longest) {
  // What is left out needs no escaping: an escape is at most four times as long as its byte.
  const std::string part = shortened(std::string(text), 2 * longest);
  std::string line;
  for (std::string_view rest = part; !rest.empty();) {
    const auto first = first_code_point(rest);
    const std::size_t bytes = first ? first->bytes : 1;
    if (first && printable(first->value)) {
      line += rest.substr(0, bytes);
    } else {
      for (const char c : rest.substr(0, bytes)) line += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
    rest.remove_prefix(bytes);
  }
  return shortened(line, longest);
}

}  // namespace dob
