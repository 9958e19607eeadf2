#include "reference.hpp"

#include <array>

namespace thinbench::reference {
namespace {

struct NamedThinning {
  std::string_view operation;
  Thinning function;
};

constexpr std::array kThinnings = {
    NamedThinning{"thin_naccache_shinghal", &thin_naccache_shinghal},
};

}  // namespace

Thinning find_thinning(std::string_view operation) {
  for (const NamedThinning& named : kThinnings) {
    if (named.operation == operation) return named.function;
  }
  return nullptr;
}

}  // namespace thinbench::reference
