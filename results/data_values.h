// Values of the tables for programs, JSON and CSV. Private to results/.
#pragma once

#include <optional>
#include <string>

#include "results/statistics.h"
#include "results/store_json.h"

namespace dob {

inline Json number_or_null(const std::optional<double>& x) {
  return x ? Json(*x) : Json();
}

inline Json text_or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

inline Json interval_or_null(const std::optional<Interval>& x) {
  return x ? Json::array({x->low, x->high}) : Json();
}

// The fields of a row that name it.
Json key_to_row(const CellKey& key);

// Over several lines, for a file; ends in a line end.
std::string json_text(const Json& json);

// Quoted as in RFC 4180 where it must be; nothing for null.
std::string csv_value(const Json& value);

// A flat object as a line of CSV, and its names as the heading of such lines. A field NAME_ci95 is an interval or null
// and fills two columns, NAME_ci95_low and NAME_ci95_high.
std::string csv_heading(const Json& row);
std::string csv_line(const Json& row);

}  // namespace dob
