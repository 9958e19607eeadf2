#include "out_of_core/checkpoint.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "support/content_hash.hpp"
#include "support/json_field.hpp"
#include "support/regular_file.hpp"

namespace thinbench {
namespace {

/// A digit per tile: 1 changed in the last iteration.
std::string text_of(const std::vector<bool>& tiles) {
  std::string text;
  for (const bool unsettled : tiles) text += unsettled ? '1' : '0';
  return text;
}

std::vector<bool> tiles_of(const std::string& text) {
  if (text.find_first_not_of("01") != std::string::npos) throw std::out_of_range("tiles");
  std::vector<bool> tiles;
  for (const char digit : text) tiles.push_back(digit == '1');
  return tiles;
}

[[noreturn]] void cannot_resume(const std::string& path, const std::string& why) {
  throw FileError("cannot resume from '" + path + "': " + why);
}

Index integer_of(const nlohmann::json& value, Index min, Index max) {
  const Index number = value.get_ref<const nlohmann::json::number_integer_t&>();
  if (number < min || number > max) throw std::out_of_range("integer");
  return number;
}

/// Throws for anything that no run writes.
Checkpoint checkpoint_of(const nlohmann::json& state, const CheckpointLimits& limits) {
  Checkpoint checkpoint;
  checkpoint.passes = static_cast<int>(integer_of(state.at("passes"), 1, limits.max_passes));
  checkpoint.foreground_before = integer_of(state.at("foreground_before"), 0, limits.pixels);
  checkpoint.foreground_after =
      integer_of(state.at("foreground_after"), 0, checkpoint.foreground_before);
  checkpoint.unsettled = tiles_of(state.at("tiles").get<std::string>());
  if (std::ssize(checkpoint.unsettled) != limits.tiles) throw std::out_of_range("tiles");
  checkpoint.pixels = state.at("pixels").get<std::string>();
  return checkpoint;
}

std::string checksum_of(const nlohmann::json& state) {
  const std::string text = state.dump();
  return hash_text(hash_of(text.data(), text.size()));
}

/// Without its checksum, which must be right.
nlohmann::json checked_state(const std::string& text) {
  nlohmann::json state = parse_json(text, "the state");
  const auto checksum = state.at("checksum").get<std::string>();
  state.erase("checksum");
  if (checksum != checksum_of(state)) throw std::runtime_error("checksum");
  return state;
}

/// Those of another run may lie out of range.
void check_identity(const nlohmann::json& state, const std::string& path,
                    const std::string& identity) {
  const auto begun = state.at("run").get<std::string>();
  if (begun == identity) return;
  cannot_resume(path, "it belongs to another run (" + begun + "), this is " + identity);
}

}  // namespace

void save_checkpoint(const std::string& path, const std::string& identity,
                     const Checkpoint& checkpoint) {
  nlohmann::json state = {{"run", identity},
                          {"passes", checkpoint.passes},
                          {"foreground_before", checkpoint.foreground_before},
                          {"foreground_after", checkpoint.foreground_after},
                          {"tiles", text_of(checkpoint.unsettled)},
                          {"pixels", checkpoint.pixels}};
  state["checksum"] = checksum_of(state);
  std::ofstream stream(path, std::ios::binary);
  stream << state.dump(1) << '\n';
  stream.close();
  if (!stream) {
    cannot_write_by_errno(path);
  }
}

std::optional<Checkpoint> load_checkpoint(const std::string& path, const std::string& identity,
                                          const CheckpointLimits& limits) {
  constexpr std::size_t max_bytes = 10'000'000'000;
  if (!std::filesystem::exists(path)) return std::nullopt;
  const std::string text = read_whole_file(path, max_bytes);
  try {
    const nlohmann::json state = checked_state(text);
    check_identity(state, path, identity);
    return checkpoint_of(state, limits);
  } catch (const FileError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    cannot_resume(path, "the file is damaged; run without --resume to begin again");
  }
}

}  // namespace thinbench
