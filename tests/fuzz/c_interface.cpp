// The C interface with arguments that are valid, almost valid or absurd: a rejected call has the
// status of an invalid argument, one line about it and an untouched destination; all others give
// the reference's result, which the target `calls` compares for lists, labels and packed images.
// Memory is as large as the arguments say, or the call must be rejected.
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "drawn_image.hpp"
#include "drawn_rule.hpp"
#include "graph.hpp"
#include "holes.hpp"
#include "support/packed_image.hpp"
#include "support/reference_thinning.hpp"
#include "thinbench.h"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

constexpr Index kMax = std::numeric_limits<Index>::max();
constexpr Index kMin = std::numeric_limits<Index>::min();
constexpr std::array<Index, 10> kAbsurd = {
    -1, 0, 1, 2, 255, Index{1} << 31, Index{1} << 40, kMax / 2, kMax, kMin};

/// Now and then replaces a value.
void spoil(ByteSource& input, Index& value) {
  if (input.once_in(24)) value = input.pick(kAbsurd);
}

/// A stack, or an image, in memory that ends with its last pixel. Arguments may say something else.
class Stack {
 public:
  explicit Stack(ByteSource& input, const DrawnSize& size, std::optional<Index> images = {})
      : count_(images.value_or(1)), height_(size.height), width_(size.width) {
    stride_ = width_ + (input.once_in(3) ? input.number(1, 20) : 0);
    const bool has_rows = width_ > 0 && height_ > 0;
    const Index image_bytes = has_rows ? (height_ - 1) * stride_ + width_ : 0;
    image_stride_ = image_bytes + (input.once_in(3) ? input.number(1, 20) : 0);
    if (count_ > 0 && has_rows) bytes_ = (count_ - 1) * image_stride_ + image_bytes;
    data_.reset(new std::uint8_t[static_cast<std::size_t>(bytes_)]);
    std::fill_n(data_.get(), bytes_, kGuard);
    pixels_ = input.once_in(24) ? nullptr : data_.get();
    for (Index* value : {&height_, &width_, &stride_}) spoil(input, *value);
    if (!images) return;
    for (Index* value : {&count_, &image_stride_}) spoil(input, *value);
  }

  void describe(thinbench_stack& stack, std::uint8_t foreground) const {
    stack = {sizeof(stack), pixels_,       count_,     width_, height_,
             stride_,       image_stride_, foreground, {}};
  }
  void describe(thinbench_image& image, std::uint8_t foreground) const {
    image = {sizeof(image), pixels_, width_, height_, stride_, foreground, {}};
  }
  template <class Struct = thinbench_image>
  [[nodiscard]] Struct described(std::uint8_t foreground = 0) const {
    Struct found = {};
    describe(found, foreground);
    return found;
  }
  [[nodiscard]] Index count() const { return count_; }
  [[nodiscard]] ConstImageView image(Index i) const {
    return {pixels_ + (i == 0 ? 0 : i * image_stride_), width_, height_, stride_};
  }
  [[nodiscard]] std::vector<std::uint8_t> bytes() const {
    return {data_.get(), data_.get() + bytes_};
  }

  /// As many images of this size as in another stack.
  void resize_as(const Stack& other) {
    count_ = other.count_;
    height_ = other.height_;
    width_ = other.width_;
  }

  /// Fills the memory with pixels of the input.
  void draw(ByteSource& input) {
    const ByteImage pixels = draw_binary(input, {bytes_, 1});
    std::copy_n(pixels.view().data, bytes_, data_.get());
  }

  /// Whether there are pixels, all of them in this memory.
  [[nodiscard]] bool is_readable() const {
    if (count_ <= 0 || height_ <= 0 || width_ <= 0 || stride_ < width_) return false;
    Index image = 0;
    Index before = 0;
    const bool overflows =
        __builtin_mul_overflow(height_ - 1, stride_, &image) ||
        __builtin_add_overflow(image, width_, &image) ||
        (count_ > 1 && __builtin_mul_overflow(count_ - 1, image_stride_, &before));
    if (overflows || (count_ > 1 && image_stride_ < image)) return false;
    return pixels_ != nullptr && image <= bytes_ && before <= bytes_ - image;
  }

