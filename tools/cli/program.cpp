#include "cli/program.hpp"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/parse_errors.hpp"
#include "cli/reported.hpp"
#include "support/unfinished_file.hpp"
#include "thinbench/isa.hpp"
#include "thinbench/version.hpp"

namespace thinbench {
namespace {

/// The program with all its commands, before and after parsing.
class Program {
 public:
  Program(const ProgramInfo& info, const Console& console)
      : app_(info.description, info.name), console_(console) {
    app_.set_version_flag("--version", info.name + " " + std::string(kVersion),
                          "Print the version");
    app_.require_subcommand(1);
    app_.footer(info.footer);
    for (const auto add : info.commands) commands_.push_back(add(app_));
  }

  int run(const std::vector<std::string>& args) {
    if (args.empty()) {
      console_.err << app_.help();
      return kUsage;
    }
    const Command* const command = read(args);
    return command == nullptr ? kSuccess : command->run(console_);
  }

  /// The innermost command that was named; nullptr where help or the version was printed.
  const Command* read(const std::vector<std::string>& args) {
    check_command_names(args);
    if (!parse_or_help(app_, args, console_.out)) return nullptr;
    checked_usage(&isa_cap);
    return &parsed_command();
  }

 private:
  using Commands = std::vector<Command>;

  /// Rejects a first word that is not a command and, after a command that holds others, a second.
  void check_command_names(const std::vector<std::string>& words) const {
    const Commands* known = &commands_;
    for (const std::string& word : words) {
      if (known->empty() || word.rfind('-', 0) == 0) return;
      const auto found = std::find_if(known->begin(), known->end(), [&](const Command& command) {
        return command.app->get_name() == word;
      });
      if (found == known->end()) reject_name("command", word, names_of(*known));
      known = &found->parts;
    }
    if (!known->empty()) {
      throw UsageError(words.back() +
                       " needs one more word: " + enumeration(names_of(*known), " or ") +
                       "; see '" + app_.get_name() + " " + words.back() + " --help'");
    }
  }

  static std::vector<std::string_view> names_of(const Commands& commands) {
    std::vector<std::string_view> names;
    for (const Command& command : commands) names.push_back(command.app->get_name());
    return names;
  }

  /// The innermost command that was named.
  [[nodiscard]] const Command& parsed_command() const {
    const Command* parsed = nullptr;
    for (const Commands* commands = &commands_; !commands->empty(); commands = &parsed->parts) {
      parsed = &*std::find_if(commands->begin(), commands->end(),
                              [](const Command& command) { return command.app->parsed(); });
    }
    return *parsed;
  }

  CLI::App app_;
  Commands commands_;
  Console console_;
};

}  // namespace

int run_program(const ProgramInfo& program, const std::vector<std::string>& args, std::ostream& out,
                std::ostream& err) {
  return run_and_report(program.name, out, err, [&] {
    return Program(program, {out, err}).run(args);
  });
}

int run_main(const ProgramInfo& program, int argc, char** argv) {
  remove_unfinished_files_on_signals();
  return run_program(program, {argv + (argc > 0 ? 1 : 0), argv + argc}, std::cout, std::cerr);
}

int check_arguments(const ProgramInfo& program, const std::vector<std::string>& args,
                    std::ostream& out, std::ostream& err) {
  return run_and_report(program.name, out, err, [&] {
    static_cast<void>(Program(program, {out, err}).read(args));
    return kSuccess;
  });
}

}  // namespace thinbench
