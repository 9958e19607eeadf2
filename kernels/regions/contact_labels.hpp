// Objects and holes from runs as bits and their contacts: what label images are painted from.
#pragma once

#include "regions/labels_state.hpp"

namespace thinbench::detail {

/// Of images of one size. The packed image must be the same in find() and paint().
class ContactLabels {
 public:
  ContactLabels() = default;
  virtual ~ContactLabels() = default;
  ContactLabels(const ContactLabels&) = delete;
  ContactLabels& operator=(const ContactLabels&) = delete;

  /// Finds the objects and what else the task asks for.
  virtual void find(const ConstBitPlaneView& image) = 0;
  /// As LabelsState has them.
  [[nodiscard]] virtual RegionLists regions() const = 0;
  [[nodiscard]] virtual Label objects() const = 0;
  virtual void paint(const ConstBitPlaneView& image, const LabelView& labels) const = 0;
};

/// By the kernels of an ISA.
[[nodiscard]] std::unique_ptr<ContactLabels> make_contact_labels(const LabelsParameters& parameters,
                                                                 Isa isa, Index width,
                                                                 Index height);

}  // namespace thinbench::detail
