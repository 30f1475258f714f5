/* rom/choose/weigh.c - measure of how much a mode matters in a given motion.
 *
 *   u        coordinates of all modes over a period; a mode that is not kept has its static value,
 *            v_s = (f_s(tau) - sum over kept j <= k of Q_sjk u_j u_k)/omega_s^2
 *   R        restoring force at u of the model with all modes, with the stiffness that the load varies
 *   J        its tangent
 *   c_h      harmonics, u = Re sum c_h exp(i h tau)
 *   Delta_s  dynamic part of mode s. If s is not kept: one step of Newton's method with the diagonal
 *            of the harmonic balance,
 *            -(u'' + D u' + R - f)_h/(omega_s^2 - h^2 Omega^2 + i h Omega D). If s is kept: u_s - v_s
 *
 * Three effects of Delta_s are compared; the largest is the measure of the mode.
 *
 *   1. It moves the displacement in its plane by |Delta_s + f_s(tau)/omega_s^2|/|u|, with u the
 *      kept modes in that plane. If |u| is below FAINT times the largest motion weighed so far, that
 *      bound replaces it, and if both together are below the bound, effect 1 is ignored, unless the
 *      load drives the mode near its resonance: the displacements of a model contain the linear
 *      response of condensed modes (known.c), but a resonance depends on the motion. The static
 *      answer to the load is included although the displacements of a model contain it to the order
 *      (Omega/omega_s)^4: without it bench/accuracy finds errors beyond the estimate. Where they
 *      contain all of it (choice->answered), it is left out. Instead of
 *      planes, displacement components x at the shape points can be weighed: then effect 1 is the
 *      largest of max |dx/du_s (Delta_s + the answer to the load)|/max |x| over the period
 *      (displaced.c).
 *   2. The part of its force J_js Delta_s that is in phase with the kept modes moves their frequency,
 *      by half of its work on u over that of the inertia.
 *   3. The part in phase with their velocity changes the amplitude, by its power over that of the
 *      damping.
 *
 * A mode without any force on it can be made unstable by the motion: J varies over the period, and the
 * harmonic m of J_sp, of amplitude G, excites the pair s, p at omega_s + omega_p = m Omega if
 *
 *     (G/(4 sqrt(omega_s omega_p)))^2  >  ((omega_s + omega_p - m Omega)/2)^2 + D_s D_p/4
 *
 * (first-order averaging; s = p is Mathieu's equation). The measure of such a pair is the square root
 * of left over right side. The frequencies are those about the motion, from the mean of J.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "rom/choose/drive.h"
#include "rom/choose/weigh.h"

#define HARMONICS 8 /* highest harmonic; chosen */
#define ORDERS 4    /* highest order of parametric resonance; chosen */
#define FAINT 0.4   /* smallest displacement in a plane, relative to the largest, that counts;
                     * chosen */
#define AT_RISK 0.5 /* part of the amplitude at the stability limit from which a pair is listed */
#define NEAR 0.1    /* relative difference of two frequencies that may be in resonance; chosen */

struct work {
	struct hawser_choice *choice;
	int n, rows, harmonics;
	double omega, spacing;
	double *u, *v, *R;  /* [rows][n] */
	double *J;          /* [rows][n][n] */
	double *rate;       /* [rows][n] du/dtau of the kept */
	double *delta;      /* [rows] of one mode */
	double complex *c, *Delta; /* [HARMONICS + 1] of one mode */
	double complex *load;      /* [n][HARMONICS + 1] of every mode */
	double complex *turn; /* [rows] exp(i tau) */
	double size[2], inertia, damping; /* means over the period of the kept modes; size for each
	                                   * plane */
	unsigned counted;   /* displacements that are weighed (weigh.h) */
	double most[HAWSER__COUNTED]; /* largest amplitudes of those */
	struct hawser__hold hold;
};

static void work_clear(struct work *work)
{
	hawser__hold_clear(&work->hold);
}

