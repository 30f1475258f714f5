/* core/bytes.c - a sequence of bytes that grows, and reading it again.
 *
 * Numbers are stored as they are in memory: the processes of one computation run on machines of one
 * kind (src/core/ranks.c checks that).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/bytes.h"

void hawser__bytes_reserve(struct hawser__bytes *bytes, size_t length)
{
	unsigned char *larger = length > bytes->room ? realloc(bytes->at, 2*length) : bytes->at;

	if (length > bytes->room && !larger) {
		bytes->short_of_memory = 1;
		return;
	}
	bytes->at = larger;
	bytes->room = length > bytes->room ? 2*length : bytes->room;
}

void hawser__bytes_add(struct hawser__bytes *bytes, const void *from, size_t length)
{
	hawser__bytes_reserve(bytes, bytes->used + length);
	if (bytes->short_of_memory || length == 0)
		return; /* nothing behind a gap: a reader would take it for what is missing */
	memcpy(bytes->at + bytes->used, from, length);
	bytes->used += length;
}

void hawser__bytes_add_long(struct hawser__bytes *bytes, long number)
{
	hawser__bytes_add(bytes, &number, sizeof number);
}

void hawser__bytes_add_double(struct hawser__bytes *bytes, double number)
{
	hawser__bytes_add(bytes, &number, sizeof number);
}

void hawser__bytes_add_text(struct hawser__bytes *bytes, const char *text)
{
	size_t length = text ? strlen(text) : 0;

	hawser__bytes_add_long(bytes, (long)length);
	hawser__bytes_add(bytes, text, length);
}

void hawser__bytes_empty(struct hawser__bytes *bytes)
{
	bytes->used = 0;
	bytes->short_of_memory = 0;
}

void hawser__bytes_clear(struct hawser__bytes *bytes)
{
	free(bytes->at);
	*bytes = (struct hawser__bytes){.at = NULL};
}

/* The next `length` bytes, or NULL. */
static const void *next(struct hawser__extract *view, size_t length)
{
	const unsigned char *at = view->at;

	if (view->bad || length > view->left) {
		view->bad = 1;
		return NULL;
	}
	view->at += length;
	view->left -= length;
	return at;
}

void hawser__extract_read(void *to, struct hawser__extract *view, size_t length)
{
	const void *from = next(view, length);

	if (from && length > 0)
		memcpy(to, from, length);
	else
		memset(to, 0, length);
}

long hawser__extract_long(struct hawser__extract *view)
{
	long number;

	hawser__extract_read(&number, view, sizeof number);
	return number;
}

double hawser__extract_double(struct hawser__extract *view)
{
	double number;

	hawser__extract_read(&number, view, sizeof number);
	return number;
}

struct hawser__extract hawser__extract_part(struct hawser__extract *view)
{
	long length = hawser__extract_long(view);
	const void *at = next(view, length >= 0 ? (size_t)length : view->left + 1);

	return (struct hawser__extract){at, at ? (size_t)length : 0, view->bad};
}

void hawser__extract_text(char *to, size_t size, struct hawser__extract *view)
{
	struct hawser__extract part = hawser__extract_part(view);
	size_t length = part.left < size - 1 ? part.left : size - 1;

	if (length > 0)
		memcpy(to, part.at, length);
	to[length] = '\0';
}
