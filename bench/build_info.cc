#include "bench/build_info.h"

#include <commit.h>  // made by the build

namespace dob {

BuildInfo build_info() {
  return {.version = DOB_VERSION,
          .commit = DOB_COMMIT,
          .build_type = DOB_BUILD_TYPE,
          .compiler = DOB_COMPILER,
          .flags = DOB_FLAGS};
}

}  // namespace dob
