// The observer of a command line, `--observer NAME:key=value,...`. The first byte chooses the profile.
#include <array>

#include "observers/factory.h"
#include "scenarios/document.h"
#include "test/fuzz/harness.h"

namespace {

constexpr std::array kProfiles{"paper", "matched", "tuned"};

// It would be loaded, and it can do whatever it likes.
bool may_name_a_plugin(std::string_view text) {
  return text.find('/') != std::string_view::npos || text.find(".so") != std::string_view::npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = dob::fuzz::text_of(data, size);
  if (text.empty() || text.find('\0') != std::string_view::npos || may_name_a_plugin(text)) return 0;
  static const dob::fuzz::InputFile file("observer.toml");
  try {
    const dob::ObserverConfig observer = dob::load_observer(text.substr(1), kProfiles.at(data[0] % kProfiles.size()));
    dob::make_observer(observer.observer, observer.options, dob::SimOptions{}.dt);
    const std::string written = dob::observer_toml(observer);
    if (dob::to_toml(dob::parse_file(file.write(written))) != written)
      dob::fuzz::finding("the observer comes back as another one:\n" + written);
  } catch (const dob::InputError& error) {
    dob::fuzz::check_refusal(error.what(), {"--observer "});
  }
  return 0;
}
