#include "counts/counted_job.hpp"

#include <limits>
#include <stdexcept>

#include "harness/operation.hpp"

namespace thinbench {
namespace {

void write_pixels(std::ostream& stream, const ConstImageView& image) {
  for (Index y = 0; y < image.height; ++y) {
    stream.write(reinterpret_cast<const char*>(image.row(y)), image.width);
  }
}

ByteImage read_pixels(std::istream& stream, Index width, Index height) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    stream.read(reinterpret_cast<char*>(image.view().row(y)), width);
  }
  return image;
}

/// "case/technique/isa/threads/", with which the name of a row begins.
std::string start_of(const Operation& operation, const Variant& variant) {
  return row_name(operation.name, variant.technique, variant.isa_label(), 1) + "/";
}

}  // namespace

void write_job(std::ostream& stream, const TimedInput& input,
               const std::vector<std::string>& rows) {
  stream << input.width() << ' ' << input.height() << ' ' << rows.size() << '\n'
         << input.name << '\n';
  for (const std::string& row : rows) stream << row << '\n';
  write_pixels(stream, input.binary.view());
  write_pixels(stream, input.grey.view());
}

CountedJob read_job(std::istream& stream) {
  Index width = 0;
  Index height = 0;
  std::size_t count = 0;
  stream >> width >> height >> count;
  stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  CountedJob job{};
  std::getline(stream, job.input.name);
  std::string row;
  while (job.rows.size() < count && std::getline(stream, row)) job.rows.push_back(row);
  if (stream) {
    job.input.binary = read_pixels(stream, width, height);
    job.input.grey = read_pixels(stream, width, height);
  }
  if (!stream) throw std::runtime_error("standard input holds no whole job");
  return job;
}

TimedRow row_named(const std::string& name, const TimedInput& input) {
  for (const Operation& operation : all_operations()) {
    for (const Variant& variant : operation.variants) {
      const std::string start = start_of(operation, variant);
      if (variant.threaded || !name.starts_with(start)) continue;
      if (!variant.unavailable_reason(input.width()).empty()) continue;
      const bool is_kernel = name.compare(start.size(), 7, "kernel/") == 0;
      return {name,   &operation, &variant, 1, is_kernel ? Scope::kernel : Scope::end_to_end,
              &input, {}};
    }
  }
  throw std::runtime_error("there is no row '" + name + "' here");
}

}  // namespace thinbench
