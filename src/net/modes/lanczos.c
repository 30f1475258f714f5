/* net/modes/lanczos.c - lowest modes of a mesh by the block Lanczos method; see eigen.h.
 *
 * B     inv(K)*M, whose largest eigenvalues mu = 1/omega^2 are wanted
 * V     [columns][unknowns] a basis, V'*M*V = I; the images B*v of the first `done` columns lie in it
 * A     V'*M*B*V; its eigenvalues approach those of B from below
 *
 * Subspace iteration needs some fifteen solutions for each of twice as many vectors as modes; a basis
 * of all images needs about twice as many solutions as modes in all. The columns are made orthogonal
 * to all before them, twice, so that no mode comes back as a copy.
 *
 * A block of p vectors can miss copies of a frequency that p + 1 or more modes share, as in a row of
 * equal cables. The number of modes below a shift just above the last one is therefore counted; as
 * long as it is larger than what was found, random vectors join the block.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <cblas.h>
#include <lapacke.h>

#include "core/report.h"
#include "net/modes/eigen.h"

enum { FEW = 16, SMALL = 4, LARGE = 8, /* columns of a block: of fewer modes than FEW, of more */
       MORE = 20, LEAST = 400,         /* most columns: MORE for each mode, and LEAST */
       ROUNDS = 100, SHIFTS = 5,       /* of counting; shifts tried in a round */
       COLUMN = 102 /* LAPACK_COL_MAJOR */ };
static const double converged = 1e-9;  /* residual of B over mu */
static const double roundoff = 1e-14;  /* of A, over its largest eigenvalue */
static const double dependent = 1e-10; /* part of a vector outside the others that is round-off */

struct basis {
	struct hawser__eigen *eigen;
	int n, done, columns, room, block;
	double *v;      /* [room][n] */
	double *a;      /* [room][room] column j: what B*v_j has along the others */
	double *s, *mu; /* [room][room] eigenvectors of A, [room] values, ascending */
	double *w, *mw, *c; /* [n], [n], [room] */
	unsigned long long seed;
};

static void clear(struct basis *basis)
{
	free(basis->v);
	free(basis->a);
	free(basis->s);
	free(basis->mu);
	free(basis->w);
	free(basis->mw);
	free(basis->c);
}

/* Room for `more` columns. */
static enum hawser_status grow(struct basis *basis, int more, struct hawser_report *report)
{
	size_t n = (size_t)basis->n, room = (size_t)(basis->columns + more), old = (size_t)basis->room;
	double *v, *a;

	if (basis->columns + more <= basis->room)
		return HAWSER_OK;
	room += room/2;
	v = realloc(basis->v, room*n*sizeof *v);
	basis->v = v ? v : basis->v;
	a = calloc(room*room, sizeof *a);
	free(basis->s);
	free(basis->mu);
	free(basis->c);
	basis->s = malloc(room*room*sizeof *basis->s);
	basis->mu = malloc(room*sizeof *basis->mu);
	basis->c = malloc(room*sizeof *basis->c);
	if (!v || !a || !basis->s || !basis->mu || !basis->c) {
		free(a);
		return hawser__no_memory(report, "net");
	}
	for (size_t j = 0; j < old; j++)
		memcpy(a + j*room, basis->a + j*old, old*sizeof *a);
	free(basis->a);
	basis->a = a;
	basis->room = (int)room;
	return HAWSER_OK;
}

/* Take the columns of V out of w, twice; what was there is added to `into` [columns], or NULL. Returns
 * the length of what is left over that of w: below `dependent` there is nothing. mw: M*w. */
static double separate(struct basis *basis, double *into)
{
	double before, after = 0.0;

	hawser__eigen_mass(basis->mw, basis->w, basis->eigen->mesh, 7U);
	before = sqrt(cblas_ddot(basis->n, basis->w, 1, basis->mw, 1));
	for (int pass = 0; pass < 2; pass++) {
		if (basis->columns > 0) {
			cblas_dgemv(CblasColMajor, CblasTrans, basis->n, basis->columns, 1.0, basis->v, basis->n,
			            basis->mw, 1, 0.0, basis->c, 1);
			cblas_dgemv(CblasColMajor, CblasNoTrans, basis->n, basis->columns, -1.0, basis->v,
			            basis->n, basis->c, 1, 1.0, basis->w, 1);
		}
		for (int i = 0; i < basis->columns && into; i++)
			into[i] += basis->c[i];
		hawser__eigen_mass(basis->mw, basis->w, basis->eigen->mesh, 7U);
	}
	after = sqrt(cblas_ddot(basis->n, basis->w, 1, basis->mw, 1));
	return after/before;
}

