#include "results/figure_robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "robot/standing_pose.h"
#include "scenarios/loader.h"

namespace dob {
namespace {

using Point = std::array<double, 2>;

constexpr int kRound = 32;                                                           // corners of what is round
constexpr double kArrow = 0.1, kArrowOfW = 0.2;                                      // [m] axes of frames
constexpr double kMarginM = 0.06;                                                    // [m] around the robot
constexpr std::array<const char*, 3> kAxisColours{"#D55E00", "#009E73", "#0072B2"};  // x, y, z

Point projected(const Vec3& p, int view) {
  return view == 1 ? Point{p.x(), p.z()} : Point{p.x(), p.y()};
}

// Points whose hull is the box or the cylinder, in its own axes.
std::vector<Vec3> corners(const CollisionShape& shape) {
  std::vector<Vec3> points;
  if (shape.kind == CollisionShape::Kind::kBox) {
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        for (const double z : {-0.5, 0.5}) points.emplace_back(shape.size.cwiseProduct(Vec3(x, y, z)));
      }
    }
    return points;
  }
  for (int i = 0; i < kRound; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kRound;
    const double c = shape.size.x() * std::cos(a);
    const double s = shape.size.x() * std::sin(a);
    for (const double end : {-0.5, 0.5}) points.emplace_back(c, s, end * shape.size.y());
  }
  return points;
}

double cross(const Point& o, const Point& a, const Point& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

// Andrew's monotone chain.
std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  std::vector<Point> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

struct Solid {
  std::vector<Point> outline;
  double depth;  // greater is nearer
  std::string colour;
};

struct Body {
  const LinkDescription* link;
  Mat3 R;
  Vec3 p;
  std::string colour;
};

class RobotDrawing {
 public:
  RobotDrawing(const RobotDescription& robot, const RobotState& state, const Vec3& com)
      : robot_(robot), state_(state), com_(com) {
    bodies_.push_back({&robot.trunk, state.R_WB, state.p_WB, "#C9D6E2"});
    for (std::size_t l = 0; l < kLegs; ++l) add_leg(l);
  }

  FigurePanel panel(int view) const {
    FigurePanel panel;
    panel.title = view == 1 ? "from the right" : "from above";
    panel.x_axis = "x [m]";
    panel.y_axis = view == 1 ? "z [m]" : "y [m]";
    panel.equal_axes = true;
    for (const Solid& solid : solids(view)) add_solid(solid, panel);
    set_range(view, panel);
    if (view == 1) add_ground(panel);
    add_frames(view, panel);
    return panel;
  }

 private:
  void add_leg(std::size_t l) {
    const LegDescription& leg = robot_.legs[l];
    Mat3 R = state_.R_WB;
    Vec3 p = state_.p_WB;
    for (std::size_t j = 0; j < kJointsPerLeg; ++j) {
      p += R * leg.joints[j].origin;
      R = R * Eigen::AngleAxisd(state_.q[static_cast<int>(3 * l + j)], leg.joints[j].axis).toRotationMatrix();
      bodies_.push_back({&leg.links[j], R, p, l % 2 == 1 ? "#9FB4C7" : "#DDE3E8"});
    }
    feet_[l] = p + R * leg.foot_center;
  }

  std::vector<Solid> solids(int view) const {
    std::vector<Solid> all;
    const auto depth = [view](const Vec3& p) { return view == 1 ? -p.y() : p.z(); };
    for (const Body& body : bodies_) {
      for (const CollisionShape& shape : body.link->shapes) {
        all.push_back({outline(shape, body.R, body.p, view), depth(body.p + body.R * shape.position), body.colour});
      }
    }
    for (std::size_t l = 0; l < kLegs; ++l) {
      CollisionShape foot{CollisionShape::Kind::kSphere, Vec3::Constant(robot_.legs[l].foot_radius), Vec3::Zero(),
                          Mat3::Identity()};
      all.push_back({outline(foot, Mat3::Identity(), feet_[l], view), depth(feet_[l]), "#5B6B7A"});
    }
    std::stable_sort(all.begin(), all.end(), [](const Solid& a, const Solid& b) { return a.depth < b.depth; });
    return all;
  }

  static void add_solid(const Solid& solid, FigurePanel& panel) {
    FigureLine line;
    line.look.colour = solid.colour;
    line.mark = FigureMark::kFill;
    for (const Point& p : solid.outline) {
      line.x.push_back(p[0]);
      line.y.push_back(p[1]);
    }
    line.x.push_back(line.x.front());
    line.y.push_back(line.y.front());
    panel.lines.push_back(std::move(line));
  }

  static void add_ground(FigurePanel& panel) {
    FigureLine ground;
    ground.look.colour = "#888888";
    ground.x = {panel.x_range[0], panel.x_range[1]};
    ground.y = {0.0, 0.0};
    panel.lines.insert(panel.lines.begin(), std::move(ground));
  }

  void set_range(int view, FigurePanel& panel) const {
    panel.x_range = panel.y_range = {1e9, -1e9};
    for (const FigureLine& line : panel.lines) {
      for (std::size_t i = 0; i < line.x.size(); ++i) {
        panel.x_range = {std::min(panel.x_range[0], line.x[i]), std::max(panel.x_range[1], line.x[i])};
        panel.y_range = {std::min(panel.y_range[0], line.y[i]), std::max(panel.y_range[1], line.y[i])};
      }
    }
    panel.x_range = {panel.x_range[0] - kMarginM, panel.x_range[1] + kMarginM};
    panel.y_range = {panel.y_range[0] - kMarginM, panel.y_range[1] + kMarginM};
    if (view == 1) panel.y_range[0] = -0.03;
  }

  void add_frame(const Vec3& origin, const Mat3& R, double length, int view, FigurePanel& panel) const {
    for (int axis = 0; axis < 3; ++axis) {
      const Point from = projected(origin, view);
      const Point to = projected(origin + length * R.col(axis), view);
      if (std::hypot(to[0] - from[0], to[1] - from[1]) < 0.2 * length) continue;  // towards the eye
      panel.arrows.push_back({from, to, kAxisColours[static_cast<std::size_t>(axis)]});
    }
  }

  void add_frames(int view, FigurePanel& panel) const {
    const auto text = [&](const Vec3& at, const std::string& words, double dx, double dy) {
      const Point p = projected(at, view);
      panel.texts.push_back({p[0] + dx, p[1] + dy, words});
    };
    add_frame(Vec3::Zero(), Mat3::Identity(), kArrowOfW, view, panel);
    add_frame(state_.p_WB, state_.R_WB, kArrow, view, panel);
    text(kArrowOfW * Vec3::UnitX(), "W", 0.012, 0.0);
    text(state_.p_WB + kArrow * state_.R_WB.col(0), "B", 0.012, view == 1 ? 0.0 : 0.022);
    FigureLine com;
    com.mark = FigureMark::kPoints;
    com.look.point = 7;
    const Point c = projected(com_, view);
    com.x = {c[0]};
    com.y = {c[1]};
    panel.lines.push_back(com);
    text(com_, "CoM", -0.1, view == 1 ? -0.002 : 0.0);
    for (std::size_t l = 0; l < kLegs; ++l) {
      if (view == 1 && l % 2 == 0) continue;  // behind the right ones
      text(feet_[l], std::string(kLegNames[l]), 0.04, 0.0);
    }
  }

  const RobotDescription& robot_;
  const RobotState& state_;
  Vec3 com_;
  std::vector<Body> bodies_;
  PerLeg<Vec3> feet_;
};

void add_robot(const Scenario& s, Figure& figure) {
  const RobotDescription robot = load_robot(s.robot.urdf, s.robot.forward);
  const Model model(robot);
  const FootstepOptions& footsteps = s.planner.footsteps;
  const RobotState state =
      standing_pose(model, s.planner.com_height, footsteps.foot_offset_x, footsteps.foot_offset_y, s.robot.posture);
  ModelTerms terms;
  model.compute(state, terms);
  const RobotDrawing drawing(robot, state, terms.p_com);
  figure.subtitle += fmt::format("{}{}, {:.1f} kg", figure.panels.empty() ? "" : "; ", robot.name, robot.total_mass());
  figure.cells.push_back("the robot of " + s.name);
  figure.panels.push_back(drawing.panel(1));
  figure.panels.push_back(drawing.panel(2));
}

}  // namespace

