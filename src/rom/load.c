/* rom/load.c - the varying load of a scene: the section load and the pieces of the list loads.
 *
 *    f            force per length of a piece between the scaled arclengths a and b, N/m
 *    cos(k tau + phase - kappa s)     its variation; tau = Omega t
 *    kappa        2 pi over the wavelength, scaled; 0: in phase
 *
 * With the two parts of the cosine, each multiple k of the frequency has the forces
 *
 *    f_j cos   =   scale * integral of Phi_j . f cos(phase - kappa s) ds
 *    f_j sin   = - scale * integral of Phi_j . f sin(phase - kappa s) ds
 *
 * on mode j. The integrals are exact at a and b: the elements of the modes' grid are divided there,
 * and in a wave so that the phase changes by at most STEP on each part, on which the Gauss rule is
 * exact to round-off. A force F at a point is a piece without length: its work is F . Phi_j there.
 *
 * Lengths are unstretched. Those of the apparent cable of a travelling one are longer by 1/(1 - m),
 * m of struct hawser_motion, and the total force remains: force per length of it is (1 - m) f.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/load.h"
#include "statics/frame.h"

#define STEP 0.5        /* rad */
#define SHORTEST 200.0  /* wavelengths in the cable */

static const char where[] = "rom";

int hawser__loaded(const struct hawser_scene *scene)
{
	return scene && (scene->load.present || scene->loads > 0);
}

void hawser__loads_clear(struct hawser__loads *loads)
{
	free(loads->cut);
	*loads = (struct hawser__loads){.count = 0};
}

/* --- pieces --- */

/* Index of this harmonic, which is added if it is new. */
static int entry(struct hawser__loads *loads, int k, enum hawser_phase wave)
{
	for (int h = 0; h < loads->harmonics; h++)
		if (loads->k[h] == k && loads->wave[h] == wave)
			return h;
	loads->k[loads->harmonics] = k;
	loads->wave[loads->harmonics] = wave;
	return loads->harmonics++;
}

/* cos or -sin of the angle: exactly zero at multiples of 90 degrees. */
static double part(double angle, enum hawser_phase wave)
{
	double value = wave == HAWSER_COS ? cos(angle) : -sin(angle);

	return fabs(value) < 1e-15 ? 0.0 : value;
}

static void add_piece(struct hawser__loads *loads, const struct hawser__piece *piece, int k)
{
	struct hawser__piece *to = &loads->piece[loads->count++];

	*to = *piece;
	for (int w = 0; w < 2; w++) {
		enum hawser_phase wave = w ? HAWSER_SIN : HAWSER_COS;

		to->harmonic[w] = to->kappa != 0.0 || part(to->phase, wave) != 0.0
		                  ? entry(loads, k, wave) : -1;
	}
}

static enum hawser_status place(double *s, double value, int by_length, const char *key, int number,
                                const struct hawser_statics *st, struct hawser_report *report)
{
	double length = st->l*st->span.d*(1.0 - st->motion.mach2);

	*s = by_length ? value/length*st->l : value*st->l;
	if (by_length && value > length)
		return hawser__fail(report, HAWSER_ERR_SCENE, where,
		                    "loads.%d.%s: %.9g m is beyond the end of the cable, whose unstretched "
		                    "length is %.9g m", number, key, value, length);
	return HAWSER_OK;
}

static enum hawser_status from_list(struct hawser__loads *loads, const struct hawser_statics *st,
                                    const struct hawser_load_piece *one, int number,
                                    struct hawser_report *report)
{
	double length = st->l*st->span.d*(1.0 - st->motion.mach2);
	int point = one->force[0] != 0.0 || one->force[1] != 0.0 || one->force[2] != 0.0;
	struct hawser__piece piece = {.frame = one->frame, .phase = one->phase};
	enum hawser_status status = point
		? place(&piece.from, one->at, one->at_length, "at", number, st, report)
		: place(&piece.from, one->from, one->from_length, "from", number, st, report);

	piece.to = piece.from;
	if (!status && !point)
		status = place(&piece.to, one->to, one->to_length, "to", number, st, report);
	if (status)
		return status;
	if (!point && !(piece.from < piece.to))
		return hawser__fail(report, HAWSER_ERR_SCENE, where,
		                    "loads.%d acts from %.9g m to %.9g m: give the end nearer to A first",
		                    number, piece.from/st->l*length, piece.to/st->l*length);
	if (one->wave != 0.0 && !(fabs(one->wave) >= length/SHORTEST))
		return hawser__fail(report, HAWSER_ERR_SCENE, where,
		                    "loads.%d.wave: %g m is less than 1/%g of the cable, which no mode here "
		                    "follows: give a longer one", number, one->wave, SHORTEST);
	for (int c = 0; c < 3; c++)
		piece.f[c] = point ? one->force[c]/(length/st->l) : one->per_length[c];
	if (one->wave != 0.0 && !point)
		piece.kappa = 2.0*M_PI*length/st->l/one->wave;
	add_piece(loads, &piece, one->harmonic);
	return HAWSER_OK;
}

/* --- cuts --- */

static int ascending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

static enum hawser_status set_cuts(struct hawser__loads *loads, struct hawser_report *report)
{
	int count = 0, kept = 0;

