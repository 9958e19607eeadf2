// thinbench-study machine: what the measurements of this machine depend on.
#include <memory>
#include <string>

#include "cli/command.hpp"
#include "machine/machine.hpp"
#include "study/study.hpp"
#include "support/json_field.hpp"

namespace thinbench {
namespace {

struct MachineOptions {
  std::string commit = "unknown";
  std::string options = "{}";
  bool fingerprint = false;
};

nlohmann::json parsed_options(const std::string& text) {
  try {
    auto options = parse_json(text, "--options");
    if (options.is_object()) return options;
  } catch (const std::runtime_error&) {
  }
  throw UsageError("--options: '" + text + R"(' is not a JSON object such as {"quick": true})");
}

int print(const MachineOptions& options, std::ostream& out) {
  const nlohmann::json run_options = parsed_options(options.options);
  if (options.fingerprint) {
    out << machine_fingerprint() << '\n';
  } else {
    using Json = nlohmann::json;
    out << machine_json(options.commit, run_options)
               .dump(2, ' ', false, Json::error_handler_t::replace)
        << '\n';
  }
  return kSuccess;
}

}  // namespace

Command add_machine_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("machine", "Describe this machine and build as JSON");
  const auto options = std::make_shared<MachineOptions>();
  app->add_option("--commit", options->commit, "Commit to name")
      ->type_name("ID")
      ->capture_default_str();
  app->add_option("--options", options->options, "Options of the run to name")
      ->type_name("JSON")
      ->capture_default_str();
  app->add_flag("--fingerprint", options->fingerprint, "Print the fingerprint and nothing else");
  app->footer(R"--(Examples:
  thinbench-study machine
  thinbench-study machine --fingerprint
  thinbench-study machine --commit "$(git rev-parse HEAD)" --options '{"quick": true}')--");
  return {app, [options](const Console& console) { return print(*options, console.out); }};
}

}  // namespace thinbench
