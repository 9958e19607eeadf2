// Plans of the sampler: their numbers, or one line that says what is wrong.
#include <stdexcept>
#include <string>

#include "byte_source.hpp"
#include "measure/plan_json.hpp"

namespace thinbench {

void try_input(ByteSource& input) {
  must_succeed_or_explain<std::runtime_error>([&] {
    const Plan plan = plan_from_json(input.rest());
    for (const Group& group : plan.groups) {
      must(group.layouts > 0, "no layout");
      for (const Entry& entry : group.entries) {
        must(entry.calls > 0 && entry.delay_ns >= 0 && entry.visits > 0 && entry.warm_up >= 0,
             "an entry that cannot be measured");
      }
    }
  });
}

}  // namespace thinbench
