/* response/locus/own_section.c - see own_section.h.
 *
 *    w        amplitude a exp(i theta) of the critical motion Re(w q)
 *    R(x)     where the section is met again; with x = Re(w q) + a^2 (h_0 + 2 Re h_2 exp(2 i theta)),
 *             (1 - M) h_0 = g_0 and (mu^2 - M) h_2 = g_2, of the parts g of R at Re(w q) that are even
 *             in w, its part along q has the third order only that the normal form has:
 *             <p, R> = (mu + c |w|^2) w/2 + ...
 *
 * The parts are sums over equal angles: two of a real multiplier, ANGLES of a pair. Two amplitudes take
 * off the next order.
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., section 5.4 (the projection
 * onto the critical eigenspace).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/locus/own_section.h"

#define AMPLITUDE 0.01  /* of the motion's size: errors 1e-8 by truncation, 1e-9 by round-off */
#define ALONG 1e-3      /* part of a direction that is its own beside the motion's; chosen */
enum { ANGLES = 8, MEETS = 5 };

/* --- the section --- */

static void velocity(double *f, const struct hawser__own_section *section, const double *x)
{
	int n = section->rom->n;

	memcpy(f, x + n, (size_t)n*sizeof *f);
	hawser_rom_acceleration(section->rom, f + n, x, x + n, 0.0, section->omega);
}

int hawser__own_apart(const double *rotation, const double *motion, int m)
{
	double length = cblas_dnrm2(m, rotation, 1), along = cblas_ddot(m, motion, 1, rotation, 1);

	along /= cblas_dnrm2(m, motion, 1);
	return along*along < (1.0 - ALONG)*length*length;
}

/* Q: the directions of the motion, and of the rotation unless that is the motion, then others at right
 * angles to them. */
static enum hawser_status set_directions(struct hawser__own_section *section, double *work,
                                         struct hawser_report *report)
{
	int n = section->rom->n, m = section->m, turns = 0;
	double *Q = section->Q, *turn = work, *tau = work + n*n;
	enum hawser_status status = hawser__cycle_turn(turn, &turns, section->rom, report);

	velocity(Q, section, section->x);
	section->gone = 1;
	for (int k = 0; turns && k < 2; k++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, turn, n, section->x + k*n, 1, 0.0,
		            Q + m + k*n, 1);
	section->gone += turns && m > 2 && hawser__own_apart(Q + m, Q, m);
	section->size = m - section->gone;
	LAPACKE_dgeqrf(LAPACK_COL_MAJOR, m, section->gone, Q, m, tau);
	for (int j = section->gone; j < m; j++)
		memset(Q + (size_t)j*m, 0, (size_t)m*sizeof *Q);
	LAPACKE_dorgqr(LAPACK_COL_MAJOR, m, m, section->gone, Q, m, tau);
	return status;
}

/* M and its eigenvalues and eigenvectors, from the derivative A (row-major) of the period map. */
static enum hawser_status set_multipliers(struct hawser__own_section *section, const double *A,
                                          double *work, struct hawser_report *report)
{
	int m = section->m, w = section->size, info;
	const double *across = section->Q + (size_t)section->gone*m;
	double *re = work + (size_t)m*m, *im = re + m;

	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, m, w, m, 1.0, A, m, across, m, 0.0, work, m);
	cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, w, w, m, 1.0, across, m, work, m, 0.0,
	            section->M, w);
	memcpy(work, section->M, (size_t)w*w*sizeof *work);
	info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'V', 'V', w, work, w, re, im, section->left, w,
	                     section->right, w);
	for (int i = 0; i < w; i++)
		section->mu[i] = re[i] + I*im[i];
	return hawser__lapack_starved(info) ? hawser__no_memory(report, "locus") : HAWSER_OK;
}

