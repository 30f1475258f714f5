/* response/backbone/nnm.c - see hawser/nnm.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/nnm.h>

#include "core/grow.h"
#include "core/hold.h"
#include "core/report.h"
#include "core/settle.h"

#define SAME 1e-6 /* relative difference of Omega and energy of first points that are mirror images */
/* Distances of the first point from the branch point, in the metric; chosen. */
static const double distance[] = {0.02, 0.005, 0.05, 0.15};
enum { DISTANCES = sizeof distance/sizeof *distance, MOST_CURVES = 60 };

void hawser_nnm_settle(struct hawser_nnm_options *options)
{
	hawser__settle(&options->tolerance, 1e-9);
	hawser__settle(&options->step_max, 0.05);
	hawser__settle_count(&options->max_points, 1000);
	hawser__settle_count(&options->periods, 1);
}

/* The larger one of: the potential of a quadratic force over 2/3 of that of the linear one, and
 * that of a cubic force over 1/2, as far as the energies at a and -a tell. At 1 the force equals
 * the linear one. */
static double share(const struct hawser_rom *rom, int mode, double a, double *u, const double *rest)
{
	double k = rom->K[(size_t)mode*((size_t)rom->n + 1)], linear = 0.5*k*a*a, up, down;

	u[mode] = a;
	up = hawser_rom_energy(rom, u, rest);
	u[mode] = -a;
	down = hawser_rom_energy(rom, u, rest);
	u[mode] = 0.0;
	return fmax(0.75*fabs(up - down)/linear, 2.0*fabs(0.5*(up + down)/linear - 1.0));
}

/* The energy of the linear mode at the least amplitude at which the nonlinear part of the force in this
 * mode alone equals its linear one; where it never does, at amplitude 1. */
static enum hawser_status usual_energy(double *energy, const struct hawser_rom *rom, int mode,
                                       struct hawser_report *report)
{
	double k = rom->K[(size_t)mode*((size_t)rom->n + 1)], lo = 1e-6, hi;
	double *u = calloc(2*(size_t)rom->n, sizeof *u);

	if (!u)
		return hawser__no_memory(report, "nnm");
	while (lo < 1e3 && share(rom, mode, 2.0*lo, u, u + rom->n) < 1.0)
		lo *= 2.0;
	hi = 2.0*lo;
	for (int i = 0; i < 40 && lo < 1e3; i++) {
		double middle = 0.5*(lo + hi);

		*(share(rom, mode, middle, u, u + rom->n) < 1.0 ? &lo : &hi) = middle;
	}
	free(u);
	*energy = lo < 1e3 ? 0.5*k*lo*lo : 0.5*k;
	return HAWSER_OK;
}

static struct hawser_nnm_curve *add(struct hawser_nnm *nnm, struct hawser_report *report)
{
	if (hawser__more(&nnm->curve, nnm->curves, sizeof *nnm->curve)) {
		(void)hawser__no_memory(report, "nnm");
		return NULL;
	}
	nnm->curve[nnm->curves] = (struct hawser_nnm_curve){.parent = -1, .born = -1};
	return &nnm->curve[nnm->curves++];
}

/* Omega and energy of all branch points; NULL: no memory. */
static double *branch_points(const struct hawser_nnm *nnm, int *count)
{
	double *list;

	*count = 0;
	for (int c = 0; c < nnm->curves; c++)
		*count += nnm->curve[c].motion.branches;
	list = malloc((2*(size_t)*count + 1)*sizeof *list);
	*count = 0;
	for (int c = 0; list && c < nnm->curves; c++)
		for (int b = 0; b < nnm->curve[c].motion.branches; b++) {
			list[2**count] = nnm->curve[c].motion.branch[b].omega;
			list[2*(*count)++ + 1] = nnm->curve[c].motion.branch[b].energy;
		}
	return list;
}

/* A curve that failed after its first points is kept, with the reason; *status becomes HAWSER_OK. */
static void keep_part(struct hawser_nnm_curve *curve, enum hawser_status *status,
                      const struct hawser_report *report)
{
	if (*status == HAWSER_ERR_CONVERGENCE && curve->motion.points > 1) {
		snprintf(curve->message, sizeof curve->message, "%s", report->message);
		*status = HAWSER_OK;
	}
}

/* The curve from a branch point to one side. *found 0: there is none. */
static enum hawser_status leave(struct hawser_nnm *nnm, const struct hawser_rom *rom,
                                const struct hawser_backbone_options *base, int parent, int born,
                                double side, int *found, struct hawser_report *report)
{
	size_t size = (size_t)rom->n + 1;
	double *start = malloc(2*size*sizeof *start), *direction = hawser__behind(start, size), *known;
	struct hawser_backbone_options options = *base;
	struct hawser_nnm_curve *curve = start ? add(nnm, report) : NULL;
	enum hawser_status status = HAWSER_OK;

	*found = 0;
	known = branch_points(nnm, &options.known_count);
	if (!start || !curve || !known) {
		free(start);
		free(known);
		return hawser__no_memory(report, "nnm");
	}
	curve->parent = parent;
	curve->born = born;
	curve->depth = nnm->curve[parent].depth + 1;
	options.start = start;
	options.direction = direction;
	options.known = known;
	options.quadrature = 0;
	for (int d = 0; !status && !*found && d < DISTANCES; d++) {
		const struct hawser_backbone *from = &nnm->curve[parent].motion;
		const double *at = from->branch_start + (size_t)born*size;
		const double *s = from->branch_direction + (size_t)born*size;

		options.sign = from->branch_sign + (size_t)born*(size - 1);
		for (size_t k = 0; k < size; k++) {
			direction[k] = side*s[k];
			start[k] = at[k] + distance[d]*direction[k];
		}
		hawser_backbone_clear(&curve->motion);
		status = hawser_backbone_trace(&curve->motion, rom, &options, report);
		nnm->interrupted = !status && curve->motion.end == HAWSER_BACKBONE_STOPPED;
		keep_part(curve, &status, report);
		*found = !status && curve->motion.points > 1;
		if (status == HAWSER_ERR_CONVERGENCE)
			status = HAWSER_OK;
	}
	if (!*found) {
		hawser_backbone_clear(&curve->motion);
		nnm->curves--;
	}
	free(start);
	free(known);
	return status;
}

