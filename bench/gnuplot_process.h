// Running gnuplot, one process for a figure and no shell.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace dob {

class GnuplotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Runs `gnuplot -d SCRIPT` in `dir`, where the script's own paths begin. Throws GnuplotError if there is no gnuplot
// (naming the package), and with what it has to say if it does not end well.
void run_gnuplot(const std::filesystem::path& dir, const std::string& script);

}  // namespace dob
