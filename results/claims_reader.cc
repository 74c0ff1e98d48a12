#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "results/claim_keys.h"
#include "results/claims.h"
#include "scenarios/data_root.h"

namespace dob {
namespace {

using Test = decltype(Claim::test);

struct Kind {
  std::string_view word;
  Test (*read)(Reader&, const std::string& subject);
};

template <auto read_test>
constexpr auto as_test = [](Reader& reader, const std::string& subject) -> Test { return read_test(reader, subject); };

const std::array<Choice<Kind>, 9> kClaimKinds{{
    {"bound", {"bound", as_test<read_bound>}},
    {"fall", {"fall", as_test<read_fall>}},
    {"survive", {"survive", as_test<read_survive>}},
    {"ordering", {"ordering", as_test<read_ordering>}},
    {"similar", {"similar", as_test<read_similar>}},
    {"offset", {"offset", as_test<read_offset>}},
    {"two_peaks", {"two_peaks", as_test<read_two_peaks>}},
    {"larger", {"larger", as_test<read_larger>}},
    {"grows", {"grows", as_test<read_grows>}},
}};

// Observers that a test asks for.
struct ObserversOf {
  std::vector<std::string> operator()(const auto& test) const { return {test.observer}; }
  std::vector<std::string> operator()(const SimilarClaim& test) const { return test.observers; }
  std::vector<std::string> operator()(const OrderingClaim& test) const {
    std::vector<std::string> all;
    for (const auto& stage : test.stages) all.insert(all.end(), stage.begin(), stage.end());
    return all;
  }
};

// Enough for any list of claims; what goes beyond is an accident, or worse.
constexpr std::size_t kMostClaims = 1000;
constexpr std::size_t kMostContrasts = 100;
constexpr std::size_t kMostExpanded = 64 << 20;  // [bytes] of all claims that a key `each` stands for

std::vector<Contrast> read_contrasts(Reader& reader) {
  std::vector<Contrast> contrasts;
  reader.each("contrast", [&](Reader& r) {
    contrasts.push_back({text_or(r, "observer", ""), text_or(r, "profile", ""), text_or(r, "gains", ""),
                         text_or(r, "planner", ""), text_or(r, "overrides", "")});
  });
  if (contrasts.size() > kMostContrasts) reader.refuse("contrast", fmt::format("at most {} tables", kMostContrasts));
  return contrasts;
}

Claim read_claim(Reader& reader, const ClaimSet& set, const std::vector<Contrast>& contrasts) {
  Claim claim;
  claim.id = reader.text("id");
  claim.study = reader.text("case");
  claim.text = reader.text("text");
  claim.paper = reader.text("paper");
  claim.source = reader.text("source");
  const Kind kind = reader.choice("kind", kClaimKinds);
  claim.kind = kind.word;
  claim.along = kind.word == "grows";
  claim.cells = reader.texts(claim.along ? "along" : "cells");
  claim.test = kind.read(reader, set.subject);
  claim.observers = std::visit(ObserversOf{}, claim.test);
  claim.contrasts = reader.has("contrast") ? read_contrasts(reader) : contrasts;
  const auto same = [&](const Claim& other) { return other.id == claim.id; };
  if (claim.id.empty() || std::any_of(set.claims.begin(), set.claims.end(), same))
    reader.refuse("id", "an id that no other claim has");
  return claim;
}

std::string replaced(std::string text, const std::string& by) {
  for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + by.size())) {
    text.replace(at, 1, by);
  }
  return text;
}

// `room` [bytes] is what the nodes may still take.
void replace_all(Node& node, const std::string& by, std::size_t& room) {
  auto* text = std::get_if<std::string>(&node.value);
  if (text != nullptr) *text = replaced(*text, by);
  const std::size_t size = sizeof(Node) + (text == nullptr ? 0 : text->size());
  if (size > room)
    throw InputError(node.place, "each", fmt::format("its claims take more than {} bytes in all", kMostExpanded));
  room -= size;
  if (auto* array = std::get_if<Array>(&node.value)) {
    for (Node& element : *array) replace_all(element, by, room);
  }
  if (auto* table = std::get_if<Table>(&node.value)) {
    for (Entry& e : *table) replace_all(e.node, by, room);
  }
}

// A claim with the key `each` stands for one claim per text in that list, $ replaced by it.
void add_claims(const Node& claim, std::size_t& room, Array& all) {
  const Node* each = claim.find("each");
  if (each == nullptr) {
    all.push_back(claim);
    return;
  }
  std::vector<std::string> values;
  Node only_each{Table{{"each", *each}}, claim.place};
  Reader::read(only_each, "claim", [&](Reader& reader) { values = reader.texts("each"); });
  Node pattern = claim;
  erase(pattern, "each");
  for (const std::string& value : values) {
    all.push_back(pattern);
    replace_all(all.back(), value, room);
  }
}

Node expanded(const Node& document) {
  Node out = document;
  Node* list = out.find("claim");
  auto* claims = list == nullptr ? nullptr : std::get_if<Array>(&list->value);
  if (claims == nullptr) return out;
  Array all;
  std::size_t room = kMostExpanded;
  for (const Node& claim : *claims) {
    add_claims(claim, room, all);
    if (all.size() > kMostClaims) throw InputError(claim.place, "claim", fmt::format("more than {}", kMostClaims));
  }
  *claims = std::move(all);
  return out;
}

}  // namespace

std::filesystem::path paper_claims_file() {
  return data_root() / "results" / "paper_claims.toml";
}

ClaimSet load_claims(const std::filesystem::path& file) {
  ClaimSet set;
  const Node document = expanded(parse_file(file));
  Reader::read(document, "", [&](Reader& reader) {
    set.subject = reader.text("subject");
    set.ours = reader.text("ours");
    const std::vector<Contrast> contrasts = reader.has("contrast") ? read_contrasts(reader) : std::vector<Contrast>{};
    reader.each("claim", [&](Reader& r) { set.claims.push_back(read_claim(r, set, contrasts)); });
  });
  return set;
}

}  // namespace dob
