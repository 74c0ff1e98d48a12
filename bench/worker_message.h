// What a worker process sends home through its pipe. Private to the worker pool.
//
// One frame with its length and a fingerprint: what was cut short, or written there by somebody else, is told from what
// the worker itself has to say.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace dob {

struct WorkerMessage {
  bool ok = false;   // a result; else the reason why there is none
  std::string text;  // of either
};

std::string framed(bool ok, std::string_view text);

// Of the bytes of exactly one whole frame; nullopt for anything else.
std::optional<WorkerMessage> unframed(std::string_view bytes);

// More than that is no result: a cell of an hour takes about a megabyte.
inline constexpr std::size_t kLongestMessage = std::size_t{64} << 20U;  // [byte]

}  // namespace dob
