/* tests/extremes/traces-judge.h - checks of a whole trace, over the tension or over the speed: each
 * station, each crossover, and the traces with other steps and in the opposite direction
 * (traces-check.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_TRACES_JUDGE_H
#define HAWSER_TESTS_TRACES_JUDGE_H

#include "tests/extremes/traces-check.h"

/* --- the tension --- */

static inline struct trace of_irvine(const struct hawser_irvine *irvine)
{
	struct trace t = {.stations = irvine->stations, .branches = irvine->branches,
	                  .in = irvine->in_plane, .crossovers = irvine->crossovers,
	                  .omega = irvine->omega, .residual = irvine->residual, .place = irvine->place,
	                  .family = irvine->family, .symmetry = irvine->symmetry};

	trace_room(&t);
	for (int i = 0; i < t.stations; i++) {
		t.x[i] = irvine->station[i].statics.H;
		t.moved[i] = irvine->station[i].moved;
		if (!irvine->station[i].inserted)
			t.asked[t.points++] = i;
	}
	for (int i = 0; i < t.crossovers; i++) {
		const struct hawser_irvine_crossover *c = irvine->crossover + i;

		t.at[i] = (struct hawser_campbell_crossover){c->kind, c->H, c->below, c->above, c->omega,
		                                             c->gap, c->relative_gap};
	}
	return t;
}

/* The apparent cable of a span at a speed, solved as a resting one. */
static inline enum hawser_status apparent(struct hawser_statics *st, const struct hawser_span *span,
                                   double speed, double H)
{
	double m = span->rho*speed*speed/span->EA;
	struct hawser_span slow = *span;
	enum hawser_status status;

	slow.rho *= 1.0 - m;
	status = hawser_statics_solve(st, &slow, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL);
	st->motion.speed = speed;
	st->motion.mach2 = m;
	st->motion.nu = speed*sqrt(span->rho/((1.0 - m)*H));
	return status;
}

/* Stations must be at the requested places. */
static inline void placed(struct sweep_point *point, const struct hawser_irvine *irvine,
                   const struct trace *t, const struct hawser_irvine_options *o)
{
	double first = log(t->x[0]), last = log(t->x[t->stations - 1]);

	if (t->points != o->points)
		trace_wrong(point, "%d of %d points", t->points, o->points);
	for (int k = 0; k < t->points && k < o->points; k++) {
		const struct hawser_irvine_station *at = irvine->station + t->asked[k];
		double part = (double)k/(o->points - 1);
		double error = at->value/(o->from*pow(o->to/o->from, part)) - 1.0;

		if (o->sweep == HAWSER_GIVEN_LENGTH0)
			error = log(at->statics.H) - first - part*(last - first);
		if (!(fabs(error) <= 2.0*fabs(at->moved) + 2e-4*fabs(irvine->station[0].moved) + 1e-12))
			trace_wrong(point, "point %d is off its place by %.1e (%.1e)", k, error, at->moved);
	}
}

/* Modes at x, with the branch pair of a crossover: index of the lower one in the plane, or -1. */
static inline int closest(struct truth *truth, double omega, int most)
{
	int best = -1;
	double least = INFINITY;

	if (truth_solve(truth, most + 3, 0))
		return -1;
	for (int k = 0; k + 1 < truth->count[0]; k++) {
		double off = fabs(0.5*(truth->omega[0][k] + truth->omega[0][k + 1])/omega - 1.0);

		if (off < least) {
			least = off;
			best = k;
		}
	}
	return best;
}

static inline double gap_of(const struct truth *truth, int k)
{
	const double *omega = truth->omega[0];

	return 2.0*(omega[k + 1] - omega[k])/(omega[k + 1] + omega[k]);
}

/* At a crossover two modes must have the reported distance, and no smaller distance near it. At a
 * crossing the index theorem must count two frequencies. */
