/* rom/kernel.h - the compiled form of a model.
 *
 * With symmetric splitting of every monomial over its indices, the restoring force is G(u) u, where
 *
 *     G_jk(u) = K_jk + sum_l A_jkl u_l + sum_{l<=m} B_jk,lm u_l u_m
 *
 * and its Jacobian is K + 2 A(u) + 3 B(u): force and tangent come out of the same two sparse
 * matrix-vector products, whose columns are u and the products u_l u_m. When the tensors come from
 * a potential, G is symmetric and only its lower half is stored.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_KERNEL_H
#define HAWSER_ROM_KERNEL_H

#include <hawser/rom.h>

/* Bound on the coordinates of a model: the hot loops keep u_l u_m on the stack. */
#define HAWSER_ROM_MAX 100
#define HAWSER_ROM_MAX_PAIRS (HAWSER_ROM_MAX*(HAWSER_ROM_MAX + 1)/2)

/* Row r of G: the entry (j, k), its constant part, and its columns in A and in B. */
struct hawser__row {
	int j, k;
	int a, a_end, b, b_end; /* ranges in col/val */
	double constant;        /* K_jk */
};

struct hawser_rom_kernel {
	int symmetric;        /* rows have k <= j and stand for (k, j) too */
	int rows;
	struct hawser__row *row;
	int *col;             /* column of A: l; column of B: index of the pair (l, m) */
	double *val;
	int d_entries;        /* nonzeros of D */
	int *d_j, *d_k;
	double *d_val;
	double asymmetry;     /* largest |T - transposed T| over largest |T|, of K, Q and C */
};

void hawser__kernel_free(struct hawser_rom_kernel *kernel);

#endif
