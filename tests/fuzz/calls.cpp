// Sequences of calls: plans for one image and for stacks that are made, used, moved and used again
// after a rejected call; lists of images, labels, regions, edges and packed images, with rules of
// any kind.
// Every result is the reference's; every rejected call says why in one line and writes nothing.
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "drawn_image.hpp"
#include "drawn_rule.hpp"
#include "holes.hpp"
#include "localise.hpp"
#include "support/packed_image.hpp"
#include "support/reference_thinning.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/many.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

/// What a plan was made for.
struct Request {
  Rule rule = Rule::guo_hall;
  DrawnSize size = {};
  Thinning thinning = {};
  Execution execution = {};

  int by_reference(const ConstImageView& source, const ImageView& destination) const {
    return thin_by_reference(rule, thinning, source, destination);
  }
};

/// Mostly valid; now and then something that does not exist or does not apply.
Thinning draw_thinning(ByteSource& input) {
  constexpr std::array limits = {kUnlimited, kUnlimited, kUnlimited, 1, 2, 3, 0, -1};
  Thinning thinning;
  if (input.once_in(2)) thinning.border = static_cast<Border>(input.number(0, 2));
  if (input.once_in(64)) thinning.border = static_cast<Border>(3);
  if (input.once_in(2)) thinning.max_iterations = input.pick(limits);
  return thinning;
}

Execution draw_execution(ByteSource& input) {
  Execution execution;
  if (input.once_in(2)) execution.isa = static_cast<Isa>(input.number(0, 4));
  if (input.once_in(64)) execution.isa = static_cast<Isa>(6);
  if (input.once_in(16)) execution.threads = static_cast<int>(input.number(-1, 2));
  return execution;
}

Request draw_request(ByteSource& input) {
  const Rule rule = draw_rule(input);
  const DrawnSize size = draw_size(input);
  const Thinning thinning = draw_thinning(input);
  return {rule, size, thinning, draw_execution(input)};
}

template <class Plan>
struct Made {
  Request request;
  Plan plan;
};

class Calls {
 public:
  explicit Calls(ByteSource& input) : input_(input) {}

  void run() {
    for (int calls = 0; calls < 12 && !input_.is_empty(); ++calls) {
      must_succeed_or_explain<std::invalid_argument>([&] { call(); });
    }
  }

 private:
  /// Twice or more what has many states.
  void call() {
    constexpr std::array<void (Calls::*)(), 16> calls = {
        &Calls::make_thinner,       &Calls::make_thinner,      &Calls::run_thinner,
        &Calls::run_thinner,        &Calls::run_thinner,       &Calls::move_thinner,
        &Calls::make_stack_thinner, &Calls::run_stack_thinner, &Calls::run_stack_thinner,
        &Calls::move_stack_thinner, &Calls::thin_list,         &Calls::thin_label_image,
        &Calls::find_all_regions,   &Calls::find_edges,        &Calls::thin_packed,
        &Calls::thin_once};
    (this->*input_.pick(calls))();
  }

  template <class Plan>
  using Slots = std::array<std::optional<Made<Plan>>, 3>;

  template <class Plan>
  void make(Slots<Plan>& slots) {
    auto& slot = slots[static_cast<std::size_t>(input_.number(0, 2))];
    const Request request = draw_request(input_);
    const auto& [rule, size, thinning, execution] = request;
    slot.emplace(Made<Plan>{request, Plan(rule, size.width, size.height, thinning, execution)});
  }

  /// Onto another plan or into an empty slot. What was moved from is not used again.
  template <class Plan>
  void move(Slots<Plan>& slots) {
    const auto from = static_cast<std::size_t>(input_.number(0, 2));
    const auto to = static_cast<std::size_t>(input_.number(0, 2));
    if (from == to) return;
    slots[to] = std::move(slots[from]);
    slots[from].reset();
  }

  void make_thinner() { make(thinners_); }
  void make_stack_thinner() { make(stack_thinners_); }
  void move_thinner() { move(thinners_); }
  void move_stack_thinner() { move(stack_thinners_); }

  /// Calls `thin(source, destination)` on a drawn image and compares.
  template <class Thin>
  void check(const Request& request, const Thin& thin) {
    const ByteImage image = draw_binary(input_, request.size);
    DrawnPair images(input_, image.view());
    const int iterations = thin(images.source.view(), images.to());
    ByteImage expected(image.width(), image.height());
    must(iterations == request.by_reference(image.view(), expected.view()), "other iterations");
    must_be_equal(images.to(), expected.view(), "a call");
    images.must_be_intact();
  }

  void run_thinner() {
    auto& slot = thinners_[static_cast<std::size_t>(input_.number(0, 2))];
    if (!slot) return;
    if (input_.once_in(8)) reject_other_size(*slot);
    check(slot->request, std::ref(slot->plan));
  }

