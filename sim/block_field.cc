#include "sim/block_field.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "sim/random_stream.h"
#include "sim/require.h"

namespace dob {
namespace {

constexpr std::uint32_t kFieldStream = 0xb10cu;

// Whole tiles within a length, of which rounding does not cost one.
double whole_tiles(double length, double tile) noexcept {
  constexpr double kSlack = 1e-9;  // of a tile
  return std::floor(length / tile + kSlack);
}

std::vector<std::size_t> regular_pattern(std::size_t columns, std::size_t rows, std::size_t kinds) {
  std::vector<std::size_t> pattern;
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t r = 0; r < rows; ++r) pattern.push_back((c + r) % kinds);
  }
  return pattern;
}

// Fisher and Yates.
void shuffle(std::vector<std::size_t>& pattern, std::uint64_t seed) {
  std::mt19937_64 random = random_stream(seed, kFieldStream);
  for (std::size_t i = pattern.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(uniform(random) * static_cast<double>(i));
    std::swap(pattern[i - 1], pattern[other]);
  }
}

}  // namespace

double BlockField::columns() const noexcept {
  return whole_tiles(end - start, tile_x);
}

double BlockField::rows() const noexcept {
  return whole_tiles(width, tile_y);
}

void BlockField::validate() const {
  const Require require{"block field"};
  require.finite("start", start);
  require.positive("tile_x", tile_x);
  require.positive("tile_y", tile_y);
  require(std::isfinite(end) && columns() >= 1.0, "end", end, "finite and at least a tile past start");
  require(std::isfinite(width) && rows() >= 1.0, "width", width, "finite and at least that of a tile");
  require(columns() * rows() <= kMaxBlocks, "number of blocks", columns() * rows(), fmt::format("<= {}", kMaxBlocks));
  require(!kinds.empty(), "number of kinds", 0.0, "at least 1");
  for (const Kind& kind : kinds) {
    require.positive("height", kind.height);
    require.not_negative("friction", kind.friction);
  }
}

std::vector<TerrainBox> lay_blocks(const BlockField& field, std::uint64_t seed) {
  field.validate();
  const auto columns = static_cast<std::size_t>(field.columns());
  const auto rows = static_cast<std::size_t>(field.rows());
  std::vector<std::size_t> pattern = regular_pattern(columns, rows, field.kinds.size());
  if (seed != 1) shuffle(pattern, seed);

  const double right = -0.5 * static_cast<double>(rows) * field.tile_y;  // y of the first row's edge
  std::vector<TerrainBox> blocks;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const BlockField::Kind& kind = field.kinds[pattern[i]];
    const std::size_t column = i / rows;
    const std::size_t row = i % rows;
    const double x = field.start + (static_cast<double>(column) + 0.5) * field.tile_x;
    const double y = right + (static_cast<double>(row) + 0.5) * field.tile_y;
    blocks.push_back({.center = {x, y, 0.5 * kind.height},
                      .size = {field.tile_x, field.tile_y, kind.height},
                      .yaw_rad = 0.0,
                      .friction = kind.friction});
  }
  return blocks;
}

}  // namespace dob
