/* study/accuracy/motions.c - see motions.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "hawser/integrate.h"
#include "study/accuracy/motions.h"

enum { rows = 48,      /* samples per period: resolves more than the harmonics that choose.h
                        * examines; chosen */
       OF_PERIOD = 1000, OF_OSCILLATION = 20 }; /* steps of a period, and of an oscillation; chosen */

int hawser__nearest_point(const struct hawser_frf *frf, double arc)
{
	int best = 0;

	for (int i = 1; i < frf->points; i++)
		if (fabs(frf->point[i].arc - arc) < fabs(frf->point[best].arc - arc))
			best = i;
	return best;
}

long hawser__steps_of_period(const struct hawser_rom *rom, double omega)
{
	double most = 0.0;

	for (int j = 0; j < rom->n; j++)
		most = fmax(most, rom->K[j*(rom->n + 1)]);
	return OF_PERIOD + OF_OSCILLATION*(long)ceil(sqrt(most)/omega);
}

/* u of the modes that the model keeps, at its state. */
static void coordinates_of_modes(double *u, const struct hawser_rom *rom, const double *state)
{
	int n = rom->n, kept = n - rom->inertia.shapes;

	if (rom->carried)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, n, n, 1.0, rom->carried, n, state, 1, 0.0, u, 1);
	else
		memcpy(u, state, (size_t)kept*sizeof *u);
}

enum hawser_status hawser__weigh_motion(struct hawser_choice *choice, const struct hawser_rom *rom,
                                        const struct hawser_accuracy_motion *start, int whole,
                                        unsigned counted, unsigned peaks,
                                        struct hawser_report *report)
{
	double omega = start->omega, period = 2.0*M_PI/omega, *u, *state;
	struct hawser_integrate_options options = {
		.omega = omega, .begin = start->time, .until = start->time + period,
		.every = period/rows, .rtol = 1e-7, .atol = 1e-12, .initial = start->state,
		.max_steps = hawser__steps_of_period(rom, omega),
	};
	size_t n = (size_t)rom->n, kept = (size_t)(rom->n - rom->inertia.shapes);
	struct hawser__orbit_of orbit = {.model = rom};
	struct hawser_trajectory run;
	enum hawser_status status = hawser_integrate(&run, rom, &options, report);

	if (hawser__escapes(status)) {
		choice->followed = 1.0; /* the model does not hold the motion */
		hawser_trajectory_clear(&run);
		return HAWSER_OK;
	}
	u = malloc((size_t)rows*kept*sizeof *u);
	state = malloc((size_t)rows*n*sizeof *state);
	if (!status && (!u || !state))
		status = hawser__no_memory(report, "study");
	for (size_t t = 0; !status && t < rows; t++) {
		coordinates_of_modes(u + t*kept, rom, run.state + t*2*n);
		memcpy(state + t*n, run.state + t*2*n, n*sizeof *state);
	}
	orbit.state = state;
	if (!status)
		status = hawser__choice_weigh(choice, u, rows, omega, whole, counted, peaks, &orbit,
		                              report);
	free(state);
	free(u);
	hawser_trajectory_clear(&run);
	return status;
}

enum hawser_status hawser__weigh_orbit(struct hawser_choice *choice, const struct hawser_rom *rom,
                                       const struct hawser_frf *frf, int i, int whole,
                                       unsigned counted, unsigned peaks,
                                       struct hawser_report *report)
{
	const struct hawser_accuracy_motion start = {.omega = frf->point[i].omega,
	                                             .state = frf->state +
	                                                      (size_t)i*2*(size_t)frf->n};

	return hawser__weigh_motion(choice, rom, &start, whole, counted, peaks, report);
}

/* Points of the branch whose motions weigh the modes: value 2 at landmarks and ends, 1 at equal
 * distances between. If there is no landmark, all of them have the value 2. peak: the component
 * that has a peak there, see weigh.h. */
static void mark(char *mark, unsigned *peak, const struct hawser_frf *frf,
                 const struct hawser__marks *marks, int between)
{
	int any = 0;

	for (int k = 0; k < marks->count; k++)
		any |= marks->strong[k];
	for (int k = 0; k <= between; k++)
		mark[lround((double)k*(frf->points - 1)/between)] = any ? 1 : 2;
	/* a resonance outside the range is strongest at its end, and its mode may be missing in the
	 * model */
	mark[0] = mark[frf->points - 1] = 2;
	for (int i = 0; i < frf->points; i++)
		peak[i] = any ? 0 : HAWSER__BY_PLANE;
	for (int k = 0; k < marks->count; k++) {
		const struct hawser_landmark *item = &marks->item[k];
		int i = hawser__nearest_point(frf, item->arc);

		if (!marks->strong[k])
			continue;
		mark[i] = 2;
		if (item->kind == HAWSER_LANDMARK_PEAK)
			peak[i] |= 1u << (3*item->probe + item->axis);
	}
}

/* The point with the largest coordinates among those with the value 2. */
static int largest(const struct hawser_frf *frf, const char *marked)
{
	double most = -1.0;
	int best = 0;

	for (int i = 0; i < frf->points; i++) {
		double sum = 0.0;

		for (int j = 0; j < frf->n; j++)
			sum += pow(frf->coordinate[(size_t)i*frf->n + j], 2);
		if (marked[i] != 2 || sum <= most)
			continue;
		most = sum;
		best = i;
	}
	return best;
}

enum hawser_status hawser__weigh_response(struct hawser_choice *choice, const struct hawser_rom *rom,
                                          const struct hawser_frf *frf,
                                          const struct hawser__marks *marks, int between,
                                          struct hawser_report *report)
{
	char *marked = calloc((size_t)frf->points, 1);
	unsigned *peaks = calloc((size_t)frf->points, sizeof *peaks);
	enum hawser_status status = marked && peaks ? HAWSER_OK : hawser__no_memory(report, "study");
	int first = 0;

	if (!status) {
		mark(marked, peaks, frf, marks, between);
		first = largest(frf, marked);
		hawser_choice_forget(choice);
		status = hawser__weigh_orbit(choice, rom, frf, first, 1, HAWSER__BY_PLANE, peaks[first],
		                             report);
	}
	for (int i = 0; !status && i < frf->points; i++)
		if (marked[i] && i != first)
			status = hawser__weigh_orbit(choice, rom, frf, i, marked[i] == 2,
			                             HAWSER__BY_PLANE, peaks[i], report);
	free(marked);
	free(peaks);
	return status;
}
