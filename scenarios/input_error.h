// What is said about bad input: where it stands, which key, which value, what is allowed.
#pragma once

#include <stdexcept>
#include <string>

namespace dob {

// Where a value was written: a line of a file, or an option of the command line.
struct Place {
  std::string source;  // the file, or the option ("--set") when line is 0
  int line = 0;        // from 1
  int column = 0;      // from 1
};

// Input that cannot be used. what() is one line: `FILE:LINE:COLUMN: key: value; what is allowed`, or with an
// option of the command line in front: `--set key: value; what is allowed`.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  // An empty key is left out.
  InputError(const Place& place, const std::string& key, const std::string& message);
};

}  // namespace dob
