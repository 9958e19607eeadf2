#include "sweeps/journal.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "harness/case_json.hpp"
#include "support/whole_file.hpp"
#include "timing/inputs.hpp"

namespace thinbench {
namespace {

using nlohmann::json;
using PointsByKey = std::map<std::string, const Point*>;

constexpr int kSchema = 1;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw FileError("'" + path + "' " + why);
}

/// What identifies a point, as its lines have it.
json place_of(const Point& point) {
  json place = case_json<json>(*point.operation);
  place.update({{"sweep", point.sweep},
                {"x", point.x},
                {"y", point.y ? json(*point.y) : json()},
                {"technique", point.variant->technique},
                {"isa", point.variant->isa_label()},
                {"threads", point.threads}});
  return place;
}

std::string key_of(const json& line) {
  std::string key;
  for (const char* name : {"sweep", "x", "y", "case", "technique", "isa", "threads"}) {
    key += line.at(name).dump() + " ";
  }
  return key;
}

std::string key_of(const Point& point) {
  return key_of(place_of(point));
}

/// Names the points as a whole: input images and clocks, too.
std::string hash_of_points(const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points) text += point.name() + "\n";
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
  const auto size = static_cast<Index>(text.size());
  return pixel_hash({bytes, size, 1, size});
}

/// What is not the same on a later day, though nothing changed.
json lasting(json header) {
  header.at("machine").erase("date");
  return header;
}

/// "machine/commit is "a" there and "b" here", for a field that differs; of machine and options
/// where these do, since other options mean other points.
std::string first_difference(const json& there, const json& here) {
  const json changes = json::diff(there, here);
  json change = changes.front();
  for (const json& other : changes) {
    if (other.at("path").get<std::string>().starts_with("/machine")) change = other;
  }
  const json::json_pointer place(change.at("path").get<std::string>());
  const auto value = [&](const json& header) {
    return header.contains(place) ? header.at(place).dump() : std::string("missing");
  };
  return place.to_string().substr(1) + " is " + value(there) + " there and " + value(here) +
         " here";
}

std::string bytes_of_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void check_header(const std::string& path, const std::string& line, const json& header) {
  const json found = json::parse(line, nullptr, false);
  const bool is_header = found.is_object() && found.contains("kind") &&
                         found.at("kind") == "header" && found.contains("machine") &&
                         found.at("machine").is_object();
  if (!is_header) {
    refuse(path, "is no journal of sweeps: its first line is no header");
  }
  const json there = lasting(found);
  const json here = lasting(header);
  if (there != here) {
    refuse(path, "is of another run: " + first_difference(there, here) +
                     "; resume it as it was begun, or begin another file");
  }
}

}  // namespace

json journal_header(const json& machine, const std::vector<Point>& points) {
  return {{"kind", "header"},
          {"schema", kSchema},
          {"machine", machine},
          {"points", points.size()},
          {"definition", hash_of_points(points)}};
}

Journal::Journal(std::string path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

Journal::Journal(Journal&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      proofs_(std::move(other.proofs_)),
      rounds_(std::move(other.rounds_)) {}

Journal::~Journal() {
  if (descriptor_ >= 0) close(descriptor_);
}

Journal Journal::opened(const std::string& path, int flags) {
  constexpr mode_t readable_and_writable = 0666;  // less what the user's umask takes away
  const int descriptor =
      open(path.c_str(), flags | O_WRONLY | O_APPEND | O_CLOEXEC, readable_and_writable);
  if (descriptor < 0) refuse(path, std::string("cannot be opened: ") + std::strerror(errno));
  Journal journal(path, descriptor);
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    refuse(path, "is being written by another process");
  return journal;
}

Journal Journal::begin(const std::string& path, const json& header) {
  if (access(path.c_str(), F_OK) == 0) {
    refuse(path, "is there already: go on with it by --resume, or choose another name");
  }
  check_target(path);
  Journal journal = opened(path, O_CREAT | O_EXCL);
  journal.append(header);
  return journal;
}

Journal Journal::resume(const std::string& path, const json& header,
                        const std::vector<Point>& points) {
  Journal journal = opened(path, 0);
  std::string text = bytes_of_file(path);
  text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  check_header(path, text.substr(0, text.find('\n')), header);
  if (ftruncate(journal.descriptor_, static_cast<off_t>(text.size())) != 0) {
    refuse(path, std::string("cannot be written: ") + std::strerror(errno));
  }
  PointsByKey by_key;
  for (const Point& point : points) by_key.emplace(key_of(point), &point);
  journal.read_back(text, by_key);
  return journal;
}

void Journal::read_back(const std::string& text, const PointsByKey& points) {
  int number = 2;
  for (std::size_t begin = text.find('\n') + 1; begin < text.size(); ++number) {
    const std::size_t end = text.find('\n', begin);
    const json line = json::parse(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                  text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    bool good = false;
    try {
      good = take(line, points);
    } catch (const json::exception&) {
      good = false;
    }
    if (!good) refuse(path_, "is damaged: line " + std::to_string(number) + " is none of this run");
    begin = end + 1;
  }
}

bool Journal::take(const json& line, const PointsByKey& points) {
  const std::string key = key_of(line);
  if (!points.contains(key)) return false;
  if (line.at("kind") == "proof") {
    const Proof proof{line.at("against"), line.at("hash"), line.at("seconds")};
    return proofs_.emplace(key, proof).second;
  }
  return line.at("kind") == "sample" && rounds_[key].insert(line.at("round").get<int>()).second;
}

void Journal::append(const json& line) {
  const std::string text = line.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  const auto size = static_cast<ssize_t>(text.size());
  ssize_t written = -1;
  do {
    written = write(descriptor_, text.data(), text.size());
  } while (written < 0 && errno == EINTR);
  if (written == size) return;
  const char* why = written < 0 ? std::strerror(errno) : "no space left";
  refuse(path_, std::string("cannot be written: ") + why);
}

void Journal::add(const Point& point, const Proof& proof) {
  json line = place_of(point);
  line.update({{"kind", "proof"},
               {"input", point.input.name()},
               {"pixels", point.input.pixels()},
               {"against", proof.against},
               {"hash", proof.hash},
               {"seconds", proof.seconds}});
  append(line);
  proofs_.emplace(key_of(point), proof);
}

void Journal::add(const Point& point, const Sample& sample) {
  json line = place_of(point);
  line.update({{"kind", "sample"},
               {"pixels", point.input.pixels()},
               {"proved_against", proof_of(point)->against},
               {"clock", point.clock()},
               {"round", sample.round},
               {"calls", sample.calls},
               {"ns", sample.ns}});
  append(line);
  rounds_[key_of(point)].insert(sample.round);
}

const Proof* Journal::proof_of(const Point& point) const {
  const auto found = proofs_.find(key_of(point));
  return found == proofs_.end() ? nullptr : &found->second;
}

bool Journal::has(const Point& point, int round) const {
  const auto found = rounds_.find(key_of(point));
  return found != rounds_.end() && found->second.contains(round);
}

}  // namespace thinbench
