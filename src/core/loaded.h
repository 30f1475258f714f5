/* core/loaded.h - functions of libraries that are loaded at run time, and their leaks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_LOADED_H
#define HAWSER_CORE_LOADED_H

#include <dlfcn.h>
#include <string.h>

/* Set the pointer of `size` bytes at `to` to the symbol `name`. 0: the library has none. */
static inline int hawser__loaded(void *to, size_t size, void *library, const char *name)
{
	void *at = dlsym(library, name);

	memcpy(to, &at, size); /* ISO C has no conversion of an object's pointer to a function's */
	return at != NULL;
}

/* Between these two, what is allocated is not for LeakSanitizer to report. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HAWSER_SEES_LEAKS
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define HAWSER_SEES_LEAKS
#endif
#ifdef HAWSER_SEES_LEAKS
#include <sanitizer/lsan_interface.h>
#define hawser__leaks_begin() __lsan_disable()
#define hawser__leaks_end() __lsan_enable()
#else
#define hawser__leaks_begin() ((void)0)
#define hawser__leaks_end() ((void)0)
#endif

#endif
