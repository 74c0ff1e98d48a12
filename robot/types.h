// Vocabulary of the whole project: fixed-size types, leg and link names. Frames and symbols: docs/notation.md.
#pragma once

#include <array>
#include <string_view>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace dob {

inline constexpr int kLegs = 4;                        // n_l
inline constexpr int kJointsPerLeg = 3;                // n
inline constexpr int kJoints = kLegs * kJointsPerLeg;  // n n_l
inline constexpr int kBaseDof = 6;                     // floating base
inline constexpr int kDof = kBaseDof + kJoints;        // 6 + n n_l
inline constexpr double kGravity = 9.81;               // [m/s^2], along -z of W

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Vec12 = Eigen::Matrix<double, 12, 1>;
using Vec18 = Eigen::Matrix<double, 18, 1>;
using Mat3 = Eigen::Matrix3d;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat12 = Eigen::Matrix<double, 12, 12>;
using Mat18 = Eigen::Matrix<double, 18, 18>;
using Mat36 = Eigen::Matrix<double, 3, 6>;
using Mat6x12 = Eigen::Matrix<double, 6, 12>;
using Mat12x6 = Eigen::Matrix<double, 12, 6>;
using Mat3x18 = Eigen::Matrix<double, 3, 18>;

// Legs are named by the direction of travel (x of the base frame B); the index is the order in every stacked
// vector: joints and feet are [LF; RF; LH; RH], three entries each.
enum class Leg : int { kLF = 0, kRF = 1, kLH = 2, kRH = 3 };
inline constexpr std::array<std::string_view, kLegs> kLegNames{"LF", "RF", "LH", "RH"};

// Moving links of one leg, from the trunk outwards; the enumerator is also the index of the joint that moves it.
enum class LegLink : int { kHip = 0, kUpper = 1, kLower = 2 };
inline constexpr std::array<std::string_view, kJointsPerLeg> kLegLinkNames{"hip", "upper", "lower"};

template <typename T>
using PerLeg = std::array<T, kLegs>;

// State of the floating-base robot. v = [v_WB; omega_WB; qd], all linear and angular parts along the axes of W.
struct RobotState {
  Vec3 p_WB = Vec3::Zero();      // [m] origin of the base frame B
  Mat3 R_WB = Mat3::Identity();  // rotation from B to W
  Vec3 v_WB = Vec3::Zero();      // [m/s] velocity of the origin of B
  Vec3 omega_WB = Vec3::Zero();  // [rad/s] angular velocity of B
  Vec12 q = Vec12::Zero();       // [rad]
  Vec12 qd = Vec12::Zero();      // [rad/s]
};

// Matrix of the cross product: skew(a) b = a x b.
inline Mat3 skew(const Vec3& a) noexcept {
  Mat3 s;
  s << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return s;
}

}  // namespace dob
