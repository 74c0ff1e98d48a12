#include "results/report_robot.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "results/claim_cells.h"
#include "results/report_text.h"

namespace dob {
namespace {

Json vector_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

const char* kind_name(CollisionShape::Kind kind) {
  switch (kind) {
    case CollisionShape::Kind::kBox:
      return "box";
    case CollisionShape::Kind::kCylinder:
      return "cylinder";
    default:
      return "sphere";
  }
}

Json shape_json(const CollisionShape& shape) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rotation.push_back(shape.rotation(row, column));
  }
  return {{"kind", kind_name(shape.kind)},
          {"size", vector_json(shape.size)},
          {"position", vector_json(shape.position)},
          {"rotation", std::move(rotation)}};
}

Json link_json(const LinkDescription& link, int parent, int joint, const Vec3& origin, const Vec3& axis) {
  Json shapes = Json::array();
  for (const CollisionShape& shape : link.shapes) shapes.push_back(shape_json(shape));
  return {{"name", link.name},         {"parent", parent},           {"joint", joint}, {"origin", vector_json(origin)},
          {"axis", vector_json(axis)}, {"shapes", std::move(shapes)}};
}

// Its place among `robots`; null where it cannot be read.
Json add_robot(const RobotConfig& config, const std::string& walked, Json& robots, std::vector<std::string>& missing) {
  try {
    robots.push_back(robot_json(load_robot(config.urdf, config.forward)));
    return robots.size() - 1;
  } catch (const DescriptionError& error) {
    missing.push_back(fmt::format("No replay of {}: the robot's description cannot be read ({}).", walked,
                                  without_directories(error.what())));
    return {};
  }
}

}  // namespace

Json robot_json(const RobotDescription& robot) {
  Json links = Json::array(), feet = Json::array();
  links.push_back(link_json(robot.trunk, -1, -1, Vec3::Zero(), Vec3::UnitX()));
  for (int l = 0; l < kLegs; ++l) {
    const LegDescription& leg = robot.legs[static_cast<std::size_t>(l)];
    for (int j = 0; j < kJointsPerLeg; ++j) {
      const auto& joint = leg.joints[static_cast<std::size_t>(j)];
      const int index = kJointsPerLeg * l + j;  // of the joint; its link stands one further, behind the trunk
      links.push_back(
          link_json(leg.links[static_cast<std::size_t>(j)], j == 0 ? 0 : index, index, joint.origin, joint.axis));
    }
    feet.push_back({{"leg", kLegNames[static_cast<std::size_t>(l)]},
                    {"link", kJointsPerLeg * (l + 1)},
                    {"center", vector_json(leg.foot_center)},
                    {"radius", leg.foot_radius}});
  }
  return {{"name", robot.name},
          {"mass_kg", std::round(1e3 * robot.total_mass()) / 1e3},
          {"links", std::move(links)},
          {"feet", std::move(feet)}};
}

Json report_robots(const std::vector<ReportScenario>& scenarios, Json& shown, std::vector<std::string>& missing) {
  Json robots = Json::array();
  std::map<std::pair<std::filesystem::path, Forward>, Json> places;  // null: cannot be read
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    shown[i]["robot"] = Json();
    if (!scenarios[i].scenario) continue;
    const RobotConfig& config = scenarios[i].scenario->robot;
    const auto [place, added] = places.try_emplace({config.urdf, config.forward});
    if (added) place->second = add_robot(config, case_name(scenarios[i].cell), robots, missing);
    shown[i]["robot"] = place->second;
  }
  return robots;
}

}  // namespace dob
