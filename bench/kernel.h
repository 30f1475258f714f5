/* bench/kernel.h - the part of bench/kernel that is about models of cables.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BENCH_KERNEL_H
#define HAWSER_BENCH_KERNEL_H

/* Verify, then time, forces from tensors and from functions; returns 0 where they disagree. */
int bench_cables(void);

#endif
