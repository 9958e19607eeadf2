#include "cli/program.hpp"

#include <algorithm>
#include <iostream>
#include <new>
#include <vector>

#include <unistd.h>

#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/parse_errors.hpp"
#include "core/isa.hpp"
#include "experiments/experiment_command.hpp"
#include "training/train_command.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench run thin_naccache_shinghal parts.png skeleton.png --invert
  thinbench verify --quick
  thinbench train cluster
  thinbench list

THINBENCH_MAX_ISA=avx2 (or baseline, sse4.2, avx512, avx512icl) caps the instruction set.)";

constexpr const char* kLeadIn = "thinbench: ";

/// The program with all its commands, before and after parsing.
class Program {
 public:
  explicit Program(const Console& console) : console_(console) {
    app_.set_version_flag("--version", "thinbench " THINBENCH_VERSION, "Print the version");
    app_.require_subcommand(1);
    app_.footer(kExamples);
    commands_ = {add_list_command(app_), add_verify_command(app_), add_run_command(app_),
                 add_scene_command(app_), add_machine_command(app_)};
    add_train_command(app_, console.out, console.err);
    add_experiment_command(app_, console.out, console.err);
    // These two do their work while they are parsed.
    for (const char* name : {"train", "experiment"}) {
      commands_.push_back({app_.get_subcommand(name), [](const Console&) { return kSuccess; }});
    }
  }

  int run(const std::vector<std::string>& args) {
    if (args.empty()) {
      console_.err << app_.help();
      return kUsage;
    }
    check_command_name(args.front());
    if (!parse(args, console_.out)) return kSuccess;
    check_cap();
    return chosen()->run(console_);
  }

 private:
  using Commands = std::vector<Command>;

  void check_command_name(const std::string& word) const {
    std::vector<std::string> names;
    for (const Command& command : commands_) names.push_back(command.app->get_name());
    const bool known = std::find(names.begin(), names.end(), word) != names.end();
    if (!known && word.rfind('-', 0) != 0) {
      refuse_name("command", word, {names.begin(), names.end()});
    }
  }

  /// False where help or the version was asked for, and printed.
  bool parse(const std::vector<std::string>& args, std::ostream& out) {
    try {
      app_.parse(std::vector<std::string>(args.rbegin(), args.rend()));
      return true;
    } catch (const CLI::CallForHelp&) {
      out << app_.help();
    } catch (const CLI::CallForVersion& version) {
      out << version.what() << '\n';
    } catch (const CLI::ParseError& error) {
      const auto command = chosen();
      const bool is_own = command == commands_.end() || !app_.remaining().empty();
      throw UsageError(parse_error_text(error, is_own ? app_ : *command->app));
    }
    return false;
  }

  [[nodiscard]] Commands::const_iterator chosen() const {
    return std::find_if(commands_.begin(), commands_.end(),
                        [](const Command& command) { return command.app->parsed(); });
  }

  static void check_cap() {
    try {
      static_cast<void>(isa_cap());
    } catch (const std::invalid_argument& error) {
      throw UsageError(error.what());
    }
  }

  CLI::App app_{"Thin binary pictures fast, and prove that every variant is right", "thinbench"};
  Commands commands_;
  Console console_;
};

int run_and_flush(const std::vector<std::string>& args, const Console& console) {
  const int status = Program(console).run(args);
  if (!console.out.flush()) throw std::runtime_error("standard output cannot be written");
  return status;
}

}  // namespace

int run_program(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  const bool err_is_terminal = &err == &std::cerr && isatty(STDERR_FILENO) != 0;
  try {
    return run_and_flush(args, {out, err, err_is_terminal});
  } catch (const UsageError& error) {
    err << kLeadIn << error.what() << '\n';
    return kUsage;
  } catch (const std::bad_alloc&) {
    err << kLeadIn << "there is not enough memory\n";
  } catch (const std::exception& error) {
    err << kLeadIn << error.what() << '\n';
  }
  return kFailure;
}

}  // namespace thinbench
