/* thinbench for C99: thinning, edges, distances, objects, holes and graphs of images.
 *
 * What can fail returns a status. After THINBENCH_INVALID_ARGUMENT nothing is written, and
 * thinbench_last_error() has one line that names the invalid value. No function throws, so
 * pthread_cancel inside a call ends the program. All functions are thread-safe for different
 * destinations and handles.
 *
 * A function has the name of the C++ function that does the same, with the prefix thinbench_; the
 * C++ headers say more, and docs/library.md lists what differs. Rules, edge operators, borders,
 * channels and ISAs go by the names that the program uses: "guo_hall", "sobel", "avx2".
 *
 * Arguments come in this order: what is read, images that are written, options, execution, and
 * other results: lists with their capacities, numbers and handles. Width is before height, x before
 * y. The foreground of an image is what is not 0; what is outside the image is background. A source
 * is never written, so a const pointer may be cast. Unless a comment says otherwise, a destination
 * has the size of its source, and is the source or shares no byte with it.
 *
 * A struct that begins with its size is made by its macro, which sets the size and the defaults:
 *
 *   thinbench_image image = THINBENCH_IMAGE_INIT;
 *   image.data = pixels;
 *   image.width = image.stride = 640;
 *   image.height = 480;
 *
 * Later versions add members at the end of such a struct. A library that is newer than the program
 * gives them their defaults; one that is older accepts them as long as they are 0. Members named
 * `reserved` must be 0. Of the other structs, thinbench_pixel, thinbench_link and
 * thinbench_graph_edge never change; elements of other lists may grow, so functions for lists are
 * told their size, and accept that of earlier versions, too. */
#ifndef THINBENCH_H
#define THINBENCH_H

#include <stddef.h>
#include <stdint.h>

#include "thinbench/export.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum thinbench_status {
  THINBENCH_OK = 0,
  THINBENCH_INVALID_ARGUMENT = 1,
  THINBENCH_OUT_OF_MEMORY = 2,
  THINBENCH_INTERNAL_ERROR = 3
} thinbench_status;

/* The version of the library, for example "1.0.0". */
THINBENCH_API const char* thinbench_version(void);

/* The message of this thread's last failure, at most 1023 bytes of it; "" if there was none. Valid
 * until its next failure. */
THINBENCH_API const char* thinbench_last_error(void);

/* Frees the memory that the calling thread keeps for its next calls: at most 8 MiB in 32 blocks. A
 * thread that ends frees it, too. Also frees as much for each worker that calls with several
 * threads have used at once, but for those at work in another call; after fork(), the child has a
 * copy.
 */
THINBENCH_API void thinbench_release_memory(void);

/* --- Images ---------------------------------------------------------------------------------- */

/* An image of one byte per pixel: pixel (x, y) is data[y * stride + x]. */
typedef struct thinbench_image {
  size_t size; /* of this struct */
  uint8_t* data;
  ptrdiff_t width;
  ptrdiff_t height;
  ptrdiff_t stride;
  uint8_t foreground; /* of a binary result: what is written instead of 255; 0 stands for 255 */
  uint8_t reserved[7];
} thinbench_image;

#define THINBENCH_IMAGE_INIT                     \
  {                                              \
    sizeof(thinbench_image), NULL, 0, 0, 0, 0, { \
      0                                          \
    }                                            \
  }

/* `count` images of one size: pixel (x, y) of image i is data[i * image_stride + y * stride + x].
 */
typedef struct thinbench_stack {
  size_t size; /* of this struct */
  uint8_t* data;
  ptrdiff_t count;
  ptrdiff_t width;
  ptrdiff_t height;
  ptrdiff_t stride;
  ptrdiff_t image_stride;
  uint8_t foreground; /* as that of thinbench_image */
  uint8_t reserved[7];
} thinbench_stack;

#define THINBENCH_STACK_INIT                           \
  {                                                    \
    sizeof(thinbench_stack), NULL, 0, 0, 0, 0, 0, 0, { \
      0                                                \
    }                                                  \
  }

/* A binary image of 8 pixels per byte. 1 is foreground. Every row starts with a new byte, and the
 * stride is in bytes. Unused bits of a row's last byte have no meaning; they are written as 0. */
typedef struct thinbench_packed {
  size_t size; /* of this struct */
  uint8_t* data;
  ptrdiff_t width; /* in pixels */
  ptrdiff_t height;
  ptrdiff_t stride;
  int32_t lsb_first; /* nonzero: the first pixel is the lowest bit; 0: the highest, as in PBM */
  int32_t reserved;
} thinbench_packed;

#define THINBENCH_PACKED_INIT \
  { sizeof(thinbench_packed), NULL, 0, 0, 0, 0, 0 }

