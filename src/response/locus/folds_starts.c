/* response/locus/folds_starts.c - detached response curves from pseudo-random motions.
 *
 * A closed curve that has no fold on a curve through the folds of responses is connected to nothing
 * that is followed. Here motions from pseudo-random states settle at frequencies of a coarse grid, and
 * Newton's method turns each into an orbit. An orbit that is on no known curve at this frequency begins
 * a new one. The states are the same in each run and on every machine.
 *
 *    s_j    largest amplitude of coordinate j on the known curves, at least LEAST times that of all
 *    a, b   pseudo-random: u_j = r s_j cos b_j, du_j/dt = -r s_j w_j sin b_j, with log r uniform
 *    w_j    frequency of coordinate j
 *
 * Orbits are compared by their amplitudes, which those of mirror images share. A curve that begins at a
 * branch point of a known one is not detached, and is left out: its motions have lost a symmetry.
 *
 * The search finds what it meets. It proves nothing, and the result says how far it went.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "core/random.h"
#include "response/time/flow.h"
#include "response/locus/folds_search.h"
#include "response/orbit/shooting.h"

#define AT_EACH 4     /* starts at a frequency; chosen */
#define LEAST 0.3     /* see s_j; chosen */
#define SMALL 0.2     /* range of r; chosen, as is the other end: */
#define LARGE 4.0     /* detached curves have several times the amplitude of the others */
#define PERIODS 60    /* largest number of periods in which a motion settles; chosen */
#define TRY 10        /* periods between looks at it; chosen */
#define SETTLED 1e-3  /* relative change over a period of a settled motion: Newton's method goes on */
#define FINER 2       /* steps of a period relative to those of small motions, with which motions are
                       * integrated again that grow without bound with the same; chosen */
#define FEWEST 8      /* frequencies; chosen */
#define UNASKED 2.0   /* s, as counted (hawser_orbit_work): work to which a default number of motions is
                       * reduced, but not below FEWEST frequencies; chosen */
#define ALIKE 1e-4    /* largest relative difference of amplitudes of the same orbit; chosen, above the
                       * errors of orbits and below their distances */
#define SAME_POINT 1e-6 /* relative difference of Omega of two branch points that are one; chosen */
#define STARTS_TIME 0.2 /* of all of them over the search before, for the time left alone; measured */
#define MOST_NEW 8    /* curves after which the search ends: each may take as long as a response */

struct hunt {
	struct hawser__fold_search *search;
	struct hawser__flow flow;
	double *s, *x;          /* [n], [2n] */
	double *start, *before, *now; /* [AT_EACH][2n] settled motions; those of a period ago and now */
	double *known;          /* [count][n] amplitudes of the orbits known at the present frequency */
	int count;
	struct hawser_frf *beside; /* [besides] curves that begin at branch points of known ones */
	int besides;
	uint64_t random;
};

/* --- orbits that are known --- */

static enum hawser_status remember(struct hunt *hunt, const double *amplitudes)
{
	size_t n = (size_t)hunt->search->rom->n;

	if (hawser__more(&hunt->known, hunt->count, n*sizeof *hunt->known))
		return hawser__no_memory(hunt->search->report, "folds");
	memcpy(hunt->known + (size_t)hunt->count++*n, amplitudes, n*sizeof *amplitudes);
	return HAWSER_OK;
}

static int is_known(const struct hunt *hunt, const double *amplitudes)
{
	int n = hunt->search->rom->n;

	for (int k = 0; k < hunt->count; k++)
		if (hawser__same_state(hunt->known + (size_t)k*(size_t)n, amplitudes, n, ALIKE))
			return 1;
	return 0;
}

/* Watches a trace that is to stop at its first point, or if that is known. */
struct first {
	struct hawser__fold_watch base;
	const struct hunt *hunt;
	int only, known;
};

static int watch(void *data, const struct hawser_progress_state *state)
{
	struct first *first = data;

	if (state->frf->points == 1)
		first->known = is_known(first->hunt, state->frf->coordinate);
	return first->known || (first->only && state->frf->points > 0) ||
	       hawser__fold_watch(&first->base, state);
}