std::vector<Point> outline(const CollisionShape& shape, const Mat3& R_WL, const Vec3& p_WL, int view) {
  std::vector<Point> points;
  if (shape.kind == CollisionShape::Kind::kSphere) {  // its outline is a circle, however it is turned
    const Point centre = projected(p_WL + R_WL * shape.position, view);
    for (int i = 0; i < kRound; ++i) {
      const double a = 2.0 * std::numbers::pi * i / kRound;
      points.push_back({centre[0] + shape.size.x() * std::cos(a), centre[1] + shape.size.x() * std::sin(a)});
    }
    return points;
  }
  for (const Vec3& corner : corners(shape)) {
    points.push_back(projected(p_WL + R_WL * (shape.position + shape.rotation * corner), view));
  }
  return convex_hull(std::move(points));
}

Figure robot_figure(const std::string& id, const std::vector<std::filesystem::path>& scenarios) {
  Figure figure;
  figure.id = id;
  std::set<std::pair<std::filesystem::path, Forward>> shown;
  for (const std::filesystem::path& file : scenarios) {
    const Scenario s = load_scenarios({.name = file.string()}).front();
    if (shown.emplace(s.robot.urdf, s.robot.forward).second) add_robot(s, figure);
  }
  figure.subtitle += "; axes x red, y green, z blue";
  if (shown.size() == 1) return figure;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    figure.panels[i].title = figure.cells[i / 2] + ", " + figure.panels[i].title;
  }
  return figure;
}

}  // namespace dob
