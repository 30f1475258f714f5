/* core/bytes.h - a sequence of bytes that grows, and reading it again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_BYTES_H
#define HAWSER_CORE_BYTES_H

#include <stddef.h>

/* All zero: empty. Without memory it stays as it is and `short_of_memory` is set, after which nothing
 * is added, so that a writer asks once, at the end. */
struct hawser__bytes {
	unsigned char *at; /* [used] */
	size_t used, room;
	int short_of_memory;
};
/* Have room for `length` bytes in all. */
void hawser__bytes_reserve(struct hawser__bytes *bytes, size_t length);
void hawser__bytes_add(struct hawser__bytes *bytes, const void *from, size_t length);
void hawser__bytes_add_long(struct hawser__bytes *bytes, long number);
void hawser__bytes_add_double(struct hawser__bytes *bytes, double number);
/* The length, then the characters without '\0'; NULL as an empty text. */
void hawser__bytes_add_text(struct hawser__bytes *bytes, const char *text);
/* Nothing in it, with the same room: for the next message. */
void hawser__bytes_empty(struct hawser__bytes *bytes);
void hawser__bytes_clear(struct hawser__bytes *bytes);

/* What is left to be read. Beyond the end numbers are 0, and `bad` is set. */
struct hawser__extract {
	const unsigned char *at; /* [left] */
	size_t left;
	int bad;
};
void hawser__extract_read(void *to, struct hawser__extract *view, size_t length);
long hawser__extract_long(struct hawser__extract *view);
double hawser__extract_double(struct hawser__extract *view);
/* A text written by hawser__bytes_add_text into to [size], cut at its end. */
void hawser__extract_text(char *to, size_t size, struct hawser__extract *view);
/* A part that begins with its length, as hawser__bytes_add_text writes it. */
struct hawser__extract hawser__extract_part(struct hawser__extract *view);

#endif
