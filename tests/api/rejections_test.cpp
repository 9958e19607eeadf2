// What functions of images reject: invalid views, options and enumerators. Each gives one sentence
// with the value and what was expected, before a byte is written.
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "rules/trained_cluster.hpp"
#include "support/isa_tests.hpp"
#include "support/made_image.hpp"
#include "support/rejection.hpp"
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
#include "thinbench/nets.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/path.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

/// A call must throw std::invalid_argument with one sentence that holds this part.
void expect_rejected(const std::function<void()>& call, const std::string& part) {
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

constexpr Index kHuge = std::numeric_limits<Index>::max() / 2;

using In = const ConstImageView&;
using Out = const ImageView&;
using How = const Execution&;

/// A function of an image, and of another one to write to.
struct Operation {
  const char* name;
  std::function<void(In, Out, How)> call;
  bool writes = true;
  bool works_in_place = true;
  std::string source = "source", destination = "destination";  // as errors call them
};

constexpr HoleFilling kSmallHoles = {Connectivity::four, 3};

const std::vector<Operation>& operations() {
  static const std::vector<Operation> all = {
      {"thin", [](In in, Out out, How how) { thin(Rule::mb2, in, out, {}, how); }},
      {"thin_many",
       [](In in, Out out, How how) {
         thin_many(Rule::mb2, {&in, 1}, {&out, 1}, {}, how);
       }},
      {"midpoint_scan",
       [](In in, Out out, How how) { midpoint_scan(in, out, {}, Border::background, how); }},
      {"fill_holes", [](In in, Out out, How how) { fill_holes(in, out, {}, how); }},
      {"fill_holes up to an area",
       [](In in, Out out, How how) { fill_holes(in, out, kSmallHoles, how); }},
      {"localise_objects, written",
       [](In in, Out out, How how) { (void)localise_objects(in, {}, how, out); }, true, true,
       "grey", "objects"},
      {"binarise", [](In in, Out out, How how) { (void)binarise(in, out, {}, how); }, true, true,
       "grey"},
      {"detect_edges",
       [](In in, Out out, How how) { detect_edges(EdgeOperator::sobel, in, out, {}, how); }, true,
       false},
      {"localise_objects", [](In in, Out, How how) { (void)localise_objects(in, {}, how); }, false,
       false, "grey"},
      {"find_regions", [](In in, Out, How how) { (void)find_regions(in, how); }, false},
      {"find_objects", [](In in, Out, How how) { (void)find_objects(in, how); }, false},
      {"euler_number", [](In in, Out, How how) { (void)euler_number(in, Connectivity::four, how); },
       false},
      {"skeleton_graph", [](In in, Out, How how) { (void)skeleton_graph(in, how); }, false, false,
       "skeleton"},
      {"prune", [](In in, Out out, How how) { (void)prune(in, out, {}, how); }, true, true,
       "skeleton"},
      {"full_blocks", [](In in, Out, How how) { (void)full_blocks(in, how); }, false, false,
       "image"},
      {"classify_pixels", [](In in, Out out, How how) { classify_pixels(in, out, {}, how); }, false,
       false, "image"},
  };
  return all;
}

TEST(Operations, reject_invalid_sources) {
  Untouched from, to;
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.name);
    for (const auto& [source, part] : std::vector<std::pair<ConstImageView, std::string>>{
             {{nullptr, 20, 10, 64}, " has no data"},
             {{from.data(), -1, 10, 64}, " has the size -1 x 10"},
             {{from.data(), 20, -10, 64}, " has the size 20 x -10"},
             {{from.data(), 20, 10, 19}, " has a stride of 19 bytes, below its width of 20"},
             {{from.data(), 20, 10, kHuge},
              " exceeds the address space: 20 x 10, stride 4611686018427387903"}}) {
      const ConstImageView in = source;
      const ImageView out = {to.data(), in.width, in.height, 64};
      expect_rejected([&] { operation.call(in, out, {}); }, operation.source + part);
    }
  }
}

