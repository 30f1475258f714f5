/* rom/condense/order.c - error of the fourth-order energy of a condensed model, and of all modes
 * beyond the candidates, measured against a full-order model along a motion.
 *
 *   u     coordinates of the kept modes at a phase tau of their motion
 *   v     the other candidates, statically condensed to second order: v_s = -p_s(u)/omega_s^2 with
 *         p_s = sum over kept j <= k of Q_sjk u_j u_k
 *   y     coordinates of the full-order model: the kept modes have their values u, all others (the
 *         relaxed ones) those that minimise the exact strain energy
 *   W     dy/du of the relaxed coordinates
 *   a     accelerations in the model of the response, at its own orbit; a_full: in the full-order
 *         model at y, with y' and y'' by differentiation over the period
 *   r     a_full - Omega^2 y'' of a relaxed coordinate: the force that moves it from y
 *   G     force on the kept modes that the model omits, a - a_full - W'r
 *
 * a - a_full contains the order of the energy, the inertia shapes of the model, and the modes of the
 * model that `exact` does not resolve and that are therefore relaxed here. W'r is the force on the kept
 * modes by the load, the inertia and the damping of the relaxed coordinates, to first order in r. Of
 * the effect of the load the model has the terms that are linear in the motion; W has all orders, and
 * in a deep sag the next order may be as large as the error of the energy. For omitted[0] only the load
 * on the candidates counts, since weigh.c measures the effect of their inertia; for omitted[2] all of
 * r, with the resonance of the coordinate: harmonic h times
 * omega_s^2/(omega_s^2 - h^2 Omega^2 + i h Omega D). omitted[1] is the effect of the energy alone:
 * restoring force at y minus that of the condensed model at u, which is
 * d/du [V(u, 0) - sum p_s^2/(2 omega_s^2)] with V the energy to fourth order. Where the
 * cable travels, the gyroscopic force of what r moves is added to W'r, which is a tenth of it.
 *
 * Why the others are relaxed: a motion that keeps the length of the cable to second order stretches it
 * in higher orders, and its energy grows with 1/epsilon. The exact energy at (u, v) would be that of a
 * shape that the cable never takes.
 *
 * The effect of G on the response is the shortest displacement, in relative Omega and relative motion,
 * from the orbit to the displaced response curve: the least-norm solution of
 *
 *     Omega^2 dx'' - Omega (da/dv) dx' - (da/dx) dx
 *         + (2 Omega^2 x'' - Omega (da/dv) x' - Omega da/dOmega) dOmega/Omega = -G
 *
 * by Galerkin's method, HAWSER__OMITTED_WAVES harmonics, with x the coordinates of the model of the
 * response, its inertia shapes included, and v = Omega x'. The equation must be that of the model: the
 * orbit then solves it exactly, and a neighbouring point of the curve is a solution without G. With
 * the tangent stiffness alone, without the inertia of the shapes, the resonance of the equation is
 * displaced, and the effect at a peak is too small by up to a half where the displacement is as large
 * as the width of the resonance. Along a response curve Omega is stationary at a fold and the amplitude
 * at its peak, so for these landmarks the solution is the whole error to first order, however sharp the
 * resonance. Displacements change by dx and by the difference of y and (u, v).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <string.h>

#include "core/report.h"
#include "rom/condense/order.h"
#include "rom/condense/known.h"

#define RESOLVED 0.6  /* fraction of the candidates that the full-order model must resolve; chosen */
#define ROWS_LEAST 24 /* least number of rows per period; chosen */

static void clear(struct hawser__omitted *w)
{
	hawser__relax_clear(&w->relax);
	hawser__hold_clear(&w->hold);
}

static double *array(struct hawser__omitted *w, size_t a, size_t b)
{
	return hawser__hold(&w->hold, a*b + 1, sizeof(double));
}

