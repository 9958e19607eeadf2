/* The C interface from C99; compiled as C++ as well. Each function passes its arguments on, and
 * gives the status of an error; what C++ rejects is in rejections_test.cpp. Prints what failed; the
 * status is the number of failures. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "thinbench.h"

static int failures = 0;

#define CHECK(condition)                                                          \
  do {                                                                            \
    if (!(condition)) {                                                           \
      printf("line %d: %s [%s]\n", __LINE__, #condition, thinbench_last_error()); \
      ++failures;                                                                 \
    }                                                                             \
  } while (0)

#define SUCCEEDS(call) CHECK((call) == THINBENCH_OK)

static thinbench_rule* guo_hall;

enum { WIDTH = 20, HEIGHT = 12, COUNT = 3 };
static uint8_t pixels[COUNT][HEIGHT][WIDTH];
static uint8_t results[COUNT][HEIGHT][WIDTH];
static int32_t numbers[HEIGHT][WIDTH];

/* Views with contiguous rows. */
static thinbench_image view_of(const uint8_t* data, ptrdiff_t width, ptrdiff_t height) {
  thinbench_image view = THINBENCH_IMAGE_INIT;
  view.data = (uint8_t*)data;
  view.width = view.stride = width;
  view.height = height;
  return view;
}

static thinbench_labels labels_of(const int32_t* data, ptrdiff_t width, ptrdiff_t height) {
  thinbench_labels view = THINBENCH_LABELS_INIT;
  view.data = (int32_t*)data;
  view.width = view.stride = width;
  view.height = height;
  return view;
}

static thinbench_reals reals_of(double* data, ptrdiff_t width, ptrdiff_t height) {
  thinbench_reals view = THINBENCH_REALS_INIT;
  view.data = data;
  view.width = view.stride = width;
  view.height = height;
  return view;
}

static thinbench_stack stack_of(uint8_t* data, ptrdiff_t count) {
  thinbench_stack view = THINBENCH_STACK_INIT;
  view.data = data;
  view.count = count;
  view.width = view.stride = WIDTH;
  view.height = HEIGHT;
  view.image_stride = HEIGHT * WIDTH;
  return view;
}

/* Of the first image, its result and numbers, and of all images; main() sets them. */
static thinbench_image one, output;
static thinbench_labels labels;
static thinbench_stack all, outputs;

/* A block with a hole in each image, the hole at another place. */
static void draw(void) {
  int i, x, y;
  memset(pixels, 0, sizeof(pixels));
  for (i = 0; i < COUNT; ++i) {
    for (y = 2; y < HEIGHT - 2; ++y) {
      for (x = 2; x < WIDTH - 2; ++x) pixels[i][y][x] = !(y == 5 && x == 7 + i);
    }
  }
  memset(results, 77, sizeof(results));
}

static int unwritten(void) {
  size_t i;
  for (i = 0; i < sizeof(results); ++i) {
    if ((&results[0][0][0])[i] != 77) return 0;
  }
  return 1;
}

/* Each call must fail with a message of one line that contains `value`, and write nothing. */
static void rejects(thinbench_status status, const char* value) {
  if (status != THINBENCH_INVALID_ARGUMENT || strstr(thinbench_last_error(), value) == NULL ||
      strchr(thinbench_last_error(), '\n') != NULL || !unwritten()) {
    printf("status %d, expected an error with %s: %s\n", (int)status, value,
           thinbench_last_error());
    ++failures;
  }
}

#if THINBENCH_VERSION_MAJOR < 1
#error "expected version 1 or later"
#endif
static void macros_have_the_version(void) {
  char version[40];
  snprintf(version, sizeof(version), "%d.%d.%d", THINBENCH_VERSION_MAJOR, THINBENCH_VERSION_MINOR,
           THINBENCH_VERSION_PATCH);
  CHECK(strcmp(thinbench_version(), version) == 0);
}

static void thins_images_stacks_and_lists(void) {
  thinbench_thinning thinning = THINBENCH_THINNING_INIT;
  thinbench_execution execution = THINBENCH_EXECUTION_INIT;
  thinbench_image sources[COUNT], destinations[COUNT];
  thinbench_thinner* thinner = NULL;
  uint8_t first[HEIGHT][WIDTH], expected[COUNT][HEIGHT][WIDTH];
  int32_t iterations = 0, most = 0;
  int i;
  draw();
  SUCCEEDS(thinbench_thin(guo_hall, &one, &output, NULL, NULL, &iterations));
  CHECK(iterations > 1);
  memcpy(first, results[0], sizeof(first));
  SUCCEEDS(thinbench_thin_stack(guo_hall, &all, &outputs, &thinning, &execution, &most));
  CHECK(memcmp(first, results[0], sizeof(first)) == 0);
  CHECK(memcmp(results[0], results[1], sizeof(first)) != 0);
  memcpy(expected, results, sizeof(expected));
  draw();
  for (i = 0; i < COUNT; ++i) {
    sources[i] = view_of(&pixels[i][0][0], WIDTH, HEIGHT);
    destinations[i] = view_of(&results[i][0][0], WIDTH, HEIGHT);
  }
  SUCCEEDS(thinbench_thin_many(guo_hall, sources, destinations, COUNT, NULL, NULL, &iterations));
  CHECK(memcmp(results, expected, sizeof(expected)) == 0 && iterations == most);
  SUCCEEDS(thinbench_thin_many(guo_hall, NULL, NULL, 0, NULL, NULL, &iterations));
  CHECK(iterations == 0);
  draw();
  SUCCEEDS(thinbench_thinner_create(guo_hall, WIDTH, HEIGHT, NULL, NULL, &thinner));
  SUCCEEDS(thinbench_thinner_run(thinner, &one, &output, NULL));
  SUCCEEDS(thinbench_thinner_run(thinner, &one, &output, &iterations));
  CHECK(iterations > 1 && memcmp(first, results[0], sizeof(first)) == 0);
  thinbench_thinner_destroy(thinner);
  thinbench_thinner_destroy(NULL);
  thinning.max_iterations = 1;
  execution.isa = "baseline";
  SUCCEEDS(thinbench_thin(guo_hall, &one, &output, &thinning, &execution, &iterations));
  CHECK(iterations == 1);
  draw();
  rejects(thinbench_thinner_create(guo_hall, -1, 5, NULL, NULL, &thinner), "-1");
  CHECK(thinner == NULL);
  rejects(thinbench_thin_many(NULL, NULL, NULL, 0, NULL, NULL, NULL), "rule is NULL");
  rejects(thinbench_thin_many(guo_hall, NULL, destinations, 2, NULL, NULL, NULL),
          "sources is NULL");
  rejects(thinbench_thin_many(guo_hall, sources, NULL, 2, NULL, NULL, NULL),
          "destinations is NULL");
  sources[1].width = -1;
  rejects(thinbench_thin_many(guo_hall, sources, destinations, 2, NULL, NULL, NULL), "-1");
}

