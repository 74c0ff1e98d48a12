// One cell's time series as the report's page holds them: few enough samples to draw, no peak lost. Private to
// results/.
//
// The page's text for a trace is base64 of a zlib stream of little-endian int16: first the signals of the replay, one
// after the other, `frames` numbers each, then those of the plots, `points` numbers each. Every signal is the first
// number and then differences modulo 2^16; after summing up, value = offset + scale * number, and -32768 says that the
// value does not apply. Replay frames are samples at k / rate_Hz. Plots have two points for each bucket of bucket_s,
// its smallest and its largest value in their order of time, drawn at a quarter and three quarters of the bucket.
// Signals that the trace does not have, or that apply nowhere in it, are left out.
#pragma once

#include <string>

#include "results/store_json.h"
#include "results/trace.h"

namespace dob {

struct TracePayload {
  // {"replay": {"rate_Hz", "frames", "signals": [{"name", "offset", "scale"}]},
  //  "plots": {"buckets", "bucket_s", "points", "signals": [...]},
  //  "swings": {"LF": [[t0, t1], ...], ...}, "disturbed": [[t0, t1], ...], "end_s": t}
  Json description;
  std::string base64;
};

// Throws StoreError for a trace without samples or without a rate.
TracePayload encode_trace(const Trace& trace);

}  // namespace dob
