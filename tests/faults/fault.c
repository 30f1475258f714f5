/* tests/faults/fault.c - which of the seeded faults is active: HAWSER_FAULT has its number.
 *
 * seed.sh copies this file to src/core of the tree with faults. If HAWSER_FAULTS_REACHED names a
 * file, the number of each place is appended to it when the place is reached for the first time.
 * Neither stdio nor malloc: tests replace the allocator and fill disks. Two threads may both write
 * a number, which does no harm.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

enum { FAULTS = 1000, UNKNOWN = -1 };

int hawser__fault(int number);

static void note(int number)
{
	const char *path = getenv("HAWSER_FAULTS_REACHED");
	int error = errno;
	int file = path ? open(path, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666) : -1;
	const char line[] = {(char)('0' + number/100), (char)('0' + number/10%10),
		(char)('0' + number%10), '\n'};

	if (file >= 0) {
		if (write(file, line, sizeof line) != (ssize_t)sizeof line)
			abort();
		close(file);
	}
	errno = error;
}

int hawser__fault(int number)
{
	static char reached[FAULTS];
	static int active = UNKNOWN;

	if (!reached[number]) {
		const char *text = getenv("HAWSER_FAULT");

		reached[number] = 1;
		active = text ? atoi(text) : 0;
		note(number);
	}
	return active == number;
}