static void thins_labels_each_alone(void) {
  int32_t iterations = 0;
  int x, y;
  for (y = 0; y < HEIGHT; ++y) {
    for (x = 0; x < WIDTH; ++x) numbers[y][x] = x < WIDTH / 2 ? 300000 : 4;
  }
  SUCCEEDS(thinbench_thin_labels(guo_hall, &labels, &labels, NULL, NULL, &iterations));
  CHECK(iterations > 1 && numbers[0][0] == 0);
  for (x = 0, y = 0; x < WIDTH; ++x) {
    if (numbers[HEIGHT / 2][x] == (x < WIDTH / 2 ? 300000 : 4)) ++y;
  }
  CHECK(y == 2);
  draw();
  rejects(thinbench_thin_labels(guo_hall, &labels, NULL, NULL, NULL, NULL), "destination is NULL");
}

/* Two lines that touch. */
static const int32_t labelled[3][5] = {{0, 0, 4, 0, 7}, {4, 4, 4, 4, 7}, {0, 0, 0, 0, 7}};

static void finds_regions_and_labels(void) {
  const thinbench_labels values = labels_of(&labelled[0][0], 5, 3);
  const thinbench_labels parts = labels_of(&numbers[0][0], 5, 3);
  thinbench_regions* regions = NULL;
  const thinbench_region* hole;
  size_t count = 0;
  int64_t number = 9;
  uint32_t objects = 9;
  draw();
  SUCCEEDS(thinbench_label_regions(&one, &labels, NULL, &regions));
  CHECK(thinbench_regions_objects(regions, &count, sizeof(thinbench_region))->area ==
        (HEIGHT - 4) * (WIDTH - 4) - 1);
  CHECK(count == 1);
  hole = thinbench_regions_holes(regions, &count, sizeof(thinbench_region));
  CHECK(count == 1 && hole->area == 1 && hole->left == 7 && hole->bottom == 5);
  CHECK(hole->enclosing_object == 1 && hole->reserved == 0);
  CHECK(thinbench_regions_holes(regions, NULL, sizeof(thinbench_region)) == hole);
  CHECK(numbers[0][0] == 0 && numbers[2][2] == 1 && numbers[5][7] == 2);
  thinbench_regions_destroy(regions);
  SUCCEEDS(thinbench_find_regions(&one, NULL, &regions));
  CHECK(thinbench_regions_holes(regions, &count, sizeof(thinbench_region)) != NULL && count == 1);
  thinbench_regions_destroy(regions);
  SUCCEEDS(thinbench_find_objects(&one, NULL, &regions));
  thinbench_regions_holes(regions, &count, sizeof(thinbench_region));
  CHECK(count == 0);
  thinbench_regions_destroy(regions);
  SUCCEEDS(thinbench_label_objects(&one, &labels, 4, NULL, NULL, &regions));
  CHECK(numbers[2][2] == 1 && numbers[5][7] == 0);
  CHECK(thinbench_regions_objects(regions, &count, sizeof(thinbench_region))->left == 2);
  thinbench_regions_destroy(regions);
  thinbench_regions_destroy(NULL);
  SUCCEEDS(thinbench_label_image(&one, &labels, 8, "pixels", NULL, &objects));
  CHECK(objects == 1 && numbers[0][0] == 0 && numbers[2][2] == 1 && numbers[5][7] == 0);
  SUCCEEDS(thinbench_label_values(&values, &parts, 8, 0, NULL, &objects));
  CHECK(objects == 2 && parts.data[2] == 1 && parts.data[5] == 1 && parts.data[4] == 2);
  SUCCEEDS(thinbench_euler_number(&one, 8, NULL, &number));
  CHECK(number == 0);
  rejects(thinbench_label_regions(&one, NULL, NULL, &regions), "labels is NULL");
  rejects(thinbench_find_regions(&one, NULL, NULL), "regions");
  rejects(thinbench_euler_number(&one, 6, NULL, &number), "6");
  rejects(thinbench_label_image(&one, &labels, 260, NULL, NULL, &objects), "260");
  rejects(thinbench_label_image(&one, &labels, 8, NULL, NULL, NULL), "objects");
  rejects(thinbench_label_objects(&one, &labels, 8, "raster", NULL, &regions), "raster");
  rejects(thinbench_label_objects(&one, &labels, 8, "opencv", NULL, NULL), "regions");
  rejects(thinbench_label_values(&values, &parts, 5, 0, NULL, &objects), "5");
}

static void finds_edges_and_localises(void) {
  const thinbench_image nothing = THINBENCH_IMAGE_INIT;
  thinbench_regions* regions = NULL;
  draw();
  rejects(thinbench_localise_objects(&one, &nothing, 0, 0, NULL, &regions),
          "grey is 20 x 12 and objects 0 x 0");
  rejects(thinbench_localise_objects(NULL, NULL, 0, 0, NULL, &regions), "grey is NULL");
  rejects(thinbench_detect_edges("canny", &one, &output, 0, 0, NULL), "'canny'");
  output.foreground = 1;
  output.data = NULL;
  rejects(thinbench_localise_objects(&one, &output, 0, 0, NULL, &regions), "objects has no data");
  output.data = &results[0][0][0];
  SUCCEEDS(thinbench_localise_objects(&one, NULL, 0, 0, NULL, &regions));
  thinbench_regions_destroy(regions);
  CHECK(unwritten());
  SUCCEEDS(thinbench_localise_objects(&one, &output, 0, 0, NULL, &regions));
  CHECK(results[0][5][5] == 1 && results[0][0][0] == 0);
  thinbench_regions_destroy(regions);
  output.foreground = 0;
  SUCCEEDS(thinbench_detect_edges("sobel", &one, &output, 0, 0, NULL));
  CHECK(results[0][2][3] == 255 && results[0][0][0] == 0);
}

