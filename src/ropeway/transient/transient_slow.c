/* ropeway/transient/transient_slow.c - the statics that a ropeway in motion has as its slow part:
 * without friction, at equidistant phases of the carriers.
 *
 * L_k    unstretched content of span k, between fixed places of two batteries
 * F      change of the chord of the free rope with the force at its beginning, m/N (2 by 2)
 * c_k    -dL/dT of a span with fixed ends: content that is added at B moves its end by stretch*t_B, so
 *        that the force at A changes by -F^-1 t_B stretch dL, and the tension by its part along t_A
 * C_k    the part of c_k that is not L/EA: by sag
 *
 * The flexibility is that of the exact catenaries (flight.c), not of a parabola.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/share.h"
#include "ropeway/statics/line.h"
#include "ropeway/transient/transient.h"

#define PI 3.14159265358979323846 /* to the digits of a double */

struct outcome {
	enum hawser_status status;
	struct hawser_report report;
};
/* Of one phase, before the means are taken. */
struct means {
	double *value;             /* [phases][2][spans][OF_SPAN] */
	int *turning;              /* [phases][2][towers] sheaves that are touched */
};
enum { LENGTH, ELASTIC, SAGGING, CHORD, TENSION, MASS, OF_SPAN };

struct task {
	struct hawser__slow *slow;
	const struct hawser__frame *frame;
	struct hawser_ropeway_options options;
	struct means means;
	struct outcome *outcome;   /* [phases] */
};

/* Flexibility of the free rope of a span. */
static void flexibility(double F[3], const struct hawser_line_statics *st, double S0, double S1)
{
	struct hawser__rope rope = hawser__line_rope(st->line);

	F[0] = F[1] = F[2] = 0.0;
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];
		struct hawser__rope_point at = {.x = {piece->x0[0], piece->x0[1]}, .S = fmax(piece->S0, S0)};
		double end = fmin(piece->S1, S1), angle = piece->angle0, T = piece->T0;

		if (piece->sheave >= 0 || !(end > at.S))
			continue;
		if (at.S > piece->S0)
			hawser_line_at(st, at.x, &angle, &T, NULL, NULL, at.S);
		at.P[0] = T*cos(angle);
		at.P[1] = T*sin(angle);
		hawser__fly(&at, F, &rope, end);
	}
}

static double compliance(const struct hawser_ropeway_span *span, const double F[3], double EA)
{
	double a[2] = {cos(span->angle_from), sin(span->angle_from)},
	       b[2] = {cos(span->angle_to), sin(span->angle_to)};
	double det = F[0]*F[2] - F[1]*F[1];
	double along = (a[0]*(F[2]*b[0] - F[1]*b[1]) + a[1]*(F[0]*b[1] - F[1]*b[0]))/det;

	return 1.0/(along*(1.0 + span->T_to/EA));
}

/* S of the rope at a fixed place of a battery, where its circle has the slope of the frame, found from
 * the ends of the contact along the circle. The middle of the contact would not do: it moves by half a
 * metre when the kink of a carrier reaches the battery, without any rope that passes. */
static double place(const struct hawser_ropeway_lane *lane, int tower,
                    const struct hawser__frame *frame)
{
	const struct hawser_ropeway_tower *at = &frame->ropeway->tower[tower];
	const struct hawser_ropeway_contact *c = &lane->contact[tower];
	double side = frame->side[tower], sum = 0.0;
	const double *point[2] = {lane->span[tower].to, lane->span[tower + 1].from};
	double S[2] = {lane->span[tower].S_to, lane->span[tower + 1].S_from};

	for (int i = 0; i < 2; i++) {
		double part = at->radius > 0.0 ? -side*(point[i][0] - at->at[0])/at->radius : 0.0;
		double slope = asin(fmax(-1.0, fmin(1.0, part)));
		double T = i ? c->T_out : c->T_in;

		sum += S[i] + (at->radius > 0.0 ? side*at->radius*(slope - frame->slope[tower]) /
		                                  (1.0 + T/lane->line->EA) : 0.0);
	}
	return 0.5*sum;
}

