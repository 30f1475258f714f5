/* response/branch/return_map.c - see return_map.h.
 *
 *    w        amplitude a exp(i theta) of the critical motion Re(w q)
 *    R(x)     where the section is met again; with x = Re(w q) + a^2 (h_0 + 2 Re h_2 exp(2 i theta)),
 *             (1 - M) h_0 = g_0 and (mu^2 - M) h_2 = g_2, of the parts g of R at Re(w q) that are even
 *             in w, its part along q has the third order only that the normal form has:
 *             <p, R> = (mu + d |w|^2) w/2 + ...
 *
 * The parts are sums over equal angles: two of a real multiplier, ANGLES of a pair. Three amplitudes
 * take off the next two orders. The flow has fixed steps, so that the map is smooth and its differences
 * have round-off only. (Exact variational equations of third order would hold for polynomials only, and
 * not for drag, stops and models of full order.)
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., section 5.4 (the projection
 * onto the critical eigenspace).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/branch/return_map.h"
#include "response/orbit/shooting.h"
#include "rom/terms/terms.h"

#define ASIDE 0.1      /* distance from the motion, relative to its size, of the state at which
                        * the steps are chosen; chosen */
#define STEP_ERROR 1e-12 /* of the integration over the period, relative; chosen, near round-off */
#define MOST_STEPS 4000 /* of a period, so that the result takes seconds; chosen */
#define ALONG 1e-3      /* least squared sine of the angle between rotation and motion at which
                         * they count as two directions; chosen */
enum { ANGLES = 6, MEETS = 5, SIZES = 3 };
static const double share[SIZES] = {1.5, -0.6, 0.1}; /* weights of amplitudes a, 2 a, 3 a: no errors
                                                      * of the order of a^2 and a^4 */

/* --- the section --- */

/* Multiply the velocities of x by the factor: between v and v/Omega. */
static void stretch(const struct hawser__return *section, double *x, double factor)
{
	cblas_dscal(section->rom->n, factor, x + section->rom->n, 1);
}

/* The change of the state with time; `work` [m]. */
static void velocity(double *f, const struct hawser__return *section, const double *x, double *work)
{
	int n = section->rom->n;

	memcpy(work, x, (size_t)section->m*sizeof *work);
	stretch(section, work, section->omega);
	memcpy(f, work + n, (size_t)n*sizeof *f);
	hawser_rom_acceleration(section->rom, f + n, work, work + n, 0.0, section->omega);
	stretch(section, f, 1.0/section->omega);
}

int hawser__apart(const double *rotation, const double *motion, int m)
{
	double length = cblas_dnrm2(m, rotation, 1), along = cblas_ddot(m, motion, 1, rotation, 1);

	along /= cblas_dnrm2(m, motion, 1);
	return along*along < (1.0 - ALONG)*length*length;
}

/* Q: the directions of the motion, and of the rotation unless that is the motion, then others at right
 * angles to them. */
static enum hawser_status set_directions(struct hawser__return *section, double *work,
                                         struct hawser_report *report)
{
	int n = section->rom->n, m = section->m, turns = 0;
	double *Q = section->Q, *turn = work, *tau = work + m*m;
	enum hawser_status status = HAWSER_OK;

	section->size = m;
	if (!hawser_rom_autonomous(section->rom)) {
		for (int j = 0; j < m; j++)
			Q[j*(m + 1)] = 1.0;
		return HAWSER_OK;
	}
	status = hawser__cycle_turn(turn, &turns, section->rom, report);
	velocity(Q, section, section->x, tau);
	for (int k = 0; turns && k < 2; k++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, turn, n, section->x + k*n, 1, 0.0,
		            Q + m + k*n, 1);
	section->gone = 1 + (turns && m > 2 && hawser__apart(Q + m, Q, m));
	section->size = m - section->gone;
	LAPACKE_dgeqrf(LAPACK_COL_MAJOR, m, section->gone, Q, m, tau);
	for (int j = section->gone; j < m; j++)
		memset(Q + (size_t)j*m, 0, (size_t)m*sizeof *Q);
	LAPACKE_dorgqr(LAPACK_COL_MAJOR, m, m, section->gone, Q, m, tau);
	return status;
}

/* The number of steps in a period for STEP_ERROR, at a state beside the motion x [m]: at rest itself
 * any number has an error of 0. 0: more than MOST_STEPS. */
