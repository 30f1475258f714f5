/* rom/build/line_load.c - loads of a model of a rope over sheaves.
 *
 * Passing: weights W at S = v t + i d have on a shape with the vertical displacement y(S) the force
 *
 *    sum_i - W y(v t + i d) = a_0 + sum_k [a_k cos(k Omega t) + b_k sin(k Omega t)],
 *    a_k = - 2 W/d * integral of y cos(2 pi k S/d) dS,    Omega = 2 pi v/d
 *
 * (Poisson's sum), b_k with the sine. a_0 is the weight smeared over the rope, which is in the
 * statics. For w_jk, with which the modes that are not kept follow, it is a force - K_jk u_k.
 *
 * Drive: ropeway/expand/expand_drive.c. The shape Z of the modes that are not kept changes the
 * stiffness by its third derivatives.
 *
 * A rope that runs: with the mass r per length of rope and carriers, relative to that of the rope, the
 * kinetic energy has the term r nu integral of du/dt.u', which gives the gyroscopic forces
 *
 *    - r nu (A - A') du/dt,      A_jk = integral of Phi_j.Phi_k'
 *
 * and its term in nu^2 makes the apparent tension of the tension, which is that of the statics. If
 * carriers pass, nu = Omega d/2 pi, so that the forces are a harmonic k = 0 with a factor Omega.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "rom/build/line.h"

static struct hawser_harmonic *add(struct hawser_rom *rom, int k, enum hawser_phase phase,
                                   struct hawser_report *report)
{
	struct hawser_harmonic *h = &rom->harmonic[rom->harmonics++];
	size_t n = (size_t)rom->n;

	h->k = k;
	h->phase = phase;
	h->f = calloc(n, sizeof *h->f);
	h->K = calloc(n*n, sizeof *h->K);
	if (h->f && h->K)
		return h;
	(void)hawser__no_memory(report, "line rom");
	return NULL;
}

/* --- passing --- */

double hawser__line_pull(const void *wave, int lane, double s)
{
	const struct hawser__line_wave *w = wave;
	double phase = w->number*(s - w->first[lane]);

	return w->scale[lane]*(w->sine ? sin(phase) : cos(phase));
}

struct hawser__line_wave hawser__line_wave(const struct hawser_line_modes *modes,
                                           const struct hawser_line_rom_options *o, int i)
{
	double per = modes->length_unit/o->spacing;
	struct hawser__line_wave wave = {.number = 2.0*M_PI*(i/2 + 1)*per, .sine = i%2};

	for (int lane = 0; lane < modes->lanes; lane++) {
		wave.scale[lane] = -2.0*o->weight[lane]/modes->force_unit*per*
		                   (i%2 && o->modes.backward[lane] ? -1.0 : 1.0);
		wave.first[lane] = o->first[lane]/modes->length_unit;
	}
	return wave;
}

/* Gauss rules of the modes' grids on parts of elements on which the wave turns by at most this
 * phase: with 4 nodes and more its error is below 1e-12. */
static const double longest = 0.5;

/* Sum over the points of one piece, divided so that the wave is resolved. y: the vertical
 * displacement of shape `what` at s from the beginning of the piece. */
struct field {
	const struct hawser__lexpand *t;
	const struct hawser_line_modes *modes;
	int mode, pair; /* the other is -1 */
};

static double vertical(const struct field *field, int piece, double s)
{
	const struct hawser__lmode_piece *at = &field->t->rope->piece[piece];
	const struct hawser_line_modes_piece *on = &field->modes->piece[piece];
	double angle, u[3];

	hawser_line_at(field->modes->lane[at->lane], NULL, &angle, NULL, NULL, NULL,
	               fmin(at->s0 + s, at->s0 + at->length)*field->modes->length_unit);
	if (field->mode >= 0)
		hawser__grid_at(u, &on->grid, field->modes->shape +
		                3*((size_t)field->mode*(size_t)field->modes->points + (size_t)on->first), 3, 3,
		                s);
	else
		hawser__lexpand_field_at(u, NULL, field->t->rope, field->t->second +
		                         (size_t)field->pair*field->t->width, piece, s, angle);
	return u[0]*sin(angle) + u[1]*cos(angle);
}

