/* net/span/span.c - the cable of a span as a net; see hawser/net_span.h.
 *
 * S, s    unstretched arclength from end A, m, and scaled: S/d
 * F_a, F_b  forces of a load f(S) per length on the ends a, b of an element: the integrals of f
 *         times (S_b - S)/(S_b - S_a) and (S - S_a)/(S_b - S_a)
 *
 * Halves of the load on each end would be as good where it is smooth; the integrals are of order 2
 * also where a load ends within an element, and they leave a force at a point where it acts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/span/span.h"
#include "statics/frame.h"
#include "statics/load.h"
#include "statics/wind.h"

enum { ELEMENTS = 120, MOST = 1000000 };
static const char where[] = "net";

void hawser_net_span_settle(struct hawser_net_span_options *options)
{
	if (options->elements == 0)
		options->elements = ELEMENTS;
}

/* --- what a mesh does not have --- */

/* *key: the first key of the scene without counterpart, with the reason; NULL if there is none. */
static const char *at_rest(const char **key, const struct hawser_scene *scene)
{
	*key = "beam";
	if (scene->beam.form != HAWSER_BEAM_NONE)
		return "a mesh of cable elements has no travelling beam";
	*key = "travel";
	if (scene->travel.present)
		return "a mesh of cable elements does not travel";
	*key = "cable.EA";
	if (!isfinite(scene->cable.EA))
		return "cable elements are elastic: give a finite EA";
	*key = "cable.EI";
	if (scene->cable.EI > 0.0)
		return "cable elements have no bending stiffness";
	for (int end = 0; end < 2; end++)
		for (int k = 0; k < 3; k++) {
			*key = end ? "support.B.stiffness" : "support.A.stiffness";
			if (scene->support[end].present && isfinite(scene->support[end].stiffness[k]))
				return "the ends of a mesh of cable elements are not on springs";
		}
	return NULL;
}

static const char *damped(const char **key, const struct hawser_scene *scene)
{
	*key = "damping.rayleigh";
	if (scene->damping.kind == HAWSER_DAMPING_RAYLEIGH)
		return "a mesh of cable elements has viscous damping only: give damping.alpha";
	*key = "damping.ratio";
	if (scene->damping.kind == HAWSER_DAMPING_RATIO)
		return "a mesh of cable elements has no modal damping: give damping.alpha";
	*key = "damping.drag";
	if (scene->damping.drag > 0.0)
		return "a mesh of cable elements has no quadratic drag";
	*key = "wind";
	if (scene->wind.present)
		return "a mesh of cable elements does not feel the wind change as it moves";
	return NULL;
}

static const char *attached(const struct hawser_attachment *attach, const char **member)
{
	*member = attach->damper_to ? "damper_to" : "absorber_cubic";
	return attach->damper_to || attach->absorber_cubic > 0.0
		? "dampers of a mesh of cable elements are to the ground, and its absorbers linear" : NULL;
}

static enum hawser_status refuse(const struct hawser_scene *scene, int still,
                                 struct hawser_report *report)
{
	const char *key, *reason = at_rest(&key, scene), *member;

	if (!reason && !still)
		reason = damped(&key, scene);
	if (reason)
		return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s: %s: %s", scene->name, key,
		                    reason);
	for (int i = 0; i < scene->attachments && !reason; i++) {
		reason = attached(&scene->attach[i], &member);
		if (reason)
			return hawser__fail(report, HAWSER_ERR_SCENE, where, "%s: attach.%d.%s: %s",
			                    scene->name, i, member, reason);
	}
	return HAWSER_OK;
}

static int moves(const struct hawser_scene *scene)
{
	int any = 0;

	for (int i = 0; i < 6; i++)
		any |= scene->support[i/3].present && scene->support[i/3].motion[i % 3] != 0.0;
	return any;
}

