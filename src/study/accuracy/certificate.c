/* study/accuracy/certificate.c - folds and peaks of a net's model, corrected in its mesh.
 *
 * The motions of the model near a landmark are lifted to the mesh (rom/build/net_lift.c), and from
 * there the landmark of the mesh is found (certify.c) by harmonic balance of all its nodes
 * (net/balance). From that of a mesh with half as many elements, whose start is the first one at the
 * nodes of both, the error of second order by their length is taken out, as it is of the model; where
 * one of fourth order might be as large as the distance, a third mesh takes that out too. Four
 * more harmonics on the second mesh, a quarter of the work, tell what the others do. Peaks of a span's
 * other points are not corrected: their error is that of the sizes in the motion at the largest one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <hawser/certificate.h>
#include <hawser/integrate.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/hold.h"
#include "core/report.h"
#include "study/accuracy/certificate.h"
#include "study/accuracy/landmark.h"
#include "study/accuracy/motions.h"

enum { MOST = HAWSER__CERTIFIED_ORDER, MORE = HAWSER__CERTIFIED_MORE }; /* harmonics */
static const double small = 0.05;  /* least peak over the largest one; chosen */
static const double trusted = 0.1; /* part of a distance that more harmonics may be, */
static const double counted = 1e-4; /* of the least distance that counts; chosen */
static const double speed = 4e9;   /* operations per second with blocks, on a core of 2 GHz */
static const double chain = 12.7*33.0*33.0*33.0; /* of an inner node, with 5 harmonics */
static const double factors = 5.0; /* matrices of the mesh for a landmark, those of the other meshes and
                                    * what is solved with them included */
static const double left = 0.5;   /* of the difference of two meshes, what is of higher order, with 8
                                   * elements a cable: it falls by their square; chosen */
static const double fourth = 4.0/15.0; /* of the difference of two meshes, an error of fourth order
                                   * that their extrapolation enlarges: h^2 taken for h^4 */
static const double unsure = 1.0/3.0; /* of the difference of two extrapolations; chosen by net 4 of
                                       * bench/nets.py with the seed 3 */
static const double margin = 1.02; /* of a distance, what meshes leave in landmarks whose error is not
                                    * of second order yet; chosen by bench/nets.py */
static const double far_omega = 0.03; /* relative: another landmark; chosen */
static const double far_size = 0.35;

