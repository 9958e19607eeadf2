// Options that several commands share, and checks of arguments, whose messages state what would be
// right. They read decimal numbers and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <CLI/CLI.hpp>

#include "images/binarise.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/isa.hpp"

namespace thinbench {

[[nodiscard]] CLI::Validator whole_number(std::uint64_t lowest, std::uint64_t highest);

[[nodiscard]] CLI::Validator real_number(double lowest, double highest);

[[nodiscard]] CLI::Validator one_of(const std::vector<std::string_view>& names);

/// Rejects "", which stands for "not given" behind the options.
[[nodiscard]] CLI::Validator not_empty();

/// UTF-8 without control characters, and not "".
[[nodiscard]] CLI::Validator printable();

/// The whole numbers in a text of this form, which has N for each, of at most so many digits: 10
/// and 20 of "10x20" by "NxN". Nothing where the text has another form.
[[nodiscard]] std::vector<std::int64_t> whole_numbers(const std::string& text,
                                                      const std::string& form, int max_digits);

/// "0.5,2" as numbers; nothing unless all are finite.
[[nodiscard]] std::optional<std::vector<double>> numbers_from(const std::string& text);

/// From "120,45". Throws UsageError that begins with the option's name.
[[nodiscard]] Pixel pixel_from(const char* name, const std::string& text);

/// `--spacing DX[,DY]`.
void add_spacing_option(CLI::App& app, Spacing& spacing);

/// A file that is no image: neither "" nor "-".
[[nodiscard]] CLI::Validator file_name();

/// Throws UsageError where an output is an input or another output, and FileError where it cannot
/// be written. "" and "-" are no files.
void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

/// Throws UsageError where JSON and an image would both go to standard output.
void check_streams(bool json, const std::vector<std::string>& images);

/// Throws UsageError where OUT, of one page, would replace IN, of several.
void check_replaced(const FileBytes& in, const std::string& out);

/// Throws FileError where distances, which graphs need, too, cannot be found in an image of this
/// size.
void check_sides(const std::string& file, Index width, Index height);

/// An option whose values fulfil the check, for a variable or a function that takes its text. Help
/// calls them `type`.
template <class Value>
CLI::Option* add_value(CLI::App& app, const std::string& name, Value&& value,
                       const std::string& what, const CLI::Validator& check,
                       const std::string& type) {
  if constexpr (std::is_invocable_v<Value, const std::string&>) {
    return app.add_option_function<std::string>(name, value, what)->check(check)->type_name(type);
  } else {
    return app.add_option(name, value, what)->check(check)->type_name(type);
  }
}

/// An argument that must be given.
template <class Value>
void add_argument(CLI::App& app, const std::string& name, Value& value, const std::string& what) {
  app.add_option(name, value, what)->required()->type_name("");
}

/// The name of a file, which fulfils the check.
CLI::Option* add_file_option(CLI::App& app, const std::string& name, std::string& path,
                             const std::string& what, const CLI::Validator& check = not_empty());

/// The image that a command reads.
void add_input(CLI::App& app, std::string& in);

/// `--overlay FILE`, by write_overlay().
void add_overlay_option(CLI::App& app, std::string& path);

/// `--isa NAME`.
void add_isa_option(CLI::App& app, std::optional<Isa>& isa);

/// `--threads N`, one thread by default.
void add_threads_option(CLI::App& app, int& threads);

using Options = std::vector<CLI::Option*>;

/// Those that `add` adds to the command.
template <class Add>
Options options_added(CLI::App& app, const Add& add) {
  const std::size_t before = app.get_options().size();
  add();
  const Options all = app.get_options();
  return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}

/// Returns them. `image` is the option without which these have no meaning; nullptr where the
/// command always reads an image.
Options add_binarise_options(CLI::App& app, BinariseOptions& options, CLI::Option* image = nullptr);

/// Those of the options that were given, each with a space before it: " --foreground dark".
[[nodiscard]] std::string given_words(const Options& options);

}  // namespace thinbench