TEST(Operations, reject_invalid_destinations_and_overlap_but_not_views_side_by_side) {
  Untouched from, to;
  const ConstImageView source = {from.data(), 20, 8, 64};
  for (const Operation& operation : operations()) {
    if (!operation.writes) continue;
    SCOPED_TRACE(operation.name);
    const std::string& to_name = operation.destination;
    const std::string overlap = operation.source + " and " + to_name + " overlap";
    const auto expect_call_rejected = [&](const ImageView& destination, const std::string& part) {
      expect_rejected([&] { operation.call(source, destination, {}); }, part);
    };
    expect_call_rejected({nullptr, 20, 8, 64}, to_name + " has no data");
    expect_call_rejected({to.data(), 20, 8, 19}, to_name + " has a stride of 19 bytes, below its");
    expect_call_rejected({to.data(), 20, 9, 64}, operation.source + " is 20 x 8 and " + to_name +
                                                     " 20 x 9; they must have the same size");
    for (const Index distance : {1, 19, 64 - 19, 64 + 19, 2 * 64}) {
      expect_call_rejected({from.data() + distance, 20, 8, 64}, overlap);
      const ConstImageView shifted = {from.data() + distance, 20, 8, 64};
      expect_rejected([&] { operation.call(shifted, {from.data(), 20, 8, 64}, {}); }, overlap);
    }
    expect_call_rejected({from.data(), 20, 8, 2 * 64}, overlap);  // the same first pixel
    if (!operation.works_in_place) expect_call_rejected({from.data(), 20, 8, 64}, overlap);
    ByteImage both(64, 8);
    const ImageView left = {both.view().data, 20, 8, 64};
    const ImageView right = {both.view().data + 20, 20, 8, 64};
    EXPECT_EQ(rejection_of([&] { operation.call(left, right, {}); }), "");
    EXPECT_EQ(rejection_of([&] { operation.call(right, left, {}); }), "");
    if (!operation.works_in_place) continue;
    EXPECT_EQ(rejection_of([&] { operation.call(left, left, {}); }), "");
  }
}

TEST(Operations, work_in_place_on_one_row_or_one_image_whatever_the_strides_to_the_next) {
  for (const Operation& operation : operations()) {
    if (!operation.writes || !operation.works_in_place) continue;
    ByteImage row = noise_image(20, 1, 60, 1, 3), expected(20, 1);
    std::uint8_t* const data = row.view().data;
    operation.call(row.view(), expected.view(), {});
    const auto call = [&] { operation.call({data, 20, 1, 64}, {data, 20, 1, 20}, {}); };
    EXPECT_EQ(rejection_of(call), "") << operation.name;
    EXPECT_TRUE(equal(row.view(), expected.view())) << operation.name;
  }
  ByteImage image = filled_image(64, 8, 1);
  std::uint8_t* const data = image.view().data;
  const auto rejection = [](const StackView& source, const StackView& destination) {
    return rejection_of([&] { thin_stack(Rule::guo_hall, source, destination); });
  };
  EXPECT_EQ(rejection({data, 1, 20, 8, 64, 512}, {data, 1, 20, 8, 64, 0}), "");
  EXPECT_EQ(rejection({data, 1, 20, 1, 64, 512}, {data, 1, 20, 1, 20, 0}), "");
  EXPECT_EQ(rejection({data, 8, 20, 1, 64, 64}, {data, 8, 20, 1, 20, 64}), "");
  EXPECT_NE(rejection({data, 2, 20, 1, 64, 64}, {data, 2, 20, 1, 64, 128}), "");
}

/// Calls that are valid but for what a test gives them.
struct Valid {
  ByteImage both = filled_image(64, 8, 0x5A);
  ImageView left = {both.view().data, 20, 8, 64}, right = {both.view().data + 20, 20, 8, 64};
  PackedView bits = {both.view().data, 20, 8, 64, BitOrder::msb_first};
  StackView stack = {both.view().data, 1, 20, 8, 64, 512};
  std::vector<std::int32_t> numbers = std::vector<std::int32_t>(160), others = numbers;
  std::vector<double> reals_of = std::vector<double>(160);
  LabelView labels = {numbers.data(), 20, 8}, results = {others.data(), 20, 8};
  View<double> reals = {reals_of.data(), 20, 8};

  /// Of every function that takes an execution.
  std::vector<std::pair<std::string, std::function<void(How)>>> calls() {
    std::vector<std::pair<std::string, std::function<void(How)>>> all = {
        {"thin_packed", [&](How how) { thin_packed(Rule::mb2, bits, bits, {}, how); }},
        {"thin_stack", [&](How how) { thin_stack(Rule::mb2, stack, stack, {}, how); }},
        {"thin_labels", [&](How how) { thin_labels(Rule::mb2, labels, results, {}, how); }},
        {"label_regions", [&](How how) { label_regions(left, results, how); }},
        {"label_values",
         [&](How how) { label_values(labels, results, Connectivity::four, 0, how); }},
        {"fill_holes_of_labels", [&](How how) { fill_holes_of_labels(labels, results, {}, how); }},
        {"squared_distances", [&](How how) { squared_distances(left, results, how); }},
        {"distances", [&](How how) { distances(left, reals, {}, how); }}};
    for (const Operation& one : operations()) {
      all.emplace_back(one.name, [&](How how) { one.call(left, right, how); });
    }
    return all;
  }
};

