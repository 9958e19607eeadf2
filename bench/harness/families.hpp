// The families of operations as the harness sees them: images and numbers.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "harness/operation.hpp"
#include "reference.hpp"
#include "techniques/variants.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// A variant of the library without a kernel scope; the description is that of its technique where
/// it is empty.
[[nodiscard]] Variant library_variant(const detail::VariantInfo& variant, JobMaker make_job,
                                      std::string_view description = {});

/// The reference of a rule of the product or of the study. Throws std::logic_error for other names.
[[nodiscard]] reference::Thinning reference_named(std::string_view rule);

/// By the reference of the rule's name; by tables for others and with foreground outside. Throws
/// std::logic_error where there is neither.
int thin_by_reference(const Rule& rule, const reference::Repetition& repetition,
                      const ConstImageView& source, const ImageView& destination);
/// What is not given is the rule's own.
int thin_by_reference(const Rule& rule, const Thinning& thinning, const ConstImageView& source,
                      const ImageView& destination);

/// Every rule with all borders that it can have, and the nets limited to one iteration.
[[nodiscard]] std::vector<Operation> thinning_family();

/// One operation; it must outlive the result.
[[nodiscard]] Operation thinning_operation(const detail::ThinningOperation& operation,
                                           const reference::Repetition& repetition = {});

[[nodiscard]] std::unique_ptr<Job> thinning_job(std::unique_ptr<detail::ThinningState> state);

/// In all directions, with both borders.
[[nodiscard]] std::vector<Operation> midpoint_family();

/// Custom rules, optimised: built-in ones given as tables, Life and a random table. Not timed
/// unless a filter names them.
[[nodiscard]] std::vector<Operation> custom_family();

/// With the default thresholds.
[[nodiscard]] std::vector<Operation> edges_family();

/// The reference of an edge operator with these thresholds; a brightness threshold of -1 omits the
/// second.
[[nodiscard]] JobMaker edges_reference(EdgeOperator op, const EdgeThresholds& thresholds);

/// One operation with these thresholds; it must outlive the result.
[[nodiscard]] Operation edges_operation(const detail::EdgeOperation& operation,
                                        const EdgeThresholds& thresholds);

[[nodiscard]] std::vector<Operation> regions_family();

/// Lists as numbers: how many objects and holes there are, and then every member of each.
[[nodiscard]] std::vector<std::int64_t> numbers_of(const Regions& lists);
/// What number `index` of these is, in words.
[[nodiscard]] std::string name_of_region_number(std::size_t index);

/// One operation, with the default thresholds.
[[nodiscard]] std::vector<Operation> localise_family();

/// Numbers: the label of every pixel, then lists as numbers_of() gives them.
[[nodiscard]] std::vector<Operation> labels_family();

/// Numbers: the squared distance of every pixel.
[[nodiscard]] std::vector<Operation> distance_family();

/// Numbers: nodes and edges with their pixels.
[[nodiscard]] std::vector<Operation> graph_family();

/// An input of width W and height H holds H / W images of W x W pixels, one below the other; rows
/// that are left over become background. Variants take the images one by one or as a batch.
[[nodiscard]] std::vector<Operation> batch_family();

/// Lists of images and labels, by rules of every kind: an input is a grid of images, or of labels.
[[nodiscard]] std::vector<Operation> collections_family();

}  // namespace thinbench
