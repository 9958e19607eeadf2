#include "batch/pipeline.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "core/startable_threads.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "support/progress.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

/// The images under way for each thread: more than one, so that a large image delays no other.
constexpr std::size_t kJobsPerThread = 4;

struct Page {
  BatchRecord record;
  GreyImage grey;
  BatchResult result;
};

/// A job on its way.
struct Work {
  const BatchJob* job = nullptr;
  std::vector<Page> pages;
  std::string error;
};

/// Adds the time until it ends.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::size_t pages_of(const std::vector<BatchJob>& jobs) {
  std::size_t pages = 0;
  for (const BatchJob& job : jobs) pages += job.pages.size();
  return pages;
}

class Batch {
 public:
  Batch(const std::vector<BatchJob>& jobs, const BatchOperation& operation,
        const BatchSettings& settings, Manifest& manifest)
      : jobs_(jobs),
        operation_(operation),
        settings_(settings),
        manifest_(manifest),
        computes_(operation.make),
        progress_(one_line(operation.name), static_cast<double>(pages_of(jobs)), "images") {}

  BatchTotals run() {
    const int arena_size = detail::startable_threads(settings_.threads);
    const auto threads = static_cast<std::size_t>(arena_size);
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
    works_.resize(kJobsPerThread * threads);
    tbb::task_arena(arena_size).execute([&] {
      tbb::parallel_pipeline(works_.size(), all_stages());
    });
    totals_.not_started = jobs_.size() - next_;
    return std::move(totals_);
  }

 private:
  tbb::filter<void, void> all_stages() {
    using tbb::filter_mode;
    const auto stage = [this](void (Batch::*step)(Work&)) {
      return tbb::make_filter<Work*, Work*>(filter_mode::parallel, [this, step](Work* work) {
        attempt(*work, step);
        return work;
      });
    };
    return tbb::make_filter<void, Work*>(
               filter_mode::serial_in_order,
               [this](tbb::flow_control& control) { return next(control); }) &
           stage(&Batch::decode) & stage(&Batch::compute) & stage(&Batch::encode) &
           tbb::make_filter<Work*, void>(filter_mode::serial_in_order,
                                         [this](const Work* work) { record(*work); });
  }

  /// Places are free again in the order in which they were taken: the last stage is in order, too.
  Work* next(tbb::flow_control& control) {
    if (next_ == jobs_.size() || stops_) {
      control.stop();
      return nullptr;
    }
    Work& work = works_[next_ % works_.size()];
    const BatchJob& job = jobs_[next_++];
    work = {&job, std::vector<Page>(job.pages.size()), {}};
    for (std::size_t i = 0; i < job.pages.size(); ++i) {
      BatchRecord& record = work.pages[i].record;
      record.file = job.path;
      record.page = job.pages[i] + 1;
      record.output = job.output;
      record.operation = operation_.name;
    }
    return &work;
  }

  /// A failed job skips its remaining stages.
  void attempt(Work& work, void (Batch::*step)(Work&)) {
    if (!work.error.empty()) return;
    try {
      (this->*step)(work);
      return;
    } catch (const std::bad_alloc&) {
      work.error = "there is not enough memory for '" + work.job->path + "'";
    } catch (const std::exception& error) {
      work.error = error.what();
    }
    for (Page& page : work.pages) page = {std::move(page.record), {}, {}};  // frees memory
    if (settings_.stops_on_error) stops_ = true;
  }

  void decode(Work& work) {
    for (Page& page : work.pages) {
      const Stopwatch stopwatch(page.record.decode_seconds);
      const BatchJob& job = *work.job;
      GreyFile file = read_grey_file(read_file(job.path), page.record.page - 1, settings_.reading);
      page.grey = std::move(file.grey);
      page.record.warning = std::move(file.warning);
      page.record.width = page.grey.width;
      page.record.height = page.grey.height;
    }
  }

  void compute(Work& work) {
    BatchCompute& compute_page = computes_.local();
    for (Page& page : work.pages) {
      const Stopwatch stopwatch(page.record.compute_seconds);
      try {
        page.result = compute_page(std::move(page.grey), page.record);
      } catch (const std::invalid_argument& error) {
        throw std::runtime_error("cannot process '" + work.job->path + "': " + error.what());
      }
    }
  }

  void encode(Work& work) {
    const Stopwatch stopwatch(work.pages.front().record.encode_seconds);
    const std::filesystem::path out = settings_.out;
    const std::string path = out / work.job->output;
    const BatchResult& first = work.pages.front().result;
    if (!work.job->overlay.empty()) {
      write_overlay(out / work.job->overlay, first.ground.view(), first.overlay);
    }
    if (first.image.width() == 0) {
      write_whole_file(path, first.text);
    } else if (work.pages.size() == 1) {
      write_binary(path, first.image.view());
    } else {
      std::vector<ByteImage> images;
      for (Page& page : work.pages) images.push_back(std::move(page.result.image));
      write_grey_pages(path, images);
    }
    for (Page& page : work.pages) page.result = {};  // waits without its image
  }

  void record(const Work& work) {
    for (const Page& page : work.pages) {
      BatchRecord record = page.record;
      record.error = work.error;
      manifest_.append(record);
      totals_.decode_seconds += record.decode_seconds;
      totals_.compute_seconds += record.compute_seconds;
      totals_.encode_seconds += record.encode_seconds;
      if (!record.warning.empty()) ++totals_.with_warning;
      if (record.error.empty()) ++totals_.done;
    }
    if (!work.error.empty()) totals_.failures.push_back(work.error);
    progress_.advance(static_cast<double>(work.pages.size()));
  }

  const std::vector<BatchJob>& jobs_;
  const BatchOperation& operation_;
  const BatchSettings& settings_;
  Manifest& manifest_;
  tbb::enumerable_thread_specific<BatchCompute> computes_;
  Progress progress_;
  std::vector<Work> works_;  // on their way; oneTBB loses what it would own when a stage throws
  std::size_t next_ = 0;
  std::atomic<bool> stops_ = false;
  BatchTotals totals_;
};

}  // namespace

BatchTotals run_jobs(const std::vector<BatchJob>& jobs, const BatchOperation& operation,
                     const BatchSettings& settings, Manifest& manifest) {
  return Batch(jobs, operation, settings, manifest).run();
}

}  // namespace thinbench
