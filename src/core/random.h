/* core/random.h - random numbers that are the same on every machine.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_RANDOM_H
#define HAWSER_CORE_RANDOM_H

#include <stdint.h>

/* The next number, uniform in 0..1 (splitmix64: any state is a good beginning). */
static inline double hawser__random(uint64_t *state)
{
	uint64_t z = *state += 0x9e3779b97f4a7c15u;

	z = (z ^ z >> 30)*0xbf58476d1ce4e5b9u;
	z = (z ^ z >> 27)*0x94d049bb133111ebu;
	return (double)((z ^ z >> 31) >> 11)/9007199254740992.0;
}

#endif
