/* response/locus/locus_own.c - loci of autonomous models in two parameters: Hopf points, folds and
 * branch points of equilibria; folds, period doublings, tori and branch points of limit cycles.
 *
 *    P        a point of the locus, its parameters in units of their ranges
 *    line     through the predicted point, at right angles to the curve: there the bifurcation is that
 *             of a model with one parameter (own_line.c)
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., chapter 8.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <hawser/branches.h>

#include "continuation/curve.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/locus/locus_own.h"

#define BEND 0.3      /* rad between chords, at which a step is made again; chosen */
/* Step in which eigenvalues may change their kind, relative to the longest; chosen. */
#define UNEXPLAINED 0.01
#define ASIDE 0.01    /* of the line that gives the first direction, in longest steps; chosen */
#define TURNED 0.02   /* first step behind a cusp, in longest steps; chosen */
#define KNOWN 1e-6    /* distance of bifurcations that are one; chosen */
enum { FEWEST = 8 }; /* points of a closed curve; chosen */

/* --- lines --- */

static enum hawser_status model_on(void *context, const struct hawser_rom **rom, double t,
                                   struct hawser_report *report)
{
	const struct hawser__own_line *line = context;
	double p[2];

	for (int k = 0; k < 2; k++)
		p[k] = (line->base[k] + t*line->normal[k])*line->extent[k];
	return line->plane->model(line->plane->context, rom, p, report);
}

/* --- what is recorded --- */

static enum hawser_status add_point(struct hawser__own *own, const struct hawser__own_spot *spot,
                                    struct hawser_report *report)
{
	struct hawser__locus_list *list = own->list;
	size_t n = (size_t)own->line.n, k = (size_t)list->points;

	if (hawser__more(&list->point, list->points, sizeof *list->point) ||
	    hawser__more(&list->coordinate, list->points, n*sizeof(double)) ||
	    hawser__more(&list->state, list->points, 2*n*sizeof(double)))
		return hawser__no_memory(report, "locus");
	list->point[k] = (struct hawser_locus_point){
		.omega = spot->at[0]*own->line.extent[0], .parameter = spot->at[1]*own->line.extent[1],
		.angle = hawser__own_angle(spot), .own = spot->omega*own->time/spot->time,
		.l1 = own->line.kind == HAWSER_HOPF ? spot->test[HAWSER__OWN_DEGENERATE] : NAN,
		.arc = k ? list->point[k - 1].arc + hawser__own_distance(spot->at, own->here.at)
		         : 0.0,
		.mesh = spot->error, .unstable = spot->unstable, .iterations = 0};
	for (size_t j = 0; j < n; j++)
		list->coordinate[k*n + j] = fabs(spot->state[j]);
	memcpy(list->state + k*2*n, spot->state, 2*n*sizeof(double));
	list->points++;
	return HAWSER_OK;
}

/* --- the curve --- */

/* Whether the point is outside the ranges, and what part of the way to it is inside. */
static int outside(const struct hawser__own *own, double *part, enum hawser_locus_end *end)
{
	const double low[2] = {fmin(own->o->from, own->o->to),
		fmin(own->o->parameter_from, own->o->parameter_to)};

	*part = 1.0;
	for (int k = 0; k < 2; k++) {
		double from = low[k]/own->line.extent[k], a = own->here.at[k], b = own->next.at[k];
		double bound = b < from ? from : from + 1.0;

		if ((b < from || b > from + 1.0) && (bound - a)/(b - a) < *part) {
			*part = (bound - a)/(b - a);
			*end = k ? HAWSER_LOCUS_PARAMETER : HAWSER_LOCUS_OMEGA;
		}
	}
	return *part < 1.0;
}

/* The direction of the curve here, of length 1. */
static void set_along(struct hawser__own *own, double x, double y)
{
	double length = hypot(x, y);

	own->along[0] = x/length;
	own->along[1] = y/length;
}

