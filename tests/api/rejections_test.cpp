// What functions of images reject: invalid views, options and enumerators. Each gives one sentence
// with the value and what was expected, before a byte is written.
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/isa_parameters.hpp"
#include "support/rejection.hpp"
#include "support/untouched.hpp"
#include "thinbench/binarise.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/graph_parts.hpp"
#include "thinbench/graph_paths.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/many.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/rule_notation.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr Index kHuge = std::numeric_limits<Index>::max() / 2;

using Source = const ConstImageView&;
using Destination = const ImageView&;
using How = const Execution&;

/// A function of an image, and of another one to write to.
struct Operation {
  const char* name;
  std::function<void(Source, Destination, How)> call;
  bool writes = true;
  bool works_in_place = true;
};

const std::vector<Operation>& operations() {
  static const std::vector<Operation> all = {
      {"thin",
       [](Source from, Destination to, How how) { thin(Rule::guo_hall, from, to, {}, how); }},
      {"midpoint_scan", [](Source from, Destination to,
                           How how) { midpoint_scan(from, to, {}, Border::background, how); }},
      {"fill_holes", [](Source from, Destination to, How how) { fill_holes(from, to, {}, how); }},
      {"fill_holes up to an area",
       [](Source from, Destination to, How how) {
         fill_holes(from, to, {Connectivity::four, 3}, how);
       }},
      {"localise_objects, written",
       [](Source from, Destination to, How how) { (void)localise_objects(from, {}, how, to); }},
      {"detect_edges",
       [](Source from, Destination to, How how) {
         detect_edges(EdgeOperator::sobel, from, to, {}, how);
       },
       true, false},
      {"localise_objects",
       [](Source from, Destination, How how) { (void)localise_objects(from, {}, how); }, false},
      {"find_regions", [](Source from, Destination, How how) { (void)find_regions(from, how); },
       false},
      {"find_objects", [](Source from, Destination, How how) { (void)find_objects(from, how); },
       false},
      {"euler_number",
       [](Source from, Destination, How how) { (void)euler_number(from, Connectivity::four, how); },
       false},
      {"skeleton_graph", [](Source from, Destination, How how) { (void)skeleton_graph(from, how); },
       false},
      {"full_blocks", [](Source from, Destination, How how) { (void)full_blocks(from, how); },
       false},
      {"classify_pixels",
       [](Source from, Destination to, How how) { classify_pixels(from, to, {}, how); }, false},
      {"binarise", [](Source from, Destination to, How how) { (void)binarise(from, to, {}, how); }},
  };
  return all;
}

TEST(Operations, reject_invalid_sources) {
  Untouched from, to;
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.name);
    for (const auto& [source, part] : std::vector<std::pair<ConstImageView, std::string>>{
             {{nullptr, 20, 10, 64}, "source has no data"},
             {{from.data(), -1, 10, 64}, "source has the size -1 x 10"},
             {{from.data(), 20, -10, 64}, "source has the size 20 x -10"},
             {{from.data(), 20, 10, 19}, "source has a stride of 19 bytes, below its width of 20"},
             {{from.data(), 20, 10, kHuge},
              "source exceeds the address space: 20 x 10, stride 4611686018427387903"}}) {
      expect_rejected(
          [&, in = source] {
            operation.call(in, {to.data(), in.width, in.height, 64}, {});
          },
          part);
    }
  }
}

