// What the fuzz targets have in common: the input as a file, as the program would meet it, and what an answer has to
// be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "scenarios/loader.h"

namespace dob::fuzz {

// A file in memory (where the system has /dev/shm), written anew for each input; gone when the process ends.
class InputFile {
 public:
  explicit InputFile(const std::string& name);            // with its extension
  const std::string& write(std::string_view text) const;  // returns the path

 private:
  std::string path_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};  // NOLINT: bytes from libFuzzer
}

// Reports something that must not be and ends the process, so that libFuzzer keeps the input.
[[noreturn]] void finding(const std::string& what);

// A refusal names a place, which begins with one of those given, and behind it a reason; it is one printable line of
// bounded length.
void check_refusal(const std::string& message, std::initializer_list<std::string_view> places);

// Loads what the request asks for. What is taken has to be valid: its terrain can be laid, and its resolved form loads
// to the same resolved form. Throws InputError for what is refused.
void load_and_resolve(const ScenarioRequest& request);

}  // namespace dob::fuzz