static enum hawser_status check(const struct hawser_scene *scene,
                                const struct hawser_net_span_options *options,
                                struct hawser_report *report)
{
	if (options->elements < 2 || options->elements > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the number of elements of the cable is 2 to %d, not %d", MOST,
		                    options->elements);
	if (!options->still && (hawser__loaded(scene) || moves(scene)) &&
	    !(options->Omega > 0.0 && isfinite(options->Omega)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%s: the load or the motion of the ends needs a positive frequency "
		                    "Omega", scene->name);
	return refuse(scene, options->still, report);
}

/* --- nodes and cables --- */

static enum hawser_status allocate(struct hawser_net *net, const struct hawser_scene *scene,
                                   const struct hawser_statics *st, int harmonics,
                                   struct hawser_report *report)
{
	size_t pieces = (size_t)st->attachments + 1;

	net->name = strdup(scene->name);
	net->node = calloc(pieces + 1, sizeof *net->node);
	net->cable = calloc(pieces, sizeof *net->cable);
	net->absorber = calloc(pieces, sizeof *net->absorber);
	net->load = calloc(pieces*(HAWSER__SPAN_LOADS + (size_t)harmonics), sizeof *net->load);
	net->motion = calloc(2, sizeof *net->motion);
	return net->name && net->node && net->cable && net->absorber && net->load && net->motion
		? HAWSER_OK : hawser__no_memory(report, where);
}

/* Elements of a part of the cable: of several parts a multiple of two units, so that a mesh with half
 * of them has elements twice as long everywhere. */
static int share(int elements, double part, int parts, int unit, int halved)
{
	int half = unit*(int)fmax(round(0.5*elements*part/unit), 1.0);

	return parts == 1 ? elements/(halved ? 2 : 1) : half*(halved ? 1 : 2);
}

/* The cable from S = from to S = to, and what is constant. */
static void cable(struct hawser_net *net, const struct hawser_scene *scene,
                  const struct hawser_statics *st, int i, double from, double to, int elements)
{
	struct hawser_net_cable *one = &net->cable[net->cables++];
	int last = st->attachments;
	double still[3];

	if (last == 0)
		snprintf(one->name, sizeof one->name, "cable");
	else
		snprintf(one->name, sizeof one->name, "cable_%d", i + 1);
	one->from = i == 0 ? 0 : i + 1;
	one->to = i == last ? 1 : i + 2;
	one->EA = st->span.EA;
	one->rho = st->span.rho;
	one->given = HAWSER_NET_LENGTH0;
	one->value = to - from;
	one->elements = elements;
	if (hawser__static_load(still, scene)) {
		struct hawser_net_load *load = &net->load[net->loads++];

		load->node = -1;
		load->cable = i;
		memcpy(load->value, still, sizeof load->value);
	}
}

static void absorb(struct hawser_net *net, const struct hawser_attachment *from, const char *name,
                   int node)
{
	struct hawser_net_absorber *to = &net->absorber[net->absorbers++];
	double length = hawser__norm(from->absorber_direction);

	*to = (struct hawser_net_absorber){.node = node, .mass = from->absorber_mass,
		.stiffness = from->absorber_stiffness, .damping = from->absorber_damping};
	memcpy(to->name, name, sizeof to->name);
	for (int k = 0; k < 3; k++)
		to->direction[k] = from->absorber_direction[k]/length;
}

static void attach(struct hawser_net *net, const struct hawser_scene *scene,
                   const struct hawser_statics *st, int i)
{
	const struct hawser_attached *at = &st->attached[i];
	const struct hawser_attachment *from = &scene->attach[at->index];
	struct hawser_net_node *node = &net->node[i + 2];
	struct hawser_net_load *load = &net->load[net->loads++];

	if (*from->name)
		memcpy(node->name, from->name, sizeof node->name);
	else
		snprintf(node->name, sizeof node->name, "attach_%d", at->index);
	node->mass = at->mass;
	memcpy(node->spring, from->spring, sizeof node->spring);
	memcpy(node->damper, from->damper, sizeof node->damper);
	if (from->absorber_mass > 0.0)
		absorb(net, from, node->name, i + 2);
	load->node = i + 2;
	load->cable = -1;
	memcpy(load->value, from->force, sizeof load->value);
}

static void chain(struct hawser_net *net, const struct hawser_scene *scene,
                  const struct hawser_statics *st, int elements, int unit, int halved)
{
	int parts = st->attachments + 1;
	double from = 0.0;

	net->nodes = st->attachments + 2;
	net->g = scene->g;
	for (int end = 0; end < 2; end++) {
		struct hawser_net_node *node = &net->node[end];

		snprintf(node->name, sizeof node->name, "%c", "AB"[end]);
		node->placed = node->support = 1;
		memset(node->held, 1, sizeof node->held);
	}
	net->node[1].x[0] = scene->span.d;
	net->node[1].x[1] = scene->span.h;
	for (int i = 0; i <= st->attachments; i++) {
		double to = i < st->attachments ? st->attached[i].S : st->length0;

		cable(net, scene, st, i, from, to,
		      share(elements, (to - from)/st->length0, parts, unit, halved));
		if (i < st->attachments)
			attach(net, scene, st, i);
		from = to;
	}
}

/* --- the load --- */

/* Force per length of harmonic h at s, along x, y, z. */
static void force_at(double f[3], const struct hawser__piece *piece,
                     const struct hawser__loads *loads, int h, const struct hawser_statics *st,
                     double s)
{
	struct hawser_frame_point at = hawser_statics_frame(st, s);
	double local[3], v[3];

	hawser__piece_at(local, piece, loads, h, st, s);
	hawser__frame_out(v, &at, local);
	hawser_statics_to_global(st, f, v);
}

/* Add the forces of a piece on the ends of the element between a and b, scaled. */
static void element(double F[2][3], const struct hawser__piece *piece,
                    const struct hawser__loads *loads, int h, const struct hawser_statics *st,
                    double a, double b)
{
	static const double node[] = {-0.7745966692414834, 0.0, 0.7745966692414834},
	                    weight[] = {5.0/9.0, 8.0/9.0, 5.0/9.0};
	double from = fmax(a, piece->from), to = fmin(b, piece->to), f[3];
	int parts = 1 + (int)(fabs(piece->kappa)*(to - from)/HAWSER__LOAD_STEP);

	for (int p = 0; p < parts && from < to; p++)
		for (int i = 0; i < 3; i++) {
			double half = 0.5*(to - from)/parts, s = from + half*(2.0*p + 1.0 + node[i]);
			double w = weight[i]*half*st->span.d, part = (s - a)/(b - a);

			force_at(f, piece, loads, h, st, s);
			for (int k = 0; k < 3; k++) {
				F[0][k] += (1.0 - part)*w*f[k];
				F[1][k] += part*w*f[k];
			}
		}
}

/* A force at a point: within [a, b), or at the end of the cable. */
static void point(double F[2][3], const struct hawser__piece *piece,
                  const struct hawser__loads *loads, int h, const struct hawser_statics *st, double a,
                  double b, int last)
{
	double f[3], part = (piece->from - a)/(b - a);

	if (piece->from < a || (last ? piece->from > b : piece->from >= b))
		return;
	force_at(f, piece, loads, h, st, piece->from);
	for (int k = 0; k < 3; k++) {
		F[0][k] += (1.0 - part)*st->span.d*f[k];
		F[1][k] += part*st->span.d*f[k];
	}
}

/* Harmonic h of the loads on the cable c, which begins at S = from. */
static enum hawser_status harmonic(struct hawser_net *net, const struct hawser__loads *loads, int h,
                                   const struct hawser_statics *st, int c, double from, double Omega,
                                   struct hawser_report *report)
{
	struct hawser_net_load *load = &net->load[net->loads];
	int n = net->cable[c].elements, end = c == net->cables - 1;
	double step = net->cable[c].value/n/st->span.d, begin = from/st->span.d;