	for (int pass = 0; pass < 2; pass++) {
		if (pass == 1 && !(loads->cut = malloc(((size_t)count + 1)*sizeof *loads->cut)))
			return hawser__no_memory(report, where);
		count = 0;
		for (int i = 0; i < loads->count; i++) {
			const struct hawser__piece *p = &loads->piece[i];
			int parts = 1 + (int)(fabs(p->kappa)*(p->to - p->from)/STEP);

			for (int c = 0; c <= parts; c++, count++)
				if (pass == 1)
					loads->cut[count] = c == parts ? p->to
					                    : p->from + (p->to - p->from)*c/parts;
		}
	}
	if (count)
		qsort(loads->cut, (size_t)count, sizeof *loads->cut, ascending);
	for (int i = 0; i < count; i++)
		if (kept == 0 || loads->cut[i] > loads->cut[kept - 1])
			loads->cut[kept++] = loads->cut[i];
	loads->cuts = kept;
	return HAWSER_OK;
}

enum hawser_status hawser__loads_make(struct hawser__loads *loads, const struct hawser_statics *st,
                                      const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	*loads = (struct hawser__loads){.scale = st->span.d/st->H*(1.0 - st->motion.mach2)};
	if (scene && scene->load.present) {
		struct hawser__piece piece = {.frame = scene->load.frame,
			.from = scene->load.extent[0]*st->l, .to = scene->load.extent[1]*st->l};

		memcpy(piece.f, scene->load.per_length, sizeof piece.f);
		add_piece(loads, &piece, 1);
	}
	for (int i = 0; scene && !status && i < scene->loads; i++)
		status = from_list(loads, st, &scene->piece[i], i, report);
	return status ? status : set_cuts(loads, report);
}

/* --- forces --- */

void hawser__piece_at(double local[3], const struct hawser__piece *piece,
                      const struct hawser__loads *loads, int h, const struct hawser_statics *st,
                      double s)
{
	double factor = piece->harmonic[loads->wave[h] == HAWSER_SIN] == h
	                ? part(piece->phase - piece->kappa*s, loads->wave[h]) : 0.0;
	double f[3];

	for (int c = 0; c < 3; c++)
		local[c] = f[c] = factor*piece->f[c];
	if (piece->frame == HAWSER_FRAME_GLOBAL) {
		struct hawser_frame_point at = hawser_statics_frame(st, s);
		double in[3];

		hawser_statics_from_global(st, in, f);
		hawser__frame_in(local, &at, in);
	}
}

static double work_at(const struct hawser__piece *piece, const struct hawser__loads *loads, int h,
                      const struct hawser_modes *modes, int j, double s)
{
	double phi[3], f[3];

	hawser_modes_at(modes, phi, NULL, j, s);
	hawser__piece_at(f, piece, loads, h, &modes->statics, s);
	return phi[0]*f[0] + phi[1]*f[1] + phi[2]*f[2];
}

/* Integral over [from, to] inside element e, by the rule of the element, scaled, on as many parts as
 * a wave needs. */
static double panel(const struct hawser__piece *piece, const struct hawser__loads *loads, int h,
                    const struct hawser_modes *modes, int j, int e, double from, double to)
{
	const struct hawser_grid *grid = &modes->grid;
	int parts = 1 + (int)(fabs(piece->kappa)*(to - from)/STEP);
	double width = (to - from)/parts, sum = 0.0;
	double shrink = width/(grid->edge[e + 1] - grid->edge[e]);

	for (int p = 0; p < parts; p++)
		for (int i = 0; i < grid->order; i++) {
			double s = from + p*width + 0.5*width*(1.0 + grid->node[i]);

			sum += shrink*grid->weight[e*grid->order + i]*work_at(piece, loads, h, modes, j, s);
		}
	return sum;
}

double hawser__loads_work(const struct hawser__loads *loads, int h, const struct hawser_modes *modes,
                          int j)
{
	const struct hawser_grid *grid = &modes->grid;
	double sum = 0.0;

	for (int i = 0; i < loads->count; i++) {
		const struct hawser__piece *piece = &loads->piece[i];

		if (piece->harmonic[loads->wave[h] == HAWSER_SIN] != h)
			continue;
		if (piece->from == piece->to)
			sum += work_at(piece, loads, h, modes, j, piece->from);
		for (int e = 0; e < grid->elements; e++) {
			double from = fmax(grid->edge[e], piece->from);
			double to = fmin(grid->edge[e + 1], piece->to);

			if (from < to)
				sum += panel(piece, loads, h, modes, j, e, from, to);
		}
	}
	return loads->scale*sum;
}

double hawser__loads_most(const struct hawser__loads *loads, const struct hawser_modes *modes, int j)
{
	double most = 0.0;

	if (loads->harmonics == 1)
		return hawser__loads_work(loads, 0, modes, j);
	for (int h = 0; h < loads->harmonics; h++) {
		double square = 0.0;

		for (int i = 0; i < loads->harmonics; i++)
			if (loads->k[i] == loads->k[h])
				square += pow(hawser__loads_work(loads, i, modes, j), 2.0);
		most = fmax(most, sqrt(square));
	}
	return most;
}
