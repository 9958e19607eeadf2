/* The version for the preprocessor, and what the shared library exports: nothing else is. */
#ifndef THINBENCH_EXPORT_H
#define THINBENCH_EXPORT_H

#define THINBENCH_VERSION_MAJOR 1
#define THINBENCH_VERSION_MINOR 0
#define THINBENCH_VERSION_PATCH 0

#ifndef _WIN32
#define THINBENCH_API __attribute__((visibility("default")))
#elif defined(THINBENCH_EXPORTS) /* while the library is compiled */
#define THINBENCH_API __declspec(dllexport)
#else
#define THINBENCH_API
#endif

#endif
