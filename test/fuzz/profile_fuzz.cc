// A profile: what is taken makes every observer, and comes back from its own text.
#include "scenarios/data_directory.h"
#include "test/fuzz/harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const dob::fuzz::InputFile file("input.toml"), written("written.toml");
  const std::string& path = file.write(dob::fuzz::text_of(data, size));
  std::string text;
  try {
    dob::is_profile(path);
    text = dob::profile_toml(dob::load_profile(path));
  } catch (const dob::InputError& error) {
    dob::fuzz::check_refusal(error.what(), {path});
    return 0;
  }
  try {
    if (dob::profile_toml(dob::load_profile(written.write(text))) != text)
      dob::fuzz::finding("the profile comes back as another one:\n" + text);
  } catch (const dob::InputError& error) {
    dob::fuzz::finding("what was written is refused: " + std::string(error.what()) + "\n" + text);
  }
  return 0;
}