static int make(struct hawser__omitted *w)
{
	size_t n = (size_t)w->n, N = (size_t)w->N, rows = (size_t)w->rows;

	w->mode = hawser__hold(&w->hold, n, sizeof *w->mode);
	w->place = hawser__hold(&w->hold, n, sizeof *w->place);
	w->beyond = hawser__hold(&w->hold, N, 1);
	w->u = array(w, n, 1);
	w->plus = array(w, n, 1);
	w->minus = array(w, n, 1);
	w->J = array(w, n, n);
	w->J_minus = array(w, n, n);
	w->led = array(w, rows, N*n);
	w->motion = array(w, rows, N);
	w->force = array(w, rows, N);
	w->pull = array(w, rows, N);
	w->rate = array(w, rows, 1);
	w->G = array(w, rows, n);
	w->kept = array(w, rows, n);
	w->off = array(w, rows, (size_t)w->places);
	w->spin = array(w, rows, 2);
	w->wave = array(w, rows, 2*HAWSER__OMITTED_WAVES + 1);
	w->turn = array(w, rows, 2);
	return !hawser__relax_new(&w->relax, w->exact) && !w->hold.short_of_memory;
}

/* --- the same mode in both models --- */

static int find_twins(struct hawser_choice *choice)
{
	int found = 0;

	for (int j = 0; j < choice->n; j++) {
		choice->twin[j] = hawser__twin(&choice->all, j, &choice->exact);
		found += choice->twin[j] != 0;
	}
	return found;
}

enum hawser_status hawser__choice_resolve(struct hawser_choice *choice,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	static const int functions[] = {16, 24, 32};
	int enough = (int)(RESOLVED*choice->n);
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; !status && i < 3; i++) {
		hawser_rom_clear(&choice->exact);
		status = hawser_rom_build_full(&choice->exact, &choice->modes->statics, scene,
		                               functions[i], NULL);
		if (!status && find_twins(choice) >= enough)
			return HAWSER_OK;
	}
	if (!status)
		return HAWSER_OK;
	/* an inextensible cable has none: then no error is stated */
	choice->exact = (struct hawser_rom){.n = 0};
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "choose") : HAWSER_OK;
}

/* A mode that `exact` does not resolve is condensed. */
static int kept(const struct hawser__omitted *w, int j)
{
	return w->choice->mode[j].kept && w->choice->twin[j] != 0;
}

static int index_of(const struct hawser__omitted *w, int k)
{
	return abs(w->choice->twin[w->mode[k]]) - 1;
}

static double sign_of(const struct hawser__omitted *w, int k)
{
	return w->choice->twin[w->mode[k]] > 0 ? 1.0 : -1.0;
}

double hawser__omitted_twin(const struct hawser__omitted *w, int k, const double *x)
{
	return sign_of(w, k)*x[index_of(w, k)];
}

static void divide(struct hawser__omitted *w)
{
	int coordinate = 0; /* of the orbit's model */

	for (int j = 0; j < w->n; j++) {
		if (kept(w, j)) {
			w->place[w->held] = coordinate;
			w->mode[w->held++] = j;
		}
		coordinate += w->choice->mode[j].kept || w->orbit.model == w->all;
	}
	for (int i = 0; i < w->N; i++) {
		int held = 0, looked_at = 0;

		for (int j = 0; j < w->n; j++) {
			int same = abs(w->choice->twin[j]) == i + 1;

			held |= same && kept(w, j);
			looked_at |= same;
		}
		if (held)
			continue;
		w->beyond[w->relax.frees] = (char)!looked_at;
		w->relax.freed[w->relax.frees++] = i;
	}
}

/* --- relaxation of the other coordinates --- */

/* Minimise the energy with the kept modes at u. 0: no convergence. */
static int relax(struct hawser__omitted *w)
{
	for (int k = 0; k < w->held; k++)
		w->relax.y[index_of(w, k)] = sign_of(w, k)*w->u[w->mode[k]];
	hawser__relax_place(&w->relax);
	return hawser__relax(&w->relax, cblas_dnrm2(w->n, w->u, 1));
}

/* W at the minimum, from the last tangent and its factor. */
static void lead(struct hawser__omitted *w, double *led)
{
	const struct hawser__relax *relax = &w->relax;
	int m = relax->frees, held = w->held;

	for (int i = 0; i < m; i++)
		for (int k = 0; k < held; k++)
			led[i*held + k] = sign_of(w, k)*relax->T[relax->freed[i]*w->N + index_of(w, k)];
	/* the factor is by columns: by rows, it is the transposed one */
	cblas_dtrsm(CblasRowMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, m, held, 1.0,
	            relax->matrix, m, led, held);
	cblas_dtrsm(CblasRowMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, m, held, -1.0,
	            relax->matrix, m, led, held);
}

