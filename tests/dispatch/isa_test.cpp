#include "thinbench/isa.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

/// Sets the cap for one test and restores what was there.
class CapGuard {
 public:
  CapGuard() {
    if (const char* text = std::getenv(kIsaCapVariable)) before_ = text;
  }
  ~CapGuard() { set(before_.c_str()); }
  CapGuard(const CapGuard&) = delete;
  CapGuard& operator=(const CapGuard&) = delete;
  static void set(const char* value) { setenv(kIsaCapVariable, value, 1); }

 private:
  std::string before_;
};

TEST(Isa, names_and_levels_are_one_to_one) {
  for (const Isa isa : kAllIsas) EXPECT_EQ(isa_from_name(isa_name(isa)), isa);
  EXPECT_EQ(isa_from_name("mmx"), std::nullopt);
}

TEST(Isa, cap_hides_every_level_above_it) {
  const CapGuard guard;
  CapGuard::set("sse4.2");
  EXPECT_TRUE(isa_available(Isa::baseline));
  EXPECT_FALSE(isa_available(Isa::avx2));
  EXPECT_FALSE(isa_available(Isa::avx512icl));
  EXPECT_LE(best_isa(), Isa::sse42);
}

TEST(Isa, empty_cap_is_no_cap) {
  const CapGuard guard;
  CapGuard::set("");
  for (const Isa isa : kAllIsas) EXPECT_EQ(isa_available(isa), cpu_supports(isa));
}

TEST(Isa, unknown_cap_is_refused_and_named) {
  const CapGuard guard;
  CapGuard::set("avx3");
  try {
    static_cast<void>(isa_cap());
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("THINBENCH_MAX_ISA=avx3"), std::string::npos);
  }
}

TEST(Isa, each_level_contains_the_one_before) {
  for (std::size_t i = 1; i < kAllIsas.size(); ++i) {
    EXPECT_LE(cpu_supports(kAllIsas[i]), cpu_supports(kAllIsas[i - 1]));
  }
}

}  // namespace
}  // namespace thinbench
