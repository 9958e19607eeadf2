// JSON as text, and values of a JSON file with errors that name the file and the way to the value.
// For sources that link nlohmann_json.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace thinbench {

/// A value as at most 60 characters of ASCII.
inline std::string shown(const nlohmann::json& value) {
  return value.dump(-1, ' ', true).substr(0, 60);
}

/// Whole numbers without a point.
inline nlohmann::ordered_json json_number(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  if (static_cast<double>(whole) == value) return whole;
  return value;
}

// As texts that end with a newline: indented, or one line. What is no UTF-8 is replaced.

inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}
inline std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

/// A value in the file and the way to it, such as hidden[3].bias. Errors are std::runtime_error
/// with one line: "weights.json: hidden[3].weights has 7 numbers; it must have 8".
class JsonField {
 public:
  using Json = nlohmann::json;

  JsonField(const Json& json, const std::string& file, std::string name)
      : json_(json), file_(file), name_(std::move(name)) {}

  [[nodiscard]] const Json& json() const { return json_; }
  [[nodiscard]] bool has(const std::string& key) const { return json_.contains(key); }

  [[nodiscard]] JsonField member(const std::string& key) const {
    if (!json_.is_object()) fail("must be an object");
    JsonField found(has(key) ? json_.at(key) : json_, file_,
                    name_.empty() ? key : name_ + "." + key);
    if (!has(key)) found.fail("is missing");
    return found;
  }

  [[nodiscard]] JsonField element(std::size_t i) const {
    return {json_.at(i), file_, name_ + "[" + std::to_string(i) + "]"};
  }

  /// The number of elements, which must lie between the two.
  [[nodiscard]] std::size_t count(std::size_t min, std::size_t max, const char* what) const {
    if (!json_.is_array()) fail("must be a list");
    const std::size_t size = json_.size();
    if (size >= min && size <= max) return size;
    const std::string range =
        min == max ? std::to_string(max) : std::to_string(min) + " to " + std::to_string(max);
    fail("has " + std::to_string(size) + " " + what + "; it must have " + range);
  }

  [[nodiscard]] std::int64_t integer() const {
    if (!json_.is_number_integer()) fail("must be an integer");
    if (json_.is_number_unsigned() && json_.get<std::uint64_t>() > INT64_MAX) fail("is too large");
    return json_.get<std::int64_t>();
  }

  [[nodiscard]] std::string text() const {
    if (!json_.is_string()) fail("must be a text");
    return json_.get<std::string>();
  }

  /// The value must be an object without other keys.
  void allow_only(std::initializer_list<std::string_view> keys) const {
    if (!json_.is_object()) fail("must be an object");
    for (const auto& item : json_.items()) {
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end()) {
        fail("has the unknown key " + shown(item.key()));
      }
    }
  }

  [[noreturn]] void fail(const std::string& problem) const {
    const std::string field = name_.empty() ? "the outermost value" : name_;
    throw std::runtime_error(file_ + ": " + field + " " + problem);
  }

 private:
  const Json& json_;
  const std::string& file_;
  std::string name_;
};

/// Of files of rules and weights.
inline constexpr std::size_t kMaxJsonBytes = 1'000'000;

/// Of objects and lists within each other: nlohmann_json copies and prints them by recursion.
inline constexpr int kMaxJsonDepth = 16;

/// JSON of a text; `name` stands for the file in errors. `filter` as for nlohmann::json::parse.
inline nlohmann::json parse_json(const std::string& text, const std::string& name,
                                 const nlohmann::json::parser_callback_t& filter = nullptr) {
  using Event = nlohmann::json::parse_event_t;
  const auto check = [&](int depth, Event event, nlohmann::json& parsed) {
    const bool begins = event == Event::object_start || event == Event::array_start;
    if (begins && depth >= kMaxJsonDepth) {
      throw std::runtime_error(name + ": values are nested too deep");
    }
    return !filter || filter(depth, event, parsed);
  };
  try {
    return nlohmann::json::parse(text, check);
  } catch (const nlohmann::json::parse_error& error) {
    throw std::runtime_error(name + ": not JSON, or truncated, at byte " +
                             std::to_string(std::min(error.byte, text.size())) + " of " +
                             std::to_string(text.size()));
  } catch (const nlohmann::json::out_of_range&) {
    throw std::runtime_error(name + ": a number is too large to read");
  }
}

}  // namespace thinbench
