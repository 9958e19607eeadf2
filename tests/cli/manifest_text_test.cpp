#include "batch/manifest_text.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/rejection.hpp"

namespace thinbench {
namespace {

std::string rejection(const std::string& text, TableFormat format) {
  return rejection_of<std::runtime_error>([&] { static_cast<void>(parse_manifest(text, format)); });
}

TEST(ManifestText, nested_values_and_values_of_wrong_types_are_no_records) {
  constexpr int depth = 100'000;
  const std::string nested = std::string(depth, '[') + std::string(depth, ']');
  for (const std::string& line :
       {R"({"file":"a","page":)" + nested + "}", R"({"file":"a","output":)" + nested + "}",
        R"({"file":"a","other":)" + nested + "}",
        std::string(R"({"file":1,"output":7,"error":null})"),
        std::string(R"({"file":1,"page":1e300,"error":null})"),
        std::string(R"({"file":1,"page":"2","error":null})"), std::string(R"({"file":1})"),
        std::string(R"({"file":)")}) {
    EXPECT_EQ(rejection(line + "\n", TableFormat::json_lines),
              "it is not a manifest of this program: a line is not a record")
        << line.substr(0, 99);
  }
}

TEST(ManifestText, pages_are_numbers) {
  const std::string head = manifest_head(TableFormat::csv);
  const auto commas = static_cast<std::size_t>(std::ranges::count(head, ','));
  const std::string end = std::string(commas - 1, ',') + "\n";
  EXPECT_EQ(parse_manifest(head + "a.png,2" + end, TableFormat::csv).lines.front().page, 2);
  for (const char* page : {"", "x", "2x", "99999999999"}) {
    EXPECT_EQ(rejection(head + "a.png," + page + end, TableFormat::csv),
              "it is not a manifest of this program: a page has no number")
        << page;
  }
}

}  // namespace
}  // namespace thinbench
