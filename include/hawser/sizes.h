/* hawser/sizes.h - sizes of the public structures in the library that runs, for bindings.
 *
 * A program that is compiled with these headers needs none of this. A binding of another language
 * allocates hawser_sizeof(name) bytes, all zero, for a result or for options, passes the address, and
 * releases what the structure points to by the function named _clear. A structure may be moved by
 * copying its bytes, but for struct hawser_accuracy, whose choice points to its modes. A binding that
 * reads members by their offsets compares hawser_sizeof(name) with the size that it knows: if they
 * differ, the library is of another version.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SIZES_H
#define HAWSER_SIZES_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes of a public structure, by its name without "struct": "hawser_frf"; 0 if there is none of that
 * name. */
size_t hawser_sizeof(const char *name);

#ifdef __cplusplus
}
#endif
#endif
