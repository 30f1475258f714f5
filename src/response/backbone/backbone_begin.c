/* response/backbone/backbone_begin.c - see backbone.h.
 *
 * The linear modes of a gyroscopic model, u'' + G u' + K u = 0, are complex: u = Re(z exp(i w t)).
 * Where reversed motions with reflected coordinates are motions, z is real in the even coordinates
 * and imaginary in the odd ones, but for a common phase.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/backbone/backbone.h"

static const char where[] = "backbone";

#define FIRST 1e-3       /* size of the first point, relative to the largest: the model is nearly linear
                          * there; chosen */
#define FIRST_PAIR 0.03  /* the same in quadrature: nonlinear terms determine the ratio; chosen */
#define SAME_OMEGA 1e-6  /* relative difference of frequencies that are the same; chosen */
#define TINY 1e-9        /* of a vector: round-off */

static int is_gyroscopic(const struct hawser__half *half)
{
	for (int i = 0; i < half->base.n*half->base.n; i++)
		if (half->G[i] != 0.0)
			return 1;
	return 0;
}

/* at = the shape of the complex mode in column c of z, whose frequency is w. */
static int shape_of(struct hawser__free_walk *walk, const double *z, int c, double w)
{
	const struct hawser__half *half = &walk->half;
	int n = half->base.n, m = 2*n, big = 0;
	double most = 0.0, rest = 0.0, re, im;

	for (int j = 0; j < n; j++) {
		double size = hypot(z[(size_t)j*m + c], z[(size_t)j*m + c + 1]);

		big = size > most ? j : big;
		most = fmax(most, size);
	}
	/* times conj(z_big), and i if it is odd */
	re = z[(size_t)big*m + c]/(most*most);
	im = -z[(size_t)big*m + c + 1]/(most*most);
	if (half->sign[big] < 0) {
		double keep = re;

		re = -im;
		im = keep;
	}
	for (int j = 0; j < n; j++) {
		double a = z[(size_t)j*m + c], b = z[(size_t)j*m + c + 1];
		double real = a*re - b*im, imaginary = a*im + b*re;

		walk->at[j] = half->sign[j] < 0 ? -imaginary : real;
		rest = fmax(rest, fabs(half->sign[j] < 0 ? real : imaginary));
		if (fabs(walk->at[j]) < TINY)
			walk->at[j] = 0.0;
	}
	walk->at[n] = w;
	return rest > 1e-6;
}

/* The mode whose frequency has the place options->mode in ascending order. */
static enum hawser_status gyroscopic_mode(struct hawser__free_walk *walk, struct hawser_report *report)
{
	const struct hawser__half *half = &walk->half;
	int n = half->base.n, m = 2*n, info, mode = walk->options->mode, chosen = -1;
	size_t square = (size_t)m*(size_t)m;
	double *room = calloc(2*square + 2*(size_t)m, sizeof *room), *z, *re, *im, w = 0.0;

	if (!room)
		return hawser__no_memory(report, where);
	z = room + square;
	re = z + square;
	im = re + m;
	for (int j = 0; j < n; j++) {
		room[(size_t)j*m + n + j] = 1.0;
		for (int k = 0; k < n; k++) {
			room[(size_t)(n + j)*m + k] = -walk->rom->K[(size_t)j*n + k];
			room[(size_t)(n + j)*m + n + k] = -half->G[(size_t)j*n + k];
		}
	}
	info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', m, room, m, re, im, NULL, 1, z, m);
	for (int place = 0; !info && place <= mode; place++) {
		chosen = -1;
		for (int i = 0; i < m; i++)
			if (im[i] > w && fabs(re[i]) < 1e-6*im[i] && (chosen < 0 || im[i] < im[chosen]))
				chosen = i;
		w = chosen < 0 ? w : im[chosen];
	}
	if (!info)
		info = chosen < 0 || shape_of(walk, z, chosen, w);
	free(room);
	return info ? hawser__fail(report, HAWSER_ERR_CONVERGENCE, where,
	                           "mode %d of the gyroscopic model is not a motion of constant amplitude "
	                           "that is alone at its frequency: no family of free motions can begin at "
	                           "it", mode + 1) : HAWSER_OK;
}

