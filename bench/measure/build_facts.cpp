#include "measure/build_facts.hpp"

#include "thinbench/isa.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

Json libraries_json() {
  return {{"xsimd", THINBENCH_XSIMD_VERSION},
          {"tbb", THINBENCH_TBB_VERSION},
          {"opencv", THINBENCH_OPENCV_VERSION},
          {"benchmark", THINBENCH_BENCHMARK_VERSION}};
}

/// Null where nothing caps it.
Json isa_cap_json() {
  const std::optional<Isa> cap = isa_cap();
  return cap ? Json(isa_name(*cap)) : Json();
}

Json available_isas() {
  Json names = Json::array();
  for (const Isa isa : all_isas()) {
    if (isa_available(isa)) names.push_back(isa_name(isa));
  }
  return names;
}

}  // namespace

Json compiler_json() {
  return {{"id", THINBENCH_COMPILER_ID},
          {"version", THINBENCH_COMPILER_VERSION},
          {"flags", THINBENCH_COMPILER_FLAGS},
          {"build_type", THINBENCH_BUILD_TYPE}};
}

Json build_facts() {
  return {{"compiler", compiler_json()},
          {"libraries", libraries_json()},
          {"isa_available", available_isas()},
          {"isa_cap", isa_cap_json()}};
}

}  // namespace thinbench
