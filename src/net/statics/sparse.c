/* net/statics/sparse.c - symmetric matrices over the unknowns of a mesh, and their Cholesky factors.
 *
 * The lower triangle is stored by columns; each element knows where its 21 entries are, so that a
 * new matrix costs no search. The order of elimination is found once, for the graph of the nodes
 * (net/statics/elimination.c). CHOLMOD factors small matrices by columns and large ones by dense
 * blocks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/columns.h"
#include "core/report.h"
#include "net/statics/solve.h"

enum { ENTRIES = 21, DIRECTIONS = 6 };
/* Operations per entry of the factors from which CHOLMOD factors by dense blocks. Below it factors
 * by columns, which is faster there: with 74 (a web of 2919 unknowns) 4 against 6 ms, with 98 (a
 * roof of 9747) as fast, with 234 (a web of 29586) 240 against 80 ms (nets of bench/net-statics). */
#define BLOCKS_FROM 100.0

/* Where CHOLMOD uses OpenMP, it starts four threads in each dense block, whatever the number of
 * threads or processors is; they wait actively, so that the factors took two to eight times the
 * processor time. With no active level of parallel regions its loops run in the calling thread. The
 * levels are those of this thread alone, and are set back. */
#ifdef HAVE_OMP_LEVELS
int omp_get_max_active_levels(void);
void omp_set_max_active_levels(int levels);

static int begin_serial(void)
{
	int levels = omp_get_max_active_levels();

	omp_set_max_active_levels(0);
	return levels;
}

static void end_serial(int levels)
{
	omp_set_max_active_levels(levels);
}
#else
static int begin_serial(void)
{
	return 0;
}

static void end_serial(int levels)
{
	(void)levels;
}
#endif

struct hawser__sparse {
	cholmod_common common;
	cholmod_sparse *matrix;
	cholmod_factor *factor;
	cholmod_dense *right, *x, *y, *e; /* y, e: work space of the solver */
	int (*at)[ENTRIES]; /* [elements] in the values of the matrix; -1: a held direction */
	int *diagonal;      /* [unknowns] */
	int unknowns;
};

void hawser__sparse_clear(struct hawser__sparse *sparse)
{
	if (!sparse)
		return;
	cholmod_free_factor(&sparse->factor, &sparse->common);
	cholmod_free_sparse(&sparse->matrix, &sparse->common);
	cholmod_free_dense(&sparse->right, &sparse->common);
	cholmod_free_dense(&sparse->x, &sparse->common);
	cholmod_free_dense(&sparse->y, &sparse->common);
	cholmod_free_dense(&sparse->e, &sparse->common);
	cholmod_finish(&sparse->common);
	free(sparse->at);
	free(sparse->diagonal);
	free(sparse);
}

static enum hawser_status failed(struct hawser__sparse *sparse, struct hawser_report *report)
{
	if (sparse->common.status == CHOLMOD_OUT_OF_MEMORY || sparse->common.status == CHOLMOD_TOO_LARGE)
		return hawser__no_memory(report, "net");
	return hawser__fail(report, HAWSER_ERR_PROGRAM, "net", "CHOLMOD failed with status %d",
	                    sparse->common.status);
}

/* Row and column of the entry-th of the lower triangle of 6x6. */
static void pair(int *i, int *j, int entry)
{
	for (*i = 0; entry > *i; ++*i)
		entry -= *i + 1;
	*j = entry;
}

/* List the entries (column, row) of all elements, absorbers and of the diagonal: list [count][2]. */
static size_t list_entries(int (*list)[2], const struct hawser__mesh *mesh)
{
	size_t count = 0;

	for (int j = 0; j < mesh->unknowns; j++, count++)
		list[count][0] = list[count][1] = j;
	for (int e = 0; e < mesh->elements; e++) {
		int u[DIRECTIONS];

		hawser__mesh_unknowns(u, mesh, e);
		for (int i = 0; i < DIRECTIONS; i++)
			for (int j = 0; j < i; j++) {
				if (u[i] < 0 || u[j] < 0)
					continue;
				list[count][0] = u[i] < u[j] ? u[i] : u[j];
				list[count++][1] = u[i] < u[j] ? u[j] : u[i];
			}
	}
	for (int i = 0; i < 3*mesh->absorbers; i++) {
		const struct hawser__mesh_absorber *of = &mesh->absorber[i/3];
		int own = mesh->unknown[of->at][of->axis], u = mesh->unknown[of->node][i%3];

		if (own < 0 || u < 0)
			continue;
		list[count][0] = own < u ? own : u;
		list[count++][1] = own < u ? u : own;
	}
	return count;
}

