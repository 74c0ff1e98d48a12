// A figure as a gnuplot script and the data it reads, to be kept and restyled: `gnuplot FIGURE.gp` beside FIGURE.dat.
// One column of a journal wide (84 mm), text of 8 pt and less, without serifs.
#pragma once

#include <string>

#include "results/figure.h"

namespace dob {

enum class FigureFormat { kSvg, kPdf, kPng };

std::string to_string(FigureFormat format);  // also the extension of the files

struct GnuplotFiles {
  std::string script, data;
};

// The same figure gives the same bytes. Texts from anywhere are quoted: none can become a command.
GnuplotFiles gnuplot_files(const Figure& figure, FigureFormat format);

// The text as one of gnuplot's double-quoted strings, with octal numbers for what is special in them; control
// characters become blanks.
std::string gnuplot_quoted(const std::string& text);

}  // namespace dob
