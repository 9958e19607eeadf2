#include "harness/operation.hpp"

#include <stdexcept>

#include "harness/batch_family.hpp"
#include "harness/edges_family.hpp"
#include "harness/localise_family.hpp"
#include "harness/regions_family.hpp"
#include "harness/thinning_family.hpp"

namespace thinbench {
namespace {

Outcome outcome_by(const JobMaker& make_job, const ConstImageView& input) {
  return outcome_of(*make_job(input.width, input.height, 1), input);
}

}  // namespace

const std::vector<Operation>& all_operations() {
  static const std::vector<Operation> operations = [] {
    std::vector<Operation> all;
    for (const auto& family :
         {thinning_family(), edges_family(), regions_family(), localise_family(), batch_family()}) {
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

}  // namespace thinbench
