// An operation that copies its input, with one variant that does so and one that does not.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

class Copy : public Job {
 public:
  explicit Copy(bool broken) : broken_(broken) {}
  void run(const ConstImageView& input, const ImageView& output) override {
    for (Index y = 0; y < input.height; ++y) {
      std::copy_n(input.row(y), input.width, output.row(y));
    }
    if (broken_) output.row(0)[0] ^= 255;
  }

 private:
  bool broken_;
};

inline JobMaker copy_maker(bool broken) {
  return [broken](Index, Index, int) { return std::make_unique<Copy>(broken); };
}

inline Variant copy_variant(std::string_view technique, bool broken, std::string_view reason = "") {
  return {technique, "for tests", Isa::baseline, false, false, copy_maker(broken), [reason](Index) {
            return std::string(reason);
          }};
}

/// Variants "good", "bad" and "absent", the last not available.
inline std::vector<Operation> copy_operations() {
  return {{"copy",
           "for tests",
           InputKind::binary,
           {copy_variant("good", false), copy_variant("bad", true),
            copy_variant("absent", false, "this machine lacks it")},
           copy_maker(false)}};
}

}  // namespace thinbench
