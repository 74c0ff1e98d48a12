#include "robot/urdf_reader.h"

#include <algorithm>
#include <console_bridge/console.h>
#include <initializer_list>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <tinyxml.h>

#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include "robot/description.h"
#include "robot/text_input.h"
#include "robot/urdf_ranges.h"

namespace dob {
namespace {

// Bounds on what may reach the XML library, which recurses once per level of nesting. A URDF has some 10 kB
// and 200 elements.
constexpr std::size_t kMaxBytes = 4 << 20;
constexpr std::ptrdiff_t kMaxElements = 5000;

std::string read_text(const std::filesystem::path& file) {
  try {
    return read_text_file(file, kMaxBytes);
  } catch (const TextFileError& error) {
    throw DescriptionError(fmt::format("{}; a URDF file is expected", error.what()));
  }
}

void check_text(std::string_view text) {
  if (text.find('\0') != std::string_view::npos) {
    throw DescriptionError("contains a zero byte; a URDF file is text");
  }
  const auto opens_element = [](char bracket, char next) {
    return bracket == '<' && next != '/' && next != '!' && next != '?';
  };
  std::ptrdiff_t elements = 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    elements += opens_element(text[i - 1], text[i]) ? 1 : 0;
  }
  if (elements > kMaxElements) {
    throw DescriptionError(fmt::format("has {} XML elements; at most {} are allowed", elements, kMaxElements));
  }
}

std::string attribute(const TiXmlElement* element, const char* name) {
  const char* const value = element != nullptr ? element->Attribute(name) : nullptr;
  return value != nullptr ? value : "";
}

// One joint as the check below needs it.
struct Edge {
  std::string joint;
  std::string parent;
};

// Parent links that lead back to `child` make a loop. Every link has at most one joint above it here.
void check_loop(const std::map<std::string, Edge>& above, const std::string& child) {
  auto edge = above.find(child);
  for (std::size_t step = 0; edge != above.end(); ++step) {
    if (step > above.size()) {
      throw DescriptionError(fmt::format("joint '{}': belongs to a loop of joints; links and joints must form a tree",
                                         edge->second.joint));
    }
    edge = above.find(edge->second.parent);
  }
}

// urdfdom follows the references without looking for loops and would not come back from one.
void check_tree(const TiXmlElement& robot) {
  std::map<std::string, Edge> above;  // by child link
  for (const TiXmlElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const std::string child = attribute(joint->FirstChildElement("child"), "link");
    const Edge edge{attribute(joint, "name"), attribute(joint->FirstChildElement("parent"), "link")};
    const auto [other, inserted] = above.emplace(child, edge);
    if (!inserted) {
      throw DescriptionError(fmt::format("link '{}': is the child of joint '{}' and of joint '{}'; only one is allowed",
                                         child, other->second.joint, edge.joint));
    }
  }
  for (const auto& [child, edge] : above) {
    check_loop(above, child);
  }
}

// Removes the child elements whose name is not in `kept`.
void keep_only(TiXmlElement& element, std::initializer_list<std::string_view> kept) {
  TiXmlElement* child = element.FirstChildElement();
  while (child != nullptr) {
    TiXmlElement* const next = child->NextSiblingElement();
    if (std::find(kept.begin(), kept.end(), child->ValueStr()) == kept.end()) {
      element.RemoveChild(child);
    }
    child = next;
  }
}

// The part of the file that matters here. Visuals, materials and other programs' extensions are dropped so
// that everything urdfdom still complains about is a reason to refuse the file: it reports an unreadable mass
// or collision and then goes on without it.
std::string extract_mechanics(const std::string& text) {
  TiXmlDocument xml;
  xml.Parse(text.c_str());
  if (xml.Error()) {
    // TinyXML knows no place for what is missing at the end of the file.
    const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
    throw DescriptionError(xml.ErrorRow() > 0 ? fmt::format("line {}, column {}: not valid XML: {}", xml.ErrorRow(),
                                                            xml.ErrorCol(), xml.ErrorDesc())
                                              : fmt::format("line {}: not valid XML: {}", lines, xml.ErrorDesc()));
  }
  TiXmlElement* const robot = xml.RootElement();
  if (robot == nullptr || robot->ValueStr() != "robot") {
    throw DescriptionError(fmt::format("the root element is '{}'; a URDF has <robot>",
                                       robot != nullptr ? robot->ValueStr() : std::string("(none)")));
  }
  if (robot->NextSiblingElement() != nullptr) {
    throw DescriptionError(fmt::format("line {}: a second root element '{}'; only <robot> is allowed",
                                       robot->NextSiblingElement()->Row(), robot->NextSiblingElement()->ValueStr()));
  }
  check_tree(*robot);
  keep_only(*robot, {"link", "joint"});
  for (TiXmlElement* link = robot->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    keep_only(*link, {"inertial", "collision"});
  }
  check_ranges(*robot);
  TiXmlPrinter printer;
  robot->Accept(&printer);
  return printer.Str();
}

// Collects what urdfdom would print. urdfdom reports through one output handler per process: hence the lock.
class UrdfdomMessages final : public console_bridge::OutputHandler {
 public:
  UrdfdomMessages()
      : lock_(mutex()), handler_(console_bridge::getOutputHandler()), level_(console_bridge::getLogLevel()) {
    console_bridge::useOutputHandler(this);
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_ERROR);
  }
  ~UrdfdomMessages() override {
    console_bridge::useOutputHandler(handler_);
    console_bridge::setLogLevel(level_);
  }
  UrdfdomMessages(const UrdfdomMessages&) = delete;
  UrdfdomMessages& operator=(const UrdfdomMessages&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/, int /*line*/) override {
    if (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
      errors_ += (errors_.empty() ? "" : "; ") + text;
    }
  }
  const std::string& errors() const { return errors_; }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  std::scoped_lock<std::mutex> lock_;
  console_bridge::OutputHandler* handler_;
  console_bridge::LogLevel level_;
  std::string errors_;
};

}  // namespace

std::shared_ptr<const urdf::ModelInterface> read_urdf(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  check_text(text);
  const std::string mechanics = extract_mechanics(text);
  const UrdfdomMessages messages;
  urdf::ModelInterfaceSharedPtr model;
  try {
    model = urdf::parseURDF(mechanics);
  } catch (const std::exception& error) {
    throw DescriptionError(fmt::format("not a valid URDF: {}", error.what()));
  }
  if (!messages.errors().empty()) {
    throw DescriptionError(fmt::format("not a valid URDF: {}", messages.errors()));
  }
  if (!model || !model->getRoot()) {
    throw DescriptionError("not a valid URDF: it has no root link");
  }
  return model;
}

}  // namespace dob
