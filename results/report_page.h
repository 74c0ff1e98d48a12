// The page as a file: a template, built from results/report/, with a run's data in it. Private to results/.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "results/store_json.h"

namespace dob {

// <script> of the data, id report-data, and of the trace with this number; each ends in a line end.
std::string data_element(const Json& data);
std::string trace_element(std::size_t number, const std::string& base64);

class PageTemplate {
 public:
  // Has exactly one line that is <!--REPORT-DATA-->. Throws StoreError.
  explicit PageTemplate(const std::filesystem::path& file);

  std::size_t size() const noexcept { return before_.size() + after_.size(); }  // of the page besides its data
  std::string with(const Json& data, const std::vector<std::string>& traces) const;

 private:
  std::string before_, after_;
};

}  // namespace dob