/* The signs of a motion in two modes, the second of which is odd. */
static enum hawser_status quadrature(struct hawser__free_walk *walk, struct hawser_report *report)
{
	struct hawser__half *half = &walk->half;
	int n = half->base.n, j = walk->options->mode, k = walk->options->quadrature - 1, none;
	double a = walk->rom->K[(size_t)j*((size_t)n + 1)], b = walk->rom->K[(size_t)k*((size_t)n + 1)];
	enum hawser_status status;

	if (!(fabs(sqrt(b/a) - 1.0) < SAME_OMEGA))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the frequencies of modes %d and %d differ by %.3g of the first: small "
		                    "motions in quadrature need the same one. Others begin at branch points of "
		                    "the curve of one mode", j + 1, k + 1, sqrt(fmax(b/a, 0.0)) - 1.0);
	memset(walk->member, 0, (size_t)n);
	walk->member[j] = 1;
	status = hawser__signs_flip(&walk->signs, walk->member, k, half->sign, &none, report);
	if (!status && none)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                      "the model changes when mode %d is reflected and mode %d is not: they "
		                      "have no common motions in quadrature", k + 1, j + 1);
	walk->member[k] = 1;
	return status;
}

/* The first point, nearly. */
static enum hawser_status first_shape(struct hawser__free_walk *walk, struct hawser_report *report)
{
	const struct hawser_backbone_options *options = walk->options;
	struct hawser__half *half = &walk->half;
	size_t n = (size_t)half->base.n;
	enum hawser_status status = HAWSER_OK;

	memset(walk->at, 0, (n + 1)*sizeof(double));
	walk->first = (options->quadrature ? FIRST_PAIR : FIRST)*options->size;
	if (options->start) {
		walk->first = FIRST*options->size;
		memcpy(walk->at, options->start, (n + 1)*sizeof(double));
		for (size_t j = 0; j < n; j++)
			walk->member[j] = options->start[j] != 0.0 || options->direction[j] != 0.0;
		return HAWSER_OK;
	}
	walk->at[n] = sqrt(walk->rom->K[(size_t)options->mode*(n + 1)]);
	walk->at[options->mode] = 1.0;
	if (is_gyroscopic(half))
		status = gyroscopic_mode(walk, report);
	for (size_t j = 0; j < n; j++) {
		walk->member[j] |= walk->at[j] != 0.0;
		walk->at[j] *= walk->first;
	}
	return status;
}

enum hawser_status hawser__free_signs(struct hawser__free_walk *walk, struct hawser_report *report)
{
	const struct hawser_backbone_options *options = walk->options;
	struct hawser__half *half = &walk->half;
	int n = half->base.n;
	enum hawser_status status = hawser__signs_init(&walk->signs, walk->rom, half->G, report);

	if (status)
		return status;
	walk->member = calloc((size_t)n, 1);
	if (!walk->member)
		return hawser__no_memory(report, where);
	if (walk->rom->mass && is_gyroscopic(half))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the damping times the inverse of the mass matrix is not symmetric: give "
		                    "the model in coordinates with the mass 1, without damping");
	if (hawser__signs_reversal(&walk->signs, half->sign))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "the model is gyroscopic (a travelling cable's), and without symmetry: no "
		                    "reflection of coordinates makes a motion of a motion reversed in time, so "
		                    "that its free motions do not equal their reverse, and are not found. "
		                    "Level spans and those without quadratic terms have this symmetry");
	if (options->sign)
		memcpy(half->sign, options->sign, (size_t)n*sizeof *half->sign);
	if (options->quadrature) {
		if (is_gyroscopic(half))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "motions in quadrature of two given modes: not in a gyroscopic model, "
			                    "whose modes are such motions already");
		status = quadrature(walk, report);
	}
	if (!status)
		status = first_shape(walk, report);
	if (!status)
		status = hawser__signs_classes(&walk->signs, walk->member, half->class_of, &half->classes,
		                               report);
	if (status)
		return status;
	memcpy(walk->backbone->sign, half->sign, (size_t)n*sizeof *half->sign);
	walk->events = 2*half->classes - 1;
	walk->event = calloc(4*(size_t)walk->events, sizeof(double));
	if (!walk->event)
		return hawser__no_memory(report, where);
	walk->next_event = walk->event + 2*(size_t)walk->events;
	return HAWSER_OK;
}