	*load = (struct hawser_net_load){.node = -1, .cable = c, .harmonic = 1,
		.Omega = loads->k[h]*Omega, .phase = loads->sine[h] ? -M_PI/2.0 : 0.0};
	load->along = calloc((size_t)n + 1, sizeof *load->along);
	if (!load->along)
		return hawser__no_memory(report, where);
	net->loads++;
	for (int i = 0; i < loads->count; i++) {
		const struct hawser__piece *piece = &loads->piece[i];

		for (int e = 0; e < n && piece->harmonic[loads->sine[h]] == h; e++) {
			double a = begin + e*step, b = e < n - 1 ? begin + (e + 1)*step
				: (from + net->cable[c].value)/st->span.d;

			if (piece->from < piece->to)
				element(load->along + e, piece, loads, h, st, a, b);
			else
				point(load->along + e, piece, loads, h, st, a, b, end && e == n - 1);
		}
	}
	return HAWSER_OK;
}

static enum hawser_status load(struct hawser_net *net, const struct hawser__loads *loads,
                               const struct hawser_statics *st, double Omega,
                               struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int h = 0; h < loads->harmonics; h++) {
		double from = 0.0;

		for (int c = 0; c < net->cables && !status; c++) {
			status = harmonic(net, loads, h, st, c, from, Omega, report);
			from += net->cable[c].value;
		}
	}
	return status;
}