TEST(Operations, reject_numbers_of_threads_and_instruction_sets_that_there_are_not) {
  Valid valid;
  for (const auto& [name, call] : valid.calls()) {
    SCOPED_TRACE(name);
    for (const int threads : {0, -1, 1025}) {
      expect_rejected([&, &one = call] { one({.threads = threads}); },
                      "threads: expected an integer in [1, 1024], got " + std::to_string(threads));
    }
    for (const int isa : {static_cast<int>(Isa::neon_sha3) + 1, 99, 255}) {
      expect_rejected(
          [&, &one = call] { one({.isa = static_cast<Isa>(isa)}); },
          "isa: expected one of " + all_isa_names() + ", got number " + std::to_string(isa));
    }
  }
  EXPECT_TRUE(is_filled(valid.both.view(), 0x5A));
}

TEST(Operations, take_every_available_instruction_set_and_reject_others) {
  Valid valid;
  for (const auto& [name, call] : valid.calls()) {
    for (int number = 0; number <= static_cast<int>(Isa::neon_sha3); ++number) {
      const auto isa = static_cast<Isa>(number);
      const std::string rejection = rejection_of([&, &one = call] { one({.isa = isa}); });
      const std::string expected = "isa: " + std::string(isa_name(isa)) + " is not available: ";
      EXPECT_EQ(rejection.substr(0, expected.size()), isa_available(isa) ? "" : expected) << name;
    }
  }
}

/// A call, and a part of what it says.
using Rejected = std::pair<std::function<void()>, std::string>;

void expect_all_rejected(const std::vector<Rejected>& rows) {
  for (const auto& [call, part] : rows) expect_rejected(call, part);
}

TEST(PackedImages, are_checked_and_nothing_is_written) {
  Untouched from, to;
  std::uint8_t* const data = from.data();
  constexpr BitOrder order = BitOrder::msb_first;
  const PackedView good = {data, 20, 10, order}, out = {to.data(), 20, 10, order};
  const auto thins = [&](const ConstPackedView& source, const PackedView& destination) {
    return [=] { thin_packed(Rule::guo_hall, source, destination); };
  };
  expect_all_rejected({
      {thins({data, 20, 9, order}, out),
       "source is 20 x 9 and destination 20 x 10; they must have"},
      {thins({data, 20, 10, 2, order}, out),
       "source has a stride of 2 bytes; its rows of 20 pixels"},
      {thins(good, {to.data(), 20, 10, static_cast<BitOrder>(2)}),
       "destination has the bit order 2; expected msb_first or lsb_first"},
      {thins({to.data() + 1, 20, 10, order}, out), "overlap without being the same image"},
  });
}

TEST(Stacks, are_checked_and_nothing_is_written) {
  Untouched from, to;
  std::uint8_t* const data = from.data();
  const std::string overlap = "source and destination overlap without being the same images";
  const StackView four = {to.data(), 4, 5, 5, 5, 25};
  const auto thins = [&](const ConstStackView& source, const StackView& destination) {
    return [=] { thin_stack(Rule::guo_hall, source, destination); };
  };
  expect_all_rejected({
      {thins({data, -1, 5, 5, 5, 25}, four),
       "source is -1 images of 5 x 5; counts and sizes cannot be negative"},
      {thins({data, 4, 5, 5, 5, 24}, four), "an image stride of 24 bytes; its images take 25"},
      {thins({data, kHuge, 5, 5, 5, 25}, four),
       "address space: 4611686018427387903 images of 5 x 5"},
      {thins({data, 3, 5, 5, 5, 25}, four),
       "source is 3 images of 5 x 5 and destination 4 images of 5 x 5; they must have the same"},
      {thins({data + 1, 3, 5, 5, 5, 25}, {data, 3, 5, 5, 5, 25}), overlap},
      {thins({data, 3, 5, 5, 5, 50}, {data + 25, 3, 5, 5, 5, 50}), overlap},  // interleaved
  });
}