static int work_make(struct work *work)
{
	size_t n = (size_t)work->n, rows = (size_t)work->rows;

	work->u = hawser__hold(&work->hold, rows*n, sizeof *work->u);
	work->v = hawser__hold(&work->hold, rows*n, sizeof *work->v);
	work->R = hawser__hold(&work->hold, rows*n, sizeof *work->R);
	work->J = hawser__hold(&work->hold, rows*n*n, sizeof *work->J);
	work->rate = hawser__hold(&work->hold, rows*n, sizeof *work->rate);
	work->delta = hawser__hold(&work->hold, rows, sizeof *work->delta);
	work->c = hawser__hold(&work->hold, HARMONICS + 1, sizeof *work->c);
	work->Delta = hawser__hold(&work->hold, HARMONICS + 1, sizeof *work->Delta);
	work->load = hawser__hold(&work->hold, n*(HARMONICS + 1), sizeof *work->load);
	work->turn = hawser__hold(&work->hold, rows, sizeof *work->turn);
	for (size_t i = 0; work->load && i < n*(HARMONICS + 1); i++)
		work->load[i] = hawser__drive(&work->choice->all, (int)(i/(HARMONICS + 1)),
		                              (int)(i%(HARMONICS + 1)), work->omega);
	for (size_t t = 0; work->turn && t < rows; t++)
		work->turn[t] = cexp(I*2.0*M_PI*(double)t/(double)rows);
	return !work->hold.short_of_memory;
}

/* exp(i h tau) at row t. */
static double complex turned(const struct work *work, int h, int t)
{
	return work->turn[(size_t)h*(size_t)t%(size_t)work->rows];
}

static double omega2(const struct work *work, int s)
{
	return work->choice->all.K[s*work->n + s];
}

static double damping(const struct work *work, int s)
{
	return work->choice->all.D[s*work->n + s];
}

static enum hawser_plane plane(const struct work *work, int s)
{
	return work->choice->modes->mode[s].plane;
}

/* Harmonics of field[rows][stride]: f = Re sum c_h exp(i h tau). */
static void analyse(double complex *c, const struct work *work, const double *field, int stride)
{
	for (int h = 0; h <= work->harmonics; h++) {
		double complex sum = 0.0;

		for (int t = 0; t < work->rows; t++)
			sum += field[(size_t)t*stride]*conj(turned(work, h, t));
		c[h] = (h ? 2.0 : 1.0)*sum/work->rows;
	}
}

static double at_row(const double complex *c, const struct work *work, int t)
{
	double sum = 0.0;

	for (int h = 0; h <= work->harmonics; h++)
		sum += creal(c[h]*turned(work, h, t));
	return sum;
}

/* Static displacement of mode s by the load. */
static double held(const struct work *work, int s, int t)
{
	return at_row(work->load + (size_t)s*(HARMONICS + 1), work, t)/omega2(work, s);
}

/* Static value of every mode, under the load and all kept modes except itself. */
static void follow(struct work *work)
{
	const struct hawser_rom *all = &work->choice->all;
	const struct hawser_choice_mode *mode = work->choice->mode;

	for (int t = 0; t < work->rows; t++)
		for (int s = 0; s < work->n; s++)
			work->v[(size_t)t*work->n + s] = held(work, s, t);
	for (int i = 0; i < all->quads; i++) {
		const struct hawser_quad *q = &all->Q[i];
		double factor = -q->value/omega2(work, q->j);

		if (!mode[q->k].kept || !mode[q->l].kept || q->k == q->j || q->l == q->j)
			continue;
		for (int t = 0; t < work->rows; t++) {
			const double *u = work->u + (size_t)t*work->n;

			work->v[(size_t)t*work->n + q->j] += factor*u[q->k]*u[q->l];
		}
	}
}

/* Velocities of the kept modes, and the means by which effects are divided. */
static void measure_motion(struct work *work)
{
	int n = work->n, rows = work->rows;

	for (int s = 0; s < n; s++) {
		if (!work->choice->mode[s].kept)
			continue;
		analyse(work->c, work, work->u + s, n);
		for (int h = 0; h <= work->harmonics; h++)
			work->Delta[h] = I*h*work->c[h];
		for (int t = 0; t < rows; t++) {
			double u = work->u[(size_t)t*n + s], rate = at_row(work->Delta, work, t);

			work->rate[(size_t)t*n + s] = rate;
			work->size[plane(work, s)] += u*u/rows;
			work->inertia += pow(work->omega*rate, 2)/rows;
			work->damping += damping(work, s)*work->omega*rate*rate/rows;
		}
	}
}

/* In the model with all modes: the load on condensed coordinates varies the stiffness; see also
 * hawser__vary. */
static void forces(struct work *work)
{
	int n = work->n;

	for (int t = 0; t < work->rows; t++) {
		size_t row = (size_t)t*n;

		for (int s = 0; s < n; s++)
			if (!work->choice->mode[s].kept)
				work->u[row + s] = work->v[row + s];
		hawser_rom_tangent(&work->choice->all, work->R + row, work->J + row*n, work->u + row);
		hawser__vary(&work->choice->all, work->R + row, work->J + row*n, work->u + row,
		             work->rate + row, 2.0*M_PI*t/work->rows, work->omega);
	}
}

