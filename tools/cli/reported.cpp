#include "cli/reported.hpp"

#include <new>
#include <stdexcept>

#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/usage.hpp"

namespace thinbench {

int run_and_report(const std::string& program, std::ostream& out, std::ostream& err,
                   const std::function<int()>& run) {
  const auto report = [&](const std::string& text, int status) {
    err << program << ": " << one_line(text) << '\n';
    return status;
  };
  try {
    const int status = run();
    if (!out.flush()) throw std::runtime_error("standard output cannot be written");
    return status;
  } catch (const UsageError& error) {
    return report(error.what(), kUsage);
  } catch (const ExtensionError& error) {
    return report(error.what(), kUsage);
  } catch (const NothingFound& error) {
    return report(error.what(), kNothingFound);
  } catch (const std::bad_alloc&) {
    return report("there is not enough memory", kFailure);
  } catch (const std::exception& error) {
    return report(error.what(), kFailure);
  }
}

}  // namespace thinbench