static int is_closed(const struct hawser__own *own)
{
	return own->list->points > FEWEST && hawser__own_distance(own->next.at, own->start.at) <
	       0.6*hawser__own_distance(own->next.at, own->here.at) &&
	       (own->next.at[0] - own->here.at[0])*(own->start.at[0] - own->here.at[0]) +
	       (own->next.at[1] - own->here.at[1])*(own->start.at[1] - own->here.at[1]) > 0.0;
}

/* The last point, at the end of the ranges. */
static enum hawser_status end_at(struct hawser__own *own, double part, struct hawser_report *report)
{
	int found;
	enum hawser_status status = hawser__own_at(own, part, &found, report);

	if (status || !found)
		return status;
	hawser__own_copy(&own->next, &own->trial, own->line.n);
	status = hawser__own_specials(own, report);
	return status ? status : add_point(own, &own->next, report);
}

/* --- operations of continuation/curve.h --- */

static enum hawser_status prepare(void *owner, int *ended)
{
	struct hawser__own *own = owner;
	struct hawser_progress_state state = {.stage = "locus", .unit = "points",
		.done = own->locus->points + own->list->points};

	own->stopped |= hawser__told_to_stop(&own->o->progress, &state);
	own->list->end = own->stopped ? HAWSER_LOCUS_INTERRUPTED : HAWSER_LOCUS_MAX_POINTS;
	*ended = own->stopped || own->list->points >= own->o->max_points;
	return HAWSER_OK;
}

static int predict(void *owner, double ds)
{
	struct hawser__own *own = owner;
	double last = hawser__own_distance(own->prev.at, own->here.at);

	hawser__own_between(&own->next, &own->prev, &own->here, last > 0.0 ? 1.0 + ds/last : 1.0,
	                    own->line.n);
	for (int k = 0; k < 2; k++)
		own->next.at[k] = own->here.at[k] + ds*own->along[k];
	return 0;
}

static enum hawser_status correct(void *owner, double ds, struct hawser__correction *correction,
                                  int *failed)
{
	struct hawser__own *own = owner;
	double base[2] = {own->next.at[0], own->next.at[1]};
	int found;
	enum hawser_status status = hawser__own_across(own, &own->next, &found, base, own->along, ds,
	                                               own->report);

	*correction = (struct hawser__correction){.iterations = 1};
	*failed = !found;
	return status;
}

/* The tangent is the chord; the first one is not known well. */
static enum hawser_status finish(void *owner, double ds, double *angle)
{
	struct hawser__own *own = owner;
	double x = own->next.at[0] - own->here.at[0], y = own->next.at[1] - own->here.at[1];

	(void)ds;
	*angle = fabs(atan2(x*own->along[1] - y*own->along[0], x*own->along[0] + y*own->along[1]));
	if (own->list->points < 2)
		*angle = 0.0;
	return HAWSER_OK;
}

static enum hawser_status judge(void *owner, double ds, double angle, enum hawser__verdict *verdict)
{
	struct hawser__own *own = owner;
	int unexplained = !hawser__own_explained(own) && ds > UNEXPLAINED*own->o->step_max;
	/* beside a cusp the other fold */
	int other = own->line.kind == HAWSER_FOLD && own->here.vanish*own->next.vanish < 0.0;

	*verdict = angle >= BEND || unexplained || other ? HAWSER__SHORTEN : HAWSER__KEEP;
	return HAWSER_OK;
}

static double longest(void *owner)
{
	return ((struct hawser__own *)owner)->o->step_max;
}

