/* checks/cover.c - what a program of the sanitizers' tree reaches, for make check-cover.
 *
 * Linked into a program, it adds at the end of each process to the files PROGRAM and PROGRAM.pcs in
 * the folder $GCOV_PREFIX (tests/run -g): a byte a block of code, not 0 where it was reached; and
 * twice the place of each block in the program, plus 1 where a function begins.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST = 1 << 20 };

struct block {
	uintptr_t at, entry;
};

void __sanitizer_cov_8bit_counters_init(uint8_t *begin, uint8_t *end);
void __sanitizer_cov_pcs_init(const uintptr_t *begin, const uintptr_t *end);
extern const char __executable_start;

static const uint8_t *counter, *counter_end;
static const struct block *block;
static uint8_t before[MOST];
static uint32_t place[MOST];

/* clang's names, called before main */
void __sanitizer_cov_8bit_counters_init(uint8_t *begin, uint8_t *end)
{
	counter = begin;
	counter_end = end;
}

void __sanitizer_cov_pcs_init(const uintptr_t *begin, const uintptr_t *end)
{
	(void)end;
	block = (const struct block *)begin;
}

static void make_folders(char *path)
{
	for (char *slash = path + 1; (slash = strchr(slash, '/')); slash++) {
		*slash = '\0';
		mkdir(path, 0777);
		*slash = '/';
	}
}

static void write_places(const char *path, size_t count)
{
	char name[PATH_MAX + 8];
	FILE *file;

	snprintf(name, sizeof name, "%s.pcs", path);
	file = fopen(name, "w");
	for (size_t i = 0; i < count; i++)
		place[i] = (uint32_t)(2*(block[i].at - (uintptr_t)&__executable_start) +
		                      (block[i].entry & 1));
	if (file) {
		fwrite(place, sizeof *place, count, file);
		fclose(file);
	}
}

__attribute__((destructor)) static void leave(void)
{
	size_t count = (size_t)(counter_end - counter);
	const char *folder = getenv("GCOV_PREFIX");
	char path[PATH_MAX];
	int file;

	if (!folder || !block || count > MOST)
		return;
	snprintf(path, sizeof path, "%s/%s", folder, program_invocation_short_name);
	make_folders(path);
	file = open(path, O_RDWR | O_CREAT, 0666);
	if (file < 0 || flock(file, LOCK_EX))
		return;
	if (read(file, before, count) <= 0)
		write_places(path, count);
	for (size_t i = 0; i < count; i++)
		before[i] |= counter[i] != 0;
	if (pwrite(file, before, count, 0) < 0)
		perror(path);
	close(file);
}