static double boundary(const struct hawser_ropeway_lane *lane, int k, int spans,
                       const struct hawser__frame *frame)
{
	return k == 0 ? 0.0 : k == spans ? lane->st.length0 : place(lane, k - 1, frame);
}

static void keep_span(struct hawser__slow_span *to, double *value,
                      const struct hawser_ropeway_lane *lane, int k, int spans,
                      const struct hawser__frame *frame)
{
	const struct hawser_ropeway_span *span = &lane->span[k];
	const struct hawser_line *line = lane->line;
	double F[3], total;
	double from = boundary(lane, k, spans, frame), till = boundary(lane, k + 1, spans, frame);

	flexibility(F, &lane->st, span->S_from, span->S_to);
	total = compliance(span, F, line->EA);
	*to = (struct hawser__slow_span){.content = till - from, .T_from = span->T_from,
		.T_to = span->T_to, .T_min = span->T_min, .T_max = span->T_max};
	value[LENGTH] = to->content;
	value[ELASTIC] = to->content/line->EA;
	value[SAGGING] = fmax(0.0, total - span->length0/line->EA);
	value[CHORD] = hypot(span->to[0] - span->from[0], span->to[1] - span->from[1]);
	value[TENSION] = 0.5*(span->T_from + span->T_to);
	value[MASS] = line->rho*span->length0;
	for (int i = 0; i < lane->carriers; i++)
		if (line->mass[i].S > from && line->mass[i].S <= till) {
			double shape = sin(PI*(line->mass[i].S - from)/(till - from));

			value[MASS] += 2.0*line->mass[i].mass*shape*shape; /* on average its mass */
		}
}

static void keep(struct task *task, const struct hawser_ropeway_statics *st, int phase)
{
	struct hawser__slow *slow = task->slow;
	size_t row = 2*(size_t)phase;

	slow->force[phase] = st->force;
	slow->travel[phase] = st->travel;
	slow->rest[phase] = st->loop0;
	for (int i = 0; i < 2; i++) {
		const struct hawser_ropeway_lane *lane = &st->lane[i];
		size_t first = (row + (size_t)i)*(size_t)slow->spans;

		slow->T_top[row + (size_t)i] = lane->st.T_B;
		for (int k = 0; k < slow->spans; k++) {
			keep_span(&slow->span[first + (size_t)k],
			          task->means.value + (first + (size_t)k)*OF_SPAN, lane, k, slow->spans,
			          task->frame);
			slow->rest[phase] -= slow->span[first + (size_t)k].content;
		}
		first = (row + (size_t)i)*(size_t)slow->towers;
		for (int k = 0; k < slow->towers; k++) {
			const struct hawser_ropeway_contact *c = &lane->contact[k];
			double half = 0.5*(c->angle_in - c->angle_out);

			slow->tower[first + (size_t)k] = (struct hawser__slow_tower){
				.pressing = c->pressing, .turn = 2.0*half,
				.normal = fabs(half) > 1e-6 ? c->pressing*half/sin(half) : c->pressing};
			task->means.turning[first + (size_t)k] = c->touches;
		}
	}
}

static void one_phase(void *context, long item, int worker)
{
	struct task *task = context;
	struct outcome *outcome = &task->outcome[item];
	struct hawser_ropeway_statics st;
	double phase = task->slow->spacing*(double)item/task->slow->phases;

	(void)worker;
	outcome->status = hawser__ropeway_state(&st, task->frame, &task->options, phase, &outcome->report);
	if (outcome->status)
		return;
	keep(task, &st, (int)item);
	hawser_ropeway_statics_clear(&st);
}