  /// Whether a call stays in this memory and ends soon: it has to reject the arguments, or may read
  /// and write what they say.
  [[nodiscard]] bool is_safe() const {
    constexpr Index many = 1 << 12;
    if (is_readable() || count_ < 0 || height_ < 0 || width_ < 0 || stride_ < width_) return true;
    if (count_ == 0 || height_ == 0 || width_ == 0) {
      return count_ <= many && height_ <= many && width_ <= many;
    }
    if (pixels_ == nullptr || stride_ > kMax / height_) return true;
    const Index image = (height_ - 1) * stride_ + width_;
    return count_ > 1 && (image_stride_ < image || image_stride_ > kMax / count_);
  }

 private:
  static constexpr std::uint8_t kGuard = 0xA5;

  Index count_;
  Index height_;
  Index width_;
  Index stride_ = 0;
  Index image_stride_ = 0;
  Index bytes_ = 0;
  std::unique_ptr<std::uint8_t[]> data_;
  std::uint8_t* pixels_ = nullptr;
};

constexpr std::array<const char*, 4> kNonsense = {nullptr, "", "nonsense", "guo_hall\n"};

/// A struct that begins with its size, or none, and what a later version may have after it.
template <class Struct>
struct Drawn {
  bool given = false;
  Struct value = {};
  std::array<std::uint8_t, 16> more = {};

  [[nodiscard]] const Struct* pointer() const { return given ? &value : nullptr; }
};

template <class Struct>
Drawn<Struct> draw_struct(ByteSource& input, const Struct& defaults) {
  constexpr std::array<std::size_t, 7> sizes = {
      0, 8, sizeof(Struct) - 1, sizeof(Struct) + 1, sizeof(Struct) + 16, 4096, SIZE_MAX};
  Drawn<Struct> drawn = {input.once_in(2), defaults};
  if (input.once_in(32)) drawn.more[input.byte() % 16] = input.byte();
  if (drawn.given && input.once_in(32)) drawn.value.size = input.pick(sizes);
  return drawn;
}

Drawn<thinbench_thinning> draw_thinning(ByteSource& input) {
  constexpr std::array<std::int32_t, 6> limits = {0, 0, 1, 2, -1, INT32_MIN};
  constexpr std::array<const char*, 5> borders = {nullptr, "background", "keep", "foreground",
                                                  "white"};
  auto drawn = draw_struct<thinbench_thinning>(input, THINBENCH_THINNING_INIT);
  if (!drawn.given) return drawn;
  drawn.value.border = input.pick(borders);
  drawn.value.max_iterations = input.pick(limits);
  return drawn;
}

/// What an accepted struct means.
Thinning thinning_of(const Drawn<thinbench_thinning>& drawn) {
  const auto& [size, border, limit, reserved] = drawn.value;
  Thinning thinning;
  if (!drawn.given) return thinning;
  if (limit > 0) thinning.max_iterations = limit;
  if (border == nullptr) return thinning;
  thinning.border = border_from_name(border);
  return thinning;
}

Drawn<thinbench_execution> draw_execution(ByteSource& input) {
  constexpr std::array<std::int32_t, 8> threads = {1, 1, 1, 1, 1, 2, 0, 1025};
  auto drawn = draw_struct<thinbench_execution>(input, THINBENCH_EXECUTION_INIT);
  if (!drawn.given) return drawn;
  if (input.once_in(8)) drawn.value.threads = input.pick(threads);
  if (input.once_in(2)) {
    drawn.value.isa = thinbench_isa_name(static_cast<std::size_t>(input.number(0, 5)));
  }
  if (input.once_in(32)) drawn.value.isa = input.pick(kNonsense);
  return drawn;
}

