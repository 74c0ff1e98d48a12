#include "robot/urdf_ranges.h"

#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <tinyxml.h>

#include <fmt/format.h>

#include "robot/description.h"

namespace dob {
namespace {

// As urdfdom reads a number: independently of the locale, to the end of the text.
std::optional<double> parse_number(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double number = 0.0;
  in >> number;
  if (in.fail() || !in.eof()) return std::nullopt;
  return number;
}

bool within(const std::optional<double>& number, const UrdfRange& range) {
  return number && *number >= range.min && *number <= range.max && !(range.without_min && *number == range.min);
}

// `owner` is "link 'name'" or "joint 'name'".
void check_attribute(const TiXmlElement& element, const std::string& owner, const UrdfRange& range) {
  const std::string* const text = element.Attribute(std::string(range.attribute));
  if (text == nullptr) return;
  std::istringstream words(*text);
  for (std::string word; std::getline(words, word, ' ');) {
    if (word.empty() || within(parse_number(word), range)) continue;
    throw DescriptionError(fmt::format("line {}, column {}: {}: {} {} is {}; allowed: {} {} to {} {}", element.Row(),
                                       element.Column(), owner, range.element, range.attribute, word,
                                       range.without_min ? "above" : "from", range.min, range.max, range.unit));
  }
}

bool is_revolute(const TiXmlElement& joint) {
  const char* const type = joint.Attribute("type");
  return type != nullptr && std::string_view(type) == "revolute";
}

void check_below(const TiXmlElement& parent, const std::string& owner, bool of_moving_joint) {
  for (const TiXmlElement* element = parent.FirstChildElement(); element != nullptr;
       element = element->NextSiblingElement()) {
    const std::string& name = element->ValueStr();
    const bool read = of_moving_joint || (name != "axis" && name != "limit");
    for (const UrdfRange& range : kUrdfRanges) {
      if (read && range.element == name) check_attribute(*element, owner, range);
    }
    check_below(*element, owner, of_moving_joint);
  }
}

}  // namespace

void check_ranges(const TiXmlElement& robot) {
  for (const TiXmlElement* element = robot.FirstChildElement(); element != nullptr;
       element = element->NextSiblingElement()) {
    const char* const name = element->Attribute("name");
    const std::string owner = fmt::format("{} '{}'", element->ValueStr(), name != nullptr ? name : "");
    check_below(*element, owner, is_revolute(*element));
  }
}

}  // namespace dob