static void take_means(struct hawser__slow *slow, const struct task *task)
{
	double *to[OF_SPAN] = {slow->length, slow->elastic, slow->sagging, slow->chord, slow->tension,
	                       slow->mass};
	size_t spans = 2*(size_t)slow->spans, towers = 2*(size_t)slow->towers;

	for (size_t p = 0; p < (size_t)slow->phases; p++) {
		for (size_t k = 0; k < spans; k++)
			for (int j = 0; j < OF_SPAN; j++)
				to[j][k] += task->means.value[(p*spans + k)*OF_SPAN + (size_t)j]/slow->phases;
		for (size_t k = 0; k < towers; k++) {
			const struct hawser_ropeway_tower *tower =
				&task->frame->ropeway->tower[k%(size_t)slow->towers];
			double radius = tower->sheaves ? tower->sheave : tower->radius;

			if (tower->inertia > 0.0)
				slow->sheaves[k] += tower->inertia/(radius*radius) *
				                    task->means.turning[p*towers + k]/slow->phases;
		}
	}
}

static enum hawser_status allot(struct hawser__slow *slow, struct task *task,
                                struct hawser_report *report)
{
	size_t n = (size_t)slow->phases, spans = 2*(size_t)slow->spans, towers = 2*(size_t)slow->towers;
	double **mean[] = {&slow->length, &slow->elastic, &slow->sagging, &slow->chord, &slow->tension,
	                   &slow->mass};

	for (size_t i = 0; i < sizeof mean/sizeof *mean; i++)
		*mean[i] = hawser__hold(&slow->hold, spans, sizeof **mean[i]);
	slow->force = hawser__hold(&slow->hold, n, sizeof *slow->force);
	slow->travel = hawser__hold(&slow->hold, n, sizeof *slow->travel);
	slow->rest = hawser__hold(&slow->hold, n, sizeof *slow->rest);
	slow->T_top = hawser__hold(&slow->hold, 2*n, sizeof *slow->T_top);
	slow->span = hawser__hold(&slow->hold, n*spans, sizeof *slow->span);
	slow->tower = hawser__hold(&slow->hold, n*towers + 1, sizeof *slow->tower);
	slow->sheaves = hawser__hold(&slow->hold, towers + 1, sizeof *slow->sheaves);
	slow->side = hawser__hold(&slow->hold, towers + 1, sizeof *slow->side);
	task->means.value = calloc(n*spans*OF_SPAN, sizeof *task->means.value);
	task->means.turning = calloc(n*towers + 1, sizeof *task->means.turning);
	task->outcome = calloc(n, sizeof *task->outcome);
	return !slow->hold.short_of_memory && task->means.value && task->means.turning && task->outcome
	       ? HAWSER_OK : hawser__no_memory(report, "transient");
}

static enum hawser_status fill(struct task *task, int threads, struct hawser_report *report)
{
	struct hawser__slow *slow = task->slow;
	enum hawser_status status = allot(slow, task, report);

	if (!status)
		hawser__share(slow->phases, threads > 0 ? threads : hawser__processors(), one_phase, task);
	for (int i = 0; i < slow->phases && !status; i++)
		if (task->outcome[i].status) {
			status = task->outcome[i].status;
			if (report)
				*report = task->outcome[i].report;
		}
	if (status)
		return status;
	take_means(slow, task);
	for (int k = 0; k < slow->towers; k++)
		slow->side[k] = task->frame->side[k];
	for (int k = 0; k < 2*slow->spans; k++)
		if (!(slow->elastic[k] > 0.0 && isfinite(slow->sagging[k])))
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "transient",
			                    "lane %s, span %d: the rope is too slack for a stiffness along its "
			                    "chord: give a larger tension", k < slow->spans ? "up" : "down",
			                    k%slow->spans);
	return HAWSER_OK;
}

