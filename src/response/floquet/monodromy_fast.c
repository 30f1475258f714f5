/* response/floquet/monodromy_fast.c - which coordinates of variational equations are too fast to matter
 * (symbols as in monodromy_condense.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>

#include "response/floquet/monodromy.h"

#define FAR 2.0            /* least frequency of a fast coordinate relative to W; chosen */
#define THRESHOLD 0.1      /* least ratio of a harmonic of K to the damping for which it counts;
                            * chosen with a margin of ten */
#define SLIGHT 1e-9        /* a harmonic of K that changes the multipliers by less is omitted; below
                            * their tolerance */

/* Largest |K_k|/(2 sqrt(w_i w_j)) over all i, j that harmonic k can bring into resonance. */
static double strength(const struct hawser__monodromy *monodromy,
                       const struct hawser__variational *system, int k)
{
	int n = system->n;
	const double *c = system->K + (size_t)(2*k - 1)*n*n, *s = c + (size_t)n*n;
	double top = 0.0;

	for (int i = 0; i < n; i++)
		for (int j = 0; j < n; j++) {
			double a = c[i*n + j], b = s[i*n + j];

			if (monodromy->frequency[i] + monodromy->frequency[j] <=
			    (k + 1)*system->omega)
				top = fmax(top, (a*a + b*b)*monodromy->reach[i]*
				                monodromy->reach[j]);
		}
	return 0.5*sqrt(top);
}

/* The harmonics of K that are not negligible, and W. */
void hawser__fast_find_range(struct hawser__monodromy *monodromy, struct hawser__variational *system)
{
	int n = system->n, matter = 1, order = 0;
	double damping = INFINITY, period = 2.0*M_PI/system->omega;

	for (int j = 0; j < n; j++) {
		damping = fmin(damping, 0.5*fabs(system->D[(size_t)j*(n + 1)]));
		monodromy->reach[j] = 1.0/monodromy->frequency[j];
	}
	for (int k = system->order; k > 0; k--) {
		double part = strength(monodromy, system, k);

		if (order == 0 && part*period > SLIGHT)
			order = k;
		if (part > THRESHOLD*0.5*damping) {
			matter = k;
			break;
		}
	}
	system->order = order > matter ? order : matter < system->order ? matter : system->order;
	monodromy->fastest = (matter + 1)*system->omega;
}

/* Largest coefficient with which the velocity of a slow coordinate acts on coordinate j. The
 * response acts back on the slow coordinate as an inertia, (coefficient/w)^2 of its own, which is
 * neglected. */
static double velocity_coupling(const struct hawser__monodromy *monodromy,
                                const struct hawser__variational *system, int j, double top)
{
	int n = system->n;
	double most = 0.0;

	for (int i = 0; i < n; i++) {
		double sum = 0.0;

		for (int r = 0; r <= 2*system->order_d && monodromy->frequency[i] <= top; r++)
			sum += (r ? 1.0 : 0.5)*fabs(system->D[((size_t)r*n + j)*n + i]);
		most = fmax(most, i == j ? 0.0 : sum);
	}
	return most;
}

/* Expected error of the slow stiffness, relative, if coordinate j is condensed; infinite if it is too
 * slow for that. Harmonic k of its stiffness makes it respond to slow motions exp(s t) with
 * frequency s + i k Omega = z, as -G/(1 + (z d + z^2)/w^2) x_s: a series in (z d + z^2)/w^2, which an
 * iteration of the condensation extends by one term. G is the coupling by the reduced stiffness
 * where there is one, since all fast coordinates are condensed together. */