/* A trace from the state x at omega. HAWSER_OK with no points: there is no orbit. */
static enum hawser_status trace(struct hunt *hunt, struct hawser_frf *frf, struct first *first,
                                const double *x, double omega, int direction)
{
	struct hawser__fold_search *search = hunt->search;
	struct hawser_frf_options choice = hawser__fold_response(search, &first->base);
	enum hawser_status status;

	first->base.options = search->options;
	first->base.stage = "detached curve";
	first->hunt = hunt;
	choice.begin = omega;
	choice.start = x;
	choice.direction = direction;
	choice.skip_events = first->only;
	choice.progress = (struct hawser_progress){watch, first};
	status = hawser__fold_trace(search, frf, search->rom, &choice, NULL);
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(search->report, "folds") : HAWSER_OK;
}

/* Remember the orbits of a curve at omega. */
static enum hawser_status crossings(struct hunt *hunt, const struct hawser_frf *curve, double omega)
{
	int m = 2*curve->n;

	for (int p = 0; p + 1 < curve->points; p++) {
		double a = curve->point[p].omega, b = curve->point[p + 1].omega, s = (omega - a)/(b - a);
		const double *x = curve->state + (size_t)p*(size_t)m;
		struct first first = {.only = 1};
		struct hawser_frf frf = {0};
		enum hawser_status status;

		if (!(s >= 0.0 && s < 1.0))
			continue;
		for (int i = 0; i < m; i++)
			hunt->x[i] = (1.0 - s)*x[i] + s*x[m + i];
		status = trace(hunt, &frf, &first, hunt->x, omega, 0);
		if (!status && frf.points > 0 && !first.known)
			status = remember(hunt, frf.coordinate);
		hawser_frf_clear(&frf);
		if (status)
			return status;
	}
	return HAWSER_OK;
}

static enum hawser_status all_crossings(struct hunt *hunt, double omega)
{
	const struct hawser_folds *folds = hunt->search->folds;
	enum hawser_status status = crossings(hunt, &folds->response, omega);

	for (int i = 0; !status && i < folds->isolas; i++)
		status = crossings(hunt, &folds->isola[i], omega);
	for (int i = 0; !status && i < hunt->besides; i++)
		status = crossings(hunt, &hunt->beside[i], omega);
	return status;
}

/* --- motions --- */

static void raise_amplitudes(double *s, const struct hawser_frf *frf)
{
	for (int p = 0; p < frf->points; p++)
		for (int j = 0; j < frf->n; j++)
			s[j] = fmax(s[j], frf->coordinate[p*frf->n + j]);
}

static void amplitudes(struct hunt *hunt)
{
	const struct hawser_folds *folds = hunt->search->folds;
	double most = 0.0;

	raise_amplitudes(hunt->s, &folds->response);
	for (int i = 0; i < folds->isolas; i++)
		raise_amplitudes(hunt->s, &folds->isola[i]);
	for (int j = 0; j < folds->n; j++)
		most = fmax(most, hunt->s[j]);
	for (int j = 0; j < folds->n; j++)
		hunt->s[j] = fmax(hunt->s[j], LEAST*most);
}

static void random_state(struct hunt *hunt, double *x)
{
	const struct hawser_rom *rom = hunt->search->rom;
	int n = rom->n;
	double r = SMALL*pow(LARGE/SMALL, hawser__random(&hunt->random));

	for (int j = 0; j < n; j++) {
		double b = 2.0*M_PI*hawser__random(&hunt->random), w = sqrt(fmax(rom->K[j*n + j], 0.0));

		x[j] = r*hunt->s[j]*cos(b);
		x[n + j] = -r*hunt->s[j]*w*sin(b);
	}
}

static int steps_at(const struct hunt *hunt, double omega)
{
	return hawser__shooting_steps(hunt->search->rom, omega, 1);
}

/* The frequency g of a grid of `count`. */
static double frequency(const struct hunt *hunt, int g, int count)
{
	const struct hawser__fold_walk *walk = &hunt->search->walk;

	return walk->omega_lo + (walk->omega_hi - walk->omega_lo)*(g + 0.5)/count;
}

