#include "results/trace.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string_view>
#include <zlib.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "results/store.h"
#include "results/whole_file.h"
#include "results/zlib_stream.h"

namespace dob {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "dobtrace";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kPrefix = kMagic.size() + 8;
constexpr int kTraceCompression = 6;

void append(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xFFU);
}

std::uint32_t number_at(const std::string& bytes, std::size_t position) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8U | static_cast<unsigned char>(bytes[position + i]);
  return number;
}

std::string sorted_bytes(const std::vector<std::vector<float>>& columns) {
  std::string bytes;
  for (const std::vector<float>& column : columns) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      for (const float x : column) bytes += static_cast<char>(std::bit_cast<std::uint32_t>(x) >> shift & 0xFFU);
    }
  }
  return bytes;
}

std::vector<float> column_from(const std::string& bytes, std::size_t begin, std::size_t rows) {
  std::vector<float> column(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t b = 4; b-- > 0;) bits = bits << 8U | static_cast<unsigned char>(bytes[begin + b * rows + i]);
    column[i] = std::bit_cast<float>(bits);
  }
  return column;
}

std::string uncompressed(std::string_view bytes, std::size_t expected) {
  uLongf size = expected;
  std::string out(expected, '\0');
  if (uncompress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                 bytes.size()) != Z_OK ||
      size != expected) {
    throw std::runtime_error("its data are damaged");
  }
  return out;
}

std::string read_bytes(const fs::path& file) {
  std::error_code error;
  const fs::file_type type = fs::status(file, error).type();
  if (type != fs::file_type::regular && type != fs::file_type::not_found) throw std::runtime_error("is no file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

Trace from_bytes(const std::string& bytes) {
  if (bytes.size() < kPrefix || !bytes.starts_with(kMagic)) throw std::runtime_error("is not a trace");
  if (const std::uint32_t version = number_at(bytes, kMagic.size()); version != kVersion) {
    throw std::runtime_error(fmt::format("trace of version {}, this program reads version {}", version, kVersion));
  }
  const std::size_t head_size = number_at(bytes, kMagic.size() + 4);
  if (bytes.size() < kPrefix + head_size) throw std::runtime_error("its data are damaged");
  const auto head = nlohmann::json::parse(bytes.substr(kPrefix, head_size));
  Trace trace{head.at("rate_Hz").get<double>(), head.at("names").get<std::vector<std::string>>(), {}};
  const auto rows = head.at("rows").get<std::size_t>();
  const std::string data =
      uncompressed(std::string_view(bytes).substr(kPrefix + head_size), 4 * rows * trace.names.size());
  for (std::size_t i = 0; i < trace.names.size(); ++i) trace.columns.push_back(column_from(data, 4 * rows * i, rows));
  return trace;
}

}  // namespace

const std::vector<float>& Trace::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw StoreError(fmt::format("a trace has no column '{}'", name));
  return columns.at(static_cast<std::size_t>(found - names.begin()));
}

void write_trace(const fs::path& file, const Trace& trace) {
  const nlohmann::json head{{"rate_Hz", trace.rate_Hz}, {"rows", trace.rows()}, {"names", trace.names}};
  const std::string text = head.dump();
  std::string bytes(kMagic);
  append(bytes, kVersion);
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text + zlib_stream(sorted_bytes(trace.columns), kTraceCompression);
  write_whole_file(file, bytes);
}

Trace read_trace(const fs::path& file) {
  try {
    return from_bytes(read_bytes(file));
  } catch (const std::exception& error) {
    throw StoreError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace dob
