#include <algorithm>
#include <utility>
#include <vector>

#include "core/exported.hpp"
#include "harness/library_operation.hpp"
#include "reference.hpp"
#include "scan/built_in.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/many.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {
namespace {

struct CollectionCase {
  std::string name;  // of the rule
  Rule rule;
  Thinning thinning = {};
};

/// Rules of every kind. Those that add pixels, or with foreground outside, are for lists only.
std::vector<CollectionCase> cases() {
  return {{"guo_hall", Rule::guo_hall},
          {"guo_hall:keep", Rule::guo_hall, {.border = Border::keep}},
          {"mb2", Rule::mb2},
          {"golay_l", Rule::named("golay_l")},
          {"guo_hall:foreground", Rule::guo_hall, {.border = Border::foreground}},
          {"erode", Rule::named("erode")},
          {"dilate", Rule::named("dilate")},
          {"life:5", Rule::named("life"), {.max_iterations = 5}}};
}

bool suits_labels(const CollectionCase& one) {
  const auto parameters = detail::thinning_parameters(one.rule, one.thinning);
  return !parameters.complemented && !parameters.rule->adds_pixels();
}

/// The parts of an image of this size: a grid of images of four sizes.
template <class View>
std::vector<View> parts_of(const View& image) {
  constexpr Index grid = 3;
  std::vector<View> parts;
  for (Index i = 0; i < grid * grid; ++i) {
    const auto begin = [](Index size, Index part) { return size * part / grid; };
    const Index x = begin(image.width, i % grid);
    const Index y = begin(image.height, i / grid);
    parts.emplace_back(image.data + y * image.stride + x, begin(image.width, i % grid + 1) - x,
                       begin(image.height, i / grid + 1) - y, image.stride);
  }
  return parts;
}

constexpr std::int32_t kLabels = 3;

/// A label in cells of 16 x 16 pixels, so that labels touch and have several components.
std::int32_t label_at(Index x, Index y) {
  constexpr Index cell = 16;
  return static_cast<std::int32_t>((x / cell + 2 * (y / cell)) % kLabels) + 1;
}

/// Selects the foreground of one label. False if it has none.
bool select(const ConstImageView& source, std::int32_t label, const ImageView& selected) {
  bool any = false;
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      const bool is_selected = source.row(y)[x] != 0 && label_at(x, y) == label;
      selected.row(y)[x] = is_selected ? 255 : 0;
      any = any || is_selected;
    }
  }
  return any;
}

int labels_by_reference(const CollectionCase& one, const Execution&, const ConstImageView& source,
                        const ImageView& destination) {
  ByteImage selected(source.width, source.height);
  int iterations = 0;
  for (Index y = 0; y < source.height; ++y) {
    std::fill_n(destination.row(y), source.width, std::uint8_t{0});
  }
  for (std::int32_t label = 1; label <= kLabels; ++label) {
    if (!select(source, label, selected.view())) continue;
    iterations = std::max(
        iterations, thin_by_reference(one.rule, one.thinning, selected.view(), selected.view()));
    for (Index y = 0; y < source.height; ++y) {
      for (Index x = 0; x < source.width; ++x) {
        if (selected.at(x, y) != 0) destination.row(y)[x] = static_cast<std::uint8_t>(label);
      }
    }
  }
  return iterations;
}

int labels_by_library(const CollectionCase& one, const Execution& execution,
                      const ConstImageView& source, const ImageView& destination) {
  std::vector<std::int32_t> labels;
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      labels.push_back(source.row(y)[x] != 0 ? label_at(x, y) : 0);
    }
  }
  const LabelView view(labels.data(), source.width, source.height);
  const int iterations = thin_labels(one.rule, view, view, one.thinning, execution);
  for (Index y = 0; y < source.height; ++y) {
    std::copy_n(view.row(y), source.width, destination.row(y));
  }
  return iterations;
}

int list_by_reference(const CollectionCase& one, const Execution&, const ConstImageView& source,
                      const ImageView& destination) {
  const auto from = parts_of(source);
  const auto to = parts_of(destination);
  int iterations = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    iterations = std::max(iterations, thin_by_reference(one.rule, one.thinning, from[i], to[i]));
  }
  return iterations;
}

int list_by_library(const CollectionCase& one, const Execution& execution,
                    const ConstImageView& source, const ImageView& destination) {
  return thin_many(one.rule, parts_of(source), parts_of(destination), one.thinning, execution);
}

using Thin = int (*)(const CollectionCase&, const Execution&, const ConstImageView&,
                     const ImageView&);

JobMaker job_of(const CollectionCase& one, Isa isa, Thin thin) {
  return [=](Index, Index, int threads) {
    return counting_job([=](const auto& input, const auto& output) {
      return thin(one, {threads, isa}, input, output);
    });
  };
}

Operation operation_of(const std::string& kind, const CollectionCase& one, Thin by_reference,
                       Thin by_library) {
  Operation operation = {kind + "_" + one.name,
                         "many images or labels, thinned in one call",
                         InputKind::binary,
                         {},
                         job_of(one, Isa::baseline, by_reference)};
  for (const Isa isa : detail::isas_of<detail::BuiltInScans>()) {
    for (const bool threaded : {false, true}) {
      operation.variants.push_back(
          library_variant({"chosen", isa, threaded, detail::kAnyWidth, static_cast<int>(isa)},
                          job_of(one, isa, by_library), "the library's choice"));
    }
  }
  operation.counts_iterations = true;
  operation.small_sets_only = true;
  operation.timed = false;
  return operation;
}

}  // namespace

std::vector<Operation> collections_family() {
  std::vector<Operation> family;
  for (const CollectionCase& one : cases()) {
    family.push_back(operation_of("list", one, &list_by_reference, &list_by_library));
    if (!suits_labels(one)) continue;
    family.push_back(operation_of("labels", one, &labels_by_reference, &labels_by_library));
  }
  return family;
}

}  // namespace thinbench
