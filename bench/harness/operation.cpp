#include "harness/operation.hpp"

#include <regex>
#include <stdexcept>

#include "harness/families.hpp"

namespace thinbench {
Outcome outcome_of(Job& job, const ConstImageView& input) {
  Outcome outcome;
  if (job.gives_image()) outcome.image = ByteImage(input.width, input.height);
  job.run(input, outcome.image.view());
  outcome.numbers = job.numbers();
  return outcome;
}

namespace {

Outcome outcome_by(const JobMaker& make_job, const ConstImageView& input) {
  return outcome_of(*make_job(input.width, input.height, 1), input);
}

}  // namespace

const std::vector<Operation>& all_operations() {
  static const std::vector<Operation> operations = [] {
    std::vector<Operation> all;
    for (const auto& family :
         {thinning_family(), midpoint_family(), edges_family(), regions_family(), labels_family(),
          localise_family(), distance_family(), graph_family(), batch_family(), custom_family(),
          collections_family()}) {
      all.insert(all.end(), family.begin(), family.end());
    }
    return all;
  }();
  return operations;
}

const Operation& operation_of(std::string_view name) {
  for (const Operation& operation : all_operations()) {
    if (operation.name == name) return operation;
  }
  throw std::logic_error("no operation is named " + std::string(name));
}

Outcome expected_of(std::string_view operation, const ConstImageView& input) {
  return outcome_by(operation_of(operation).reference, input);
}

Outcome expected_of(const Operation& operation, const Variant& variant,
                    const ConstImageView& input) {
  return outcome_by(variant.own_reference ? variant.own_reference : operation.reference, input);
}

namespace {

std::regex compiled(const std::string& filter) {
  try {
    return std::regex(filter, std::regex::ECMAScript | std::regex::optimize);
  } catch (const std::regex_error& error) {
    throw std::invalid_argument("'" + filter + "' is not a regular expression: " + error.what());
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
