// Compression of time series. Private to results/.
#pragma once

#include <string>

namespace dob {

// `bytes` as a zlib stream (RFC 1950). `level`: 1 fast to 9 small. Throws StoreError.
std::string zlib_stream(const std::string& bytes, int level);

}  // namespace dob