static void fills_holes(void) {
  int32_t with_holes[3][6] = {{4, 4, 4, 7, 7, 7}, {4, 0, 4, 7, 0, 7}, {4, 4, 4, 0, 7, 7}};
  int32_t filled[18];
  const thinbench_labels image = labels_of(&with_holes[0][0], 6, 3);
  const thinbench_labels to = labels_of(filled, 6, 3);
  thinbench_hole_filling filling = THINBENCH_HOLE_FILLING_INIT;
  draw();
  filling.max_area = -1;
  rejects(thinbench_fill_holes(&one, &output, &filling, NULL), "-1");
  rejects(thinbench_fill_holes_of_labels(&image, &to, &filling, NULL), "max_area");
  SUCCEEDS(thinbench_fill_holes(&one, &output, NULL, NULL));
  CHECK(results[0][5][7] == 255 && results[0][0][0] == 0);
  filling.max_area = 0;
  SUCCEEDS(thinbench_fill_holes(&one, &output, &filling, NULL));
  CHECK(results[0][5][7] == 0 && results[0][5][8] == 255);
  filling.connectivity = 4;
  filling.max_area = 1000;
  SUCCEEDS(thinbench_fill_holes_of_labels(&image, &to, &filling, NULL));
  CHECK(filled[7] == 4 && filled[10] == 0 && filled[15] == 0);
  SUCCEEDS(thinbench_fill_holes_of_labels(&image, &image, NULL, NULL));
  CHECK(with_holes[1][1] == 4 && with_holes[1][4] == 7 && with_holes[2][3] == 0);
}

static void writes_another_foreground(void) {
  thinbench_image part = output;
  draw();
  outputs.foreground = 1;
  SUCCEEDS(thinbench_thin_stack(guo_hall, &all, &outputs, NULL, NULL, NULL));
  CHECK(results[0][0][0] == 0 && memchr(results, 1, sizeof(results)) != NULL &&
        memchr(results, 255, sizeof(results)) == NULL);
  outputs.foreground = 0;
  /* With gaps between rows, which are not written. */
  memset(results, 77, sizeof(results));
  one.width = part.width = WIDTH - 1;
  part.foreground = 8;
  SUCCEEDS(thinbench_thin(guo_hall, &one, &part, NULL, NULL, NULL));
  CHECK(memchr(results[0], 8, sizeof(results[0])) != NULL && results[0][5][WIDTH - 1] == 77);
  one.width = WIDTH;
}

/* Conway's blinker, by a table of values and as a sub-iteration before one that removes all pixels.
 */
static void rules_are_made_from_tables(void) {
  const char* const patterns[] = {"1:(... .1. ...)->0", NULL};
  thinbench_thinning defaults = THINBENCH_THINNING_INIT;
  thinbench_execution execution = THINBENCH_EXECUTION_INIT;
  uint64_t life[2 * THINBENCH_TABLE_WORDS], same[THINBENCH_TABLE_WORDS];
  uint8_t values[512];
  thinbench_rule* rule = NULL;
  int32_t iterations = 0, gates = 0;
  int i, x;
  draw();
  SUCCEEDS(thinbench_table_from_hensel("B3/S23", life));
  for (i = 0; i < 512; ++i) values[i] = (uint8_t)(life[i / 64] >> (i % 64) & 1);
  SUCCEEDS(thinbench_table_from_values(values, "raster", same));
  CHECK(memcmp(life, same, sizeof(same)) == 0);
  defaults.max_iterations = 3;
  SUCCEEDS(thinbench_rule_from_tables(life, 1, &defaults, 0, &rule));
  SUCCEEDS(thinbench_rule_gates(rule, 0, &gates));
  CHECK(gates > 3 && gates < 30);
  memset(pixels, 0, sizeof(pixels));
  for (x = 5; x < 8; ++x) pixels[1][4][x] = 1;
  execution.isa = "baseline";
  SUCCEEDS(thinbench_thin_stack(rule, &all, &outputs, NULL, &execution, &iterations));
  CHECK(iterations == 3 && results[1][3][6] == 255 && results[1][5][6] == 255);
  CHECK(results[1][4][6] == 255 && results[1][4][5] == 0 && results[0][4][6] == 0);
  thinbench_rule_destroy(rule);
  memset(values, 1, 256);
  SUCCEEDS(thinbench_table_from_removals(values, "descriptor", same));
  SUCCEEDS(thinbench_table_from_patterns(patterns, 1, life + THINBENCH_TABLE_WORDS));
  CHECK(memcmp(same, life + THINBENCH_TABLE_WORDS, sizeof(same)) == 0);
  SUCCEEDS(thinbench_table_from_patterns(NULL, 0, same)); /* keeps every pixel */
  defaults.border = "keep";
  SUCCEEDS(thinbench_rule_from_tables(life, 2, &defaults, 1, &rule));
  pixels[1][0][0] = 1;
  SUCCEEDS(thinbench_thin_stack(rule, &all, &outputs, NULL, NULL, NULL));
  CHECK(results[1][4][6] == 0 && results[1][0][0] == 255);
  thinbench_rule_destroy(rule);
  thinbench_rule_destroy(NULL);
  draw();
  values[7] = 2;
  rejects(thinbench_table_from_hensel("B3/S29", same), "'9'");
  rejects(thinbench_table_from_hensel(NULL, same), "notation is NULL");
  rejects(thinbench_table_from_hensel("B3/S23", NULL), "table is NULL");
  rejects(thinbench_table_from_patterns(patterns + 1, 1, same), "a pattern is NULL");
  rejects(thinbench_table_from_patterns(NULL, 1, same), "patterns is NULL");
  rejects(thinbench_table_from_values(values, "raster", same), "value 8 of 512");
  rejects(thinbench_table_from_values(values, "columns", same), "'columns'");
  rejects(thinbench_table_from_removals(values, "matlab", same), "'matlab'");
  rejects(thinbench_rule_from_tables(life, 0, NULL, 0, &rule), "got 0");
  rejects(thinbench_rule_from_tables(NULL, 1, NULL, 0, &rule), "tables is NULL");
  rejects(thinbench_rule_from_tables(life, 1, NULL, 0, NULL), "rule is NULL");
  defaults.border = "wrap";
  rejects(thinbench_rule_from_tables(life, 1, &defaults, 0, &rule), "'wrap'");
  CHECK(rule == NULL);
}

