/* tests/fuzz/alloc.c - makes a chosen allocation of a program fail; for LD_PRELOAD.
 *
 * HAWSER_ALLOC_FAIL=N: of all calls of malloc, calloc, realloc, aligned_alloc and posix_memalign
 * after main begins, from any library, the N-th one fails. HAWSER_ALLOC_LIST=FILE: no call fails;
 * when the program ends, FILE gets the number of calls, then the number of the first call from each
 * place, ascending. A place is given by the addresses of the callers; a line that is reached by
 * another path is another place. The addresses differ between runs, the list does not.
 *
 * Calls from OpenBLAS's kernels for small matrix products are counted, but are not listed and do
 * not fail, because these kernels use the result of malloc without a check. OpenBLAS 0.3.21,
 * kernels SkylakeX and Cooperlake, where the malloc in frame 0 failed:
 *
 *   SIGSEGV at vmovupd %ymm5,(%r8,%rcx,8), the first store to the buffer
 *   #0 dgemm_small_kernel_b0_nn_SKYLAKEX () from libopenblas.so.0
 *   #1 cblas_dgemm () from libopenblas.so.0
 *   #2 hawser__compliance_solve (...)        (or any other caller of cblas_dgemm)
 *
 * Compiled separately and without sanitizers. Under gcc's AddressSanitizer, whose malloc is called
 * by this one, ASAN_OPTIONS must have verify_asan_link_order=0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH = 24, PLACES = 1 << 16 };

static void *(*real_malloc)(size_t);
static void *(*real_calloc)(size_t, size_t);
static void *(*real_realloc)(void *, size_t);
static void *(*real_aligned)(size_t, size_t);
static void (*real_free)(void *);
static int (*real_posix)(void **, size_t, size_t);
static int (*real_main)(int, char **, char **);

static atomic_long calls;
static long chosen;
static int running;
static __thread int busy; /* nonzero within this library's own calls, which are not counted */
static atomic_flag remembering = ATOMIC_FLAG_INIT;
static uint64_t place[PLACES];
static long first[PLACES];

/* dlsym allocates a little before it returns the address of calloc. */
static char early[1 << 16];
static size_t early_used;

static void *from_early(size_t size)
{
	void *at = early + early_used;

	early_used += (size + 15) & ~(size_t)15;
	if (early_used > sizeof early)
		abort();
	return at;
}

static int is_early(const void *at)
{
	return (const char *)at >= early && (const char *)at < early + sizeof early;
}

static void find(void)
{
	busy = 1;
	*(void **)&real_free = dlsym(RTLD_NEXT, "free");
	*(void **)&real_calloc = dlsym(RTLD_NEXT, "calloc");
	*(void **)&real_malloc = dlsym(RTLD_NEXT, "malloc");
	*(void **)&real_realloc = dlsym(RTLD_NEXT, "realloc");
	*(void **)&real_aligned = dlsym(RTLD_NEXT, "aligned_alloc");
	*(void **)&real_posix = dlsym(RTLD_NEXT, "posix_memalign");
	busy = 0;
}

static void remember(long call)
{
	void *at[DEPTH];
	int depth;
	uint64_t hash = UINT64_C(14695981039346656037);
	size_t slot;

	busy = 1;
	depth = backtrace(at, DEPTH);
	busy = 0;
	for (int i = 0; i < depth; i++)
		hash = (hash ^ (uintptr_t)at[i])*UINT64_C(1099511628211);
	hash |= 1;
	while (atomic_flag_test_and_set(&remembering))
		;
	for (slot = hash % PLACES; place[slot] && place[slot] != hash; slot = (slot + 1) % PLACES)
		;
	if (!place[slot]) {
		place[slot] = hash;
		first[slot] = call;
	}
	atomic_flag_clear(&remembering);
}

/* 1 if the caller is one of OpenBLAS's kernels for small products, such as
 * dgemm_small_kernel_nn_SKYLAKEX. */
static int by_small_kernel(const void *caller)
{
	Dl_info info;

	return dladdr(caller, &info) && info.dli_sname && strstr(info.dli_sname, "gemm_small_kernel");
}

/* 1 if this call must fail. */
static int refuse(const void *caller)
{
	long call;

	if (!real_malloc && !busy)
		find();
	if (!running || busy)
		return 0;
	call = atomic_fetch_add(&calls, 1) + 1;
	if (chosen < 0 && !by_small_kernel(caller))
		remember(call);
	if (call != chosen || by_small_kernel(caller))
		return 0;
	errno = ENOMEM;
	return 1;
}

void *malloc(size_t size)
{
	if (refuse(__builtin_return_address(0)))
		return NULL;
	return real_malloc ? real_malloc(size) : from_early(size);
}

void *calloc(size_t count, size_t size)
{
	if (refuse(__builtin_return_address(0)))
		return NULL;
	return real_calloc ? real_calloc(count, size) : from_early(count*size);
}

void *realloc(void *old, size_t size)
{
	void *copy;

	if (refuse(__builtin_return_address(0)))
		return NULL;
	if (real_realloc && !is_early(old))
		return real_realloc(old, size);
	copy = real_malloc ? real_malloc(size) : from_early(size);
	if (old && copy)
		memcpy(copy, old, size);
	return copy;
}

void *aligned_alloc(size_t alignment, size_t size)
{
	return refuse(__builtin_return_address(0)) ? NULL : real_aligned(alignment, size);
}

int posix_memalign(void **at, size_t alignment, size_t size)
{
	return refuse(__builtin_return_address(0)) ? ENOMEM : real_posix(at, alignment, size);
}

void free(void *at)
{
	if (!at || is_early(at))
		return;
	if (!real_free && !busy)
		find();
	if (real_free) /* dlsym itself frees memory: until real_free is known, nothing is released */
		real_free(at);
}

static int ascending(const void *left, const void *right)
{
	long a = *(const long *)left, b = *(const long *)right;

	return (a > b) - (a < b);
}

static void list(void)
{
	const char *path = getenv("HAWSER_ALLOC_LIST");
	FILE *stream;

	running = 0;
	stream = path ? fopen(path, "w") : NULL;
	if (!stream)
		return;
	fprintf(stream, "%ld\n", atomic_load(&calls));
	qsort(first, PLACES, sizeof *first, ascending);
	for (size_t i = 0; i < PLACES; i++)
		if (first[i]) /* calls are counted from 1; 0 is an empty slot */
			fprintf(stream, "%ld\n", first[i]);
	fclose(stream);
}

static int counted_main(int argc, char **argv, char **environment)
{
	const char *fail = getenv("HAWSER_ALLOC_FAIL");
	void *at[DEPTH];

	chosen = fail ? atol(fail) : 0;
	if (getenv("HAWSER_ALLOC_LIST")) {
		chosen = -1;
		(void)backtrace(at, DEPTH); /* the first call loads a library */
		atexit(list);
	}
	running = 1;
	return real_main(argc, argv, environment);
}

/* The start-up of the loader and of the libraries is not counted: counting begins at main. */
int __libc_start_main(int (*main)(int, char **, char **), int argc, char **argv,
                      void (*init)(void), void (*fini)(void), void (*rtld_fini)(void), void *end)
{
	int (*start)(int (*)(int, char **, char **), int, char **, void (*)(void), void (*)(void),
	             void (*)(void), void *);

	*(void **)&start = dlsym(RTLD_NEXT, "__libc_start_main");
	real_main = main;
	return start(counted_main, argc, argv, init, fini, rtld_fini, end);
}
