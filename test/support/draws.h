// How many random problems a test draws.
#pragma once

namespace dob::test {

// All of them, or a tenth under a sanitizer, where each takes ten times as long.
constexpr int draws(int all) noexcept {
#if defined(DOB_SANITIZED)
  return all / 10;
#else
  return all;
#endif
}

}  // namespace dob::test