static void rules_apply_to_packed_images(void) {
  uint8_t bits[3] = {0, 0x38, 0}, result[3] = {1, 1, 1};
  thinbench_packed packed = THINBENCH_PACKED_INIT, to;
  int32_t iterations = 0;
  thinbench_rule* life = NULL;
  packed.data = bits;
  packed.width = 7;
  packed.height = 3;
  packed.stride = 1;
  to = packed;
  to.data = result;
  SUCCEEDS(thinbench_rule_named("life", &life));
  SUCCEEDS(thinbench_thin_packed(life, &packed, &to, NULL, NULL, &iterations));
  CHECK(iterations == 1 && result[0] == 0x10 && result[1] == 0x10 && result[2] == 0x10);
  bits[1] = 0x70;
  to.lsb_first = 1;
  SUCCEEDS(thinbench_thin_packed(life, &packed, &to, NULL, NULL, NULL));
  CHECK(result[0] == 4 && result[1] == 4 && result[2] == 4);
  draw();
  rejects(thinbench_thin_packed(life, NULL, &to, NULL, NULL, NULL), "source");
  to.reserved = 1;
  rejects(thinbench_thin_packed(life, &packed, &to, NULL, NULL, NULL), "destination.reserved");
  thinbench_rule_destroy(life);
}

static void scans_midpoints(void) {
  uint8_t row[7] = {9, 9, 9, 0, 1, 1, 1};
  const uint8_t marks[7] = {0, 1, 0, 0, 0, 1, 0};
  thinbench_image line = view_of(row, 7, 1);
  line.foreground = 1;
  draw();
  SUCCEEDS(thinbench_midpoint_scan(&line, &line, THINBENCH_ROWS, NULL, NULL));
  CHECK(memcmp(row, marks, sizeof(row)) == 0);
  rejects(thinbench_midpoint_scan(&line, &line, 16, NULL, NULL), "got 16");
  rejects(thinbench_midpoint_scan(&line, &line, 1, "wrap", NULL), "'wrap'");
  rejects(thinbench_midpoint_scan(&line, NULL, 1, NULL, NULL), "destination is NULL");
}

/* A net that keeps every pixel, and one that keeps none. */
static void rules_are_made_from_nets(void) {
  const int32_t last[1] = {255};
  float weights[9 * 9] = {0};
  thinbench_rule* net = NULL;
  draw();
  SUCCEEDS(thinbench_rule_from_cluster(last, weights, 1, &net));
  SUCCEEDS(thinbench_thin(net, &one, &output, NULL, NULL, NULL));
  CHECK(results[0][3][3] == 255 && results[0][0][0] == 0);
  thinbench_rule_destroy(net);
  weights[9 * 9 - 1] = -3;
  SUCCEEDS(thinbench_rule_from_two_layer_net(weights, "linear", &net));
  SUCCEEDS(thinbench_thin(net, &one, &output, NULL, NULL, NULL));
  CHECK(memchr(results[0], 255, sizeof(results[0])) == NULL);
  thinbench_rule_destroy(net);
  draw();
  rejects(thinbench_rule_from_cluster(last, weights, 0, &net), "got 0");
  rejects(thinbench_rule_from_cluster(NULL, weights, 1, &net), "last is NULL");
  rejects(thinbench_rule_from_two_layer_net(NULL, "linear", &net), "weights is NULL");
  rejects(thinbench_rule_from_two_layer_net(weights, "relu", &net), "'relu'");
  CHECK(net == NULL);
}

static void selects_a_channel(void) {
  /* With a byte between the lines. */
  uint8_t bytes[18] = {200, 10, 20, 0, 10, 20, 9, 0, 10, 20, 200, 10, 20};
  uint8_t grey[] = {77, 77, 77, 77, 77};
  thinbench_colours colours = THINBENCH_COLOURS_INIT;
  thinbench_image levels = view_of(grey, 2, 2);
  const char* chosen = NULL;
  draw();
  colours.data = bytes;
  colours.width = colours.height = 2;
  colours.stride = 7;
  levels.stride = 3;
  SUCCEEDS(thinbench_select_channel(&colours, &levels, "red", NULL, &chosen));
  CHECK(strcmp(chosen, "red") == 0);
  CHECK(grey[0] == 200 && grey[1] == 0 && grey[2] == 77 && grey[3] == 0 && grey[4] == 200);
  rejects(thinbench_select_channel(&colours, &levels, "hue", NULL, &chosen), "'hue'");
  rejects(thinbench_select_channel(&colours, &levels, NULL, NULL, NULL), "got NULL");
  colours.samples = 2;
  rejects(thinbench_select_channel(&colours, &levels, "blue", NULL, NULL), "got 2");
  CHECK(strcmp(chosen, "red") == 0 && grey[0] == 200);
}

static void binarises_grey_images(void) {
  uint8_t grey[] = {200, 0, 0, 200}, binary[] = {77, 77, 77, 77};
  thinbench_image source = view_of(grey, 2, 2);
  const thinbench_image to = view_of(binary, 2, 2);
  thinbench_binarisation request = THINBENCH_BINARISATION_INIT;
  const char* foreground = NULL;
  int32_t threshold = 0;
  draw();
  request.foreground = "dark";
  request.threshold = 200;
  SUCCEEDS(thinbench_binarise(&source, &to, &request, NULL, &foreground, &threshold));
  CHECK(strcmp(foreground, "dark") == 0 && threshold == 200);
  CHECK(binary[0] == 0 && binary[1] == 255 && binary[2] == 255 && binary[3] == 0);
  request.foreground = "red";
  rejects(thinbench_binarise(&source, &to, &request, NULL, NULL, NULL), "'red'");
  request.foreground = NULL;
  request.threshold = 256;
  rejects(thinbench_binarise(&source, &to, &request, NULL, NULL, NULL), "256");
  rejects(thinbench_binarise(NULL, &to, NULL, NULL, NULL, NULL), "grey is NULL");
  request.threshold = THINBENCH_OTSU;
  request.window = 4;
  rejects(thinbench_binarise(&source, &to, &request, NULL, NULL, NULL),
          "window: expected THINBENCH_LOCAL beside it, got 4");
  request.window = 0;
  request.threshold = 100;
  request.offset = -77;
  rejects(thinbench_binarise(&source, &to, &request, NULL, NULL, NULL),
          "offset: expected THINBENCH_LOCAL beside it, got -77");
  source.foreground = 1;
  SUCCEEDS(thinbench_binarise(&source, &source, NULL, NULL, NULL, NULL));
  CHECK(grey[0] + grey[1] == 1 && grey[0] == grey[3]);
}

