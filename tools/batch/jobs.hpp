// What a batch has to do: for each result the input and the name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "batch/inputs.hpp"

namespace thinbench {

/// One result. Pages count from 0.
struct BatchJob {
  std::string path;
  std::string output;   // relative to the output directory
  std::string overlay;  // the same; empty: none
  std::vector<int> pages = {0};
};

struct Shard {
  std::size_t number = 1;  // from 1
  std::size_t count = 1;
};

/// Extensions of results, with their dots.
struct ResultExtensions {
  std::string output;
  std::string overlay;  // empty: none
};

/// The results of all inputs. A file of several pages has one result per page, NAME_page1 and so
/// on, or one for all where `joins_pages`.
[[nodiscard]] std::vector<std::vector<BatchJob>> jobs_of(const std::vector<BatchInput>& inputs,
                                                         const ResultExtensions& extensions,
                                                         bool joins_pages);

/// Takes out what cannot be done and returns why, a line each: what would have the result of an
/// input before it, or would replace an input, or has a name that `check` rejects by an exception.
[[nodiscard]] std::vector<std::string> remove_impossible(
    std::vector<std::vector<BatchJob>>& jobs, const std::string& out,
    const std::function<void(const std::string& path)>& check);

/// Those of every count-th input, from the shard's number on.
[[nodiscard]] std::vector<BatchJob> jobs_in(const std::vector<std::vector<BatchJob>>& jobs,
                                            const Shard& shard);

/// Makes the directories of all results and removes what killed runs left in them. Throws FileError
/// where `out` cannot be made.
void make_directories(const std::vector<BatchJob>& jobs, const std::string& out);

/// Removes those of them that are empty.
void remove_empty_directories(const std::vector<BatchJob>& jobs, const std::string& out);

}  // namespace thinbench
