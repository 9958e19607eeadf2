// What a measuring process does.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "harness/operation.hpp"
#include "paired/wire.hpp"

namespace thinbench {

using LineSink = std::function<void(const std::string& line)>;

/// 16 hexadecimal digits that name a result, image and numbers.
[[nodiscard]] std::string hash_of(const Outcome& outcome);

/// Measures all groups of the order, in an order that depends on the seed, and tells `answer` of
/// each when it is done. The first result of every row is compared with the verified one,
/// by its hash. Throws std::runtime_error for another result or an unknown row.
void measure(const Order& order, std::uint64_t seed, const std::vector<Operation>& operations,
             const LineSink& answer);

}  // namespace thinbench