/// Whether the call was accepted; otherwise it must say why.
bool is_accepted(thinbench_status status) {
  must(status == THINBENCH_OK || status == THINBENCH_INVALID_ARGUMENT,
       "status " + std::to_string(status) + ": " + thinbench_last_error());
  if (status != THINBENCH_OK) must_be_one_line(thinbench_last_error());
  return status == THINBENCH_OK;
}

/// A status for calls whose result is not looked at.
void check_status(thinbench_status status) {
  static_cast<void>(is_accepted(status));
}

/// What a call of thinning gets: a rule, which may be NULL, and structs.
class DrawnCall {
 public:
  explicit DrawnCall(ByteSource& input)
      : thinning(draw_thinning(input)), execution(draw_execution(input)) {
    if (input.once_in(4)) {
      make_from_tables(input);
    } else {
      make_named(input);
    }
  }
  ~DrawnCall() { thinbench_rule_destroy(rule); }
  DrawnCall(const DrawnCall&) = delete;
  DrawnCall& operator=(const DrawnCall&) = delete;

  int by_reference(const ConstImageView& source, const ImageView& destination) const {
    return thin_by_reference(*same_, thinning_of(thinning), source, destination);
  }

  thinbench_rule* rule = nullptr;
  Drawn<thinbench_thinning> thinning;
  Drawn<thinbench_execution> execution;

 private:
  void make_named(ByteSource& input) {
    const auto names = static_cast<Index>(kRules.size() + named_rules().size());
    const auto index = static_cast<std::size_t>(input.number(0, names - 1));
    const bool has_name = !input.once_in(16);
    const char* const name = has_name ? thinbench_rule_name(index) : input.pick(kNonsense);
    const bool made = is_accepted(thinbench_rule_named(name, &rule));
    must(made == has_name && made == (rule != nullptr), "a wrong handle");
    if (made) same_ = Rule::named(name);
  }

  /// Tables of named rules: others take long to compile.
  void make_from_tables(ByteSource& input) {
    const NamedRule& named = input.pick(named_rules());
    const auto defaults = draw_thinning(input);
    std::size_t count = named.sub_iterations.size();
    if (input.once_in(16)) count = input.once_in(2) ? 0 : 9;
    const auto* const words = named.sub_iterations.front().words.data();
    const bool made =
        is_accepted(thinbench_rule_from_tables(words, count, defaults.pointer(), 0, &rule));
    must(made == (rule != nullptr), "a handle without a rule");
    const Thinning given = thinning_of(defaults);
    if (!made) return;
    same_ = Rule(named.sub_iterations, {given.border.value_or(Border::background),
                                        given.max_iterations.value_or(kUnlimited)});
  }

  std::optional<Rule> same_;
};

class Caller {
 public:
  explicit Caller(ByteSource& input) : input_(input) {}

  void run() {
    for (int calls = 0; calls < 4 && !input_.is_empty(); ++calls) call();
  }

 private:
  using Call = void (Caller::*)();

  void call() {
    constexpr std::array<Call, 12> calls = {
        &Caller::thin,        &Caller::thin_stack,   &Caller::thin_many, &Caller::thin_packed,
        &Caller::thin_labels, &Caller::use_thinner,  &Caller::ask_rule,  &Caller::ask_rule,
        &Caller::find_edges,  &Caller::find_regions, &Caller::fill,      &Caller::call_more};
    (this->*input_.pick(calls))();
  }

  void call_more() {
    constexpr std::array<Call, 7> calls = {
        &Caller::find_distances, &Caller::find_graph, &Caller::use_labels, &Caller::use_labels,
        &Caller::make_net,       &Caller::use_labels, &Caller::use_labels};
    (this->*input_.pick(calls))();
  }

