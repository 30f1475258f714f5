/* study/accuracy/certificate.c - folds and peaks of a net's model, corrected in its mesh.
 *
 * The motions of the model near a landmark are lifted to the mesh (rom/build/net_lift.c), and from
 * there the landmark of the mesh is found (certify.c) by harmonic balance of all its nodes
 * (net/balance). From that of a mesh with half as many elements, whose start is the first one at the
 * nodes of both, the error of second order by their length is taken out, as it is of the model. Four
 * more harmonics on the second mesh, a quarter of the work, tell what the others do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <hawser/certificate.h>
#include <hawser/integrate.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/hold.h"
#include "core/report.h"
#include "net/balance/balance.h"
#include "rom/build/net.h"
#include "study/accuracy/certify.h"
#include "study/accuracy/motions.h"

enum { LEAST = 5, MOST = 11, MORE = 4 };        /* harmonics */
enum { NEAR = 5 }; /* points of a curve between peaks of one resonance, at most; chosen */
enum { PHASES = 32, WIDTH = 2*(MOST + 1) + 1 }; /* of a motion of the model; coefficients */
static const double faint = 3e-5;  /* part of a motion by the harmonics that are left out; chosen */
static const double trusted = 0.1; /* part of a distance that more harmonics may be, */
static const double counted = 1e-4; /* of the least distance that counts; chosen */
static const double speed = 4e9;   /* operations per second with blocks, on a core of 2 GHz */
static const double chain = 12.7*33.0*33.0*33.0; /* of an inner node of a cable, with LEAST harmonics */
static const double factors = 5.0; /* matrices of the mesh for a landmark, those of the other meshes and
                                    * what is solved with them included */
static const double far_omega = 0.03; /* relative: another landmark; chosen */
static const double far_size = 0.35;

/* A mesh in equilibrium, and a motion with its tangent. */
struct finite {
	struct hawser__mesh *mesh;
	struct hawser__mesh_balance balance;
	const int *node;               /* [probes] nodes of the model's points */
	double *y, *along, bend;
	struct hawser__hold hold;
};

struct work {
	struct hawser_certificate *to;
	const struct hawser_rom *rom;
	const struct hawser_frf *frf;
	struct hawser_net fine, half;
	struct hawser__net_source source;
	struct hawser__answers answers;
	struct hawser__mesh coarse;
	int *from;                     /* [nodes of coarse] the same ones of the other mesh */
	int *node[2];                  /* [probes] nodes of the model's points, of both meshes */
	struct finite first, second, checked;
	double *row, *series;          /* [PHASES][unknowns], [unknowns][WIDTH] m */
	double *start[3];              /* [size of first] */
	double *u;                     /* [PHASES][n] */
	double worst;                  /* largest part of the last harmonics in a motion of the second mesh: */
	struct hawser_certified at;    /* its landmark, */
	double *worst_y, *worst_along, worst_bend; /* motion and tangent */
	struct hawser__hold hold, ordered; /* ordered: what depends on the number of harmonics */
};

static double now(void)
{
	struct timespec time;

	clock_gettime(CLOCK_MONOTONIC, &time);
	return (double)time.tv_sec + 1e-9*(double)time.tv_nsec;
}

/* --- the corrector of a mesh --- */

static void metric(void *of, const double *y)
{
	hawser__mesh_balance_metric(&((struct finite *)of)->balance, y);
}

static double dot(void *of, const double *a, const double *b)
{
	return hawser__mesh_balance_dot(&((struct finite *)of)->balance, a, b);
}

static void correct(void *of, double *y, double *along, int *lost, double far)
{
	hawser__mesh_balance_correct(&((struct finite *)of)->balance, y, along, lost, far);
}

/* x and its derivatives by the phase, of coefficients. */
static void at_phase(double x[3], const double *c, int order, double phase)
{
	x[0] = c[0];
	x[1] = x[2] = 0.0;
	for (int k = 1; k <= order; k++) {
		double a = c[2*k - 1], b = c[2*k], cosine = cos(k*phase), sine = sin(k*phase);

		x[0] += a*cosine + b*sine;
		x[1] += k*(b*cosine - a*sine);
		x[2] -= k*k*(a*cosine + b*sine);
	}
}

