#include "sim/ode_contacts.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace dob {
namespace {

constexpr int kMaxPointsPerPair = 4;  // enough to rest a box or a cylinder on a plane

bool overlap(std::span<const dReal, 6> a, std::span<const dReal, 6> b) noexcept {
  return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] && b[4] <= a[5];
}

// First friction direction: x of W in the tangent plane; y of W where x is the normal itself.
Vec3 friction_direction(const Vec3& normal) noexcept {
  const Vec3 axis = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  return (axis - axis.dot(normal) * normal).normalized();
}

}  // namespace

OdeContacts::OdeContacts(dWorldID world, const Terrain& terrain, const SimOptions& options)
    : world_(world), options_(options), space_(dSimpleSpaceCreate(nullptr)), joints_(dJointGroupCreate(0)) {
  add_surface(dCreatePlane(space_.get(), 0.0, 0.0, 1.0, 0.0), terrain.ground_friction);
  for (const TerrainBox& box : terrain.boxes) {
    dGeomID geom = dCreateBox(space_.get(), box.size.x(), box.size.y(), box.size.z());
    dGeomSetPosition(geom, box.center.x(), box.center.y(), box.center.z());
    const OdeRotation yaw(Eigen::AngleAxisd(box.yaw_rad, Vec3::UnitZ()).toRotationMatrix());
    dGeomSetRotation(geom, yaw.data);
    add_surface(geom, box.friction);
  }
}

void OdeContacts::add_surface(dGeomID geom, double friction) {
  Surface surface{geom, std::min(friction, options_.robot_friction), {}};
  dGeomGetAABB(geom, surface.aabb.data());
  surfaces_.push_back(surface);
}

void OdeContacts::clear() {
  dJointGroupEmpty(joints_.get());
  count_ = 0;
}

void OdeContacts::find(std::span<const RobotGeom> geoms) {
  clear();
  for (const RobotGeom& part : geoms) {
    std::array<dReal, 6> aabb{};
    dGeomGetAABB(part.geom, aabb.data());
    for (const Surface& surface : surfaces_) {
      if (overlap(aabb, surface.aabb)) collide(part, surface);
    }
  }
}

void OdeContacts::collide(const RobotGeom& part, const Surface& surface) {
  std::array<dContactGeom, kMaxPointsPerPair> points;
  const int allowed = part.part == RobotGeom::Part::kFoot ? 1 : kMaxPointsPerPair;
  const int found = dCollide(part.geom, surface.geom, allowed, points.data(), sizeof(dContactGeom));
  for (int i = 0; i < found; ++i) add(part, surface.friction, points[static_cast<std::size_t>(i)]);
}

void OdeContacts::add(const RobotGeom& part, double friction, const dContactGeom& geometry) {
  if (count_ == kMaxContacts) return;
  Contact& record = contacts_[count_++];
  record = {&part, from_ode(geometry.pos), from_ode(geometry.normal), {}};

  dContact contact{};
  contact.surface.mode = dContactApprox1 | dContactFDir1 | dContactSoftERP | dContactSoftCFM;
  contact.surface.mu = friction;
  contact.surface.soft_erp = options_.contact_erp;
  contact.surface.soft_cfm = options_.contact_cfm;
  contact.geom = geometry;
  const Vec3 direction = friction_direction(record.normal);
  std::copy_n(direction.data(), 3, contact.fdir1);

  dJointID joint = dJointCreateContact(world_, joints_.get(), &contact);
  dJointAttach(joint, part.body, nullptr);
  dJointSetFeedback(joint, &record.feedback);
}

void OdeContacts::report(StepResult& result) const {
  for (const Contact& contact : std::span(contacts_).first(count_)) {
    const RobotGeom& part = *contact.part;
    result.trunk_contact |= part.part == RobotGeom::Part::kTrunk;
    result.leg_contact |= part.part == RobotGeom::Part::kLeg;
    if (part.part != RobotGeom::Part::kFoot) continue;

    const auto leg = static_cast<std::size_t>(part.leg);
    result.foot_contact[leg] = true;
    result.foot_force_W[leg] += from_ode(contact.feedback.f1);
    // The body has moved on since the contact was found; its velocity is that of the step, the arm the old
    // one.
    dVector3 velocity;
    dBodyGetPointVel(part.body, contact.point.x(), contact.point.y(), contact.point.z(), velocity);
    const Vec3 v = from_ode(velocity);
    const Vec3 slip = v - v.dot(contact.normal) * contact.normal;
    if (slip.squaredNorm() > result.foot_slip_W[leg].squaredNorm()) result.foot_slip_W[leg] = slip;
  }
}

}  // namespace dob
