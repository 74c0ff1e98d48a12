// Values of the tables for programs, JSON and CSV. Private to results/.
#pragma once

#include <optional>
#include <string>

#include "results/store_json.h"

namespace dob {

inline Json number_or_null(const std::optional<double>& x) {
  return x ? Json(*x) : Json();
}

inline Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

// Quoted as in RFC 4180 where it must be; nothing for null.
std::string csv_value(const Json& value);

}  // namespace dob