/* The phase at which |x| is largest: the best of some, then Newton's method for x' = 0. */
static double largest_at(const double *c, int order)
{
	int many = 16*(order + 1);
	double best = 0.0, most = -1.0, x[3];

	for (int t = 0; t < many; t++) {
		at_phase(x, c, order, 2.0*M_PI*t/many);
		if (fabs(x[0]) > most) {
			most = fabs(x[0]);
			best = 2.0*M_PI*t/many;
		}
	}
	for (int i = 0; i < 4; i++) {
		at_phase(x, c, order, best);
		best -= fabs(x[1]) < 0.1*fabs(x[2]) ? x[1]/x[2] : 0.0;
	}
	return best;
}

static double size_of(void *of, double *slope, const struct hawser_certified *peak, const double *y,
                      const double *along)
{
	const struct finite *finite = of;
	const struct hawser__mesh_balance *balance = &finite->balance;
	const double *c = hawser__mesh_balance_at(balance, y, finite->node[peak->probe], peak->axis);
	const double *t = hawser__mesh_balance_at(balance, along, finite->node[peak->probe], peak->axis);
	double x[3], rate[3], phase;

	*slope = 0.0;
	if (!c)
		return NAN;
	phase = largest_at(c, balance->order);
	at_phase(x, c, balance->order, phase);
	at_phase(rate, t, balance->order, phase);
	*slope = x[0] < 0.0 ? -rate[0] : rate[0];
	return fabs(x[0]);
}

static struct hawser__corrector corrector_of(struct finite *finite)
{
	return (struct hawser__corrector){.of = finite, .size = finite->balance.size, .metric = metric,
		.dot = dot, .correct = correct, .size_of = size_of};
}

/* --- meshes --- */

/* Damping ratios of the model's modes, of which phi [n][unknowns] are those of this mesh. */
static enum hawser_status set_ratio(struct finite *finite, const struct hawser__net_source *source,
                                    const double *phi, struct hawser_report *report)
{
	struct hawser__mesh_balance *balance = &finite->balance;
	size_t unknowns = (size_t)finite->mesh->unknowns, n = (size_t)source->n;
	double *mode = hawser__hold(&finite->hold, n*unknowns, sizeof *mode);
	double *rated = hawser__hold(&finite->hold, n, sizeof *rated);

	if (!mode || !rated)
		return hawser__no_memory(report, "certificate");
	for (size_t j = 0; j < n; j++) {
		double *own = mode + j*unknowns;

		hawser__eigen_mass(own, phi + j*unknowns, finite->mesh, 7U);
		cblas_dscal((int)unknowns, 1.0/sqrt(cblas_ddot((int)unknowns, own, 1, phi + j*unknowns, 1)),
		            own, 1);
		rated[j] = 2.0*source->net->ratio*source->modal.modes.omega[source->kept[j]];
	}
	balance->mode = mode;
	balance->rated = rated;
	balance->modes = source->n;
	balance->ratio = source->net->ratio;
	return HAWSER_OK;
}

static enum hawser_status open_finite(struct finite *finite, struct work *w, int second, int order,
                                      struct hawser_report *report)
{
	const struct hawser__net_source *source = &w->source;
	enum hawser_status status;
	double *phi = NULL;

	finite->mesh = second ? &w->coarse : &w->source.modal.mesh;
	finite->node = w->node[second];
	status = hawser__mesh_balance_open(&finite->balance, finite->mesh, source->net->mass_rate, order,
	                                   report);
	if (status)
		return status;
	finite->y = hawser__hold(&finite->hold, finite->balance.size, sizeof *finite->y);
	finite->along = hawser__hold(&finite->hold, finite->balance.size, sizeof *finite->along);
	if (second && source->net->ratio > 0.0)
		phi = hawser__hold(&finite->hold, (size_t)source->n*(size_t)finite->mesh->unknowns, sizeof *phi);
	if (finite->hold.short_of_memory)
		return hawser__no_memory(report, "certificate");
	for (int i = 0; phi && i < 3*source->n*finite->mesh->nodes; i++) {
		int j = i/(3*finite->mesh->nodes), node = i/3%finite->mesh->nodes, k = i%3;
		int at = finite->mesh->unknown[node][k];

		if (at >= 0)
			phi[j*finite->mesh->unknowns + at] = source->mode[
				(size_t)j*(size_t)source->modal.mesh.unknowns +
				(size_t)source->modal.mesh.unknown[w->from[node]][k]];
	}
	return source->net->ratio > 0.0 ? set_ratio(finite, source, phi ? phi : source->mode, report)
	                                : HAWSER_OK;
}

