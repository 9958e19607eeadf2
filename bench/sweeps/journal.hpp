// The journal of a run: JSON lines that are on disk as soon as they are known, so that a run may
// end at any time and go on later.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sweeps/proof.hpp"

namespace thinbench {

/// The first line: what the run does, where and with what.
[[nodiscard]] nlohmann::json journal_header(const nlohmann::json& machine,
                                            const std::vector<Point>& points);

/// All calls of a sample together took `ns` nanoseconds.
struct Sample {
  int round = 0;
  std::int64_t ns = 0;
  std::int64_t calls = 0;
};

/// Lines after the header are {"kind": "proof"} or {"kind": "sample"}, each with the place of its
/// point.
class Journal {
 public:
  /// A new file. Throws FileError where one is there or none can be made.
  static Journal begin(const std::string& path, const nlohmann::json& header);
  /// Goes on with a file; a last line that was cut off is dropped from it. Throws FileError where
  /// the header says something else than `header`, but for the date, or a line is damaged.
  static Journal resume(const std::string& path, const nlohmann::json& header,
                        const std::vector<Point>& points);

  ~Journal();
  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  void add(const Point& point, const Proof& proof);
  void add(const Point& point, const Sample& sample);

  /// nullptr where the point was not proved yet.
  [[nodiscard]] const Proof* proof_of(const Point& point) const;
  [[nodiscard]] bool has(const Point& point, int round) const;

 private:
  Journal(std::string path, int descriptor);
  [[nodiscard]] static Journal opened(const std::string& path, int flags);

  void append(const nlohmann::json& line);
  void read_back(const std::string& text, const std::map<std::string, const Point*>& points);
  /// Takes over what a line says; false where it is none of this run's.
  [[nodiscard]] bool take(const nlohmann::json& line,
                          const std::map<std::string, const Point*>& points);

  std::string path_;
  int descriptor_;
  std::map<std::string, Proof> proofs_;
  std::map<std::string, std::set<int>> rounds_;
};

}  // namespace thinbench