/* An image of labels or other integers: that of (x, y) is data[y * stride + x]. */
typedef struct thinbench_labels {
  size_t size; /* of this struct */
  int32_t* data;
  ptrdiff_t width;
  ptrdiff_t height;
  ptrdiff_t stride; /* in integers */
} thinbench_labels;

#define THINBENCH_LABELS_INIT \
  { sizeof(thinbench_labels), NULL, 0, 0, 0 }

/* An image of real numbers: that of (x, y) is data[y * stride + x]. */
typedef struct thinbench_reals {
  size_t size; /* of this struct */
  double* data;
  ptrdiff_t width;
  ptrdiff_t height;
  ptrdiff_t stride; /* in numbers */
} thinbench_reals;

#define THINBENCH_REALS_INIT \
  { sizeof(thinbench_reals), NULL, 0, 0, 0 }

/* An image of colours: 3 or 4 bytes per pixel, which are red, green, blue and what is ignored. */
typedef struct thinbench_colours {
  size_t size; /* of this struct */
  uint8_t* data;
  ptrdiff_t width;
  ptrdiff_t height;
  ptrdiff_t stride; /* in bytes */
  int32_t samples;  /* 3 or 4 */
  int32_t reserved;
} thinbench_colours;

#define THINBENCH_COLOURS_INIT \
  { sizeof(thinbench_colours), NULL, 0, 0, 0, 3, 0 }

/* Images of 16 bits per pixel or sample; strides are in these. */
typedef struct thinbench_image16 {
  size_t size; /* of this struct */
  uint16_t* data;
  ptrdiff_t width;
  ptrdiff_t height;
  ptrdiff_t stride;
} thinbench_image16;

#define THINBENCH_IMAGE16_INIT \
  { sizeof(thinbench_image16), NULL, 0, 0, 0 }

typedef struct thinbench_colours16 {
  size_t size; /* of this struct */
  uint16_t* data;
  ptrdiff_t width;
  ptrdiff_t height;
  ptrdiff_t stride;
  int32_t samples; /* 3 or 4 */
  int32_t reserved;
} thinbench_colours16;

#define THINBENCH_COLOURS16_INIT \
  { sizeof(thinbench_colours16), NULL, 0, 0, 0, 3, 0 }

typedef struct thinbench_pixel {
  int32_t x;
  int32_t y;
} thinbench_pixel;

/* How far the centres of neighbouring columns (x) and rows (y) are apart, in any unit, from 1e-30
 * to 1e30. Where a function takes a spacing, NULL stands for 1, 1. */
typedef struct thinbench_spacing {
  size_t size; /* of this struct */
  double x;
  double y;
} thinbench_spacing;

#define THINBENCH_SPACING_INIT \
  { sizeof(thinbench_spacing), 1, 1 }

/* How a result is computed, which never changes a pixel. NULL stands for the defaults. */
typedef struct thinbench_execution {
  size_t size;     /* of this struct */
  int32_t threads; /* the maximum number, 1 to 1024 */
  const char* isa; /* the highest to use; NULL: the highest that this machine has */
} thinbench_execution;

#define THINBENCH_EXECUTION_INIT \
  { sizeof(thinbench_execution), 1, NULL }

/* Names of ISAs, from the lowest; NULL past the end. Valid as long as the program. */
THINBENCH_API const char* thinbench_isa_name(size_t index);

/* Whether the processor has this ISA and THINBENCH_MAX_ISA allows it: 1, 0, or -1 for an unknown
 * name. */
THINBENCH_API int32_t thinbench_isa_available(const char* isa);

/* --- Rules ----------------------------------------------------------------------------------- */

/* What thinning computes: thinbench/rule.hpp. All functions that take a rule take every rule.
 * Immutable: threads may use it at the same time. */
typedef struct thinbench_rule thinbench_rule;

/* No limit of iterations. */
#define THINBENCH_UNLIMITED INT32_MAX

/* What a call may change about a rule. NULL stands for the defaults. */
typedef struct thinbench_thinning {
  size_t size;            /* of this struct */
  const char* border;     /* "background", "keep" or "foreground"; NULL: as the rule says */
  int32_t max_iterations; /* 1 to THINBENCH_UNLIMITED; 0: as the rule says */
  int32_t reserved;
} thinbench_thinning;

#define THINBENCH_THINNING_INIT \
  { sizeof(thinbench_thinning), NULL, 0, 0 }

/* The functions that make a rule set *rule, which must be destroyed; NULL on failure. */

/* By the name of a built-in rule, of its operation ("thin_guo_hall"), or of a named rule. */
THINBENCH_API thinbench_status thinbench_rule_named(const char* name, thinbench_rule** rule);