static void clear_finite(struct finite *finite)
{
	hawser__mesh_balance_clear(&finite->balance);
	hawser__hold_clear(&finite->hold);
	*finite = (struct finite){.mesh = NULL};
}

/* Nodes of the second mesh among those of the first. */
static void pair_nodes(struct work *w)
{
	const struct hawser__mesh *fine = &w->source.modal.mesh;

	for (int i = 0; i < w->fine.nodes; i++)
		w->from[i] = i;
	for (int c = 0; c < w->coarse.cables; c++) {
		int count = w->coarse.first[c + 1] - w->coarse.first[c];
		int ratio = (fine->first[c + 1] - fine->first[c])/count;

		for (int i = 1; i < count; i++)
			w->from[w->coarse.inner[c] + i - 1] = fine->inner[c] + ratio*i - 1;
	}
}

/* The second mesh, in equilibrium. */
static enum hawser_status open_second(struct work *w, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	const struct hawser__mesh_options choice = {.method = NULL};
	struct hawser__equilibrium found;
	double *T;
	enum hawser_status status = hawser__net_finer(&w->half, net, 1, report);

	if (!status)
		status = hawser__mesh_build(&w->coarse, &w->half, report);
	if (status)
		return status;
	T = hawser__hold(&w->hold, (size_t)w->coarse.elements, sizeof *T);
	w->from = hawser__hold(&w->hold, (size_t)w->coarse.nodes, sizeof *w->from);
	if (w->hold.short_of_memory)
		return hawser__no_memory(report, "certificate");
	status = hawser__mesh_form(&w->coarse, T, &found, &w->half, &choice, report);
	if (!status)
		status = hawser__net_multiples(&w->coarse, net->name, report);
	pair_nodes(w);
	return status;
}

/* The nodes of the model's points: all are nodes of both meshes. */
static enum hawser_status find_nodes(struct work *w, struct hawser_report *report)
{
	struct hawser__net_source *source = &w->source;
	size_t most = (size_t)(w->fine.nodes + 6*w->fine.cables);
	char **name = calloc(most, sizeof *name);
	enum hawser_status status = name ? hawser__net_places(source, name, report)
	                                 : hawser__no_memory(report, "certificate");

	for (size_t i = 0; name && i < most; i++)
		free(name[i]);
	free(name);
	w->node[0] = hawser__hold(&w->hold, most, sizeof *w->node[0]);
	w->node[1] = hawser__hold(&w->hold, most, sizeof *w->node[1]);
	if (!status && w->hold.short_of_memory)
		status = hawser__no_memory(report, "certificate");
	for (int p = 0; !status && p < source->shapes; p++) {
		w->node[0][p] = source->place[p].node[source->place[p].share > 0.5];
		for (int i = 0; i < w->coarse.nodes; i++)
			if (w->from[i] == w->node[0][p])
				w->node[1][p] = i;
	}
	return status;
}

/* --- starts --- */

/* The series of the displacements. */
static void transform(struct work *w)
{
	double project[PHASES*WIDTH];
	int unknowns = w->source.modal.mesh.unknowns;

	for (int i = 0; i < PHASES*WIDTH; i++) {
		int t = i/WIDTH, c = i%WIDTH, k = (c + 1)/2;
		double angle = 2.0*M_PI*(k*t%PHASES)/PHASES;

		project[i] = (c ? 2.0 : 1.0)/PHASES*(c > 0 && c%2 == 0 ? sin(angle) : cos(angle));
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, unknowns, WIDTH, PHASES, 1.0, w->row, unknowns,
	            project, WIDTH, 0.0, w->series, WIDTH);
}

