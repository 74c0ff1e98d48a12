#include "bench/gnuplot_process.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

extern char** environ;  // NOLINT: as POSIX has it

namespace dob {
namespace {

// Everything that comes through the pipe until the other side closes it.
std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = ::read(descriptor, buffer.data(), buffer.size())) != 0;) {
    if (n < 0 && errno != EINTR) break;
    if (n > 0) text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  return text;
}

int exit_status(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

// Starts gnuplot with both its outputs on `output`; an error of posix_spawn, 0 for none.
int start(const std::filesystem::path& dir, const std::string& script, int output, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, dir.c_str());
  std::string name = "gnuplot";
  std::string defaults = "-d";  // nobody's ~/.gnuplot
  std::string argument = script;
  const std::array<char*, 4> arguments{name.data(), defaults.data(), argument.data(), nullptr};
  const int error = ::posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

void run_gnuplot(const std::filesystem::path& dir, const std::string& script) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw GnuplotError(fmt::format("gnuplot: {}", std::strerror(errno)));
  pid_t child = 0;
  const int error = start(dir, script, ends[1], child);
  ::close(ends[1]);
  const std::string said = error == 0 ? read_all(ends[0]) : "";
  ::close(ends[0]);
  if (error == ENOENT) throw GnuplotError("gnuplot is not there: install the Debian package gnuplot-nox");
  if (error != 0) throw GnuplotError(fmt::format("gnuplot cannot be started: {}", std::strerror(error)));
  const int status = exit_status(child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && said.empty()) return;
  throw GnuplotError(fmt::format("gnuplot {}: {}", (dir / script).string(), said.empty() ? "did not end well" : said));
}

}  // namespace dob