  /// An image of another size is rejected, and the plan remains as it was.
  void reject_other_size(Made<Thinner>& made) {
    const auto [width, height] = made.request.size;
    ByteImage image(width + 1, height);
    ByteImage found(width + 1, height);
    try {
      made.plan(image.view(), found.view());
    } catch (const std::invalid_argument& error) {
      must_be_one_line(error.what());
      return;
    }
    must(false, "an image of another size was taken");
  }

  void thin_once() {
    const Request request = draw_request(input_);
    check(request, [&](const ConstImageView& source, const ImageView& destination) {
      return thin(request.rule, source, destination, request.thinning, request.execution);
    });
  }

  /// The images of a stack one below the other, which is itself an image.
  void run_stack_thinner() {
    auto& slot = stack_thinners_[static_cast<std::size_t>(input_.number(0, 2))];
    if (!slot) return;
    const Index width = slot->request.size.width;
    const Index height = slot->request.size.height;
    const Index count = input_.number(0, 9);
    const DrawnSize all = {width, count * height};
    const ByteImage image = draw_binary(input_, all);
    DrawnPair images(input_, image.view());
    const auto stack = [&](const ImageView& view) {
      return StackView{view.data, count, width, height, view.stride, height * view.stride};
    };
    const int found = slot->plan(stack(images.source.view()), stack(images.to()));
    ByteImage expected(width, all.height);
    int iterations = 0;
    for (Index i = 0; i < count; ++i) {
      const ConstImageView from(image.view().row(i * height), width, height, image.view().stride);
      iterations = std::max(
          iterations, slot->request.by_reference(from, {expected.view().row(i * height), width,
                                                        height, expected.view().stride}));
    }
    must(found == iterations, "a stack: other iterations");
    must_be_equal(images.to(), expected.view(), "a stack");
    images.must_be_intact();
  }

