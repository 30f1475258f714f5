/* net/motion/motion-klu.c - unsymmetric sparse matrices over the unknowns of a mesh, by SuiteSparse
 * KLU.
 *
 * The pattern is analysed once and pivots are chosen once; later matrices are factored with the same
 * pivots, and with new ones where that fails.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <suitesparse/klu.h>

#include "core/columns.h"
#include "core/hold.h"
#include "core/report.h"
#include "net/motion/motion.h"

enum { ENTRIES = 36, DIRECTIONS = 6 };

struct hawser__klu {
	klu_common common;
	klu_symbolic *symbolic;
	klu_numeric *numeric;
	int unknowns, nodes, elements;
	int *p, *i;            /* [unknowns + 1], [entries] columns */
	double *x;             /* [entries] values */
	int (*at)[ENTRIES];    /* [elements] place of row r, column c of the block, in r*6 + c; -1: held */
	int (*diagonal)[3];    /* [nodes] -1: held */
	const int (*unknown)[3]; /* [nodes] of the mesh */
	double *right;         /* [unknowns] */
	klu_numeric *factors;  /* of complex matrices */
	double *z;             /* [2 entries] their values; NULL: there was none yet */
	struct hawser__hold hold;
};

void hawser__klu_clear(struct hawser__klu *klu)
{
	if (!klu)
		return;
	klu_free_numeric(&klu->numeric, &klu->common);
	klu_z_free_numeric(&klu->factors, &klu->common);
	free(klu->z);
	klu_free_symbolic(&klu->symbolic, &klu->common);
	hawser__hold_clear(&klu->hold);
	free(klu);
}

double hawser__klu_bytes(const struct hawser__klu *klu)
{
	/* an index and a value for each entry; KLU's estimate of the factors is one of a symmetric
	 * pattern */
	double factors = klu->symbolic
		? fmax(klu->symbolic->lnz, 0.0) + fmax(klu->symbolic->unz, 0.0) : 0.0;

	return 12.0*(factors + klu->p[klu->unknowns]) + (double)klu->elements*sizeof *klu->at;
}

void hawser__klu_forget(struct hawser__klu *klu)
{
	klu_free_numeric(&klu->numeric, &klu->common);
}

static int find(const struct hawser__klu *klu, int row, int column)
{
	return hawser__columns_find(klu->p, klu->i, row, column);
}

/* Entries (column, row) of all elements and of the diagonal. */
static size_t list_entries(int (*list)[2], const struct hawser__mesh *mesh)
{
	size_t count = 0;

	for (int j = 0; j < mesh->unknowns; j++, count++)
		list[count][0] = list[count][1] = j;
	for (int e = 0; e < mesh->elements; e++) {
		int u[DIRECTIONS];

		hawser__mesh_unknowns(u, mesh, e);
		for (int k = 0; k < ENTRIES; k++)
			if (u[k/6] >= 0 && u[k%6] >= 0) {
				list[count][1] = u[k/6];
				list[count++][0] = u[k%6];
			}
	}
	return count;
}

static void locate(struct hawser__klu *klu, const struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			klu->diagonal[i][k] = mesh->unknown[i][k] < 0 ? -1
				: find(klu, mesh->unknown[i][k], mesh->unknown[i][k]);
	for (int e = 0; e < mesh->elements; e++) {
		int u[DIRECTIONS];

		hawser__mesh_unknowns(u, mesh, e);
		for (int k = 0; k < ENTRIES; k++)
			klu->at[e][k] = u[k/6] < 0 || u[k%6] < 0 ? -1 : find(klu, u[k/6], u[k%6]);
	}
}

static enum hawser_status failed(const struct hawser__klu *klu, struct hawser_report *report)
{
	if (klu->common.status == KLU_OUT_OF_MEMORY || klu->common.status == KLU_TOO_LARGE)
		return hawser__no_memory(report, "net");
	return hawser__fail(report, HAWSER_ERR_PROGRAM, "net", "KLU failed with status %d",
	                    klu->common.status);
}

