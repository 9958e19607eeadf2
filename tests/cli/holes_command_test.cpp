#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/made_image.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// Two bright plates on black; the first has a hole of 4 x 3 pixels at (8, 7).
ByteImage plates() {
  return image_by(60, 30, [](Index x, Index y) {
    const bool hole = x >= 8 && x < 12 && y >= 7 && y < 10;
    const bool plate = y >= 2 && y < 20 && ((x >= 3 && x < 20) || (x > 25 && x < 40));
    return hole ? 20 : (plate ? 200 : 0);
  });
}

class HolesCommand : public Commands {
 protected:
  HolesCommand() { write_grey("in.png", plates().view()); }
};

TEST_F(HolesCommand, prints_each_object_with_its_holes_as_json) {
  const Json found = Json::parse(output_of("holes in.png --json"));
  EXPECT_EQ(found.at("foreground"), "bright");
  EXPECT_EQ(found.at("threshold"), 21) << "the level that separates the hole from the plates";
  EXPECT_EQ(found.at("threshold_method"), "otsu");
  EXPECT_EQ(found.at("min_area"), 1);
  const Json& objects = found.at("objects");
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].at("id"), 1);
  EXPECT_EQ(objects[0].at("area"), 17 * 18 - 12);
  EXPECT_EQ(objects[0].at("box"), (std::vector<int>{3, 2, 17, 18}));
  ASSERT_EQ(objects[0].at("holes").size(), 1U);
  const Json& hole = objects[0].at("holes")[0];
  EXPECT_EQ(hole.at("area"), 12);
  EXPECT_EQ(hole.at("centre"), (std::vector<double>{9.5, 8.0}));
  EXPECT_EQ(hole.at("box"), (std::vector<int>{8, 7, 4, 3}));
  EXPECT_EQ(objects[1].at("holes"), Json::array());
}

TEST_F(HolesCommand, lists_the_same_for_people) {
  const std::string list = output_of("holes in.png");
  expect_holds(list, "2 objects, 1 hole\n");
  expect_holds(list, "  hole 1: area 12, centre (9.50, 8.00), box 8 7 4 3\n");
}

TEST_F(HolesCommand, threshold_and_foreground_choose_the_objects) {
  expect_holds(output_of("holes in.png --threshold 10"), "2 objects, 0 holes");
  expect_holds(output_of("holes in.png --foreground dark --threshold 100"), "2 objects, 2 holes");
  const Json found =
      Json::parse(output_of("holes in.png --foreground dark --threshold 100 --json"));
  EXPECT_EQ(found.at("foreground"), "dark");
  EXPECT_EQ(found.at("threshold"), 100);
  EXPECT_EQ(found.at("threshold_method"), "given");
}

TEST_F(HolesCommand, finds_parts_of_either_polarity_without_options) {
  const ProgramRun bright = typed("holes in.png");
  expect_holds(bright.err, "foreground is bright (grey level >= 21)");
  write_grey("in.png", mapped(plates(), [](int level) { return 250 - level; }).view());
  const ProgramRun dark = typed("holes in.png");
  EXPECT_EQ(dark.out, bright.out);
  expect_holds(dark.err, "foreground is dark (grey level < 51)");
  EXPECT_EQ(dark.status, 0);
}

TEST_F(HolesCommand, min_area_leaves_out_small_objects_and_holes_everywhere) {
  ByteImage image = plates();
  image.at(50, 1) = 200;                                      // the first object
  image.at(37, 5) = image.at(38, 5) = image.at(14, 15) = 20;  // holes before and after the large
  write_grey("in.png", image.view());
  expect_holds(output_of("holes in.png"), "3 objects, 3 holes\n");
  const std::string list = output_of("holes in.png --min-area 12");
  expect_holds(list, "2 objects, 1 hole\nobject 1: area 293");
  expect_holds(list, "  hole 1: area 12, ");
  const Json found = Json::parse(output_of("holes in.png --min-area 12 --json"));
  EXPECT_EQ(found.at("min_area"), 12);
  EXPECT_EQ(found.at("objects").size(), 2U);
  EXPECT_EQ(found.at("/objects/0/id"_json_pointer), 1);
  EXPECT_EQ(found.at("/objects/0/holes"_json_pointer).size(), 1U);
  EXPECT_EQ(found.at("/objects/0/holes/0/id"_json_pointer), 1);
  EXPECT_EQ(found.at("/objects/1/holes"_json_pointer).size(), 0U);
}

TEST_F(HolesCommand, image_without_objects_gives_an_empty_list) {
  write_grey("in.png", ByteImage(20, 10).view());
  const Json found = Json::parse(output_of("holes in.png --json --overlay overlay.png"));
  EXPECT_EQ(found.at("objects"), Json::array());
  EXPECT_EQ(read_grey("overlay.png").width(), 20);
  EXPECT_EQ(output_of("holes in.png"), "0 objects, 0 holes\n");
}

TEST_F(HolesCommand, bad_input_gives_one_line_and_no_file) {
  fs::create_hard_link("in.png", "link.png");
  expect_rejected({
      {1, "holes in.png --overlay no/a.png", {"no directory"}},
      {2, "holes in.png --min-area 0", {"--min-area", "integer in [1, 2147483648], got '0'"}},
      {2, "holes in.png --overlay ''", {"--overlay: expected a value, got ''"}},
      {2, "holes in.png --csv ./in.png", {"'./in.png' is read or written as another file, too"}},
      {2, "holes in.png --csv a.svg --overlay a.svg", {"'a.svg' is read or written as another"}},
      {2, "path in.png --start 1,1 --goal 2,2 --overlay in.png", {"'in.png' is read or written"}},
      {1, "holes in.png --csv /proc/self/fd/1", {"it is an open file or a stream"}},
      {2, "holes in.png --csv link.png", {"'link.png' is read or written as another"}},
      {1, "holes in.png --csv " + std::string(300, 'a'), {"File name too long"}},
  });
}

TEST_F(HolesCommand, truncated_jpeg_is_read_with_a_warning_if_lenient) {
  const std::string bytes = bytes_of(THINBENCH_SOURCE_DIR "/results/pictures/scene.jpg");
  put("cut.jpg", bytes.substr(0, bytes.size() / 2));
  expect_rejected({1, "holes cut.jpg", {"cannot read 'cut.jpg': the file is truncated"}});
  const ProgramRun lenient = typed("holes cut.jpg --lenient");
  EXPECT_EQ(lenient.status, 0);
  EXPECT_EQ(lenient.err.rfind("warning: cut.jpg: the file is truncated\n", 0), 0U);
  expect_holds(lenient.out, "object 1");
  EXPECT_EQ(typed("batch holes cut.jpg --out out").status, 1);
  EXPECT_EQ(typed("batch holes cut.jpg --out out --lenient").status, 0);
  expect_holds(bytes_of("out/manifest.csv"), "the file is truncated");
}

}  // namespace
}  // namespace thinbench