/// Of one image they are checked with `operations()`.
TEST(Lists, are_checked_and_nothing_is_written) {
  Untouched from, to;
  constexpr Index side = Index{1} << 21;
  auto* const far = reinterpret_cast<std::uint8_t*>(std::uintptr_t{1} << 60);
  const auto at = [](Untouched& memory, Index x, Index y) {
    return ImageView(memory.data() + y * 64 + x, 9, 9, 64);
  };
  const ConstImageView other = at(from, 0, 0), inner = at(to, 5, 5);
  const ImageView first = at(to, 0, 0);
  const auto thins = [&](std::vector<ConstImageView> sources, std::vector<ImageView> destinations) {
    return [=] { thin_many(Rule::guo_hall, sources, destinations); };
  };
  const std::string both = "the destination of image 1 shares bytes with the destination of image ";
  expect_all_rejected({
      {thins({other, other}, {first}), "got 2 sources and 1 destinations"},
      {thins({other, {from.data(), -1, 5}}, {first, at(to, 20, 20)}),
       "image 1: source has the size -1 x 5"},
      {thins({{from.data(), side, side / 2}}, {{far, side, side / 2}}),
       "is larger than 2^40 pixels"},
      {thins({other, other}, {first, at(to, 8, 8)}), both + "0"},
      {thins({other, other}, {first, first}), both + "0"},
      {thins({other, inner}, {first, at(to, 9, 9)}),
       "image 1: source and destination overlap without being the same image"},
      {thins({other, inner}, {first, at(to, 20, 20)}),
       "the destination of image 0 shares bytes with the source of image 1"},
  });
}

TEST(Labels, are_checked_and_nothing_is_written) {
  constexpr Index smallest = std::numeric_limits<Index>::min();
  Valid valid;
  std::int32_t* const data = valid.numbers.data();
  const LabelView to = valid.results;
  const auto thins = [&](const ConstLabelView& source, const LabelView& destination,
                         const Thinning& thinning = {}) {
    return [=] { thin_labels(Rule::guo_hall, source, destination, thinning); };
  };
  const ConstImageView bytes = {reinterpret_cast<const std::uint8_t*>(to.data), 20, 8};
  const ConstLabelView reals = {reinterpret_cast<const std::int32_t*>(valid.reals_of.data()), 20,
                                8};
  const ConstLabelView nothing = {nullptr, 3, 3}, row = {data + 1, 5, 1};
  const LabelView narrow = {to.data, 19, 8}, row_before = {data, 5, 1};
  valid.numbers[7 * 20 + 19] = -3;
  expect_all_rejected({
      {thins({data, 1 << 16, 1 << 16}, to), "image size 65536 x 65536 is larger than 2^31"},
      {thins({data, 20, 8, PTRDIFF_MAX / 3}, to), "source exceeds the address space: 20 x 8"},
      {thins({data, 0, 1, smallest}, {data, 0, 1, 1}),
       "source has a stride of -9223372036854775808, below"},
      {thins({data, 0, 1, 1}, {data, 0, 1, smallest}),
       "destination has a stride of -9223372036854775808"},
      {thins(row, row_before), "overlap without being the same image"},
      {thins(valid.labels, to, {.max_iterations = 0}), "max_iterations: expected"},
      {thins(valid.labels, to, {.border = Border::foreground}),
       "border: expected background or keep for labels, got foreground"},
      {thins(valid.labels, to), "labels: expected 0 or more, got -3 in row 7, column 19"},
      {[&] { thin_labels(Rule::named("life"), valid.labels, to); },
       "life adds pixels, which would belong to no label; apply it to an image"},
      {[&] { label_regions(valid.left, narrow); }, "source is 20 x 8 and labels 19 x 8; they must"},
      {[&] { label_regions(bytes, to); }, "source and labels overlap"},
      {[&] { label_values(to, to, Connectivity::eight); }, "values and labels overlap"},
      {[&] { fill_holes_of_labels(row, row_before); }, "overlap without being the same image"},
      {[&] { (void)graph_of_labels(nothing); }, "skeletons has no data"},
      {[&] { (void)prune_labels(row, row_before, {}); }, "skeletons and destination overlap"},
      {[&] { distances_of_labels(reals, valid.reals); }, "labels and distances overlap"},
  });
  EXPECT_EQ(valid.others, std::vector<std::int32_t>(160));
}

TEST(Thinning, rejects_options_wherever_they_are_given) {
  Valid valid;
  for (const RuleInfo& info : kRules) {
    const Rule rule = info.rule;
    const auto expect_rejected_by_all = [&](const Thinning& thinning, const std::string& part) {
      expect_all_rejected({
          {[&] { thin(rule, valid.left, valid.left, thinning); }, part},
          {[&] { thin_packed(rule, valid.bits, valid.bits, thinning); }, part},
          {[&] { thin_many(rule, {}, {}, thinning); }, part},
          {[&] { Thinner(rule, 20, 8, thinning); }, part},
          {[&] { thin_stack(rule, valid.stack, valid.stack, thinning); }, part},
          {[&] { StackThinner(rule, 20, 8, thinning); }, part},
      });
    };
    for (const int limit : {0, -1}) {
      expect_rejected_by_all(
          {.max_iterations = limit},
          "max_iterations: expected an integer of at least 1, got " + std::to_string(limit));
    }
    for (const int border : {3, 99, 255}) {
      expect_rejected_by_all(
          {.border = static_cast<Border>(border)},
          "border: expected background, keep or foreground, got " + std::to_string(border));
    }
  }
  const auto inverted = [&] { thin(Rule::mb2, valid.left, valid.left, {Border::foreground}); };
  EXPECT_EQ(rejection_of(inverted).substr(0, 12), "mb2: border:");
  EXPECT_TRUE(is_filled(valid.both.view(), 0x5A));
}