/* Delta of mode s. */
static void own_answer(struct work *work, int s)
{
	double complex R[HARMONICS + 1], *Delta = work->Delta;
	const double complex *load = work->load + (size_t)s*(HARMONICS + 1);

	analyse(work->c, work, work->u + s, work->n);
	if (work->choice->mode[s].kept) {
		analyse(Delta, work, work->v + s, work->n);
		for (int h = 0; h <= work->harmonics; h++)
			Delta[h] = work->c[h] - Delta[h];
		return;
	}
	analyse(R, work, work->R + s, work->n);
	for (int h = 0; h <= work->harmonics; h++) {
		double W = h*work->omega;
		double complex own = -W*W + I*W*damping(work, s);

		Delta[h] = -(own*work->c[h] + R[h] - load[h])/
		           (omega2(work, s) + own);
	}
}

/* Whether the load drives mode s near its natural frequency. */
static int at_resonance(const struct work *work, int s)
{
	double w = sqrt(omega2(work, s));

	return fabs(w - work->omega) < NEAR*w &&
	       cabs(work->load[(size_t)s*(HARMONICS + 1) + 1]) > 0.0;
}

/* The largest of the three effects of Delta_s. */
static double effect(struct work *work, int s)
{
	double work_on = 0.0, power = 0.0, moved = 0.0, turned, least, size;
	const double *D = work->choice->all.D;
	double complex velocity[HARMONICS + 1];
	int n = work->n, rows = work->rows;

	for (int h = 0; h <= work->harmonics; h++)
		velocity[h] = I*h*work->omega*work->Delta[h];

	for (int t = 0; t < rows; t++) {
		size_t row = (size_t)t*n;
		double delta = at_row(work->Delta, work, t), speed = at_row(velocity, work, t);

		work->delta[t] = delta + (work->choice->answered ? 0.0 : held(work, s, t));
		moved += work->delta[t]*work->delta[t]/rows;
		for (int j = 0; j < n; j++) {
			double force = (work->J[(row + j)*n + s]*delta + D[j*n + s]*speed)/rows;

			if (j == s || !work->choice->mode[j].kept)
				continue;
			work_on += force*work->u[row + j];
			power += force*work->rate[row + j];
		}
	}
	/* a plane may be below FAINT only because this mode is missing there */
	least = FAINT*FAINT*work->choice->largest;
	size = work->size[plane(work, s)];
	if (size + moved < least && !at_resonance(work, s))
		moved = 0.0;
	size = fmax(size, least);
	turned = work->damping > 0.0 ? fabs(power)/work->damping : 0.0;
	if (work->counted != HAWSER__BY_PLANE)
		return fmax(hawser__displaced(&work->choice->all, s, work->u, work->delta, rows,
		                              work->counted, work->most),
		            fmax(0.5*fabs(work_on)/work->inertia, turned));
	return fmax(moved > 0.0 ? sqrt(moved/size) : 0.0, fmax(0.5*fabs(work_on)/work->inertia, turned));
}

static int loudest(const struct work *work)
{
	int best = 0;

	for (int h = 1; h <= work->harmonics; h++)
		if (cabs(work->Delta[h]) > cabs(work->Delta[best]))
			best = h;
	return best;
}

/* A kept mode such that omega_s is a multiple of its frequency, or its sum with that of another
 * one; or -1. */
static int resonant_with(const struct work *work, int s)
{
	double w = sqrt(omega2(work, s));

	for (int j = 0; j < work->n; j++) {
		double wj = sqrt(omega2(work, j)), part = w/wj;

		if (j == s || !work->choice->mode[j].kept)
			continue;
		if (part > 0.9 && part < 3.2 && fabs(part - round(part)) < NEAR*round(part))
			return j;
	}
	return -1;
}

static void tell(struct hawser_choice_mode *mode, double measure, double omega,
                 enum hawser_reason reason, int harmonic, int partner)
{
	if (!(measure > HAWSER__NEGLIGIBLE) || !(measure > mode->measure))
		return;
	mode->measure = measure;
	mode->omega = omega;
	mode->reason = reason;
	mode->harmonic = harmonic;
	mode->partner = partner;
}

static void weigh_mode(struct work *work, int s)
{
	struct hawser_choice_mode *mode = &work->choice->mode[s];
	double w = sqrt(omega2(work, s)), measure;
	double complex direct, f = work->load[(size_t)s*(HARMONICS + 1) + 1];
	enum hawser_reason reason = HAWSER_DYNAMIC;
	int h, partner = -1;

	own_answer(work, s);
	measure = effect(work, s);
	h = loudest(work);
	direct = f/(omega2(work, s) - work->omega*work->omega + I*work->omega*damping(work, s));
	if (h == 1 && cabs(direct) > 0.1*cabs(work->Delta[1]))
		reason = HAWSER_DIRECT;
	else if (h > 0 && fabs(w - h*work->omega) < NEAR*w)
		reason = HAWSER_INTERNAL;
	if (reason != HAWSER_DIRECT && (partner = resonant_with(work, s)) >= 0 && h > 0)
		reason = HAWSER_INTERNAL;
	tell(mode, measure, work->omega, reason, h, reason == HAWSER_INTERNAL ? partner : -1);
}

