// Overrides, `--set KEY=VALUE`: a line each. The first byte chooses what they are laid over.
#include <array>
#include <utility>

#include "scenarios/data_directory.h"
#include "test/fuzz/harness.h"

namespace {

constexpr std::array kScenarios{"undisturbed", "case1/tip_lateral", "case3", "case4", "case6", "payload", "crawl",
                                "chirp_knee",  "imperfect_sensing"};
constexpr std::size_t kMostOverrides = 16;

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < kMostOverrides) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = dob::fuzz::text_of(data, size);
  if (text.empty() || text.find('\0') != std::string_view::npos) return 0;  // no argument holds a zero byte
  dob::ScenarioRequest request{.name = kScenarios.at(data[0] % kScenarios.size())};
  request.overrides = lines_of(text.substr(1));
  try {
    dob::fuzz::load_and_resolve(request);
  } catch (const dob::InputError& error) {
    dob::fuzz::check_refusal(error.what(), {"--set", dob::data_directory().string()});
  }
  return 0;
}
