/* response/cycle/settle.c - a limit cycle from a state, by integration in time.
 *
 *    x, f    the state and its rate of change; s = f . (x(t) - x), which grows through 0 where the
 *            motion comes back to the plane through x at right angles to it
 *
 * A return that is near closes the cycle: its time is the period, and what is left is for the
 * corrector. A state from which no return is near is replaced by one that the motion has reached
 * meanwhile: a stable cycle is approached in this way, and an unstable one is kept if the state is
 * near to it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/cycle/hopf.h"
#include "response/orbit/shooting.h"

#define FINER 4       /* times as many steps as shooting begins with */
#define CLOSE 0.01    /* distance of a return, relative to the extent, that closes a cycle; chosen */
#define AT_REST 1e-3  /* distance from an equilibrium, relative, of a state that is one; chosen */
#define NEAR_ENOUGH 1e-5 /* the same, at which nothing is gained; chosen */
enum { CLOSER = 60 };    /* further periods; chosen */
enum { TURNS = 12, STARTS = 60 }; /* returns that are looked at from a state, and states; chosen */

struct settle {
	const struct hawser_rom *rom;
	struct hawser__flow flow;
	struct hawser__stretch step;
	double *x, *f, *at, *before; /* [m] */
	int m;
};

static void rate(double *f, const struct hawser_rom *rom, const double *x)
{
	memcpy(f, x + rom->n, (size_t)rom->n*sizeof *f);
	hawser_rom_acceleration(rom, f + rom->n, x, x + rom->n, 0.0, 1.0);
}

static double across(const struct settle *of, const double *at)
{
	double sum = 0.0;

	for (int i = 0; i < of->m; i++)
		sum += of->f[i]*(at[i] - of->x[i]);
	return sum;
}

static double apart(const struct settle *of, const double *at)
{
	double sum = 0.0;

	for (int i = 0; i < of->m; i++)
		sum += (at[i] - of->x[i])*(at[i] - of->x[i]);
	return sqrt(sum);
}

/* *period of the first near return to of->x, and *gap, its distance relative to the extent; 0: none.
 * of->at becomes the state that was reached last. */
static void look(double *period, double *gap, struct settle *of)
{
	double extent = 0.0, s, last = 0.0;
	long most = (long)TURNS*of->step.steps*40;
	int turns = 0;

	*period = 0.0;
	rate(of->f, of->rom, of->x);
	memcpy(of->at, of->x, (size_t)of->m*sizeof(double));
	for (long i = 1; i < most && turns < TURNS; i++) {
		memcpy(of->before, of->at, (size_t)of->m*sizeof(double));
		hawser__flow_map(&of->flow, of->at, NULL,
		                 &(struct hawser__stretch){.h = of->step.h, .steps = 1, .count = 1}, 1.0);
		s = across(of, of->at);
		extent = fmax(extent, apart(of, of->at));
		if (!isfinite(s))
			return;
		if (last < 0.0 && s >= 0.0) {
			double part = last/(last - s), near = 0.0;

			for (int j = 0; j < of->m; j++)
				near += pow(of->before[j] + part*(of->at[j] - of->before[j]) - of->x[j], 2);
			turns++;
			if (sqrt(near) <= CLOSE*extent) {
				*period = ((double)i - 1.0 + part)*of->step.h;
				*gap = sqrt(near)/extent;
				return;
			}
		}
		last = s;
	}
}

/* A stable cycle is near after further periods; an unstable one is left, and the state stays. */
static void approach_cycle(struct settle *of, double *period, double gap, double *kept)
{
	size_t bytes = (size_t)of->m*sizeof *kept;

	for (int i = 0; i < CLOSER && gap > NEAR_ENOUGH; i++) {
		double next, next_gap = 1.0;

		memcpy(kept, of->x, bytes);
		memcpy(of->x, of->at, bytes);
		look(&next, &next_gap, of);
		if (!(next > 0.0 && next_gap < gap)) {
			memcpy(of->x, kept, bytes);
			return;
		}
		*period = next;
		gap = next_gap;
	}
}

static int is_at_rest(const struct settle *of, double *u, struct hawser_report *report)
{
	int n = of->rom->n;
	double gap = 0.0;

	memcpy(u, of->x, (size_t)n*sizeof *u);
	if (hawser__equilibrium_find(u, of->rom, 0, report))
		return 0;
	for (int j = 0; j < n; j++)
		gap = fmax(gap, fmax(fabs(u[j] - of->x[j]), fabs(of->x[n + j])));
	return gap <= AT_REST*fmax(cblas_dnrm2(n, u, 1), AT_REST);
}

enum hawser_status hawser__cycle_settle(double *x, double *omega, const struct hawser_rom *rom,
                                        struct hawser_report *report)
{
	struct settle of = {.rom = rom, .m = 2*rom->n};
	size_t m = (size_t)of.m;
	double *memory = malloc(4*m*sizeof *memory), period = 0.0, gap = 1.0;
	int steps = FINER*hawser__shooting_steps(rom, 1.0, 1);
	enum hawser_status status = memory ? hawser__flow_init(&of.flow, rom, report)
	                                   : hawser__no_memory(report, "frf");

	*omega = 0.0;
	of.step = (struct hawser__stretch){.h = 2.0*M_PI/steps, .steps = steps};
	of.x = x;
	of.f = memory;
	of.at = memory ? memory + m : NULL;
	of.before = memory ? memory + 2*m : NULL;
	if (!status && is_at_rest(&of, of.f, NULL)) {
		hawser__flow_clear(&of.flow);
		free(memory);
		return HAWSER_OK;
	}
	if (!status && rom->first) /* the velocities follow */
		hawser_rom_acceleration(rom->first, x + rom->n, x, of.f, 0.0, 1.0);
	for (int i = 0; !status && period == 0.0 && i < STARTS; i++) {
		look(&period, &gap, &of);
		if (period == 0.0)
			memcpy(x, of.at, m*sizeof *x);
		if (!isfinite(cblas_dnrm2(of.m, x, 1)))
			break;
	}
	if (period > 0.0)
		approach_cycle(&of, &period, gap, memory + 3*m);
	hawser__flow_clear(&of.flow);
	free(memory);
	if (!status && period == 0.0)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf",
		                      "the motion from the given state does not come to a limit cycle: hawser "
		                      "integrate shows it");
	if (!status)
		*omega = 2.0*M_PI/period;
	return status;
}
