// Every tick of a trial as a CSV file: --log csv.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "results/cell.h"
#include "results/tick_record.h"

namespace dob {

class TickLog {
 public:
  // Throws StoreError if the file cannot be made.
  explicit TickLog(const std::filesystem::path& file);
  void add(const TickRecord& tick);
  // Throws StoreError if something could not be written.
  void close();

 private:
  std::filesystem::path file_;
  std::ofstream out_;
  std::string line_;
};

// A file name made of the cell's key; letters, digits, '.', '_' and '-' only.
std::string log_name(const CellKey& key);

}  // namespace dob
