#include "results/claim_ordering.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/claim_keys.h"
#include "results/claim_pairs.h"

namespace dob {
namespace {

double largest(const std::vector<double>& figures) {
  return *std::max_element(figures.begin(), figures.end());
}

struct Standing {
  std::string observer;
  std::vector<const CellGroup*> groups;
  Finding finding;  // median and worst of the runs that survived, falls
};

// nullopt: not run, or the metric does not apply.
std::optional<Standing> standing_of(const std::string& observer, std::size_t metric, const ClaimView& view) {
  Standing standing{view.name_of(observer), view.groups(observer), {}};
  Finding& finding = standing.finding;
  count_falls(standing.groups, finding);
  const std::vector<Sample> samples = samples_of(standing.groups, metric);
  if (samples.empty() && finding.falls == 0) return std::nullopt;
  if (samples.empty()) return standing;
  const auto less = [](const Sample& a, const Sample& b) { return a.value < b.value; };
  finding.median = median_of(samples);
  finding.worst = std::max_element(samples.begin(), samples.end(), less)->value;
  return standing;
}

// Two observers set against each other, by their figures unless falls tell already.
struct Standings {
  Verdict verdict = Verdict::kNoData;
  PairedFigures by;
};

// nullopt: falls do not tell.
std::optional<Verdict> no_worse_by_falls(const Finding& a, const Finding& b) {
  const auto verdict = [](bool yes) { return yes ? Verdict::kYes : Verdict::kNo; };
  const long left = static_cast<long>(a.falls) * b.runs, right = static_cast<long>(b.falls) * a.runs;
  if (left != right) return verdict(left < right);
  if (a.falls > 0 && a.falls == a.runs) return verdict(*a.fall_time_median_s >= *b.fall_time_median_s);
  return std::nullopt;
}

Standings no_worse(const Standing& a, const Standing& b, const OrderingClaim& claim) {
  if (const auto verdict = no_worse_by_falls(a.finding, b.finding)) return {*verdict, {}};
  Standings comparison{.by = pair_by_case(a.groups, b.groups, claim.metric)};
  const PairedFigures& by = comparison.by;
  if (by.a.empty()) return comparison;
  comparison.verdict = largest(by.a) <= claim.slack * largest(by.b) ? Verdict::kYes : Verdict::kNo;
  return comparison;
}

Standings alike(const Standing& a, const Standing& b, const SimilarClaim& claim) {
  Standings comparison{.by = pair_by_case(a.groups, b.groups, claim.metric)};
  const PairedFigures& by = comparison.by;
  if (by.a.empty()) return comparison;
  const auto [less, more] = std::minmax({largest(by.a), largest(by.b)});
  comparison.verdict = more <= claim.within_ratio * less ? Verdict::kYes : Verdict::kNo;
  return comparison;
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

std::string shown(const Standing& one, const std::vector<Standing>& all, std::size_t metric) {
  const Finding& f = one.finding;
  std::vector<std::string> parts{short_name(one, all)};
  if (f.worst) parts.push_back(describe(metric, *f.median, *f.worst, static_cast<std::size_t>(f.runs - f.falls)));
  if (f.falls > 0) parts.push_back(describe_falls(f));
  return fmt::format("{}", fmt::join(parts, " "));
}

// What the answers to every pair come to: one no is a no.
class Answer {
 public:
  Answer(const std::vector<Standing>& all, std::size_t metric) : all_(all), metric_(metric) {}

  void add(const Standing& a, const Standing& b, const Standings& comparison) {
    const std::string one = short_name(a, all_), other = short_name(b, all_);
    if (comparison.verdict == Verdict::kNo) no_ = true;
    if (comparison.verdict == Verdict::kNoData)
      open_.push_back(fmt::format("no runs of {} and {} compare", one, other));
    const PairedFigures& by = comparison.by;
    if (!by.until) return;
    on_common_time_ += fmt::format("; on common time (from {:.1f} s): {} {}, {} {}", *by.until, one,
                                   describe_all(metric_, by.a), other, describe_all(metric_, by.b));
  }

  // The figures of the first, who is the one the claim is about.
  Finding finding() const {
    Finding finding = all_.front().finding;
    std::vector<std::string> parts;
    for (const Standing& one : all_) parts.push_back(shown(one, all_, metric_));
    finding.measured = fmt::format("{}{}", fmt::join(parts, ", "), on_common_time_);
    finding.verdict = no_ ? Verdict::kNo : open_.empty() ? Verdict::kYes : Verdict::kNoData;
    if (!no_) finding.remark = fmt::format("{}", fmt::join(open_, "; "));
    return finding;
  }

 private:
  const std::vector<Standing>& all_;
  std::size_t metric_;
  bool no_ = false;
  std::vector<std::string> open_;
  std::string on_common_time_;
};

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
  std::vector<Standing> all;
  std::vector<std::size_t> ends;  // of the stages in `all`
  for (const std::vector<std::string>& stage : claim.stages) {
    for (const std::string& observer : stage) {
      const auto standing = standing_of(observer, claim.metric, view);
      if (!standing) return no_data(fmt::format("no figure of {}", view.name_of(observer)));
      all.push_back(*standing);
    }
    ends.push_back(all.size());
  }
  Answer answer(all, claim.metric);
  for (std::size_t stage = 0, begin = 0; stage + 1 < ends.size(); begin = ends[stage++]) {
    for (std::size_t a = begin; a < ends[stage]; ++a) {
      for (std::size_t b = ends[stage]; b < ends[stage + 1]; ++b) {
        answer.add(all[a], all[b], no_worse(all[a], all[b], claim));
      }
    }
  }
  return answer.finding();
}

Finding evaluate(const SimilarClaim& claim, const ClaimView& view) {
  std::vector<Standing> all;
  for (const std::string& observer : claim.observers) {
    const auto standing = standing_of(observer, claim.metric, view);
    if (!standing) return no_data(fmt::format("no figure of {}", view.name_of(observer)));
    all.push_back(*standing);
  }
  Answer answer(all, claim.metric);
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) answer.add(all[a], all[b], alike(all[a], all[b], claim));
  }
  return answer.finding();
}

}  // namespace dob