TEST(Operations, reject_invalid_destinations_and_overlap_but_not_views_side_by_side) {
  Untouched from, to;
  const std::string overlap = "source and destination overlap";
  const ConstImageView source = {from.data(), 20, 8, 64};
  for (const Operation& operation : operations()) {
    if (!operation.writes) continue;
    SCOPED_TRACE(operation.name);
    const auto expect_call_rejected = [&](const ImageView& destination, const std::string& part) {
      expect_rejected([&] { operation.call(source, destination, {}); }, part);
    };
    expect_call_rejected({nullptr, 20, 8, 64}, "destination has no data");
    expect_call_rejected({to.data(), 20, 8, 19}, "destination has a stride of 19 bytes, below its");
    expect_call_rejected({to.data(), 20, 9, 64},
                         "source is 20 x 8 and destination 20 x 9; they must have the same size");
    for (const Index distance : {1, 19, 64 - 19, 64 + 19, 2 * 64}) {
      expect_call_rejected({from.data() + distance, 20, 8, 64}, overlap);
      expect_rejected(
          [&] {
            operation.call({from.data() + distance, 20, 8, 64}, {from.data(), 20, 8, 64}, {});
          },
          overlap);
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

TEST(Operations, reject_numbers_of_threads_and_instruction_sets_that_there_are_not) {
  Untouched from, to;
  const ConstImageView source = {from.data(), 20, 8, 64};
  const ImageView destination = {to.data(), 20, 8, 64};
  for (const Operation& operation : operations()) {
    SCOPED_TRACE(operation.name);
    const auto expect_call_rejected = [&](const Execution& execution, const std::string& part) {
      expect_rejected([&] { operation.call(source, destination, execution); }, part);
    };
    for (const int threads : {0, -1, 1025}) {
      expect_call_rejected({.threads = threads}, "threads: expected an integer in [1, 1024], got " +
                                                     std::to_string(threads));
    }
    for (const int isa : {static_cast<int>(Isa::neon_sha3) + 1, 99, 255}) {
      expect_call_rejected(
          {.isa = static_cast<Isa>(isa)},
          "isa: expected one of " + all_isa_names() + ", got number " + std::to_string(isa));
    }
  }
}

TEST(Operations, take_every_available_instruction_set_and_reject_others) {
  ByteImage both(64, 8);
  const ImageView source = {both.view().data, 20, 8, 64};
  const ImageView destination = {both.view().data + 20, 20, 8, 64};
  for (const Operation& operation : operations()) {
    for (int number = 0; number <= static_cast<int>(Isa::neon_sha3); ++number) {
      const auto isa = static_cast<Isa>(number);
      const std::string rejection =
          rejection_of([&] { operation.call(source, destination, {.isa = isa}); });
      const std::string expected = "isa: " + std::string(isa_name(isa)) + " is not available: ";
      EXPECT_EQ(rejection.substr(0, expected.size()), isa_available(isa) ? "" : expected)
          << operation.name;
    }
  }
}

TEST(Thinning, rejects_options_wherever_they_are_given) {
  Untouched memory;
  const ImageView image = {memory.data(), 20, 8, 64};
  const StackView stack = {memory.data(), 1, 20, 8, 64, 512};
  const PackedView bits = {memory.data(), 20, 8, 64, BitOrder::msb_first};
  for (const RuleInfo& info : kRules) {
    const Rule rule = info.rule;
    const auto expect_all_rejected = [&](const Thinning& thinning, const std::string& part) {
      expect_rejected([&] { thin(rule, image, image, thinning); }, part);
      expect_rejected([&] { thin_packed(rule, bits, bits, thinning); }, part);
      expect_rejected([&] { Thinner(rule, 20, 8, thinning); }, part);
      expect_rejected([&] { thin_stack(rule, stack, stack, thinning); }, part);
      expect_rejected([&] { StackThinner(rule, 20, 8, thinning); }, part);
    };
    for (const int limit : {0, -1}) {
      expect_all_rejected(
          {.max_iterations = limit},
          "max_iterations: expected an integer of at least 1, got " + std::to_string(limit));
    }
    for (const int border : {3, 99, 255}) {
      expect_all_rejected(
          {.border = static_cast<Border>(border)},
          "border: expected background, keep or foreground, got " + std::to_string(border));
    }
  }
}

TEST(Enumerations, reject_values_outside_them) {
  const std::string expected = ": expected one of the enumeration, got number ";
  for (const int value : {static_cast<int>(kRules.size()), 99, 255}) {
    const auto rule = static_cast<BuiltInRule>(value);
    const std::string part = "rule" + expected + std::to_string(value);
    expect_rejected([&] { Rule{rule}; }, part);
    expect_rejected([&] { (void)rule_info(rule); }, part);
    expect_rejected([&] { (void)rule_name(rule); }, part);
  }
  Untouched memory;
  const ImageView image = {memory.data(), 20, 8, 64};
  const auto op = static_cast<EdgeOperator>(6);
  expect_rejected([&] { (void)edge_operator_info(op); }, "operator" + expected + "6");
  expect_rejected(
      [&] {
        detect_edges(op, image, {image.row(9), 20, 8, 64});
      },
      "operator" + expected + "6");
  expect_rejected([] { (void)border_name(static_cast<Border>(99)); }, "border" + expected + "99");
  expect_rejected([] { (void)foreground_name(static_cast<Foreground>(3)); },
                  "foreground" + expected + "3");
  expect_rejected([] { (void)channel_name(static_cast<Channel>(7)); }, "channel" + expected + "7");
  expect_rejected([&] { binarise(image, image, {.foreground = static_cast<Foreground>(99)}); },
                  "foreground" + expected + "99");
  expect_rejected([] { (void)isa_available(static_cast<Isa>(99)); }, "99");
  expect_rejected(
      [] { (void)table_from_values(std::vector<std::uint8_t>(512), static_cast<WindowOrder>(3)); },
      "order" + expected + "3");
  std::vector<std::int32_t> labels(160);
  expect_rejected(
      [&] {
        label_image(image, {labels.data(), 20, 8}, Connectivity::four, static_cast<LabelOrder>(2));
      },
      "order" + expected + "2");
  expect_rejected([&] { (void)euler_number(image, static_cast<Connectivity>(6)); },
                  "connectivity: expected 4 or 8, got 6");
  expect_rejected([&] { midpoint_scan(image, image, Directions{0x10}); },
                  "directions: expected bits in [0, 15], got 16");
  for (const auto& [border, name] :
       {std::pair{Border::foreground, "foreground"}, {static_cast<Border>(7), "7"}}) {
    expect_rejected([&, given = border] { midpoint_scan(image, image, {}, given); },
                    std::string("border: expected background or keep, got ") + name);
  }
  expect_rejected(
      [&] {
        fill_holes(image, image, {static_cast<Connectivity>(6), 1});
      },
      "connectivity: expected 4 or 8, got 6");
  expect_rejected(
      [&] {
        fill_holes(image, image, {Connectivity::four, -1});
      },
      "max_area: expected at least 0, got -1");
}

TEST(Colours, share_no_byte_with_their_grey_levels) {
  Untouched memory;
  const auto select = [&](Index width, ImageView grey, Channel channel) {
    const Index stride = 3 * (width % (Index{1} << 60));
    return [=, &memory] { select_channel({memory.data(), width, 2, stride}, grey, channel); };
  };
  const ImageView grey = {memory.data() + 512, 20, 2};
  expect_rejected(select(20, {memory.data() + 119, 20, 2}, Channel::red),
                  "colours and destination overlap");
  expect_rejected(select(20, grey, static_cast<Channel>(7)),
                  "channel: expected one of the enumeration, got number 7");
  expect_rejected(select(Index{1} << 62, grey, Channel::red), "is larger than 2^40 pixels");
  expect_rejected(select(20, {grey.data, 20, 3}, Channel::red),
                  "expected 20 x 2 pixels, got 20 x 3");
}

TEST(Binarisation, has_ranges) {
  Untouched memory;
  const ImageView image = {memory.data(), 20, 8, 64};
  for (const auto& [wrong, part] : std::vector<std::pair<Binarisation, std::string>>{
           {{.threshold = -1}, "threshold: expected an integer in [0, 255], got -1"},
           {{.threshold = 256}, "got 256"},
           {{.threshold = 5, .local = LocalThreshold{}}, "a level or a local threshold, not both"},
           {{.local = LocalThreshold{.window = 4}}, "window: expected an odd integer"},
           {{.local = LocalThreshold{.window = 1}}, "in [3, 65535], got 1"},
           {{.local = LocalThreshold{.offset = -1}}, "offset: expected an integer in [0, 255]"}}) {
    expect_rejected([&, &request = wrong] { (void)binarise(image, image, request); }, part);
  }
}

TEST(Spacing, is_in_a_range) {
  const Graph empty;
  for (const Spacing spacing : {Spacing{0, 1}, Spacing{1, -1}, Spacing{1, 1e31}}) {
    const std::string expected = "spacing: expected numbers from 1e-30 to 1e30, got ";
    expect_rejected([&] { (void)links_of(empty, spacing); }, expected);
    expect_rejected([&] { (void)branches(empty, spacing); }, expected);
    expect_rejected([&] { (void)open_cycles(empty, 1, spacing); }, expected);
  }
}

TEST(Thresholds, are_levels) {
  Untouched memory;
  const ConstImageView source = {memory.data(), 20, 8, 64};
  for (const auto& [thresholds, part] : std::vector<std::pair<EdgeThresholds, std::string>>{
           {{256, 0}, "gradient_threshold: expected an integer in [0, 255], got 256"},
           {{-1, 0}, "gradient_threshold: expected an integer in [0, 255], got -1"},
           {{0, 256}, "brightness_threshold: expected an integer in [0, 255], got 256"},
           {{0, -1}, "brightness_threshold: expected an integer in [0, 255], got -1"}}) {
    expect_rejected(
        [&, given = thresholds] {
          detect_edges(EdgeOperator::sobel, source, {memory.data() + 20, 20, 8, 64}, given);
        },
        part);
    expect_rejected([&, given = thresholds] { (void)localise_objects(source, given); }, part);
  }
}

TEST(Sizes, beyond_what_coordinates_can_hold_are_rejected) {
  Untouched memory;
  const Index side = Index{1} << 29;
  expect_rejected(
      [&] {
        (void)find_regions({memory.data(), side + 1, 0});
      },
      "image size 536870913 x 0 has a side above 2^29 pixels");
  expect_rejected(
      [&] {
        (void)localise_objects({memory.data(), 0, side + 1});
      },
      "image size 0 x 536870913 has a side above 2^29 pixels");
  expect_rejected(
      [&] {
        (void)find_objects({memory.data(), 1 << 17, 1 << 17});
      },
      "image size 131072 x 131072 is larger than 2^32 pixels");
  for (const auto& [width, height, part] : std::vector<std::tuple<Index, Index, std::string>>{
           {-1, 5, "image size -1 x 5 is negative"},
           {5, -1, "image size 5 x -1 is negative"},
           {Index{1} << 40, 2, "image size 1099511627776 x 2 is larger than 2^40 pixels"},
           {2, std::numeric_limits<Index>::max(), "9223372036854775807 is larger than 2^40"}}) {
    expect_rejected([w = width, h = height] { Thinner(Rule::guo_hall, w, h); }, part);
    expect_rejected([w = width, h = height] { StackThinner(Rule::guo_hall, w, h); }, part);
  }
}

TEST(Plans, reject_images_of_another_size) {
  Untouched memory;
  Thinner thinner(Rule::guo_hall, 20, 8);
  StackThinner stack_thinner(Rule::guo_hall, 20, 8);
  const ImageView image = {memory.data(), 20, 9, 64};
  const StackView stack = {memory.data(), 2, 5, 6};
  expect_rejected([&] { thinner(image, image); }, "expected images of 20 x 8, got 20 x 9");
  expect_rejected([&] { stack_thinner(stack, stack); }, "expected images of 20 x 8, got 5 x 6");
}

}  // namespace
}  // namespace thinbench
