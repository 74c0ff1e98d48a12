#include "results/claim_keys.h"

#include "results/metric_fields.h"

namespace dob {

std::size_t read_metric(Reader& reader, std::string_view key) {
  const std::string name = reader.text(key);
  std::string names;
  for (std::size_t i = 0; i < kMetricFields.size(); ++i) {
    if (kMetricFields[i].name == name) return i;
    names += (i > 0 ? ", " : "one of ") + std::string(kMetricFields[i].name);
  }
  if (!reader.has(key)) return 0;  // reported when the table has been read
  reader.refuse(key, names);
}

std::string text_or(Reader& reader, std::string_view key, const std::string& fallback) {
  return reader.has(key) ? reader.text(key) : fallback;
}

std::string read_observer(Reader& reader, const std::string& subject) {
  return text_or(reader, "observer", subject);
}

}  // namespace dob