enum hawser_status hawser__own_section_open(struct hawser__own_section *section,
                                            const struct hawser_rom *rom, const double *x,
                                            double omega, int steps, struct hawser_report *report)
{
	size_t m = 2*(size_t)rom->n;
	double *A, *work, *end, *by_omega;
	enum hawser_status status;

	*section = (struct hawser__own_section){.rom = rom, .omega = omega, .m = (int)m,
		.period = {.h = 2.0*M_PI/steps, .steps = steps, .count = 1}};
	status = hawser__flow_init(&section->flow, rom, report);
	section->x = hawser__hold(&section->hold, m, sizeof(double));
	section->Q = hawser__hold(&section->hold, m*m, sizeof(double));
	section->M = hawser__hold(&section->hold, 3*m*m, sizeof(double));
	section->mu = hawser__hold(&section->hold, m, sizeof(double complex));
	A = hawser__hold(&section->hold, 2*m*m + 4*m, sizeof(double));
	if (!status && section->hold.short_of_memory)
		status = hawser__no_memory(report, "locus");
	if (status)
		return status;
	section->left = section->M + m*m;
	section->right = section->left + m*m;
	work = A + m*m;
	end = work + m*m + 2*m;
	by_omega = end + m;
	memcpy(section->x, x, m*sizeof *x);
	memcpy(end, x, m*sizeof *x);
	velocity(work, section, x);
	section->extent = hypot(cblas_dnrm2(rom->n, work, 1), cblas_dnrm2(rom->n, work + rom->n, 1)/omega)/
	                  omega;
	status = set_directions(section, work, report);
	hawser__flow_derive(&section->flow, end, A, by_omega, NULL, &section->period, omega);
	return status ? status : set_multipliers(section, A, work, report);
}

void hawser__own_section_close(struct hawser__own_section *section)
{
	hawser__flow_clear(&section->flow);
	hawser__hold_clear(&section->hold);
}

/* x [m] goes along the motion to the section. */
static void meet(struct hawser__own_section *section, double *x, double *f)
{
	for (int i = 0; i < MEETS; i++) {
		double away = 0.0;
		struct hawser__stretch rest = {.steps = 1, .count = 1};

		velocity(f, section, x);
		for (int j = 0; j < section->m; j++)
			away += section->Q[j]*(x[j] - section->x[j]);
		rest.h = -section->omega*away/cblas_ddot(section->m, section->Q, 1, f, 1);
		if (!(fabs(rest.h) > 0.0))
			return;
		hawser__flow_map(&section->flow, x, NULL, &rest, section->omega);
	}
}

/* R of `count` points [count][size] of the section; x [count + 1][m]. */
static void carry(struct hawser__own_section *section, double *point, int count, double *x)
{
	int m = section->m, w = section->size;
	const double *across = section->Q + (size_t)section->gone*m;

	section->period.count = count;
	for (int k = 0; k < count; k++) {
		memcpy(x + k*m, section->x, (size_t)m*sizeof *x);
		cblas_dgemv(CblasColMajor, CblasNoTrans, m, w, 1.0, across, m, point + k*w, 1, 1.0, x + k*m, 1);
	}
	hawser__flow_map(&section->flow, x, NULL, &section->period, section->omega);
	for (int k = 0; k < count; k++) {
		meet(section, x + k*m, x + (size_t)count*m);
		cblas_daxpy(m, -1.0, section->x, 1, x + k*m, 1);
		cblas_dgemv(CblasColMajor, CblasTrans, m, w, 1.0, across, m, x + k*m, 1, 0.0, point + k*w, 1);
	}
}

/* --- normal forms --- */

struct bend {
	struct hawser__own_section *section;
	int angles;               /* 2, ANGLES */
	double complex mu, *q, *p; /* [size], <p, q> = 1 */
	double complex *even[2];  /* [size] g_0, g_2, then h_0, h_2 */
	double complex *matrix;   /* [size][size] */
	double *point, *x;        /* [2 angles + 1][size], [2 angles + 2][m] */
	lapack_int *pivot;
};

static double amplitude(const struct bend *bend, int k)
{
	return AMPLITUDE*bend->section->extent*(1 + k/bend->angles);
}
static double complex phase(const struct bend *bend, int k, int harmonic)
{
	return cexp(2.0*M_PI*I*(harmonic*(k%bend->angles))/bend->angles);
}

/* R at all angles and both amplitudes, less R of the cycle itself; `curved`: on the curved surface. */
static void sample(struct bend *bend, int curved)
{
	int w = bend->section->size, count = 2*bend->angles;

	memset(bend->point, 0, ((size_t)count + 1)*w*sizeof *bend->point);
	for (int k = 0; k < count; k++)
		for (int j = 0; j < w; j++) {
			double a = amplitude(bend, k);
			double complex once = phase(bend, k, 1)*bend->q[j];
			double complex twice = bend->even[0][j] + 2.0*phase(bend, k, 2)*bend->even[1][j];

			bend->point[k*w + j] = a*creal(once) + curved*a*a*creal(twice);
		}
	carry(bend->section, bend->point, count + 1, bend->x);
	for (int k = 0; k < count; k++)
		cblas_daxpy(w, -1.0, bend->point + count*w, 1, bend->point + k*w, 1);
}