/* Append w, made of length 1; returns its length. */
static double append(struct basis *basis)
{
	double length = sqrt(cblas_ddot(basis->n, basis->w, 1, basis->mw, 1));
	double *v = basis->v + (size_t)basis->columns*(size_t)basis->n;

	for (int i = 0; i < basis->n; i++)
		v[i] = basis->w[i]/length;
	basis->columns++;
	return length;
}

static enum hawser_status image(struct basis *basis, struct hawser_report *report)
{
	basis->eigen->iterations++;
	memcpy(basis->w, basis->mw, (size_t)basis->n*sizeof *basis->w);
	return hawser__border_solve(basis->w, basis->eigen->border, basis->eigen->sparse, report);
}

/* Random vectors, the same in each run. B is applied twice: a rough vector has an energy that hides the
 * modes. */
static enum hawser_status join(struct basis *basis, int count, struct hawser_report *report)
{
	enum hawser_status status = grow(basis, count, report);

	for (int k = 0; k < count && !status && basis->columns < basis->eigen->massive; k++) {
		for (int i = 0; i < basis->n; i++) {
			basis->seed ^= basis->seed << 13;
			basis->seed ^= basis->seed >> 7;
			basis->seed ^= basis->seed << 17;
			basis->w[i] = (double)(basis->seed >> 11)/9007199254740992.0 - 0.5;
		}
		for (int pass = 0; pass < 2 && !status; pass++) {
			hawser__eigen_mass(basis->mw, basis->w, basis->eigen->mesh, 7U);
			status = image(basis, report);
		}
		if (!status && separate(basis, NULL) > dependent)
			append(basis);
	}
	return status;
}

/* Images of the columns that have none yet. */
static enum hawser_status step(struct basis *basis, struct hawser_report *report)
{
	int last = basis->columns;
	enum hawser_status status = grow(basis, last - basis->done, report);

	for (int j = basis->done; j < last && !status; j++) {
		double *column = basis->a + (size_t)j*(size_t)basis->room;

		hawser__eigen_mass(basis->mw, basis->v + (size_t)j*(size_t)basis->n, basis->eigen->mesh, 7U);
		status = image(basis, report);
		if (!status && separate(basis, column) > dependent &&
		    basis->columns < basis->eigen->massive) {
			int fresh = basis->columns;

			column[fresh] = append(basis);
		}
	}
	basis->done = last;
	return status;
}

static enum hawser_status ritz(struct basis *basis, struct hawser_report *report)
{
	int m = basis->done, info;

	for (int j = 0; j < m; j++)
		memcpy(basis->s + (size_t)j*(size_t)m, basis->a + (size_t)j*(size_t)basis->room,
		       (size_t)m*sizeof *basis->s);
	info = LAPACKE_dsyevd(COLUMN, 'V', 'U', m, basis->s, m, basis->mu);
	if (info == 0)
		return HAWSER_OK;
	return hawser__lapack_starved(info) ? hawser__no_memory(report, "net")
		: hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: the modes cannot be told apart to "
		               "double precision: ask for fewer than %d", basis->eigen->name, basis->eigen->n);
}

/* omega^2 of mode j, from 0. */
static double value(const struct basis *basis, int j)
{
	return 1.0/basis->mu[basis->done - 1 - j];
}

/* Whether mode j is found: the part of its image outside the columns whose images are known. */
static int is_found(const struct basis *basis, int j)
{
	const double *s = basis->s + (size_t)(basis->done - 1 - j)*(size_t)basis->done;
	double mu = basis->mu[basis->done - 1 - j], sum = 0.0;

	for (int i = basis->done; i < basis->columns; i++) {
		double part = 0.0;

		for (int k = 0; k < basis->done; k++)
			part += basis->a[(size_t)k*(size_t)basis->room + (size_t)i]*s[k];
		sum += part*part;
	}
	return mu > 0.0 && sqrt(sum) <= fmax(converged*mu, roundoff*basis->mu[basis->done - 1]);
}

/* Number of modes up to the first gap at or after mode `n`; 0 if there is none yet. */
static int up_to_gap(const struct basis *basis, int n)
{
	for (int j = n; j < basis->done; j++)
		if (basis->mu[basis->done - 1 - j]*value(basis, j - 1) < 1.0/(1.0 + HAWSER__EIGEN_EQUAL))
			return j;
	return basis->done == basis->eigen->massive ? basis->done : 0;
}

/* One more vector at least: images of the last ones, or random ones; *more is 0 where all that is left
 * outside the basis is round-off. */
static enum hawser_status extend(int *more, struct basis *basis, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (basis->done == basis->columns && basis->columns < basis->eigen->massive)
		status = join(basis, basis->block, report);
	*more = basis->done < basis->columns;
	return status || !*more ? status : step(basis, report);
}

