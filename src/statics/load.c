/* statics/load.c - the varying load of a scene: the section load and the pieces of the list loads.
 *
 *    f            force per length of a piece between the scaled arclengths a and b, N/m
 *    cos(k tau + phase - kappa s)     its variation; tau = Omega t
 *    kappa        2 pi over the wavelength, scaled; 0: in phase
 *
 * The cosine is split in two parts, cos(k tau) and sin(k tau), with the forces
 * f cos(phase - kappa s) and - f sin(phase - kappa s).
 *
 * Lengths are unstretched. Those of the apparent cable of a travelling one are longer by 1/(1 - m),
 * m of struct hawser_motion, and the total force remains: force per length of it is (1 - m) f.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/order.h"
#include "core/report.h"
#include "statics/frame.h"
#include "statics/load.h"

#define SHORTEST 200.0  /* wavelengths in the cable */

static const char where[] = "statics";

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
static int entry(struct hawser__loads *loads, int k, int sine)
{
	for (int h = 0; h < loads->harmonics; h++)
		if (loads->k[h] == k && loads->sine[h] == sine)
			return h;
	loads->k[loads->harmonics] = k;
	loads->sine[loads->harmonics] = sine;
	return loads->harmonics++;
}

/* cos or -sin of the angle: exactly zero at multiples of 90 degrees. */
static double part(double angle, int sine)
{
	double value = sine ? -sin(angle) : cos(angle);

	return fabs(value) < 1e-15 ? 0.0 : value;
}

static void add_piece(struct hawser__loads *loads, const struct hawser__piece *piece, int k)
{
	struct hawser__piece *to = &loads->piece[loads->count++];

	*to = *piece;
	for (int sine = 0; sine < 2; sine++)
		to->harmonic[sine] = to->kappa != 0.0 || part(to->phase, sine) != 0.0
		                     ? entry(loads, k, sine) : -1;
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

static enum hawser_status set_cuts(struct hawser__loads *loads, struct hawser_report *report)
{
	int count = 0, kept = 0;

	for (int pass = 0; pass < 2; pass++) {
		if (pass == 1 && !(loads->cut = malloc(((size_t)count + 1)*sizeof *loads->cut)))
			return hawser__no_memory(report, where);
		count = 0;
		for (int i = 0; i < loads->count; i++) {
			const struct hawser__piece *p = &loads->piece[i];
			int parts = 1 + (int)(fabs(p->kappa)*(p->to - p->from)/HAWSER__LOAD_STEP);

			for (int c = 0; c <= parts; c++, count++)
				if (pass == 1)
					loads->cut[count] = c == parts ? p->to
					                    : p->from + (p->to - p->from)*c/parts;
		}
	}
	if (count)
		qsort(loads->cut, (size_t)count, sizeof *loads->cut, hawser__ascending);
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

void hawser__piece_part(double f[3], const struct hawser__piece *piece,
                        const struct hawser__loads *loads, int h, double s)
{
	double factor = piece->harmonic[loads->sine[h]] == h
	                ? part(piece->phase - piece->kappa*s, loads->sine[h]) : 0.0;

	for (int c = 0; c < 3; c++)
		f[c] = factor*piece->f[c];
}

void hawser__piece_at(double local[3], const struct hawser__piece *piece,
                      const struct hawser__loads *loads, int h, const struct hawser_statics *st,
                      double s)
{
	double f[3];

	hawser__piece_part(f, piece, loads, h, s);
	for (int c = 0; c < 3; c++)
		local[c] = f[c];
	if (piece->frame == HAWSER_FRAME_GLOBAL) {
		struct hawser_frame_point at = hawser_statics_frame(st, s);
		double in[3];

		hawser_statics_from_global(st, in, f);
		hawser__frame_in(local, &at, in);
	}
}
