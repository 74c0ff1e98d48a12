// [terrain]: what the robot walks on.
#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "scenarios/reader.h"
#include "scenarios/schema.h"

namespace dob {
namespace {

constexpr Range kPlace = between(-1e4, 1e4);                                        // [m] in W
constexpr Range kEdge = above(0.0, 1e4);                                            // [m]
constexpr Range kBlockHeight = above(0.0, 1.0);                                     // [m]
constexpr Range kAngle = between(-2.0 * std::numbers::pi, 2.0 * std::numbers::pi);  // [rad]

TerrainBox read_box(Reader& r) {
  return {.center = r.vector("center_m", kPlace),
          .size = r.vector("size_m", kEdge),
          .yaw_rad = r.number("yaw_rad", kAngle, 0.0),
          .friction = r.number("friction", kFriction)};
}

// Heights and frictions are pairs.
std::vector<BlockField::Kind> read_kinds(Reader& r) {
  const std::vector<double> heights = r.numbers("heights_m", kBlockHeight);
  const std::vector<double> frictions = r.numbers("frictions", kFriction);
  if (r.has("heights_m") && r.has("frictions") && frictions.size() != heights.size())
    r.refuse("frictions", fmt::format("as many numbers as heights_m has, {}", heights.size()));
  std::vector<BlockField::Kind> kinds;
  for (std::size_t i = 0; i < std::min(heights.size(), frictions.size()); ++i) {
    kinds.push_back({heights[i], frictions[i]});
  }
  return kinds;
}

void read_tiles(Reader& r, BlockField& field) {
  const std::vector<double> tile = r.numbers("tile_m", kEdge);
  if (!r.has("tile_m")) return;
  if (tile.size() != 2) r.refuse("tile_m", "two numbers, along x and along y");
  field.tile_x = tile[0];
  field.tile_y = tile[1];
  if (!r.has("start_m") || !r.has("end_m") || !r.has("width_m")) return;
  if (field.columns() < 1.0 || field.rows() < 1.0)
    r.refuse("tile_m", fmt::format("at most the field's {:.6g} by {:.6g}", field.end - field.start, field.width));
  if (const double blocks = field.columns() * field.rows(); blocks > BlockField::kMaxBlocks)
    r.refuse("tile_m", fmt::format("at most {} blocks in the field, these are {:.6g}", BlockField::kMaxBlocks, blocks));
}

BlockField read_field(Reader& r) {
  BlockField field;
  field.start = r.number("start_m", kPlace);
  field.end = r.number("end_m", kPlace);
  if (r.has("start_m") && r.has("end_m") && field.end <= field.start)
    r.refuse("end_m", fmt::format("a number above start_m, {}", field.start));
  field.width = r.number("width_m", kEdge);
  read_tiles(r, field);
  field.kinds = read_kinds(r);
  return field;
}

}  // namespace

void read_terrain(Reader& r, Scenario& scenario) {
  r.table("terrain", [&](Reader& t) {
    scenario.terrain.ground_friction = t.number("ground_friction", kFriction);
    t.each("boxes", [&](Reader& box) { scenario.terrain.boxes.push_back(read_box(box)); });
    if (t.has("field")) t.table("field", [&](Reader& f) { scenario.block_field = read_field(f); });
  });
}

}  // namespace dob
