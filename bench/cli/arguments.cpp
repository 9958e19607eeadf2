#include "cli/arguments.hpp"

#include <charconv>
#include <optional>
#include <sstream>

#include "thinbench/options.hpp"

namespace thinbench {
namespace {

template <class Number>
std::optional<Number> number_from(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return number;
}

template <class Number>
CLI::Validator number_in(Number lowest, Number highest, const std::string& kind) {
  std::ostringstream range;
  range << "from " << lowest << " to " << highest;
  const auto check = [=, span = range.str()](std::string& text) -> std::string {
    const auto number = number_from<Number>(text);
    if (!number || !(*number >= lowest && *number <= highest)) {
      return "'" + text + "' is no " + kind + " " + span;
    }
    text = text.substr(std::min(text.find_first_not_of('0'), text.size() - 1));
    return {};
  };
  return {check, ""};  // help texts give the range in their own words
}

}  // namespace

CLI::Validator whole_number(std::uint64_t lowest, std::uint64_t highest) {
  return number_in(lowest, highest, "whole number");
}

CLI::Validator real_number(double lowest, double highest) {
  return number_in(lowest, highest, "number");
}

CLI::Validator not_empty() {
  return {[](std::string& text) { return text.empty() ? "its value is empty" : std::string(); },
          ""};
}

void add_threads_option(CLI::App& app, int& threads) {
  app.add_option("--threads", threads, "Number of threads, 1 to " + std::to_string(kMaxThreads))
      ->check(whole_number(1, kMaxThreads))
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace thinbench
