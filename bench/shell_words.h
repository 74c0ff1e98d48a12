// A command line as one line of text that a shell, and this program, splits again into the same words.
#pragma once

#include <string>
#include <vector>

namespace dob {

// Words with characters that a shell gives a meaning stand in single quotes.
std::string join_words(const std::vector<std::string>& words);

// Of what join_words made; understands blanks, '...' and \c, nothing else of a shell.
std::vector<std::string> split_words(const std::string& line);

}  // namespace dob