/* A table of a rule: 512 bits, the new value of a pixel for each of the 512 values of its
 * 3 x 3 window. Bit k of a window is its pixel k in raster order, so bit 0 is the north-west
 * neighbour, bit 4 the pixel itself and bit 8 the south-east neighbour; 1 is foreground. The bit of
 * window w is bit w % 64 of word w / 64. */
#define THINBENCH_TABLE_WORDS 8

/* Tables from notations; `table` gets THINBENCH_TABLE_WORDS words. Meaning and orders are those of
 * thinbench/rule_notation.hpp. */
/* Hensel's notation, such as "B3/S23" or "B2-a/S12". */
THINBENCH_API thinbench_status thinbench_table_from_hensel(const char* notation, uint64_t* table);
/* `count` patterns of Pillow's ImageMorph.LutBuilder, such as "4:(... .1. 111)->1". */
THINBENCH_API thinbench_status thinbench_table_from_patterns(const char* const* patterns,
                                                             size_t count, uint64_t* table);
/* 512 values, 0 or 1, by windows whose bits are in the order "raster" (as above), "matlab" or
 * "octave" (makelut of either). */
THINBENCH_API thinbench_status thinbench_table_from_values(const uint8_t* values, const char* order,
                                                           uint64_t* table);
/* 256 values, 1 where a foreground pixel with these neighbours becomes background, else 0. Bits of
 * the index are in the order "descriptor" (east, then anticlockwise: scikit-image's thin),
 * "clockwise" (from north-west: scikit-image's skeletonize) or "raster". */
THINBENCH_API thinbench_status thinbench_table_from_removals(const uint8_t* removed,
                                                             const char* order, uint64_t* table);

/* A rule of 1 to 8 sub-iterations, each a table. All pixels of a sub-iteration are computed from
 * the same image. `tables` has sub_iterations * THINBENCH_TABLE_WORDS words, which are copied.
 * `defaults` may be NULL: background outside, no limit. A rule that both adds and removes pixels
 * needs a limit, here or in each call. `optimise` nonzero: search for fewer gates, up to 2 s per
 * table. */
THINBENCH_API thinbench_status thinbench_rule_from_tables(const uint64_t* tables,
                                                          size_t sub_iterations,
                                                          const thinbench_thinning* defaults,
                                                          int32_t optimise, thinbench_rule** rule);
/* The two-layer net of the paper with other weights: 9 neurons of 8 weights and a bias, the output
 * neuron last. The activation is "sigmoid" or "linear". */
THINBENCH_API thinbench_status thinbench_rule_from_two_layer_net(const float* weights,
                                                                 const char* activation,
                                                                 thinbench_rule** rule);
/* The cluster of nets with other weights: net i has the descriptors up to last[i], and 8 weights
 * and a bias at weights + 9 * i. */
THINBENCH_API thinbench_status thinbench_rule_from_cluster(const int32_t* last,
                                                           const float* weights, size_t count,
                                                           thinbench_rule** rule);
/* NULL is allowed. */
THINBENCH_API void thinbench_rule_destroy(thinbench_rule* rule);

/* Valid as long as the rule; strings of built-in and named rules as long as the program. */
typedef struct thinbench_rule_info {
  size_t size;             /* of this struct */
  const char* name;        /* "custom" for tables, "net" for weights */
  const char* description; /* NULL for these */
  const char* source;      /* of named rules; else NULL */
  int32_t built_in;        /* nonzero: one of the catalogue */
  const uint64_t* tables;  /* one after the other; NULL if it is no function of 3 x 3 pixels */
  size_t sub_iterations;   /* number of tables */
  const char* border;
  int32_t max_iterations;
  /* How far the effect of a pixel advances in an iteration, in pixels along rows and columns. What
   * is farther than iterations * reach from a pixel does not change it. */
  int32_t reach;
} thinbench_rule_info;

#define THINBENCH_RULE_INFO_INIT \
  { sizeof(thinbench_rule_info), NULL, NULL, NULL, 0, NULL, 0, NULL, 0, 0 }

THINBENCH_API thinbench_status thinbench_rule_describe(const thinbench_rule* rule,
                                                       thinbench_rule_info* info);
/* The number of three-input gates of a sub-iteration's circuit. */
THINBENCH_API thinbench_status thinbench_rule_gates(const thinbench_rule* rule,
                                                    size_t sub_iteration, int32_t* gates);
/* Names, first of all built-in rules, then of all named rules; NULL past the end. Valid as long as
 * the program. */
THINBENCH_API const char* thinbench_rule_name(size_t index);

/* --- Thinning -------------------------------------------------------------------------------- */

/* Applies a rule to an image. *iterations becomes the number of iterations, including the last one
 * if it changed nothing; it may be NULL, here and below. */