/* add[waves] += the integral of y times each wave over a piece. */
static void integrate(double *sum, const struct field *field, int piece,
                      const struct hawser__line_wave *wave, int waves)
{
	const struct hawser_grid *grid = &field->modes->piece[piece].grid;
	double s0 = field->t->rope->piece[piece].s0;
	int lane = field->t->rope->piece[piece].lane;

	for (int e = 0; e < grid->elements; e++) {
		double length = grid->edge[e + 1] - grid->edge[e];
		int parts = 1 + (int)(wave[waves - 1].number*length/longest/grid->order);

		for (int p = 0; p < parts; p++)
			for (int i = 0; i < grid->order; i++) {
				double s = grid->edge[e] + length/parts*(p + 0.5*(1.0 + grid->node[i]));
				double y = grid->weight[e*grid->order + i]/parts*vertical(field, piece, s);

				for (int k = 0; k < waves; k++)
					sum[k] += y*hawser__line_pull(&wave[k], lane, s0 + s);
			}
	}
}

static void project(double *sum, const struct field *field, const struct hawser__line_wave *wave,
                    int waves)
{
	for (int k = 0; k < waves; k++)
		sum[k] = 0.0;
	for (int i = 0; i < field->t->rope->pieces; i++)
		if (wave->scale[field->t->rope->piece[i].lane] != 0.0 &&
		    field->modes->piece[i].grid.points > 0)
			integrate(sum, field, i, wave, waves);
}

/* Mass that runs along a lane over that of the rope; signed: positive from end A to end B. */
static double running_of(const struct hawser_line_modes *modes, const struct hawser_line_rom_options *o,
                         int lane)
{
	return o->running[lane]/modes->rho*(o->modes.backward[lane] ? -1.0 : 1.0);
}

/* Integral of Phi_j.Phi_k' over a piece. */
static double along(const struct hawser_line_modes *modes, const struct hawser_line_modes_piece *piece,
                    int j, int k)
{
	size_t first = (size_t)piece->first, points = (size_t)modes->points;
	const double *u = modes->shape + 3*((size_t)j*points + first);
	const double *slope = modes->slope + 3*((size_t)k*points + first), *weight = modes->weight + first;
	double sum = 0.0;

	for (int p = 0; p < piece->grid.points; p++, u += 3, slope += 3)
		sum += weight[p]*(u[0]*slope[0] + u[1]*slope[1] + u[2]*slope[2]);
	return sum;
}

/* r (A - A') times the speed, plus what is in G [n][n]. */
static void add_gyroscopic(double *G, int n, const struct hawser_line_modes *modes,
                           const struct hawser_line_rom_options *o, double speed)
{
	for (int j = 0; j < modes->n; j++)
		for (int k = 0; k < modes->n; k++) {
			double sum = 0.0;

			for (int i = 0; i < modes->pieces && modes->mode[j].plane == modes->mode[k].plane; i++) {
				const struct hawser_line_modes_piece *piece = &modes->piece[i];

				sum += speed*running_of(modes, o, piece->lane)*along(modes, piece, j, k);
			}
			G[j*n + k] += sum;
			G[k*n + j] -= sum;
		}
}

static enum hawser_status passing_runs(struct hawser_rom *rom, const struct hawser_line_modes *modes,
                                       const struct hawser_line_rom_options *o,
                                       struct hawser_report *report)
{
	struct hawser_harmonic *h = &rom->harmonic[rom->harmonics];

	if (!(o->running[0] + o->running[1] > 0.0))
		return HAWSER_OK;
	h->D = calloc((size_t)rom->n*(size_t)rom->n, sizeof *h->D);
	if (!h->D)
		return hawser__no_memory(report, "line rom");
	rom->harmonics++;
	h->phase = HAWSER_COS;
	h->omega_power = 1;
	add_gyroscopic(h->D, rom->n, modes, o, o->spacing/modes->length_unit/(2.0*M_PI));
	return HAWSER_OK;
}