/* Displacements of the mesh in a period of the model's motion from that state. */
static enum hawser_status lift(struct work *w, const double *state, double omega,
                               struct hawser_report *report)
{
	double period = 2.0*M_PI/omega;
	const struct hawser_integrate_options options = {.omega = omega, .until = period,
		.every = period/PHASES, .rtol = 1e-8, .atol = 1e-12, .initial = state};
	size_t n = (size_t)w->rom->n;
	struct hawser_trajectory run;
	enum hawser_status status = hawser_integrate(&run, w->rom, &options, report);

	for (size_t t = 0; !status && t < PHASES; t++)
		memcpy(w->u + t*n, run.state + 2*t*n, n*sizeof *w->u);
	hawser_trajectory_clear(&run);
	if (!status)
		status = hawser__net_lift(w->row, &w->source, &w->answers, w->u, PHASES, report);
	if (!status)
		transform(w);
	return status;
}

/* The highest harmonic that is not faint in the displacements. */
static int order_of(const struct work *w)
{
	double square[MOST + 2] = {0.0}, all = 0.0, rest;
	int order = MOST;

	for (int i = 0; i < w->source.modal.mesh.unknowns*WIDTH; i++) {
		square[(i%WIDTH + 1)/2] += w->series[i]*w->series[i];
		all += w->series[i]*w->series[i];
	}
	for (rest = square[MOST + 1]; order > LEAST; order--) {
		rest += square[order];
		if (rest > faint*faint*all)
			break;
	}
	return order;
}

static void take_start(double *y, const struct work *w, double omega)
{
	const struct hawser__mesh_balance *balance = &w->first.balance;
	const struct hawser__mesh *mesh = w->first.mesh;

	memset(y, 0, balance->size*sizeof *y);
	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			memcpy(y + (3*balance->blocks.row[i/3] + i%3)*balance->width,
			       w->series + mesh->unknown[i/3][i%3]*WIDTH, (size_t)balance->width*sizeof *y);
	y[balance->size - 1] = omega/w->rom->time;
}

/* --- landmarks --- */

/* The point of the curve nearest to a landmark, with points on both sides. */
static int point_of(const struct hawser_frf *frf, const struct hawser_landmark *landmark)
{
	int best = landmark->kind == HAWSER_LANDMARK_FOLD ? -1 : hawser__nearest_point(frf, landmark->arc);

	for (int i = 0; best < 0 && i < frf->events; i++)
		if (frf->event[i].kind == HAWSER_FOLD && frf->event[i].arc == landmark->arc) {
			best = frf->event[i].after;
			if (best + 1 < frf->points && fabs(frf->point[best + 1].omega - landmark->omega) <
			    fabs(frf->point[best].omega - landmark->omega))
				best++;
		}
	return best < 1 ? 1 : best > frf->points - 2 ? frf->points - 2 : best;
}

static void add(struct work *w, int *point, const struct hawser_landmark *landmark)
{
	struct hawser_certificate *to = w->to;

	if (to->count == HAWSER_CERTIFIED_MOST) {
		to->omitted++;
		return;
	}
	point[to->count] = point_of(w->frf, landmark);
	to->item[to->count++] = (struct hawser_certified){.kind = landmark->kind,
		.probe = landmark->probe, .axis = landmark->axis, .turn = landmark->turn,
		.omega = landmark->omega, .size = landmark->size, .exact_omega = NAN, .exact_size = NAN,
		.distance = NAN, .tension = NAN};
}

/* Whether no larger peak is of the same resonance. */
static int is_new(const struct work *w, const int *point, const struct hawser_landmark *peak)
{
	int own = point_of(w->frf, peak), good = 1;

	for (int i = 0; i < w->to->count; i++)
		good = good && (w->to->item[i].kind == HAWSER_LANDMARK_FOLD || abs(point[i] - own) > NEAR);
	return good;
}

static int larger(const void *a, const void *b)
{
	double x = ((const struct hawser_landmark *)a)->size, y = ((const struct hawser_landmark *)b)->size;

	return (x < y) - (x > y);
}