/* Number of frequencies: if the number of motions is the default, fewer where those that never settle
 * would take too long. */
static int frequencies(const struct hunt *hunt)
{
	const struct hawser__fold_search *search = hunt->search;
	int count = (search->options->starts + AT_EACH - 1)/AT_EACH;
	struct hawser_orbit_cost cost = {.flops = 0.0};

	for (int g = 0; g < count; g++)
		cost.flops += (double)AT_EACH*PERIODS*steps_at(hunt, frequency(hunt, g, count))*
		              hawser__flow_flops(&hunt->flow, 0);
	if (search->unasked)
		count = (int)fmax(fmin(FEWEST, count),
		                  count*fmin(1.0, UNASKED/hawser_orbit_work(&cost, search->rom)));
	return count;
}

/* The motions from AT_EACH pseudo-random states until each has settled: they differ in nothing else, so
 * that they are integrated side by side. One that grows without bound is not finite at its end. Returns
 * whether all are finite. */
static int settle(struct hunt *hunt, double omega, int finer)
{
	int m = 2*hunt->search->rom->n, moving = AT_EACH, steps = finer*steps_at(hunt, omega);
	struct hawser__stretch period = {.h = 2.0*M_PI/steps, .steps = steps, .count = AT_EACH};
	double *now = hunt->now;
	int settled[AT_EACH] = {0};

	for (int i = 0; i < AT_EACH; i++)
		random_state(hunt, now + i*m);
	for (int p = 1; p <= PERIODS && moving > 0; p++) {
		memcpy(hunt->before, now, AT_EACH*(size_t)m*sizeof *now);
		hawser__flow_map(&hunt->flow, now, NULL, &period, omega);
		if (p % TRY == 0 && hawser__fold_told_to_stop(hunt->search, "detached curves", "frequencies",
		                                              hunt->search->folds->starts.frequencies))
			return 1;
		for (int i = 0; i < AT_EACH; i++) {
			double *x = now + i*m;

			if (settled[i])
				continue;
			memcpy(hunt->start + i*m, x, (size_t)m*sizeof *x);
			settled[i] = !isfinite(cblas_dasum(m, x, 1)) ||
			             (p % TRY == 0 && hawser__same_state(hunt->before + i*m, x, m, SETTLED));
			moving -= settled[i];
		}
	}
	return isfinite(cblas_dasum(AT_EACH*m, hunt->start, 1));
}

/* --- curves --- */

/* Whether the curve has a branch point of a known one. */
static int shares_branch_point(const struct hawser_frf *curve, const struct hawser_frf *other)
{
	for (int e = 0; e < curve->events; e++)
		for (int f = 0; f < other->events; f++)
			if (curve->event[e].kind == HAWSER_BRANCH_POINT &&
			    other->event[f].kind == HAWSER_BRANCH_POINT &&
			    fabs(curve->event[e].omega - other->event[f].omega) <=
			    SAME_POINT*curve->event[e].omega)
				return 1;
	return 0;
}

static int is_attached(const struct hunt *hunt, const struct hawser_frf *curve)
{
	const struct hawser_folds *folds = hunt->search->folds;
	int found = shares_branch_point(curve, &folds->response);

	for (int i = 0; i < folds->isolas; i++)
		found |= shares_branch_point(curve, &folds->isola[i]);
	return found;
}

/* Take the curve, which is moved. */
static enum hawser_status take(struct hunt *hunt, struct hawser_frf *curve)
{
	struct hawser__fold_search *search = hunt->search;

	if (!is_attached(hunt, curve)) {
		search->folds->starts.fresh++;
		return hawser__fold_keep(search, curve);
	}
	if (hawser__more(&hunt->beside, hunt->besides, sizeof *hunt->beside)) {
		hawser_frf_clear(curve);
		return hawser__no_memory(search->report, "folds");
	}
	hunt->beside[hunt->besides++] = *curve;
	search->folds->starts.attached++;
	return HAWSER_OK;
}

