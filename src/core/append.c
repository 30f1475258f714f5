/* core/append.c - texts that are put together from parts. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/append.h"

void hawser__append(char *text, size_t size, const char *between, const char *format, ...)
{
	size_t used = strlen(text);
	va_list args;

	if (used)
		snprintf(text + used, size - used, "%s", between);
	used += strlen(text + used);
	va_start(args, format);
	vsnprintf(text + used, size - used, format, args);
	va_end(args);
}
