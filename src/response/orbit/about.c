/* response/orbit/about.c - see about.h.
 *
 *   T     tangent of the restoring force along the orbit, a Fourier series (balance.h)
 *
 * The variation of a periodic response obeys v'' + (D + D_h) v' + T(Omega t) v = 0, the equation of a
 * model that has nothing but K, D and harmonics. Everything that is computed of parametric
 * excitation about rest (multipliers, determinants, ridges) therefore applies to responses. The orbit
 * is one of harmonic balance, whose T is exact for a polynomial energy.
 *
 * A response is no function of the parameters where several exist. The one that is meant grows out of
 * rest: Newton's method starts from the linear response and, unless it ends near it, the excitation is
 * raised from 0 in steps. Where that ends, the response has a fold, and jumps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/floquet/linear_margin.h"
#include "response/orbit/about.h"
#include "response/orbit/balance.h"
#include "response/time/flow.h"
#include "response/orbit/start.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

#define TOLERANCE 1e-8 /* of the orbit: well below the 1e-10 of multipliers; chosen */
#define FINE 1e-5      /* of the orbits on the way where rough ones lose it; chosen */
#define PASSED 0.2     /* size of a coordinate, relative to the orbit, below which rough orbits may
                        * pass its folds unnoticed; chosen */
#define SURE 0.01      /* tolerance, relative to a coordinate, with which it is followed; chosen */
#define NOTHING 1e-13   /* harmonics of T below this times Omega^2 change no exponent by more than the
                         * error of the orbit; chosen */
#define LITTLE 1e-8     /* the same for the sign of a determinant, which these harmonics change only
                         * where it is zero within that error; chosen */

void hawser__about_clear(struct hawser__about *about)
{
	free(about->K);
	free(about->harmonic);
	hawser_linear_free(about->linear);
	hawser__hill_matrix_release(&about->matrix);
	*about = (struct hawser__about){.room = 0};
}

static enum hawser_status refuse(const struct hawser_rom *rom, struct hawser_report *report)
{
	static const char what[] = "the stability of a response over two parameters";
	enum hawser_status status = hawser__drag_refuse(rom, what, report);

	if (!status)
		status = hawser__more_refuse(rom, what, report);
	return status ? status : hawser__periods_refuse(rom, what, report);
}

static double largest(const double *x, size_t count)
{
	double most = 0.0;

	for (size_t i = 0; i < count; i++)
		most = fmax(most, fabs(x[i]));
	return most;
}

/* The highest harmonic of T, up to `order`, that is above `least`. */
static int highest(const double *T, int order, int n, double least)
{
	size_t n2 = (size_t)n*(size_t)n;

	while (order > 0 && largest(T + (2*(size_t)order - 1)*n2, 2*n2) <= least)
		order--;
	return order;
}

static int make_room(struct hawser__about *about, size_t numbers, size_t harmonics)
{
	if (numbers > about->room) {
		free(about->K);
		about->K = malloc(numbers*sizeof *about->K);
		about->room = about->K ? numbers : 0;
	}
	if (harmonics > about->room_h) {
		free(about->harmonic);
		about->harmonic = malloc(harmonics*sizeof *about->harmonic);
		about->room_h = about->harmonic ? harmonics : 0;
	}
	return about->K && about->harmonic;
}

/* The model from T; the D of the harmonics remain. */
static enum hawser_status take(struct hawser__about *about, const struct hawser_rom *rom,
                               const struct hawser__balance *balance, double omega,
                               struct hawser_report *report)
{
	int order = highest(balance->T, balance->spread, rom->n, NOTHING*omega*omega), count = 0;
	size_t n2 = (size_t)rom->n*(size_t)rom->n, numbers = (2*(size_t)order + 1)*n2;

