// Calls from a thread with little stack, after a call that failed for want of memory, and while the
// program ends: after main, when static variables that were made later are destroyed. A program of
// its own, as in others some were made, and threads started, earlier.
#include <atomic>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <pthread.h>
#include <unistd.h>
#if __has_include(<sys/wait.h>)
#include <sys/wait.h>
#endif

#include "core/byte_image.hpp"
#include "harness/splitmix64.hpp"
#include "thinbench.h"
#include "thinbench/binarise.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/graph_labels.hpp"
#include "thinbench/graph_parts.hpp"
#include "thinbench/graph_paths.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/many.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/nets.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/path.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace {
std::atomic<long> available = LONG_MAX;  // allocations until the one that fails
std::atomic<bool> has_failed = false;

[[noreturn]] void fail_slowly() {
  has_failed = true;
  usleep(20'000);  // for others to begin a call
  throw std::bad_alloc();
}
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  if (available-- == 0) fail_slowly();
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace thinbench {
namespace {

detail::ByteImage test_image(Index width, Index height) {
  detail::ByteImage image(width, height);
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      image.at(x, y) = splitmix64(1, static_cast<std::uint64_t>(y / 5 * 1000 + x / 7)) % 3 != 0;
    }
  }
  return image;
}

/// Of the numbers of all results, in their order.
class Sum {
 public:
  template <class T>
  void add(T number) {
    sum_ = sum_ * 31 + static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
  }
  template <class T>
  void add(const View<T>& image) {
    for (Index y = 0; y < image.height; ++y) {
      for (Index x = 0; x < image.width; ++x) add(image.row(y)[x]);
    }
  }
  [[nodiscard]] std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0;
};

/// An image, and what calls write.
struct Places {
  detail::ByteImage image = test_image(700, 90);  // in tiles
  detail::ByteImage result{700, 90};
  std::vector<std::int32_t> numbers = std::vector<std::int32_t>(700 * 90);
  std::vector<std::int32_t> more_numbers = numbers;
  std::vector<double> real_numbers = std::vector<double>(700 * 90);
  LabelView labels = {numbers.data(), 700, 90};
  LabelView other_labels = {more_numbers.data(), 700, 90};
  View<double> reals = {real_numbers.data(), 700, 90};
};

void add_thinning(Places& places, Sum& sum) {
  const ConstImageView image = places.image.view();
  const ImageView result = places.result.view();
  for (const RuleInfo& info : kRules) {
    thin(info.rule, image, result);
    sum.add(result);
  }
  const Rule life(table_from_hensel("B3/S23"), {.max_iterations = 3});
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    thin(life, image, result, {}, {.isa = isa});
    sum.add(result);
  }
  for (const NamedRule& named : named_rules()) {
    sum.add(thin(Rule(named.sub_iterations, {.max_iterations = 2}), image, result));
    sum.add(result);
  }
  const ConstStackView stack(image.data, 3, 700, 30, image.stride, 30 * image.stride);
  const StackView thinned(result.data, 3, 700, 30, result.stride, 30 * result.stride);
  thin_stack(Rule::mb2, stack, thinned);
  sum.add(result);
  thin_many(Rule::lu_wang, {&image, 1}, {&result, 1});
  sum.add(result);
  const TwoLayerWeights weights = {};
  sum.add(thin(Rule::from_net(weights, Activation::sigmoid), image, result));
  std::vector<std::uint8_t> bits(90 * packed_row_bytes(700), 0x5a);
  const PackedView packed(bits.data(), 700, 90, BitOrder::msb_first);
  sum.add(thin_packed(Rule::guo_hall, packed, packed));
  for (const std::uint8_t byte : bits) sum.add(byte);
}

void add_pixel_operations(Places& places, Sum& sum) {
  const ConstImageView image = places.image.view();
  const ImageView result = places.result.view();
  detect_edges(EdgeOperator::sobel, image, result, {}, {});
  sum.add(result);
  midpoint_scan(image, result);
  sum.add(result);
  fill_holes(image, result);
  sum.add(result);
  sum.add(binarise(result, result).threshold);
  sum.add(result);
  sum.add(binarise(image, result, {.local = LocalThreshold{}}).foreground_share * 1e9);
  sum.add(result);
  const ConstColourView colours = {image.data, 200, 90, image.stride};
  const ImageView channel(result.data, 200, 90, result.stride);
  sum.add(select_channel(colours, channel, Channel::automatic));
  sum.add(channel);
  std::vector<std::uint16_t> levels(700 * 90, 7);
  levels[5] = 65535;
  sum.add(binarise16({levels.data(), 700, 90}, result).threshold);
  sum.add(result);
  std::vector<std::uint16_t> darkest(200 * 90);
  const View<std::uint16_t> channel16(darkest.data(), 200, 90);
  sum.add(select_channel16({levels.data(), 200, 90, 700, 3}, channel16, Channel::automatic));
  sum.add(channel16);
}

void add_regions(Places& places, Sum& sum) {
  const ConstImageView image = places.image.view();
  sum.add(find_regions(image).objects.size());
  sum.add(find_objects(image).size());
  sum.add(label_regions(image, places.labels).holes.size());
  sum.add(label_objects(image, places.labels).size());
  sum.add(label_image(image, places.labels, Connectivity::eight));
  sum.add(places.labels);
  sum.add(label_values(places.labels, places.other_labels));
  sum.add(places.other_labels);
  fill_holes_of_labels(places.labels, places.other_labels);
  sum.add(places.other_labels);
  sum.add(thin_labels(Rule::guo_hall, places.labels, places.other_labels));
  sum.add(places.other_labels);
  sum.add(euler_number(image));
  sum.add(localise_objects(image, {}, {}).objects.size());
}