TEST(Rules, are_checked) {
  Valid valid;
  const WindowTable life = table_from_hensel("B3/S23");
  const std::vector<WindowTable> nine(9, WindowTable{});
  TwoLayerWeights no_number = kPaperTwoLayer, too_large = kPaperTwoLayer;
  no_number.hidden[3].weight[5] = std::numeric_limits<float>::quiet_NaN();
  too_large.output.bias = 2e30F;
  const auto cluster = [](int net, int last, int count = detail::kTrainedCluster.count) {
    ClusterWeights weights = detail::kTrainedCluster;
    weights.nets[net].last = last;
    weights.count = count;
    return [=] { (void)Rule::from_net(weights); };
  };
  const int third = detail::kTrainedCluster.nets[2].last;
  expect_all_rejected({
      {[&] { Rule(std::span(nine).first(0)); }, "a rule has 1 to 8 sub-iterations, not 0"},
      {[&] { Rule(std::span(nine)); }, "a rule has 1 to 8 sub-iterations, not 9"},
      {[&] { Rule(life, {.max_iterations = 0}); }, "expected an integer of at least 1, got 0"},
      {[&] { Rule(life, {.border = static_cast<Border>(9)}); }, "border: expected background, "},
      {[&] { thin(Rule(life), valid.left, valid.left); },
       "custom: this rule adds and removes pixels, so it may never end; it needs a limit "
       "(max_iterations)"},
      {[] { (void)Rule(Rule::guo_hall).gates(2); }, "sub-iteration 2 of a rule with 2"},
      {[] { (void)Rule::named("magic"); }, "rule: expected a name, got 'magic'"},
      {[&] { (void)Rule::from_net(no_number, Activation::linear); },
       "weight 5 of hidden neuron 3: expected a number in [-1e30, 1e30], got nan"},
      {[&] { (void)Rule::from_net(too_large, Activation::sigmoid); }, "in [-1e30, 1e30], got"},
      {[] { (void)Rule::from_net(kPaperTwoLayer, static_cast<Activation>(7)); },
       "activation: expected sigmoid or linear, got number 7"},
      {cluster(11, 254), "the nets end at descriptor 254, not 255"},
      {cluster(3, third), "net 3 covers no descriptor"},
      {cluster(0, 67, 0), "the cluster has 0 nets; it must have 1 to 16"},
      {cluster(0, 67, 17), "the cluster has 17 nets; it must have 1 to 16"},
  });
}

TEST(Enumerations, reject_values_outside_them) {
  Valid valid;
  const ImageView image = valid.left;
  const std::string expected = ": expected one of the enumeration, got number ";
  const std::string connectivity = "connectivity: expected 4 or 8, got 6";
  const auto six = static_cast<Connectivity>(6);
  const HoleFilling filling = {six, 1};
  const auto op = static_cast<EdgeOperator>(6);
  for (const int value : {static_cast<int>(kRules.size()), 99, 255}) {
    const auto rule = static_cast<BuiltInRule>(value);
    const std::string part = "rule" + expected + std::to_string(value);
    expect_all_rejected({{[&] { Rule{rule}; }, part},
                         {[&] { (void)rule_info(rule); }, part},
                         {[&] { (void)rule_name(rule); }, part}});
  }
  expect_all_rejected({
      {[&] { (void)edge_operator_info(op); }, "operator" + expected + "6"},
      {[&] { detect_edges(op, image, valid.right); }, "operator" + expected + "6"},
      {[] { (void)border_name(static_cast<Border>(99)); }, "border" + expected + "99"},
      {[] { (void)foreground_name(static_cast<Foreground>(3)); }, "foreground" + expected + "3"},
      {[] { (void)channel_name(static_cast<Channel>(7)); }, "channel" + expected + "7"},
      {[&] { binarise(image, image, {.foreground = static_cast<Foreground>(99)}); },
       "foreground" + expected + "99"},
      {[] { (void)isa_available(static_cast<Isa>(99)); }, "99"},
      {[] { (void)table_from_values(std::vector<std::uint8_t>(512), static_cast<WindowOrder>(3)); },
       "order" + expected + "3"},
      {[&] { label_image(image, valid.results, Connectivity::four, static_cast<LabelOrder>(2)); },
       "order" + expected + "2"},
      {[&] { label_image(image, valid.results, six); }, connectivity},
      {[&] { label_objects(image, valid.results, six); }, connectivity},
      {[&] { label_values(valid.labels, valid.results, six); }, connectivity},
      {[&] { (void)euler_number(image, six); }, connectivity},
      {[&] { fill_holes(image, image, filling); }, connectivity},
      {[&] { fill_holes_of_labels(valid.labels, valid.results, filling); }, connectivity},
      {[&] { midpoint_scan(image, image, Directions{0x10}); },
       "directions: expected bits in [0, 15], got 16"},
      {[&] { midpoint_scan(image, image, {}, Border::foreground); },
       "border: expected background or keep, got foreground"},
      {[&] { midpoint_scan(image, image, {}, static_cast<Border>(7)); },
       "border: expected background or keep, got 7"},
  });
}

