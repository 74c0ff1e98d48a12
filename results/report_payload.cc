#include "results/report_payload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "results/store.h"
#include "results/trace_encoding.h"
#include "results/zlib_stream.h"
#include "robot/types.h"

namespace dob {
namespace {

constexpr double kReplayRate = 25.0;       // [Hz]
constexpr double kFastest = 1e6;           // [Hz] that anything is recorded with
constexpr std::size_t kMostBuckets = 500;  // of a plot: two points each, about one for a pixel
constexpr int kPageCompression = 9;

using Names = std::vector<std::string>;

// Steps in which values are kept: what the eye sees of a replay, what a plot is zoomed into. The first that fits the
// signal's name.
struct Resolution {
  std::string_view begin, end;  // of the name
  double replay, plots;
};
constexpr std::array kResolutions{
    Resolution{"trunk/q", "", 2e-4, 2e-4},
    Resolution{"zmp/", "_m", 5e-4, 1e-4},  // places; the other lengths are errors in the plots
    Resolution{"", "_m", 5e-4, 2e-5},      //
    Resolution{"", "_rad", 1e-3, 1e-4},    //
    Resolution{"", "_N", 0.5, 0.1},        //
    Resolution{"", "_Nm", 0.1, 0.02},      //
    Resolution{"", "", 1.0, 1.0},          // what is left is counted
};

double resolution_of(const std::string& name, double Resolution::*use) {
  const auto fits = [&](const Resolution& r) { return name.starts_with(r.begin) && name.ends_with(r.end); };
  return *std::find_if(kResolutions.begin(), kResolutions.end(), fits).*use;
}

void add_axes(Names& names, const std::string& vector, std::string_view unit, std::string_view axes = "xyz") {
  for (const char axis : axes) names.push_back(fmt::format("{}/{}_{}", vector, axis, unit));
}

Names replay_signals() {
  Names names;
  add_axes(names, "trunk", "m");
  for (const char part : {'w', 'x', 'y', 'z'}) names.push_back(fmt::format("trunk/q{}", part));
  for (const std::string_view leg : kLegNames) {
    for (const std::string_view link : kLegLinkNames) names.push_back(fmt::format("{}/{}/angle_rad", leg, link));
  }
  for (const std::string_view leg : kLegNames) {
    names.push_back(fmt::format("{}/stance", leg));
    add_axes(names, fmt::format("{}/foothold", leg), "m");
    add_axes(names, fmt::format("{}/force", leg), "N");
  }
  add_axes(names, "com", "m");
  add_axes(names, "com_reference", "m");
  add_axes(names, "applied/point", "m");
  for (const char* force : {"applied/force", "force_estimate", "com_force_estimate"}) add_axes(names, force, "N");
  for (const char* place : {"zmp/reference", "zmp/cop", "path"}) add_axes(names, place, "m", "xy");
  return names;
}

Names plot_signals() {
  Names names{"com_error_m", "path_error_m", "orientation_error_rad"};
  for (const char* force : {"force_true", "force_estimate", "com_force_true", "com_force_estimate"}) {
    add_axes(names, force, "N");
  }
  add_axes(names, "com_moment_true", "Nm");
  add_axes(names, "com_moment_estimate", "Nm");
  for (const std::string_view leg : kLegNames) {
    for (const std::string_view link : kLegLinkNames) {
      names.push_back(fmt::format("{}/{}/estimate_Nm", leg, link));
      names.push_back(fmt::format("{}/{}/true_disturbance_Nm", leg, link));
    }
    names.push_back(fmt::format("{}/foot_error_m", leg));
    names.push_back(fmt::format("{}/force/z_N", leg));
    names.push_back(fmt::format("{}/force_commanded/z_N", leg));
  }
  add_axes(names, "zmp/reference", "m", "xy");
  add_axes(names, "zmp/cop", "m", "xy");
  names.insert(names.end(), {"zmp/margin_m", "saturated_joints"});
  return names;
}

const std::vector<float>* find(const Trace& trace, const std::string& name) {
  const auto found = std::find(trace.names.begin(), trace.names.end(), name);
  return found == trace.names.end() ? nullptr : &trace.columns[static_cast<std::size_t>(found - trace.names.begin())];
}

// Horizontal distance between the CoM and its path; empty where the trace does not say.
std::vector<float> path_error(const Trace& trace) {
  std::vector<float> error;
  const auto *x = find(trace, "com/x_m"), *y = find(trace, "com/y_m");
  const auto *path_x = find(trace, "path/x_m"), *path_y = find(trace, "path/y_m");
  if (x == nullptr || y == nullptr || path_x == nullptr || path_y == nullptr) return error;
  for (std::size_t i = 0; i < trace.rows(); ++i) {
    error.push_back(std::hypot((*x)[i] - (*path_x)[i], (*y)[i] - (*path_y)[i]));
  }
  return error;
}

// Of the trace, or derived from it; empty where it is not there or applies nowhere.
std::vector<float> column_of(const Trace& trace, const std::string& name) {
  if (name == "path_error_m") return path_error(trace);
  const std::vector<float>* column = find(trace, name);
  const auto applies = [](float x) { return std::isfinite(x); };
  return column != nullptr && std::any_of(column->begin(), column->end(), applies) ? *column : std::vector<float>();
}

// Puts the signals behind `bytes`, each thinned out by `thin`, and returns how to read them.
template <typename Thin>
Json add_signals(const Trace& trace, const Names& names, double Resolution::*use, const Thin& thin,
                 std::string& bytes) {
  Json signals = Json::array();
  for (const std::string& name : names) {
    const std::vector<float> column = column_of(trace, name);
    if (column.empty()) continue;
    const QuantisedColumn quantised = quantise(thin(column), resolution_of(name, use));
    bytes += delta_coded(quantised.numbers);
    signals.push_back({{"name", name}, {"offset", quantised.offset}, {"scale", quantised.scale}});
  }
  return signals;
}

Json add_replay(const Trace& trace, std::string& bytes) {
  const double rate = std::min(kReplayRate, trace.rate_Hz);
  const double step = trace.rate_Hz / rate;
  std::vector<std::size_t> frames;
  for (std::size_t row = 0; row < trace.rows();
       row = static_cast<std::size_t>(std::lround(static_cast<double>(frames.size()) * step))) {
    frames.push_back(row);
  }
  const auto at_frames = [&](const std::vector<float>& column) {
    std::vector<float> samples;
    samples.reserve(frames.size());
    for (const std::size_t row : frames) samples.push_back(column[row]);
    return samples;
  };
  Json signals = add_signals(trace, replay_signals(), &Resolution::replay, at_frames, bytes);
  return {{"rate_Hz", rate}, {"frames", frames.size()}, {"signals", std::move(signals)}};
}

Json add_plots(const Trace& trace, std::string& bytes) {
  const std::size_t samples = (trace.rows() + kMostBuckets - 1) / kMostBuckets;
  const std::size_t buckets = (trace.rows() + samples - 1) / samples;
  const auto extremes = [&](const std::vector<float>& column) { return min_max_decimated(column, samples); };
  Json signals = add_signals(trace, plot_signals(), &Resolution::plots, extremes, bytes);
  return {{"buckets", buckets},
          {"bucket_s", static_cast<double>(samples) / trace.rate_Hz},
          {"points", 2 * buckets},
          {"signals", std::move(signals)}};
}

// When the flag has this value, in whole milliseconds.
Json intervals(const Trace& trace, const std::string& name, bool wanted) {
  Json found = Json::array();
  const std::vector<float>* flag = find(trace, name);
  if (flag == nullptr) return found;
  const auto time = [&](std::size_t row) { return std::round(1e3 * static_cast<double>(row) / trace.rate_Hz) / 1e3; };
  for (std::size_t begin = 0; begin < flag->size();) {
    std::size_t end = begin;
    while (end < flag->size() && ((*flag)[end] != 0.0F) == wanted) ++end;
    if (end > begin) found.push_back({time(begin), time(end)});
    begin = end + 1;  // the row at `end` is not wanted
  }
  return found;
}

}  // namespace

TracePayload encode_trace(const Trace& trace) {
  if (trace.rows() == 0) throw StoreError("holds no samples");
  if (!(trace.rate_Hz > 0.0 && trace.rate_Hz < kFastest)) throw StoreError("has a rate that none is recorded with");
  std::string bytes;
  Json description;
  description["replay"] = add_replay(trace, bytes);
  description["plots"] = add_plots(trace, bytes);
  for (const std::string_view leg : kLegNames) {
    description["swings"][std::string(leg)] = intervals(trace, fmt::format("{}/stance", leg), false);
  }
  description["disturbed"] = intervals(trace, "disturbance_active", true);
  description["end_s"] = static_cast<double>(trace.rows() - 1) / trace.rate_Hz;
  return {std::move(description), base64(zlib_stream(bytes, kPageCompression))};
}

}  // namespace dob