static void locate(struct hawser__sparse *sparse, const struct hawser__mesh *mesh)
{
	const int *p = sparse->matrix->p, *rows = sparse->matrix->i;

	for (int j = 0; j < mesh->unknowns; j++)
		sparse->diagonal[j] = hawser__columns_find(p, rows, j, j);
	for (int e = 0; e < mesh->elements; e++) {
		int u[DIRECTIONS], i, j;

		hawser__mesh_unknowns(u, mesh, e);
		for (int entry = 0; entry < ENTRIES; entry++) {
			pair(&i, &j, entry);
			sparse->at[e][entry] = u[i] < 0 || u[j] < 0 ? -1
				: u[i] < u[j] ? hawser__columns_find(p, rows, u[j], u[i])
				              : hawser__columns_find(p, rows, u[i], u[j]);
		}
	}
}

static enum hawser_status pattern(struct hawser__sparse *sparse, const struct hawser__mesh *mesh,
                                  struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	size_t most = (size_t)mesh->unknowns + 15*(size_t)mesh->elements + 3*(size_t)mesh->absorbers, count;
	int (*list)[2] = malloc((most + 1)*sizeof *list);

	sparse->at = malloc(((size_t)mesh->elements + 1)*sizeof *sparse->at);
	sparse->diagonal = malloc(((size_t)mesh->unknowns + 1)*sizeof *sparse->diagonal);
	if (list && sparse->at && sparse->diagonal) {
		count = list_entries(list, mesh);
		sparse->matrix = cholmod_allocate_sparse((size_t)mesh->unknowns, (size_t)mesh->unknowns, count,
		                                         1, 1, -1, CHOLMOD_REAL, &sparse->common);
		if (!sparse->matrix)
			status = failed(sparse, report);
		else if (hawser__columns(sparse->matrix->p, sparse->matrix->i, list, count, mesh->unknowns))
			status = hawser__no_memory(report, "net");
		else
			locate(sparse, mesh);
	} else {
		status = hawser__no_memory(report, "net");
	}
	free(list);
	return status;
}

/* The order of elimination, and the pattern of the factors. */
static enum hawser_status analyse(struct hawser__sparse *sparse, const struct hawser__mesh *mesh,
                                  struct hawser_report *report)
{
	int *permutation = malloc(((size_t)mesh->unknowns + 1)*sizeof *permutation);

	if (!permutation || !hawser__elimination(permutation, mesh, &sparse->common)) {
		free(permutation);
		return hawser__no_memory(report, "net");
	}
	sparse->common.nmethods = 1;
	sparse->common.method[0].ordering = CHOLMOD_GIVEN;
	sparse->factor = cholmod_analyze_p(sparse->matrix, permutation, NULL, 0, &sparse->common);
	free(permutation);
	return sparse->factor ? HAWSER_OK : failed(sparse, report);
}

static enum hawser_status open_with(struct hawser__sparse **made, const struct hawser__mesh *mesh,
                                    int indefinite, struct hawser_report *report)
{
	struct hawser__sparse *sparse = calloc(1, sizeof *sparse);
	enum hawser_status status;

	*made = NULL;
	if (!sparse)
		return hawser__no_memory(report, "net");
	cholmod_start(&sparse->common);
	sparse->common.print = 0; /* the library never prints */
	sparse->common.supernodal = indefinite ? CHOLMOD_SIMPLICIAL : CHOLMOD_AUTO;
	sparse->common.supernodal_switch = BLOCKS_FROM;
	/* L*L' tells a matrix that is not definite, L*D*L' goes on. */
	sparse->common.final_ll = !indefinite;
	sparse->unknowns = mesh->unknowns;
	status = pattern(sparse, mesh, report);
	if (!status) {
		hawser__sparse_zero(sparse);
		sparse->right = cholmod_zeros((size_t)mesh->unknowns, 1, CHOLMOD_REAL, &sparse->common);
		status = sparse->right ? analyse(sparse, mesh, report) : failed(sparse, report);
	}
	if (status)
		hawser__sparse_clear(sparse);
	else
		*made = sparse;
	return status;
}

enum hawser_status hawser__sparse_open(struct hawser__sparse **made, const struct hawser__mesh *mesh,
                                       struct hawser_report *report)
{
	return open_with(made, mesh, 0, report);
}

enum hawser_status hawser__sparse_open_indefinite(struct hawser__sparse **made,
                                                  const struct hawser__mesh *mesh,
                                                  struct hawser_report *report)
{
	return open_with(made, mesh, 1, report);
}

