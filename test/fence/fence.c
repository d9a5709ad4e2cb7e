/* A malloc() that ends each large block at a wall, for a program that runs with this in LD_PRELOAD.
 *
 * A store up to 128 KB beyond the end of such a block is a segmentation fault, there and then, whoever made it:
 * library code that was compiled without a sanitizer too. So is any use of a block after free(). A block
 * smaller than LARGE comes from glibc as ever.
 */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { PAGE = 4096, LARGE = 2048, WALL = 1 << 17, ALIGNMENT = 16 };
#define ROOM ((size_t)1 << 40) /* of addresses, not of memory; none is used twice */

extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* block, size_t size);
extern void __libc_free(void* block);

static uint8_t* room;
static size_t taken;

__attribute__((constructor)) static void take_room(void) {
  room = mmap(NULL, ROOM, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) _exit(99);
}

static bool is_fenced(const void* block) {
  return room != NULL && (const uint8_t*)block >= room && (const uint8_t*)block < room + ROOM;
}

static size_t whole_pages(size_t size) { return (size + PAGE - 1) / PAGE * PAGE; }

/* A page with the size, the block's own pages, the wall. The block ends where the wall begins. */
static void* fenced(size_t size) {
  size = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
  const size_t pages = PAGE + whole_pages(size);
  uint8_t* slot = room + __atomic_fetch_add(&taken, pages + WALL, __ATOMIC_RELAXED);
  if (slot + pages + WALL > room + ROOM || mprotect(slot, pages, PROT_READ | PROT_WRITE) != 0) _exit(98);
  memcpy(slot, &size, sizeof size);
  return slot + pages - size;
}

static uint8_t* slot_of(const void* block) {
  const uintptr_t page = (uintptr_t)block / PAGE * PAGE;
  return (uint8_t*)(page - PAGE);
}

static size_t size_of(const void* block) {
  size_t size;
  memcpy(&size, slot_of(block), sizeof size);
  return size;
}

void* malloc(size_t size) { return size >= LARGE && room != NULL ? fenced(size) : __libc_malloc(size); }

void* calloc(size_t count, size_t size) {
  size_t all;
  if (__builtin_mul_overflow(count, size, &all)) return NULL;
  return all >= LARGE && room != NULL ? fenced(all) : __libc_calloc(count, size); /* new pages are zero */
}

void free(void* block) {
  if (!is_fenced(block)) {
    __libc_free(block);
    return;
  }
  const size_t pages = PAGE + whole_pages(size_of(block));
  madvise(slot_of(block), pages, MADV_DONTNEED);
  mprotect(slot_of(block), pages, PROT_NONE);
}

void* realloc(void* block, size_t size) {
  if (block == NULL) return malloc(size);
  if (!is_fenced(block)) {
    void* grown = __libc_realloc(block, size);
    if (grown == NULL || size < LARGE || room == NULL) return grown;
    void* moved = fenced(size);
    memcpy(moved, grown, size);
    __libc_free(grown);
    return moved;
  }
  void* moved = malloc(size);
  if (moved == NULL) return NULL;
  const size_t old = size_of(block);
  memcpy(moved, block, old < size ? old : size);
  free(block);
  return moved;
}