static inline void crossover(struct sweep_point *point, const struct hawser_irvine *irvine,
                      const struct hawser_irvine_crossover *c)
{
	struct truth truth;
	const struct hawser_motion motion = {.speed = irvine->speed, .hold = HAWSER_HOLD_TENSION};
	double v = irvine->speed, H = c->H, off = 0.1*c->relative_gap + 1e-7, here, width, error;
	int k, most = c->above > c->below ? c->above : c->below;

	if (hawser_statics_travel(&truth.statics, &irvine->span, HAWSER_GIVEN_H, H,
	                          HAWSER_BRANCH_TAUT, &motion, NULL)) {
		trace_wrong(point, "no statics at the crossover, H %.17g", H);
		return;
	}
	k = closest(&truth, c->omega, most > irvine->in_plane ? most + 2 : irvine->in_plane + 2);
	if (k < 0) {
		trace_wrong(point, "no modes at the crossover, H %.17g", H);
		return;
	}
	here = gap_of(&truth, k);
	width = 4.0*truth.residual[0][k] + 1e-9*c->relative_gap + 1e-12*H/truth.statics.H;
	error = fabs(here - c->relative_gap);
	if (!(error <= width) || !(fabs(0.5*(truth.omega[0][k] + truth.omega[0][k + 1])/c->omega - 1.0)
	                           <= width))
		trace_wrong(point, "the crossover at H %.17g has a gap of %.3e, stated %.3e", H, here,
		            c->relative_gap);
	if (c->kind == HAWSER_CROSSING && v == 0.0) {
		double side = 1e-6, omega = c->omega;
		int below, above;

		if ((k > 0 && truth.omega[0][k - 1] > omega*(1.0 - 3.0*side)) ||
		    truth.omega[0][k + 2] < omega*(1.0 + 3.0*side))
			return;
		below = truth_below(&truth, HAWSER_IN_PLANE, omega*(1.0 - side), k + 2);
		above = truth_below(&truth, HAWSER_IN_PLANE, omega*(1.0 + side), k + 2);
		if (below != k || above != k + 2)
			trace_wrong(point, "the crossing at H %.17g holds frequencies %d to %d, not %d and %d",
			            H, below + 1, above, k + 1, k + 2);
		return;
	}
	for (int way = -1; way < 2; way += 2) {
		struct truth beside;

		if (apparent(&beside.statics, &irvine->span, v, truth.statics.H*(1.0 + way*off)) ||
		    truth_solve(&beside, k + 3, 0))
			continue;
		if (!(gap_of(&beside, k) >= here*(1.0 - 1e-9) - width))
			trace_wrong(point, "the gap at H %.17g is %.17g, beside it %.17g", H, here,
			            gap_of(&beside, k));
	}
}

/* Level cable at rest: a branch keeps its symmetry. Its label may change where P becomes the dominant
 * component. */
static inline void symmetric(struct sweep_point *point, const struct trace *t)
{
	for (int b = 0; b < t->in; b++) {
		int known = -1;

		for (int i = 0; i < t->stations; i++) {
			int at = i*t->branches + b, here = t->symmetry[at];

			if (here == HAWSER_MIXED || trace_close(t, i, b))
				continue;
			here ^= t->family[at] == HAWSER_LONGITUDINAL;
			if (known >= 0 && here != known)
				trace_wrong(point, "branch %d changes its symmetry at station %d, H %.17g", b, i,
				            t->x[i]);
			known = here;
		}
	}
}

/* Crossings and narrow veerings of branches that both sweeps have must be in both sweeps. */
static inline void same_crossovers(struct sweep_point *point, const struct trace *t,
                            const struct trace *other)
{
	for (int i = 0; i < t->crossovers; i++) {
		const struct hawser_campbell_crossover *c = t->at + i;
		int found = c->below > t->in || c->above > t->in || c->relative_gap > 1e-3;

		for (int j = 0; j < other->crossovers; j++)
			found |= other->at[j].kind == c->kind && other->at[j].below == c->below &&
			         other->at[j].above == c->above &&
			         fabs(other->at[j].speed/c->speed - 1.0) < 1e-7 + c->relative_gap;
		if (!found)
			trace_wrong(point, "the %s of %d and %d at %.17g is not there with other steps",
			            hawser_crossover_name(c->kind), c->below, c->above, c->speed);
	}
}

static inline void again(struct sweep_point *point, const struct hawser_irvine *irvine,
                  const struct trace *t, struct hawser_irvine_options o, int step)
{
	struct hawser_report report = {.message = ""};
	struct hawser_irvine other;
	struct trace u;
	double from = o.from;
	enum hawser_status status;

	if (step < 0) {
		o.from = o.to;
		o.to = from;
	} else
		o.points = (o.points - 1)*step + 1;
	status = hawser_irvine_trace(&other, &irvine->span, &o, &report);
	if (status) {
		if (!strstr(report.message, "does not change"))
			trace_wrong(point, "refused with other steps (%d): %.300s", step, report.message);
		return;
	}
	u = of_irvine(&other);
	trace_same(point, t, &u, step);
	if (step > 0) {
		same_crossovers(point, t, &u);
		same_crossovers(point, &u, t);
	}
	trace_clear(&u);
	hawser_irvine_clear(&other);
}

static inline void judge_irvine(struct sweep_point *point, const struct hawser_irvine *irvine,
                         const struct hawser_irvine_options *o, int nth)
{
	static struct truth truth;
	struct trace t = of_irvine(irvine);
	int last = t.stations - 1, shown = sweep_long() ? 5 : 3;

	trace_sound(point, &t);
	trace_order(point, &t);
	placed(point, irvine, &t, o);
	for (int k = 0; k < shown; k++) {
		int i = k == 0 ? 0 : k == 1 ? last : (nth*37 + k*101) % t.stations;

		if (apparent(&truth.statics, &irvine->span, irvine->speed, t.x[i])) {
			trace_wrong(point, "no statics at station %d", i);
			break;
		}
		trace_station(point, &t, i, &truth);
	}
	for (int k = 0; k < t.crossovers && k < (sweep_long() ? 4 : 1); k++)
		crossover(point, irvine, irvine->crossover + (nth + k) % t.crossovers);
	if (irvine->span.h == 0.0 && irvine->speed == 0.0)
		symmetric(point, &t);
	if (o->points < 50 || (o->points < 500 && nth % 2 == 0))
		again(point, irvine, &t, *o, nth % 3 == 0 ? -1 : 2);
	trace_clear(&t);
}