static void takes_levels_of_16_bits(void) {
  uint16_t samples[] = {700, 5, 5, 600, 5, 5}, grey[] = {7, 7};
  uint8_t binary[] = {77, 77};
  thinbench_colours16 colours = THINBENCH_COLOURS16_INIT;
  thinbench_image16 levels = THINBENCH_IMAGE16_INIT;
  const thinbench_image to = view_of(binary, 2, 1);
  thinbench_binarisation request = THINBENCH_BINARISATION_INIT;
  const char* chosen = NULL;
  int32_t threshold = 0;
  draw();
  colours.data = samples;
  levels.data = grey;
  colours.width = levels.width = levels.stride = 2;
  colours.height = levels.height = 1;
  colours.stride = 6;
  SUCCEEDS(thinbench_select_channel16(&colours, &levels, "red", NULL, &chosen));
  CHECK(strcmp(chosen, "red") == 0 && grey[0] == 700 && grey[1] == 600);
  request.foreground = "bright";
  request.threshold = 601;
  SUCCEEDS(thinbench_binarise16(&levels, &to, &request, NULL, &chosen, &threshold));
  CHECK(strcmp(chosen, "bright") == 0 && threshold == 601 && binary[0] == 255 && binary[1] == 0);
  request.threshold = 65536;
  rejects(thinbench_binarise16(&levels, &to, &request, NULL, NULL, NULL), "65536");
  rejects(thinbench_select_channel16(&colours, NULL, "red", NULL, NULL), "destination is NULL");
}

static void describes_and_lists_what_there_is(void) {
  thinbench_rule_info info = THINBENCH_RULE_INFO_INIT;
  thinbench_rule* rule;
  size_t built_in = 0, named = 0;
  int32_t gates = 0;
  draw();
  while (thinbench_rule_name(built_in + named) != NULL) {
    const char* const name = thinbench_rule_name(built_in + named);
    SUCCEEDS(thinbench_rule_named(name, &rule));
    SUCCEEDS(thinbench_rule_describe(rule, &info));
    thinbench_rule_destroy(rule);
    CHECK(strcmp(info.name, name) == 0 && strlen(info.description) > 0);
    CHECK((info.tables == NULL) == (info.sub_iterations == 0));
    CHECK(info.built_in == (info.source == NULL));
    *(info.built_in ? &built_in : &named) += 1;
  }
  CHECK(built_in >= 8 && named >= 19);
  CHECK(thinbench_rule_name(SIZE_MAX) == NULL);
  SUCCEEDS(thinbench_rule_describe(guo_hall, &info));
  CHECK(info.sub_iterations == 2 && info.reach == 2 && info.max_iterations == THINBENCH_UNLIMITED);
  CHECK(strcmp(info.border, "background") == 0);
  CHECK(thinbench_edge_operator_name(0) != NULL && thinbench_edge_operator_name(99) == NULL);
  CHECK(thinbench_isa_name(0) != NULL && thinbench_isa_name(99) == NULL);
  CHECK(thinbench_isa_available("baseline") == 1 && thinbench_isa_available("mmx") == -1);
  rejects(thinbench_rule_named("guo-hall", &rule), "'guo-hall'");
  rejects(thinbench_rule_named(NULL, &rule), "name is NULL");
  rejects(thinbench_rule_named("guo_hall", NULL), "rule is NULL");
  rejects(thinbench_rule_gates(NULL, 0, &gates), "rule is NULL");
  rejects(thinbench_rule_gates(guo_hall, 2, &gates), "sub-iteration 2");
  rejects(thinbench_rule_gates(guo_hall, 0, NULL), "gates is NULL");
  rejects(thinbench_rule_describe(guo_hall, NULL), "info is NULL");
  info.size = 8;
  rejects(thinbench_rule_describe(guo_hall, &info), "info.size");
}

/* For the sanitizers: nothing is added to NULL. Other arguments are checked all the same. */
static void takes_images_without_pixels(void) {
  const thinbench_image none = view_of(NULL, 0, 5);
  const thinbench_labels no_labels = labels_of(NULL, 0, 5);
  const thinbench_pruning pruning = THINBENCH_PRUNING_INIT;
  thinbench_execution execution = THINBENCH_EXECUTION_INIT;
  thinbench_image nowhere = none;
  thinbench_stack two = stack_of(NULL, 2), no_image = stack_of(NULL, 0);
  thinbench_packed packed = THINBENCH_PACKED_INIT;
  thinbench_graph* graph = NULL;
  thinbench_regions* regions = NULL;
  int64_t blocks = -1;
  int32_t iterations = 9;
  nowhere.foreground = two.foreground = 1;
  two.width = 0;
  packed.height = 5;
  packed.stride = 3;
  draw();
  SUCCEEDS(thinbench_thin(guo_hall, &none, &nowhere, NULL, NULL, NULL));
  SUCCEEDS(thinbench_thin_stack(guo_hall, &two, &two, NULL, NULL, NULL));
  SUCCEEDS(thinbench_thin_stack(guo_hall, &no_image, &no_image, NULL, NULL, &iterations));
  CHECK(iterations == 0);
  SUCCEEDS(thinbench_detect_edges("sobel", &none, &none, 0, 0, NULL));
  SUCCEEDS(thinbench_fill_holes(&none, &nowhere, NULL, NULL));
  SUCCEEDS(thinbench_prune(&none, &nowhere, &pruning, NULL, NULL));
  SUCCEEDS(thinbench_squared_distances(&none, &no_labels, NULL));
  SUCCEEDS(thinbench_classify_pixels(&none, &nowhere, &nowhere, NULL));
  SUCCEEDS(thinbench_localise_objects(&none, &nowhere, 0, 0, NULL, &regions));
  thinbench_regions_destroy(regions);
  SUCCEEDS(thinbench_euler_number(&none, 8, NULL, &blocks));
  CHECK(blocks == 0);
  SUCCEEDS(thinbench_full_blocks(&none, NULL, &blocks, NULL));
  CHECK(blocks == 0);
  SUCCEEDS(thinbench_skeleton_graph(&none, NULL, &graph));
  thinbench_graph_destroy(graph);
  SUCCEEDS(thinbench_find_regions(&none, NULL, &regions));
  thinbench_regions_destroy(regions);
  SUCCEEDS(thinbench_thin_packed(guo_hall, &packed, &packed, NULL, NULL, NULL));
  execution.threads = 0;
  rejects(thinbench_thin_stack(guo_hall, &no_image, &no_image, NULL, &execution, NULL), "got 0");
  rejects(thinbench_detect_edges("sobel", &none, &none, 0, 0, &execution), "got 0");
  rejects(thinbench_detect_edges("sobel", &none, &none, 0, -1, NULL), "-1");
  no_image.stride = 3;
  rejects(thinbench_thin_stack(guo_hall, &no_image, &no_image, NULL, NULL, NULL), "stride of 3");
}