static int choose_steps(struct hawser__return *section, int period, const double *x, double *end)
{
	int at = hawser__shooting_steps(section->rom, section->omega, 1);

	for (; at*period <= MOST_STEPS; at *= 2) {
		struct hawser__stretch whole = {.h = 2.0*M_PI/at, .steps = at*period, .count = 1};

		for (int i = 0; i < section->m; i++)
			end[i] = x[i] + ASIDE*section->extent*(i < section->rom->n ? 1.0 : section->omega);
		if (hawser__flow_map(&section->flow, end, NULL, &whole, section->omega) <=
		    STEP_ERROR*section->extent)
			return at;
	}
	return 0;
}

/* M and its eigenvalues and eigenvectors, from the derivative A (row-major) of the period map. */
static enum hawser_status set_multipliers(struct hawser__return *section, const double *A,
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
	return hawser__lapack_starved(info) ? hawser__no_memory(report, "orbit") : HAWSER_OK;
}

enum hawser_status hawser__return_open(struct hawser__return *section, const struct hawser_rom *rom,
                                       const double *x, double omega, int period, int steps,
                                       struct hawser_report *report)
{
	size_t n = (size_t)rom->n, m = 2*n;
	double *A, *work, *end, *by_omega;
	enum hawser_status status;

	*section = (struct hawser__return){.rom = rom, .m = (int)m,
		.omega = omega/hawser__rom_periods(rom)};
	status = hawser__flow_init(&section->flow, rom, report);
	section->x = hawser__hold(&section->hold, m, sizeof(double));
	section->Q = hawser__hold(&section->hold, m*m, sizeof(double));
	section->M = hawser__hold(&section->hold, 3*m*m, sizeof(double));
	section->mu = hawser__hold(&section->hold, m, sizeof(double complex));
	A = hawser__hold(&section->hold, 2*m*m + 4*m, sizeof(double));
	if (!status && section->hold.short_of_memory)
		status = hawser__no_memory(report, "orbit");
	if (status)
		return status;
	section->left = section->M + m*m;
	section->right = section->left + m*m;
	work = A + m*m;
	end = work + m*m + 2*m;
	by_omega = end + m;
	memcpy(section->x, x, m*sizeof *x);
	stretch(section, section->x, 1.0/section->omega);
	section->extent = cblas_dnrm2((int)m, section->x, 1);
	section->extent = section->extent > 0.0 ? section->extent : 1.0;
	steps = steps ? steps : choose_steps(section, period, x, end);
	if (!steps)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "orbit",
		                    "no normal form: a period takes more than %d steps", MOST_STEPS);
	section->period = (struct hawser__stretch){.h = 2.0*M_PI/steps, .steps = steps*period, .count = 1};
	memcpy(end, x, m*sizeof *x);
	status = set_directions(section, work, report);
	hawser__flow_derive(&section->flow, end, A, by_omega, NULL, &section->period, section->omega);
	for (size_t i = 0; i < m*m; i++)
		A[i] *= (i%m < n ? 1.0 : section->omega)/(i/m < n ? 1.0 : section->omega);
	return status ? status : set_multipliers(section, A, work, report);
}

void hawser__return_close(struct hawser__return *section)
{
	hawser__flow_clear(&section->flow);
	hawser__hold_clear(&section->hold);
}

/* x [m] goes along the motion to the section; `work` [2m]. */
static void meet(struct hawser__return *section, double *x, double *work)
{
	for (int i = 0; i < MEETS; i++) {
		double away = 0.0, *f = work + section->m;
		struct hawser__stretch rest = {.steps = 1, .count = 1};

		velocity(f, section, x, work);
		for (int j = 0; j < section->m; j++)
			away += section->Q[j]*(x[j] - section->x[j]);
		rest.h = -section->omega*away/cblas_ddot(section->m, section->Q, 1, f, 1);
		if (!(fabs(rest.h) > 0.0))
			return;
		stretch(section, x, section->omega);
		hawser__flow_map(&section->flow, x, NULL, &rest, section->omega);
		stretch(section, x, 1.0/section->omega);
	}
}

/* R of `count` points [count][size] of the section; x [count + 2][m]. */
static void carry(struct hawser__return *section, double *point, int count, double *x)
{
	int m = section->m, w = section->size;
	const double *across = section->Q + (size_t)section->gone*m;

	section->period.count = count;
	for (int k = 0; k < count; k++) {
		memcpy(x + k*m, section->x, (size_t)m*sizeof *x);
		cblas_dgemv(CblasColMajor, CblasNoTrans, m, w, 1.0, across, m, point + k*w, 1, 1.0, x + k*m, 1);
		stretch(section, x + k*m, section->omega);
	}
	hawser__flow_map(&section->flow, x, NULL, &section->period, section->omega);
	for (int k = 0; k < count; k++) {
		stretch(section, x + k*m, 1.0/section->omega);
		if (section->gone > 0)
			meet(section, x + k*m, x + (size_t)count*m);
		cblas_daxpy(m, -1.0, section->x, 1, x + k*m, 1);
		cblas_dgemv(CblasColMajor, CblasTrans, m, w, 1.0, across, m, x + k*m, 1, 0.0, point + k*w, 1);
	}
}