static enum hawser_status arrive(void *owner, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct hawser__own *own = owner;
	double part;
	enum hawser_status status;

	(void)ds;
	(void)taken;
	*arrival = HAWSER__AT_END;
	if (outside(own, &part, &own->list->end))
		return end_at(own, part, own->report);
	if (is_closed(own)) {
		own->list->end = HAWSER_LOCUS_CLOSED;
		return add_point(own, &own->start, own->report);
	}
	status = hawser__own_specials(own, own->report);
	if (!status)
		status = add_point(own, &own->next, own->report);
	set_along(own, own->next.at[0] - own->here.at[0], own->next.at[1] - own->here.at[1]);
	hawser__own_copy(&own->prev, &own->here, own->line.n);
	hawser__own_copy(&own->here, &own->next, own->line.n);
	own->most = fmax(own->most, fabs(own->here.vanish));
	*arrival = HAWSER__GO_ON;
	return status;
}

static const struct hawser__curve_ops own_ops = {
	.prepare = prepare, .predict = predict, .correct = correct, .finish = finish, .judge = judge,
	.longest = longest, .arrive = arrive
};

/* Where the curve is lost. *again: it goes on from a cusp. */
static enum hawser_status end_curve(struct hawser__own *own, int *again, struct hawser_report *report)
{
	struct hawser__locus_list *list = own->list;
	enum hawser_status status;

	list->end = HAWSER_LOCUS_FAILED;
	snprintf(list->message, sizeof list->message, "no %s was found near the parameters %.9g, %.9g: the "
	         "curve may turn sharply or end there", hawser_event_name(own->line.kind),
	         own->here.at[0]*own->line.extent[0], own->here.at[1]*own->line.extent[1]);
	status = hawser__own_end(own, again, report);
	if (status || !*again || own->line.kind != HAWSER_FOLD) {
		*again = 0;
		return status;
	}
	/* on the other side of the cusp the fold is as far from it, and the coefficient is the negative */
	hawser__own_between(&own->next, &own->prev, &own->here,
	                    1.0 + 2.0*own->here.vanish/(own->prev.vanish - own->here.vanish), own->line.n);
	set_along(own, -own->along[0], -own->along[1]);
	status = hawser__own_across(own, &own->next, again, own->here.at, own->along, own->o->step_max,
	                            report);
	*again &= own->next.vanish*own->here.vanish > 0.0; /* not the same one again */
	if (status || !*again)
		return status;
	*list->message = '\0';
	hawser__own_copy(&own->here, &own->next, own->line.n);
	hawser__own_copy(&own->prev, &own->here, own->line.n);
	return add_point(own, &own->here, report);
}

static enum hawser_status follow(struct hawser__own *own, struct hawser__locus_list *list,
                                 const double tangent[2], int sign, struct hawser_report *report)
{
	struct hawser__curve curve = {.ops = &own_ops, .settings = &hawser__own_steps, .owner = own,
		.ds = own->o->step_max};
	enum hawser__outcome outcome;
	enum hawser_status status;

	int again = 1;

	own->list = list;
	own->report = report;
	set_along(own, sign*tangent[0], sign*tangent[1]);
	hawser__own_copy(&own->here, &own->start, own->line.n);
	hawser__own_copy(&own->prev, &own->start, own->line.n);
	if (own->along[1] < 0.0) /* t is the other way than at the start */
		own->here.vanish *= -1.0;
	own->most = fabs(own->here.vanish);
	status = add_point(own, &own->here, report);
	while (!status && again) {
		status = hawser__curve_follow(&curve, &outcome);
		again = !status && outcome == HAWSER__LOST;
		if (again)
			status = end_curve(own, &again, report);
		curve.ds = TURNED*own->o->step_max;
	}
	return status;
}

/* --- where curves begin --- */

/* The event of the response, whose parameter is the first one. */
static void begin(struct hawser__own *own, const struct hawser_frf *frf, int e)
{
	const struct hawser_frf_event *event = &frf->event[e];
	size_t m = 2*(size_t)own->line.n;

	own->line.cycles = frf->point[0].omega > 0.0;
	own->line.steps = own->line.gone = 0;
	own->start.at[0] = event->parameter/own->line.extent[0];
	own->start.at[1] = own->o->at/own->line.extent[1];
	own->start.omega = event->kind == HAWSER_HOPF || own->line.cycles ? event->omega : 0.0;
	own->start.angle = 0.0;
	memcpy(own->start.state, frf->event_state + m*(size_t)e, m*sizeof(double));
}

