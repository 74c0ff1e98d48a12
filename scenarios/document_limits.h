// How large, how deep and how wide a TOML document may be. Looked at before the TOML library sees the text: it recurses
// once per level, and whoever walks the document afterwards does, too.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scenarios/input_error.h"

namespace dob {

inline constexpr std::size_t kMostBytes = 4 << 20;   // of a file; the shipped ones have at most some 10 kB
inline constexpr int kDeepestNesting = 32;           // of [ ] and { }
inline constexpr int kMostKeyParts = 16;             // a.b.c has three
inline constexpr std::size_t kLongestKey = 200;      // [bytes], one part of it
inline constexpr std::size_t kMostEntries = 1000;    // of a table
inline constexpr std::size_t kMostElements = 10000;  // of an array
inline constexpr std::size_t kLongestText = 1000;    // [bytes] of a text that is a value

// What an InputError that names a place says is one printable line (robot/text_input.h) of at most so many bytes,
// whatever stood in the input.
inline constexpr std::size_t kLongestMessage = 2500;

// Throws InputError with the place at which `text` is nested too deeply or a key has too many parts. Text that is no
// TOML is the library's business.
void check_nesting(std::string_view text, const std::string& source);

// Throws InputError for a dotted path (`disturbance.0.amplitude_N`) with too many or too long parts.
void check_path(const std::string& path, const Place& place);

}  // namespace dob
