#include "measure/known_rows.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "harness/splitmix64.hpp"
#include "measure/timed_call.hpp"
#include "peers/peers.hpp"
#include "support/content_hash.hpp"
#include "support/file_bytes.hpp"
#include "support/progress.hpp"

namespace thinbench {

using Json = nlohmann::ordered_json;

namespace {

/// What a call is taken for that the clock does not see.
constexpr double kMinSeconds = 1e-9;

int more_calls(double seconds) {
  constexpr double kLongerThanInterruptions = 0.1;
  constexpr double kEnough = 0.001;
  if (seconds > kLongerThanInterruptions) return 0;
  return static_cast<int>(std::clamp(kEnough / seconds, 1.0, 100.0));
}

template <class Number>
Json or_null(const std::optional<Number>& number) {
  return number ? Json(*number) : Json();
}

Json sources_json(const InputChoice& choice) {
  return {{"pictures", choice.pictures},
          {"drawn", choice.drawn},
          {"foreground", foreground_name(choice.binarise.foreground)},
          {"threshold", or_null(choice.binarise.threshold)}};
}

InputChoice sources_of(const Json& sources) {
  InputChoice choice;
  sources.at("pictures").get_to(choice.pictures);
  sources.at("drawn").get_to(choice.drawn);
  const auto foreground = foreground_from_name(sources.at("foreground").get<std::string>());
  choice.binarise.foreground = foreground.value_or(Foreground::automatic);
  if (!sources.at("threshold").is_null()) {
    choice.binarise.threshold = sources.at("threshold").get<int>();
  }
  return choice;
}

Json known_json(const KnownRow& known) {
  const TimedRow& row = known.row;
  const bool is_reference = row.variant == nullptr;
  Json object = row_json(row);
  object.update(
      {{"iterations", or_null(row.iterations)},
       {"peer", row.is_peer()},
       {"default", !is_reference && is_default(*row.operation, *row.variant, row.input->width())},
       {"scalar", is_reference || (!row.is_peer() && is_scalar(*row.variant))},
       {"seconds", known.seconds},
       {"hash", known.hash}});
  return object;
}

Json peers_json(const std::vector<KnownRow>& rows) {
  std::set<std::string_view> techniques;
  for (const KnownRow& known : rows) {
    if (known.row.is_peer()) techniques.insert(known.row.variant->technique);
  }
  Json list = Json::array();
  for (const Peer& peer : peers()) {
    if (techniques.count(peer.technique) == 0) continue;
    list.push_back({{"technique", peer.technique},
                    {"about", peer.about},
                    {"equal_output", peer.equal_output}});
  }
  return list;
}

}  // namespace

Json input_json(const TimedInput& input) {
  return {{"name", input.name},
          {"width", input.width()},
          {"height", input.height()},
          {"hash", hash_text(pixel_hash(input.binary.view()))},
          {"grey_hash", hash_text(pixel_hash(input.grey.view()))}};
}

Json row_json(const TimedRow& row) {
  const Operation& operation = *row.operation;
  const std::string_view plain = operation.operation;
  return {{"case", operation.name},
          {"operation", plain.empty() ? operation.name : plain},
          {"border", operation.border ? border_name(*operation.border) : ""},
          {"max_iterations", or_null(operation.max_iterations)},
          {"technique", row.variant == nullptr ? "reference" : row.variant->technique},
          {"isa", row.variant == nullptr ? "baseline" : row.variant->isa_label()},
          {"threads", row.threads},
          {"scope", scope_name(row.scope)},
          {"input", row.input->name}};
}

std::string hash_of(const Outcome& outcome) {
  std::uint64_t hash = pixel_hash(outcome.image.view());
  for (const std::int64_t number : outcome.numbers) {
    hash = splitmix64(hash ^ static_cast<std::uint64_t>(number));
  }
  return hash_text(hash);
}

/// The minimum counts: an interrupted call would make repetitions of too few calls. The first call
/// also touches every page.
KnownRow calibrate(const TimedRow& row) {
  TimedCall call(row);
  const auto timed = [&] {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  double seconds = timed();
  for (int i = more_calls(seconds); i > 0; --i) seconds = std::min(seconds, timed());
  return {row, std::max(seconds, kMinSeconds), hash_of(call.outcome())};
}

std::vector<KnownRow> calibrate_rows(Selection& selection, double max_seconds) {
  std::ostringstream reason;
  reason << "a call takes more than " << max_seconds << " s";
  std::vector<KnownRow> rows;
  Progress progress("calibrating", static_cast<double>(selection.rows.size()));
  for (const TimedRow& row : selection.rows) {
    KnownRow known = calibrate(row);
    if (known.seconds > max_seconds) {
      selection.skipped.push_back({row.name, reason.str()});
    } else {
      rows.push_back(std::move(known));
    }
    progress.advance(1);
  }
  return rows;
}

Json facts_json(const InputChoice& sources, const std::vector<TimedInput>& inputs,
                const Selection& selection, const std::vector<KnownRow>& rows) {
  Json facts = {{"sources", sources_json(sources)},  {"inputs", Json::array()},
                {"peers", peers_json(rows)},         {"rows", Json::object()},
                {"skipped", Json::array()},          {"verified", selection.verified},
                {"mismatches", selection.mismatches}};
  for (const TimedInput& input : inputs) {
    facts["inputs"].push_back(input_json(input));
    facts["inputs"].back()["foreground_pixels"] = foreground_pixels(input.binary.view());
  }
  for (const KnownRow& known : rows) facts["rows"][known.row.name] = known_json(known);
  for (const SkippedRow& row : selection.skipped) {
    facts["skipped"].push_back({{"row", row.name}, {"reason", row.reason}});
  }
  return facts;
}

Known::Known(const std::string& file, const std::vector<Operation>& operations) {
  constexpr std::size_t kMaxBytes = 1'000'000'000;
  try {
    const Json facts = Json::parse(read_file(file, kMaxBytes).text());
    inputs = timed_inputs(sources_of(facts.at("sources")));
    for (const auto& [name, row] : facts.at("rows").items()) {
      rows.push_back({row_named(name, operations, inputs),
                      std::max(row.at("seconds").get<double>(), kMinSeconds),
                      row.at("hash").get<std::string>()});
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file + ": holds no facts: " + error.what());
  }
}

}  // namespace thinbench
