// Tables of a profile for all observers that estimate the legs, the CoM, or both: their routing. A name's own
// [NAME.routing] goes before it. Private to scenarios/.
#pragma once

#include <array>

namespace dob {

inline constexpr const char* kOfLegs = "legs";
inline constexpr const char* kOfCom = "com";
inline constexpr const char* kOfBoth = "pair";
inline constexpr std::array kRoutedKinds{kOfLegs, kOfCom, kOfBoth};

}  // namespace dob