TEST(Numbers, have_ranges) {
  Valid valid;
  const ImageView image = valid.left;
  const auto binarises = [&](const Binarisation& request) {
    return [=] { (void)binarise(image, image, request); };
  };
  const HoleFilling negative = {Connectivity::four, -1};
  const std::string area = "max_area: expected at least 0, got -1";
  std::vector<Rejected> rows = {
      {binarises({.threshold = -1}), "threshold: expected an integer in [0, 255], got -1"},
      {binarises({.threshold = 256}), "got 256"},
      {binarises({.threshold = 5, .local = LocalThreshold{}}),
       "a level or a local threshold, not both"},
      {binarises({.local = LocalThreshold{.window = 4}}), "window: expected an odd integer"},
      {binarises({.local = LocalThreshold{.window = 1}}), "in [3, 65535], got 1"},
      {binarises({.local = LocalThreshold{.offset = -1}}),
       "offset: expected an integer in [0, 255]"},
      {[&] { fill_holes(image, image, negative); }, area},
      {[&] { fill_holes_of_labels(valid.labels, valid.results, negative); }, area},
  };
  for (const int level : {-1, 256}) {
    const std::string part =
        "_threshold: expected an integer in [0, 255], got " + std::to_string(level);
    for (const auto& [thresholds, name] : {std::pair(EdgeThresholds{level, 0}, "gradient"),
                                           {EdgeThresholds{0, level}, "brightness"}}) {
      const EdgeThresholds given = thresholds;
      rows.push_back(
          {[=, to = valid.right] { detect_edges(EdgeOperator::sobel, image, to, given); },
           name + part});
      rows.push_back({[=] { (void)localise_objects(image, given); }, name + part});
    }
  }
  const Graph empty;
  for (const Spacing spacing : {Spacing{0, 1}, Spacing{1, -1}, Spacing{1, 1e31}}) {
    const std::string part = "spacing: expected numbers from 1e-30 to 1e30, got ";
    rows.push_back({[=] { (void)links_of(empty, spacing); }, part});
    rows.push_back({[=] { (void)summary(empty, spacing); }, part});
    rows.push_back({[=] { (void)open_cycles(empty, 1, spacing); }, part});
    rows.push_back({[=] { (void)prune(image, image, {.spacing = spacing}); }, part});
    rows.push_back({[=, &valid] { distances(image, valid.reals, spacing); }, part});
  }
  expect_all_rejected(rows);
}

TEST(Colours, share_no_byte_with_their_grey_levels) {
  Untouched memory;
  const auto select = [&](Index width, ImageView grey, Channel channel) {
    const Index stride = 3 * (width % (Index{1} << 60));
    return [=, &memory] { select_channel({memory.data(), width, 2, stride}, grey, channel); };
  };
  const ImageView grey = {memory.data() + 512, 20, 2};
  expect_all_rejected({
      {select(20, {memory.data() + 119, 20, 2}, Channel::red), "colours and destination overlap"},
      {select(20, grey, static_cast<Channel>(7)),
       "channel: expected one of the enumeration, got number 7"},
      {select(Index{1} << 62, grey, Channel::red), "is larger than 2^40 pixels"},
      {select(20, {grey.data, 20, 3}, Channel::red), "expected 20 x 2 pixels, got 20 x 3"},
  });
}