enum hawser_status hawser__slow_open(struct hawser__slow *slow, const struct hawser_ropeway *rw,
                                     const struct hawser_transient_options *options,
                                     struct hawser_report *report)
{
	const double *mass = rw->load_case[options->load_case].mass;
	struct hawser_ropeway rest = *rw;
	struct hawser__frame frame = {.ropeway = NULL};
	struct task task = {.slow = slow, .frame = &frame,
	                    .options = {.load_case = options->load_case, .tolerate = 1}};
	enum hawser_status status;

	memset(slow, 0, sizeof *slow);
	rest.sliding = HAWSER_ROPEWAY_REST;
	if (rw->tension == HAWSER_ROPEWAY_T0)
		rest.value = hawser__apparent(rw, rw->value, rw->speed);
	slow->spans = rw->towers + 1;
	slow->towers = rw->towers;
	slow->spacing = rw->spacing > 0.0 && (mass[0] > 0.0 || mass[1] > 0.0) ? rw->spacing : 0.0;
	slow->phases = slow->spacing > 0.0 ? options->phases : 1;
	status = hawser__frame_open(&frame, &rest, report);
	if (!status)
		status = hawser__frame_refer(&frame, report);
	if (!status)
		status = fill(&task, options->threads, report);
	hawser__frame_clear(&frame);
	free(task.means.value);
	free(task.means.turning);
	free(task.outcome);
	if (status)
		hawser__slow_clear(slow);
	return status;
}

void hawser__slow_clear(struct hawser__slow *slow)
{
	hawser__hold_clear(&slow->hold);
	memset(slow, 0, sizeof *slow);
}

enum hawser_status hawser__slow_now_open(struct hawser__slow_now *now, const struct hawser__slow *slow,
                                         struct hawser_report *report)
{
	now->span = calloc(2*(size_t)slow->spans, sizeof *now->span);
	now->tower = calloc(2*(size_t)slow->towers + 1, sizeof *now->tower);
	return now->span && now->tower ? HAWSER_OK : hawser__no_memory(report, "transient");
}

void hawser__slow_now_clear(struct hawser__slow_now *now)
{
	free(now->span);
	free(now->tower);
	now->span = NULL;
	now->tower = NULL;
}

static double mix(double a, double b, double part)
{
	return a + part*(b - a);
}

void hawser__slow_at(struct hawser__slow_now *now, const struct hawser__slow *slow, double phase)
{
	double at = slow->spacing > 0.0 ? phase/slow->spacing : 0.0, part;
	int a, b;

	at = (at - floor(at))*slow->phases;
	a = (int)at < slow->phases ? (int)at : 0;
	b = a + 1 < slow->phases ? a + 1 : 0;
	part = slow->spacing > 0.0 ? at - (int)at : 0.0;
	now->force = mix(slow->force[a], slow->force[b], part);
	now->travel = mix(slow->travel[a], slow->travel[b], part);
	now->rest = mix(slow->rest[a], slow->rest[b], part);
	for (int i = 0; i < 2; i++)
		now->T_top[i] = mix(slow->T_top[2*a + i], slow->T_top[2*b + i], part);
	for (int k = 0; k < 2*slow->spans; k++) {
		const struct hawser__slow_span *x = &slow->span[2*slow->spans*a + k],
		                               *y = &slow->span[2*slow->spans*b + k];

		now->span[k] = (struct hawser__slow_span){mix(x->content, y->content, part),
			mix(x->T_from, y->T_from, part), mix(x->T_to, y->T_to, part),
			mix(x->T_min, y->T_min, part), mix(x->T_max, y->T_max, part)};
	}
	for (int k = 0; k < 2*slow->towers; k++) {
		const struct hawser__slow_tower *x = &slow->tower[2*slow->towers*a + k],
		                                *y = &slow->tower[2*slow->towers*b + k];

		now->tower[k] = (struct hawser__slow_tower){mix(x->normal, y->normal, part),
			mix(x->pressing, y->pressing, part), mix(x->turn, y->turn, part)};
	}
}
