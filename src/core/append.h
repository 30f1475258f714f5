/* core/append.h - texts that are put together from parts. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_APPEND_H
#define HAWSER_CORE_APPEND_H

#include <stddef.h>

#include <hawser/status.h>

/* Add to text [size]: `between`, where something stands there already, and what the format writes. What
 * has no room is left out. */
void hawser__append(char *text, size_t size, const char *between, const char *format, ...)
	HAWSER_PRINTF(4, 5);

#endif