  void thin_list() {
    const Request request = draw_request(input_);
    const Index count = input_.number(0, 8);
    std::vector<ByteImage> expected;
    std::vector<DrawnImage> images;
    std::vector<ConstImageView> sources;
    std::vector<ImageView> destinations;
    for (Index i = 0; i < count; ++i) {
      const DrawnSize size = input_.once_in(2) ? request.size : draw_size(input_);
      expected.push_back(draw_binary(input_, size));
      images.emplace_back(input_, size).copy_from(expected.back().view());
      sources.emplace_back(images.back().view());
      if (!input_.once_in(4)) images.emplace_back(input_, size);
      destinations.push_back(images.back().view());
    }
    const int found =
        thin_many(request.rule, sources, destinations, request.thinning, request.execution);
    int iterations = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const ImageView view = expected[i].view();
      iterations = std::max(iterations, request.by_reference(view, view));
      must_be_equal(destinations[i], view, "an image of a list");
    }
    must(found == iterations, "a list: other iterations");
    for (const DrawnImage& image : images) image.must_be_intact();
  }

  void thin_label_image() {
    const Request request = draw_request(input_);
    const auto [width, height] = request.size;
    constexpr std::array<std::int32_t, 8> values = {0, 0, 0, 1, 2, 3, 70'000, INT32_MAX};
    const auto pixels = static_cast<std::size_t>(width * height);
    std::vector<std::int32_t> labels(pixels);
    const bool is_negative = input_.once_in(32);
    for (std::int32_t& label : labels) label = input_.is_empty() ? 1 : input_.pick(values);
    if (is_negative && pixels > 0) labels[pixels / 2] = -1;
    std::vector<std::int32_t> found(pixels, -7);
    const int iterations =
        thin_labels(request.rule, {labels.data(), width, height}, {found.data(), width, height},
                    request.thinning, request.execution);
    must(!is_negative || pixels == 0, "a negative label was taken");
    int expected_iterations = 0;
    std::vector<std::int32_t> expected(pixels, 0);
    for (const std::int32_t value : {1, 2, 3, 70'000, INT32_MAX}) {
      std::vector<std::uint8_t> mask(pixels);
      std::transform(labels.begin(), labels.end(), mask.begin(),
                     [=](std::int32_t label) { return label == value ? 255 : 0; });
      if (std::count(labels.begin(), labels.end(), value) == 0) continue;
      const ImageView view(mask.data(), width, height);
      expected_iterations = std::max(expected_iterations, request.by_reference(view, view));
      for (std::size_t i = 0; i < pixels; ++i) expected[i] += mask[i] != 0 ? value : 0;
    }
    must(found == expected, "labels differ from the reference");
    must(iterations == expected_iterations, "labels: other iterations");
    fill_label_image(labels, width, height);
  }

  void fill_label_image(std::vector<std::int32_t>& labels, Index width, Index height) {
    constexpr std::array<std::int64_t, 4> areas = {kAnyHoleArea, 0, 1, 9};
    const bool four = input_.once_in(2);
    const std::int64_t max_area = input_.pick(areas);
    std::vector<std::int32_t> expected(labels.size());
    reference::fill_label_holes({labels.data(), width, height}, {expected.data(), width, height},
                                four, max_area);
    const LabelView view = {labels.data(), width, height};
    fill_holes_of_labels(view, view, {four ? Connectivity::four : Connectivity::eight, max_area});
    must(labels == expected, "filled labels differ from the reference");
  }

  void find_all_regions() {
    const Execution execution = draw_execution(input_);
    const DrawnSize size = draw_size(input_);
    const ByteImage image = draw_binary(input_, size);
    DrawnImage source(input_, size);
    source.copy_from(image.view());
    const auto pixels = static_cast<std::size_t>(size.width * size.height);
    std::vector<std::int32_t> labels(pixels, -7), expected_labels(pixels);
    const reference::Regions expected =
        reference::label_regions(image.view(), {expected_labels.data(), size.width, size.height});
    const Regions labelled = label_regions(source.view(), {labels.data(), size.width, size.height});
    must(labels == expected_labels, "labels differ");
    must(labelled.objects == expected.objects && labelled.holes == expected.holes,
         "labelled regions differ");
    must(find_objects(source.view(), execution) == expected.objects, "objects differ");
    const Regions found = find_regions(source.view(), execution);
    must(found.objects == expected.objects && found.holes == expected.holes, "regions differ");
    must(euler_number(source.view(), Connectivity::eight, execution) ==
                 reference::euler_number(image.view()) &&
             euler_number(source.view(), Connectivity::four, execution) ==
                 reference::euler_number_4(image.view()),
         "Euler numbers differ");
    ByteImage filled(size.width, size.height);
    reference::fill_holes(image.view(), filled.view());
    fill_holes(source.view(), source.view(), {}, execution);
    must_be_equal(source.view(), filled.view(), "a filled image");
    source.must_be_intact();
  }

  void find_edges() {
    const Execution execution = draw_execution(input_);
    const auto last = static_cast<Index>(kEdgeOperators.size()) - 1;
    const auto op = static_cast<EdgeOperator>(input_.number(0, input_.once_in(32) ? 6 : last));
    const EdgeThresholds thresholds = {static_cast<int>(input_.number(-1, 256)),
                                       static_cast<int>(input_.number(-1, 256))};
    const DrawnSize size = draw_size(input_);
    const ByteImage image = draw_grey(input_, size);
    DrawnPair images(input_, image.view(), false);
    const ConstImageView source = images.source.view();
    const Regions found = localise_objects(source, thresholds, execution);
    detect_edges(op, source, images.to(), thresholds, execution);
    ByteImage expected(size.width, size.height);
    reference::edges(op)(thresholds, image.view(), expected.view());
    must_be_equal(images.to(), expected.view(), "edges");
    const reference::Regions regions = reference::localise_objects(
        reference::edges(EdgeOperator::sobel), thresholds, image.view());
    must(found.objects == regions.objects && found.holes == regions.holes, "localised differ");
    images.must_be_intact();
  }

  void thin_packed() {
    const Request request = draw_request(input_);
    const auto [width, height] = request.size;
    constexpr std::array orders = {BitOrder::msb_first, BitOrder::lsb_first};
    constexpr std::array<std::uint8_t, 3> fillers = {0, 0xFF, 0xA5};
    const std::uint8_t filler = input_.pick(fillers);
    const ByteImage image = draw_binary(input_, request.size);
    const BitOrder order = input_.pick(orders);
    PackedImage source(image.view(), order, input_.number(0, 9), filler);
    PackedImage destination(width, height, input_.pick(orders), input_.number(0, 9), filler);
    PackedImage& to = input_.once_in(4) ? source : destination;
    const BitOrder written = to.view().order;
    const int iterations = thinbench::thin_packed(request.rule, std::as_const(source).view(),
                                                  to.view(), request.thinning, request.execution);
    ByteImage expected(width, height);
    must(iterations == request.by_reference(image.view(), expected.view()),
         "a packed image: other iterations");
    const Index gap = to.view().stride - packed_row_bytes(width);
    const PackedImage packed(expected.view(), written, gap, filler == 0xFF ? 0 : filler);
    for (Index y = 0; y < height; ++y) {
      const std::uint8_t* const row = to.view().row(y);
      const Index bytes = packed_row_bytes(width);
      must(std::equal(row, row + bytes, packed.view().row(y)), "a packed image differs");
      must(std::all_of(row + bytes, row + bytes + gap, [=](auto byte) { return byte == filler; }),
           "bytes of a gap were changed");
    }
  }

  ByteSource& input_;
  Slots<Thinner> thinners_;
  Slots<StackThinner> stack_thinners_;
};

}  // namespace

void try_input(ByteSource& input) {
  Calls(input).run();
}

}  // namespace thinbench
