#include "bench/cell_files.h"

#include <cctype>

#include <fmt/format.h>

namespace dob {

std::string cell_file_name(std::size_t index, const CellKey& key) {
  constexpr std::size_t kLongest = 160;  // a specification may be long, a file system's names may not
  std::string name = fmt::format("{:05}_{}_{}_{}_{}_{}_{}_seed{}", index + 1, key.scenario, key.variant, key.observer,
                                 key.profile, key.gains, key.planner, key.seed);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '_' && c != '-') c = '_';
  }
  return name.substr(0, kLongest);
}

TraceRecorder::TraceRecorder(double rate, double dt) : signals_(tick_signals()), decimation_(rate, dt) {
  trace_.rate_Hz = decimation_.rate();
  for (const Signal& signal : signals_) trace_.names.push_back(signal.name);
  trace_.columns.resize(signals_.size());
}

void TraceRecorder::add(const TickRecord& tick) {
  if (!decimation_.keep()) return;
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    trace_.columns[i].push_back(static_cast<float>(signals_[i].value(tick)));
  }
}

}  // namespace dob
