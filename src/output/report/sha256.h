/* output/report/sha256.h - the SHA-256 digest of a text, by which a report names the scene it
 * was made from (FIPS 180-4). SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_SHA256_H
#define HAWSER_OUTPUT_SHA256_H

#include <stddef.h>

enum { HAWSER__SHA256_SIZE = 65 }; /* 64 hexadecimal digits and the end */
void hawser__sha256(char digest[HAWSER__SHA256_SIZE], const void *text, size_t size);

#endif