/* --- normal forms --- */

struct bend {
	struct hawser__return *section;
	int angles;               /* 2, ANGLES */
	double a;
	double complex mu, *q, *p; /* [size], <p, q> = 1 */
	double complex *even[2];  /* [size] g_0, g_2, then h_0, h_2 */
	double complex *matrix;   /* [size][size] */
	double *point, *x;        /* [SIZES angles + 1][size], [SIZES angles + 3][m] */
	lapack_int *pivot;
};

static double amplitude(const struct bend *bend, int k)
{
	return bend->a*(1 + k/bend->angles);
}
static double complex phase(const struct bend *bend, int k, int harmonic)
{
	return cexp(2.0*M_PI*I*(harmonic*(k%bend->angles))/bend->angles);
}

/* R at all angles and amplitudes, less R of the motion itself; `curved`: with h_0 and h_2. */
static void sample(struct bend *bend, int curved)
{
	int w = bend->section->size, count = SIZES*bend->angles;

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
	for (int k = 0; k < SIZES*bend->angles; k++) {
		double complex by = share[k/bend->angles]/bend->angles/pow(amplitude(bend, k), 2)*
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

static double complex project(const struct bend *bend, const double complex *x)
{
	double complex sum = 0.0;

	for (int j = 0; j < bend->section->size; j++)
		sum += conj(bend->p[j])*x[j];
	return sum;
}

/* d/2 of a pair or d, from <p, R> at all amplitudes. */
static double complex odd_part(const struct bend *bend)
{
	int w = bend->section->size, pair = bend->angles > 2;
	double complex sum = 0.0;

	for (int k = 0; k < SIZES*bend->angles; k++) {
		double a = amplitude(bend, k);
		double complex along = 0.0;

		for (int j = 0; j < w; j++)
			along += conj(bend->p[j])*bend->point[k*w + j];
		along *= conj(phase(bend, k, 1))/a;
		sum += share[k/bend->angles]/bend->angles*(along - (pair ? 0.5 : 1.0)*bend->mu)/(a*a);
	}
	return sum;
}

/* Eigenvector `which` as LAPACK has it. */
static void unpack(double complex *to, const double *from, const struct hawser__return *section,
                   int which)
{
	int w = section->size, conjugate = cimag(section->mu[which]) < 0.0;
	const double *re = from + (size_t)(which - conjugate)*w;

	for (int j = 0; j < w; j++)
		to[j] = cimag(section->mu[which]) == 0.0 ? re[j] : re[j] + (conjugate ? -I : I)*re[w + j];
}

static void open_bend(struct bend *bend, int which, struct hawser__hold *hold)
{
	struct hawser__return *section = bend->section;
	size_t w = (size_t)section->size, rows = SIZES*(size_t)bend->angles + 3;
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
	along = project(bend, bend->q);
	for (size_t j = 0; j < w; j++)
		bend->p[j] /= conj(along);
}

enum hawser_status hawser__return_form(struct hawser__return *section, double *c, int which,
                                       enum hawser_event_kind kind, double a,
                                       struct hawser_report *report)
{
	struct bend bend = {.section = section, .mu = section->mu[which], .a = a,
		.angles = kind == HAWSER_TORUS ? ANGLES : 2};
	struct hawser__hold hold = {.last = NULL};

	*c = NAN;
	if (section->gone > 1) /* R would have to turn back, too */
		return HAWSER_OK;
	open_bend(&bend, which, &hold);
	if (hold.short_of_memory) {
		hawser__hold_clear(&hold);
		return hawser__no_memory(report, "orbit");
	}
	sample(&bend, 0);
	take_even(&bend, 0);
	if (kind == HAWSER_TORUS)
		take_even(&bend, 2);
	if (kind == HAWSER_FOLD)
		*c = fabs(creal(project(&bend, bend.even[0])));
	else if (!settle_even(&bend, 1.0, bend.even[0]) &&
	         !settle_even(&bend, bend.mu*bend.mu, bend.even[1])) {
		sample(&bend, 1);
		*c = kind == HAWSER_TORUS ? 8.0*creal(conj(bend.mu)*odd_part(&bend)) : creal(odd_part(&bend));
	}
	hawser__hold_clear(&hold);
	return HAWSER_OK;
}
