#include "scenarios/scenario_source.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/data_directory.h"
#include "scenarios/reader.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

constexpr std::string_view kExtension = ".toml";
constexpr const char* kSummary = "summary";
constexpr const char* kBase = "base";
constexpr const char* kVariants = "variant";
constexpr const char* kCellsOf = "cells_of";
constexpr const char* kSet = "set";
constexpr const char* kObservers = "observers";
constexpr const char* kProfiles = "profiles";
constexpr std::array kOfAlias{kCellsOf, kSummary, kSet, kObservers, kProfiles};

constexpr std::array<Choice<ScenarioSet>, 2> kSets{{{"paper", ScenarioSet::kPaper}, {"extra", ScenarioSet::kExtra}}};

// Where a reference to a scenario was written, and the files that led there.
struct Reference {
  std::string text;
  Place place{"scenario"};  // of a request
  std::string key = {};
  std::filesystem::path directory = {};         // that a path in it is relative to
  std::vector<std::filesystem::path> via = {};  // files that are being read
};

// Names are also those of files.
constexpr std::size_t kLongestName = 100;  // [bytes]
constexpr const char* kNameIs = "letters, digits, _ and -, at most 100 of them";

bool is_name(std::string_view text) {
  return is_bare_key(text) && text.size() <= kLongestName;
}

// A few files of a few lines are not to stand for thousands of others.
constexpr std::size_t kMostBases = 4;    // of one file
constexpr std::size_t kDeepestBase = 6;  // files below one

struct Located {
  std::string name;
  std::filesystem::path path;
  std::optional<std::string> variant;
};

// "head/tail" at the first slash from `from` on; without one there is no tail.
std::pair<std::string, std::optional<std::string>> split(const std::string& text, std::size_t from = 0) {
  const std::size_t slash = text.find('/', from);
  if (slash == std::string::npos) return {text, std::nullopt};
  return {text.substr(0, slash), text.substr(slash + 1)};
}

Located locate(const Reference& reference) {
  const std::string& text = reference.text;
  const std::size_t extension = text.rfind(kExtension);
  const std::size_t end = extension == std::string::npos ? 0 : extension + kExtension.size();
  const bool is_path = end != 0 && (end == text.size() || text[end] == '/');
  auto [head, variant] = split(text, is_path ? end : 0);
  if (is_path) return {std::filesystem::path(head).stem().string(), reference.directory / head, variant};
  require_known(head, scenario_names(), reference.place, reference.key);
  return {head, scenario_file(head), variant};
}

// A reference that a file makes to another one.
Reference referred(const ScenarioSource& source, const Node& node, const char* key,
                   std::vector<std::filesystem::path> via) {
  const auto* text = std::get_if<std::string>(&node.value);
  if (text == nullptr) throw InputError(node.place, key, describe(node) + "; allowed: a scenario's name or file");
  return {*text, node.place, key, source.path.parent_path(), std::move(via)};
}

// The file of a reference; refuses one that is already being read.
void enter(Reference& reference, const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::weakly_canonical(path, ignored);
  if (!reference.via.empty() && !std::filesystem::is_regular_file(file, ignored)) {
    throw InputError(reference.place, reference.key, fmt::format("there is no file '{}'", path.string()));
  }
  if (std::find(reference.via.begin(), reference.via.end(), file) != reference.via.end()) {
    throw InputError(reference.place, reference.key, fmt::format("'{}' leads back to itself", reference.text));
  }
  if (reference.via.size() > kDeepestBase) {
    throw InputError(reference.place, reference.key, fmt::format("more than {} files upon one another", kDeepestBase));
  }
  reference.via.push_back(file);
}

// Variants and a name written in the file leave the document: they are not part of the schema.
void take_variants(ScenarioSource& source) {
  const Node* node = source.document.find(kVariants);
  if (node == nullptr) return;
  source.variants = table_of(*node, kVariants);
  if (source.variants.empty()) throw InputError(node->place, kVariants, "empty; allowed: tables [variant.NAME]");
  for (const Entry& e : source.variants) {
    const std::string key = fmt::format("{}.{}", kVariants, e.key);
    if (!is_name(e.key)) throw InputError(e.node.place, key, fmt::format("allowed in a name: {}", kNameIs));
    table_of(e.node, key);
  }
  erase(source.document, kVariants);
}

void take_name(ScenarioSource& source) {
  const Node* node = source.document.find(kNameKey);
  if (node == nullptr) return;
  const auto* text = std::get_if<std::string>(&node->value);
  const auto [name, variant] = split(text == nullptr ? "" : *text);
  const bool both = variant && !source.variants.empty();
  if (!is_name(name) || (variant && !is_name(*variant)) || both) {
    throw InputError(node->place, kNameKey,
                     describe(*node) + "; allowed: \"NAME\", or \"NAME/VARIANT\" in a file without variants");
  }
  source.name = name;
  source.variant = variant.value_or("");
  erase(source.document, kNameKey);
}

std::vector<WrittenText> texts_at(Reader& r, const char* key) {
  std::vector<WrittenText> written;
  if (!r.has(key)) return written;
  for (std::string& text : r.texts(key)) written.push_back({std::move(text), r.place(key)});
  return written;
}

