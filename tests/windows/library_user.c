/* A DLL that uses the library: one call loads or unloads both. */
#include <windows.h>

#include "thinbench.h"

/* Frees what threads keep when they end, as late as a program can. */
BOOL WINAPI DllMain(HINSTANCE self, DWORD reason, LPVOID reserved) {
  (void)self;
  (void)reserved;
  if (reason == DLL_THREAD_DETACH || reason == DLL_PROCESS_DETACH) thinbench_release_memory();
  return TRUE;
}

enum { WIDTH = 1100, HEIGHT = 1000 };

/* The number of pixels of a bar's skeleton, which three threads compute; -1 after an error. */
__declspec(dllexport) int skeleton_pixels(void) {
  thinbench_image image = THINBENCH_IMAGE_INIT;
  thinbench_execution execution = THINBENCH_EXECUTION_INIT;
  thinbench_rule* rule = NULL;
  int count = 0;
  image.data = HeapAlloc(GetProcessHeap(), HEAP_ZERO_MEMORY, WIDTH * HEIGHT);
  if (image.data == NULL) return -1;
  image.width = image.stride = WIDTH;
  image.height = HEIGHT;
  for (int y = 100; y < 110; ++y) {
    for (int x = 100; x < 1000; ++x) image.data[y * WIDTH + x] = 255;
  }
  execution.threads = 3;
  if (thinbench_rule_named("guo_hall", &rule) != THINBENCH_OK ||
      thinbench_thin(rule, &image, &image, NULL, &execution, NULL) != THINBENCH_OK) {
    count = -1;
  }
  thinbench_rule_destroy(rule);
  for (int i = 0; count >= 0 && i < WIDTH * HEIGHT; ++i) count += image.data[i] != 0;
  HeapFree(GetProcessHeap(), 0, image.data);
  return count;
}
