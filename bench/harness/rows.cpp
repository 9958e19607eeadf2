#include "harness/rows.hpp"

#include <regex>
#include <stdexcept>

namespace thinbench {
namespace {

std::regex compiled(const std::string& filter) {
  try {
    return std::regex(filter, std::regex::ECMAScript | std::regex::optimize);
  } catch (const std::regex_error& error) {
    throw std::invalid_argument("'" + filter + "' is no regular expression: " + error.what());
  }
}

}  // namespace

std::string row_name(std::string_view operation, std::string_view technique, std::string_view isa,
                     int threads) {
  std::string name(operation);
  name.append("/").append(technique).append("/").append(isa).append("/");
  return name + std::to_string(threads);
}

std::vector<Row> matching_rows(const std::string& filter, const std::vector<int>& thread_counts,
                               const std::vector<Operation>& operations) {
  const std::regex pattern = compiled(filter);
  const std::vector<int> one = {1};
  std::vector<Row> rows;
  for (const Operation& operation : operations) {
    for (const Variant& variant : operation.variants) {
      for (const int threads : variant.threaded ? thread_counts : one) {
        Row row{&operation, &variant, threads,
                row_name(operation.name, variant.technique, variant.isa_label(), threads)};
        if (std::regex_search(row.name, pattern)) rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

}  // namespace thinbench
