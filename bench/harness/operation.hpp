// Operations of all families in one form, and rows of them chosen by name: what verify, list and
// the measurements walk.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/job.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

/// One way to compute an operation.
struct Variant {
  std::string_view technique;
  std::string_view description;  // of the technique
  Isa isa;
  bool threaded;          // runs with as many threads as asked for
  bool has_kernel_scope;  // works on a representation of its own
  JobMaker make_job;
  /// Why it cannot run here on an image of this width; empty where it can.
  std::function<std::string(Index width)> unavailable_reason;
  /// The library prefers the variant with the higher one.
  int priority = 0;
  /// Another project's code, or a lower bound such as a copy: timed beside the variants, never
  /// offered by the library.
  bool is_peer = false;
  /// What a peer that does something else is compared with; empty for the operation's own
  /// reference.
  JobMaker own_reference = {};

  /// The ISA in names of results; peers choose theirs at run time.
  [[nodiscard]] std::string_view isa_label() const { return is_peer ? "native" : isa_name(isa); }
};

/// A case: an operation with the options that change what it gives. Every case is verified.
struct Operation {
  /// Unique: the operation's name, with the border where it is kept and the limit of iterations
  /// where there is one, such as "thin_guo_hall:keep" and "net_two_layer_linear:1".
  std::string name;
  std::string_view description;
  InputKind takes;
  std::vector<Variant> variants;
  JobMaker reference;
  /// The first of its numbers is the number of iterations.
  bool counts_iterations = false;
  /// A net whose images are those of the rule that it learned.
  bool is_net = false;
  /// Too slow for the big sets of test images; another operation covers the same code.
  bool small_sets_only = false;
  /// The name without border and limit, where it has them.
  std::string_view operation = {};
  /// Thinning only.
  std::optional<Border> border = std::nullopt;
  std::optional<int> max_iterations = std::nullopt;
  /// Measured on skeletons of the inputs, as that is what it is for; verified on any image.
  bool measured_on_skeletons = false;
  /// False for cases that are verified, but timed, counted and compared only where a filter spells
  /// their name out, see is_requested().
  bool timed = true;
};

/// Whether a case is timed and counted with this filter, a regular expression for names of results:
/// all that are usually timed, and those whose name is written out in the filter, as in
/// "^thin_mb2:keep/".
[[nodiscard]] inline bool is_requested(const Operation& operation, std::string_view filter) {
  return operation.timed || filter.find(operation.name) != std::string_view::npos;
}

/// The operations of the library, family after family.
[[nodiscard]] const std::vector<Operation>& all_operations();

/// Throws std::logic_error for an unknown name.
[[nodiscard]] const Operation& operation_of(std::string_view name);

/// What the reference of the operation of this name makes of an input.
[[nodiscard]] Outcome expected_of(std::string_view operation, const ConstImageView& input);

/// What a variant has to give for this input.
[[nodiscard]] Outcome expected_of(const Operation& operation, const Variant& variant,
                                  const ConstImageView& input);

/// "case/technique/isa/threads", as rows are called everywhere.
[[nodiscard]] std::string row_name(std::string_view operation, std::string_view technique,
                                   std::string_view isa, int threads);

struct Row {
  const Operation* operation;
  const Variant* variant;
  int threads;
  std::string name;  // case/technique/isa/threads

  /// Why the row cannot run on images of this width here; empty where it can.
  [[nodiscard]] std::string unavailable_reason(Index width) const {
    return variant->unavailable_reason(width);
  }
};

/// All rows whose name contains a match of the regular expression (all where it is empty), in the
/// order of `operations`, to which they point; threaded variants once for each of `thread_counts`.
/// Throws std::invalid_argument where the expression is malformed.
[[nodiscard]] std::vector<Row> matching_rows(
    const std::string& filter, const std::vector<int>& thread_counts,
    const std::vector<Operation>& operations = all_operations());

}  // namespace thinbench
