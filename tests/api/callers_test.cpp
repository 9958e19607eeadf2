// Calls from a thread with little stack, and while the program ends: after main, when static
// variables that were made later are destroyed. A program of its own, as in others some were made
// earlier.
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <pthread.h>
#include <unistd.h>

#include "core/byte_image.hpp"
#include "harness/splitmix64.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

detail::ByteImage test_image() {
  detail::ByteImage image(700, 90);  // in tiles
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      image.at(x, y) = splitmix64(1, static_cast<std::uint64_t>(y / 5 * 1000 + x / 7)) % 3 != 0;
    }
  }
  return image;
}

/// Pixels of every rule, and what all other operations count.
std::uint64_t results_of_every_operation() {
  const detail::ByteImage image = test_image();
  detail::ByteImage result(image.width(), image.height());
  std::uint64_t sum = 0;
  const auto add = [&] {
    for (Index y = 0; y < result.height(); ++y) {
      for (Index x = 0; x < result.width(); ++x) sum = sum * 31 + result.at(x, y);
    }
  };
  for (const RuleInfo& info : kRules) {
    thin(info.rule, image.view(), result.view());
    add();
  }
  const Rule life(table_from_hensel("B3/S23"), {.max_iterations = 3});
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    thin(life, image.view(), result.view(), {}, {.isa = isa});
    add();
  }
  detect_edges(EdgeOperator::sobel, image.view(), result.view(), {}, {});
  add();
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(image.width() * image.height()));
  const LabelView labels = {numbers.data(), image.width(), image.height()};
  squared_distances(image.view(), labels);
  for (const std::int32_t number : numbers) sum = sum * 31 + static_cast<std::uint32_t>(number);
  sum += static_cast<std::uint64_t>(label_image(image.view(), labels, Connectivity::eight));
  sum += find_regions(image.view()).objects.size();
  sum += localise_objects(image.view(), {}, {}).objects.size();
  sum += skeleton_graph(image.view()).edges.size();
  return sum;
}

std::uint64_t expected = 0;

[[noreturn]] void fail(const char* where) {
  std::fprintf(stderr, "other results %s\n", where);
  _exit(1);
}

void call_after_main() {
  if (results_of_every_operation() != expected) fail("after main");
}

void* call_in_thread(void*) {
  if (results_of_every_operation() != expected) fail("in a thread");
  return nullptr;
}

#ifdef THINBENCH_SANITIZED  // sanitizers take more
constexpr std::size_t kStackBytes = std::size_t{8} << 20;
#else
/// What docs/library.md promises.
constexpr std::size_t kStackBytes = std::size_t{128} << 10;
#endif

}  // namespace
}  // namespace thinbench

int main() {
  if (std::atexit(&thinbench::call_after_main) != 0) return 2;
  thinbench::expected = thinbench::results_of_every_operation();
  pthread_attr_t attributes;
  pthread_t thread;
  pthread_attr_init(&attributes);
  if (pthread_attr_setstacksize(&attributes, thinbench::kStackBytes) != 0) return 2;
  if (pthread_create(&thread, &attributes, &thinbench::call_in_thread, nullptr) != 0) return 2;
  pthread_join(thread, nullptr);
}