// What the file says about itself.
void take_info(ScenarioSource& source) {
  Node about{Table{}, source.document.place};
  for (const char* key : {kSet, kObservers, kProfiles}) {
    const Node* node = source.document.find(key);
    if (node == nullptr) continue;
    entry(std::get<Table>(about.value), key, node->place) = *node;
    erase(source.document, key);
  }
  ScenarioInfo& info = source.info;
  Reader::read(about, "", [&info](Reader& r) {
    info.set = r.choice(kSet, kSets, std::optional(ScenarioSet::kExtra));
    info.observers = texts_at(r, kObservers);
    info.profiles = texts_at(r, kProfiles);
    if (!info.profiles.empty() && info.observers.empty()) r.refuse(kProfiles, "only beside observers");
  });
  for (const WrittenText& profile : info.profiles)
    require_known(profile.text, profile_names(), profile.place, kProfiles);
}

// Of the wrong type it is refused with the rest of the schema.
std::string summary_of(const Node& document) {
  const Node* node = document.find(kSummary);
  const auto* text = node == nullptr ? nullptr : std::get_if<std::string>(&node->value);
  return text == nullptr ? "" : *text;
}

ScenarioSource read(Reference reference);

// One base as a document, with the variant that was asked for laid over it.
Node base_of(const ScenarioSource& source, const Node& named, const std::vector<std::filesystem::path>& via) {
  const Reference reference = referred(source, named, kBase, via);
  ScenarioSource base = read(reference);
  if (base.asked) {
    require_known(*base.asked, names_of(base.variants), reference.place, kBase);
    for (const Entry& e : base.variants) {
      if (e.key == *base.asked) lay(base.document, e.node);
    }
  }
  return std::move(base.document);
}

// Puts the document over those it names as its bases, the later of them over the earlier.
void take_base(ScenarioSource& source, const std::vector<std::filesystem::path>& via) {
  const Node* node = source.document.find(kBase);
  if (node == nullptr) return;
  const auto* list = std::get_if<Array>(&node->value);
  if (list != nullptr && list->empty()) throw InputError(node->place, kBase, "empty; allowed: names or files");
  if (list != nullptr && list->size() > kMostBases)
    throw InputError(node->place, kBase, fmt::format("{} of them; at most {} are allowed", list->size(), kMostBases));
  const Array bases = list != nullptr ? *list : Array{*node};
  erase(source.document, kBase);
  Node below = base_of(source, bases.front(), via);
  for (std::size_t i = 1; i < bases.size(); ++i) lay(below, base_of(source, bases[i], via));
  lay(below, source.document);
  source.document = std::move(below);
}

// A file that names another one's trials: those, under what this one says about itself.
ScenarioSource follow(const ScenarioSource& alias, const Node& cells_of,
                      const std::vector<std::filesystem::path>& via) {
  for (const Entry& e : std::get<Table>(alias.document.value)) {
    if (std::find(kOfAlias.begin(), kOfAlias.end(), e.key) != kOfAlias.end()) continue;
    throw InputError(e.node.place, e.key,
                     fmt::format("the trials are those that cells_of names; allowed: {}", fmt::join(kOfAlias, ", ")));
  }
  Reference reference = referred(alias, cells_of, kCellsOf, via);
  ScenarioSource source = read(reference);
  if (source.asked) throw InputError(cells_of.place, kCellsOf, describe(cells_of) + "; allowed: a whole scenario");
  source.asked = alias.asked;
  source.info = alias.info;
  source.info.summary = summary_of(alias.document);
  return source;
}

ScenarioSource read(Reference reference) {
  const Located located = locate(reference);
  enter(reference, located.path);
  ScenarioSource source{located.name, located.path, parse_file(located.path), {}, located.variant, {}, {}};
  source.info.name = located.name;
  source.info.path = located.path;
  take_info(source);
  if (const Node* cells_of = source.document.find(kCellsOf)) return follow(source, *cells_of, reference.via);
  take_variants(source);
  take_name(source);
  source.info.name = source.name;
  take_base(source, reference.via);
  source.info.summary = summary_of(source.document);
  if (!is_name(source.name)) {
    throw InputError(
        {source.path.string()}, "",
        fmt::format("'{}' is no name; allowed: {}, in the file's name or as name = \"NAME\"", source.name, kNameIs));
  }
  return source;
}

}  // namespace

std::vector<std::string> names_of(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  names.reserve(entries.size());
  for (const Entry& e : entries) names.push_back(e.key);
  return names;
}

void require_known(const std::string& name, const std::vector<std::string>& names, const Place& place,
                   const std::string& key) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw InputError(place, key, fmt::format("there is no '{}'; there are: {}", name, fmt::join(names, ", ")));
}

void lay(Node& document, const Node& layer) {
  const Node* robot = layer.find("robot");
  if (robot != nullptr && robot->find("urdf") != nullptr) {
    if (Node* below = document.find("robot")) erase(*below, "posture_rad");
    const Node* controller = layer.find("controller");
    const bool says_limit = controller != nullptr && controller->find("torque_limit_Nm") != nullptr;
    if (Node* below = document.find("controller"); below != nullptr && !says_limit) erase(*below, "torque_limit_Nm");
  }
  merge(document, layer);
}

ScenarioSource read_source(const std::string& request) {
  return read({.text = request});
}

std::vector<std::string> chosen_variants(const ScenarioSource& source) {
  if (source.variants.empty()) {
    if (source.asked)
      throw InputError({source.path.string()}, "",
                       fmt::format("there is no variant '{}'; the scenario has none", *source.asked));
    return {source.variant};
  }
  std::vector<std::string> names = names_of(source.variants);
  if (!source.asked) return names;
  require_known(*source.asked, names, {"variant"});
  return {*source.asked};
}

}  // namespace dob
