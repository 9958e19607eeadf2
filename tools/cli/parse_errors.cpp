#include "cli/parse_errors.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "cli/names.hpp"

namespace thinbench {
namespace {

std::string unexpected_text(const CLI::App& app) {
  const std::vector<std::string> left = app.remaining();
  const auto option = std::find_if(left.begin(), left.end(),
                                   [](const std::string& word) { return word.rfind('-', 0) == 0; });
  if (option == left.end()) return "'" + left.front() + "' was not expected";
  std::vector<std::string> names;
  for (const CLI::Option* known : app.get_options()) {
    if (known->nonpositional()) names.push_back(known->get_name());
  }
  std::string text = "there is no option '" + *option + "'";
  if (const auto nearest = nearest_name(*option, {names.begin(), names.end()})) {
    text += "; did you mean '" + std::string(*nearest) + "'?";
  }
  return text;
}

/// The parser's text, or a better one where it uses its own terms.
std::string plain_text(const CLI::ParseError& error) {
  std::string text = error.what();
  const auto colon = text.find(": ");
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr || colon == std::string::npos) {
    return text;
  }
  const bool missing = text.find("missing") != std::string::npos;
  return text.substr(0, colon) + (missing ? " needs a value" : " may be given only once");
}

std::string full_name(const CLI::App& app) {
  const bool is_command = app.get_parent() != nullptr;
  return is_command ? full_name(*app.get_parent()) + " " + app.get_name() : app.get_name();
}

/// The app that an error is about: the outermost that was left with words it does not know, else
/// the innermost that was named.
const CLI::App& rejecting_app(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (!app.remaining().empty() || parsed.empty()) return app;
  return rejecting_app(*parsed.back());
}

std::string parse_error_text(const CLI::ParseError& error, const CLI::App& program) {
  const CLI::App& app = rejecting_app(program);
  const bool unexpected = !app.remaining().empty();
  std::string text = unexpected ? unexpected_text(app) : plain_text(error);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text + (text.back() == '?' ? " See '" : "; see '") + full_name(app) + " --help'";
}

}  // namespace

bool parse_or_help(CLI::App& app, const std::vector<std::string>& arguments, std::ostream& out) {
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // last one first
    return true;
  } catch (const CLI::CallForHelp&) {
    out << app.help();
  } catch (const CLI::CallForVersion& version) {
    out << version.what() << '\n';
  } catch (const CLI::ParseError& error) {
    throw UsageError(parse_error_text(error, app));
  }
  return false;
}

}  // namespace thinbench
