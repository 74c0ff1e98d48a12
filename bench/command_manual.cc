#include <fmt/format.h>

#include "bench/build_info.h"
#include "bench/commands.h"
#include "bench/manual.h"

namespace dob {

Command add_manual_command(CLI::App& app) {
  app.add_subcommand("manual", "the manual page dobbench(1), as text for man");
  return [&app] {
    fmt::print("{}", manual_page(app, fmt::format("dobbench {}", build_info().version)));
    return kExitOk;
  };
}

}  // namespace dob