double hawser__sparse_bytes(const struct hawser__sparse *sparse)
{
	double elements = sparse->matrix ? (double)sparse->matrix->nzmax : 0.0;

	/* the list of entries of the pattern lives beside the matrix for a while */
	return (double)sparse->common.memory_usage + 8.0*elements;
}

void hawser__sparse_zero(struct hawser__sparse *sparse)
{
	const int *p = sparse->matrix->p;

	memset(sparse->matrix->x, 0, (size_t)p[sparse->unknowns]*sizeof(double));
}

void hawser__sparse_add(struct hawser__sparse *sparse, int element, double a, double b,
                        const double e[3])
{
	const int *at = sparse->at[element];
	double *x = sparse->matrix->x;

	for (int i = 0, entry = 0; i < DIRECTIONS; i++)
		for (int j = 0; j <= i; j++, entry++) {
			double value = b*e[i%3]*e[j%3] + (i%3 == j%3 ? a : 0.0);

			if (at[entry] >= 0)
				x[at[entry]] += i/3 == j/3 ? value : -value;
		}
}

void hawser__sparse_block(struct hawser__sparse *sparse, int element, const double block[3][3])
{
	const int *at = sparse->at[element];
	double *x = sparse->matrix->x;

	for (int i = 0, entry = 0; i < DIRECTIONS; i++)
		for (int j = 0; j <= i; j++, entry++)
			if (at[entry] >= 0)
				x[at[entry]] += i/3 == j/3 ? block[i%3][j%3] : -block[i%3][j%3];
}

void hawser__sparse_ends(struct hawser__sparse *sparse, int element, const double block[6][6])
{
	const int *at = sparse->at[element];
	double *x = sparse->matrix->x;

	for (int i = 0, entry = 0; i < DIRECTIONS; i++)
		for (int j = 0; j <= i; j++, entry++)
			if (at[entry] >= 0) /* both triangles of two directions that are one unknown */
				x[at[entry]] += i != j && at[entry] == at[i*(i + 3)/2] ? 2.0*block[i][j]
				                                                       : block[i][j];
}

void hawser__sparse_node(struct hawser__sparse *sparse, int element, int end, const double block[3][3])
{
	const int *at = sparse->at[element];
	double *x = sparse->matrix->x;

	for (int i = 3*end; i < 3*end + 3; i++)
		for (int j = 3*end; j <= i; j++) {
			int entry = at[i*(i + 1)/2 + j];

			if (entry >= 0)
				x[entry] += block[i - 3*end][j - 3*end];
		}
}

void hawser__sparse_diagonal(struct hawser__sparse *sparse, int unknown, double value)
{
	((double *)sparse->matrix->x)[sparse->diagonal[unknown]] += value;
}

void hawser__sparse_pair(struct hawser__sparse *sparse, int unknown, int other, double value)
{
	int low = unknown < other ? unknown : other, high = unknown < other ? other : unknown;
	int at = hawser__columns_find(sparse->matrix->p, sparse->matrix->i, high, low);

	((double *)sparse->matrix->x)[at] += value;
}

enum hawser_status hawser__sparse_factor(struct hawser__sparse *sparse, int *definite,
                                         struct hawser_report *report)
{
	int levels = begin_serial();
	int done = cholmod_factorize(sparse->matrix, sparse->factor, &sparse->common);

	end_serial(levels);
	*definite = done && sparse->common.status == CHOLMOD_OK;
	if (*definite || sparse->common.status == CHOLMOD_NOT_POSDEF ||
	    sparse->common.status == CHOLMOD_DSMALL)
		return HAWSER_OK;
	return failed(sparse, report);
}

enum hawser_status hawser__sparse_inertia(int *negative, int *done, struct hawser__sparse *sparse,
                                          struct hawser_report *report)
{
	enum hawser_status status = hawser__sparse_factor(sparse, done, report);
	const double *x;
	const int *p;

	*negative = 0;
	if (status || !*done)
		return status;
	x = sparse->factor->x;
	p = sparse->factor->p;
	for (int j = 0; j < sparse->unknowns; j++) { /* D is where the diagonal of L, all ones, would be */
		*done = *done && x[p[j]] != 0.0;
		*negative += x[p[j]] < 0.0;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__sparse_solve(double *x, struct hawser__sparse *sparse,
                                        struct hawser_report *report)
{
	size_t size = (size_t)sparse->unknowns*sizeof *x;

	memcpy(sparse->right->x, x, size);
	if (!cholmod_solve2(CHOLMOD_A, sparse->factor, sparse->right, NULL, &sparse->x, NULL, &sparse->y,
	                    &sparse->e, &sparse->common))
		return failed(sparse, report);
	memcpy(x, sparse->x->x, size);
	return HAWSER_OK;
}
