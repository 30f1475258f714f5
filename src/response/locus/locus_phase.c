/* response/locus/locus_phase.c - the damped backbone: motions whose load is in phase quadrature
 * with them.
 *
 *   f    load of harmonic k: f_c cos k tau + f_s sin k tau, as forces that do work on the coordinates
 *   a, b coefficients of cos k tau and sin k tau of the motion
 *   G    f_c a + f_s b, what of the motion is in phase with the load; g is G relative to both
 *   W    pi k (f_c b - f_s a), the work of the load in a period
 *
 * G = 0 says that the load does no reactive work: at every instant its velocity-like part feeds the
 * damping alone, and the motion along it lags by 90 degrees. Without damping and load the free motions
 * of a conservative model that are even in time have it too. G is linear in the motion, so that its
 * gradient is the load. By Omega and the parameter it is differentiated with the defects
 * (locus_second.c).
 *
 * Along a response G falls through 0 at a resonance, with the frequency rising, and rises through 0 at
 * an antiresonance.
 *
 * References: M. Peeters, G. Kerschen and J. C. Golinval, J. Sound Vib. 330 (2011) 486; S. Peter and
 * R. I. Leine, Mech. Syst. Signal Process. 96 (2017) 139; M. Scheel, S. Peter, R. I. Leine and
 * M. Krack, J. Sound Vib. 435 (2018) 346.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/locus/locus_walk.h"

#define LEAST 1e-3 /* of the harmonic relative to the motion, in the scale of g; chosen */

/* f of the harmonic k at the present model and Omega, [2][n]. */
static void load_of(double *load, const struct hawser__locus *locus, int k)
{
	const struct hawser_rom *rom = locus->rom;
	int n = locus->n;

	memset(load, 0, 2*(size_t)n*sizeof *load);
	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[p];
		double *to = load + (harmonic->phase == HAWSER_COS ? 0 : n);
		double s = pow(locus->omega, harmonic->omega_power);

		if (harmonic->k != k || !harmonic->f)
			continue;
		if (rom->mass)
			cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, s, rom->mass, n, harmonic->f, 1, 1.0, to, 1);
		else
			cblas_daxpy(n, s, harmonic->f, 1, to, 1);
	}
}

double hawser__locus_in_phase(struct hawser__locus *locus, const double *z)
{
	load_of(locus->load, locus, locus->harmonic);
	return cblas_ddot(2*locus->n, locus->load, 1,
	                  z + LOCUS_FIRST + (2*locus->harmonic - 1)*locus->n, 1);
}

enum hawser_status hawser__locus_quadrature(struct hawser__locus *locus, const double *z)
{
	int n = locus->n, first = (2*locus->harmonic - 1)*n;
	double value = hawser__locus_in_phase(locus, z);
	double size = cblas_dnrm2(2*n, z + LOCUS_FIRST + first, 1), per;
	enum hawser_status status;

	size = fmax(size, LEAST*locus->size_y);
	per = 1.0/(cblas_dnrm2(2*n, locus->load, 1)*size);
	memset(locus->g_y, 0, (size_t)locus->coefficients*sizeof *locus->g_y);
	for (int i = 0; i < 2*n; i++)
		locus->g_y[first + i] = per*locus->load[i];
	status = hawser__locus_differentiate(locus, z);
	locus->g = per*value;
	locus->g_p[0] *= per;
	locus->g_p[1] *= per;
	return status;
}

void hawser__locus_phase(struct hawser__locus *locus, struct hawser_locus_point *point,
                         const double *z)
{
	const double *y = z + LOCUS_FIRST;
	int n = locus->n, highest = 0;
	double inward = hawser__locus_in_phase(locus, z), length = cblas_dnrm2(2*n, locus->load, 1);
	double *load = locus->load, outward;

	outward = cblas_ddot(n, load, 1, y + 2*locus->harmonic*n, 1) -
	          cblas_ddot(n, load + n, 1, y + (2*locus->harmonic - 1)*n, 1);
	point->amplitude = hypot(inward, outward)/length;
	point->phase = atan2(outward, inward);
	for (int p = 0; p < locus->rom->harmonics; p++)
		highest = locus->rom->harmonic[p].k > highest ? locus->rom->harmonic[p].k : highest;
	point->work = 0.0;
	for (int k = 1; k <= highest; k++) {
		load_of(load, locus, k);
		point->work += M_PI*k*(cblas_ddot(n, load, 1, y + 2*k*n, 1) -
		                       cblas_ddot(n, load + n, 1, y + (2*k - 1)*n, 1));
	}
	point->energy = 0.0;
	for (int r = 0; r < locus->rows; r++) {
		cblas_dscal(n, locus->omega, locus->du + (size_t)r*n, 1);
		point->energy += hawser_rom_energy(locus->rom, locus->u + (size_t)r*n,
		                                   locus->du + (size_t)r*n)/locus->rows;
		cblas_dscal(n, 1.0/locus->omega, locus->du + (size_t)r*n, 1);
	}
	point->damping = point->work/(4.0*M_PI*point->energy);
}

