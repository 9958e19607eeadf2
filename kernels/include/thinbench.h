/* thinbench for C: thinning, edges, objects and holes of images.
 *
 * Functions return a status. After THINBENCH_INVALID_ARGUMENT nothing is written, and
 * thinbench_last_error() has one line that names the invalid value. Names ("guo_hall", "sobel",
 * "avx2") are those of the C++ interface and of the command-line program. No function throws, so
 * pthread_cancel inside a call ends the program. All functions are thread-safe for different
 * destinations and handles.
 *
 * thinbench_thinning, thinbench_execution, thinbench_rule_info, thinbench_binarisation and
 * thinbench_pruning begin with their size, so that later versions can add members at the end and
 * still serve programs compiled before; macros such as THINBENCH_THINNING_INIT set it. The other
 * structs never change. */
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

/* Frees the memory that the calling thread keeps for its next calls: at most 8 MiB in 32 blocks. A
 * thread that ends frees it, too; after fork(), the child goes on with that of the forking thread.
 */
THINBENCH_API void thinbench_release_memory(void);

/* The message of this thread's last failure, at most 1023 bytes of it; "" if there was none. Valid
 * until its next failure. */
THINBENCH_API const char* thinbench_last_error(void);

/* `count` images of height x width pixels, one byte each: pixel (x, y) of image i is
 * data[i * image_stride + y * stride + x]. Strides are in bytes; the image_stride of a single image
 * is not used. Binary images: 0 is background, anything else is foreground. An image is a stack of
 * one. */
typedef struct thinbench_stack {
  const uint8_t* data;
  ptrdiff_t count;
  ptrdiff_t height;
  ptrdiff_t width;
  ptrdiff_t stride;
  ptrdiff_t image_stride;
} thinbench_stack;

/* The same for results, of the source's size. */
typedef struct thinbench_output {
  uint8_t* data;
  ptrdiff_t stride;
  ptrdiff_t image_stride;
  uint8_t foreground; /* what is written instead of 255; 0 stands for 255 */
} thinbench_output;

/* What a call may change about a rule. */
typedef struct thinbench_thinning {
  size_t size;            /* of this struct */
  const char* border;     /* "background", "keep" or "foreground"; NULL: as the rule says */
  int32_t max_iterations; /* at least 1, INT32_MAX for no limit; 0: as the rule says */
  int32_t reserved;       /* must be 0 */
} thinbench_thinning;

#define THINBENCH_THINNING_INIT \
  { sizeof(thinbench_thinning), NULL, 0, 0 }

/* How a result is computed, which never changes a pixel. */
typedef struct thinbench_execution {
  size_t size;     /* of this struct */
  int32_t threads; /* 1 to 1024 */
  const char* isa; /* the highest to use; NULL: the highest that this machine has */
} thinbench_execution;

#define THINBENCH_EXECUTION_INIT \
  { sizeof(thinbench_execution), 1, NULL }

/* A rule, as in thinbench/rule.hpp: what thinning computes. All functions that take a rule take
 * every rule. Immutable: threads may use it at the same time. */
typedef struct thinbench_rule thinbench_rule;

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
  int32_t max_iterations; /* INT32_MAX: no limit */
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

/* Applies a rule to every image of a stack; destination may be the source. `thinning` and
 * `execution` may be NULL, and so may `iterations`, which gets the maximum over all images,
 * including the last iteration if it changed nothing. */
THINBENCH_API thinbench_status thinbench_thin(
    const thinbench_rule* rule, const thinbench_stack* source, const thinbench_output* destination,
    const thinbench_thinning* thinning, const thinbench_execution* execution, int32_t* iterations);

/* Thins `count` images of any sizes: image i is sources[i], a stack of one, and its skeleton goes
 * to destinations[i]. The same result as thinbench_thin for each, but faster for many small images.
 * A destination is its source or shares no byte with any image of the lists. The other
 * arguments as above. */
THINBENCH_API thinbench_status thinbench_thin_many(const thinbench_rule* rule,
                                                   const thinbench_stack* sources,
                                                   const thinbench_output* destinations,
                                                   size_t count, const thinbench_thinning* thinning,
                                                   const thinbench_execution* execution,
                                                   int32_t* iterations);

/* A binary image of 8 pixels per byte; every row starts with a new byte, and the stride is in
 * bytes. 1 is foreground. Unused bits of a row's last byte have no meaning. */
