/* beam/matrices.c - M, C and K of a travelling beam from the integrals.
 *
 * Multiply the equation (beam.h) by s_j and integrate by parts. The rotary terms give
 *
 *   -r^2 (d2/dx2)(2 v dy'/dt) -> 2 v r^2 s_j' s_k'',    -r^2 (d2/dx2)(v^2 y'') -> -r^2 v^2 s_j'' s_k''
 *
 * where the second uses y'' = 0 at simple ends. s_j' s_k'' is not skew-symmetric. Its symmetric
 * part is half of the difference of s_j' s_k' between the two ends, which is the flux of rotary
 * momentum through the supports. With HAWSER_MOMENT_BALANCED, the natural end condition of the
 * Lagrangian, the moment at the ends equals that flux, and the symmetric part vanishes. Clamped
 * ends have no flux.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stddef.h>

#include <hawser/beam.h>

void hawser_beam_matrices(double *M, double *C, double *K,
                          const struct hawser_beam_integrals *is, const struct hawser_beam *beam)
{
	const double v = beam->speed, r2 = beam->rotary, c = beam->drag;
	const double bend = beam->theta - r2*v*v, pull = beam->tension - beam->weight - v*v;
	int balanced = beam->moment == HAWSER_MOMENT_BALANCED || beam->ends == HAWSER_ENDS_CLAMPED;
	size_t n = (size_t)is->n;

	for (size_t j = 0; j < n; j++)
		for (size_t k = 0; k < n; k++) {
			size_t x = j*n + k, y = k*n + j;
			double rotary = balanced ? 0.5*(is->s1s2[x] - is->s1s2[y]) : is->s1s2[x];

			M[x] = is->ss[x] + r2*is->s1s1[x];
			C[x] = c*is->ss[x] + 2.0*v*(is->ss1[x] + r2*rotary);
			K[x] = bend*is->s2s2[x] + pull*is->s1s1[x] + beam->weight*is->xs1s1[x]
			       + c*v*is->ss1[x];
		}
}
