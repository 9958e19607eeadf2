#include "counts/counted_job.hpp"

#include <limits>
#include <stdexcept>

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

}  // namespace thinbench
