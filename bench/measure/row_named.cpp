// Apart from the rest, as the program that callgrind runs links no more than this.
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "measure/timed_row.hpp"

namespace thinbench {
namespace {

template <class Thing, class Is>
const Thing& first_of(std::span<const Thing> things, const Is& is, const std::string& row) {
  const auto found = std::find_if(things.begin(), things.end(), is);
  if (found == things.end()) throw std::runtime_error("there is no row '" + row + "'");
  return *found;
}

std::vector<std::string> fields_of(const std::string& name) {
  constexpr std::size_t kFields = 6;
  std::vector<std::string> fields;
  std::istringstream stream(name);
  for (std::string field; std::getline(stream, field, '/');) fields.push_back(field);
  fields.resize(kFields);
  return fields;
}

}  // namespace

TimedRow row_named(const std::string& name, const std::vector<Operation>& operations,
                   std::span<const TimedInput> inputs) {
  const std::vector<std::string> fields = fields_of(name);
  const auto has_name = [](const std::string& wanted) {
    return [&wanted](const auto& thing) { return thing.name == wanted; };
  };
  const auto is_variant = [&](const Variant& variant) {
    return variant.technique == fields[1] && variant.isa_label() == fields[2] &&
           variant.threaded == (fields[3] != "1");
  };
  const auto& operation = first_of<Operation>(operations, has_name(fields[0]), name);
  const bool is_reference = fields[1] == "reference";
  return {name,
          &operation,
          is_reference ? nullptr : &first_of<Variant>(operation.variants, is_variant, name),
          std::stoi(fields[3]),
          fields[4] == scope_name(Scope::kernel) ? Scope::kernel : Scope::end_to_end,
          &first_of<TimedInput>(inputs, has_name(fields[5]), name)};
}

}  // namespace thinbench
