// Rejected calls, and memory that they leave alone.
#pragma once

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "support/filled_image.hpp"
#include "support/rejection.hpp"

namespace thinbench {

/// A call must throw std::invalid_argument with one sentence that holds this part.
inline void expect_rejected(const std::function<void()>& call, const std::string& part) {
  const std::string text = rejection_of(call);
  EXPECT_TRUE(is_one_sentence(text)) << text;
  EXPECT_NE(text.find(part), std::string::npos) << text << ", expected: " << part;
}

/// Memory that no rejected call writes.
class Untouched {
 public:
  ~Untouched() { EXPECT_TRUE(is_filled(image_.view(), 0x5A)); }
  [[nodiscard]] std::uint8_t* data() { return image_.view().data; }

 private:
  ByteImage image_ = filled_image(64, 40, 0x5A);
};

}  // namespace thinbench