enum hawser_status hawser__locus_choose_harmonic(struct hawser__locus *locus, int harmonic,
                                                 struct hawser_report *report)
{
	const struct hawser_rom *rom = locus->rom;
	int lowest = 0, found = 0;

	for (int p = 0; p < rom->harmonics; p++) {
		const struct hawser_harmonic *at = &rom->harmonic[p];
		int live = 0;

		for (int i = 0; at->f && i < rom->n; i++)
			live |= at->f[i] != 0.0;
		if (live && at->k > 0 && (lowest == 0 || at->k < lowest))
			lowest = at->k;
		found |= live && at->k == harmonic;
	}
	if (lowest == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                    rom->harmonics == 0
		                    ? "the model has no load: a resonance is where the motion lags the load "
		                      "by 90 degrees; give it one, or use hawser nnm for free motions"
		                    : "the load acts on no coordinate directly, it only varies the stiffness "
		                      "or the damping: a resonance is where the motion lags a force by 90 "
		                      "degrees; parametric resonances are the kind period-doubling");
	if (harmonic > 0 && !found)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "locus",
		                    "harmonic %d: the load has no force of that harmonic; the lowest that it "
		                    "has is %d", harmonic, lowest);
	locus->harmonic = harmonic > 0 ? harmonic : lowest;
	locus->load = calloc(2*(size_t)rom->n, sizeof *locus->load);
	return locus->load ? HAWSER_OK : hawser__no_memory(report, "locus");
}

static enum hawser_status add(struct hawser_frf *frf, const double value[2], int after,
                              struct hawser_report *report)
{
	const struct hawser_frf_point *a = &frf->point[after], *b = a + 1;
	size_t wide = 2*(size_t)frf->n, count = (size_t)frf->events + 1;
	double part = value[0]/(value[0] - value[1]);

	if (hawser__resize(&frf->event, count, sizeof *frf->event) ||
	    hawser__resize(&frf->event_state, count*wide, sizeof(double)))
		return hawser__no_memory(report, "locus");
	for (size_t i = 0; i < wide; i++)
		frf->event_state[(count - 1)*wide + i] = NAN;
	frf->event[count - 1] = (struct hawser_frf_event){.kind = HAWSER_RESONANCE, .after = after,
		.omega = a->omega + part*(b->omega - a->omega),
		.parameter = a->parameter + part*(b->parameter - a->parameter),
		.arc = a->arc + part*(b->arc - a->arc), .bracket = {a->omega, b->omega}};
	frf->events = (int)count;
	frf->event_capacity = (int)count;
	return HAWSER_OK;
}

enum hawser_status hawser__locus_find_resonances(struct hawser__locus_walk *walk,
                                                 struct hawser_frf *frf)
{
	struct hawser__locus *locus = walk->locus;
	double value[2] = {NAN, NAN}, sign = frf->points > 0 ? frf->point[0].direction : 1.0;
	enum hawser_status status = hawser__locus_first_order(locus);

	for (int i = 0; !status && i < frf->points; i++) {
		status = hawser__locus_orbit_through(walk, walk->here.z, frf->state + 2*(size_t)frf->n*i,
		                                     frf->point[i].parameter);
		if (status)
			break;
		value[0] = value[1];
		value[1] = sign*hawser__locus_in_phase(locus, walk->here.z);
		if (value[0] > 0.0 && value[1] <= 0.0)
			status = add(frf, value, i - 1, walk->report);
	}
	return status;
}
