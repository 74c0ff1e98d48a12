// Options of an observer as plain values: what a profile's TOML table or `--observer NAME:key=value` says.
// Callers turn TOML integers into double. Each observer reads its own keys with an OptionReader.
#pragma once

#include <initializer_list>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dob {

using OptionValue = std::variant<bool, double, std::string, std::vector<double>>;
using ObserverOptions = std::map<std::string, OptionValue>;

// From the command line: true | false, a number, a list "1.0;2.0;3.0", anything else is a string. Never
// throws on bad text: whoever reads the option knows what it should have been.
OptionValue parse_option_value(std::string_view text);

// The inverse of parse_option_value, for messages: numbers in their shortest exact form, strings quoted.
std::string format_option_value(const OptionValue& value);

// An option that cannot be used. what() names the observer, the option, its value and what is allowed.
class OptionError : public std::runtime_error {
 public:
  OptionError(std::string_view observer, std::string_view key, const OptionValue& value, std::string_view allowed);
  explicit OptionError(const std::string& message) : std::runtime_error(message) {}
};

// Range of allowed numbers: (above, max], or [min, max] where a min is given; infinities and NaN are never allowed.
struct NumberRange {
  double above = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::max();
  double min = -std::numeric_limits<double>::infinity();
};

inline constexpr NumberRange kGainRange{.above = 0.0, .max = 1e6};  // [rad/s], far above what any tick resolves
inline constexpr NumberRange kGainOrNone{.max = 1e6, .min = 0.0};   // [rad/s]

// Throws OptionError unless dt [s] is finite and > 0.
void check_tick(std::string_view observer, double dt);

// Reads options by key. An absent key gives the fallback (for choice(): the first of the allowed); a value of
// another type or out of range throws OptionError. Call refuse_unknown() after the last key.
class OptionReader {
 public:
  OptionReader(std::string_view observer, const ObserverOptions& options) : observer_(observer), options_(options) {}

  // true or false; a number within the range, of the key's unit; a whole number from min to max; one of the words.
  bool flag(const std::string& key, bool fallback);
  double number(const std::string& key, double fallback, NumberRange range);
  int integer(const std::string& key, int fallback, int min, int max);
  std::string choice(const std::string& key, std::initializer_list<std::string_view> allowed);
  // A single number counts as a list of one.
  std::vector<double> list(const std::string& key, std::vector<double> fallback, NumberRange range, int max_size);

  // Throws OptionError on the first key that nobody has asked for.
  void refuse_unknown() const;

 private:
  const OptionValue* find(const std::string& key);

  std::string observer_;
  const ObserverOptions& options_;
  std::set<std::string> known_;
};

}  // namespace dob