THINBENCH_API thinbench_status thinbench_thin(
    const thinbench_rule* rule, const thinbench_image* source, const thinbench_image* destination,
    const thinbench_thinning* thinning, const thinbench_execution* execution, int32_t* iterations);

/* To every image of a stack; *iterations becomes the maximum over all images. */
THINBENCH_API thinbench_status thinbench_thin_stack(
    const thinbench_rule* rule, const thinbench_stack* source, const thinbench_stack* destination,
    const thinbench_thinning* thinning, const thinbench_execution* execution, int32_t* iterations);

/* To `count` images of any sizes, from sources[i] to destinations[i]. The same result as
 * thinbench_thin for each, but faster for many small images. A destination is its source or shares
 * no byte with any image of the lists. *iterations becomes the maximum. */
THINBENCH_API thinbench_status thinbench_thin_many(const thinbench_rule* rule,
                                                   const thinbench_image* sources,
                                                   const thinbench_image* destinations,
                                                   size_t count, const thinbench_thinning* thinning,
                                                   const thinbench_execution* execution,
                                                   int32_t* iterations);

/* To a packed image. Bit orders may differ. */
THINBENCH_API thinbench_status thinbench_thin_packed(
    const thinbench_rule* rule, const thinbench_packed* source, const thinbench_packed* destination,
    const thinbench_thinning* thinning, const thinbench_execution* execution, int32_t* iterations);

/* To every label as if it were alone in the image: a pixel keeps its label where the label's
 * skeleton has it, else it becomes 0. 0 is background; negative labels are rejected. *iterations
 * becomes the maximum over all labels. */
THINBENCH_API thinbench_status thinbench_thin_labels(
    const thinbench_rule* rule, const thinbench_labels* source, const thinbench_labels* destination,
    const thinbench_thinning* thinning, const thinbench_execution* execution, int32_t* iterations);

/* Thins images of one size with memory allocated once. One call at a time. */
typedef struct thinbench_thinner thinbench_thinner;

/* *thinner must be destroyed; NULL on failure. */
THINBENCH_API thinbench_status thinbench_thinner_create(const thinbench_rule* rule, ptrdiff_t width,
                                                        ptrdiff_t height,
                                                        const thinbench_thinning* thinning,
                                                        const thinbench_execution* execution,
                                                        thinbench_thinner** thinner);
/* Thins one image of this size. */
THINBENCH_API thinbench_status thinbench_thinner_run(thinbench_thinner* thinner,
                                                     const thinbench_image* source,
                                                     const thinbench_image* destination,
                                                     int32_t* iterations);
/* NULL is allowed. */
THINBENCH_API void thinbench_thinner_destroy(thinbench_thinner* thinner);

/* --- Binary images, edges and distances ------------------------------------------------------ */

#define THINBENCH_OTSU (-1)  /* the threshold by Otsu's method */
#define THINBENCH_LOCAL (-2) /* a threshold for each pixel, from the mean around it */

/* What is foreground: thinbench/binarise.hpp. NULL stands for the defaults. */
typedef struct thinbench_binarisation {
  size_t size;            /* of this struct */
  const char* foreground; /* "auto", "bright" or "dark"; NULL: "auto" */
  int32_t threshold;      /* 0 to the highest level, THINBENCH_OTSU or THINBENCH_LOCAL */
  /* Of the local threshold alone: */
  int32_t window; /* odd, 3 to 65535; 0: by the image's size */
  int32_t offset; /* -1: 10, of 16 bits 10 / 255 of their range */
  int32_t reserved;
} thinbench_binarisation;

#define THINBENCH_BINARISATION_INIT \
  { sizeof(thinbench_binarisation), NULL, THINBENCH_OTSU, 0, -1, 0 }

/* Writes 255 on the foreground of a grey image and 0 elsewhere. *foreground becomes "bright" or
 * "dark" and *threshold the level from which pixels are bright, unless local; each may be NULL. */
THINBENCH_API thinbench_status thinbench_binarise(const thinbench_image* grey,
                                                  const thinbench_image* destination,
                                                  const thinbench_binarisation* request,
                                                  const thinbench_execution* execution,
                                                  const char** foreground, int32_t* threshold);

/* Writes a channel as a grey image, which shares no byte with the colours: "grey", "red", "green",
 * "blue", "saturation", "value" or "auto". *chosen, which may be NULL, becomes its name. */
THINBENCH_API thinbench_status thinbench_select_channel(const thinbench_colours* colours,
                                                        const thinbench_image* destination,
                                                        const char* channel,
                                                        const thinbench_execution* execution,
                                                        const char** chosen);