/* --- the speed --- */

static inline struct trace of_campbell(const struct hawser_campbell *campbell)
{
	struct trace t = {.stations = campbell->stations, .branches = campbell->branches,
	                  .in = campbell->in_plane, .crossovers = campbell->crossovers,
	                  .omega = campbell->im, .residual = campbell->residual,
	                  .place = campbell->place, .family = campbell->family};

	trace_room(&t);
	for (int i = 0; i < t.stations; i++) {
		t.x[i] = campbell->station[i].speed;
		t.moved[i] = campbell->station[i].moved;
		if (!campbell->station[i].inserted)
			t.asked[t.points++] = i;
	}
	for (int i = 0; i < t.crossovers; i++)
		t.at[i] = campbell->crossover[i];
	return t;
}

static inline enum hawser_status steady(struct hawser_statics *st, const struct hawser_scene *scene,
                                 double speed)
{
	const struct hawser_span span = {scene->cable.EA, scene->cable.rho, scene->g, scene->span.d,
	                                 scene->span.h};
	const struct hawser_motion motion = {.speed = speed, .hold = scene->travel.hold};

	return hawser_statics_travel(st, &span, scene->tension.given, scene->tension.value,
	                             HAWSER_BRANCH_TAUT, &motion, NULL);
}

static inline void meeting(struct sweep_point *point, const struct hawser_scene *scene,
                    const struct hawser_campbell_crossover *c, int most, double limit)
{
	struct truth truth;
	double here, width, off = 1e-3*c->relative_gap + 1e-7;
	int k;

	most = c->above > most ? c->above : most;
	if (steady(&truth.statics, scene, c->speed) || (k = closest(&truth, c->omega, most + 2)) < 0) {
		trace_wrong(point, "no modes at the crossover, speed %.17g", c->speed);
		return;
	}
	here = gap_of(&truth, k);
	width = 4.0*truth.residual[0][k] + 1e-9*c->relative_gap + 1e-11;
	if (!(fabs(here - c->relative_gap) <= width))
		trace_wrong(point, "the crossover at %.17g m/s has a gap of %.3e, stated %.3e", c->speed,
		            here, c->relative_gap);
	for (int way = -1; way < 2; way += 2) {
		struct truth beside;

		if (c->speed*(1.0 + way*off) > limit ||
		    steady(&beside.statics, scene, c->speed*(1.0 + way*off)) ||
		    truth_solve(&beside, k + 3, 0))
			continue;
		if (!(gap_of(&beside, k) >= here*(1.0 - 1e-8) - width))
			trace_wrong(point, "the gap at %.17g m/s is %.17g, beside it %.17g", c->speed, here,
			            gap_of(&beside, k));
	}
}

static inline void judge_campbell(struct sweep_point *point, const struct hawser_campbell *campbell,
                           const struct hawser_scene *scene,
                                  struct hawser_campbell_options o, int nth)
{
	static struct truth truth;
	struct trace t = of_campbell(campbell), u;
	struct hawser_campbell fine;
	struct hawser_report report = {.message = ""};

	trace_sound(point, &t);
	trace_order(point, &t);
	if (campbell->criticals != (o.to >= campbell->limit) || campbell->unsure)
		trace_wrong(point, "%d critical speeds, %d unsure", campbell->criticals, campbell->unsure);
	for (int k = 0; k < (sweep_long() ? 4 : 2); k++) {
		int i = k == 0 ? 0 : k == 1 ? t.stations - 1 : (nth*37 + k*101) % t.stations;

		if (steady(&truth.statics, scene, t.x[i])) {
			trace_wrong(point, "no steady state at station %d", i);
			break;
		}
		trace_station(point, &t, i, &truth);
	}
	for (int k = 0; k < t.crossovers && k < (sweep_long() ? 4 : 1); k++)
		meeting(point, scene, t.at + (nth + k) % t.crossovers, t.in, campbell->limit);
	o.points = 2*o.points - 1;
	if ((sweep_long() && o.points < 50) || nth % 4 == 0) {
		if (hawser_campbell_trace(&fine, scene, &o, &report))
			trace_wrong(point, "refused with twice the steps: %.300s", report.message);
		else {
			u = of_campbell(&fine);
			trace_same(point, &t, &u, 2);
			same_crossovers(point, &t, &u);
			same_crossovers(point, &u, &t);
			trace_clear(&u);
			hawser_campbell_clear(&fine);
		}
	}
	trace_clear(&t);
}

#endif