enum { WAVES_MOST = 60 }; /* two of each harmonic */

static enum hawser_status passing(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                  const struct hawser_line_modes *modes,
                                  const struct hawser_line_rom_options *o,
                                  struct hawser_report *report)
{
	struct hawser__line_wave wave[WAVES_MOST];
	struct hawser_harmonic *h[WAVES_MOST];
	struct field field = {.t = t, .modes = modes, .pair = -1};
	double sum[WAVES_MOST];
	int waves = 2*o->harmonics;

	rom->harmonic = calloc((size_t)waves + 1, sizeof *rom->harmonic);
	if (!rom->harmonic)
		return hawser__no_memory(report, "line rom");
	for (int k = 0; k < waves; k++) {
		wave[k] = hawser__line_wave(modes, o, k);
		h[k] = add(rom, k/2 + 1, k%2 ? HAWSER_SIN : HAWSER_COS, report);
		if (!h[k])
			return HAWSER_ERR_MEMORY;
	}
	for (int j = 0; j < modes->n; j++) {
		field.mode = j;
		project(sum, &field, wave, waves);
		for (int k = 0; k < waves; k++)
			h[k]->f[j] = sum[k];
	}
	field.mode = -1;
	for (int j = 0; j < modes->n; j++)
		for (int l = 0; l <= j; l++) {
			if (modes->mode[j].plane != modes->mode[l].plane)
				continue;
			field.pair = hawser__pair(l, j);
			project(sum, &field, wave, waves);
			for (int k = 0; k < waves; k++)
				h[k]->K[j*rom->n + l] = h[k]->K[l*rom->n + j] = -sum[k];
		}
	return passing_runs(rom, modes, o, report);
}

double hawser__line_force(const struct hawser__lexpand *t, const struct hawser_line_modes *modes,
                          const struct hawser_line_rom_options *o, const double *pull, int j)
{
	struct hawser__line_wave wave[WAVES_MOST] = {{.sine = 0}};
	const struct field field = {.t = t, .modes = modes, .mode = j, .pair = -1};
	double sum[WAVES_MOST] = {0.0}, most = 0.0;
	int waves = 2*o->harmonics;

	if (o->load != HAWSER_LINE_LOAD_PASSING)
		return o->load == HAWSER_LINE_LOAD_DRIVE ? fabs(pull[j]) : 0.0;
	for (int k = 0; k < waves; k++)
		wave[k] = hawser__line_wave(modes, o, k);
	project(sum, &field, wave, waves);
	for (int k = 0; k < waves; k += 2)
		most = fmax(most, hypot(sum[k], sum[k + 1]));
	return most;
}

/* --- drive --- */

static enum hawser_status drive(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                const struct hawser_line_modes *modes,
                                const struct hawser_line_rom_options *o, const double *pull,
                                struct hawser_report *report)
{
	struct hawser_harmonic *h;
	int n = rom->n;

	add_gyroscopic(rom->D, rom->n, modes, o, o->speed*modes->time_unit/modes->length_unit);
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	if (!rom->harmonic)
		return hawser__no_memory(report, "line rom");
	h = add(rom, 1, HAWSER_COS, report);
	if (!h)
		return HAWSER_ERR_MEMORY;
	for (int j = 0; j < modes->n; j++) {
		h->f[j] = -pull[j];
		for (int k = 0; k < modes->n; k++)
			for (int i = modes->n; i < t->n; i++)
				h->K[j*n + k] += t->third[(j*t->n + k)*t->n + i];
	}
	return HAWSER_OK;
}

enum hawser_status hawser__line_load(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                     const struct hawser_line_modes *modes,
                                     const struct hawser_line_rom_options *o, const double *pull,
                                     struct hawser_report *report)
{
	if (o->load == HAWSER_LINE_LOAD_PASSING)
		return passing(rom, t, modes, o, report);
	return o->load == HAWSER_LINE_LOAD_DRIVE ? drive(rom, t, modes, o, pull, report) : HAWSER_OK;
}
