/* response/floquet/monodromy_rest.c - frequencies of variational equations that belong to motions,
 * not to coordinates.
 *
 *    b    coordinates beyond any resonance, and beyond the widest gap of frequencies there: the
 *         motions along the cable
 *    a    the others
 *    S    stiffness of a if b follows statically, K_aa - K_ab K_bb^-1 K_ba, at each phase
 *    W    see monodromy_condense.c
 *
 * In a model with exact energy the coordinates are modes at rest. Where the cable has turned, a
 * motion across is one along it too, and the diagonal of K has the stiffness EA times the square of
 * the angle: the mean frequency of a slow coordinate is then a hundred times that of any motion in
 * which it takes part, and it and its harmonics say nothing about resonances. The coordinates along
 * the cable cancel this stiffness. The frequencies are therefore those at rest (which differ from
 * those of S by the change of the tension), and the resonances are those of the harmonics of S.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "response/floquet/monodromy.h"

#define NOISE 1e-10     /* harmonics of K, relative to two frequencies, that are left out in any case;
                         * chosen, above round-off and far below the errors that are admitted */
#define BEYOND 2.0      /* frequency of b relative to that of the highest harmonic; chosen */

/* Largest |K_k| relative to the frequencies of its coordinates. */
static double size_of(const struct hawser__monodromy *monodromy,
                      const struct hawser__variational *system, int k)
{
	int n = system->n;
	const double *c = system->K + (size_t)(2*k - 1)*n*n, *s = c + (size_t)n*n;
	double top = 0.0;

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++)
			top = fmax(top, fmax(fabs(c[i*n + j]), fabs(s[i*n + j]))/
			                (monodromy->frequency[i]*monodromy->frequency[j]));
	return top;
}

/* The highest harmonic of K that counts, where the reduced stiffness may be off by *noise; what is left
 * out becomes *noise. The fast coordinates of a motion add up to sqrt(K_ss), at most about. */
static int highest(const struct hawser__monodromy *monodromy,
                   const struct hawser__variational *system, double *noise)
{
	double most = 1.0, left = 0.0;
	int k = system->order;

	for (int i = 0; i < system->n; i++)
		most = fmax(most, sqrt(0.5*fabs(system->K[(size_t)i*(system->n + 1)]))/
		                  monodromy->frequency[i]);
	most = fmax(NOISE, *noise/((1.0 + most)*(1.0 + most)));
	for (*noise = 0.0; k > 0 && (left += size_of(monodromy, system, k)) <= most; k--)
		*noise = left;
	return k;
}

/* S at one phase, in the place of K_aa; returns 1 if K_bb is not positive. Only the lower triangles
 * of the symmetric matrices are used. */
static int follow(double *K, int n, int na)
{
	int nb = n - na;
	double *bb = K + (size_t)na*n + na, *ba = K + (size_t)na*n;

	if (LAPACKE_dpotrf_work(LAPACK_ROW_MAJOR, 'L', nb, bb, n))
		return 1;
	cblas_dtrsm(CblasRowMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, nb, na, 1.0,
	            bb, n, ba, n);
	cblas_dsyrk(CblasRowMajor, CblasLower, CblasTrans, na, nb, -1.0, ba, n, 1.0, K, n);
	return 0;
}

void hawser__monodromy_phases(double *basis, int rows, int order)
{
	int columns = 2*order + 1;

	for (int i = 0; i < rows; i++) {
		double *row = basis + (size_t)i*columns;

		row[0] = 0.5;
		for (int c = 1; c < columns; c++) {
			double angle = 2.0*M_PI*(double)((long)i*((c + 1)/2)%rows)/rows;

			row[c] = c%2 ? cos(angle) : sin(angle);
		}
	}
}

/* The series of S [2 order + 1][na][na] from its values in the places of K_aa [rows][n][n], which
 * are overwritten. */
static void collect(double *series, double *K, double *basis, int rows, int order, int n, int na)
{
	int columns = 2*order + 1;

	for (int r = 0; r < rows; r++)
		for (int i = 0; i < na; i++)
			for (int j = 0; j < na; j++)
				K[((size_t)r*na + i)*na + j] =
					K[((size_t)r*n + (i > j ? i : j))*n + (i > j ? j : i)];
	for (int r = 0; r < rows; r++)
		basis[(size_t)r*columns] = 1.0; /* the constant is obtained twice */
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, na*na, rows, 2.0/rows, basis,
	            columns, K, na*na, 0.0, series, na*na);
}

static enum hawser_status make_reduced(struct hawser__monodromy *monodromy, size_t need,
                                       struct hawser_report *report)
{
	if (need <= monodromy->reduced_room)
		return HAWSER_OK;
	free(monodromy->reduced);
	monodromy->reduced = malloc(2*need*sizeof(double));
	monodromy->reduced_room = monodromy->reduced ? 2*need : 0;
	return monodromy->reduced ? HAWSER_OK : hawser__no_memory(report, "orbit");
}

/* If K_bb is not positive at a phase, the resonances are those of K. The harmonics of S decrease as
 * those of K, for which these phases are enough. */
enum hawser_status hawser__monodromy_resonances(struct hawser__monodromy *monodromy,
                                                struct hawser__variational *system, double *noise,
                                                struct hawser_report *report)
{
	int n = system->n, order = highest(monodromy, system, noise);
	int na = hawser__fast_gap(monodromy, n, BEYOND*(order + 1)*system->omega);
	int columns = 2*order + 1, rows = columns;
	size_t table = (size_t)rows*columns, samples = (size_t)rows*n*n;
	double *basis, *K, *D;
	struct hawser__variational slow = {.order = order, .omega = system->omega};

	system->order = order;
	monodromy->reduced_n = 0;
	if (hawser__monodromy_room(monodromy, table + samples + (size_t)n*n, report) ||
	    make_reduced(monodromy, (size_t)columns*na*na, report))
		return HAWSER_ERR_MEMORY;
	basis = monodromy->room;
	K = basis + table;
	D = K + samples;
	hawser__monodromy_phases(basis, rows, order);
	cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, n*n, columns, 1.0, basis,
	            columns, system->K, n*n, 0.0, K, n*n);
	for (int r = 0; r < rows && na < n; r++)
		if (follow(K + (size_t)r*n*n, n, na)) { /* in compression */
			hawser__fast_find_range(monodromy, system);
			return HAWSER_OK;
		}
	collect(monodromy->reduced, K, basis, rows, order, n, na);
	for (int j = 0; j < na; j++)
		D[(size_t)j*(na + 1)] = system->D[(size_t)j*(n + 1)];
	monodromy->reduced_n = slow.n = na;
	slow.K = monodromy->reduced;
	slow.D = D;
	hawser__fast_find_range(monodromy, &slow);
	return HAWSER_OK;
}
