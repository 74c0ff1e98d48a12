// The ticks of a trial as a CSV file: --log csv. Made for PlotJuggler: the first column is the time and increases
// strictly, names nest with '/', every value is a number; what does not apply is empty.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/signals.h"

namespace dob {

class TickLog {
 public:
  // About `rate` [Hz] of the ticks of dt [s]. Throws WriteError if the file cannot be made.
  TickLog(const std::filesystem::path& file, double rate, double dt);
  void add(const TickRecord& tick);
  // Throws WriteError if something could not be written.
  void close();

 private:
  std::filesystem::path file_;
  std::ofstream out_;
  std::vector<Signal> signals_;
  Decimation decimation_;
  std::string line_;
};

}  // namespace dob