/* The same for levels of 16 bits, from 0 to 65535. Nothing is done in place. */
THINBENCH_API thinbench_status thinbench_binarise16(const thinbench_image16* grey,
                                                    const thinbench_image* destination,
                                                    const thinbench_binarisation* request,
                                                    const thinbench_execution* execution,
                                                    const char** foreground, int32_t* threshold);
THINBENCH_API thinbench_status thinbench_select_channel16(const thinbench_colours16* colours,
                                                          const thinbench_image16* destination,
                                                          const char* channel,
                                                          const thinbench_execution* execution,
                                                          const char** chosen);

/* The directions of the midpoint scan, to be combined by |. */
#define THINBENCH_ROWS 1          /* west to east */
#define THINBENCH_COLUMNS 2       /* north to south */
#define THINBENCH_DIAGONALS 4     /* north-west to south-east */
#define THINBENCH_ANTIDIAGONALS 8 /* north-east to south-west */
#define THINBENCH_ALL_DIRECTIONS 15

/* Marks the midpoint of every run of foreground pixels along each direction. The border is
 * "background" or "keep"; NULL stands for the first. */
THINBENCH_API thinbench_status thinbench_midpoint_scan(const thinbench_image* source,
                                                       const thinbench_image* destination,
                                                       int32_t directions, const char* border,
                                                       const thinbench_execution* execution);

/* Edges of a grey image by "sobel", "prewitt", "roberts4", "roberts9", "mero_vassy" or
 * "mero_vassy_5x5"; thresholds from 0 to 255 (40 and 128 are usual). Source and destination share
 * no byte. */
THINBENCH_API thinbench_status thinbench_detect_edges(
    const char* edge_operator, const thinbench_image* source, const thinbench_image* destination,
    int32_t gradient_threshold, int32_t brightness_threshold, const thinbench_execution* execution);

/* Names, in the order of the catalogue; NULL past the end. Valid as long as the program. */
THINBENCH_API const char* thinbench_edge_operator_name(size_t index);

/* The square of the Euclidean distance from each pixel to its nearest background pixel; INT32_MAX
 * in an image without background. What is outside the image does not count. Sides are at most
 * 32767. Source and distances share no byte. */
THINBENCH_API thinbench_status thinbench_squared_distances(const thinbench_image* source,
                                                           const thinbench_labels* distances,
                                                           const thinbench_execution* execution);

/* The distances themselves, in the unit of the spacing; infinity in an image without background. */
THINBENCH_API thinbench_status thinbench_distances(const thinbench_image* source,
                                                   const thinbench_reals* distances,
                                                   const thinbench_spacing* spacing,
                                                   const thinbench_execution* execution);

/* The distance from each pixel of a label to the nearest pixel without this label; 0 on background.
 */
THINBENCH_API thinbench_status thinbench_distances_of_labels(const thinbench_labels* labels,
                                                             const thinbench_reals* distances,
                                                             const thinbench_spacing* spacing,
                                                             const thinbench_execution* execution);

/* --- Objects and holes ----------------------------------------------------------------------- */

/* An object (8-connected) or a hole (4-connected background that does not touch the border). */
typedef struct thinbench_region {
  int64_t area;
  int64_t sum_x; /* of the pixels' coordinates: the centre is (sum_x / area, sum_y / area) */
  int64_t sum_y;
  int32_t left;
  int32_t top;
  int32_t right; /* inclusive, as is `bottom` */
  int32_t bottom;
  uint32_t enclosing_object; /* of a hole: the object around it, counted from 1; else 0 */
  uint32_t reserved;
} thinbench_region;

/* Objects and holes, in raster order of their first pixels. The functions that make them set
 * *regions, which must be destroyed; NULL on failure. */
typedef struct thinbench_regions thinbench_regions;

THINBENCH_API thinbench_status thinbench_find_regions(const thinbench_image* source,
                                                      const thinbench_execution* execution,
                                                      thinbench_regions** regions);
/* Also writes labels: every pixel gets the number of its object from 1, or the number of objects
 * plus that of its hole, or 0. Source and labels share no byte, here and below. */
THINBENCH_API thinbench_status thinbench_label_regions(const thinbench_image* source,
                                                       const thinbench_labels* labels,
                                                       const thinbench_execution* execution,
                                                       thinbench_regions** regions);
/* Objects alone, in less time; there are no holes. */
THINBENCH_API thinbench_status thinbench_find_objects(const thinbench_image* source,
                                                      const thinbench_execution* execution,
                                                      thinbench_regions** regions);
/* Objects alone, of connectivity 8 or 4, and their labels. `order`: "pixels" or NULL, as above, or
 * "opencv", as OpenCV's connectedComponents numbers objects: those that are 8-connected in raster
 * order of their first blocks of 2 x 2 pixels. */