  /// Calls `run(source, destination)` on drawn images or stacks; compares images of an accepted
  /// call with those of `expect(source, destination)`, whose results are ANDed with the foreground.
  template <class Struct = thinbench_image, class Run, class Expect>
  void check(bool in_place_allowed, const Run& run, const Expect& expect) {
    constexpr std::array<std::uint8_t, 4> foregrounds = {0, 255, 1, 128};
    std::optional<Index> count;
    if (std::is_same_v<Struct, thinbench_stack>) count = input_.number(0, 5);
    const DrawnSize size = draw_size(input_);
    Stack source(input_, size, count);
    Stack other(input_, size, count);
    const bool in_place = in_place_allowed && input_.once_in(4);
    Stack& destination = in_place ? source : other;
    destination.resize_as(source);
    if (!source.is_safe() || !destination.is_safe()) return;
    const std::uint8_t foreground = input_.pick(foregrounds);
    source.draw(input_);
    std::vector<ByteImage> expected;
    const auto from = source.described<Struct>();
    const auto to = destination.described<Struct>(foreground);
    const auto before = destination.bytes();
    for (Index i = 0; source.is_readable() && i < source.count(); ++i) {
      expected.push_back(copy_of(source.image(i)));
    }
    const Struct* const from_or_null = input_.once_in(32) ? nullptr : &from;
    const Struct* const to_or_null = input_.once_in(32) ? nullptr : &to;
    if (!is_accepted(run(from_or_null, to_or_null))) {
      must(destination.bytes() == before, "a rejected call wrote");
      return;
    }
    must(from_or_null != nullptr && to_or_null != nullptr, "NULL was accepted");
    for (std::size_t i = 0; i < expected.size(); ++i) {
      compare(destination.image(static_cast<Index>(i)), expected[i], foreground, expect);
    }
  }

  template <class Expect>
  static void compare(const ConstImageView& found, const ByteImage& image, std::uint8_t foreground,
                      const Expect& expect) {
    ByteImage expected(image.width(), image.height());
    expect(image.view(), expected.view());
    const int ones = foreground == 0 ? 255 : foreground;
    expected = mapped(expected, [=](int pixel) { return pixel & ones; });
    must_be_equal(found, expected.view(), "an image");
  }

  void thin() { thin_as<thinbench_image>(thinbench_thin); }
  void thin_stack() { thin_as<thinbench_stack>(thinbench_thin_stack); }

  template <class Struct, class Function>
  void thin_as(const Function& function) {
    const DrawnCall call(input_);
    std::int32_t iterations = -1;
    int most = 0;
    check<Struct>(
        true,
        [&](const Struct* source, const Struct* destination) {
          return function(call.rule, source, destination, call.thinning.pointer(),
                          call.execution.pointer(), input_.once_in(4) ? nullptr : &iterations);
        },
        [&](const ConstImageView& source, const ImageView& destination) {
          const int used = call.by_reference(source, destination);
          most = std::max(most, used);
          must(iterations == -1 || used <= iterations, "too few iterations");
        });
    must(iterations == -1 || most == 0 || iterations == most, "other iterations");
  }

  void use_thinner() {
    const DrawnCall call(input_);
    auto [width, height] = draw_size(input_);
    if (input_.once_in(16)) width = input_.once_in(2) ? kMax : -1;
    thinbench_thinner* thinner = nullptr;
    const bool made = is_accepted(thinbench_thinner_create(
        call.rule, width, height, call.thinning.pointer(), call.execution.pointer(),
        input_.once_in(32) ? nullptr : &thinner));
    must(made == (thinner != nullptr), "a handle without a thinner");
    check(
        true,
        [&](const thinbench_image* source, const thinbench_image* destination) {
          return thinbench_thinner_run(thinner, source, destination, nullptr);
        },
        [&](const ConstImageView& source, const ImageView& destination) {
          call.by_reference(source, destination);
        });
    thinbench_thinner_destroy(thinner);
  }