/* Go on until `n` modes and those of the same frequency are found: *found. */
static enum hawser_status find(int *found, struct basis *basis, int n, struct hawser_report *report)
{
	int most = MORE*basis->eigen->n + LEAST, more = 1;

	for (*found = 0; more && basis->done <= most;) {
		enum hawser_status status = extend(&more, basis, report);

		if (!status && more && basis->done <= n && basis->done < basis->eigen->massive)
			continue;
		if (!status && basis->done > 0)
			status = ritz(basis, report);
		if (status)
			return status;
		*found = up_to_gap(basis, n);
		for (int j = *found - 1; j >= 0 && *found; j--)
			if (!is_found(basis, j))
				*found = 0;
		if (*found)
			return HAWSER_OK;
	}
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: the modes were not found with %d "
	                    "vectors%s: ask for fewer than %d", basis->eigen->name, basis->done,
	                    more ? "" : ", and others are not independent of these to double precision",
	                    basis->eigen->n);
}

static void vector(double *x, const struct basis *basis, int j)
{
	cblas_dgemv(CblasColMajor, CblasNoTrans, basis->n, basis->done, 1.0, basis->v, basis->n,
	            basis->s + (size_t)(basis->done - 1 - j)*(size_t)basis->done, 1, 0.0, x, 1);
}

/* Modes below a shift above the last one found; 0: round-off prevents the count. */
static enum hawser_status count(int *below, struct basis *basis, int found,
                                struct hawser_report *report)
{
	double gap = found < basis->done ? fmin(value(basis, found)/value(basis, found - 1) - 1.0, 1.0)
		: 1.0;
	double distance = fmin(0.5*gap, HAWSER__EIGEN_ABOVE);
	enum hawser_status status = HAWSER_OK;
	int sure = 0;

	vector(basis->w, basis, found - 1);
	for (int k = 0; k < SHIFTS && !sure && !status; k++, distance *= 0.6) {
		basis->eigen->shift = value(basis, found - 1)*(1.0 + distance);
		status = hawser__eigen_count(below, &sure, basis->eigen, basis->eigen->shift, basis->w, report);
		sure = sure && *below >= found; /* the values are upper bounds */
	}
	if (!sure)
		*below = 0;
	return status;
}

static enum hawser_status certify(struct basis *basis, struct hawser_report *report)
{
	int found, below = 0, n = basis->eigen->n;
	enum hawser_status status = find(&found, basis, n, report);

	for (int round = 0; round < ROUNDS && !status; round++) {
		basis->eigen->found = found;
		basis->eigen->shift = 0.0;
		if (found == basis->eigen->massive)
			return HAWSER_OK;
		status = count(&below, basis, found, report);
		if (!status && (below == 0 || (below > found && basis->done == basis->eigen->massive))) {
			basis->eigen->shift = -1.0;
			return HAWSER_OK;
		}
		if (status || below == found)
			return status;
		status = join(basis, basis->block, report);
		if (!status)
			status = find(&found, basis, below, report);
	}
	return status ? status
		: hawser__fail(report, HAWSER_ERR_CONVERGENCE, "net", "%s: %d modes are below %.6g rad/s, and "
		               "only %d of them were found: ask for more or fewer than %d",
		               basis->eigen->name, below, sqrt(basis->eigen->shift), found, n);
}

enum hawser_status hawser__eigen_lanczos(struct hawser__eigen *eigen, struct hawser_report *report)
{
	size_t n = (size_t)eigen->mesh->unknowns;
	struct basis basis = {.eigen = eigen, .n = eigen->mesh->unknowns, .seed = 88172645463325252ULL,
	                      .block = eigen->n < FEW ? SMALL : LARGE};
	enum hawser_status status = HAWSER_OK;

	basis.w = malloc(n*sizeof *basis.w);
	basis.mw = malloc(n*sizeof *basis.mw);
	if (!basis.w || !basis.mw)
		status = hawser__no_memory(report, "net");
	if (!status)
		status = certify(&basis, report);
	if (!status) {
		eigen->x = malloc((size_t)eigen->found*n*sizeof *eigen->x);
		eigen->value = malloc((size_t)eigen->found*sizeof *eigen->value);
		eigen->error = calloc((size_t)eigen->found, sizeof *eigen->error);
		if (!eigen->x || !eigen->value || !eigen->error)
			status = hawser__no_memory(report, "net");
	}
	for (int j = 0; j < eigen->found && !status; j++) {
		eigen->value[j] = value(&basis, j);
		vector(eigen->x + (size_t)j*n, &basis, j);
	}
	clear(&basis);
	return status;
}
