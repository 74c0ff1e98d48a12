// A scenario's file.
#include "scenarios/data_directory.h"
#include "test/fuzz/harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const dob::fuzz::InputFile file("input.toml");
  const std::string& path = file.write(dob::fuzz::text_of(data, size));
  try {
    dob::fuzz::load_and_resolve({.name = path});
  } catch (const dob::InputError& error) {
    dob::fuzz::check_refusal(error.what(), {path, dob::data_directory().string()});
  }
  return 0;
}