/* Those that are corrected, and points of the curve near them. */
static enum hawser_status choose(struct work *w, int *point, const struct hawser_landmark *peak,
                                 int peaks, struct hawser_report *report)
{
	struct hawser_landmark *fold, *sorted = calloc((size_t)peaks + 1, sizeof *sorted);
	int count = 0;
	enum hawser_status status = sorted ? hawser_landmarks(&fold, &count, w->frf, NULL, report)
	                                   : hawser__no_memory(report, "certificate");

	for (int i = 0; i < count && !status; i++)
		if (fold[i].kind == HAWSER_LANDMARK_FOLD)
			add(w, point, &fold[i]);
	if (!status) {
		free(fold);
		memcpy(sorted, peak, (size_t)peaks*sizeof *sorted);
		qsort(sorted, (size_t)peaks, sizeof *sorted, larger);
	}
	for (int i = 0; i < peaks && !status; i++)
		if (sorted[i].kind == HAWSER_LANDMARK_PEAK && sorted[i].probe >= 0 &&
		    is_new(w, point, &sorted[i]))
			add(w, point, &sorted[i]);
	free(sorted);
	return status;
}

/* --- one after the other --- */

/* The motion of one mesh or order, on another. from: the nodes there; NULL: the same. */
static void copy_motion(double *to, const struct finite *of, const double *y,
                        const struct finite *other, const int *from)
{
	int width = of->balance.width < other->balance.width ? of->balance.width : other->balance.width;

	memset(to, 0, of->balance.size*sizeof *to);
	for (int i = 0; i < 3*of->mesh->nodes; i++) {
		const double *own = hawser__mesh_balance_at(&other->balance, y, from ? from[i/3] : i/3, i%3);
		int row = of->balance.blocks.row[i/3];

		if (own && row >= 0)
			memcpy(to + (3*row + i%3)*of->balance.width, own, (size_t)width*sizeof *to);
	}
	to[of->balance.size - 1] = y[other->balance.size - 1];
}

/* Part of a motion by its two last harmonics. */
static double last_part(const struct finite *finite)
{
	int width = finite->balance.width;
	double all = 0.0, last = 0.0;

	for (size_t i = 0; i < finite->balance.size - 1; i++) {
		double own = finite->y[i]*finite->y[i];

		all += own;
		last += (int)(i%(size_t)width) >= width - 4 ? own : 0.0;
	}
	return sqrt(last/all);
}

/* The worse of the relative differences of two results; NAN: one of them is none. */
static double distance_of(double omega, double size, const struct hawser_certified *item)
{
	double off = fabs(item->exact_omega/omega - 1.0);

	return item->kind == HAWSER_LANDMARK_PEAK ? fmax(off, fabs(item->exact_size/size - 1.0)) : off;
}

static int is_found(const struct hawser_certified *item, double omega, double size)
{
	return fabs(item->exact_omega/omega - 1.0) < far_omega &&
	       (item->kind == HAWSER_LANDMARK_FOLD || fabs(log(item->exact_size/size)) < far_size);
}

/* The second mesh from the first one, whose error is taken out of the item. */
static enum hawser_status extrapolate(struct work *w, struct hawser_certified *item,
                                      struct hawser_report *report)
{
	const struct hawser__corrector corrector = corrector_of(&w->second);
	struct hawser_certified own = *item;
	enum hawser_status status;
	double part;

	copy_motion(w->second.y, &w->second, w->first.y, &w->first, w->from);
	copy_motion(w->second.along, &w->second, w->first.along, &w->first, w->from);
	w->second.bend = w->first.bend;
	status = hawser__certify_from(&own, w->second.y, w->second.along, &w->second.bend, &corrector,
	                              report);
	if (status || !is_found(&own, item->exact_omega, item->exact_size)) {
		w->to->extrapolated = 0;
		return status;
	}
	item->exact_omega = (4.0*item->exact_omega - own.exact_omega)/3.0;
	item->exact_size = (4.0*item->exact_size - own.exact_size)/3.0;
	part = last_part(&w->second);
	if (part > w->worst) {
		w->worst = part;
		w->at = own;
		w->worst_bend = w->second.bend;
		memcpy(w->worst_y, w->second.y, w->second.balance.size*sizeof(double));
		memcpy(w->worst_along, w->second.along, w->second.balance.size*sizeof(double));
	}
	return HAWSER_OK;
}

