/* study/accuracy/primary_curve.c - the response curve of hawser/primary.h.
 *
 *    x      sigma - Gamma a^2. Along the curve a = F/sqrt(delta^2 + x^2) and sigma = x + Gamma a^2 are
 *           functions of x, through the peak (x = 0) and the folds
 *    delta  half the damping
 *    F      f/(2 omega)
 *
 * Points are equidistant in asinh(x/delta), which resolves the peak as well as its flanks. The
 * motion is unstable where sigma decreases as x grows, and where it excites a mode of half the
 * frequency.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/order.h"
#include "core/report.h"
#include "response/branch/amplitude.h"
#include "response/backbone/modulation.h"
#include "study/accuracy/primary.h"

enum { PHASES = 64 };

struct curve {
	const struct hawser_primary *primary;
	double delta, F;
};

static double amplitude(const struct curve *c, double x)
{
	return c->F/hypot(c->delta, x);
}

static double omega_at(const struct curve *c, double x)
{
	double a = amplitude(c, x);

	return c->primary->omega + x + c->primary->gamma*a*a;
}

/* Real and imaginary part of A: 2 omega (-x + i delta) A = load/2. */
static void state_at(const struct curve *c, double *A, double x)
{
	double complex load = c->primary->load[0] + I*c->primary->load[1];
	double complex value = 0.25*load/(c->primary->omega*(-x + I*c->delta));

	A[0] = creal(value);
	A[1] = cimag(value);
}

/* x [points + 3] of the points within the range, including folds and peak. */
static int places(double *x, const struct curve *c, double lo, double hi, int points)
{
	const struct hawser_primary *primary = c->primary;
	double lean = fabs(primary->gamma)*primary->peak*primary->peak;
	double low = asinh((lo - primary->omega - lean)/c->delta);
	double high = asinh((hi - primary->omega + lean)/c->delta);
	int count = points, first = 0;

	for (int i = 0; i < points; i++)
		x[i] = c->delta*sinh(low + (high - low)*i/(points - 1));
	x[count++] = 0.0;
	for (int k = 0; k < primary->folds; k++)
		x[count++] = primary->fold_omega[k] - primary->omega
		             - primary->gamma*primary->fold[k]*primary->fold[k];
	qsort(x, (size_t)count, sizeof *x, hawser__ascending);
	while (first < count && (omega_at(c, x[first]) < lo || omega_at(c, x[first]) > hi))
		first++;
	while (count > first && (omega_at(c, x[count - 1]) < lo || omega_at(c, x[count - 1]) > hi))
		count--;
	memmove(x, x + first, (size_t)(count - first)*sizeof *x);
	return count - first;
}

static enum hawser_status allocate(struct hawser_primary_curve *curve, const struct hawser_rom *rom,
                                   int points, struct hawser_report *report)
{
	struct hawser_frf *frf = &curve->frf;
	size_t rows = (size_t)points + 1, probes = (size_t)rom->shapes.points;

	frf->n = rom->n;
	frf->probes = rom->shapes.points;
	frf->method = "multiple scales, closed form";
	frf->capacity = points + 1;
	frf->event_capacity = 2;
	frf->point = calloc(rows, sizeof *frf->point);
	frf->coordinate = calloc(rows*(size_t)rom->n, sizeof(double));
	frf->probe = calloc(rows*3*probes + 1, sizeof(double));
	frf->event = calloc(2, sizeof *frf->event);
	curve->amplitude = calloc(rows, sizeof(double));
	curve->part = calloc(rows*9*probes + 1, sizeof(double));
	if (!frf->point || !frf->coordinate || !frf->probe || !frf->event || !curve->amplitude ||
	    !curve->part)
		return hawser__no_memory(report, "multiple scales");
	return HAWSER_OK;
}

/* part [3][3] of one probe. */
static void parts(double *part, const struct hawser_rom *rom, const double *samples, int probe,
                  double omega)
{
	double cosine[3][2] = {{0.0}}, sine[3][2] = {{0.0}};

	for (int i = 0; i < PHASES; i++) {
		double xyz[3], tau = 2.0*M_PI*i/PHASES;
		struct hawser_rom_moment moment = {.tau = tau, .omega = omega};

		hawser_rom_displacement_at(rom, xyz, probe, samples + (size_t)i*(size_t)rom->n,
		                           omega > 0.0 ? &moment : NULL);
		for (int c = 0; c < 3; c++) {
			part[3*c] += xyz[c]/PHASES;
			for (int h = 0; h < 2; h++) {
				cosine[c][h] += 2.0*xyz[c]*cos((h + 1)*tau)/PHASES;
				sine[c][h] += 2.0*xyz[c]*sin((h + 1)*tau)/PHASES;
			}
		}
	}
	for (int c = 0; c < 3; c++)
		for (int h = 0; h < 2; h++)
			part[3*c + 1 + h] = hypot(cosine[c][h], sine[c][h]);
}

/* Row i: largest values and parts of the motion of amplitude A at omega, 0 for a free motion.
 * `samples` [PHASES][n] is scratch. */
static enum hawser_status put(struct hawser_primary_curve *curve, int i,
                              const struct hawser_modulation *m,
                              const double A[2], double omega, struct hawser__amplitude *work,
                              double *samples, struct hawser_report *report)
{
	struct hawser_frf *frf = &curve->frf;
	size_t row = (size_t)i*(size_t)frf->probes, n = (size_t)frf->n;

	for (int k = 0; k < PHASES; k++)
		hawser_modulation_motion(m, samples + (size_t)k*n, A, 2.0*M_PI*k/PHASES);
	if (hawser__amplitude_find(work, frf->coordinate + (size_t)i*n, frf->probe + 3*row, samples,
	                           PHASES, omega))
		return hawser__no_memory(report, "multiple scales");
	for (int p = 0; p < frf->probes; p++)
		parts(curve->part + 9*(row + (size_t)p), m->rom, samples, p, omega);
	curve->amplitude[i] = 2.0*hypot(A[0], A[1]);
	frf->point[i].arc = i;
	frf->points++;
	return HAWSER_OK;
}