/* Whether a curve passes there, at a point of it or between two. */
static int is_there(const struct hawser_locus *locus, const double extent[2], const double at[2])
{
	for (int i = 0; i < locus->points; i++)
		if (hypot(locus->point[i].omega/extent[0] - at[0],
		          locus->point[i].parameter/extent[1] - at[1]) < KNOWN)
			return 1;
	for (int e = 0; e < locus->events; e++)
		if (locus->event[e].kind == HAWSER_LOCUS_START &&
		    fabs(locus->event[e].omega/extent[0] - at[0]) < KNOWN)
			return 1;
	return 0;
}

/* The direction of the curve at the start, from a line beside the one that met it; along the first
 * parameter if that line meets nothing near. */
static enum hawser_status aim(struct hawser__own *own, double tangent[2], struct hawser_report *report)
{
	const double along[2] = {0.0, 1.0};
	double side = own->start.at[1]*own->line.extent[1] <
	              0.5*(own->o->parameter_from + own->o->parameter_to) ? 1.0 : -1.0;
	double base[2] = {own->start.at[0], own->start.at[1] + side*ASIDE*own->o->step_max};
	int found;
	enum hawser_status status;

	hawser__own_copy(&own->next, &own->start, own->line.n);
	status = hawser__own_across(own, &own->next, &found, base, along, own->o->step_max, report);
	for (int k = 0; k < 2; k++)
		tangent[k] = found ? own->next.at[k] - own->start.at[k] : !k;
	return status;
}

/* The curve through the event. */
static enum hawser_status trace_one(struct hawser__own *own, const struct hawser_frf *frf, int e,
                                    struct hawser_report *report)
{
	struct hawser__locus_list part[2] = {{.points = 0}, {.points = 0}};
	const double along[2] = {0.0, 1.0};
	double tangent[2];
	int found;
	enum hawser_status status;

	begin(own, frf, e);
	if (is_there(own->locus, own->line.extent, own->start.at))
		return HAWSER_OK;
	status = hawser__own_across(own, &own->start, &found, (double[2]){own->start.at[0],
	                            own->start.at[1]}, along, own->o->step_max, report);
	if (status)
		return status;
	if (!found) {
		if (hawser__more(&own->locus->lost_at, own->locus->lost, sizeof *own->locus->lost_at))
			return hawser__no_memory(report, "locus");
		own->locus->lost_at[own->locus->lost++] = frf->event[e].parameter;
		return HAWSER_OK;
	}
	status = aim(own, tangent, report);
	for (int side = 0; side < 2 && !status && !own->stopped; side++)
		if (side == 0 || part[0].end != HAWSER_LOCUS_CLOSED)
			status = follow(own, &part[side], tangent, side ? -1 : 1, report);
	if (!status)
		status = hawser__locus_join(own->locus, part, report);
	for (int side = 0; side < 2; side++)
		hawser__locus_list_clear(&part[side]);
	return status;
}

static enum hawser_status trace_events(struct hawser__own *own, const struct hawser_frf *frf, int *any,
                                       struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	double best = INFINITY, near = own->o->near;
	int only = -1;

	for (int e = 0; e < frf->events && near != 0.0; e++)
		if (frf->event[e].kind == own->o->kind && fabs(frf->event[e].parameter - near) < best) {
			best = fabs(frf->event[e].parameter - near);
			only = e;
		}
	for (int e = 0; e < frf->events && !status && !own->stopped; e++) {
		if (frf->event[e].kind != own->o->kind || !frf->event[e].located || (only >= 0 && e != only))
			continue;
		*any = 1;
		status = trace_one(own, frf, e, report);
	}
	return status;
}