static double now(void)
{
	struct timespec time;

	clock_gettime(CLOCK_MONOTONIC, &time);
	return (double)time.tv_sec + 1e-9*(double)time.tv_nsec;
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

static void add(struct hawser__certifying *w, int *point, const struct hawser_landmark *landmark)
{
	struct hawser_certificate *to = w->to;

	if (to->count == HAWSER_CERTIFIED_MOST) {
		to->omitted++;
		return;
	}
	w->arc[to->count] = landmark->arc;
	point[to->count] = point_of(w->frf, landmark);
	to->item[to->count++] = (struct hawser_certified){.kind = landmark->kind,
		.probe = landmark->probe, .axis = landmark->axis, .turn = landmark->turn,
		.omega = landmark->omega, .size = landmark->size, .exact_omega = NAN, .exact_size = NAN,
		.distance = NAN, .tension = NAN};
}

/* Whether it is one of the two largest, or no larger peak is of the same resonance, by the motion of
 * which it is looked at too. */
static int is_new(const struct hawser__certifying *w, const int *point,
                  const struct hawser_landmark *peak)
{
	int own = point_of(w->frf, peak), good = 1;

	for (int i = 0; i < w->to->count; i++)
		good = good && (w->to->item[i].kind == HAWSER_LANDMARK_FOLD ||
		                abs(point[i] - own) > HAWSER__CERTIFIED_NEAR);
	return good || hawser__is_peak(&w->largest[0], peak) || hawser__is_peak(&w->largest[1], peak);
}

static int larger(const void *a, const void *b)
{
	double x = ((const struct hawser_landmark *)a)->size, y = ((const struct hawser_landmark *)b)->size;

	return (x < y) - (x > y);
}

/* Those that are corrected, and points of the curve near them. */
static enum hawser_status choose(struct hawser__certifying *w, int *point,
                                 const struct hawser_landmark *peak, int peaks,
                                 struct hawser_report *report)
{
	struct hawser_landmark *fold, *sorted = calloc((size_t)peaks + 1, sizeof *sorted);
	int count = 0, displacements = 0;
	enum hawser_status status = sorted ? hawser_landmarks(&fold, &count, w->frf, NULL, report)
	                                   : hawser__no_memory(report, "certificate");

	for (int i = 0; i < count && !status; i++)
		if (fold[i].kind == HAWSER_LANDMARK_FOLD)
			add(w, point, &fold[i]);
	if (!status) {
		free(fold);
		for (int i = 0; i < peaks; i++)
			if (peak[i].kind == HAWSER_LANDMARK_PEAK && peak[i].probe >= 0)
				sorted[displacements++] = peak[i];
		hawser__largest_peaks(w->largest, w->frf, sorted, displacements);
		qsort(sorted, (size_t)displacements, sizeof *sorted, larger);
	}
	for (int i = 0; i < displacements && sorted[i].size > small*sorted[0].size; i++)
		if (is_new(w, point, &sorted[i]))
			add(w, point, &sorted[i]);
	free(sorted);
	return status;
}

/* --- one after the other --- */

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

/* The landmark in a mesh with fewer elements, from that in the first one; *found 0: it is not there. */
static enum hawser_status carry(struct hawser__certifying *w, struct hawser__finite *to,
                                const int *from, struct hawser_certified *item, int *found,
                                struct hawser_report *report)
{
	const struct hawser__corrector corrector = hawser__finite_corrector(to);
	double omega = item->exact_omega, size = item->exact_size;
	enum hawser_status status;

	hawser__finite_copy(to->y, to, w->first.y, &w->first, from);
	hawser__finite_copy(to->along, to, w->first.along, &w->first, from);
	to->bend = w->first.bend;
	status = hawser__certify_from(item, to->y, to->along, &to->bend, &corrector, report);
	*found = !status && is_found(item, omega, size);
	return status;
}

/* Where the error of fourth order may be as large as the distance, a third mesh takes that out too, and
 * *rest is a third of what it changes of two meshes alone: in a motion near two resonances the error
 * falls more slowly than by the fourth power. */
static enum hawser_status sharpen(struct hawser__certifying *w, double *rest,
                                  struct hawser_certified *item,
                                  const struct hawser_certified *second, struct hawser_certified own,
                                  struct hawser_report *report)
{
	double omega, size;
	int found = 0;
	enum hawser_status status = hawser__finites_third(&w->both, w->by, report);

	if (!status && !w->third.mesh)
		status = hawser__finite_open(&w->third, &w->both, 2, w->to->order, report);
	w->third.balance.factored = 0;
	if (!status)
		status = carry(w, &w->third, w->both.mesh[2].from, &own, &found, report);
	if (status || !found)
		return status;
	omega = (4.0*second->exact_omega - own.exact_omega)/3.0;
	size = (4.0*second->exact_size - own.exact_size)/3.0;
	*rest = unsure*distance_of(omega, size, item);
	item->exact_omega += (item->exact_omega - omega)/15.0;
	item->exact_size += (item->exact_size - size)/15.0;
	return HAWSER_OK;
}

/* The second mesh from the first one, whose error is taken out of the item; that of the model is omega,
 * size. */
static enum hawser_status extrapolate(struct hawser__certifying *w, struct hawser_certified *item,
                                      double omega, double size, struct hawser_report *report)
{
	struct hawser_certified own = *item, first = *item;
	int found = 0;
	enum hawser_status status = carry(w, &w->second, w->both.mesh[1].from, &own, &found, report);
	double part, rest;

	if (status || !found) {
		item->exact_omega = NAN;
		return status;
	}
	part = distance_of(own.exact_omega, own.exact_size, item);
	rest = w->left*part;
	item->exact_omega = (4.0*item->exact_omega - own.exact_omega)/3.0;
	item->exact_size = (4.0*item->exact_size - own.exact_size)/3.0;
	if (!w->by->halved && fourth*part > distance_of(omega, size, item))
		status = sharpen(w, &rest, item, &own, first, report);
	w->to->lengths = fmax(w->to->lengths, rest);
	part = hawser__finite_last(&w->second);
	if (part > w->worst) {
		w->worst = part;
		w->at = own;
		w->worst_bend = w->second.bend;
		memcpy(w->worst_y, w->second.y, w->second.balance.size*sizeof(double));
		memcpy(w->worst_along, w->second.along, w->second.balance.size*sizeof(double));
	}
	return status;
}

static enum hawser_status correct_one(struct hawser__certifying *w, struct hawser_certified *item,
                                      int point, struct hawser_report *report)
{
	const struct hawser__corrector corrector = hawser__finite_corrector(&w->first);
	const struct hawser__neighbours near = {.y = w->start[1], .around = {w->start[0], w->start[2]}};
	double omega = item->omega/w->rom->time, size = item->size*w->rom->length; /* rad/s, m */
	enum hawser_status status = HAWSER_OK;
	int element = 0;

	for (int i = 0; i < 3 && !status; i++) {
		int p = point + i - 1;
		double at = w->frf->point[p].omega;

		status = hawser__certifying_lift(w, w->frf->state + 2*(size_t)p*(size_t)w->rom->n, at, report);
		hawser__certifying_start(w->start[i], w, at);
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
	status = extrapolate(w, item, omega, size, report);
	w->to->refused += isnan(item->exact_omega);
	item->distance = distance_of(omega, size, item);
	if (item->kind == HAWSER_LANDMARK_FOLD)
		w->folds = fmax(w->folds, item->distance);
	else if (w->by->modes && isfinite(item->distance))
		hawser__certifying_others(w, item, omega, size, point);
	item->exact_omega *= w->rom->time;
	item->exact_size /= w->rom->length;
	return status;
}

/* Four more harmonics, where the last ones are largest. */
static enum hawser_status add_harmonics(struct hawser__certifying *w, struct hawser_report *report)
{
	struct hawser__corrector corrector;
	struct hawser_certified own = w->at;
	enum hawser_status status;

	if (!(w->worst > 0.0))
		return HAWSER_OK;
	status = hawser__finite_open(&w->checked, &w->both, 1, w->to->order + MORE, report);
	if (status)
		return status;
	corrector = hawser__finite_corrector(&w->checked);
	hawser__finite_copy(w->checked.y, &w->checked, w->worst_y, &w->second, NULL);
	hawser__finite_copy(w->checked.along, &w->checked, w->worst_along, &w->second, NULL);
	status = hawser__certify_from(&own, w->checked.y, w->checked.along, &w->worst_bend, &corrector,
	                              report);
	w->to->harmonics = distance_of(w->at.exact_omega, w->at.exact_size, &own);
	return status;
}

static enum hawser_status correct_all(struct hawser__certifying *w, const int *point,
                                      struct hawser_report *report)
{
	struct hawser_certificate *to = w->to;
	enum hawser_status status = HAWSER_OK;

	to->distance = NAN;
	to->harmonics = w->worst = w->others = w->folds = 0.0;
	w->off[0] = w->off[1] = NAN;
	to->lengths = 0.0;
	to->refused = 0;
	for (int i = 0; i < to->count && !status; i++) {
		status = correct_one(w, &to->item[i], point[i], report);
		to->distance = fmax(to->distance, to->item[i].distance);
	}
	return status ? status : add_harmonics(w, report);
}

/* --- all --- */

/* Both meshes, with the present number of harmonics. */
static enum hawser_status reopen(struct hawser__certifying *w, struct hawser_report *report)
{
	enum hawser_status status;

	hawser__finite_clear(&w->first);
	hawser__finite_clear(&w->second);
	hawser__finite_clear(&w->third);
	hawser__finite_clear(&w->checked);
	hawser__hold_clear(&w->ordered);
	status = hawser__finite_open(&w->first, &w->both, 0, w->to->order, report);
	if (!status)
		status = hawser__finite_open(&w->second, &w->both, 1, w->to->order, report);
	for (int i = 0; i < 3 && !status; i++)
		w->start[i] = hawser__hold(&w->ordered, w->first.balance.size, sizeof *w->start[i]);
	w->worst_y = hawser__hold(&w->ordered, w->second.balance.size, sizeof *w->worst_y);
	w->worst_along = hawser__hold(&w->ordered, w->second.balance.size, sizeof *w->worst_along);
	return !status && w->ordered.short_of_memory ? hawser__no_memory(report, "certificate") : status;
}

/* By the number of elements of a cable, the mean by their lengths. */
static double left_of(const struct hawser__mesh *mesh)
{
	double all = 0.0, sum = 0.0;

	for (int c = 0; c < mesh->cables; c++) {
		int count = mesh->first[c + 1] - mesh->first[c];

		if (count > 1) {
			all += count*mesh->length0[mesh->first[c]];
			sum += count*count*mesh->length0[mesh->first[c]];
		}
	}
	return sum > 0.0 ? left*pow(8.0*all/sum, 2) : 0.0;
}

static enum hawser_status open_meshes(struct hawser__certifying *w, struct hawser_report *report)
{
	struct hawser__nodal pattern;
	struct hawser__mesh *mesh = &w->both.source.modal.mesh;
	enum hawser_status status = hawser__nodal_open(&pattern, mesh, report);

	w->to->unknowns = mesh->unknowns;
	w->to->foreseen = factors*w->to->count*hawser__nodal_work(&pattern, 3*(2*w->to->order + 1))/speed;
	hawser__nodal_clear(&pattern);
	w->left = left_of(mesh);
	return status ? status : reopen(w, report);
}

/* The number of harmonics that the motions at the landmarks have. */
static enum hawser_status find_order(struct hawser__certifying *w, const int *point,
                                     struct hawser_report *report)
{
	size_t unknowns = (size_t)w->both.source.modal.mesh.unknowns;
	enum hawser_status status = HAWSER_OK;

	w->row = hawser__hold(&w->hold, HAWSER__CERTIFIED_PHASES*unknowns, sizeof *w->row);
	w->series = hawser__hold(&w->hold, HAWSER__CERTIFIED_WIDTH*unknowns, sizeof *w->series);
	w->size = hawser__hold(&w->hold, 6*(size_t)w->frf->probes, sizeof *w->size);
	w->u = hawser__hold(&w->hold, HAWSER__CERTIFIED_PHASES*
	                    (size_t)(w->both.turn ? w->both.source.n : w->rom->n), sizeof *w->u);
	if (w->hold.short_of_memory)
		return hawser__no_memory(report, "certificate");
	for (int i = 0; i < w->to->count && !status; i++) {
		int order;

		status = hawser__certifying_lift(w, w->frf->state + 2*(size_t)point[i]*(size_t)w->rom->n,
		              w->frf->point[point[i]].omega, report);
		order = hawser__certifying_order(w);
		w->to->order = order > w->to->order ? order : w->to->order;
	}
	return status;
}

static void clear(struct hawser__certifying *w)
{
	hawser__finite_clear(&w->first);
	hawser__finite_clear(&w->second);
	hawser__finite_clear(&w->third);
	hawser__finite_clear(&w->checked);
	hawser__finites_clear(&w->both);
	hawser__hold_clear(&w->ordered);
	hawser__hold_clear(&w->hold);
	free(w);
}

static enum hawser_status certify(struct hawser__certifying *w, const int *point, double bearable,
                                  struct hawser_report *report)
{
	struct hawser_certificate *to = w->to;
	enum hawser_status status = hawser__finites_open(&w->both, w->by, report);

	if (!status && w->by->modes)
		status = hawser__finites_turn(&w->both, w->by->modes, w->rom, report);
	if (!status)
		status = find_order(w, point, report);
	if (!status)
		status = open_meshes(w, report);
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

static double stated(const struct hawser_certificate *of, double distance)
{
	return margin*distance + of->harmonics + of->lengths;
}

enum hawser_status hawser__certified(struct hawser_certificate *certificate,
                                   const struct hawser__certified_by *by, const struct hawser_rom *rom,
                                   const struct hawser_frf *frf, const struct hawser_landmark *peak,
                                   int peaks, double bearable, struct hawser_report *report)
{
	double start = now(), elements = 0.0;
	struct hawser__certifying *w = calloc(1, sizeof *w);
	int point[HAWSER_CERTIFIED_MOST];
	enum hawser_status status = HAWSER_OK;

	*certificate = (struct hawser_certificate){.distance = NAN};
	if (!w)
		return hawser__no_memory(report, "certificate");
	w->to = certificate;
	w->by = by;
	w->rom = rom;
	w->frf = frf;
	if (frf->points > 2 && frf->period == 1)
		status = choose(w, point, peak, peaks, report);
	for (int c = 0; c < by->net->cables; c++)
		elements += by->net->cable[c].elements;
	certificate->foreseen = factors*certificate->count*elements*chain/speed;
	if (bearable > 0.0 && certificate->foreseen > bearable)
		certificate->count = 0;
	if (!status && certificate->count > 0)
		status = certify(w, point, bearable, report);
	certificate->error = certificate->distance < w->others ? w->others : certificate->distance;
	certificate->error = stated(certificate, certificate->error);
	if (isfinite(w->off[0] + w->off[1]))
		certificate->largest = stated(certificate, fmax(w->folds, fmax(w->off[0], w->off[1])));
	clear(w);
	certificate->seconds = now() - start;
	return status;
}

enum hawser_status hawser_net_certify(struct hawser_certificate *certificate,
                                      const struct hawser_net *net,
                                      const struct hawser_net_rom_options *options,
                                      const struct hawser_rom *rom, const struct hawser_frf *frf,
                                      const struct hawser_landmark *peak, int peaks, double bearable,
                                      struct hawser_report *report)
{
	const struct hawser__certified_by by = {.net = net, .options = options};

	if (net->water.density > 0.0) {
		memset(certificate, 0, sizeof *certificate);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "certificate", "%s: the mesh in which folds "
		                    "and peaks are corrected has no force of the %s", net->name,
		                    net->winds ? "wind" : "water");
	}
	return hawser__certified(certificate, &by, rom, frf, peak, peaks, bearable, report);
}
