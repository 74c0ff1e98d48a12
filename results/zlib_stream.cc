#include "results/zlib_stream.h"

#include <zlib.h>

#include "results/store.h"

namespace dob {

std::string zlib_stream(const std::string& bytes, int level) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                level) != Z_OK) {
    throw StoreError("a trace cannot be compressed");
  }
  out.resize(size);
  return out;
}

}  // namespace dob
