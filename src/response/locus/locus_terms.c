/* response/locus/locus_terms.c - terms of any degree (rom.h), or a function of a library, in the
 * equations of a locus; see locus.h.
 *
 *   P_u, P_v  derivatives of the terms' force by coordinates and velocities, at the samples
 *   x, x'     a signal and its derivative by the phase; its velocities are omega x'
 *
 * P_v is a damping that varies. The derivative of the tangents along a signal is along its velocities
 * too, and that of P_v contributes to the gradient of g by the velocities of the orbit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <string.h>

#include "response/locus/locus.h"
#include "rom/terms/terms.h"

#define FUNCTION 7 /* degree that a function of a library is given; the defect beyond tells; chosen */

int hawser__locus_degree(const struct hawser_rom *rom)
{
	int most = rom->plug ? FUNCTION : 3;

	for (int i = 0; i < rom->terms; i++)
		most = rom->term[i].factors > most ? rom->term[i].factors : most;
	for (int p = 0; p < rom->harmonics; p++)
		for (int i = 0; i < rom->harmonic[p].terms; i++)
			most = rom->harmonic[p].term[i].factors > most ? rom->harmonic[p].term[i].factors : most;
	return most;
}

void hawser__locus_terms(struct hawser__locus *locus, double *tangent, double *slope, const double *u,
                         const double *du)
{
	size_t n = (size_t)locus->n, count = (size_t)locus->rows*n;
	const struct hawser__more to = {.force = locus->force, .by_u = tangent, .by_v = slope,
	                                .sign = -1.0, .stride = 1};

	if (!locus->more)
		return;
	memset(slope, 0, count*n*sizeof *slope);
	for (size_t i = 0; i < count; i++)
		locus->velocity[i] = locus->omega*du[i];
	hawser__rom_more_left(locus->rom, &to, u, locus->velocity, locus->rows, locus->omega);
}

/* The series of P_v, for the multipliers. */
void hawser__locus_resist(struct hawser__locus *locus)
{
	int n2 = locus->n*locus->n, columns = 2*locus->width + 1;

	if (!locus->more)
		return;
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, columns, n2, locus->rows, 2.0/locus->rows,
	            locus->basis, columns, locus->slope, n2, 0.0, locus->resist, n2);
	locus->monodromy.resist = locus->resist;
	locus->monodromy.resist_order = locus->width;
}

/* g_y -= basis' omega (D_x P_v)^T conj(w) factor, the part of velocities; *second += its product with
 * those of v. */
void hawser__locus_by_velocities(struct hawser__locus *locus, double complex factor, double h)
{
	int n = locus->n, columns = 2*locus->width + 1;

	for (int r = 0; locus->more && r < locus->rows; r++) {
		const double *at = locus->basis + (size_t)r*columns;

		for (int k = 0; k < n; k++) {
			double complex sum = 0.0;

			for (int j = 0; j < n; j++) {
				size_t row = (size_t)r*n + j;

				sum += (locus->plus_v[row*n + k] - locus->minus_v[row*n + k])/(2.0*h)*
				       conj(locus->wt[row]);
			}
			sum *= factor*locus->omega;
			locus->q_v[(size_t)r*n + k] += sum;
			for (int m = 1; m <= locus->order; m++) {
				locus->g_y[(2*m - 1)*n + k] += sum*(m*at[2*m]);
				locus->g_y[2*m*n + k] -= sum*(m*at[2*m - 1]);
			}
		}
	}
}

double complex hawser__locus_through_velocities(const struct hawser__locus *locus, const double *y)
{
	int n = locus->n, columns = 2*locus->width + 1;
	double complex sum = 0.0;

	for (int r = 0; locus->more && r < locus->rows; r++)
		for (int k = 1; k <= locus->order; k++) {
			const double *at = locus->basis + (size_t)r*columns + 2*k - 1;

			for (int j = 0; j < n; j++)
				sum += locus->q_v[(size_t)r*n + j]*
				       (k*(y[2*k*n + j]*at[0] - y[(2*k - 1)*n + j]*at[1]));
		}
	return sum;
}