/* Three lines that meet. */
static const uint8_t tee[3][5] = {{0, 0, 1, 0, 0}, {0, 0, 1, 0, 0}, {1, 1, 1, 1, 1}};

static void finds_the_graph_of_a_skeleton(void) {
  const thinbench_image image = view_of(&tee[0][0], 5, 3);
  const thinbench_pixel middle[1] = {{2, 1}}, elsewhere[1] = {{0, 0}};
  const thinbench_image no_data = view_of(NULL, 5, 3);
  uint8_t classes[15];
  const thinbench_image to = view_of(classes, 5, 3);
  const thinbench_image nothing = THINBENCH_IMAGE_INIT;
  double distances[15];
  thinbench_reals reals = reals_of(distances, 5, 3);
  thinbench_spacing spacing = THINBENCH_SPACING_INIT;
  thinbench_pruning pruning = THINBENCH_PRUNING_INIT;
  int64_t blocks = -1;
  size_t count = 0;
  thinbench_widths widths[3];
  thinbench_graph *graph = NULL, *made = NULL;
  spacing.x = 3;
  spacing.y = 2;
  draw();
  rejects(thinbench_classify_pixels(&image, &no_data, NULL, NULL), "classes has no data");
  rejects(thinbench_classify_pixels(&image, NULL, &no_data, NULL), "degrees has no data");
  SUCCEEDS(thinbench_classify_pixels(&image, &to, NULL, NULL));
  CHECK(classes[2] == 2 && classes[7] == 3 && classes[12] == 4 && classes[0] == 0);
  rejects(thinbench_classify_pixels(&image, &to, &nothing, NULL),
          "image is 5 x 3 and degrees 0 x 0");
  SUCCEEDS(thinbench_full_blocks(&image, NULL, &blocks, NULL));
  CHECK(blocks == 0);
  labels = labels_of(&numbers[0][0], 5, 3);
  SUCCEEDS(thinbench_squared_distances(&image, &labels, NULL));
  CHECK(labels.data[12] == 2);
  labels = labels_of(&numbers[0][0], WIDTH, HEIGHT);
  SUCCEEDS(thinbench_distances(&image, &reals, &spacing, NULL));
  CHECK(distances[2] == 3 && distances[0] == 0);
  SUCCEEDS(thinbench_distances(&image, &reals, NULL, NULL));
  CHECK(distances[2] == 1);
  SUCCEEDS(thinbench_skeleton_graph(&image, NULL, &graph));
  CHECK(thinbench_graph_nodes(graph, &count, sizeof(thinbench_graph_node)) != NULL && count == 4);
  CHECK(thinbench_graph_edges(graph, &count, sizeof(thinbench_graph_edge)) != NULL && count == 3);
  CHECK(thinbench_graph_node_pixels(graph, &count, sizeof(thinbench_pixel))->x == 2 && count == 4);
  CHECK(thinbench_graph_edge_pixels(graph, &count, sizeof(thinbench_pixel))->y == 1 && count == 3);
  CHECK(thinbench_graph_node_labels(graph, &count, sizeof(int32_t)) == NULL || count == 0);
  SUCCEEDS(thinbench_edge_widths(graph, &reals, NULL, widths, sizeof(*widths)));
  CHECK(widths[0].min == 2 && widths[0].max > 2.8 && widths[0].max < 2.9);
  SUCCEEDS(thinbench_split_graph(graph, middle, 1, &made));
  CHECK(thinbench_graph_nodes(made, &count, sizeof(thinbench_graph_node))[4].kind == 4);
  CHECK(count == 5);
  thinbench_graph_destroy(made);
  pruning.min_length = 2.5;
  SUCCEEDS(thinbench_prune(&image, &to, &pruning, NULL, &made));
  CHECK((classes[2] + classes[7] + classes[10] + classes[12] + classes[14]) / 255 == 3);
  CHECK(thinbench_graph_edges(made, &count, sizeof(thinbench_graph_edge)) != NULL && count == 1);
  thinbench_graph_destroy(made);
  rejects(thinbench_edge_widths(graph, &reals, NULL, widths, 8), "size: expected 32, got 8");
  rejects(thinbench_edge_widths(graph, &reals, NULL, NULL, sizeof(*widths)), "widths is NULL");
  rejects(thinbench_split_graph(graph, elsewhere, 1, &made), "nodes: expected pixels");
  rejects(thinbench_split_graph(graph, NULL, 1, &made), "pixels");
  rejects(thinbench_split_graph(NULL, middle, 1, &made), "graph");
  rejects(thinbench_prune(&image, &to, NULL, NULL, &made), "pruning");
  CHECK(made == NULL);
  reals.height = 1;
  rejects(thinbench_edge_widths(graph, &reals, NULL, widths, sizeof(*widths)), "distances");
  thinbench_graph_destroy(graph);
}

