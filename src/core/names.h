/* core/names.h - words of enumerations. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_NAMES_H
#define HAWSER_CORE_NAMES_H

/* Defines a function that returns the word of an enumerator of this type, of those from 0 on; "unknown"
 * of others. */
#define HAWSER__NAMES(function, type, ...) \
	const char *function(type value) \
	{ \
		static const char *const word[] = {__VA_ARGS__}; \
	\
		return (unsigned)value < sizeof word/sizeof *word ? word[value] : "unknown"; \
	}

#endif
