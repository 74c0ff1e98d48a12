#include "scenarios/input_error.h"

#include <fmt/format.h>

#include "robot/text_input.h"
#include "scenarios/document_limits.h"

namespace dob {
namespace {

// [bytes] Shares of kLongestMessage.
constexpr std::size_t kSource = 1000;
constexpr std::size_t kKey = 200;
constexpr std::size_t kReason = 1200;
static_assert(kSource + kKey + kReason + 50 <= kLongestMessage);  // 50: line, column, punctuation

std::string message_of(const Place& place, const std::string& key, const std::string& message) {
  const std::string source = printable_line(place.source, kSource);
  const std::string name = printable_line(key, kKey);
  const std::string reason = printable_line(message, kReason);
  if (place.line == 0) return fmt::format("{}{}{}: {}", source, name.empty() ? "" : " ", name, reason);
  return fmt::format("{}:{}:{}: {}{}{}", source, place.line, place.column, name, name.empty() ? "" : ": ", reason);
}

}  // namespace

InputError::InputError(const Place& place, const std::string& key, const std::string& message)
    : std::runtime_error(message_of(place, key, message)) {}

}  // namespace dob
