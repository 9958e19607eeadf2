#include "machine/machine.hpp"
#include "regress/session.hpp"

int main(int argc, char** argv) {
  return thinbench::run_regress({argv + (argc > 0 ? 1 : 0), argv + argc},
                                thinbench::machine_json("unknown", nlohmann::json::object()));
}