static void finds_the_graphs_of_labels(void) {
  const thinbench_labels lines = labels_of(&labelled[0][0], 5, 3);
  int32_t kept[15];
  double distances[15];
  const thinbench_labels to = labels_of(kept, 5, 3);
  thinbench_reals reals = reals_of(distances, 5, 3);
  thinbench_pruning pruning = THINBENCH_PRUNING_INIT;
  const int32_t* of_nodes;
  size_t count = 0;
  thinbench_graph* graph = NULL;
  pruning.min_length = 1.5;
  draw();
  SUCCEEDS(thinbench_graph_of_labels(&lines, NULL, &graph));
  of_nodes = thinbench_graph_node_labels(graph, &count, sizeof(int32_t));
  CHECK(count == 6 && of_nodes[0] == 4 && of_nodes[3] == 4 && of_nodes[4] == 7);
  thinbench_graph_destroy(graph);
  SUCCEEDS(thinbench_distances_of_labels(&lines, &reals, NULL, NULL));
  CHECK(distances[4] == 1 && distances[0] == 0 && distances[8] == 1);
  SUCCEEDS(thinbench_prune_labels(&lines, &to, &pruning, NULL, &graph));
  CHECK(kept[4] == 7 && kept[5] == 4 && labelled[0][2] == 4 && kept[2] * kept[8] == 0);
  thinbench_graph_destroy(graph);
  rejects(thinbench_prune_labels(&lines, &to, NULL, NULL, NULL), "pruning");
  rejects(thinbench_graph_of_labels(&lines, NULL, NULL), "graph");
  reals.data = NULL;
  rejects(thinbench_distances_of_labels(&lines, &reals, NULL, NULL), "distances has no data");
}

static void finds_paths_through_a_graph(void) {
  const thinbench_link links[4] = {{0, 1, 1}, {1, 2, 2}, {2, 0, 5}, {3, 3, 7}};
  uint32_t components[4];
  size_t count = 0;
  thinbench_graph_paths* paths = NULL;
  const thinbench_graph_path* list;
  draw();
  SUCCEEDS(thinbench_components_of(4, links, 4, components));
  CHECK(components[0] == 0 && components[2] == 0 && components[3] == 1);
  SUCCEEDS(thinbench_shortest_path(4, links, 4, 0, 2, &paths));
  list = thinbench_graph_paths_list(paths, &count, sizeof(thinbench_graph_path));
  CHECK(count == 1 && list[0].length == 3 && list[0].node_count == 3);
  CHECK(list[0].first_point == -1 && list[0].last_point == -1);
  CHECK(thinbench_graph_paths_nodes(paths, &count, sizeof(uint32_t))[1] == 1 && count == 3);
  CHECK(thinbench_graph_paths_edges(paths, &count, sizeof(uint32_t))[1] == 1 && count == 2);
  CHECK(thinbench_graph_paths_list(paths, &count, 1) == NULL && count == 0);
  CHECK(thinbench_graph_paths_list(NULL, &count, sizeof(thinbench_graph_path)) == NULL);
  thinbench_graph_paths_destroy(paths);
  SUCCEEDS(thinbench_cycles(4, links, 4, &paths));
  CHECK(thinbench_graph_paths_list(paths, &count, sizeof(thinbench_graph_path)) && count == 2);
  thinbench_graph_paths_destroy(paths);
  SUCCEEDS(thinbench_shortest_path(4, links, 4, 0, 3, &paths));
  CHECK(thinbench_graph_paths_list(paths, &count, sizeof(thinbench_graph_path)) == NULL ||
        count == 0);
  thinbench_graph_paths_destroy(paths);
  thinbench_graph_paths_destroy(NULL);
  rejects(thinbench_cycles(3, links, 4, &paths), "link 3: expected nodes below 3, got 3 and 3");
  rejects(thinbench_cycles(3, NULL, 4, &paths), "links");
  CHECK(paths == NULL);
}

static void finds_the_main_path_of_a_ring(void) {
  static const uint8_t ring[3][3] = {{0, 1, 0}, {1, 0, 1}, {0, 1, 0}};
  const thinbench_image image = view_of(&ring[0][0], 3, 3);
  size_t edge_count = 0, pixel_count = 0, count = 0;
  thinbench_graph* graph = NULL;
  thinbench_graph_paths* paths = NULL;
  const thinbench_graph_edge* edges;
  const thinbench_pixel* line_pixels;
  const thinbench_graph_path* list;
  draw();
  SUCCEEDS(thinbench_skeleton_graph(&image, NULL, &graph));
  edges = thinbench_graph_edges(graph, &edge_count, sizeof(thinbench_graph_edge));
  line_pixels = thinbench_graph_edge_pixels(graph, &pixel_count, sizeof(thinbench_pixel));
  SUCCEEDS(thinbench_main_paths(1, edges, edge_count, line_pixels, pixel_count, NULL, &paths));
  list = thinbench_graph_paths_list(paths, &count, sizeof(thinbench_graph_path));
  CHECK(count == 1 && list[0].node_count == 1 && list[0].edge_count == 1);
  CHECK(list[0].first_point == -1 && line_pixels[list[0].last_point].y == 2);
  thinbench_graph_paths_destroy(paths);
  rejects(thinbench_main_paths(0, edges, edge_count, line_pixels, pixel_count, NULL, &paths),
          "link 0: expected nodes below 0, got 0 and 0");
  rejects(thinbench_main_paths(1, edges, edge_count, line_pixels, 2, NULL, &paths),
          "edge 0: expected pixels below 2, got 3 from 0");
  rejects(thinbench_main_paths(1, NULL, 1, line_pixels, pixel_count, NULL, &paths), "edges");
  CHECK(paths == NULL);
  thinbench_graph_destroy(graph);
}