TEST(Sizes, beyond_what_coordinates_can_hold_are_rejected) {
  Untouched memory;
  std::uint8_t* const data = memory.data();
  const Index side = Index{1} << 29;
  std::vector<std::int32_t> numbers(kMaxDistanceSide + 1);
  const std::vector<std::uint8_t> pixels(numbers.size());
  const auto measures = [&](Index width, Index height) {
    return [=, &numbers, &pixels] {
      squared_distances({pixels.data(), width, height}, {numbers.data(), width, height});
    };
  };
  const std::string far = " has a side above 32767 pixels, the limit for distances";
  const ConstImageView wide = {data, side + 1, 0}, high = {data, 0, side + 1};
  const ConstImageView large = {data, 1 << 17, 1 << 17};
  const std::string limit = " has a side above 2^29 pixels";
  std::vector<Rejected> rows = {
      {[&] { (void)find_regions(wide); }, "image size 536870913 x 0" + limit},
      {[&] { (void)localise_objects(high); }, "image size 0 x 536870913" + limit},
      {[&] { (void)skeleton_graph(wide); }, limit},
      {[&] { (void)full_blocks(wide); }, limit},
      {[&] { classify_pixels(wide, {}, {}); }, limit},
      {[&] { (void)find_objects(large); }, "image size 131072 x 131072 is larger than 2^32 pixels"},
      {measures(kMaxDistanceSide + 1, 1), "image size 32768 x 1" + far},
      {measures(1, kMaxDistanceSide + 1), "image size 1 x 32768" + far},
  };
  for (const auto& [width, height, part] : std::vector<std::tuple<Index, Index, std::string>>{
           {-1, 5, "image size -1 x 5 is negative"},
           {5, -1, "image size 5 x -1 is negative"},
           {Index{1} << 40, 2, "image size 1099511627776 x 2 is larger than 2^40 pixels"},
           {2, std::numeric_limits<Index>::max(), "9223372036854775807 is larger than 2^40"}}) {
    rows.push_back({[w = width, h = height] { Thinner(Rule::guo_hall, w, h); }, part});
    rows.push_back({[w = width, h = height] { StackThinner(Rule::guo_hall, w, h); }, part});
  }
  expect_all_rejected(rows);
}

TEST(Plans, reject_images_of_another_size) {
  Untouched memory;
  Thinner thinner(Rule::guo_hall, 20, 8);
  StackThinner stack_thinner(Rule::guo_hall, 20, 8);
  const ImageView image = {memory.data(), 20, 9, 64};
  const StackView stack = {memory.data(), 2, 5, 6}, low = {memory.data(), 1, 20, 7};
  expect_all_rejected({
      {[&] { stack_thinner(low, low); }, "expected images of 20 x 8, got 20 x 7"},
      {[&] { thinner(image, image); }, "expected images of 20 x 8, got 20 x 9"},
      {[&] { stack_thinner(stack, stack); }, "expected images of 20 x 8, got 5 x 6"},
  });
}

