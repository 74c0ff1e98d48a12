// Where what the program reads besides its arguments is: scenarios/, robot/ and results/, laid out as in the source
// tree.
#pragma once

#include <filesystem>
#include <vector>

namespace dob {

// PREFIX/share/dobbench beside a program PREFIX/bin/PROGRAM, so that an installed tree may be moved; else the source
// tree the program was built from; else the share directory of the prefix that the build was configured for.
// The last of these when data are nowhere; opening a file there then says what is missing.
std::filesystem::path data_root();

// The same for a given program: the first of its own share directory and `others` that holds data, else the last.
std::filesystem::path data_root_of(const std::filesystem::path& program,
                                   const std::vector<std::filesystem::path>& others);

}  // namespace dob