typedef struct thinbench_packed {
  const uint8_t* data;
  ptrdiff_t height;
  ptrdiff_t width;
  ptrdiff_t stride;
  int32_t lsb_first; /* nonzero: the first pixel is the lowest bit; 0: the highest, as in PBM */
} thinbench_packed;

/* The same as thinbench_thin for one packed image. The destination has the source's size and bit
 * order; its unused bits are set to 0. It is the source, with the same stride, or shares no byte
 * with it. */
THINBENCH_API thinbench_status thinbench_thin_packed(
    const thinbench_rule* rule, const thinbench_packed* source, uint8_t* destination,
    ptrdiff_t destination_stride, const thinbench_thinning* thinning,
    const thinbench_execution* execution, int32_t* iterations);

/* Thins every label of a height x width image of labels as if it were alone in the image: a pixel
 * keeps its label where the label's skeleton has it, else it becomes 0. 0 is background; negative
 * labels are rejected. Strides are in labels; destination may be the source. The other
 * arguments as above. */
THINBENCH_API thinbench_status thinbench_thin_labels(
    const thinbench_rule* rule, const int32_t* source, ptrdiff_t source_stride,
    int32_t* destination, ptrdiff_t destination_stride, ptrdiff_t height, ptrdiff_t width,
    const thinbench_thinning* thinning, const thinbench_execution* execution, int32_t* iterations);

/* A thinner for images of one size, with memory allocated once. One call at a time. */
typedef struct thinbench_thinner thinbench_thinner;

/* *thinner must be destroyed; NULL on failure. */
THINBENCH_API thinbench_status thinbench_thinner_create(const thinbench_rule* rule,
                                                        ptrdiff_t height, ptrdiff_t width,
                                                        const thinbench_thinning* thinning,
                                                        const thinbench_execution* execution,
                                                        thinbench_thinner** thinner);
/* Thins one image of this size. */
THINBENCH_API thinbench_status thinbench_thinner_run(thinbench_thinner* thinner,
                                                     const thinbench_stack* source,
                                                     const thinbench_output* destination,
                                                     int32_t* iterations);
/* NULL is allowed. */
THINBENCH_API void thinbench_thinner_destroy(thinbench_thinner* thinner);

/* What is foreground: thinbench/binarise.hpp. */
typedef struct thinbench_binarisation {
  size_t size;            /* of this struct */
  const char* foreground; /* "auto", "bright" or "dark"; NULL: "auto" */
  int32_t threshold;      /* 0 to 255; -1: by Otsu's method; -2: local */
  int32_t window;         /* of the local threshold: odd, 3 to 65535; 0: by the image's size */
  int32_t offset;         /* 0 to 255 */
  int32_t reserved;       /* must be 0 */
} thinbench_binarisation;

#define THINBENCH_BINARISATION_INIT \
  { sizeof(thinbench_binarisation), NULL, -1, 0, 10, 0 }

/* Writes 255 on the foreground of a grey image and 0 elsewhere; destination may be the source.
 * `request` may be NULL: the defaults. *foreground becomes "bright" or "dark" and *threshold the
 * level from which pixels are bright; each may be NULL. */
THINBENCH_API thinbench_status thinbench_binarise(const thinbench_stack* grey,
                                                  const thinbench_output* destination,
                                                  const thinbench_binarisation* request,
                                                  const char** foreground, int32_t* threshold);

/* A channel of one image of 3 or 4 bytes per pixel (red, green, blue, ignored): "grey", "red",
 * "green", "blue", "saturation", "value" or "auto". *chosen, which may be NULL, becomes its name.
 * `samples` is 3 or 4. Strides are in bytes; colours and levels must not overlap. */
THINBENCH_API thinbench_status thinbench_select_channel(const uint8_t* colours,
                                                        ptrdiff_t colours_stride, uint8_t* levels,
                                                        ptrdiff_t levels_stride, ptrdiff_t height,
                                                        ptrdiff_t width, int32_t samples,
                                                        const char* channel, const char** chosen);

/* The directions of the midpoint scan, to be combined by |. */
#define THINBENCH_ROWS 1          /* west to east */
#define THINBENCH_COLUMNS 2       /* north to south */
#define THINBENCH_DIAGONALS 4     /* north-west to south-east */
#define THINBENCH_ANTIDIAGONALS 8 /* north-east to south-west */
#define THINBENCH_ALL_DIRECTIONS 15

/* Marks the midpoint of every run of foreground pixels along each direction. The border is
 * "background" or "keep", NULL stands for the first. The destination may be the source. */
