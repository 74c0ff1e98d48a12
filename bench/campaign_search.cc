#include "bench/campaign_search.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "results/fall_threshold.h"

namespace dob {
namespace {

constexpr int kScoutLevels = 6;           // spread over the ladder, its ends among them
constexpr int kScoutSeeds = 2;            // at each of them
constexpr double kNarrowHalf = 1.5;       // [levels] width of the 50 % threshold's interval that is enough
constexpr double kNarrowTwentieth = 4.0;  // the same of the 5 % threshold: it needs many times the trials

// Levels of the ladder as a coordinate that the posterior's levels can be placed on.
class Ladder {
 public:
  explicit Ladder(const CampaignAxis& axis) {
    for (const double level : axis.levels) places_.push_back(axis.logarithmic ? std::log(level) : level);
    logarithmic_ = axis.logarithmic;
  }

  // 0 for the mildest level, size - 1 for the hardest; between two levels in proportion, beyond the ends the ends.
  double place_of(double level) const {
    const double x = logarithmic_ ? std::log(level) : level;
    const bool grows = places_.back() > places_.front();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const bool reached = grows ? x <= places_[i] : x >= places_[i];
      if (!reached) continue;
      if (i == 0) return 0.0;
      return static_cast<double>(i - 1) + (x - places_[i - 1]) / (places_[i] - places_[i - 1]);
    }
    return static_cast<double>(places_.size() - 1);
  }

 private:
  std::vector<double> places_;
  bool logarithmic_ = false;
};

// Where a threshold may lie, in levels, from mild to hard.
struct Span {
  double mild = 0.0, estimate = 0.0, hard = 0.0;
  double width() const { return hard - mild; }
};

Span span_of(const CampaignAxis& axis, const std::vector<LevelCount>& counts, double share) {
  const FallThreshold threshold = fall_threshold(counts, axis.logarithmic, share);
  const Ladder ladder(axis);
  const double a = ladder.place_of(threshold.interval.low), b = ladder.place_of(threshold.interval.high);
  return {std::min(a, b), ladder.place_of(threshold.estimate), std::max(a, b)};
}

std::vector<int> scouts(const std::vector<LevelState>& levels) {
  std::vector<int> wanted;
  const int last = static_cast<int>(levels.size()) - 1;
  const int count = std::min(kScoutLevels, last + 1);
  for (int i = 0; i < count; ++i) {
    const int level = static_cast<int>(std::lround(static_cast<double>(i * last) / (count - 1)));
    const int seeds = std::min(kScoutSeeds, levels[static_cast<std::size_t>(level)].cells);
    wanted.insert(wanted.end(), static_cast<std::size_t>(seeds), level);
  }
  return wanted;
}

// Picks levels with unused seeds, remembering what it has picked.
class Picker {
 public:
  explicit Picker(const std::vector<LevelState>& levels) {
    for (const LevelState& level : levels) unused_.push_back(level.cells - level.used());
  }

  // The nearest level to this place that has one; nothing when there is none any more.
  void pick_near(double place) {
    int nearest = -1;
    for (int i = 0; i < size(); ++i) {
      if (unused_[index(i)] > 0 && (nearest < 0 || std::abs(i - place) < std::abs(nearest - place))) nearest = i;
    }
    if (nearest >= 0) pick(nearest);
  }

  // The least tried level outside of the span, of several the one farthest from any that has been tried: gaps are
  // closed from their middle. False when there is none.
  bool pick_outside(const Span& span, const std::vector<LevelState>& levels) {
    int best = -1;
    for (int i = 0; i < size(); ++i) {
      if (unused_[index(i)] == 0 || (i >= span.mild && i <= span.hard)) continue;
      const auto rank = [&](int level) { return std::pair(levels[index(level)].used(), -distance(level, levels)); };
      if (best < 0 || rank(i) < rank(best)) best = i;
    }
    if (best >= 0) pick(best);
    return best >= 0;
  }