	if (!make_room(about, numbers, 2*(size_t)order + (size_t)rom->harmonics + 1))
		return hawser__no_memory(report, "about");
	memcpy(about->K, balance->T, numbers*sizeof *about->K);
	for (size_t e = 0; e < n2; e++)
		about->K[e] *= 0.5; /* T has the constant twice */
	for (int r = 1; r <= 2*order; r++)
		about->harmonic[count++] = (struct hawser_harmonic){.k = (r + 1)/2,
			.phase = r%2 ? HAWSER_COS : HAWSER_SIN, .K = about->K + (size_t)r*n2};
	for (int h = 0; h < rom->harmonics; h++)
		if (rom->harmonic[h].D)
			about->harmonic[count++] = (struct hawser_harmonic){.k = rom->harmonic[h].k,
				.phase = rom->harmonic[h].phase, .omega_power = rom->harmonic[h].omega_power,
				.D = rom->harmonic[h].D};
	about->rom = (struct hawser_rom){.n = rom->n, .length = rom->length, .time = rom->time,
		.force = rom->force, .scaled = rom->scaled, .D = rom->D, .K = about->K,
		.harmonics = count, .harmonic = about->harmonic};
	return HAWSER_OK;
}

/* The response y [size]; with raised->way also on the way there. Active from the beginning is what the
 * guide's orbits have. */
static enum hawser_status respond(double *y, struct hawser__orbit *orbit,
                                  struct hawser__correction *correction, double tolerance,
                                  struct hawser__raised *raised, double omega,
                                  struct hawser_report *report)
{
	const struct hawser__way *guide = raised->guide;
	enum hawser_status status = HAWSER_OK;

	raised->lone = 1;
	raised->x = calloc((size_t)orbit->m, sizeof *raised->x);
	if (!raised->x)
		return hawser__no_memory(report, "about");
	if (guide && guide->count > 0) {
		hawser__way_predict(y, guide, guide->count - 1, -1, NULL, orbit->size - 1);
		hawser__balance_adopt((struct hawser__balance *)orbit, y,
		                      guide->passed[guide->count - 1].length/(2*orbit->n), HAWSER__PART);
		status = hawser__balance_arrange((struct hawser__balance *)orbit, report);
	}
	if (!status)
		status = hawser__start(y, orbit, correction, NULL, omega, tolerance, raised, report);
	free(raised->x);
	return status;
}

static enum hawser_status open_orbit(struct hawser__orbit **orbit, double **y,
                                     const struct hawser_rom *rom, double omega,
                                     struct hawser_report *report)
{
	const struct hawser_frf_options options = {.from = omega, .to = omega};
	enum hawser_status status = refuse(rom, report);

	*y = NULL;
	*orbit = NULL;
	if (!status)
		status = hawser__balance_method.open(orbit, rom, &options, report);
	if (!status && !(*y = calloc((size_t)(*orbit)->size, sizeof **y)))
		status = hawser__no_memory(report, "about");
	return status;
}

static void close_orbit(struct hawser__orbit *orbit, double *y)
{
	free(y);
	if (orbit)
		orbit->ops->clear(orbit);
}

/* Whether a fold over the load lies before the orbit: it changes the sign of the determinant of
 * Hill's matrix at 0, which is positive at rest. So does a pitchfork. 0 also if it takes too many
 * harmonics. */
static enum hawser_status is_behind(int *behind, struct hawser__about *about, double omega,
                                    struct hawser_report *report)
{
	const double zero[2] = {0.0, 0.0};
	struct hawser__variational system = {.n = 0};
	double value[3] = {0.0};
	int exponent, harmonics = 0;
	enum hawser_status status = HAWSER_OK;

	*behind = 0;
	if (about->linear_n != about->rom.n) {
		hawser_linear_free(about->linear);
		status = hawser_linear_open(&about->linear, about->rom.n, report);
		about->linear_n = about->rom.n;
	}
	if (!status)
		status = hawser__linear_series(about->linear, &system, &about->rom, omega, report);
	if (!status)
		harmonics = hawser__hill_harmonics(&system, zero);
	if (harmonics > 0) {
		system.order = highest(system.K, system.order, system.n, LITTLE*omega*omega);
		harmonics = hawser__hill_harmonics(&system, zero);
	}
	if (harmonics > 0)
		status = hawser__hill_determinant(value, &exponent, &about->matrix, &system, zero, harmonics,
		                                  report);
	about->unsure = harmonics == 0;
	*behind = !status && harmonics > 0 && value[0] < -value[2];
	return status;
}

