/* ropeway/track_sample.c - modes at one value of a sweep, and how much the shapes of two modes have in
 * common.
 *
 * Shapes are compared at the same parts of each span: a span whose ends move, and carriers that pass,
 * change neither the number of these points nor what a mode is. Their weight is the length of rope,
 * with the carriers spread along it. The shapes of one value are then nearly orthogonal, which is
 * enough to find each mode again at the next value.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include <cblas.h>

#include "core/report.h"
#include "ropeway/track.h"

/* Points of a span: several for each half wave of the modes that are asked for. */
enum { PER_SPAN = 16 };
#define APART 1e-9 /* of the energy in common spans: the modes of spans that do not interact have 0 */

void hawser__track_sample_clear(struct hawser__track_sample *sample)
{
	free(sample->omega);
	free(sample->residual);
	free(sample->plane);
	free(sample->share);
	free(sample->shape);
	free(sample->branch);
	*sample = (struct hawser__track_sample){.n = 0};
}

double hawser__track_alike(const struct hawser__track_sample *a, int i,
                           const struct hawser__track_sample *b, int j)
{
	int n = a->values;
	const double *x = a->shape + (size_t)i*2*(size_t)n, *y = b->shape + (size_t)j*2*(size_t)n;
	double c = cblas_ddot(n, x, 1, y, 1) + cblas_ddot(n, x + n, 1, y + n, 1);
	double s = cblas_ddot(n, x, 1, y + n, 1) - cblas_ddot(n, x + n, 1, y, 1);

	return a->plane[i] == b->plane[j] ? c*c + s*s : 0.0;
}

int hawser__track_coupled(const struct hawser__track_sample *a, int i, int j)
{
	double common = 0.0;

	for (int k = 0; k < a->spans; k++)
		common += fmin(a->share[i*a->spans + k], a->share[j*a->spans + k]);
	return a->plane[i] == a->plane[j] && common > APART;
}

/* Modes whose spans are apart at a sheave are coupled all the same if the rope slips over it: their
 * shares are then not exactly 0. */
static void keep_shape(double *to, const struct hawser_line_modes *modes,
                       const struct hawser_ropeway_statics *st, int values, int k)
{
	int parts = modes->gyroscopic ? 2 : 1, at = 0;
	double norm;

	for (int lane = 0; lane < st->lanes; lane++)
		for (int i = 0; i <= st->ropeway->towers; i++) {
			const struct hawser_ropeway_span *span = &st->lane[lane].span[i];
			double length = span->S_to - span->S_from, weight = sqrt(length/PER_SPAN), shape[6];

			for (int p = 0; p < PER_SPAN; p++, at += 3) {
				hawser_line_modes_at(shape, NULL, modes, k, lane,
				                     (span->S_from + length*(p + 0.5)/PER_SPAN)/modes->length_unit);
				for (int c = 0; c < 3*parts; c++)
					to[c/3*values + at + c % 3] = weight*shape[c];
			}
		}
	norm = cblas_dnrm2(2*values, to, 1);
	if (norm > 0.0)
		cblas_dscal(2*values, 1.0/norm, to, 1);
}

static enum hawser_status keep(struct hawser__track_sample *to, const struct hawser_line_modes *modes,
                               const struct hawser_ropeway_statics *st, struct hawser_report *report)
{
	size_t n = (size_t)modes->n;
	int *own = calloc((size_t)modes->spans + 1, sizeof *own);

	to->n = modes->n;
	to->spans = st->lanes*(st->ropeway->towers + 1);
	to->values = 3*PER_SPAN*to->spans;
	to->omega = calloc(n, sizeof *to->omega);
	to->residual = calloc(n, sizeof *to->residual);
	to->plane = calloc(n, sizeof *to->plane);
	to->branch = calloc(n, sizeof *to->branch);
	to->share = calloc(n*(size_t)to->spans, sizeof *to->share);
	to->shape = calloc(n*2*(size_t)to->values, sizeof *to->shape);
	if (!own || !to->omega || !to->residual || !to->plane || !to->branch || !to->share || !to->shape) {
		free(own);
		return hawser__no_memory(report, "track");
	}
	hawser_ropeway_modes_spans(own, modes, st);
	for (int k = 0; k < modes->n; k++) {
		to->omega[k] = modes->mode[k].omega/modes->time_unit;
		to->residual[k] = modes->mode[k].residual;
		to->plane[k] = modes->mode[k].plane;
		to->branch[k] = -1;
		for (int i = 0; i < modes->spans; i++)
			if (own[i] >= 0)
				to->share[k*to->spans + own[i]] += modes->share[k*modes->spans + i];
		keep_shape(to->shape + (size_t)k*2*(size_t)to->values, modes, st, to->values, k);
	}
	free(own);
	return HAWSER_OK;
}

enum hawser_status hawser__track_sample(struct hawser__track_sample *sample, struct hawser__track *t,
                                        double value, struct hawser_report *report)
{
	const struct hawser_ropeway_track_options *o = t->options;
	const struct hawser_ropeway_options options = {.load_case = o->load_case};
	const struct hawser_ropeway_modes_options choice = {.n = t->ask, .tolerance = o->tolerance};
	struct hawser_ropeway rw = {.name = NULL};
	struct hawser_ropeway_statics st = {.ropeway = NULL};
	struct hawser_line_modes modes = {.n = 0};
	enum hawser_status status = o->open(&rw, o->context, value, report);

	*sample = (struct hawser__track_sample){.at = {.value = value}};
	if (!status)
		status = hawser_ropeway_solve(&st, &rw, &options, rw.phase, report);
	if (!status)
		status = hawser_ropeway_modes_solve(&modes, &st, &choice, report);
	if (!status) {
		sample->at.T0 = st.T0;
		sample->at.gyroscopic = modes.gyroscopic;
		status = keep(sample, &modes, &st, report);
		t->solves++;
	}
	hawser_line_modes_clear(&modes);
	hawser_ropeway_statics_clear(&st);
	hawser_ropeway_clear(&rw);
	if (status)
		hawser__track_sample_clear(sample);
	return status;
}
