#include "results/claim_ordering.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/claim_keys.h"

namespace dob {
namespace {

struct Standing {
  std::string observer;
  Finding finding;  // median, worst, falls
};

std::optional<Standing> standing_of(const std::string& observer, std::size_t metric, const ClaimView& view) {
  const std::vector<const CellGroup*> groups = view.groups(observer);
  Standing standing{view.name_of(observer), {}};
  count_falls(groups, standing.finding);
  const std::vector<Sample> samples = samples_of(groups, metric);
  if (samples.empty()) return std::nullopt;
  const auto less = [](const Sample& a, const Sample& b) { return a.value < b.value; };
  standing.finding.median = median_of(samples);
  standing.finding.worst = std::max_element(samples.begin(), samples.end(), less)->value;
  return standing;
}

bool no_worse(const Finding& a, const Finding& b, double slack) {
  const long left = static_cast<long>(a.falls) * b.runs, right = static_cast<long>(b.falls) * a.runs;
  if (left != right) return left < right;
  if (a.falls > 0 && a.falls == a.runs) return *a.fall_time_median_s >= *b.fall_time_median_s;
  return *a.worst <= slack * *b.worst;
}

// The parts of NAME:key=value,... by which observers differ; the whole name where there is nothing else.
std::vector<std::string> parts_of(const std::string& observer) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= observer.size();) {
    const std::size_t end = std::min(observer.find_first_of(":,", begin), observer.size());
    parts.push_back(observer.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::string short_name(const Standing& one, const std::vector<Standing>& all) {
  std::vector<std::string> own;
  for (const std::string& part : parts_of(one.observer)) {
    const bool shared = std::all_of(all.begin(), all.end(), [&](const Standing& other) {
      const std::vector<std::string> parts = parts_of(other.observer);
      return std::find(parts.begin(), parts.end(), part) != parts.end();
    });
    if (!shared) own.push_back(part);
  }
  return own.empty() ? one.observer : fmt::format("{}", fmt::join(own, ","));
}

std::string describe_all(const std::vector<Standing>& all, std::size_t metric) {
  std::vector<std::string> parts;
  for (const Standing& one : all) {
    const Finding& f = one.finding;
    const std::string falls = f.falls > 0 ? fmt::format(" {}", describe_falls(f)) : "";
    const auto runs = static_cast<std::size_t>(f.runs);
    parts.push_back(fmt::format("{} {}{}", short_name(one, all), describe(metric, *f.median, *f.worst, runs), falls));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

// The figures of the first, who is the one the claim is about.
Finding finding_of(const std::vector<Standing>& all, std::size_t metric) {
  Finding finding = all.front().finding;
  finding.measured = describe_all(all, metric);
  return finding;
}

std::vector<std::string> split_stage(const std::string& text) {
  constexpr std::string_view kOr = " | ";
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(kOr); end != std::string::npos; end = text.find(kOr, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + kOr.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::vector<std::string> read_observers(Reader& reader) {
  std::vector<std::string> observers = reader.texts("observers");
  if (reader.has("observers") && observers.size() < 2) reader.refuse("observers", "a list of at least two");
  return observers;
}

}  // namespace

OrderingClaim read_ordering(Reader& reader, const std::string& /*subject*/) {
  OrderingClaim claim;
  for (const std::string& stage : read_observers(reader)) claim.stages.push_back(split_stage(stage));
  claim.metric = read_metric(reader, "metric");
  claim.slack = reader.number("slack_ratio", between(1.0, 10.0), 1.0);
  return claim;
}

SimilarClaim read_similar(Reader& reader, const std::string& /*subject*/) {
  SimilarClaim claim;
  claim.observers = read_observers(reader);
  claim.metric = read_metric(reader, "metric");
  claim.within_ratio = reader.number("within_ratio", between(1.0, 10.0));
  return claim;
}

Finding evaluate(const OrderingClaim& claim, const ClaimView& view) {
  std::vector<Standing> all, before;
  bool ordered = true;
  for (const std::vector<std::string>& stage : claim.stages) {
    std::vector<Standing> present;
    for (const std::string& observer : stage) {
      const auto standing = standing_of(observer, claim.metric, view);
      if (!standing) return no_data(fmt::format("no figure of {}", view.name_of(observer)));
      for (const Standing& better : before) {
        ordered = ordered && no_worse(better.finding, standing->finding, claim.slack);
      }
      present.push_back(*standing);
    }
    all.insert(all.end(), present.begin(), present.end());
    before = std::move(present);
  }
  Finding finding = finding_of(all, claim.metric);
  finding.verdict = ordered ? Verdict::kYes : Verdict::kNo;
  return finding;
}

Finding evaluate(const SimilarClaim& claim, const ClaimView& view) {
  std::vector<Standing> all;
  for (const std::string& observer : claim.observers) {
    const auto standing = standing_of(observer, claim.metric, view);
    if (!standing) return no_data(fmt::format("no figure of {}", view.name_of(observer)));
    all.push_back(*standing);
  }
  const auto by_worst = [](const Standing& a, const Standing& b) { return *a.finding.worst < *b.finding.worst; };
  const auto [least, most] = std::minmax_element(all.begin(), all.end(), by_worst);
  const bool none_falls = std::all_of(all.begin(), all.end(), [](auto& s) { return s.finding.falls == 0; });
  const bool all_fall = std::all_of(all.begin(), all.end(), [](auto& s) { return s.finding.falls == s.finding.runs; });
  const bool alike = *most->finding.worst <= claim.within_ratio * *least->finding.worst;
  Finding finding = finding_of(all, claim.metric);
  finding.verdict = alike && (none_falls || all_fall) ? Verdict::kYes : Verdict::kNo;
  return finding;
}

}  // namespace dob
