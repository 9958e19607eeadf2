#include "paired/row_names.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace thinbench {
namespace {

[[noreturn]] void reject(const std::string& name) {
  throw std::runtime_error("there is no row '" + name + "'");
}

/// The variant, or nullptr for the reference.
const Variant* variant_of(const Operation& operation, const std::vector<std::string>& fields,
                          const std::string& name) {
  if (fields[1] == "reference") return nullptr;
  const bool threaded = fields[3] != "1";
  for (const Variant& variant : operation.variants) {
    if (variant.technique == fields[1] && variant.isa_label() == fields[2] &&
        variant.threaded == threaded) {
      return &variant;
    }
  }
  reject(name);
}

template <class Thing>
const Thing& named(const std::vector<Thing>& things, const std::string& wanted,
                   const std::string& name) {
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const Thing& thing) { return thing.name == wanted; });
  if (found == things.end()) reject(name);
  return *found;
}

}  // namespace

std::vector<std::string> fields_of(const std::string& name) {
  constexpr std::size_t kFields = 6;
  std::vector<std::string> fields;
  std::istringstream stream(name);
  for (std::string field; std::getline(stream, field, '/');) fields.push_back(field);
  if (fields.size() != kFields) reject(name);
  return fields;
}

TimedRow row_named(const std::string& name, const std::vector<Operation>& operations,
                   const std::vector<TimedInput>& inputs) {
  const std::vector<std::string> fields = fields_of(name);
  const Operation& operation = named(operations, fields[0], name);
  const Scope scope = fields[4] == scope_name(Scope::kernel) ? Scope::kernel : Scope::end_to_end;
  return {name,
          &operation,
          variant_of(operation, fields, name),
          std::stoi(fields[3]),
          scope,
          &named(inputs, fields[5], name),
          {}};
}

}  // namespace thinbench