THINBENCH_API thinbench_status thinbench_label_objects(const thinbench_image* source,
                                                       const thinbench_labels* labels,
                                                       int32_t connectivity, const char* order,
                                                       const thinbench_execution* execution,
                                                       thinbench_regions** regions);
/* The same labels without the list, in less time; *objects becomes the number of objects. */
THINBENCH_API thinbench_status thinbench_label_image(const thinbench_image* source,
                                                     const thinbench_labels* labels,
                                                     int32_t connectivity, const char* order,
                                                     const thinbench_execution* execution,
                                                     uint32_t* objects);
/* Labels components of equal values in an image of any values: pixels with one value that are 8- or
 * 4-connected. Those with the value `background` get 0. *components becomes their number. */
THINBENCH_API thinbench_status thinbench_label_values(const thinbench_labels* values,
                                                      const thinbench_labels* labels,
                                                      int32_t connectivity, int32_t background,
                                                      const thinbench_execution* execution,
                                                      uint32_t* components);
/* Sobel's edges of a grey image, filled, and the regions of the result, which `objects` gets unless
 * it is NULL. */
THINBENCH_API thinbench_status thinbench_localise_objects(const thinbench_image* grey,
                                                          const thinbench_image* objects,
                                                          int32_t gradient_threshold,
                                                          int32_t brightness_threshold,
                                                          const thinbench_execution* execution,
                                                          thinbench_regions** regions);

/* The lists, which live as long as the handle; `size` is sizeof(thinbench_region). Returns NULL and
 * sets *count to 0 if there are no regions, the handle is NULL, or `size` is not that of this or an
 * earlier version's struct. `count` may be NULL. */
THINBENCH_API const thinbench_region* thinbench_regions_objects(const thinbench_regions* regions,
                                                                size_t* count, size_t size);
THINBENCH_API const thinbench_region* thinbench_regions_holes(const thinbench_regions* regions,
                                                              size_t* count, size_t size);
/* NULL is allowed. */
THINBENCH_API void thinbench_regions_destroy(thinbench_regions* regions);

/* Which holes are filled. NULL stands for the defaults. */
typedef struct thinbench_hole_filling {
  size_t size;          /* of this struct */
  int64_t max_area;     /* only holes of at most so many pixels; INT64_MAX: all */
  int32_t connectivity; /* of objects, 8 or 4; that of holes is the other one */
  int32_t reserved;
} thinbench_hole_filling;

#define THINBENCH_HOLE_FILLING_INIT \
  { sizeof(thinbench_hole_filling), INT64_MAX, 8, 0 }

/* Writes 255 on objects and in holes. With a maximum area, objects inside a hole do not count and
 * stay as they are. */
THINBENCH_API thinbench_status thinbench_fill_holes(const thinbench_image* source,
                                                    const thinbench_image* destination,
                                                    const thinbench_hole_filling* filling,
                                                    const thinbench_execution* execution);

/* Fills the holes of labels: background gets the label of the innermost hole around it, as
 * thinbench/regions.hpp says. */
THINBENCH_API thinbench_status thinbench_fill_holes_of_labels(const thinbench_labels* source,
                                                              const thinbench_labels* destination,
                                                              const thinbench_hole_filling* filling,
                                                              const thinbench_execution* execution);

/* Objects minus holes; connectivity 8 or 4 is that of the objects. */
THINBENCH_API thinbench_status thinbench_euler_number(const thinbench_image* source,
                                                      int32_t connectivity,
                                                      const thinbench_execution* execution,
                                                      int64_t* number);

/* --- Graphs of skeletons --------------------------------------------------------------------- */

/* What each pixel is (0: background, 1: isolated, 2: end, 3: line, 4: junction), and to how many
 * neighbours it is joined: thinbench/graph.hpp. Either result may be NULL; the three images share
 * no byte. */
THINBENCH_API thinbench_status thinbench_classify_pixels(const thinbench_image* image,
                                                         const thinbench_image* classes,
                                                         const thinbench_image* degrees,
                                                         const thinbench_execution* execution);

/* How many blocks of 2 x 2 foreground pixels an image has, by which it is not thin, and the upper
 * left pixel of the first. `first` may be NULL. */
THINBENCH_API thinbench_status thinbench_full_blocks(const thinbench_image* image,
                                                     const thinbench_execution* execution,
                                                     int64_t* count, thinbench_pixel* first);

typedef struct thinbench_graph_node {
  int32_t kind;         /* 0: isolated pixel, 1: end, 2: junction, 3: first pixel of a closed line,
                           4: given to thinbench_split_graph */
  uint32_t first_pixel; /* in the list of the pixels of nodes */
  uint32_t pixel_count;
} thinbench_graph_node;