  void thin_many() {
    const DrawnCall call(input_);
    const Index count = input_.number(0, 6);
    std::vector<Stack> stacks;
    std::vector<thinbench_image> sources;
    std::vector<thinbench_image> destinations;
    for (Index i = 0; i < count; ++i) {
      const DrawnSize size = draw_size(input_);
      stacks.emplace_back(input_, size);
      Stack destination(input_, size);
      destination.resize_as(stacks.back());
      if (!stacks.back().is_safe() || !destination.is_safe()) return;
      stacks.back().draw(input_);
      sources.push_back(stacks.back().described());
      stacks.push_back(std::move(destination));
      destinations.push_back(stacks.back().described(255));
    }
    const bool is_null = input_.once_in(32);
    check_status(thinbench_thin_many(call.rule, is_null ? nullptr : sources.data(),
                                     destinations.data(), static_cast<std::size_t>(count),
                                     call.thinning.pointer(), call.execution.pointer(), nullptr));
  }

  /// Now and then replaces one value by what must be rejected: more than one at a time could be
  /// valid by chance. False where the largest is valid, too.
  template <std::size_t count>
  bool spoil_one(const DrawnSize& size, Index* const (&values)[count]) {
    constexpr std::array<Index, 4> rejected = {-1, kMin, kMax, -(Index{1} << 62)};
    if (!input_.once_in(8)) return true;
    Index& value = *input_.pick(values);
    value = input_.pick(rejected);
    return value != kMax || (size.height > 1 && size.width > 0);
  }

  void thin_packed() {
    const DrawnCall call(input_);
    const DrawnSize size = draw_size(input_);
    const ByteImage image = draw_binary(input_, size);
    const BitOrder order = input_.once_in(2) ? BitOrder::lsb_first : BitOrder::msb_first;
    PackedImage source(image.view(), order, input_.number(0, 3));
    PackedImage destination(size.width, size.height, order, input_.number(0, 3));
    const ConstPackedView from = source.view();
    const PackedView to = destination.view();
    const std::int32_t lsb_first = order == BitOrder::lsb_first ? 1 : 0;
    thinbench_packed given = THINBENCH_PACKED_INIT;
    given.width = from.width;
    given.height = from.height;
    given.lsb_first = lsb_first;
    thinbench_packed result = given;
    given.data = const_cast<std::uint8_t*>(from.data);
    given.stride = from.stride;
    result.data = to.data;
    result.stride = to.stride;
    Index* const values[] = {&given.height,  &given.width,  &given.stride,
                             &result.height, &result.width, &result.stride};
    if (!spoil_one(size, values)) return;
    check_status(thinbench_thin_packed(call.rule, &given, &result, call.thinning.pointer(),
                                       call.execution.pointer(), nullptr));
  }

  void thin_labels() {
    const DrawnCall call(input_);
    const DrawnSize size = draw_size(input_);
    const auto [width, height] = size;
    std::vector<std::int32_t> labels(static_cast<std::size_t>(width * height));
    for (std::int32_t& label : labels) label = input_.byte() % 4 == 0 ? 5 : 0;
    std::vector<std::int32_t> found(labels.size());
    thinbench_labels source = {sizeof(source), labels.data(), width, height, width};
    thinbench_labels result = {sizeof(result), found.data(), width, height, width};
    Index* const values[] = {&source.stride, &source.width, &result.stride, &result.height};
    if (!spoil_one(size, values)) return;
    check_status(thinbench_thin_labels(call.rule, &source, &result, call.thinning.pointer(),
                                       call.execution.pointer(), nullptr));
  }

  void ask_rule() {
    const DrawnCall call(input_);
    std::int32_t gates = 0;
    check_status(thinbench_rule_gates(call.rule, static_cast<std::size_t>(input_.number(0, 9)),
                                      input_.once_in(16) ? nullptr : &gates));
    thinbench_rule_info info = THINBENCH_RULE_INFO_INIT;
    if (!is_accepted(thinbench_rule_describe(call.rule, &info))) return;
    must(info.name != nullptr && info.border != nullptr, "a rule without a name or a border");
    must((info.tables != nullptr) == (info.sub_iterations > 0), "another number of tables");
  }

