#include "out_of_core/checkpoint.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "support/regular_file.hpp"

namespace thinbench {
namespace {

/// A digit per tile: 0 unchanged, 1 changed, 3 changed in the last iteration, too.
std::string text_of(const std::vector<TileState>& tiles) {
  std::string text;
  for (const TileState& tile : tiles) text += !tile.changed ? '0' : tile.unsettled ? '3' : '1';
  return text;
}

std::vector<TileState> tiles_of(const std::string& text) {
  std::vector<TileState> tiles;
  for (const char digit : text) tiles.push_back({digit != '0', digit == '3'});
  return tiles;
}

[[noreturn]] void cannot_resume(const std::string& path, const std::string& why) {
  throw FileError("cannot resume from '" + path + "': " + why);
}

/// Throws nlohmann::json::exception for anything else than an integer.
Index integer_of(const nlohmann::json& value) {
  return value.get_ref<const nlohmann::json::number_integer_t&>();
}

Checkpoint checkpoint_of(const nlohmann::json& json) {
  return {static_cast<int>(integer_of(json.at("passes"))),
          static_cast<int>(integer_of(json.at("iterations"))),
          integer_of(json.at("foreground_before")), integer_of(json.at("foreground_after")),
          tiles_of(json.at("tiles").get<std::string>())};
}

}  // namespace

void save_checkpoint(const std::string& path, const std::string& identity,
                     const Checkpoint& checkpoint) {
  const nlohmann::json json = {{"run", identity},
                               {"passes", checkpoint.passes},
                               {"iterations", checkpoint.iterations},
                               {"foreground_before", checkpoint.foreground_before},
                               {"foreground_after", checkpoint.foreground_after},
                               {"tiles", text_of(checkpoint.tiles)}};
  std::ofstream stream(path, std::ios::binary);
  stream << json.dump(1) << '\n';
  stream.close();
  if (!stream) {
    cannot_write_by_errno(path);
  }
}

std::optional<Checkpoint> load_checkpoint(const std::string& path, const std::string& identity,
                                          Index tiles) {
  constexpr std::size_t max_bytes = 10'000'000'000;
  if (!std::filesystem::exists(path)) return std::nullopt;
  try {
    const nlohmann::json json = nlohmann::json::parse(read_whole_file(path, max_bytes));
    const auto begun = json.at("run").get<std::string>();
    if (begun != identity) {
      cannot_resume(path, "it belongs to another run (" + begun + "), this is " + identity);
    }
    Checkpoint checkpoint = checkpoint_of(json);
    if (static_cast<Index>(checkpoint.tiles.size()) == tiles) return checkpoint;
  } catch (const nlohmann::json::exception&) {
  }
  cannot_resume(path, "the file is damaged");
}

}  // namespace thinbench