THINBENCH_API thinbench_status thinbench_midpoint_scan(const thinbench_stack* source,
                                                       const thinbench_output* destination,
                                                       int32_t directions, const char* border,
                                                       const thinbench_execution* execution);

/* Edges of grey images by "sobel", "prewitt", "roberts4", "roberts9", "mero_vassy" or
 * "mero_vassy_5x5"; thresholds from 0 to 255 (40 and 128 are usual). Source and destination must
 * not overlap. */
THINBENCH_API thinbench_status thinbench_edges(
    const char* edge_operator, const thinbench_stack* source, const thinbench_output* destination,
    int32_t gradient_threshold, int32_t brightness_threshold, const thinbench_execution* execution);

/* The square of the Euclidean distance from each pixel of one image to its nearest background
 * pixel, with `stride` numbers from row to row; INT32_MAX in an image without background. What is
 * outside the image does not count. Sides are at most 32767. Source and distances must not overlap.
 */
THINBENCH_API thinbench_status thinbench_squared_distances(const thinbench_stack* source,
                                                           int32_t* distances, ptrdiff_t stride,
                                                           const thinbench_execution* execution);

/* How far the centres of neighbouring rows and columns are apart, in any unit, from 1e-30 to
 * 1e30. NULL stands for 1, 1. */
typedef struct thinbench_spacing {
  double y;
  double x;
} thinbench_spacing;

/* The distances themselves, in the unit of the spacing; infinity in an image without background. */
THINBENCH_API thinbench_status thinbench_distances(const thinbench_stack* source, double* distances,
                                                   ptrdiff_t stride,
                                                   const thinbench_spacing* spacing,
                                                   const thinbench_execution* execution);

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
} thinbench_region;

/* Objects and holes, in raster order of their first pixels. */
typedef struct thinbench_regions thinbench_regions;

/* Of one image; *regions must be destroyed; NULL on failure. With `labels`, int32_t values with
 * `labels_stride` values from row to row, every pixel gets the number of its object from 1, or the
 * number of objects plus that of its hole, or 0. */
THINBENCH_API thinbench_status thinbench_find_regions(const thinbench_stack* source,
                                                      int32_t* labels, ptrdiff_t labels_stride,
                                                      const thinbench_execution* execution,
                                                      thinbench_regions** regions);
/* The labels of objects alone, which are 8- or 4-connected; *objects is their number. `order`:
 * "pixels" or NULL, as above, or "opencv", as OpenCV's connectedComponents numbers objects: those
 * that are 8-connected in raster order of their first blocks of 2 x 2 pixels. */
THINBENCH_API thinbench_status thinbench_label_image(const thinbench_stack* source, int32_t* labels,
                                                     ptrdiff_t labels_stride, int32_t connectivity,
                                                     const char* order,
                                                     const thinbench_execution* execution,
                                                     uint32_t* objects);
/* The same with the list of objects; there are no holes. */
THINBENCH_API thinbench_status thinbench_label_components(const thinbench_stack* source,
                                                          int32_t* labels, ptrdiff_t labels_stride,
                                                          int32_t connectivity, const char* order,
                                                          const thinbench_execution* execution,
                                                          thinbench_regions** regions);
/* The labels of components of equal values in a height x width image of any values: 4- or
 * 8-connected pixels with one value. Those with the value `background` get 0. Strides are in
 * values; the images share no byte. */
THINBENCH_API thinbench_status thinbench_label_values(const int32_t* values,
                                                      ptrdiff_t values_stride, int32_t* labels,
                                                      ptrdiff_t labels_stride, ptrdiff_t height,
                                                      ptrdiff_t width, int32_t connectivity,
                                                      int32_t background, uint32_t* components);
/* Sobel's edges of a grey image, filled, and the regions of the result. */
THINBENCH_API thinbench_status thinbench_localise(const thinbench_stack* grey,
                                                  int32_t gradient_threshold,
                                                  int32_t brightness_threshold,
                                                  const thinbench_execution* execution,
                                                  thinbench_regions** regions);
/* `size` is sizeof(thinbench_region): thinbench_regions_objects(r, &count, sizeof(...)). The array
 * lives as long as the handle. Returns NULL and sets *count to 0 if there are no regions, the
 * handle is NULL, or `size` differs from that of this library's struct. */
THINBENCH_API const thinbench_region* thinbench_regions_objects(const thinbench_regions* regions,
                                                                size_t* count, size_t size);
THINBENCH_API const thinbench_region* thinbench_regions_holes(const thinbench_regions* regions,
                                                              size_t* count, size_t size);
