/* modes/spectral.c - hp Legendre-Galerkin modes of the elastic catenary, strains as unknowns.
 *
 *   sa, sb     sqrt(compliance) of stretch and rotation: a = sa*strain_0, b = sb*strain_1
 *   p          Legendre polynomials per strain and element; the condition at the far end leaves
 *              p*elements - 1 functions per component
 *
 * cable.c has the grid and the fields; compliance.c explains why the unknowns are strains.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/cable.h"
#include "modes/label.h"
#include "modes/spectral.h"

/* The error of a shape is about the square root of that of its frequency. The target of the
 * frequency is therefore the tolerance times this factor, as far as round-off allows, so that the
 * shapes of a reduced model nearly meet the tolerance too. */
static const double shape_factor = 1e-3;
/* Round-off in every error estimate: this value times one plus the number of elements. Measured. */
static const double round_off = 4e-15;
/* An estimate below this value that no longer decreases is dominated by round-off. */
static const double stalled = 1e-9;
enum { UNKNOWNS_MAX = 2400 };

/* A mode as the index of a pair in a plane. */
struct place {
	int plane, pair;
};

/* A solution with a given p. */
struct attempt {
	struct hawser__cable cable;
	struct hawser__pairs pairs[HAWSER__PLANES];
	struct place *place; /* [n] of each kept mode, ascending omega */
};

static void attempt_clear(struct attempt *t)
{
	hawser__cable_clear(&t->cable);
	for (int q = 0; q < HAWSER__PLANES; q++)
		hawser__pairs_clear(&t->pairs[q]);
	free(t->place);
	*t = (struct attempt){0};
}

/* Numbers of the n lowest modes in each plane: keep[HAWSER__PLANES]. */
static void share_out(int *keep, const struct attempt *t, int n)
{
	const struct hawser__pairs *in = &t->pairs[HAWSER_IN_PLANE];
	const struct hawser__pairs *out = &t->pairs[HAWSER_OUT_OF_PLANE];
	int i = 0, o = 0;

	while (i + o < n)
		if (i == in->count || (o < out->count && out->omega[o] < in->omega[i]))
			o++;
		else
			i++;
	keep[HAWSER_IN_PLANE] = i;
	keep[HAWSER_OUT_OF_PLANE] = o;
}

/* The change by the refinement estimates the error of the unrefined frequency. The error of the
 * refined one is much smaller once the method converges, and smaller by this factor before that
 * (doc/theory-modes.md). */
double hawser__spectral_estimate(double moved, int elements)
{
	return 3.0*moved + hawser__spectral_round_off(elements);
}

double hawser__spectral_round_off(int elements)
{
	return round_off*(1 + elements);
}

static double estimate(const struct attempt *t, struct place at)
{
	double stated = hawser__spectral_estimate(t->pairs[at.plane].moved[at.pair],
	                                          t->cable.grid.elements);

	return hawser__cable_coarse(&t->cable) ? fmax(stated, 1.0) : stated;
}

static double omega_of(const struct attempt *t, struct place at)
{
	return t->pairs[at.plane].omega[at.pair];
}

/* Insert a mode into the first k, sorted by frequency. */
static void insert(struct attempt *t, int k, struct place at)
{
	for (; k > 0 && omega_of(t, t->place[k - 1]) > omega_of(t, at); k--)
		t->place[k] = t->place[k - 1];
	t->place[k] = at;
}

/* Refine the n lowest modes and sort them by frequency. *worst is the largest error estimate. */
static enum hawser_status refine(double *worst, struct attempt *t, int n,
                                 struct hawser_report *report)
{
	int keep[HAWSER__PLANES], k = 0;
	enum hawser_status status;

	share_out(keep, t, n);
	*worst = 0.0;
	for (int q = 0; q < HAWSER__PLANES; q++) {
		status = hawser__compliance_refine(&t->pairs[q], &t->cable.plane[q], &t->cable.grid,
		                                   &t->cable.reference, keep[q], report);
		if (status)
			return status;
		for (int j = 0; j < keep[q]; j++, k++) {
			insert(t, k, (struct place){q, j});
			*worst = fmax(*worst, estimate(t, (struct place){q, j}));
		}
	}
	return HAWSER_OK;
}

/* Grid, directions and refined eigenpairs with degree p. The caller clears *t, also on failure. */
static enum hawser_status attempt_solve(double *worst, struct attempt *t,
                                        const struct hawser_statics *st, int elements, int p,
                                        int n, struct hawser_report *report)
{
	enum hawser_status status;

	*t = (struct attempt){0};
	status = hawser__cable_init(&t->cable, st, elements, p, report);
	if (status)
		return status;
	t->place = malloc((size_t)n*sizeof *t->place);
	if (!t->place)
		return hawser__no_memory(report, "modes");
	for (int q = 0; q < HAWSER__PLANES && t->cable.plane[q].D > 0 && !status; q++)
		status = hawser__compliance_solve(&t->pairs[q], &t->cable.plane[q], &t->cable.grid,
		                                  &t->cable.reference, p, n, report);
	if (status)
		return status;
	return refine(worst, t, n, report);
}