  /// Weights of any size; bits that are no numbers are among them.
  void make_net() {
    std::array<float, (kHiddenNeurons + 1) * (kNetInputs + 1)> weights{};
    const bool any_bits = input_.once_in(8);
    for (float& weight : weights) {
      weight = any_bits ? std::bit_cast<float>(static_cast<std::uint32_t>(input_.word()))
                        : static_cast<float>(input_.number(-8, 8));
    }
    const std::array<std::int32_t, 2> last = {static_cast<std::int32_t>(input_.number(-1, 255)),
                                              255};
    const auto count = static_cast<std::size_t>(input_.number(0, 2));
    constexpr std::array<const char*, 4> activations = {"sigmoid", "linear", nullptr, "relu"};
    thinbench_rule* rule = nullptr;
    const auto status =
        input_.once_in(2)
            ? thinbench_rule_from_cluster(last.data(), weights.data(), count, &rule)
            : thinbench_rule_from_two_layer_net(weights.data(), input_.pick(activations), &rule);
    must(is_accepted(status) == (rule != nullptr), "a handle without a rule");
    thinbench_rule_destroy(rule);
  }

  void find_edges() {
    const char* const name =
        input_.once_in(16) ? input_.pick(kNonsense) : input_.pick(kEdgeOperators).name.data();
    const auto gradient = static_cast<std::int32_t>(input_.number(-1, 256));
    const auto brightness = static_cast<std::int32_t>(input_.number(-1, 256));
    const auto execution = draw_execution(input_);
    check(
        false,
        [&](const thinbench_image* source, const thinbench_image* destination) {
          return thinbench_detect_edges(name, source, destination, gradient, brightness,
                                        execution.pointer());
        },
        [&](const ConstImageView& source, const ImageView& destination) {
          reference::edges (*edge_operator_from_name(name))({gradient, brightness}, source,
                                                            destination);
        });
  }

  void fill() {
    const auto execution = draw_execution(input_);
    const bool four = input_.number(0, 1) == 1;
    thinbench_hole_filling filling = THINBENCH_HOLE_FILLING_INIT;
    filling.connectivity = four ? 4 : 8;
    if (input_.number(0, 1) == 0) filling.max_area = input_.number(0, 50);
    check(
        true,
        [&](const thinbench_image* source, const thinbench_image* destination) {
          return thinbench_fill_holes(source, destination, &filling, execution.pointer());
        },
        [&](const ConstImageView& source, const ImageView& destination) {
          reference::fill_small_holes(source, destination, four, filling.max_area);
        });
  }

  /// By a function that gives a list, in structures of a size, of a handle.
  template <class Struct, class Handle, class List, class T>
  static void compare_list(const Handle* handle, List list, const std::vector<T>& expected) {
    std::size_t count = 1;
    const Struct* const found = list(handle, &count, sizeof(Struct));
    must(count == expected.size() &&
             std::equal(expected.begin(), expected.end(), reinterpret_cast<const T*>(found)),
         "a list differs");
    must(list(handle, &count, sizeof(Struct) - 1) == nullptr && count == 0, "another struct");
    must(list(nullptr, &count, sizeof(Struct)) == nullptr && count == 0, "a list of nothing");
  }