void add_parts(const Graph& graph, Places& places, Sum& sum) {
  sum.add(subgraph(graph, std::vector<std::uint32_t>{0, 1}).nodes.size());
  sum.add(open_cycles(graph).edges.size());
  const GraphEdge& edge = graph.edges.front();
  sum.add(split_graph(graph, points_of(graph, edge)).nodes.size());
  sum.add(nearest_place(graph, 350, 45).edge);
  edge_labels(graph, places.labels);
  sum.add(places.labels);
  for (const EdgeSummary& line : summary(graph)) sum.add(line.length * 1e6);
}

void add_graphs(Places& places, Sum& sum) {
  const ConstImageView image = places.image.view();
  const ImageView result = places.result.view();
  squared_distances(image, places.labels);
  sum.add(places.labels);
  distances(image, places.reals, {.x = 0.5, .y = 2});
  sum.add(places.reals);
  distances(image, places.reals);
  classify_pixels(image, result, {});
  sum.add(result);
  sum.add(full_blocks(image).count);
  thin(Rule::guo_hall, image, result);
  const Graph graph = prune(result, result, {.min_widths = 1, .distances = places.reals});
  sum.add(result);
  sum.add(skeleton_graph(image).edges.size());
  for (const EdgeWidths& widths : edge_widths(graph, places.reals)) sum.add(widths.mean * 1e6);
  for (const GraphEdge& edge : graph.edges) sum.add(polyline(points_of(graph, edge), 1).size());
  for (const GraphPath& path : main_paths(graph)) sum.add(path.nodes.size());
  const auto nodes = static_cast<std::uint32_t>(graph.nodes.size());
  const std::vector<Link> links = links_of(graph);
  sum.add(cycles(nodes, links).size());
  sum.add(components_of(nodes, links).back());
  if (const auto path = shortest_path(nodes, links, 0, 1)) sum.add(path->nodes.size());
  add_parts(graph, places, sum);
  Pixel start = {0, 0};
  while (image.row(0)[start.x] == 0) ++start.x;
  sum.add(find_path(image, {.start = start, .goal = start})->pixels.size());
}

void add_graphs_of_labels(Places& places, Sum& sum) {
  label_image(places.image.view(), places.labels);
  thin_labels(Rule::guo_hall, places.labels, places.other_labels);
  sum.add(graph_of_labels(places.other_labels).graph.edges.size());
  distances_of_labels(places.labels, places.reals);
  sum.add(places.reals);
  const Pruning pruning = {.min_widths = 1, .distances = places.reals};
  prune_labels(places.other_labels, places.other_labels, pruning);
  sum.add(places.other_labels);
}

std::uint64_t results_of_every_operation() {
  Places places;
  Sum sum;
  add_thinning(places, sum);
  add_pixel_operations(places, sum);
  add_regions(places, sum);
  add_graphs(places, sum);
  add_graphs_of_labels(places, sum);
  return sum.value();
}

std::string message_of_a_failure() {
  std::uint64_t table[8];
  thinbench_table_from_hensel("B3/S23 and more than a short message", table);
  return thinbench_last_error();
}

std::uint64_t expected = 0;
std::string failure;

[[noreturn]] void fail(const char* where) {
  std::fprintf(stderr, "other results %s\n", where);
  _exit(1);
}

#if __has_include(<sys/wait.h>)
/// Whether two threads can be used while and after an allocation of the first call with two fails.
/// In a process of its own.
bool works_after_failure_at(long allocation) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);  // ends a call that waits for ever
    const detail::ByteImage image = test_image(1100, 1000);
    const auto works = [&] { return !find_regions(image.view(), {.threads = 2}).objects.empty(); };
    std::thread first([&] {
      try {
        available = allocation;
        static_cast<void>(works());
      } catch (const std::bad_alloc&) {
      }
      available = LONG_MAX;
      has_failed = true;  // or has not, with so many allocations
    });
    while (!has_failed) std::this_thread::yield();
    const bool works_meanwhile = works();
    first.join();
    _exit(works_meanwhile && works() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0;
}
#endif

void call_after_main() {
  if (results_of_every_operation() != expected) fail("after main");
  if (message_of_a_failure() != failure) fail("in a message after main");
}

/// First of all, as rules that are made once are kept.
void* call_in_thread(void*) {
  expected = results_of_every_operation();
  failure = message_of_a_failure();
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
#if __has_include(<sys/wait.h>)
  for (long i = 0; i < 80; ++i) {
    if (!thinbench::works_after_failure_at(i)) thinbench::fail("after a failed allocation");
  }
#endif
  if (std::atexit(&thinbench::call_after_main) != 0) return 2;
  pthread_attr_t attributes;
  pthread_t thread{};
  pthread_attr_init(&attributes);
  if (pthread_attr_setstacksize(&attributes, thinbench::kStackBytes) != 0) return 2;
  if (pthread_create(&thread, &attributes, &thinbench::call_in_thread, nullptr) != 0) return 2;
  pthread_join(thread, nullptr);
  if (thinbench::results_of_every_operation() != thinbench::expected) thinbench::fail("in main");
}