/* The model about the response. Where rough orbits on the way lose it, fine ones follow. Where
 * an orbit that was found from a guide or the linear response may lie behind a fold, the load is raised
 * from zero instead (raised->slow). */
static enum hawser_status find(struct hawser__about *about, struct hawser__raised *raised,
                               double tolerance, const struct hawser_rom *rom, double omega,
                               struct hawser_report *report)
{
	enum hawser_status status;
	int again;

	raised->rough = raised->slow || (raised->guide && raised->guide->rough == FINE)
	                ? FINE : HAWSER__ON_THE_WAY;
	do {
		struct hawser__correction correction = {.iterations = 0};
		struct hawser__orbit *orbit;
		double *y, small = 0.0;
		int behind = 0, lost;

		if (raised->way) {
			hawser__way_clear(raised->way);
			raised->way->rough = raised->rough;
			raised->way->n = rom->n;
		}
		status = open_orbit(&orbit, &y, rom, omega, report);
		if (!status)
			status = respond(y, orbit, &correction, tolerance, raised, omega, report);
		lost = status == HAWSER_ERR_CONVERGENCE && raised->load >= 0.0 && !raised->turned;
		if (!status) {
			hawser__balance_transform((struct hawser__balance *)orbit);
			status = take(about, rom, (const struct hawser__balance *)orbit, omega, report);
		}
		if (!status && !raised->way) /* small coordinates of guides are not determined */
			status = hawser__start_reversed(&small, y, orbit, omega, HAWSER__SEEN*tolerance,
			                                raised->slow ? HAWSER__SEEN*raised->rough : PASSED, report);
		about->unsure = about->counts && !raised->slow;
		if (!status && !raised->slow && !about->counts && small == 0.0)
			status = is_behind(&behind, about, omega, report);
		close_orbit(orbit, y);
		behind |= small > 0.0;
		again = behind || (lost && raised->rough > FINE);
		raised->rough = small > 0.0 ? fmin(FINE, SURE*small) : FINE;
		raised->slow |= behind;
		raised->guide = behind ? NULL : raised->guide;
	} while (again);
	return status;
}

enum hawser_status hawser__about_response(struct hawser__about *about, const struct hawser_rom *rom,
                                          double omega, struct hawser_report *report)
{
	struct hawser__raised raised = {.guide = about->slow ? NULL : about->guide, .slow = about->slow};
	enum hawser_status status = find(about, &raised,
	                                 about->tolerance > 0.0 ? about->tolerance : TOLERANCE, rom, omega,
	                                 report);

	if (status == HAWSER_ERR_CONVERGENCE && raised.load >= 0.0)
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "about",
		                      raised.turned
		                      ? "at Omega %.9g%s the response that grows out of rest has a fold at "
		                        "%.3g of the excitation, where it jumps: hawser frf follows it"
		                      : raised.slow
		                      ? "at Omega %.9g%s the response that grows out of rest was lost at "
		                        "%.3g of the excitation, and another motion at the whole excitation "
		                        "may lie behind a fold or a branch point of it: hawser frf --over "
		                        "factor.load, from 0.01, at this point tells"
		                      : "at Omega %.9g%s the response that grows out of rest was lost at "
		                        "%.3g of the excitation: it has a fold there, where it jumps, or "
		                        "changes too fast to be followed in all points of a plane; hawser "
		                        "frf --over factor.load, from 0.01, at this point tells which",
		                      HAWSER_SHOWN(rom, omega), raised.load);
	return status;
}

enum hawser_status hawser__about_way(struct hawser__way *way, const struct hawser__way *guide,
                                     const struct hawser_rom *rom, double omega,
                                     struct hawser_report *report)
{
	struct hawser__raised raised = {.way = way, .guide = guide};
	struct hawser__about about = {.counts = 1}; /* each response is checked itself */
	enum hawser_status status = find(&about, &raised, HAWSER__ON_THE_WAY, rom, omega, report);

	hawser__about_clear(&about);
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}