/* Whether the curve added last is a mirror image of the one before, the other side of the branch. */
static int is_image(const struct hawser_nnm *nnm)
{
	const struct hawser_backbone *a = &nnm->curve[nnm->curves - 2].motion;
	const struct hawser_backbone *b = &nnm->curve[nnm->curves - 1].motion;

	return fabs(a->point[0].omega/b->point[0].omega - 1.0) < SAME &&
	       fabs(a->point[0].energy/b->point[0].energy - 1.0) < SAME;
}

static enum hawser_status leave_both(struct hawser_nnm *nnm, const struct hawser_rom *rom,
                                     const struct hawser_backbone_options *options, int parent,
                                     int born, struct hawser_report *report)
{
	int found, other = 0;
	enum hawser_status status = leave(nnm, rom, options, parent, born, 1.0, &found, report);

	if (!status && !nnm->interrupted)
		status = leave(nnm, rom, options, parent, born, -1.0, &other, report);
	if (!status && found && other && is_image(nnm))
		hawser_backbone_clear(&nnm->curve[--nnm->curves].motion);
	nnm->lost += !status && !found && !other && !nnm->interrupted;
	return status;
}

/* All branches of a curve, if it is not as deep as asked for. */
static enum hawser_status leave_all(struct hawser_nnm *nnm, const struct hawser_rom *rom,
                                    const struct hawser_backbone_options *options, int parent,
                                    int depth, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	if (nnm->curve[parent].depth >= depth)
		return status;
	for (int b = 0; !status && b < nnm->curve[parent].motion.branches; b++)
		if (!nnm->interrupted && nnm->curves < MOST_CURVES)
			status = leave_both(nnm, rom, options, parent, b, report);
	return status;
}

enum hawser_status hawser_nnm_trace(struct hawser_nnm *nnm, const struct hawser_rom *rom,
                                    const struct hawser_nnm_options *options,
                                    struct hawser_report *report)
{
	struct hawser_nnm_options own = *options;
	struct hawser_backbone_options base = {.mode = own.mode};
	struct hawser_nnm_curve *first;
	enum hawser_status status;

	*nnm = (struct hawser_nnm){.n = rom->n};
	hawser_nnm_settle(&own);
	if (own.mode < 0 || own.mode >= rom->n)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "nnm", "mode %d: the model has 1 to %d",
		                    own.mode + 1, rom->n);
	if (!(own.energy >= 0.0 && isfinite(own.energy)) || own.depth < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "nnm",
		                    "energy %g (positive and finite), depth %d (0 or more): one is out of "
		                    "range", own.energy, own.depth);
	nnm->energy = own.energy;
	status = own.energy > 0.0 ? HAWSER_OK : usual_energy(&nnm->energy, rom, own.mode, report);
	if (status)
		return status;
	base.energy = nnm->energy;
	base.size = sqrt(2.0*fmax(nnm->energy, 0.0)/
	                 fmax(rom->K[(size_t)own.mode*((size_t)rom->n + 1)], 1e-300));
	base.periods = own.periods;
	base.quadrature = own.quadrature;
	base.branches = 1;
	base.lo = own.lo;
	base.hi = own.hi;
	if (own.hi == 0.0) {
		double w = sqrt(fmax(rom->K[(size_t)own.mode*((size_t)rom->n + 1)], 0.0));

		base.lo = 0.25*w;
		base.hi = 4.0*w;
	}
	base.tolerance = own.tolerance;
	base.step_max = own.step_max;
	base.max_points = own.max_points;
	base.progress = own.progress;
	if (!(first = add(nnm, report)))
		return HAWSER_ERR_MEMORY;
	status = hawser_backbone_trace(&first->motion, rom, &base, report);
	nnm->interrupted = !status && first->motion.end == HAWSER_BACKBONE_STOPPED;
	keep_part(first, &status, report);
	for (int c = 0; !status && !nnm->interrupted && c < nnm->curves; c++)
		status = leave_all(nnm, rom, &base, c, own.depth, report);
	return status;
}

void hawser_nnm_clear(struct hawser_nnm *nnm)
{
	if (!nnm)
		return;
	for (int c = 0; c < nnm->curves; c++)
		hawser_backbone_clear(&nnm->curve[c].motion);
	free(nnm->curve);
	*nnm = (struct hawser_nnm){.n = 0};
}