static enum hawser_status correct_one(struct work *w, struct hawser_certified *item, int point,
                                      struct hawser_report *report)
{
	const struct hawser__corrector corrector = corrector_of(&w->first);
	const struct hawser__neighbours near = {.y = w->start[1], .around = {w->start[0], w->start[2]}};
	double omega = item->omega/w->rom->time, size = item->size*w->rom->length; /* rad/s, m */
	enum hawser_status status = HAWSER_OK;
	int element = 0;

	for (int i = 0; i < 3 && !status; i++) {
		int p = point + i - 1;

		status = lift(w, w->frf->state + 2*(size_t)p*(size_t)w->rom->n, w->frf->point[p].omega, report);
		take_start(w->start[i], w, w->frf->point[p].omega);
	}
	w->first.balance.factored = 0;
	if (!status)
		status = hawser__certify_near(item, w->first.y, w->first.along, &w->first.bend, &corrector,
		                              &near, report);
	if (status || !is_found(item, omega, size)) {
		item->exact_omega = item->exact_size = NAN;
		w->to->refused += !status;
		return status;
	}
	item->tension = hawser__mesh_balance_tension(&w->first.balance, w->first.y, &element);
	item->cable = w->first.mesh->cable[element];
	w->second.balance.factored = 0;
	status = extrapolate(w, item, report);
	item->distance = distance_of(omega, size, item);
	item->exact_omega *= w->rom->time;
	item->exact_size /= w->rom->length;
	return status;
}

/* Four more harmonics, where the last ones are largest. */
static enum hawser_status add_harmonics(struct work *w, struct hawser_report *report)
{
	struct hawser__corrector corrector;
	struct hawser_certified own = w->at;
	enum hawser_status status;

	if (!(w->worst > 0.0))
		return HAWSER_OK;
	status = open_finite(&w->checked, w, 1, w->to->order + MORE, report);
	if (status)
		return status;
	corrector = corrector_of(&w->checked);
	copy_motion(w->checked.y, &w->checked, w->worst_y, &w->second, NULL);
	copy_motion(w->checked.along, &w->checked, w->worst_along, &w->second, NULL);
	status = hawser__certify_from(&own, w->checked.y, w->checked.along, &w->worst_bend, &corrector,
	                              report);
	w->to->harmonics = distance_of(w->at.exact_omega, w->at.exact_size, &own);
	return status;
}

static enum hawser_status correct_all(struct work *w, const int *point, struct hawser_report *report)
{
	struct hawser_certificate *to = w->to;
	enum hawser_status status = HAWSER_OK;

	to->distance = NAN;
	to->harmonics = w->worst = 0.0;
	to->refused = 0;
	to->extrapolated = 1;
	for (int i = 0; i < to->count && !status; i++) {
		status = correct_one(w, &to->item[i], point[i], report);
		to->distance = fmax(to->distance, to->item[i].distance);
	}
	return status ? status : add_harmonics(w, report);
}

/* --- all --- */

/* Both meshes, with the present number of harmonics. */
static enum hawser_status reopen(struct work *w, struct hawser_report *report)
{
	enum hawser_status status;

	clear_finite(&w->first);
	clear_finite(&w->second);
	clear_finite(&w->checked);
	hawser__hold_clear(&w->ordered);
	status = open_finite(&w->first, w, 0, w->to->order, report);
	if (!status)
		status = open_finite(&w->second, w, 1, w->to->order, report);
	for (int i = 0; i < 3 && !status; i++)
		w->start[i] = hawser__hold(&w->ordered, w->first.balance.size, sizeof *w->start[i]);
	w->worst_y = hawser__hold(&w->ordered, w->second.balance.size, sizeof *w->worst_y);
	w->worst_along = hawser__hold(&w->ordered, w->second.balance.size, sizeof *w->worst_along);
	return !status && w->ordered.short_of_memory ? hawser__no_memory(report, "certificate") : status;
}