/* even[h/2]: the part of the samples with exp(i h theta), over a^2. */
static void take_even(struct bend *bend, int harmonic)
{
	int w = bend->section->size;
	double complex *to = bend->even[harmonic/2];

	memset(to, 0, (size_t)w*sizeof *to);
	for (int k = 0; k < 2*bend->angles; k++) {
		double share = k < bend->angles ? 4.0/3.0 : -1.0/3.0;
		double complex by = share/bend->angles/pow(amplitude(bend, k), 2)*
		                    conj(phase(bend, k, harmonic));

		for (int j = 0; j < w; j++)
			to[j] += by*bend->point[k*w + j];
	}
}

/* even = (factor - M)^-1 even; 1 where that is singular. */
static int settle_even(struct bend *bend, double complex factor, double complex *even)
{
	int w = bend->section->size;

	for (int e = 0; e < w*w; e++)
		bend->matrix[e] = -bend->section->M[e];
	for (int j = 0; j < w; j++)
		bend->matrix[j*(w + 1)] += factor;
	return LAPACKE_zgesv_work(LAPACK_COL_MAJOR, w, 1, bend->matrix, w, bend->pivot, even, w) != 0;
}

/* c over mu, from <p, R> at both amplitudes. */
static double odd_part(const struct bend *bend)
{
	int w = bend->section->size, pair = bend->angles > 2;
	double complex c = 0.0;

	for (int k = 0; k < 2*bend->angles; k++) {
		double share = k < bend->angles ? 4.0/3.0 : -1.0/3.0, a = amplitude(bend, k);
		double complex along = 0.0;

		for (int j = 0; j < w; j++)
			along += conj(bend->p[j])*bend->point[k*w + j];
		c += share/bend->angles*(along*conj(phase(bend, k, 1))/a - (pair ? 0.5 : 1.0)*bend->mu)/(a*a);
	}
	return creal(c*conj(bend->mu));
}

/* Eigenvector `which` as LAPACK has it. */
static void unpack(double complex *to, const double *from, const struct hawser__own_section *section,
                   int which)
{
	int w = section->size, conjugate = cimag(section->mu[which]) < 0.0;
	const double *re = from + (size_t)(which - conjugate)*w;

	for (int j = 0; j < w; j++)
		to[j] = cimag(section->mu[which]) == 0.0 ? re[j] : re[j] + (conjugate ? -I : I)*re[w + j];
}

static void open_bend(struct bend *bend, int which, struct hawser__hold *hold)
{
	struct hawser__own_section *section = bend->section;
	size_t w = (size_t)section->size, rows = 2*(size_t)bend->angles + 2;
	double complex along = 0.0;

	bend->q = hawser__hold(hold, (4 + w)*w, sizeof(double complex));
	bend->point = hawser__hold(hold, rows*(w + (size_t)section->m), sizeof(double));
	bend->pivot = hawser__hold(hold, w, sizeof *bend->pivot);
	if (hold->short_of_memory)
		return;
	bend->p = bend->q + w;
	bend->even[0] = bend->p + w;
	bend->even[1] = bend->even[0] + w;
	bend->matrix = bend->even[1] + w;
	bend->x = bend->point + rows*w;
	unpack(bend->q, section->right, section, which);
	unpack(bend->p, section->left, section, which);
	for (size_t j = 0; j < w; j++)
		along += conj(bend->p[j])*bend->q[j];
	for (size_t j = 0; j < w; j++)
		bend->p[j] /= conj(along);
}

enum hawser_status hawser__own_third(struct hawser__own_section *section, double *third, int which,
                                     struct hawser_report *report)
{
	double complex mu = section->mu[which];
	struct bend bend = {.section = section, .mu = mu, .angles = cimag(mu) != 0.0 ? ANGLES : 2};
	struct hawser__hold hold = {.last = NULL};

	*third = NAN;
	if (section->gone > 1)
		return HAWSER_OK;
	open_bend(&bend, which, &hold);
	if (hold.short_of_memory) {
		hawser__hold_clear(&hold);
		return hawser__no_memory(report, "locus");
	}
	sample(&bend, 0);
	take_even(&bend, 0);
	if (bend.angles > 2)
		take_even(&bend, 2);
	if (!settle_even(&bend, 1.0, bend.even[0]) && !settle_even(&bend, mu*mu, bend.even[1])) {
		sample(&bend, 1);
		*third = odd_part(&bend);
	}
	hawser__hold_clear(&hold);
	return HAWSER_OK;
}