/// A graph of a row of three pixels, and what does not belong to it.
TEST(Graphs, are_checked) {
  std::vector<std::uint8_t> row(3, 255);
  const ConstImageView image = {row.data(), 3, 1};
  const Graph graph = skeleton_graph(image);
  Graph without_pixels = graph, outside = graph, above = graph;
  without_pixels.edge_pixels.clear();
  outside.edge_pixels.front().x = -1;
  above.edge_pixels.front().y = -1;
  const std::vector<Pixel> elsewhere = {{0, 7}};
  std::vector<std::int32_t> labels(8, 77);
  const LabelView narrow = {labels.data(), 2, 4}, low = {labels.data(), 8, 0};
  const LabelView as_large = {labels.data(), 8, 1};
  std::vector<double> reals(3, 1);
  std::vector<std::uint8_t> other(3);
  const ImageView classes = {other.data(), 3, 1}, in_place = {row.data(), 3, 1};
  const double infinity = std::numeric_limits<double>::infinity();
  const View<const double> of_image = {reals.data(), 3, 1};
  const auto prunes = [&](const Pruning& pruning) {
    return [=] { (void)prune(image, in_place, pruning); };
  };
  const auto widens = [&](const View<const double>& distances) {
    return [=] { (void)edge_widths(graph, distances); };
  };
  const auto finds_cycles = [](const Link& link) {
    return [=] { (void)cycles(2, std::vector{Link{0, 1, 1}, link}); };
  };
  const std::string length = "expected a finite number of at least 0, got ";
  expect_all_rejected({
      {[&] { (void)subgraph(graph, std::vector<std::uint32_t>{1}); },
       "edges: expected numbers below 1, got 1"},
      {[&] { (void)split_graph(graph, elsewhere); },
       "nodes: expected pixels of the skeleton, got row 7, column 0"},
      {[] { (void)open_cycles({}, -1); }, "max_length: expected a number of at least 0, got -1"},
      {[] { (void)open_cycles({}, std::nan("")); }, "max_length: expected a number"},
      {[] { (void)nearest_place({}, 0, 0); }, "expected a graph with edges, got none"},
      {[&] { (void)nearest_place(graph, 0, infinity); }, "expected a finite point, got 0, inf"},
      {[&] { (void)nearest_place(graph, infinity, 0); }, "expected a finite point"},
      {[&] { edge_labels(graph, narrow); }, "destination: smaller than the image of the graph"},
      {[&] { edge_labels(graph, low); }, "destination: smaller than the image of the graph"},
      {[&] { edge_labels(outside, as_large); }, "destination: smaller than the image of the graph"},
      {[&] { edge_labels(above, as_large); }, "destination: smaller than the image of the graph"},
      {[&] { (void)main_paths(without_pixels); }, "edge 0: expected pixels below 0, got 1 from 0"},
      {finds_cycles({0, 2, 1}), "link 1: expected nodes below 2, got 0 and 2"},
      {finds_cycles({0, 1, -1}), "link 1: length: " + length + "-1"},
      {finds_cycles({0, 1, infinity}), "link 1: length: " + length + "inf"},
      {[] { (void)shortest_path(2, {}, 0, 2); }, "expected nodes below 2, got 0 and 2"},
      {[] { (void)polyline({}, -1); }, "tolerance: " + std::string("expected a finite number")},
      {prunes({.min_length = -1}), "min_length: " + length + "-1"},
      {prunes({.min_length = std::nan("")}), "min_length: " + length},
      {prunes({.min_widths = 1}), "min_widths: expected distances of size 3 x 1"},
      {prunes({.min_widths = 1, .distances = {reals.data(), 3, 1, 2}}),
       "distances has a stride of 2, below its width of 3"},
      {widens({reals.data(), 3, 1, -3}), "distances has a stride of -3, below its"},
      {widens({reals.data(), 2, 1}), "distances"},
      {[&] { (void)edge_widths(outside, of_image); },
       "distances: smaller than the image of the graph"},
      {[&] { classify_pixels(image, in_place, {}); }, "image and classes overlap"},
      {[&] { classify_pixels(image, classes, classes); }, "classes and degrees overlap"},
  });
  for (const GraphPath& path :
       {GraphPath{0, {2}, {}}, GraphPath{0, {0}, {1}}, GraphPath{0, {0}, {0}, {}, 1},
        GraphPath{0, {0}, {0}, 1, {}}, GraphPath{0, {0}, {}, 0, {}}, GraphPath{},
        GraphPath{0, {}, {0}, 0, {}}, GraphPath{0, {}, {0, 0}, 0, 0}, GraphPath{0, {0}, {0}, 0, 0},
        GraphPath{0, {0}, {0, 0}}}) {
    expect_rejected([&] { (void)points_of(graph, path); }, "path: expected one of the graph");
  }
  std::vector<std::uint8_t> longer_row(5, 255);
  const Graph longer = skeleton_graph({longer_row.data(), 5, 1});
  EXPECT_EQ(points_of(longer, GraphPath{0, {}, {0}, 0, 2}).size(), 3U);
  const GraphPath backwards = {0, {}, {0}, 2, 0};
  expect_rejected([&] { (void)points_of(longer, backwards); }, "path: expected one of the graph");
  EXPECT_EQ(labels, std::vector<std::int32_t>(8, 77));
  EXPECT_EQ(row, std::vector<std::uint8_t>(3, 255));
}

TEST(Paths, need_places_with_room) {
  const ByteImage map = image_of({"###", "###", "##."});
  const auto finds = [&](Pixel start, Pixel goal, double width = 0) {
    return [=, &map] { (void)find_path(map.view(), {start, goal, width}); };
  };
  const ConstImageView negative = {map.view().data, -1, 8, 15};
  const std::string width = "width: expected a finite number from 0 up, got ";
  expect_all_rejected({
      {finds({3, 0}, {0, 0}), "start: row 0, column 3 is outside the map of 3 x 3 pixels"},
      {finds({0, 0}, {2, 2}), "goal: row 2, column 2 is inside an obstacle"},
      {finds({1, 2}, {0, 0}, 3),
       "start: at row 2, column 1 there is room for a width of 2, not of 3"},
      {finds({0, 0}, {0, 0}, -1), width + "-1"},
      {finds({0, 0}, {0, 0}, std::numeric_limits<double>::infinity()), width + "inf"},
      {[&] { (void)find_path(negative, {}); }, "free has the size -1 x 8"},
  });
}

}  // namespace
}  // namespace thinbench
