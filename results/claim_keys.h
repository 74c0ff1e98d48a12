// Keys that several kinds of claims have in common.
#pragma once

#include <string>

#include "scenarios/reader.h"

namespace dob {

inline constexpr Range kAnyNumber = between(-1e9, 1e9);

// The name of a metric; its index in kMetricFields. Throws InputError for a name that is not there.
std::size_t read_metric(Reader& reader, std::string_view key);

// The key `observer`; `subject` where it is missing.
std::string read_observer(Reader& reader, const std::string& subject);

// The key's text, or the fallback where it is missing.
std::string text_or(Reader& reader, std::string_view key, const std::string& fallback);

}  // namespace dob
