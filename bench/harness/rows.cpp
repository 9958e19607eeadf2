#include "harness/rows.hpp"

#include <regex>
#include <stdexcept>

#include "harness/crosscheck.hpp"

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

std::vector<Row> matching_rows(const std::string& filter, const std::vector<int>& thread_counts) {
  const std::regex pattern = compiled(filter);
  const std::vector<int> one = {1};
  std::vector<Row> rows;
  for (const ThinningOperation& operation : thinning_operations()) {
    for (const ThinningVariant& variant : operation.variants) {
      for (const int threads : variant.threaded ? thread_counts : one) {
        Row row{&operation, &variant, threads, row_name(operation.name, variant, threads)};
        if (std::regex_search(row.name, pattern)) rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

}  // namespace thinbench