/* From `start`, a pixel of node `from`, by the pixels of the line to `stop`, a pixel of node `to`.
 * The length is horizontal_steps * spacing x + vertical_steps * spacing y + diagonal_steps * the
 * length of a diagonal. A loop within a junction has no pixels and no steps. */
typedef struct thinbench_graph_edge {
  uint32_t from;
  uint32_t to; /* at least `from` */
  thinbench_pixel start;
  thinbench_pixel stop;
  uint32_t first_pixel; /* in the list of the pixels of edges */
  uint32_t pixel_count;
  uint32_t horizontal_steps;
  uint32_t vertical_steps;
  uint32_t diagonal_steps;
} thinbench_graph_edge;

/* Nodes joined by lines; thinbench/graph.hpp says what they are, and in which order. The functions
 * that make a graph set *graph, which must be destroyed; NULL on failure. */
typedef struct thinbench_graph thinbench_graph;

THINBENCH_API thinbench_status thinbench_skeleton_graph(const thinbench_image* skeleton,
                                                        const thinbench_execution* execution,
                                                        thinbench_graph** graph);

/* The graphs of all labels, one after another, in the order of the labels:
 * thinbench/graph_labels.hpp. Pixels with different labels are not joined. */
THINBENCH_API thinbench_status thinbench_graph_of_labels(const thinbench_labels* skeletons,
                                                         const thinbench_execution* execution,
                                                         thinbench_graph** graph);

/* A graph with more nodes, one at each of these pixels of lines: thinbench/graph_parts.hpp. It
 * knows no labels. */
THINBENCH_API thinbench_status thinbench_split_graph(const thinbench_graph* graph,
                                                     const thinbench_pixel* pixels, size_t count,
                                                     thinbench_graph** split);

typedef struct thinbench_pruning {
  size_t size;       /* of this struct */
  double min_length; /* removes end branches below it */
  double min_widths; /* and below so many widths of the object at their junction */
  const thinbench_reals*
      distances; /* of the image before it was thinned; may be NULL without min_widths */
  const thinbench_spacing* spacing; /* that of the distances and of min_length */
  int32_t removes_components;       /* nonzero: also short lines and pixels on their own */
  int32_t reserved;
} thinbench_pruning;

#define THINBENCH_PRUNING_INIT \
  { sizeof(thinbench_pruning), 0, 0, NULL, NULL, 0, 0 }

/* Removes short branches of a skeleton, of equal ones the first, until none is left. `graph` may be
 * NULL; otherwise *graph is that of the result. */
THINBENCH_API thinbench_status thinbench_prune(const thinbench_image* skeleton,
                                               const thinbench_image* destination,
                                               const thinbench_pruning* pruning,
                                               const thinbench_execution* execution,
                                               thinbench_graph** graph);

/* Those of the skeleton of each label as if it were alone; pixels that are removed become 0. The
 * distances are thinbench_distances_of_labels() of what was thinned. */
THINBENCH_API thinbench_status thinbench_prune_labels(const thinbench_labels* skeletons,
                                                      const thinbench_labels* destination,
                                                      const thinbench_pruning* pruning,
                                                      const thinbench_execution* execution,
                                                      thinbench_graph** graph);

/* The lists of a graph, as those of regions. */
THINBENCH_API const thinbench_graph_node* thinbench_graph_nodes(const thinbench_graph* graph,
                                                                size_t* count, size_t size);
THINBENCH_API const thinbench_graph_edge* thinbench_graph_edges(const thinbench_graph* graph,
                                                                size_t* count, size_t size);
THINBENCH_API const thinbench_pixel* thinbench_graph_node_pixels(const thinbench_graph* graph,
                                                                 size_t* count, size_t size);
THINBENCH_API const thinbench_pixel* thinbench_graph_edge_pixels(const thinbench_graph* graph,
                                                                 size_t* count, size_t size);
/* The label of each node; none for a graph that is not one of labels. */
THINBENCH_API const int32_t* thinbench_graph_node_labels(const thinbench_graph* graph,
                                                         size_t* count, size_t size);
/* NULL is allowed. */
THINBENCH_API void thinbench_graph_destroy(thinbench_graph* graph);

/* Twice the distance to the background along an edge, both ends included; infinity without
 * background. */
typedef struct thinbench_widths {
  double mean;
  double median;
  double min;
  double max;
} thinbench_widths;

/* Those of every edge, in the order of the edges, for which `widths` has room; `size` is
 * sizeof(thinbench_widths). The distances are those of the image before it was thinned. */
THINBENCH_API thinbench_status thinbench_edge_widths(const thinbench_graph* graph,
                                                     const thinbench_reals* distances,
                                                     const thinbench_execution* execution,
                                                     thinbench_widths* widths, size_t size);