/* The curve through the orbit near hunt->x, in both directions if it is open. */
static enum hawser_status follow(struct hunt *hunt, double omega)
{
	struct hawser_folds *folds = hunt->search->folds;

	for (int direction = 1; direction >= -1; direction -= 2) {
		struct first first = {.only = 0};
		struct hawser_frf frf = {0};
		enum hawser_status status = trace(hunt, &frf, &first, hunt->x, omega, direction);
		int closed = frf.end == HAWSER_END_CLOSED;

		if (status || frf.points < 2 || first.known) {
			folds->starts.known += first.known;
			folds->starts.lost += frf.points == 0;
			/* the work ended at its first orbit, which was not compared: not counted */
			folds->starts.starts -= direction > 0 && frf.points == 1 && frf.end == HAWSER_END_WORK;
			hawser_frf_clear(&frf);
			return status;
		}
		if ((status = take(hunt, &frf)) || closed ||
		    (direction > 0 && hawser__fold_ended(hunt->search)))
			return status;
	}
	return HAWSER_OK;
}

static int ended(struct hunt *hunt)
{
	return hunt->search->folds->starts.fresh >= MOST_NEW || hawser__fold_ended(hunt->search);
}

static enum hawser_status at_frequency(struct hunt *hunt, double omega)
{
	struct hawser_folds *folds = hunt->search->folds;
	int curves = -1, m = 2*folds->n, before = folds->starts.starts;
	uint64_t random = hunt->random;
	struct hawser_orbit_cost cost = {.flops = -hunt->flow.flops};
	enum hawser_status status = HAWSER_OK;

	if (!settle(hunt, omega, 1)) {
		hunt->random = random;
		settle(hunt, omega, FINER);
	}
	cost.flops += hunt->flow.flops;
	hunt->search->walk.work += hawser_orbit_work(&cost, hunt->search->rom);
	for (int i = 0; !status && i < AT_EACH && !ended(hunt); i++) {
		if (curves != folds->isolas + hunt->besides) {
			hunt->count = 0;
			curves = folds->isolas + hunt->besides;
			if ((status = all_crossings(hunt, omega)))
				return status;
		}
		folds->starts.starts++;
		memcpy(hunt->x, hunt->start + i*m, (size_t)m*sizeof *hunt->x);
		if (!isfinite(cblas_dasum(m, hunt->x, 1)))
			folds->starts.lost++;
		else
			status = follow(hunt, omega);
	}
	folds->starts.frequencies += folds->starts.starts > before;
	return status;
}

enum hawser_status hawser__fold_starts(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	struct hunt hunt = {.search = search};
	int n = folds->n, grid = 0;
	double began = 0.0;
	enum hawser_status status = hawser__flow_init(&hunt.flow, search->rom, search->report);

	hunt.s = calloc((size_t)n, (3 + 3*2*AT_EACH)*sizeof *hunt.s);
	if (!status && !hunt.s)
		status = hawser__no_memory(search->report, "folds");
	if (!status) {
		hunt.x = hunt.s + n;
		hunt.start = hunt.x + 2*n;
		hunt.before = hunt.start + AT_EACH*2*n;
		hunt.now = hunt.before + AT_EACH*2*n;
		amplitudes(&hunt);
		grid = frequencies(&hunt);
	}
	for (int g = 0; !status && g < grid && !ended(&hunt); g++) {
		double now = hawser__wall_seconds() - search->walk.span.began;
		double each = g > 0 ? (now - began)/g : STARTS_TIME*now/grid;

		began = g > 0 ? began : now;
		hawser__fold_ahead(search, each, each*(grid - g - 1));
		if (hawser__fold_told_to_stop(search, "detached curves", "frequencies", g))
			break;
		status = at_frequency(&hunt, frequency(&hunt, g, grid));
	}
	for (int i = 0; i < hunt.besides; i++)
		hawser_frf_clear(&hunt.beside[i]);
	free(hunt.beside);
	free(hunt.known);
	free(hunt.s);
	hawser__flow_clear(&hunt.flow);
	return status;
}