static enum hawser_status open_meshes(struct work *w, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	struct hawser__mesh_blocks pattern;
	struct hawser__mesh *mesh = &w->source.modal.mesh;
	enum hawser_status status = hawser__mesh_blocks_open(&pattern, mesh, report);

	w->to->unknowns = mesh->unknowns;
	w->to->foreseen = factors*w->to->count*
	                  hawser__mesh_blocks_work(&pattern, 3*(2*w->to->order + 1))/speed;
	hawser__mesh_blocks_clear(&pattern);
	if (!status)
		status = open_second(w, net, report);
	if (!status)
		status = find_nodes(w, report);
	return status ? status : reopen(w, report);
}

/* The number of harmonics that the motions at the landmarks have. */
static enum hawser_status find_order(struct work *w, const int *point, struct hawser_report *report)
{
	size_t unknowns = (size_t)w->source.modal.mesh.unknowns;
	enum hawser_status status = HAWSER_OK;

	w->row = hawser__hold(&w->hold, PHASES*unknowns, sizeof *w->row);
	w->series = hawser__hold(&w->hold, WIDTH*unknowns, sizeof *w->series);
	w->u = hawser__hold(&w->hold, PHASES*(size_t)w->rom->n, sizeof *w->u);
	if (w->hold.short_of_memory)
		return hawser__no_memory(report, "certificate");
	for (int i = 0; i < w->to->count && !status; i++) {
		int order;

		status = lift(w, w->frf->state + 2*(size_t)point[i]*(size_t)w->rom->n,
		              w->frf->point[point[i]].omega, report);
		order = order_of(w);
		w->to->order = order > w->to->order ? order : w->to->order;
	}
	return status;
}

static void clear(struct work *w)
{
	clear_finite(&w->first);
	clear_finite(&w->second);
	clear_finite(&w->checked);
	hawser__answers_clear(&w->answers);
	hawser__net_source_clear(&w->source);
	hawser__mesh_clear(&w->coarse);
	free(w->fine.cable);
	free(w->half.cable);
	hawser__hold_clear(&w->ordered);
	hawser__hold_clear(&w->hold);
	free(w);
}

static enum hawser_status certify(struct work *w, const int *point, const struct hawser_net *net,
                                  const struct hawser_net_rom_options *options, double bearable,
                                  struct hawser_report *report)
{
	struct hawser_certificate *to = w->to;
	enum hawser_status status = hawser__net_source_open(&w->source, &w->fine, &w->answers, net, options,
	                                                    report);

	if (!status)
		status = find_order(w, point, report);
	if (!status)
		status = open_meshes(w, net, report);
	if (!status && bearable > 0.0 && to->foreseen > bearable)
		to->count = 0;
	if (!status && to->count > 0)
		status = correct_all(w, point, report);
	while (!status && to->harmonics > trusted*fmax(to->distance, counted) && to->order < MOST) {
		to->order = to->order + MORE < MOST ? to->order + MORE : MOST;
		status = reopen(w, report);
		if (!status)
			status = correct_all(w, point, report);
	}
	return status;
}

enum hawser_status hawser_net_certify(struct hawser_certificate *certificate,
                                      const struct hawser_net *net,
                                      const struct hawser_net_rom_options *options,
                                      const struct hawser_rom *rom, const struct hawser_frf *frf,
                                      const struct hawser_landmark *peak, int peaks, double bearable,
                                      struct hawser_report *report)
{
	double start = now(), elements = 0.0;
	struct work *w = calloc(1, sizeof *w);
	int point[HAWSER_CERTIFIED_MOST];
	enum hawser_status status = HAWSER_OK;

	*certificate = (struct hawser_certificate){.distance = NAN, .extrapolated = 1};
	if (!w)
		return hawser__no_memory(report, "certificate");
	w->to = certificate;
	w->rom = rom;
	w->frf = frf;
	if (frf->points > 2 && frf->period == 1)
		status = choose(w, point, peak, peaks, report);
	for (int c = 0; c < net->cables; c++)
		elements += net->cable[c].elements;
	certificate->foreseen = factors*certificate->count*elements*chain/speed;
	if (bearable > 0.0 && certificate->foreseen > bearable)
		certificate->count = 0;
	if (!status && certificate->count > 0)
		status = certify(w, point, net, options, bearable, report);
	clear(w);
	certificate->seconds = now() - start;
	return status;
}