/* Mode k of the result from its pair. */
static void fill_mode(struct hawser_modes *modes, const struct attempt *t, int k)
{
	size_t points = (size_t)t->cable.grid.points;
	const struct place *at = &t->place[k];
	const struct hawser__pairs *pairs = &t->pairs[at->plane];
	const struct hawser__plane *plane = &t->cable.plane[at->plane];

	hawser__cable_fields(modes->shape + (size_t)k*3*points, modes->slope + (size_t)k*3*points,
	                     &t->cable, at->plane,
	                     pairs->strain + (size_t)at->pair*hawser__strains(plane, &t->cable.grid),
	                     pairs->displacement +
	                             (size_t)at->pair*hawser__displacements(plane, &t->cable.grid));
}

/* The accepted attempt becomes the result; it keeps the grid. */
static enum hawser_status finish(struct hawser_modes *modes, struct attempt *t, int n,
                                 struct hawser_report *report)
{
	enum hawser_status status = hawser__modes_allocate(modes, n, t->cable.grid.points, report);

	if (status)
		return status;
	for (int k = 0; k < n; k++) {
		int q = t->place[k].plane;

		fill_mode(modes, t, k);
		if (modes->stroke)
			hawser__cable_strokes(modes->stroke + k*modes->statics.attachments, &t->cable, q,
			                      t->pairs[q].strain + (size_t)t->place[k].pair*
			                      hawser__strains(&t->cable.plane[q], &t->cable.grid));
		modes->mode[k].plane = (enum hawser_plane)q;
		modes->mode[k].omega = omega_of(t, t->place[k]);
		modes->mode[k].residual = estimate(t, t->place[k]);
	}
	modes->grid = t->cable.grid;
	t->cable.grid = (struct hawser_grid){0};
	return hawser__modes_label(modes, report);
}

enum hawser_status hawser__spectral_too_few(int n, int basis, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
	                    "%d modes asked of a basis that carries %d (%d functions a component): "
	                    "ask for fewer modes, or raise model.basis to %d or more", n, 3*basis,
	                    basis, 2*n);
}

/* The basis is given: one solution, whose error is reported but not controlled. */
static enum hawser_status solve_fixed(struct attempt *t, const struct hawser_statics *st,
                                      const struct hawser_modes_options *options,
                                      struct hawser_report *report)
{
	int elements, p = hawser__cable_split(&elements, st, options->basis);
	double worst;

	if (2*(options->basis + 1) > UNKNOWNS_MAX)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a basis of %d functions a component is more than the %d that "
		                    "this method takes: lower model.basis", options->basis,
		                    UNKNOWNS_MAX/2 - 1);
	if (options->n > 3*(p*elements - 1))
		return hawser__spectral_too_few(options->n, p*elements - 1, report);
	return attempt_solve(&worst, t, st, elements, p, options->n, report);
}

enum hawser_status hawser__spectral_too_many(int n, int functions, int most,
                                             struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
	                    "%d modes asked, which need some %d functions a component where %d are the "
	                    "most: ask for fewer modes", n, functions, most);
}

enum hawser_status hawser__spectral_unsettled(const struct hawser_modes_options *options,
                                              double worst, int functions, int tries,
                                              struct hawser_report *report)
{
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "modes", tries, worst,
	                       "the first %d frequencies have an estimated relative error of %.1e "
	                       "where %.1e was asked, with up to %d functions a component in %d "
	                       "attempts: ask for fewer modes, or for a larger tolerance (round-off "
	                       "allows 1e-13)", options->n, worst, options->tolerance, functions, tries);
}

double hawser__spectral_target(const struct hawser_modes_options *options, int elements)
{
	return fmin(options->tolerance, fmax(shape_factor*options->tolerance,
	                                     25.0*round_off*(1 + elements)));
}

int hawser__spectral_improves(double worst, double before)
{
	return worst > stalled || worst < 0.5*before;
}

/* Raise p until the estimate meets the target or, if round-off prevents that, the tolerance. */
static enum hawser_status solve_adaptive(struct attempt *t, const struct hawser_statics *st,
                                         const struct hawser_modes_options *options,
                                         struct hawser_report *report)
{
	int elements = hawser__cable_elements(st), tries = 0;
	int p = st->attachments > 0 ? hawser__cable_degree_attached(st, options->n)
	                            : hawser__cable_degree(elements, options->n);
	int most = UNKNOWNS_MAX/(2*elements);
	double worst = HUGE_VAL, before, target;

	if (p > most)
		return hawser__spectral_too_many(options->n, p*elements - 1, most*elements - 1, report);
	target = hawser__spectral_target(options, elements);
	do {
		enum hawser_status status;

		before = worst;
		attempt_clear(t);
		status = attempt_solve(&worst, t, st, elements, p, options->n, report);
		if (status || worst <= target)
			return status;
		tries++;
		p += p/4 > 4 ? p/4 : 4;
	} while (p <= most && hawser__spectral_improves(worst, before));
	if (worst <= options->tolerance)
		return HAWSER_OK;
	return hawser__spectral_unsettled(options, worst, t->cable.grid.points/2 - 1, tries, report);
}

enum hawser_status hawser__spectral_solve(struct hawser_modes *modes,
                                          const struct hawser_statics *statics,
                                          const struct hawser_modes_options *options,
                                          struct hawser_report *report)
{
	struct attempt t = {0};
	enum hawser_status status;

	status = options->basis > 0 ? solve_fixed(&t, statics, options, report)
	                            : solve_adaptive(&t, statics, options, report);
	if (!status)
		status = finish(modes, &t, options->n, report);
	if (!status)
		modes->basis = modes->grid.elements*(modes->grid.order/2) - 1;
	attempt_clear(&t);
	return status;
}
