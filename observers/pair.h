// Two observers as one: the legs' part of the first estimate with the CoM's part of the second. Either may be any
// observer; what the first says about the CoM and the second about the legs is left out.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "observers/linear_observer.h"
#include "observers/observer.h"
#include "observers/options.h"

namespace dob {

class PairObserver final : public DisturbanceObserver, public LinearObserver {
 public:
  // Both must be there.
  PairObserver(std::string_view name, std::unique_ptr<DisturbanceObserver> legs,
               std::unique_ptr<DisturbanceObserver> com)
      : name_(name), legs_(std::move(legs)), com_(std::move(com)) {}

  std::string_view name() const noexcept override { return name_; }
  void reset(const ModelTerms& now) noexcept override;

  // kInvalidInput if either says so. An input that only one of them refuses (they need not read the same measurements)
  // moves the other one on.
  Estimate update(const ObserverInput& input) noexcept override;

  // That of the part which estimates the channel.
  std::optional<LinearChannel> linear(Channel channel) const override;

 private:
  std::string name_;
  std::unique_ptr<DisturbanceObserver> legs_;
  std::unique_ptr<DisturbanceObserver> com_;
};

// The name of a pair of observers, `legs=NAME,com=NAME`, in this order; empty when the text is not of that form.
struct PairName {
  std::string_view legs;
  std::string_view com;
};
std::optional<PairName> parse_pair_name(std::string_view name) noexcept;

using MakeObserver = std::function<std::unique_ptr<DisturbanceObserver>(const ObserverOptions& options, double dt)>;

// Makes both from one set of options: `legs.KEY` is option KEY of the first, `com.KEY` of the second. Throws
// OptionError for any other key, and with the pair's name and the part's before it for what a part refuses.
std::unique_ptr<DisturbanceObserver> make_pair_observer(std::string_view name, const MakeObserver& legs,
                                                        const MakeObserver& com, const ObserverOptions& options,
                                                        double dt);

}  // namespace dob