  void find_regions() {
    const auto execution = draw_execution(input_);
    const Stack source = draw_image();
    if (!source.is_safe()) return;
    const thinbench_image from = source.described();
    std::vector<std::int32_t> labels(
        source.is_readable() ? static_cast<std::size_t>(from.width * from.height) : 0);
    const thinbench_labels to = {sizeof(to), labels.data(), from.width, from.height, from.width};
    const bool with_labels = source.is_readable() && input_.once_in(2);
    thinbench_regions* regions = nullptr;
    std::int64_t euler = 0;
    const auto connectivity = static_cast<std::int32_t>(input_.once_in(16) ? 6 : 8);
    const bool has_euler =
        is_accepted(thinbench_euler_number(&from, connectivity, execution.pointer(), &euler));
    const auto status = with_labels
                            ? thinbench_label_regions(&from, &to, execution.pointer(), &regions)
                            : thinbench_find_regions(&from, execution.pointer(), &regions);
    if (is_accepted(status) && source.is_readable()) {
      const reference::Regions expected = reference::holes(source.image(0));
      compare_list<thinbench_region>(regions, thinbench_regions_objects, expected.objects);
      compare_list<thinbench_region>(regions, thinbench_regions_holes, expected.holes);
      must(!has_euler || euler == reference::euler_number(source.image(0)), "another Euler number");
    }
    thinbench_regions_destroy(regions);
    regions = nullptr;
    check_status(thinbench_localise_objects(&from, nullptr,
                                            static_cast<std::int32_t>(input_.number(-1, 256)), 128,
                                            execution.pointer(), &regions));
    thinbench_regions_destroy(regions);
  }

  Stack draw_image() {
    Stack source(input_, draw_size(input_));
    if (source.is_safe()) source.draw(input_);
    return source;
  }

  /// Where an image is read, memory for a number per pixel with gaps between rows, and its struct;
  /// or a stride that must be rejected.
  std::vector<std::int32_t> draw_numbers(const Stack& source, thinbench_labels& view) {
    constexpr std::array<Index, 4> rejected = {-1, kMin, kMax / 2, kMax};
    const thinbench_image from = source.described();
    view = {sizeof(view), nullptr, from.width, from.height, 0};
    if (!source.is_readable()) return std::vector<std::int32_t>(1, -7);
    view.stride = from.width + (input_.once_in(3) ? input_.number(1, 9) : 0);
    const auto count = static_cast<std::size_t>((from.height - 1) * view.stride + from.width);
    const bool is_spoiled = input_.once_in(16) && from.height > 4;
    if (is_spoiled) view.stride = input_.pick(rejected);
    return std::vector<std::int32_t>(count, -7);
  }

  void find_distances() {
    const auto execution = draw_execution(input_);
    const Stack source = draw_image();
    if (!source.is_safe()) return;
    const thinbench_image from = source.described();
    thinbench_labels view;
    std::vector<std::int32_t> found = draw_numbers(source, view);
    std::vector<std::int32_t> expected = found;
    view.data = input_.once_in(32) ? nullptr : found.data();
    const bool is_accepted_call =
        is_accepted(thinbench_squared_distances(&from, &view, execution.pointer()));
    if (is_accepted_call && source.is_readable()) {
      must(view.data != nullptr, "NULL was accepted");
      reference::squared_distances(source.image(0),
                                   {expected.data(), from.width, from.height, view.stride});
    }
    must(found == expected, "distances differ");
  }

  static void compare_graph(const thinbench_graph* graph, const ConstImageView& image) {
    const Graph expected = reference::skeleton_graph(image);
    compare_list<thinbench_graph_node>(graph, thinbench_graph_nodes, expected.nodes);
    compare_list<thinbench_graph_edge>(graph, thinbench_graph_edges, expected.edges);
    compare_list<thinbench_pixel>(graph, thinbench_graph_node_pixels, expected.node_pixels);
    compare_list<thinbench_pixel>(graph, thinbench_graph_edge_pixels, expected.edge_pixels);
  }