static void finds_a_path_for_a_robot(void) {
  static const uint8_t map[3][5] = {{1, 1, 0, 1, 1}, {1, 1, 1, 1, 1}, {1, 1, 0, 1, 1}};
  const thinbench_image free_space = view_of(&map[0][0], 5, 3);
  thinbench_path_request request = THINBENCH_PATH_REQUEST_INIT;
  thinbench_found_path found = THINBENCH_FOUND_PATH_INIT;
  thinbench_pixel way[15];
  draw();
  request.start.y = request.goal.y = 1;
  request.goal.x = 4;
  request.width = 2;
  SUCCEEDS(thinbench_find_path(&free_space, &request, NULL, way, 15, &found));
  CHECK(found.count == 5 && found.length == 4 && found.min_width == 2);
  CHECK(way[2].x == 2 && way[2].y == 1);
  way[2].x = 77;
  SUCCEEDS(thinbench_find_path(&free_space, &request, NULL, way, 2, &found));
  CHECK(found.count == 5 && way[1].x == 1 && way[2].x == 77);
  SUCCEEDS(thinbench_find_path(&free_space, &request, NULL, NULL, 0, &found));
  CHECK(found.count == 5);
  rejects(thinbench_find_path(&free_space, &request, NULL, NULL, 1, &found), "pixels");
  rejects(thinbench_find_path(&free_space, &request, NULL, way, 15, NULL), "found");
  rejects(thinbench_find_path(&free_space, NULL, NULL, way, 15, &found), "request");
  request.width = 3;
  SUCCEEDS(thinbench_find_path(&free_space, &request, NULL, way, 15, &found));
  CHECK(found.count == 0);
  request.goal.x = -1;
  rejects(thinbench_find_path(&free_space, &request, NULL, way, 15, &found), "goal: ");
}

static void simplifies_lines(void) {
  thinbench_spacing nothing = THINBENCH_SPACING_INIT;
  thinbench_pixel points[3] = {{0, 0}, {1, 1}, {2, 0}};
  size_t count = 0;
  nothing.x = 0;
  draw();
  SUCCEEDS(thinbench_polyline(points, 3, 0.5, NULL, points, &count));
  CHECK(count == 3);
  SUCCEEDS(thinbench_polyline(points, 3, 1, NULL, points, &count));
  CHECK(count == 2 && points[1].x == 2 && points[1].y == 0);
  SUCCEEDS(thinbench_polyline(NULL, 0, 1, NULL, NULL, &count));
  CHECK(count == 0);
  rejects(thinbench_polyline(points, 2, 1, &nothing, points, &count), "spacing");
}

/* As a program that was compiled with a later version would call, or one that errs. */
static void checks_the_sizes_of_structs(void) {
  struct {
    thinbench_execution execution;
    int64_t more;
  } later = {THINBENCH_EXECUTION_INIT, 0};
  struct {
    thinbench_image image;
    int64_t more;
  } sources[2], destinations[2];
  thinbench_thinning thinning = THINBENCH_THINNING_INIT;
  thinbench_execution execution = THINBENCH_EXECUTION_INIT;
  thinbench_binarisation request = THINBENCH_BINARISATION_INIT;
  int i;
  later.execution.size = sizeof(later);
  draw();
  for (i = 0; i < 2; ++i) {
    sources[i].image = view_of(&pixels[i][0][0], WIDTH, HEIGHT);
    destinations[i].image = view_of(&results[i][0][0], WIDTH, HEIGHT);
    sources[i].image.size = destinations[i].image.size = sizeof(sources[i]);
    sources[i].more = destinations[i].more = 0;
  }
  sources[1].more = -1;
  rejects(thinbench_thin_many(guo_hall, &sources->image, &destinations->image, 2, NULL, NULL, NULL),
          "sources: byte 48 is not 0");
  sources[1].more = 0;
  SUCCEEDS(thinbench_thin_many(guo_hall, &sources->image, &destinations->image, 2, NULL,
                               &later.execution, NULL));
  CHECK(memchr(results[1], 255, sizeof(results[1])) != NULL);
  draw();
  sources[1].image.size -= 8;
  rejects(thinbench_thin_many(guo_hall, &sources->image, &destinations->image, 2, NULL, NULL, NULL),
          "sources: expected structs of one size");
  later.more = -1;
  rejects(thinbench_thin(guo_hall, &one, &output, NULL, &later.execution, NULL),
          "execution: byte 24 is not 0");
  rejects(thinbench_thin(guo_hall, NULL, &output, NULL, NULL, NULL), "source");
  rejects(thinbench_thin(guo_hall, &one, NULL, NULL, NULL, NULL), "destination");
  execution.isa = "mmx";
  rejects(thinbench_thin(guo_hall, &one, &output, NULL, &execution, NULL), "'mmx'");
  execution.size = 4;
  rejects(thinbench_thin(guo_hall, &one, &output, NULL, &execution, NULL), "got 4");
  thinning.reserved = 1;
  rejects(thinbench_thin(guo_hall, &one, &output, &thinning, NULL, NULL), "thinning.reserved");
  sources[0].image.size = 3;
  rejects(thinbench_thin(guo_hall, &sources->image, &output, NULL, NULL, NULL),
          "source.size: expected an integer in [48, 1024], got 3");
  request.size -= sizeof(request.reserved);
  rejects(thinbench_binarise(&one, &output, &request, NULL, NULL, NULL), "request.size");
}

int main(void) {
  one = view_of(&pixels[0][0][0], WIDTH, HEIGHT);
  output = view_of(&results[0][0][0], WIDTH, HEIGHT);
  labels = labels_of(&numbers[0][0], WIDTH, HEIGHT);
  all = stack_of(&pixels[0][0][0], COUNT);
  outputs = stack_of(&results[0][0][0], COUNT);
  CHECK(strcmp(thinbench_last_error(), "") == 0);
  SUCCEEDS(thinbench_rule_named("guo_hall", &guo_hall));
  macros_have_the_version();
  thins_images_stacks_and_lists();
  thins_labels_each_alone();
  finds_regions_and_labels();
  finds_edges_and_localises();
  fills_holes();
  writes_another_foreground();
  rules_are_made_from_tables();
  rules_apply_to_packed_images();
  scans_midpoints();
  rules_are_made_from_nets();
  selects_a_channel();
  binarises_grey_images();
  takes_levels_of_16_bits();
  describes_and_lists_what_there_is();
  takes_images_without_pixels();
  finds_the_graph_of_a_skeleton();
  finds_the_graphs_of_labels();
  finds_paths_through_a_graph();
  finds_the_main_path_of_a_ring();
  finds_a_path_for_a_robot();
  simplifies_lines();
  checks_the_sizes_of_structs();
  thinbench_rule_destroy(guo_hall);
  thinbench_release_memory();
  if (failures == 0) printf("all passed\n");
  return failures;
}