static enum hawser_status pattern(struct hawser__klu *klu, const struct hawser__mesh *mesh,
                                  struct hawser_report *report)
{
	size_t most = (size_t)mesh->unknowns + ENTRIES*(size_t)mesh->elements + 1;
	int (*list)[2] = malloc(most*sizeof *list);
	int short_of_memory;

	klu->p = hawser__hold(&klu->hold, (size_t)mesh->unknowns + 1, sizeof *klu->p);
	klu->i = hawser__hold(&klu->hold, most, sizeof *klu->i);
	klu->x = hawser__hold(&klu->hold, most, sizeof *klu->x);
	klu->at = hawser__hold(&klu->hold, (size_t)mesh->elements + 1, sizeof *klu->at);
	klu->diagonal = hawser__hold(&klu->hold, (size_t)mesh->nodes + 1, sizeof *klu->diagonal);
	klu->right = hawser__hold(&klu->hold, (size_t)mesh->unknowns + 1, sizeof *klu->right);
	short_of_memory = !list || klu->hold.short_of_memory ||
	                  hawser__columns(klu->p, klu->i, list, list_entries(list, mesh), mesh->unknowns);
	free(list);
	if (short_of_memory)
		return hawser__no_memory(report, "net");
	locate(klu, mesh);
	if (!klu->unknowns) /* all nodes are held, as of a body on hinges */
		return HAWSER_OK;
	klu->symbolic = klu_analyze(klu->unknowns, klu->p, klu->i, &klu->common);
	return klu->symbolic ? HAWSER_OK : failed(klu, report);
}

enum hawser_status hawser__klu_open(struct hawser__klu **made, const struct hawser__mesh *mesh,
                                    struct hawser_report *report)
{
	struct hawser__klu *klu = calloc(1, sizeof *klu);
	enum hawser_status status;

	*made = NULL;
	if (!klu)
		return hawser__no_memory(report, "net");
	klu_defaults(&klu->common);
	klu->common.scale = 0;
	klu->common.btf = 0;
	klu->unknowns = mesh->unknowns;
	klu->nodes = mesh->nodes;
	klu->elements = mesh->elements;
	klu->unknown = (const int (*)[3])mesh->unknown;
	status = pattern(klu, mesh, report);
	if (status)
		hawser__klu_clear(klu);
	else
		*made = klu;
	return status;
}

void hawser__klu_zero(struct hawser__klu *klu)
{
	memset(klu->x, 0, (size_t)klu->p[klu->unknowns]*sizeof *klu->x);
}

static void add(struct hawser__klu *klu, int element, const double B[9], const double other[9],
                const double mass[2])
{
	for (int k = 0; k < ENTRIES; k++) {
		int row = k/6, column = k%6, same = row/3 == column/3, at = klu->at[element][k];
		double value = (row < 3 ? B : other)[3*(row%3) + column%3]*(same ? 1.0 : -1.0);

		if (at >= 0)
			klu->x[at] += value + (row%3 == column%3 ? mass[!same] : 0.0);
	}
}

void hawser__klu_element(struct hawser__klu *klu, int element, const double B[9], const double mass[2])
{
	add(klu, element, B, B, mass);
}

void hawser__klu_ends(struct hawser__klu *klu, int element, const double block[6][6], double factor)
{
	for (int k = 0; k < ENTRIES; k++)
		if (klu->at[element][k] >= 0)
			klu->x[klu->at[element][k]] += factor*block[k/6][k%6];
}

void hawser__klu_node(struct hawser__klu *klu, int element, int end, const double block[3][3])
{
	for (int k = 0; k < 9; k++) {
		int at = klu->at[element][6*(3*end + k/3) + 3*end + k%3];

		if (at >= 0)
			klu->x[at] += block[k/3][k%3];
	}
}