/* NULL is allowed. */
THINBENCH_API void thinbench_regions_destroy(thinbench_regions* regions);

/* The graph of a skeleton: nodes joined by lines. */
typedef struct thinbench_graph thinbench_graph;

typedef struct thinbench_pixel {
  int32_t x;
  int32_t y;
} thinbench_pixel;

typedef struct thinbench_graph_node {
  int32_t kind;         /* 0: isolated pixel, 1: end, 2: junction, 3: first pixel of a closed line,
                           4: given to thinbench_graph_split */
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

/* What each pixel of one image is (0: background, 1: isolated, 2: end, 3: line, 4: junction), and
 * to how many neighbours it is joined: thinbench/graph.hpp. Either may be NULL. Image, classes and
 * degrees must not overlap. */
THINBENCH_API thinbench_status thinbench_classify_pixels(const thinbench_stack* image,
                                                         uint8_t* classes, ptrdiff_t classes_stride,
                                                         uint8_t* degrees,
                                                         ptrdiff_t degrees_stride);

/* How many blocks of 2 x 2 foreground pixels one image has, by which it is not thin, and the upper
 * left pixel of the first. `first` may be NULL. */
THINBENCH_API thinbench_status thinbench_full_blocks(const thinbench_stack* image, int64_t* count,
                                                     thinbench_pixel* first);

/* What the parts are, and their order: thinbench/graph.hpp. *graph must be destroyed; NULL on
 * failure. */
THINBENCH_API thinbench_status thinbench_skeleton_graph(const thinbench_stack* skeleton,
                                                        const thinbench_execution* execution,
                                                        thinbench_graph** graph);

typedef struct thinbench_pruning {
  size_t size;             /* of this struct */
  double min_length;       /* removes end branches below it */
  double min_widths;       /* and those below so many times the object's width at their junction */
  const double* distances; /* of the image before it was thinned; NULL without min_widths */
  ptrdiff_t distances_stride;       /* in numbers */
  int32_t removes_components;       /* nonzero: also short lines and pixels on their own */
  const thinbench_spacing* spacing; /* that of the distances and of min_length */
} thinbench_pruning;

#define THINBENCH_PRUNING_INIT \
  { sizeof(thinbench_pruning), 0, 0, NULL, 0, 0, NULL }

/* Removes short branches of one skeleton, of equal ones the first, until none is left. Destination
 * may be the source. `graph` may be NULL; otherwise *graph is that of the result and must be
 * destroyed; NULL on failure. */
THINBENCH_API thinbench_status thinbench_prune(const thinbench_stack* skeleton,
                                               const thinbench_output* destination,
                                               const thinbench_pruning* pruning,
                                               const thinbench_execution* execution,
                                               thinbench_graph** graph);

/* Arrays that live as long as the handle; `size` is that of an element. Returns NULL and sets
 * *count to 0 if there are none, the handle is NULL, or `size` differs from this library's. */
THINBENCH_API const thinbench_graph_node* thinbench_graph_nodes(const thinbench_graph* graph,
                                                                size_t* count, size_t size);
THINBENCH_API const thinbench_graph_edge* thinbench_graph_edges(const thinbench_graph* graph,
                                                                size_t* count, size_t size);
THINBENCH_API const thinbench_pixel* thinbench_graph_node_pixels(const thinbench_graph* graph,
                                                                 size_t* count, size_t size);
THINBENCH_API const thinbench_pixel* thinbench_graph_edge_pixels(const thinbench_graph* graph,
                                                                 size_t* count, size_t size);
/* NULL is allowed. */
THINBENCH_API void thinbench_graph_destroy(thinbench_graph* graph);

/* Twice the distance to the background along an edge, both ends included; infinity without
 * background. */
typedef struct thinbench_edge_widths {
  double mean;
  double median;
  double min;
  double max;
} thinbench_edge_widths;

/* Those of every edge, in the order of the edges, for which `widths` has room. The distances are
 * those of the image before it was thinned, `stride` numbers from row to row. */
THINBENCH_API thinbench_status thinbench_graph_edge_widths(const thinbench_graph* graph,
                                                           const double* distances,
                                                           ptrdiff_t stride, ptrdiff_t height,
                                                           ptrdiff_t width,
                                                           thinbench_edge_widths* widths);

/* The graphs of all labels of a height x width image of labels, one after another, in the order of
 * the labels: thinbench/graph_labels.hpp. 0 is background; pixels with different labels are not
 * joined. `stride` is in labels. *graph must be destroyed; NULL on failure. */
THINBENCH_API thinbench_status thinbench_graph_of_labels(const int32_t* skeletons, ptrdiff_t stride,
                                                         ptrdiff_t height, ptrdiff_t width,
                                                         const thinbench_execution* execution,
                                                         thinbench_graph** graph);
/* The label of each node, as the other arrays; none for a graph that is not one of labels. */
THINBENCH_API const int32_t* thinbench_graph_node_labels(const thinbench_graph* graph,
                                                         size_t* count, size_t size);

/* The distance from each pixel of a label to the nearest pixel without this label; 0 on background.
 * Strides are in labels and in numbers. */
THINBENCH_API thinbench_status thinbench_label_distances(const int32_t* labels,
                                                         ptrdiff_t labels_stride, double* distances,
                                                         ptrdiff_t distances_stride,
                                                         ptrdiff_t height, ptrdiff_t width,
                                                         const thinbench_spacing* spacing,
                                                         const thinbench_execution* execution);

/* Prunes the skeleton of each label as if it were alone; pixels that are removed become 0. The
 * distances are thinbench_label_distances() of what was thinned. Destination may be the source.
 * `graph` as in thinbench_prune(), with labels. */
THINBENCH_API thinbench_status
thinbench_prune_labels(const int32_t* skeletons, ptrdiff_t skeletons_stride, int32_t* destination,
                       ptrdiff_t destination_stride, ptrdiff_t height, ptrdiff_t width,
                       const thinbench_pruning* pruning, const thinbench_execution* execution,
                       thinbench_graph** graph);

/* Graphs made from another one: thinbench/graph_parts.hpp. They know no labels, must be destroyed,
 * and are NULL on failure. */

/* Some edges, by their numbers, and their nodes. */
THINBENCH_API thinbench_status thinbench_graph_subgraph(const thinbench_graph* graph,
                                                        const uint32_t* edges, size_t count,
                                                        thinbench_graph** part);
/* With a node at each of these pixels of lines. */
THINBENCH_API thinbench_status thinbench_graph_split(const thinbench_graph* graph,
                                                     const thinbench_pixel* pixels, size_t count,
                                                     thinbench_graph** split);
/* Without the longest edge of each cycle of at most max_length. */
THINBENCH_API thinbench_status thinbench_graph_open_cycles(const thinbench_graph* graph,
                                                           double max_length,
                                                           const thinbench_spacing* spacing,
                                                           thinbench_graph** opened);

/* A pixel of an edge, and how far it is from where it was looked for. */
typedef struct thinbench_graph_place {
  uint32_t edge;
  thinbench_pixel pixel;
  double distance;
} thinbench_graph_place;

/* The pixel of an edge that is nearest to a point, the first with the least distance. */
THINBENCH_API thinbench_status thinbench_graph_nearest(const thinbench_graph* graph, double x,
                                                       double y, const thinbench_spacing* spacing,
                                                       thinbench_graph_place* place);

/* An edge as a row of the table that skan's summarize() makes. */
typedef struct thinbench_branch {
  uint32_t component; /* numbered from 0 by the first nodes */
  uint32_t from;
  uint32_t to;
  int32_t type; /* 0: between ends, 1: end and junction, 2: junctions, 3: a closed line */
  thinbench_pixel start;
  thinbench_pixel stop;
  double length;
  double chord;      /* the distance between start and stop */
  double tortuosity; /* length / chord; NaN where start and stop are one pixel */
} thinbench_branch;

/* That of every edge, in the order of the edges, for which `branches` has room. */
THINBENCH_API thinbench_status thinbench_graph_summary(const thinbench_graph* graph,
                                                       const thinbench_spacing* spacing,
                                                       thinbench_branch* branches);

/* An edge between nodes, by their numbers from 0. */
typedef struct thinbench_link {
  uint32_t from;
  uint32_t to;
  double length;
} thinbench_link;

/* Paths from node to node by links: thinbench/graph_paths.hpp. */
typedef struct thinbench_graph_paths thinbench_graph_paths;

typedef struct thinbench_graph_path {
  double length;
  size_t first_node; /* in the list of nodes */
  size_t node_count;
  size_t first_edge; /* in the list of edges: numbers of links */
  size_t edge_count;
} thinbench_graph_path;

/* The longest shortest path of every component. *paths must be destroyed; NULL on failure. */
THINBENCH_API thinbench_status thinbench_main_paths(uint32_t nodes, const thinbench_link* links,
                                                    size_t link_count,
                                                    thinbench_graph_paths** paths);
/* A cycle for each link that is not in the minimum spanning forest; the edges include the one from
 * the last node to the first. */
THINBENCH_API thinbench_status thinbench_cycles(uint32_t nodes, const thinbench_link* links,
                                                size_t link_count, thinbench_graph_paths** paths);
/* One path, or none where no path leads from one to the other. */
THINBENCH_API thinbench_status thinbench_shortest_path(uint32_t nodes, const thinbench_link* links,
                                                       size_t link_count, uint32_t from,
                                                       uint32_t to, thinbench_graph_paths** paths);
/* The component of every node, numbered from 0 by their first nodes. */
THINBENCH_API thinbench_status thinbench_components(uint32_t nodes, const thinbench_link* links,
                                                    size_t link_count, uint32_t* components);

/* Arrays as those of graphs. */
THINBENCH_API const thinbench_graph_path* thinbench_graph_paths_list(
    const thinbench_graph_paths* paths, size_t* count, size_t size);
THINBENCH_API const uint32_t* thinbench_graph_paths_nodes(const thinbench_graph_paths* paths,
                                                          size_t* count, size_t size);
THINBENCH_API const uint32_t* thinbench_graph_paths_edges(const thinbench_graph_paths* paths,
                                                          size_t* count, size_t size);
/* NULL is allowed. */
THINBENCH_API void thinbench_graph_paths_destroy(thinbench_graph_paths* paths);

/* Keeps the first point of a line, the last and some between them, chosen so that no point is
 * farther than `tolerance`, in the unit of the spacing, from the polyline. `kept` has room for
 * `count` points and may be `points`; *kept_count becomes their number. */
THINBENCH_API thinbench_status thinbench_polyline(const thinbench_pixel* points, size_t count,
                                                  double tolerance,
                                                  const thinbench_spacing* spacing,
                                                  thinbench_pixel* kept, size_t* kept_count);

/* The path of a robot from start to goal, in a map whose foreground is free, on the skeleton of the
 * free space: thinbench/path.hpp. `pixels` has room for as many pixels as the map; *count becomes
 * their number, 0 if there is no path. */
THINBENCH_API thinbench_status thinbench_find_path(const thinbench_stack* free,
                                                   thinbench_pixel start, thinbench_pixel goal,
                                                   double width,
                                                   const thinbench_execution* execution,
                                                   thinbench_pixel* pixels, size_t* count);

/* Sets objects and what they enclose to 255; destination may be the source. */
THINBENCH_API thinbench_status thinbench_fill_holes(const thinbench_stack* source,
                                                    const thinbench_output* destination,
                                                    const thinbench_execution* execution);

/* The same for objects of connectivity 8 or 4, and only for holes of at most `max_area` pixels,
 * without objects inside them, which stay as they are; INT64_MAX for all holes with all inside
 * them. */
THINBENCH_API thinbench_status thinbench_fill_small_holes(const thinbench_stack* source,
                                                          const thinbench_output* destination,
                                                          int32_t connectivity, int64_t max_area,
                                                          const thinbench_execution* execution);

/* Fills the holes of labels in a height x width image: background gets the label of the innermost
 * hole around it, as thinbench/regions.hpp says. The connectivity, 8 or 4, is that of labels; only
 * holes of at most `max_area` pixels. Strides are in labels; destination may be the source. */
THINBENCH_API thinbench_status thinbench_fill_label_holes(
    const int32_t* source, ptrdiff_t source_stride, int32_t* destination,
    ptrdiff_t destination_stride, ptrdiff_t height, ptrdiff_t width, int32_t connectivity,
    int64_t max_area, const thinbench_execution* execution);

/* Objects minus holes of one image; connectivity 8 or 4 is that of the objects. */
THINBENCH_API thinbench_status thinbench_euler_number(const thinbench_stack* source,
                                                      int32_t connectivity,
                                                      const thinbench_execution* execution,
                                                      int64_t* number);

/* Names, in the order of the catalogue; NULL past the end. Valid as long as the program. */
THINBENCH_API const char* thinbench_edge_operator_name(size_t index);
THINBENCH_API const char* thinbench_isa_name(size_t index);

/* Whether the processor has this ISA and THINBENCH_MAX_ISA allows it: 1, 0, or -1 for an unknown
 * name. */
THINBENCH_API int32_t thinbench_isa_available(const char* isa);

#ifdef __cplusplus
}
#endif

#endif
