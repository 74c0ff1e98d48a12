// What each figure shows, as data: results/paper_figures.toml (keys: docs/figures.md). Nothing here knows a run.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dob {

// A value over time, made of a trace's signals. `$` in the texts stands for the leg of the panel.
struct FigureQuantity {
  std::string id;
  std::string axis;                  // label of the axis, with the unit
  double scale = 1.0;                // from the signals' unit to the axis'
  std::vector<std::string> signals;  // one: its value; several: their Euclidean norm
  std::vector<std::string> minus;    // taken from the signals one by one before that; or empty
  std::vector<std::string> truth;    // what the signals estimate, combined in the same way; or empty
  std::string while_signal;          // only where this signal is not zero; "": everywhere
};

struct FigurePanelSpec {
  std::string quantity;  // id
  std::string leg;       // "" where the quantity has no leg
  std::string title;
  std::vector<std::string> cells;              // as FigureSpec::cells; empty: those of the figure
  std::vector<std::string> observers, labels;  // empty: those of the figure, under their names
  bool each_observer = false;                  // a panel of its own for every observer
  bool shade_swing = false, shade_disturbance = false;
  std::optional<std::array<double, 2>> time_s, limits;  // shown part of the two axes
};

enum class FigureKind {
  kTime,      // signals over time
  kErrors,    // metrics by scenario and observer
  kSurvival,  // share of runs that survived over the disturbance's amplitude
  kRobot,     // the robot with its frames
  kPicture,   // not drawn here: the note says where it is
};

struct FigureSpec {
  std::string id;     // name of its files
  std::string paper;  // number in the paper; "": has none
  std::string caption;
  std::string note;
  FigureKind kind = FigureKind::kTime;
  std::vector<std::string> cells;      // SCENARIO or SCENARIO/VARIANT; the first that the run has is shown
  std::vector<std::string> observers;  // specifications, as in the run
  std::vector<std::string> leave_out;  // scenarios that kErrors does not show
  std::string profile;                 // of the cells; "": the one that the user chooses
  int columns = 1;
  std::vector<FigurePanelSpec> panels;
};

struct FigureSet {
  std::vector<FigureQuantity> quantities;
  std::vector<FigureSpec> figures;

  const FigureQuantity& quantity(const std::string& id) const;  // must be there
};

std::filesystem::path paper_figures_file();

// Throws InputError for the first thing that is wrong with the file.
FigureSet load_figures(const std::filesystem::path& file);

// The text with every `$` replaced by the leg's name.
std::string with_leg(std::string text, const std::string& leg);

}  // namespace dob
