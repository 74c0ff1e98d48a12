// Run directories for the tests of the report, and what is in a page.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results/report.h"
#include "results/store.h"
#include "results/trace.h"
#include "test/results/run_samples.h"
#include "test/results/trace_decoder.h"

namespace dob::test {

// Signals by name, as functions of the time.
struct SignalAt {
  std::string name;
  std::function<double(double)> value;
};

inline Trace trace_of(std::size_t rows, const std::vector<SignalAt>& signals, double rate_Hz = 100.0) {
  Trace trace{rate_Hz, {"t_s"}, {{}}};
  for (std::size_t i = 0; i < rows; ++i) {
    trace.columns[0].push_back(static_cast<float>(static_cast<double>(i) / rate_Hz));
  }
  for (const SignalAt& signal : signals) {
    trace.names.push_back(signal.name);
    trace.columns.emplace_back();
    for (std::size_t i = 0; i < rows; ++i) {
      trace.columns.back().push_back(static_cast<float>(signal.value(static_cast<double>(i) / rate_Hz)));
    }
  }
  return trace;
}

// Walks along x at 0.1 m/s, its path 3 mm to the left and 4 mm ahead, LF in swing from 0.5 s to 0.7 s. `noise` makes it
// hard to compress.
inline Trace walking_trace(std::size_t rows = 300, double noise = 0.0) {
  const auto noisy = [noise](double t) { return noise * std::sin(1e6 * t * t + 1e4 * t); };
  return trace_of(rows, {{"com/x_m", [](double t) { return 0.1 * t; }},
                         {"com/y_m", [](double) { return 0.0; }},
                         {"path/x_m", [](double t) { return 0.1 * t + 0.004; }},
                         {"path/y_m", [](double) { return 0.003; }},
                         {"com_error_m", [noisy](double t) { return 0.01 * std::sin(3.0 * t) + noisy(t); }},
                         {"trunk/x_m", [](double t) { return 0.1 * t; }},
                         {"trunk/qw", [](double) { return 1.0; }},
                         {"LF/hip/angle_rad", [](double t) { return 0.3 * std::sin(t); }},
                         {"LF/foothold/x_m", [](double) { return 0.2; }},
                         {"applied/point/x_m", [](double) { return std::nan(""); }},
                         {"LF/stance", [](double t) { return t < 0.4999 || t > 0.6999 ? 1.0 : 0.0; }},
                         {"disturbance_active", [](double t) { return t > 1.999 ? 1.0 : 0.0; }}});
}

// A run directory whose cells are these, in this order; traces of those that name a file are written by the caller.
inline void make_run(const std::filesystem::path& dir, const std::vector<CellKey>& planned,
                     const std::vector<CellResult>& cells, const std::vector<CellTiming>& timings = {}) {
  RunInfo info;
  info.command_line = "dobbench run";
  info.cells = CellKeys(planned);
  RunStore store = RunStore::create(dir, info, {});
  for (const CellResult& cell : cells) store.append(cell);
  for (const CellTiming& timing : timings) store.append(timing);
  std::filesystem::create_directories(dir / "traces");
}

inline CellResult with_trace(CellResult cell, const std::string& name) {
  cell.trace = "traces/" + name + ".dobtrace";
  return cell;
}

// A page as a browser sees it: its data and its traces.
struct Page {
  std::string html;
  nlohmann::ordered_json data;

  // The text of the script element with this id; nullopt when there is none, or not exactly one.
  std::optional<std::string> script(const std::string& id) const {
    const std::string begin = fmt::format(" id=\"{}\">", id);
    const std::size_t at = html.find(begin);
    if (at == std::string::npos || html.find(begin, at + 1) != std::string::npos) return std::nullopt;
    const std::size_t first = at + begin.size();
    return html.substr(first, html.find("</script", first) - first);
  }

  PageTrace trace(std::size_t i) const { return {data.at("traces").at(i), script(fmt::format("trace-{}", i)).value()}; }

  std::string missing() const { return data.at("missing").dump(); }
};

inline Page read_page(const std::filesystem::path& file) {
  Page page{read_text(file), {}};
  page.data = nlohmann::ordered_json::parse(page.script("report-data").value());
  return page;
}

// A run directory, the smallest template, and the page that is made of them.
class ReportFixture : public ::testing::Test {
 protected:
  TemporaryDirectory temporary;
  std::filesystem::path dir = temporary.path() / "run";
  std::filesystem::path file = temporary.path() / "page.html";
  ReportOptions options{.version = "1.2.3", .commit = "abc", .page_template = temporary.path() / "template.html"};

  void SetUp() override {
    append_text(options.page_template, "<!doctype html>\n<!--REPORT-DATA-->\n<p>behind the data\n");
  }

  Page page() {
    summary = write_report(dir, file, options);
    return read_page(file);
  }

  ReportSummary summary;
};

}  // namespace dob::test