  const std::vector<int>& picked() const { return picked_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int size() const { return static_cast<int>(unused_.size()); }
  // To the nearest other level that has been tried.
  static int distance(int level, const std::vector<LevelState>& levels) {
    int nearest = static_cast<int>(levels.size());
    for (int i = 0; i < static_cast<int>(levels.size()); ++i) {
      if (i != level && levels[index(i)].used() > 0) nearest = std::min(nearest, std::abs(i - level));
    }
    return nearest;
  }
  void pick(int level) {
    --unused_[index(level)];
    picked_.push_back(level);
  }

  std::vector<int> unused_, picked_;
};

// By curve and level: its cells, by seed.
using CurveCells = std::vector<std::vector<std::vector<std::size_t>>>;

CurveCells cells_by_level(const Campaign& campaign) {
  CurveCells cells(campaign.curves.size());
  for (std::size_t curve = 0; curve < cells.size(); ++curve) {
    const std::vector<int>& axes = campaign.curves[curve].axes;
    cells[curve].resize(axes.empty() ? 1 : campaign.axes[static_cast<std::size_t>(axes[0])].levels.size());
  }
  for (std::size_t i = 0; i < campaign.cells.size(); ++i) {
    const CampaignCell& cell = campaign.cells[i];
    cells[cell.curve][static_cast<std::size_t>(cell.level[0])].push_back(i);
  }
  return cells;
}

std::vector<LevelState> states_of(const std::vector<std::vector<std::size_t>>& levels,
                                  const std::vector<std::optional<Outcome>>& outcomes) {
  std::vector<LevelState> states;
  for (const std::vector<std::size_t>& cells : levels) {
    LevelState& state = states.emplace_back();
    state.cells = static_cast<int>(cells.size());
    for (const std::size_t cell : cells) {
      if (!outcomes[cell]) continue;
      if (*outcomes[cell] == Outcome::kError) {
        ++state.errors;
      } else {
        ++state.trials;
        state.falls += *outcomes[cell] == Outcome::kFell ? 1 : 0;
      }
    }
  }
  return states;
}

// Adds the first unused seeds of the levels.
void add_cells(const std::vector<int>& wanted, const std::vector<std::vector<std::size_t>>& levels,
               const std::vector<LevelState>& states, std::vector<std::size_t>& cells) {
  std::vector<int> used;
  used.reserve(states.size());
  for (const LevelState& state : states) used.push_back(state.used());
  for (const int level : wanted) {
    const auto i = static_cast<std::size_t>(level);
    cells.push_back(levels[i][static_cast<std::size_t>(used[i]++)]);
  }
}

}  // namespace

long least_trials(CampaignKind kind, std::size_t levels, int seeds) {
  switch (kind) {
    case CampaignKind::kLimit:
      return std::min(static_cast<long>(levels), static_cast<long>(kScoutLevels)) * std::min(kScoutSeeds, seeds);
    case CampaignKind::kBreakdown:
      return 2L * seeds;
    case CampaignKind::kMap:
    case CampaignKind::kFactorial:
      break;
  }
  return 1;
}

std::vector<int> next_of_limit(const CampaignAxis& axis, const std::vector<LevelState>& levels, long left) {
  std::vector<LevelCount> counts;
  int used = 0, trials = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    counts.push_back({axis.levels[i], levels[i].trials, levels[i].falls});
    used += levels[i].used();
    trials += levels[i].trials;
  }
  std::vector<int> wanted;
  if (used == 0) {
    wanted = scouts(levels);
  } else if (trials > 0 && left > 0) {  // with nothing but errors there is nothing to search
    const Span half = span_of(axis, counts, 0.5), twentieth = span_of(axis, counts, 0.05);
    const double of_half = half.width() / kNarrowHalf, of_twentieth = twentieth.width() / kNarrowTwentieth;
    if (of_half <= 1.0 && of_twentieth <= 1.0) return {};
    const Span& widest = of_half >= of_twentieth ? half : twentieth;
    const Span both{std::min(half.mild, twentieth.mild), 0.0, std::max(half.hard, twentieth.hard)};
    Picker picker(levels);
    picker.pick_near((widest.mild + widest.estimate) / 2.0);
    picker.pick_near(widest.estimate);
    picker.pick_near((widest.estimate + widest.hard) / 2.0);
    if (!picker.pick_outside(both, levels)) picker.pick_near(widest.estimate);
    wanted = picker.picked();
  }
  if (static_cast<long>(wanted.size()) > left) wanted.resize(static_cast<std::size_t>(std::max(left, 0L)));
  return wanted;
}

std::vector<int> next_of_breakdown(const std::vector<LevelState>& levels, long left) {
  int broken = 0;  // levels running at which everything fell
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LevelState& level = levels[i];
    const int unused = level.cells - level.used();
    if (unused > 0) {
      return std::vector<int>(static_cast<std::size_t>(std::min(static_cast<long>(unused), std::max(left, 0L))),
                              static_cast<int>(i));
    }
    broken = level.trials > 0 && level.falls == level.trials ? broken + 1 : 0;
    if (broken == 2) break;
  }
  return {};
}

CellChoice campaign_choice(const CampaignPlan& plan) {
  const Campaign& campaign = *plan.batch.campaign;
  const long budget = plan.trials_per_curve;
  const CurveCells curves = cells_by_level(campaign);
  CellChoice choice;
  for (const auto& levels : curves) {
    std::size_t cells = 0;
    for (const auto& level : levels) cells += level.size();
    choice.most += std::min(cells, static_cast<std::size_t>(budget));
  }
  choice.next = [curves, budget, &campaign](const std::vector<std::optional<Outcome>>& outcomes) {
    std::vector<std::size_t> wanted;
    for (std::size_t curve = 0; curve < curves.size(); ++curve) {
      const std::vector<LevelState> states = states_of(curves[curve], outcomes);
      long left = budget;
      for (const LevelState& state : states) left -= state.used();
      const std::vector<int>& axes = campaign.curves[curve].axes;
      const auto next = [&] {
        if (campaign.kind == CampaignKind::kLimit) {
          return next_of_limit(campaign.axes[static_cast<std::size_t>(axes[0])], states, left);
        }
        if (campaign.kind == CampaignKind::kBreakdown) return next_of_breakdown(states, left);
        std::vector<int> all;
        for (std::size_t i = 0; i < states.size(); ++i) {
          all.insert(all.end(), static_cast<std::size_t>(states[i].cells - states[i].used()), static_cast<int>(i));
        }
        return all;
      };
      add_cells(next(), curves[curve], states, wanted);
    }
    return wanted;
  };
  return choice;
}

}  // namespace dob
