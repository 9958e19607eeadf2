// Peers: other projects' code for the same work, and lower bounds such as a copy, timed in the same
// run.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

/// What a reader must know to compare.
struct Peer {
  std::string_view technique;
  std::string about;  // version, instruction sets, threads
  /// Whether it gives the very pixels of the operation that it stands beside: only then is the
  /// ratio of the two times a comparison of like with like.
  bool equal_output = false;
};

[[nodiscard]] const std::vector<Peer>& peers();

/// all_operations, each followed by its peers.
[[nodiscard]] const std::vector<Operation>& operations_with_peers();

/// Peers by source file: variants for an operation, none where there are none.
[[nodiscard]] std::vector<Variant> copy_peers(const Operation& operation);
[[nodiscard]] std::vector<Variant> leptonica_peers(const Operation& operation);
[[nodiscard]] std::vector<Variant> opencv_edge_peers(const Operation& operation);
[[nodiscard]] std::vector<Variant> copy_bits_peers(const Operation& operation);
[[nodiscard]] std::vector<Variant> opencv_holes_peers(const Operation& operation);
[[nodiscard]] std::vector<Variant> opencv_labels_peers(const Operation& operation);
[[nodiscard]] std::vector<Variant> opencv_thinning_peers(const Operation& operation);

/// A peer with its technique and its description; runs everywhere, on one thread.
[[nodiscard]] Variant peer_variant(std::string_view technique, std::string_view description,
                                   JobMaker make_job, JobMaker own_reference = {});

/// The same work without the numbers, for peers that give none.
[[nodiscard]] JobMaker image_only(JobMaker make_job);

/// "OpenCV 4.6.0, 1 thread, its own choice of ...".
[[nodiscard]] std::string opencv_description();
[[nodiscard]] std::string leptonica_description();

}  // namespace thinbench
