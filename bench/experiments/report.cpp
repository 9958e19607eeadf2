#include "experiments/report.hpp"

#include <nlohmann/json.hpp>

namespace thinbench {

std::string experiment_json(const std::string& name, const nlohmann::ordered_json& data,
                            const std::string& options) {
  nlohmann::ordered_json json = {
      {"schema", 1}, {"experiment", name}, {"command", "thinbench experiment " + name + options}};
  json.update(data);
  return json.dump(2) + "\n";
}

}  // namespace thinbench