static enum hawser_status fill(struct hawser_primary_curve *curve, const struct curve *c,
                               const double *x, int points, struct hawser_report *report)
{
	const struct hawser_rom *rom = c->primary->modulation.rom;
	struct hawser__amplitude *work = hawser__amplitude_new(rom);
	double *samples = malloc((size_t)PHASES*(size_t)rom->n*sizeof *samples);
	enum hawser_status status = work && samples ? HAWSER_OK : hawser__no_memory(report,
	                                                                            "multiple scales");

	for (int i = 0; !status && i < points; i++) {
		double A[2], a = amplitude(c, x[i]), slope =
		        1.0 - 2.0*c->primary->gamma*x[i]*a*a*a*a/(c->F*c->F);

		state_at(c, A, x[i]);
		status = put(curve, i, &c->primary->modulation, A, omega_at(c, x[i]), work, samples, report);
		curve->frf.point[i].omega = omega_at(c, x[i]);
		curve->frf.point[i].unstable = slope < -1e-12; /* a fold itself counts as stable */
	}
	free(samples);
	hawser__amplitude_free(work);
	return status;
}

enum hawser_status hawser_primary_backbone(struct hawser_primary_curve *curve, double *gamma,
                                           const struct hawser_rom *rom, int mode, double size,
                                           int points, struct hawser_report *report)
{
	struct hawser_resonance resonance = {.count = 1, .mode = {mode}, .order = {1}};
	struct hawser_modulation m = {.rom = NULL};
	struct hawser__amplitude *work = hawser__amplitude_new(rom);
	struct hawser_rom bare = *rom;
	double *samples = malloc((size_t)PHASES*(size_t)rom->n*sizeof *samples);
	enum hawser_status status = work && samples ? HAWSER_OK : hawser__no_memory(report,
	                                                                            "multiple scales");

	memset(curve, 0, sizeof *curve);
	bare.harmonics = 0;
	if (!status && (mode < 0 || mode >= rom->n || points < 2 || !(size > 0.0)))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "multiple scales",
		                      "the backbone of mode %d up to %g in %d points: the model has modes 1 to "
		                      "%d, and give an amplitude and 2 points", mode + 1, size, points, rom->n);
	if (!status) {
		resonance.omega0 = sqrt(hawser__stiffness(rom, mode));
		status = hawser_modulation_derive(&m, &bare, &resonance, report);
	}
	if (!status)
		status = allocate(curve, rom, points, report);
	*gamma = status ? 0.0 : 0.375*hawser__primary_cubic(&m)/resonance.omega0;
	for (int i = 0; !status && i < points; i++) {
		const double A[2] = {0.5*size*i/(points - 1), 0.0};

		status = put(curve, i, &m, A, 0.0, work, samples, report);
		curve->frf.point[i].omega = resonance.omega0 + 4.0**gamma*A[0]*A[0];
	}
	hawser_modulation_clear(&m);
	free(samples);
	hawser__amplitude_free(work);
	if (status)
		hawser_primary_curve_clear(curve);
	return status;
}

/* Add the fold events: stability changes next to each of these points. */
static void mark(struct hawser_frf *frf)
{
	for (int i = 0; i + 1 < frf->points && frf->events < 2; i++) {
		int next = frf->point[i + 1].unstable;

		if (next == frf->point[i].unstable)
			continue;
		frf->event[frf->events++] = (struct hawser_frf_event){
			.kind = HAWSER_FOLD, .after = i, .arc = next ? i : i + 1,
			.omega = frf->point[next ? i : i + 1].omega,
		};
	}
}

enum hawser_status hawser_primary_trace(struct hawser_primary_curve *curve,
                                        const struct hawser_primary *primary, double from,
                                        double to,
                                        int points, struct hawser_report *report)
{
	const struct curve c = {primary, 0.5*primary->damping,
	                        0.5*hypot(primary->load[0], primary->load[1])/primary->omega};
	double lo = fmin(from, to), hi = fmax(from, to), *x;
	enum hawser_status status;
	int count;

	memset(curve, 0, sizeof *curve);
	if (points < 2 || !(lo > 0.0 && lo < hi && isfinite(hi)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "multiple scales",
		                    "%d points from %g to %g: give at least 2, and a range", points, from,
		                    to);
	x = malloc(((size_t)points + 3)*sizeof *x);
	if (!x)
		return hawser__no_memory(report, "multiple scales");
	count = places(x, &c, lo, hi, points);
	status = allocate(curve, primary->modulation.rom, count, report);
	if (!status)
		status = fill(curve, &c, x, count, report);
	free(x);
	if (status)
		hawser_primary_curve_clear(curve);
	else
		mark(&curve->frf);
	for (int i = 0; !status && i < count; i++)
		curve->frf.point[i].unstable += hawser__primary_excites(primary, curve->frf.point[i].omega,
		                                                        curve->amplitude[i]);
	return status;
}

void hawser_primary_curve_clear(struct hawser_primary_curve *curve)
{
	if (!curve)
		return;
	hawser_frf_clear(&curve->frf);
	free(curve->amplitude);
	free(curve->part);
	memset(curve, 0, sizeof *curve);
}
