// The page's decoding of time series, step by step and without the code that encodes them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>
#include <zlib.h>

#include <nlohmann/json.hpp>

namespace dob::test {

inline std::string from_base64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (text.size() % 4 != 0) throw std::runtime_error("base64 without its padding");
  std::string bytes;
  std::uint32_t bits = 0;
  int there = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) throw std::runtime_error("not base64");
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    there += 6;
    if (there < 8) continue;
    there -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(there) & 0xFFU);
  }
  return bytes;
}

inline std::string inflated(const std::string& stream) {
  std::string bytes(64U << 20U, '\0');
  uLongf size = bytes.size();
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(stream.data()),
                 stream.size()) != Z_OK) {
    throw std::runtime_error("not a zlib stream");
  }
  bytes.resize(size);
  return bytes;
}

// `count` numbers from the byte `begin` on, differences summed up.
inline std::vector<std::int16_t> numbers_at(const std::string& bytes, std::size_t begin, std::size_t count) {
  std::vector<std::int16_t> numbers;
  std::uint16_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto low = static_cast<unsigned char>(bytes.at(begin + 2 * i));
    const auto high = static_cast<unsigned char>(bytes.at(begin + 2 * i + 1));
    sum = static_cast<std::uint16_t>(sum + (low | high << 8U));
    numbers.push_back(static_cast<std::int16_t>(sum));
  }
  return numbers;
}

inline std::vector<double> values_of(const std::vector<std::int16_t>& numbers, double offset, double scale) {
  std::vector<double> values;
  for (const std::int16_t number : numbers) {
    values.push_back(number == -32768 ? std::numeric_limits<double>::quiet_NaN() : offset + scale * number);
  }
  return values;
}

// A trace of the page: its description and its text.
class PageTrace {
 public:
  PageTrace(nlohmann::ordered_json description, std::string_view base64)
      : description_(std::move(description)), bytes_(inflated(from_base64(base64))) {}

  // Empty when it has no such signal.
  std::vector<double> replay(const std::string& name) const { return values("replay", name, 0); }
  std::vector<double> plot(const std::string& name) const {
    return values("plots", name, 2 * count("replay") * description_.at("replay").at("signals").size());
  }

  double scale(const std::string& part, const std::string& name) const {
    for (const auto& signal : description_.at(part).at("signals")) {
      if (signal.at("name") == name) return signal.at("scale").get<double>();
    }
    throw std::runtime_error("no signal " + name);
  }

  // As many as the description says there are.
  bool is_complete() const {
    return bytes_.size() == 2 * (count("replay") * description_.at("replay").at("signals").size() +
                                 count("plots") * description_.at("plots").at("signals").size());
  }

  const nlohmann::ordered_json& description() const { return description_; }

 private:
  std::size_t count(const std::string& part) const {
    return description_.at(part).at(part == "replay" ? "frames" : "points").get<std::size_t>();
  }

  std::vector<double> values(const std::string& part, const std::string& name, std::size_t begin) const {
    for (const auto& signal : description_.at(part).at("signals")) {
      if (signal.at("name") == name) {
        return values_of(numbers_at(bytes_, begin, count(part)), signal.at("offset"), signal.at("scale"));
      }
      begin += 2 * count(part);
    }
    return {};
  }

  nlohmann::ordered_json description_;
  std::string bytes_;
};

}  // namespace dob::test
