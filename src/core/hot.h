/* core/hot.h - marks the innermost loops.
 *
 * A function marked HAWSER_HOT is compiled twice, for the baseline processor and for one with
 * 256-bit vectors; the loader selects one of them. A distribution's package is therefore as fast as
 * a build for the machine. Arithmetic in these functions uses hawser__vec, since compilers do not
 * vectorise short loops at -O2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_HOT_H
#define HAWSER_CORE_HOT_H

#define HAWSER_BLOCK 4 /* doubles of an AVX register */

/* Next multiple of HAWSER_BLOCK. */
#define HAWSER_PADDED(n) (((n) + HAWSER_BLOCK - 1)/HAWSER_BLOCK*HAWSER_BLOCK)

/* Four doubles as one value (GCC and clang), without alignment, which may alias arrays of
 * double. */
typedef double hawser__vec __attribute__((vector_size(32), aligned(8), may_alias));

/* Not with sanitizers, which run before the loader selects, and not with clang 14, which has no
 * such attribute. */
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
	!defined(__SANITIZE_ADDRESS__)
#define HAWSER_HOT __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define HAWSER_HOT
#endif

/* Before a loop whose bound is constant after inlining: unrolled, its vectors stay in registers. */
#if defined(__GNUC__) && !defined(__clang__)
#define HAWSER_UNROLL _Pragma("GCC unroll 16")
#else
#define HAWSER_UNROLL
#endif

/* A part of a hot function, inlined so that it is compiled for each processor too. clang's warning
 * about passing vectors as arguments does not apply to inlined functions. */
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpsabi"
#endif
#if defined(__GNUC__)
#define HAWSER_PART static inline __attribute__((always_inline))
#else
#define HAWSER_PART static inline
#endif

#endif
