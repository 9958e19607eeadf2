#include "cli/variant_choice.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "core/startable_threads.hpp"

namespace thinbench {
namespace {

using detail::VariantInfo;

using Variants = std::vector<const VariantInfo*>;

/// What is chosen from, and the name that rejections give it.
struct Choice {
  std::string operation;
  std::span<const VariantInfo> variants;
};

template <class Condition>
Variants variants_where(const Choice& choice, const Condition& condition) {
  Variants found;
  for (const VariantInfo& variant : choice.variants) {
    if (condition(variant)) found.push_back(&variant);
  }
  return found;
}

/// "a, b and c", each once, in the order of the variants.
template <class NameOf>
std::string names_of(const Variants& variants, const NameOf& name_of) {
  std::vector<std::string_view> names;
  for (const VariantInfo* variant : variants) {
    const std::string_view name = name_of(*variant);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return enumeration(names);
}

/// Why `isa` is out of reach; empty where it is not.
std::string unreachable_reason(Isa isa) {
  const std::string name(isa_name(isa));
  const std::string best = "; the highest ISA here is " + std::string(isa_name(best_isa()));
  if (!cpu_supports(isa)) return "this machine lacks " + name + best;
  if (isa_available(isa)) return {};
  return name + " is above the cap " + kIsaCapVariable + "=" + std::string(isa_name(*isa_cap()));
}

void check_isa(Isa isa) {
  const std::string reason = unreachable_reason(isa);
  if (!reason.empty()) throw std::runtime_error(reason);
}

/// The variants of the wanted technique, or all.
Variants of_technique(const Choice& choice, std::optional<Technique> technique) {
  const auto name_of = [](const VariantInfo& one) { return technique_name(one.technique); };
  Variants found = variants_where(choice, [&](const VariantInfo& variant) {
    return variant.technique == technique.value_or(variant.technique);
  });
  if (!found.empty()) return found;
  const Variants all = variants_where(choice, [](const VariantInfo&) { return true; });
  throw UsageError(choice.operation + " is not implemented by " +
                   std::string(technique_name(*technique)) + ", only by " + names_of(all, name_of));
}

/// The variants of the wanted kind, wherever they run. `subject` begins the rejections.
Variants wanted_variants(const std::string& subject, const Variants& candidates,
                         const Options& options) {
  Variants wanted;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(wanted),
               [&](const VariantInfo* one) { return one->isa == options.isa.value_or(one->isa); });
  if (wanted.empty()) {
    const auto name_of = [](const VariantInfo& one) { return isa_name(one.isa); };
    throw UsageError(subject + " is not implemented for " + std::string(isa_name(*options.isa)) +
                     ", only for " + names_of(candidates, name_of));
  }
  std::erase_if(wanted,
                [&](const VariantInfo* one) { return one->threaded != (options.threads > 1); });
  if (!wanted.empty()) return wanted;
  throw UsageError(subject + " runs on one thread only, not on " + std::to_string(options.threads));
}

}  // namespace

void add_technique_options(CLI::App& app, Options& options) {
  const auto add = [&app](const char* option, const auto& set, const char* what) {
    app.add_option_function<std::string>(option, set, what)->check(not_empty())->type_name("NAME");
  };
  add(
      "--technique",
      [&options](const std::string& name) { options.technique = technique_named(name); },
      "How to compute (default: the fastest)");
  add(
      "--isa", [&options](const std::string& name) { options.isa = isa_named(name); },
      "Instruction set (default: the highest)");
}

void add_variant_options(CLI::App& app, Options& options) {
  add_technique_options(app, options);
  add_threads_option(app, options.threads);
}

double milliseconds_of(int threads, const std::function<void()>& work) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(detail::startable_threads(threads)));
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

std::size_t variant_index_for(std::string_view operation, std::span<const VariantInfo> variants,
                              Index width, const Options& options) {
  const Choice choice = {std::string(operation), variants};
  if (options.isa) check_isa(*options.isa);
  const std::string subject(options.technique ? std::string(technique_name(*options.technique))
                                              : choice.operation);
  const Variants wanted =
      wanted_variants(subject, of_technique(choice, options.technique), options);
  const auto fits = [&](const VariantInfo* one) { return unavailable_reason(*one, width).empty(); };
  if (std::any_of(wanted.begin(), wanted.end(), fits)) {
    return choose_variant(operation, variants, width, options);
  }
  const VariantInfo& first = *wanted.front();  // the lowest ISA
  check_isa(first.isa);
  throw std::runtime_error(std::string(technique_name(first.technique)) + " takes images up to " +
                           std::to_string(first.max_width) + " pixels wide; this one has " +
                           std::to_string(width));
}

}  // namespace thinbench
