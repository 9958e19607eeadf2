// Every variant of every operation against its reference, on images of any size at any place in
// memory, in place where that is allowed, with every border and several limits and thresholds.

#include "drawn_image.hpp"
#include "harness/families.hpp"

namespace thinbench {
namespace {

void append(std::vector<Operation>& all, std::vector<Operation> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

/// Custom rules have a target of their own.
std::vector<Operation> make_operations() {
  std::vector<Operation> all;
  for (const detail::ThinningOperation& operation : detail::study::thinning_operations()) {
    for (const Border border : {Border::background, Border::keep, Border::foreground}) {
      if (border == Border::foreground && operation.key.sub_iterations().empty()) continue;
      for (const int limit : {kUnlimited, 1, 2, 5}) {
        all.push_back(thinning_operation(operation, {border, limit}));
      }
    }
  }
  for (const detail::EdgeOperation& operation : detail::study::edge_operations()) {
    for (const EdgeThresholds& thresholds :
         {EdgeThresholds{}, {0, 0}, {255, 255}, {1, 254}, {200, 10}, {40, 0}, {0, 128}}) {
      all.push_back(edges_operation(operation, thresholds));
    }
  }
  append(all, midpoint_family());
  append(all, regions_family());
  append(all, localise_family());
  append(all, distance_family());
  append(all, graph_family());
  append(all, batch_family());
  return all;
}

/// The result of a job, if it has an image, at another place in memory or in that of the input.
void check_job(ByteSource& input, const Operation& operation, Job& job, const ByteImage& image,
               const std::string& name) {
  const Outcome expected = expected_of(operation, operation.variants.front(), image.view());
  DrawnPair images(input, image.view(), operation.takes == InputKind::binary);
  if (input.once_in(4)) {
    job.run(ByteImage(image.width(), image.height()).view(), images.destination.view());
  }
  job.run(images.source.view(), images.to());
  if (job.gives_image()) must_be_equal(images.to(), expected.image.view(), name);
  must(job.numbers() == expected.numbers, name + ": other numbers than the reference");
  must(images.in_place || equal(images.source.view(), image.view()),
       name + ": the input was changed");
  images.must_be_intact();
}

}  // namespace

void try_input(ByteSource& input) {
  static const std::vector<Operation> operations = make_operations();
  const Operation& operation =
      operations[static_cast<std::size_t>(input.number(0, std::ssize(operations) - 1))];
  const Variant& variant =
      operation
          .variants[static_cast<std::size_t>(input.number(0, std::ssize(operation.variants) - 1))];
  const DrawnSize size = draw_size(input);
  const int threads = variant.threaded && input.once_in(32) ? 2 : 1;
  if (!variant.unavailable_reason(size.width).empty()) return;
  const bool is_grey = operation.takes == InputKind::grey;
  const auto job = variant.make_job(size.width, size.height, threads);
  const ByteImage image = is_grey ? draw_grey(input, size) : draw_binary(input, size);
  check_job(input, operation, *job, image,
            row_name(operation.name, variant.technique, variant.isa_label(), threads));
}

}  // namespace thinbench