static void assemble(struct hawser__klu *klu, const struct hawser__blocks_matrix *of)
{
	hawser__klu_zero(klu);
	for (int i = 0; i < klu->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (klu->diagonal[i][k] >= 0)
				klu->x[klu->diagonal[i][k]] += of->point[i];
	for (int i = 0; i < 9*klu->nodes && of->block; i++) {
		int row = klu->unknown[i/9][i%9/3], column = klu->unknown[i/9][i%3];

		if (row >= 0 && column >= 0)
			klu->x[find(klu, row, column)] += of->block[i/9][i%9];
	}
	for (int e = 0; e < klu->elements; e++)
		add(klu, e, of->B[e], of->other ? of->other[e] : of->B[e], of->mass[e]);
}

enum hawser_status hawser__klu_divide(double *x, int *good, struct hawser__klu *klu,
                                      struct hawser_report *report)
{
	int done = !klu->unknowns;

	*good = done;
	if (done)
		return HAWSER_OK;
	done = klu->numeric && klu_refactor(klu->p, klu->i, klu->x, klu->symbolic, klu->numeric,
	                                        &klu->common) && klu->common.status == KLU_OK;

	if (!done) {
		klu_free_numeric(&klu->numeric, &klu->common);
		klu->numeric = klu_factor(klu->p, klu->i, klu->x, klu->symbolic, &klu->common);
		done = klu->numeric && klu->common.status == KLU_OK;
	}
	*good = done;
	if (!done)
		return klu->common.status == KLU_SINGULAR ? HAWSER_OK : failed(klu, report);
	return klu_solve(klu->symbolic, klu->numeric, klu->unknowns, 1, x, &klu->common)
	       ? HAWSER_OK : failed(klu, report);
}

enum hawser_status hawser__klu_again_complex(double *x, struct hawser__klu *re,
                                             struct hawser_report *report)
{
	return !re->unknowns || klu_z_solve(re->symbolic, re->factors, re->unknowns, 1, x, &re->common)
	       ? HAWSER_OK : failed(re, report);
}

enum hawser_status hawser__klu_divide_complex(double *x, int *good, struct hawser__klu *re,
                                              const struct hawser__klu *im,
                                              struct hawser_report *report)
{
	size_t entries = (size_t)re->p[re->unknowns];
	int done = !re->unknowns;

	*good = done;
	if (done)
		return HAWSER_OK;

	if (!re->z && !(re->z = malloc((2*entries + 1)*sizeof *re->z)))
		return hawser__no_memory(report, "net");
	for (size_t i = 0; i < entries; i++) {
		re->z[2*i] = re->x[i];
		re->z[2*i + 1] = im->x[i];
	}
	done = re->factors && klu_z_refactor(re->p, re->i, re->z, re->symbolic, re->factors, &re->common) &&
	       re->common.status == KLU_OK;
	if (!done) {
		klu_z_free_numeric(&re->factors, &re->common);
		re->factors = klu_z_factor(re->p, re->i, re->z, re->symbolic, &re->common);
		done = re->factors && re->common.status == KLU_OK;
	}
	*good = done;
	if (!done)
		return re->common.status == KLU_SINGULAR ? HAWSER_OK : failed(re, report);
	return hawser__klu_again_complex(x, re, report);
}

enum hawser_status hawser__klu_solve(double (*r)[3], int *good, struct hawser__klu *klu,
                                     const struct hawser__blocks_matrix *matrix,
                                     struct hawser_report *report)
{
	enum hawser_status status;

	assemble(klu, matrix);
	for (int i = 0; i < klu->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (klu->unknown[i][k] >= 0)
				klu->right[klu->unknown[i][k]] = r[i][k];
	status = hawser__klu_divide(klu->right, good, klu, report);
	for (int i = 0; !status && *good && i < klu->nodes; i++)
		for (int k = 0; k < 3; k++)
			r[i][k] = klu->unknown[i][k] >= 0 ? klu->right[klu->unknown[i][k]] : 0.0;
	return status;
}
