#include "bench/worker_message.h"

#include <fmt/format.h>

#include "results/fingerprint.h"

namespace dob {
namespace {

// "dobw", '+' for a result or '-' for a reason, length and fingerprint of the text as 16 hexadecimal digits each.
std::string head(bool ok, std::string_view text) {
  return fmt::format("dobw{}{:016x}{}", ok ? '+' : '-', text.size(), fingerprint(text));
}

}  // namespace

std::string framed(bool ok, std::string_view text) {
  return head(ok, text).append(text);
}

std::optional<WorkerMessage> unframed(std::string_view bytes) {
  static constexpr std::size_t kHead = 4 + 1 + 16 + 16;
  if (bytes.size() < kHead) return std::nullopt;
  const std::string_view text = bytes.substr(kHead);
  for (const bool ok : {true, false}) {
    if (bytes.substr(0, kHead) == head(ok, text)) return WorkerMessage{ok, std::string(text)};
  }
  return std::nullopt;
}

}  // namespace dob