/* --- one phase --- */

/* plus: restoring force of the condensed model on the kept modes. u: the condensed modes too. */
void hawser__omitted_condensed(struct hawser__omitted *w)
{
	int n = w->n;

	for (int s = 0; s < n; s++)
		if (!kept(w, s))
			w->u[s] = 0.0;
	hawser_rom_tangent(w->all, w->plus, w->J, w->u);
	cblas_dscal(n, -1.0, w->u, 1);
	hawser_rom_tangent(w->all, w->minus, w->J_minus, w->u);
	cblas_dscal(n, -1.0, w->u, 1);
	for (int s = 0; s < n; s++) {
		double v = -0.5*(w->plus[s] + w->minus[s])/w->all->K[s*n + s];

		if (kept(w, s))
			continue;
		for (int j = 0; j < n; j++)
			w->plus[j] += 0.5*v*(w->J[s*n + j] - w->J_minus[s*n + j]);
		w->u[s] = v;
	}
}

/* Displacements at the shape points [places] of the modes in u. */
void hawser__omitted_displace(double *xyz, const struct hawser_rom *rom, const double *u)
{
	for (int p = 0; p < rom->shapes.points; p++)
		hawser_rom_displacement(rom, xyz + 3*p, p, u);
}

static int one_phase(struct hawser__omitted *w, int t)
{
	int held = w->held;
	double *off = w->off + (size_t)t*w->places, all[HAWSER__COUNTED];

	memset(w->u, 0, (size_t)w->n*sizeof *w->u);
	for (int k = 0; k < held; k++)
		w->u[w->mode[k]] = w->kept[(size_t)t*held + k];
	if (!relax(w))
		return 0;
	lead(w, w->led + (size_t)t*w->relax.frees*held);
	memcpy(w->motion + (size_t)t*w->N, w->relax.y, (size_t)w->N*sizeof *w->relax.y);
	hawser__omitted_condensed(w);
	for (int k = 0; k < held; k++)
		w->G[(size_t)t*held + k] = sign_of(w, k)*w->relax.R[index_of(w, k)] - w->plus[w->mode[k]];
	hawser__omitted_displace(off, w->exact, w->relax.y);
	hawser__omitted_displace(all, w->all, w->u);
	for (int i = 0; i < w->places; i++)
		/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): both models have the same places */
		off[i] -= all[i];
	return 1;
}

enum hawser_status hawser__order(double omitted[HAWSER__OMITTED], const struct hawser_choice *choice,
                                 const struct hawser__orbit_of *orbit, const double *u, int rows,
                                 double omega, unsigned peaks, struct hawser_report *report)
{
	struct hawser__omitted w = {.choice = choice, .exact = &choice->exact, .all = &choice->all,
		.n = choice->n, .N = choice->exact.n, .stride = 1, .omega = omega,
		.orbit = orbit ? *orbit : (struct hawser__orbit_of){&choice->all, u},
		.places = 3*choice->all.shapes.points};
	enum hawser_status status = HAWSER_OK;
	int found = 1;

	for (int k = 2; rows/k >= ROWS_LEAST; k++)
		w.stride = rows%k == 0 ? k : w.stride;
	w.rows = rows/w.stride;
	omitted[0] = omitted[1] = omitted[2] = 0.0;
	if (!make(&w)) {
		status = hawser__no_memory(report, "choose");
		goto done;
	}
	divide(&w);
	if (!w.held)
		goto done;
	for (int t = 0; found && t < w.rows; t++) {
		for (int k = 0; k < w.held; k++)
			w.kept[(size_t)t*w.held + k] = u[(size_t)t*w.stride*w.n + w.mode[k]];
		found = one_phase(&w, t);
	}
	omitted[0] = omitted[1] = omitted[2] = 1.0;
	if (found)
		status = hawser__omitted_effect(omitted, &w, peaks, report);
done:
	clear(&w);
	return status;
}