/* --- parametric resonance --- */

/* Amplitude of the harmonic m of J_sp, and its mean where m is 0. */
static double varies(const struct work *work, int s, int p, int m)
{
	double complex sum = 0.0;

	for (int t = 0; t < work->rows; t++)
		sum += work->J[((size_t)t*work->n + s)*work->n + p]*conj(turned(work, m, t));
	return m ? 2.0*cabs(sum)/work->rows : creal(sum)/work->rows;
}

static void weigh_pair(struct work *work, int s, int p)
{
	struct hawser_choice_mode *mode = work->choice->mode;
	double ws = sqrt(fmax(varies(work, s, s, 0), 0.25*omega2(work, s)));
	double wp = sqrt(fmax(varies(work, p, p, 0), 0.25*omega2(work, p)));
	int nearest = (int)lround((ws + wp)/work->omega);

	for (int m = nearest > 1 ? nearest - 1 : 1; m <= nearest + 1 && m <= ORDERS; m++) {
		double off = fmax(fabs(ws + wp - m*work->omega) - m*work->spacing, 0.0)/2.0;
		double limit = sqrt(off*off + damping(work, s)*damping(work, p)/4.0);
		double swing = hypot(varies(work, s, p, m), hawser__sway(&work->choice->all, s, p, m));
		double strength = swing/(4.0*sqrt(ws*wp));
		double ratio = limit > 0.0 ? strength/limit : strength > 0.0 ? HUGE_VAL : 0.0;

		if (ratio < AT_RISK)
			continue;
		if (!mode[s].kept)
			tell(&mode[s], ratio, work->omega, HAWSER_PARAMETRIC, m, p);
		if (!mode[p].kept)
			tell(&mode[p], ratio, work->omega, HAWSER_PARAMETRIC, m, s);
	}
}

static void weigh_pairs(struct work *work)
{
	for (int s = 0; s < work->n; s++)
		for (int p = 0; p <= s; p++)
			if (!work->choice->mode[s].kept || !work->choice->mode[p].kept)
				weigh_pair(work, s, p);
}

enum hawser_status hawser__weigh(struct hawser_choice *choice, const double *coordinate, int rows,
                                 double omega, double spacing, int whole, unsigned counted,
                                 unsigned peaks, const struct hawser__orbit_of *orbit,
                                 struct hawser_report *report)
{
	double size, omitted[HAWSER__OMITTED] = {0.0};
	struct work work = {.choice = choice, .n = choice->n, .rows = rows, .omega = omega,
		.spacing = spacing, .counted = counted,
		.harmonics = rows/2 - 1 < HARMONICS ? rows/2 - 1 : HARMONICS};
	enum hawser_status status = HAWSER_OK;

	if (!work_make(&work)) {
		status = hawser__no_memory(report, "choose");
		goto done;
	}
	memcpy(work.u, coordinate, (size_t)rows*(size_t)choice->n*sizeof *work.u);
	follow(&work);
	measure_motion(&work);
	size = work.size[0] + work.size[1];
	if (!(size > 0.0) || !isfinite(work.inertia)) {
		status = hawser__fail(report, HAWSER_ERR_NAN, "choose",
		                      "a motion at rest or not finite (mean square %g) tells nothing of "
		                      "the modes", size);
		goto done;
	}
	choice->largest = fmax(choice->largest, fmax(work.size[0], work.size[1]));
	forces(&work);
	if (counted != HAWSER__BY_PLANE)
		hawser__largest_displacements(work.most, &choice->all, work.u, rows);
	/* NOLINTNEXTLINE(clang-analyzer-unix.Malloc): work_clear() frees it */
	for (int s = 0; whole && s < choice->n; s++)
		weigh_mode(&work, s);
	weigh_pairs(&work);
	if (whole && choice->exact.n > 0) {
		status = hawser__order(omitted, choice, orbit, work.u, rows, omega, peaks, report);
		choice->truncation = fmax(choice->truncation, omitted[0]);
		choice->energy = fmax(choice->energy, omitted[1]);
		choice->followed = fmax(choice->followed, omitted[2]);
	}
done:
	work_clear(&work);
	return status;
}