static void move(struct hawser_net *net, const struct hawser_scene *scene, double Omega)
{
	for (int end = 0; end < 2; end++) {
		const double *x = scene->support[end].motion;
		struct hawser_net_load *motion = &net->motion[net->motions];

		if (!scene->support[end].present || (x[0] == 0.0 && x[1] == 0.0 && x[2] == 0.0))
			continue;
		net->motions++;
		*motion = (struct hawser_net_load){.node = end, .cable = -1, .harmonic = 1,
			.Omega = scene->support[end].harmonic*Omega, .phase = scene->support[end].phase};
		memcpy(motion->value, x, sizeof motion->value);
	}
}

enum hawser_status hawser__net_span(struct hawser_net *net, const struct hawser_scene *scene,
                                    const struct hawser_statics *st,
                                    const struct hawser_net_span_options *options, int unit,
                                    int halved, struct hawser_report *report)
{
	struct hawser_net_span_options choice = {0};
	struct hawser__loads loads = {.count = 0};
	enum hawser_status status;

	memset(net, 0, sizeof *net);
	if (options)
		choice = *options;
	hawser_net_span_settle(&choice);
	status = check(scene, &choice, report);
	if (!status)
		status = hawser__loads_make(&loads, st, choice.still ? NULL : scene, report);
	if (!status)
		status = allocate(net, scene, st, loads.harmonics, report);
	if (!status)
		chain(net, scene, st, choice.elements, unit, halved);
	net->dynamics.rho_inf = -1.0;
	if (!status && !choice.still) {
		net->alpha = scene->damping.kind == HAWSER_DAMPING_ALPHA ? scene->damping.alpha : 0.0;
		move(net, scene, choice.Omega);
		status = load(net, &loads, st, choice.Omega, report);
	}
	hawser__loads_clear(&loads);
	if (status)
		hawser_net_clear(net);
	return status;
}

enum hawser_status hawser_net_span(struct hawser_net *net, const struct hawser_scene *scene,
                                   const struct hawser_statics *st,
                                   const struct hawser_net_span_options *options,
                                   struct hawser_report *report)
{
	return hawser__net_span(net, scene, st, options, 1, 0, report);
}

void hawser__net_span_place(int *cable, double *part, const struct hawser_net *net, double S)
{
	double from = 0.0;
	int c = 0;

	while (c < net->cables - 1 && S > from + net->cable[c].value)
		from += net->cable[c++].value;
	*cable = c;
	*part = fmin(fmax((S - from)/net->cable[c].value, 0.0), 1.0);
}
