#include "paired/child_process.hpp"
#include "paired/session.hpp"
#include "peers/peers.hpp"

int main(int argc, char** argv) {
  return thinbench::run_paired({argv + (argc > 0 ? 1 : 0), argv + argc},
                               thinbench::operations_with_peers(),
                               thinbench::measure_in_new_process);
}
