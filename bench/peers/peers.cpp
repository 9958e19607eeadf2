#include "peers/peers.hpp"

#include <utility>

#include <opencv2/core.hpp>

#include "harness/library_operation.hpp"

namespace thinbench {
namespace {

using PeersOf = std::vector<Variant> (*)(const Operation&);

constexpr PeersOf kAllPeers[] = {&copy_peers,         &opencv_edge_peers,   &copy_bits_peers,
                                 &opencv_holes_peers, &opencv_labels_peers, &opencv_thinning_peers,
                                 &leptonica_peers};

}  // namespace

const std::vector<Peer>& peers() {
  static const std::vector<Peer> all = {
      {"copy", "the input's bytes copied to the output: a lower bound for every operation"},
      {"opencv", opencv_description() + "; the whole operation, equal in every pixel", true},
      {"opencv_gradient", opencv_description() + "; does less: no brightness threshold"},
      {"copy_bits", "the packed words copied: a lower bound for work on packed images"},
      {"read_bits", "the packed words read: a lower bound for work that gives numbers"},
      {"opencv_contours", opencv_description() + "; areas and centres of polygons, not of pixels"},
      {"opencv_stats", opencv_description() + "; does less: no holes"},
      {"opencv_components", opencv_description() + "; labels objects, counts no holes"},
      {"opencv_spaghetti", opencv_description() + "; the default; its own numbers"},
      {"opencv_bbdt", opencv_description() + "; its own numbers"},
      {"opencv_sauf", opencv_description() + "; its own numbers"},
      {"leptonica_4", leptonica_description()},
      {"leptonica_8", leptonica_description()}};
  return all;
}

const std::vector<Operation>& operations_with_peers() {
  static const std::vector<Operation> operations = [] {
    cv::setNumThreads(1);
    std::vector<Operation> all = all_operations();
    for (Operation& operation : all) {
      for (const PeersOf peers_of : kAllPeers) {
        for (Variant& peer : peers_of(operation)) operation.variants.push_back(std::move(peer));
      }
    }
    return all;
  }();
  return operations;
}

Variant peer_variant(std::string_view technique, std::string_view description, JobMaker make_job,
                     JobMaker own_reference) {
  Variant variant = {
      technique, description, Isa::baseline, false, false, std::move(make_job), [](Index) {
        return std::string();
      }};
  variant.is_peer = true;
  variant.own_reference = std::move(own_reference);
  return variant;
}

JobMaker image_only(JobMaker make_job) {
  return [make_job = std::move(make_job)](Index width, Index height, int threads) {
    return function_job<NoNumbers>(
        width, height,
        [job = make_job(width, height, threads)](const auto& input, const auto& output, auto&) {
          job->run(input, output);
        });
  };
}

}  // namespace thinbench
