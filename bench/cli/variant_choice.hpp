// The variant that a user requested, or the reason why there is none.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "api/catalogue.hpp"

namespace thinbench {

/// --technique and --isa.
void add_technique_options(CLI::App& app, Options& options);

/// These and --threads.
void add_variant_options(CLI::App& app, Options& options);

/// The milliseconds that `work` takes with at most so many threads of TBB.
[[nodiscard]] double milliseconds_of(int threads, const std::function<void()>& work);

/// Its index. Throws UsageError where no variant has this technique, ISA and kind of threads,
/// std::runtime_error where none of them runs here or on images of this width.
[[nodiscard]] std::size_t variant_index_for(std::string_view operation,
                                            std::span<const detail::VariantInfo> variants,
                                            Index width, const Options& options);

template <class Operation>
[[nodiscard]] const auto& variant_for(const Operation& operation, Index width,
                                      const Options& options) {
  const std::vector<detail::VariantInfo> infos(operation.variants.begin(),
                                               operation.variants.end());
  return operation.variants[variant_index_for(operation.name, infos, width, options)];
}

}  // namespace thinbench