static double neglects(const struct hawser__monodromy *monodromy,
                       const struct hawser__variational *system, int j, double top,
                       int expected)
{
	int n = system->n;
	const double *K = system->K;
	double w = monodromy->frequency[j], W = monodromy->fastest, G = 0.0, d = 0.0, rest = 0.0;
	double coupled = velocity_coupling(monodromy, system, j, top)/w;

	for (int i = 0; i < n; i++)
		d += 0.5*fabs(system->D[(size_t)j*n + i]);
	/* a strongly damped coordinate decays at the slow rate w^2/d */
	if (w < FAR*W || w*w < FAR*W*d)
		return INFINITY;
	if (monodromy->rest && j < monodromy->reduced_n) {
		n = monodromy->reduced_n;
		K = monodromy->reduced;
	}
	for (int r = 0; r <= 2*system->order; r++) {
		const double *row = K + (size_t)r*n*n + (size_t)j*n;
		double most = 0.0, z = (top + (r + 1)/2*system->omega + d)/w;

		for (int i = 0; i < n; i++)
			if (monodromy->frequency[i] <= top)
				most = fmax(most, fabs(row[i]));
		G += most/(w*w);
		rest += most/(w*w)*pow(fmin(z*z, 1.0), 1 + expected);
	}
	return G*rest + coupled*coupled*pow(fmin((top + d)/w, 1.0), 2*expected);
}

int hawser__fast_gap(const struct hawser__monodromy *monodromy, int n, double least)
{
	int kept = n;
	double widest = 1.0;

	for (int j = n - 1; j > 0 && monodromy->frequency[j] >= least; j--)
		if (monodromy->frequency[j]/monodromy->frequency[j - 1] > widest) {
			widest = monodromy->frequency[j]/monodromy->frequency[j - 1];
			kept = j;
		}
	return kept;
}

double hawser__fast_split(struct hawser__monodromy *monodromy,
                          const struct hawser__variational *system, double limit,
                          int expected, int *kept)
{
	int n = system->n, fast = 0, before = -1;
	double top = monodromy->fastest;

	while (*kept = 0, fast != before) { /* each coordinate that is kept may keep others */
		before = fast;
		fast = 0;
		for (int j = 0; j < n; j++)
			if (neglects(monodromy, system, j, top, expected) < limit)
				monodromy->fast[fast++] = j;
			else
				monodromy->slow[(*kept)++] = j;
		for (int s = 0; s < *kept; s++)
			top = fmax(top, monodromy->frequency[monodromy->slow[s]]);
	}
	if (monodromy->rest && fast == 0) { /* each kept the next one, up to the last */
		*kept = hawser__fast_gap(monodromy, n, FAR*monodromy->fastest);
		for (int f = *kept; f < n; f++)
			monodromy->fast[f - *kept] = f;
		return monodromy->frequency[*kept - 1];
	}
	*kept = n - fast;
	return top;
}

int hawser__fast_symmetric(const double *series, int order, int n)
{
	for (int r = 0; r <= 2*order; r++)
		for (int i = 0; i < n; i++)
			for (int j = 0; j < i; j++) {
				const double *K = series + (size_t)r*n*n;

				if (fabs(K[i*n + j] - K[j*n + i]) >
				    1e-10*(fabs(K[i*n + i]) + fabs(K[j*n + j])))
					return r != 0 && fabs(K[i*n + j] - K[j*n + i]) <
					       1e-10*(fabs(series[i*n + i]) + fabs(series[j*n + j]));
			}
	return 1;
}

/* Whether all combinations of the nf fast coordinates satisfy the condition for each of them, that
 * is whether the mean stiffness is large enough compared with that of the slow ones. */
int hawser__fast_separate(struct hawser__monodromy *monodromy, const struct hawser__variational *system,
                    int nf)
{
	double *rest = monodromy->stiff, least = FAR*monodromy->fastest;

	for (int e = 0; e < nf; e++)
		for (int f = 0; f < nf; f++)
			rest[e*nf + f] = 0.5*system->K[(size_t)monodromy->fast[e]*system->n +
			                               monodromy->fast[f]] - (e == f ? least*least : 0.0);
	return LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', nf, rest, nf) == 0;
}

double hawser__monodromy_pace(struct hawser__monodromy *monodromy,
                              const struct hawser__variational *system)
{
	int n = system->n;
	double *mean = monodromy->stiff, *value = mean + (size_t)n*n, *work = value + n;

	for (int e = 0; e < n*n; e++)
		mean[e] = 0.25*(system->K[e] + system->K[e%n*n + e/n]);
	if (LAPACKE_dsyev_work(LAPACK_COL_MAJOR, 'N', 'U', n, mean, n, value, work, 3*n))
		return monodromy->fastest;
	return fmax(monodromy->fastest, sqrt(fmax(-value[0], 0.0)));
}
