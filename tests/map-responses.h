/* tests/map-responses.h - all responses of u'' + d u' + u + q u^2 + c u^3 = f cos(Omega t) by harmonic
 * balance. Shares no code with the library.
 *
 * The amplitude A of the first cosine is given, and the first sine is 0 by the choice of the origin of
 * time. The other coefficients then follow, and so does the size of the force, which is a function of
 * A: each A at which it is f is a response.
 *
 *    a    coefficients: constant, then cosine and sine of each harmonic
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MAP_RESPONSES_H
#define HAWSER_TESTS_MAP_RESPONSES_H

#include <math.h>
#include <string.h>

enum { WAVES = 7, TERMS = 2*WAVES + 1, PHASES = 40 };

struct oscillator {
	double d, q, c, f;
};

static inline double wave(int term, int phase)
{
	static double cosine[PHASES];
	int k = (term + 1)/2;

	for (int p = 0; cosine[0] == 0.0 && p < PHASES; p++)
		cosine[PHASES - 1 - p] = cos(2.0*M_PI*(PHASES - 1 - p)/PHASES);
	return term % 2 ? cosine[k*phase%PHASES] : term ? cosine[(k*phase + 3*PHASES/4)%PHASES] : 1.0;
}

/* Residual r and its derivative J by projection on the waves. */
static inline void balance(double *r, double (*J)[TERMS], const double *a, const struct oscillator *of,
                           double omega)
{
	memset(r, 0, TERMS*sizeof *r);
	memset(J, 0, sizeof(double)*TERMS*TERMS);
	for (int p = 0; p < PHASES; p++) {
		double u = 0.0, force, slope, at[TERMS];

		for (int i = 0; i < TERMS; i++)
			u += a[i]*(at[i] = wave(i, p));
		force = (of->q + of->c*u)*u*u;
		slope = (2.0*of->q + 3.0*of->c*u)*u;
		for (int i = 0; i < TERMS; i++) {
			double weight = at[i]*(i ? 2.0 : 1.0)/PHASES;

			r[i] += weight*force;
			for (int j = 0; j < TERMS; j++)
				J[i][j] += weight*slope*at[j];
		}
	}
	for (int i = 0; i < TERMS; i++) {
		double w = omega*((i + 1)/2);
		int other = i == 0 ? 0 : i % 2 ? i + 1 : i - 1;
		double damp = i == 0 ? 0.0 : i % 2 ? of->d*w : -of->d*w;

		r[i] += (1.0 - w*w)*a[i] + damp*a[other];
		J[i][i] += 1.0 - w*w;
		J[i][other] += damp;
	}
}

static inline int eliminate(double (*J)[TERMS], double *r)
{
	for (int k = 0; k < TERMS; k++) {
		int best = k;

		for (int i = k + 1; i < TERMS; i++)
			best = fabs(J[i][k]) > fabs(J[best][k]) ? i : best;
		if (!(fabs(J[best][k]) > 1e-14))
			return 1;
		for (int j = 0; j < TERMS; j++) {
			double keep = J[k][j];

			J[k][j] = J[best][j];
			J[best][j] = keep;
		}
		double keep = r[k];
		r[k] = r[best];
		r[best] = keep;
		for (int i = k + 1; i < TERMS; i++) {
			double m = J[i][k]/J[k][k];

			for (int j = k; j < TERMS; j++)
				J[i][j] -= m*J[k][j];
			r[i] -= m*r[k];
		}
	}
	for (int k = TERMS - 1; k >= 0; k--) {
		for (int j = k + 1; j < TERMS; j++)
			r[k] -= J[k][j]*r[j];
		r[k] /= J[k][k];
	}
	return 0;
}

/* The force, squared, that makes the first cosine A; `a` starts from the coefficients near A. */
static inline double force_at(double A, double *a, const struct oscillator *of, double omega)
{
	double r[TERMS], J[TERMS][TERMS], change = 1.0;

	a[1] = A;
	a[2] = 0.0;
	for (int i = 0; i < 20 && change > 1e-20; i++) {
		balance(r, J, a, of, omega);
		for (int k = 1; k <= 2; k++) {
			memset(J[k], 0, sizeof J[k]);
			J[k][k] = 1.0;
			r[k] = 0.0;
		}
		if (eliminate(J, r))
			return NAN;
		change = 0.0;
		for (int k = 0; k < TERMS; k++) {
			a[k] -= r[k];
			change += r[k]*r[k];
		}
	}
	balance(r, J, a, of, omega);
	return r[1]*r[1] + r[2]*r[2];
}

static inline double peak(const double *a)
{
	double most = 0.0, at = 0.0, step = 2.0*M_PI/256;

	for (; step > 1e-6; step /= 8.0) {
		double from = step > 0.02 ? 0.0 : at - 16.0*step;

		for (int p = 0; p < (step > 0.02 ? 256 : 32); p++) {
			double u = a[0], t = from + p*step;

			for (int k = 1; k <= WAVES; k++)
				u += a[2*k - 1]*cos(k*t) + a[2*k]*sin(k*t);
			if (fabs(u) > most) {
				most = fabs(u);
				at = t;
			}
		}
	}
	return most;
}

/* Peaks of the responses, and their number. *apart: the least relative difference of two values of A;
 * 0 where it is not known. */
static inline int responses(double *least, double *most, double *apart, const struct oscillator *of,
                            double omega)
{
	double a[TERMS] = {0.0}, before = 0.0, last = 0.0, older = 0.0, found = 0.0;
	int count = 0;

	*least = *apart = INFINITY;
	*most = 0.0;
	for (double A = 0.005; A < 6.0; before = A,
	     A *= 1.0 + fmin(0.08, fmax(0.003, 0.03*fabs(last)/(of->f*of->f)))) {
		double force = force_at(A, a, of, omega) - of->f*of->f, b[TERMS];
		double lo = before, hi = A;

		if (A > 0.005 && (force > 0.0) != (last > 0.0)) {
			memcpy(b, a, sizeof b);
			for (int i = 0; i < 30; i++) {
				double at = 0.5*(lo + hi);
				int high = (force_at(at, b, of, omega) - of->f*of->f > 0.0) == (force > 0.0);

				lo = high ? lo : at;
				hi = high ? at : hi;
			}
			*least = fmin(*least, peak(b));
			*most = fmax(*most, peak(b));
			*apart = count ? fmin(*apart, lo/found - 1.0) : *apart;
			found = lo;
			count++;
		}
		/* two roots may lie between three values that have one sign */
		if (fabs(last) < 0.05*of->f*of->f && (last < older) == (last < force) && last*force > 0.0)
			*apart = 0.0;
		older = last;
		last = force;
	}
	return count;
}

#endif
