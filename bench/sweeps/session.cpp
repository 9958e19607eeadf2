#include "sweeps/session.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <thread>

#include "cli/command.hpp"
#include "machine/machine.hpp"
#include "support/splitmix64.hpp"
#include "support/whole_file.hpp"
#include "sweeps/interrupt.hpp"
#include "sweeps/journal.hpp"
#include "sweeps/options.hpp"
#include "sweeps/sampling.hpp"
#include "timing/progress.hpp"

namespace thinbench {
namespace {

struct Interrupted {};

void stop_if_interrupted() {
  if (was_interrupted()) throw Interrupted();
}

std::vector<Point> planned(const SweepOptions& options, const std::vector<Operation>& operations) {
  const int processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<Point> points;
  try {
    points = plan_points({options.only, options.filter, options.quick, processors}, operations);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--filter: ") + error.what());
  }
  if (points.empty()) throw UsageError("no row to measure; the filter is '" + options.filter + "'");
  return points;
}

nlohmann::json header_of(const SweepOptions& options, const std::vector<Point>& points) {
  const nlohmann::json chosen = {{"only", options.only},
                                 {"filter", options.filter},
                                 {"rounds", options.rounds},
                                 {"quick", options.quick},
                                 {"seed", options.seed}};
  return journal_header(machine_json(options.commit, chosen), points);
}

/// One run over one journal.
class Session {
 public:
  Session(const SweepOptions& options, const std::vector<Point>& points, Journal& journal)
      : options_(options), points_(points), journal_(journal) {}

  /// Proves what was not proved yet; returns how many points are not equal.
  int prove() {
    double pixels = 0;
    for (const Point& point : points_) pixels += work_of(point);
    Progress progress("proving", pixels);
    Prover prover(inputs_);
    int failed = 0;
    for (const Point& point : points_) {
      stop_if_interrupted();
      if (journal_.proof_of(point) == nullptr && !prove(prover, point)) ++failed;
      progress.advance(work_of(point));
    }
    return failed;
  }

  void measure() {
    const int rounds =
        options_.stop_after > 0 ? std::min(options_.stop_after, options_.rounds) : options_.rounds;
    const double expected = expected_of(rounds);
    std::cerr << "measuring " << points_.size() << " points in " << rounds << " rounds, about "
              << std::lround(expected) << " s\n";
    Progress progress("measuring", expected);
    Sampler sampler(inputs_);
    for (int round = 0; round < rounds; ++round) {
      for (const Point* point : order_of_round(
               missing(round), splitmix64(options_.seed, static_cast<std::uint64_t>(round)))) {
        stop_if_interrupted();
        const Proof& proof = *journal_.proof_of(*point);
        journal_.add(*point, sampler.take(*point, proof, round));
        progress.advance(expected_seconds(*point, proof));
      }
    }
  }

 private:
  static double work_of(const Point& point) {
    return 1000 + static_cast<double>(point.input.pixels());
  }

  bool prove(Prover& prover, const Point& point) {
    std::string mismatch;
    const std::optional<Proof> proof = prover.prove(point, mismatch);
    if (proof) {
      journal_.add(point, *proof);
    } else {
      std::cerr << "not equal, not timed: " << mismatch << '\n';
    }
    return proof.has_value();
  }

  /// Points that were proved and have no sample of this round.
  [[nodiscard]] std::vector<const Point*> missing(int round) const {
    std::vector<const Point*> found;
    for (const Point& point : points_) {
      if (journal_.proof_of(point) != nullptr && !journal_.has(point, round)) {
        found.push_back(&point);
      }
    }
    return found;
  }

  [[nodiscard]] double expected_of(int rounds) const {
    double seconds = 0;
    for (int round = 0; round < rounds; ++round) {
      for (const Point* point : missing(round)) {
        seconds += expected_seconds(*point, *journal_.proof_of(*point));
      }
    }
    return seconds;
  }

  const SweepOptions& options_;
  const std::vector<Point>& points_;
  Journal& journal_;
  InputStore inputs_;
};

int run(const SweepOptions& options, const std::vector<Operation>& operations) {
  if (options.out.empty() && options.resume.empty()) {
    throw UsageError("--out FILE or --resume FILE is needed; see 'thinbench_sweeps --help'");
  }
  const std::string& path = options.resume.empty() ? options.out : options.resume;
  const std::vector<Point> points = planned(options, operations);
  const nlohmann::json header = header_of(options, points);
  const InterruptGuard guard;
  Journal journal =
      options.resume.empty() ? Journal::begin(path, header) : Journal::resume(path, header, points);
  Session session(options, points, journal);
  try {
    const int failed = session.prove();
    session.measure();
    return failed == 0 ? kSuccess : kUsage;
  } catch (const Interrupted&) {
    std::cerr << "thinbench_sweeps: interrupted; go on by the same command with --resume '" << path
              << "'" << (options.resume.empty() ? " instead of --out" : "") << '\n';
    return kInterrupted;
  }
}

}  // namespace

int run_sweeps(const std::vector<std::string>& arguments,
               const std::vector<Operation>& operations) {
  try {
    SweepOptions options;
    if (!parse_options(arguments, options)) return kSuccess;
    return run(options, operations);
  } catch (const UsageError& error) {
    std::cerr << "thinbench_sweeps: " << error.what() << '\n';
    return kUsage;
  } catch (const std::exception& error) {
    std::cerr << "thinbench_sweeps: " << error.what() << '\n';
    return kFailure;
  }
}

}  // namespace thinbench