  void find_graph() {
    const auto execution = draw_execution(input_);
    const Stack source = draw_image();
    if (!source.is_safe()) return;
    const thinbench_image from = source.described();
    thinbench_graph* graph = nullptr;
    const bool is_found = is_accepted(thinbench_skeleton_graph(
        &from, execution.pointer(), input_.once_in(32) ? nullptr : &graph));
    must(is_found == (graph != nullptr), "a handle without a graph");
    if (is_found && source.is_readable()) compare_graph(graph, source.image(0));
    thinbench_graph_destroy(graph);
    std::int64_t blocks = -1;
    thinbench_pixel first = {};
    check_status(thinbench_full_blocks(&from, execution.pointer(),
                                       input_.once_in(32) ? nullptr : &blocks,
                                       input_.once_in(2) ? nullptr : &first));
    const auto bytes =
        source.is_readable() ? static_cast<std::size_t>(from.width * from.height) : 0;
    std::vector<std::uint8_t> classes(bytes);
    std::vector<std::uint8_t> degrees(bytes);
    thinbench_image kinds = from;
    thinbench_image counts = from;
    kinds.data = classes.data();
    counts.data = degrees.data();
    kinds.stride = input_.once_in(16) ? -1 : from.width;
    counts.stride = from.width;
    check_status(thinbench_classify_pixels(&from, input_.once_in(4) ? nullptr : &kinds,
                                           input_.once_in(4) ? nullptr : &counts,
                                           execution.pointer()));
  }

  thinbench_pruning draw_pruning() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr std::array<double, 8> lengths = {0, 1, 2.5, 6, 1e300, -1, infinity, nan};
    constexpr std::array<double, 8> widths = {0, 0, -0.0, 0.5, 2, 1e308, -1, nan};
    thinbench_pruning pruning = THINBENCH_PRUNING_INIT;
    if (input_.once_in(32)) pruning.size = input_.byte() % sizeof(pruning);  // no bytes behind it
    pruning.min_length = input_.pick(lengths);
    pruning.min_widths = input_.pick(widths);
    pruning.removes_components = input_.once_in(2) ? 1 : 0;
    return pruning;
  }

  /// The objects of an image, their graphs and distances, with strides that may not fit.
  void use_labels() {
    const auto execution = draw_execution(input_);
    const Stack source = draw_image();
    if (!source.is_safe()) return;
    const thinbench_image from = source.described();
    thinbench_labels view;
    std::vector<std::int32_t> labels = draw_numbers(source, view);
    view.data = labels.data();
    thinbench_regions* regions = nullptr;
    const char* const orders[] = {"raster", nullptr, "other"};
    const bool is_labelled =
        is_accepted(thinbench_label_objects(&from, &view, input_.once_in(16) ? 5 : 8,
                                            input_.pick(orders), execution.pointer(), &regions));
    thinbench_regions_destroy(regions);
    if (!is_labelled || !source.is_readable()) return;
    std::vector<double> numbers(labels.size());
    thinbench_reals distances = {sizeof(distances), numbers.data(), view.width, view.height,
                                 view.stride};
    if (input_.once_in(16)) distances.data = nullptr;
    check_status(thinbench_distances_of_labels(&view, &distances, nullptr, execution.pointer()));
    distances.data = numbers.data();
    thinbench_pruning pruning = draw_pruning();
    pruning.distances = &distances;
    thinbench_graph* graph = nullptr;
    check_status(thinbench_prune_labels(&view, &view, &pruning, execution.pointer(), &graph));
    split(graph);
    thinbench_graph_destroy(graph);
    thinbench_hole_filling filling = THINBENCH_HOLE_FILLING_INIT;
    filling.connectivity = input_.once_in(16) ? 5 : 4;
    filling.max_area = input_.byte() - 1;
    check_status(thinbench_fill_holes_of_labels(&view, &view, &filling, execution.pointer()));
  }

  /// A graph, or none.
  void split(const thinbench_graph* graph) {
    const thinbench_pixel pixels[] = {{input_.byte(), input_.byte()}, {-1, 0}};
    thinbench_graph* made = nullptr;
    check_status(thinbench_split_graph(graph, pixels, input_.once_in(8) ? 2 : 1, &made));
    thinbench_graph_destroy(made);
  }

  ByteSource& input_;
};

}  // namespace

void try_input(ByteSource& input) {
  Caller(input).run();
}

}  // namespace thinbench