/* Keeps the first point of a line, the last and some between them, chosen so that no point is
 * farther than `tolerance`, in the unit of the spacing, from the polyline. `kept` has room for
 * `count` points and may be `points`; *kept_count becomes their number. */
THINBENCH_API thinbench_status thinbench_polyline(const thinbench_pixel* points, size_t count,
                                                  double tolerance,
                                                  const thinbench_spacing* spacing,
                                                  thinbench_pixel* kept, size_t* kept_count);

/* --- Paths ----------------------------------------------------------------------------------- */

/* An edge between nodes, by their numbers from 0. */
typedef struct thinbench_link {
  uint32_t from;
  uint32_t to;
  double length;
} thinbench_link;

/* Paths from node to node by links: thinbench/graph_paths.hpp. The functions that make them set
 * *paths, which must be destroyed; NULL on failure. */
typedef struct thinbench_graph_paths thinbench_graph_paths;

typedef struct thinbench_graph_path {
  double length;
  size_t first_node; /* in the list of nodes */
  size_t node_count;
  size_t first_edge; /* in the list of edges: numbers of links */
  size_t edge_count;
  int64_t
      first_point;    /* where a main path begins, of the pixels of its first edge; -1: at a node */
  int64_t last_point; /* where it ends, of those of its last edge */
} thinbench_graph_path;

/* The longest shortest path between nodes and pixels of lines, of every component of a graph with
 * so many nodes, these edges and the pixels of edges. */
THINBENCH_API thinbench_status
thinbench_main_paths(uint32_t nodes, const thinbench_graph_edge* edges, size_t edge_count,
                     const thinbench_pixel* pixels, size_t pixel_count,
                     const thinbench_spacing* spacing, thinbench_graph_paths** paths);
/* A cycle for each link that is not in the minimum spanning forest; the edges include the one from
 * the last node to the first. */
THINBENCH_API thinbench_status thinbench_cycles(uint32_t nodes, const thinbench_link* links,
                                                size_t link_count, thinbench_graph_paths** paths);
/* One path, or none where no path leads from one to the other. */
THINBENCH_API thinbench_status thinbench_shortest_path(uint32_t nodes, const thinbench_link* links,
                                                       size_t link_count, uint32_t from,
                                                       uint32_t to, thinbench_graph_paths** paths);
/* The component of every node, numbered from 0 by their first nodes. */
THINBENCH_API thinbench_status thinbench_components_of(uint32_t nodes, const thinbench_link* links,
                                                       size_t link_count, uint32_t* components);

/* The lists of paths, as those of regions. */
THINBENCH_API const thinbench_graph_path* thinbench_graph_paths_list(
    const thinbench_graph_paths* paths, size_t* count, size_t size);
THINBENCH_API const uint32_t* thinbench_graph_paths_nodes(const thinbench_graph_paths* paths,
                                                          size_t* count, size_t size);
THINBENCH_API const uint32_t* thinbench_graph_paths_edges(const thinbench_graph_paths* paths,
                                                          size_t* count, size_t size);
/* NULL is allowed. */
THINBENCH_API void thinbench_graph_paths_destroy(thinbench_graph_paths* paths);

typedef struct thinbench_path_request {
  size_t size; /* of this struct */
  thinbench_pixel start;
  thinbench_pixel goal;
  double width; /* of the robot, a disc, in pixels */
} thinbench_path_request;

#define THINBENCH_PATH_REQUEST_INIT \
  { sizeof(thinbench_path_request), {0, 0}, {0, 0}, 0 }

typedef struct thinbench_found_path {
  size_t size;      /* of this struct */
  size_t count;     /* of pixels; 0 if there is no path */
  double length;    /* steps along rows and columns count 1, diagonal ones the square root of 2 */
  double min_width; /* twice the smallest distance from steps to obstacles; infinite without one */
} thinbench_found_path;

#define THINBENCH_FOUND_PATH_INIT \
  { sizeof(thinbench_found_path), 0, 0, 0 }

/* The path of a robot from start to goal, in a map whose foreground is free, on the skeleton of the
 * free space: thinbench/path.hpp. Writes the first `capacity` of its found->count pixels, none
 * and `pixels` may be NULL if it is 0; no path has more than the map. A start or a goal that is
 * outside, on an obstacle or too near to one is an invalid argument. */
THINBENCH_API thinbench_status thinbench_find_path(const thinbench_image* free,
                                                   const thinbench_path_request* request,
                                                   const thinbench_execution* execution,
                                                   thinbench_pixel* pixels, size_t capacity,
                                                   thinbench_found_path* found);

#ifdef __cplusplus
}
#endif

#endif
