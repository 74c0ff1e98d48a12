// Texts on their way into a page that goes to other people. Private to results/.
#pragma once

#include <string>
#include <string_view>

#include "results/store_json.h"

namespace dob {

// Absolute paths in a text become the names of their files: a page need not tell how somebody's machine is laid out.
std::string without_directories(std::string_view text);

// JSON for a script element: on one line, and without anything that could end the element ('<') or a line of a script
// (U+2028, U+2029); bytes that are not UTF-8 are replaced.
std::string script_json(const Json& json);

}  // namespace dob
