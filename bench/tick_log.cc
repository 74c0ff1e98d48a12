#include "bench/tick_log.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "results/whole_file.h"

namespace dob {
namespace {

// What stood there before is replaced; what a link points to is left alone.
std::ofstream make_file(const std::filesystem::path& file) {
  std::error_code nothing_there;
  std::filesystem::remove(file, nothing_there);
  return std::ofstream(file);
}

}  // namespace

TickLog::TickLog(const std::filesystem::path& file, double rate, double dt)
    : file_(file), out_(make_file(file)), signals_(tick_signals()), decimation_(rate, dt) {
  for (const Signal& signal : signals_) line_ += (line_.empty() ? "" : ",") + signal.name;
  out_ << line_ << '\n';
  if (!out_) throw WriteError(fmt::format("{}: cannot be written", file.string()));
}

void TickLog::add(const TickRecord& tick) {
  if (!decimation_.keep()) return;
  line_.clear();
  for (const Signal& signal : signals_) {
    const double value = signal.value(tick);
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(line_), "{}", value);
    line_ += ',';
  }
  line_.back() = '\n';
  out_ << line_;
}

void TickLog::close() {
  out_.close();
  if (!out_) throw WriteError(fmt::format("{}: could not be written completely", file_.string()));
}

}  // namespace dob
