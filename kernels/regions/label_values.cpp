// Components of equal values: a scan with union-find, then a scan that gives final labels. Per
// pixel about 4 comparisons, and 4 bytes written twice.
#include <vector>

#include "core/checks.hpp"
#include "core/union_find.hpp"
#include "core/variant.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

using detail::Label;

/// Provisional labels count from 1 in raster order, so a component's lowest is at its first pixel.
class Labeller {
 public:
  Labeller(const ConstLabelView& values, const LabelView& labels, bool eight,
           std::int32_t background)
      : values_(values), labels_(labels), eight_(eight), background_(background) {}

  std::uint32_t label() {
    for (Index y = 0; y < values_.height; ++y) scan_row(y);
    const std::uint32_t count = number_roots();
    for (Index y = 0; y < values_.height; ++y) {
      std::int32_t* const row = labels_.row(y);
      for (Index x = 0; x < values_.width; ++x) {
        row[x] = static_cast<std::int32_t>(parents_[static_cast<Label>(row[x])]);
      }
    }
    return count;
  }

 private:
  void scan_row(Index y) {
    const std::int32_t* const row = values_.row(y);
    std::int32_t* const to = labels_.row(y);
    for (Index x = 0; x < values_.width; ++x) {
      to[x] = row[x] == background_ ? 0 : static_cast<std::int32_t>(label_at(x, y));
    }
  }

  [[nodiscard]] bool has_value(Index x, Index y, std::int32_t value) const {
    return x >= 0 && x < values_.width && y >= 0 && values_.row(y)[x] == value;
  }
  [[nodiscard]] Label of(Index x, Index y) const { return static_cast<Label>(labels_.row(y)[x]); }

  /// Neighbours that touch each other have been united before.
  Label label_at(Index x, Index y) {
    const std::int32_t value = values_.row(y)[x];
    const bool north = has_value(x, y - 1, value), west = has_value(x - 1, y, value);
    if (north) {
      if (!west || eight_) return of(x, y - 1);
      return detail::unite(parents_.data(), of(x, y - 1), of(x - 1, y));
    }
    const bool north_west = eight_ && !west && has_value(x - 1, y - 1, value);
    const bool north_east = eight_ && has_value(x + 1, y - 1, value);
    if (!west && !north_west) return north_east ? of(x + 1, y - 1) : new_label();
    const Label left = west ? of(x - 1, y) : of(x - 1, y - 1);
    return north_east ? detail::unite(parents_.data(), left, of(x + 1, y - 1)) : left;
  }

  Label new_label() {
    parents_.push_back(static_cast<Label>(parents_.size()));
    return parents_.back();
  }

  /// Replaces parents by final labels, which lower labels have already.
  std::uint32_t number_roots() {
    std::uint32_t count = 0;
    for (Label label = 1; label < parents_.size(); ++label) {
      const Label parent = parents_[label];
      parents_[label] = parent == label ? ++count : parents_[parent];
    }
    return count;
  }

  ConstLabelView values_;
  LabelView labels_;
  bool eight_;
  std::int32_t background_;
  std::vector<Label> parents_ = {0};
};

}  // namespace

std::uint32_t label_values(ConstLabelView values, LabelView labels, Connectivity connectivity,
                           std::int32_t background, const Execution& execution) {
  static_cast<void>(detail::checked_isa(execution));
  detail::require_connectivity(static_cast<int>(connectivity));
  detail::check(detail::memory_of("values", values), detail::memory_of("labels", labels),
                detail::InPlace::rejected);
  detail::require_label_size(values.width, values.height);
  return Labeller(values, labels, connectivity == Connectivity::eight, background).label();
}

}  // namespace thinbench
