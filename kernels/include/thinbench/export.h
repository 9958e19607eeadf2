/* Marks what the shared library exports; everything else is hidden. */
#ifndef THINBENCH_EXPORT_H
#define THINBENCH_EXPORT_H

#define THINBENCH_API __attribute__((visibility("default")))

#endif
