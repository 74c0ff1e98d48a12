// A field of blocks across the way (case study 6): a rectangle of equal tiles on the plane z = 0, each a block of one
// of a few kinds. Nobody but the simulator knows of it.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/terrain.h"

namespace dob {

struct BlockField {
  struct Kind {
    double height = 0.0;    // [m] above the plane
    double friction = 1.0;  // [-] of the whole block
  };
  static constexpr int kMaxBlocks = 10000;

  double start = 0.0;   // [m] x in W where the first column begins
  double end = 0.0;     // [m] x in W that the last column does not pass
  double width = 0.0;   // [m] along y, centred on y = 0
  double tile_x = 0.0;  // [m]
  double tile_y = 0.0;  // [m]
  std::vector<Kind> kinds;

  // As many whole tiles as fit: columns one behind the other along x, rows side by side along y. May be huge.
  double columns() const noexcept;
  double rows() const noexcept;

  // Throws std::invalid_argument naming the field, the value and what is allowed: at least one kind and one tile, at
  // most kMaxBlocks tiles.
  void validate() const;
};

// The blocks, column by column from `start`, in a column from the right (-y) to the left; they touch one another, and
// the rows are centred on y = 0. Seed 1 lays the regular pattern: the kind of the block in column c and row r, both
// counted from 0, is number (c + r) mod (number of kinds), so that blocks that share an edge differ. Every other seed
// shuffles these same blocks, all orders equally probable. Throws as validate().
std::vector<TerrainBox> lay_blocks(const BlockField& field, std::uint64_t seed);

}  // namespace dob
