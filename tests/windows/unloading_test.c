/* Threads use the library and end before or after it is unloaded, which is loaded again and again.
 */
#include <stdio.h>
#include <windows.h>

enum { THREADS = 4, ROUNDS = 10 };

static int (*skeleton_pixels)(void);
static HANDLE used;  /* counts threads that have used the library */
static HANDLE ended; /* set when threads may end */

static DWORD WINAPI use_and_wait(void* count) {
  *(int*)count = skeleton_pixels();
  ReleaseSemaphore(used, 1, NULL);
  WaitForSingleObject(ended, INFINITE);
  return 0;
}

/* Returns 0 if every thread counted the same. */
static int run(int ends_first) {
  HANDLE threads[THREADS];
  int counts[THREADS];
  HMODULE user = LoadLibraryW(L"library_user.dll");
  if (user == NULL) return 1;
  skeleton_pixels = (int (*)(void))(void (*)(void))GetProcAddress(user, "skeleton_pixels");
  for (int i = 0; i < THREADS; ++i) {
    threads[i] = CreateThread(NULL, 0, use_and_wait, &counts[i], 0, NULL);
  }
  for (int i = 0; i < THREADS; ++i) WaitForSingleObject(used, INFINITE);
  if (!ends_first) FreeLibrary(user);
  SetEvent(ended);
  WaitForMultipleObjects(THREADS, threads, TRUE, INFINITE);
  if (ends_first) FreeLibrary(user);
  ResetEvent(ended);
  for (int i = 0; i < THREADS; ++i) {
    CloseHandle(threads[i]);
    if (counts[i] < 880 || counts[i] > 900) return 1;
  }
  return 0;
}

int main(void) {
  used = CreateSemaphoreW(NULL, 0, THREADS, NULL);
  ended = CreateEventW(NULL, TRUE, FALSE, NULL);
  for (int round = 0; round < ROUNDS; ++round) {
    if (run(round % 2) != 0) {
      printf("round %d: other results\n", round);
      return 1;
    }
  }
  return 0;
}