/* The cycles that begin at the Hopf points of the equilibria, or beside them. */
static enum hawser_status trace_cycles(struct hawser__own *own, int *any,
                                       const struct hawser_frf_options *choice,
                                       const struct hawser_rom *rom, struct hawser_report *report)
{
	const struct hawser_frf *rests = &own->locus->response;
	enum hawser_status status = HAWSER_OK;
	int hopf = 0, unstable = 0;

	for (int i = 0; i < rests->points; i++)
		unstable |= rests->point[i].unstable > 0;
	for (int e = 0; e <= rests->events && !status; e++) {
		struct hawser_frf cycles = {.n = 0};
		int last = e == rests->events;

		if (last ? hopf || !unstable : rests->event[e].kind != HAWSER_HOPF)
			continue;
		hopf = 1;
		status = hawser_branch_switch(&cycles, rom, rests, last ? -1 : e, choice, report);
		if (status == HAWSER_ERR_CONVERGENCE)
			status = HAWSER_OK;
		if (!status && cycles.points > 0)
			status = trace_events(own, &cycles, any, report);
		hawser_frf_clear(&cycles);
	}
	return status;
}

static enum hawser_status open_own(struct hawser__own *own, const struct hawser_rom *rom,
                                   struct hawser_report *report)
{
	struct hawser__own_spot *spot[] = {&own->prev, &own->here, &own->next, &own->trial, &own->start};
	size_t m = 2*(size_t)rom->n;

	own->line.n = rom->n;
	own->time = rom->time;
	for (size_t i = 0; i < sizeof spot/sizeof *spot; i++)
		spot[i]->state = hawser__hold(&own->hold, m, sizeof(double));
	own->line.family = (struct hawser_rom_family){0.0, model_on, &own->line};
	return own->hold.short_of_memory ? hawser__no_memory(report, "locus") : HAWSER_OK;
}

enum hawser_status hawser__own_locus(struct hawser_locus *locus,
                                     const struct hawser_locus_options *o,
                                     struct hawser_report *report)
{
	struct hawser__own own = {.o = o, .locus = locus,
		.line = {.plane = o->plane, .kind = o->kind, .tolerance = o->tolerance,
		         .extent = {fabs(o->to - o->from), fabs(o->parameter_to - o->parameter_from)}}};
	struct hawser__own_line first = own.line;
	struct hawser_frf_options choice = {.from = o->from, .to = o->to, .samples = HAWSER_NONE,
		.family = &first.family, .tolerance = o->tolerance};
	const struct hawser_rom *rom;
	int any = 0;
	enum hawser_status status;

	/* the response is one on the line along the first parameter, in its own units */
	first.extent[0] = 1.0;
	first.base[1] = o->at/first.extent[1];
	first.normal[0] = 1.0;
	first.family = (struct hawser_rom_family){0.0, model_on, &first};
	status = first.family.model(&first, &rom, o->from, report);
	if (!status)
		status = open_own(&own, rom, report);
	locus->n = status ? 0 : rom->n;
	if (!status)
		status = hawser_frf_trace(&locus->response, rom, &choice, report);
	if (status == HAWSER_ERR_CONVERGENCE && locus->response.points > 0)
		status = HAWSER_OK;
	if (!status)
		status = trace_events(&own, &locus->response, &any, report);
	if (!status && !any && o->kind != HAWSER_HOPF)
		status = trace_cycles(&own, &any, &choice, rom, report);
	if (!status && !any && !own.stopped)
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "locus",
		                      "at the parameter %.9g neither equilibria nor the limit cycles that "
		                      "begin at them have a %s in this range: begin at another value "
		                      "(--at), or change the range", o->at, hawser_event_name(o->kind));
	else if (!status && locus->curves == 0 && !own.stopped)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "locus",
		                      "no curve could be begun at the %s; begin at another value (--at)",
		                      hawser_event_name(o->kind));
	locus->interrupted = own.stopped;
	hawser__hold_clear(&own.hold);
	return status;
}
