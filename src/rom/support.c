/* rom/support.c - inertia and damping of the quasi-static displacement of moving supports.
 *
 *    s_E,x(tau)   displacement of end E along axis x, motion*cos(harmonic*tau + phase)
 *    psi_x        quasi-static displacement by a unit displacement of end B along x (support_shape.c);
 *                 by that of end A it is the unit vector minus psi_x
 *    r            sum over ends and axes of s times that displacement
 *    u            displacement relative to r, expanded in the modes: it vanishes at the ends
 *
 * The total displacement is r + u. r is in equilibrium without a load, so that the linear elastic
 * forces of r on u vanish. Its inertia and its damping by still air are loads on u:
 *
 *    - r'' - alpha r'       (scaled; the mass per length is 1)
 *
 * and the condensed modes respond to them as to any other load (answer_make.c, follow.h). Damping that
 * is proportional to the stiffness has no force in r, and a ratio of critical damping refers to u.
 * The terms of higher degree of the strain energy are in support_energy.c (doc/theory-rom.md, "Moving
 * supports").
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/support.h"

int hawser__support_moves(const struct hawser_scene *scene)
{
	for (int end = 0; end < 2; end++)
		for (int axis = 0; scene && scene->support[end].present && axis < HAWSER__AXES; axis++)
			if (scene->support[end].motion[axis] != 0.0)
				return 1;
	return 0;
}

void hawser__support_signal(struct hawser__signal *signal, const struct hawser_scene *scene, int end,
                            int axis, double length)
{
	memset(signal, 0, sizeof *signal);
	for (int e = 0; e < 2; e++) {
		double size = scene->support[e].motion[axis]/length, phase = scene->support[e].phase;
		int k = scene->support[e].harmonic;

		if (!scene->support[e].present || size == 0.0 || (end != 2 && end != e))
			continue;
		if (end == 2 && e == 0)
			size = -size;
		signal->c[k] += size*cos(phase);
		/* exactly zero in phase and in opposite phase */
		signal->s[k] -= phase == 0.0 || fabs(phase) == M_PI ? 0.0 : size*sin(phase);
	}
}

/* --- the field --- */

/* field [3][points] of r for the amplitudes amplitude[end][axis]. */
static void set_field(double *field, const struct hawser__support_shapes *shapes,
                      const double amplitude[2][HAWSER__AXES])
{
	size_t points = (size_t)shapes->points;

	for (size_t axis = 0; axis < 3; axis++)
		for (size_t p = 0; p < points; p++)
			field[axis*points + p] = amplitude[0][axis];
	for (size_t x = 0; x < HAWSER__AXES; x++)
		for (size_t i = 0; i < 3*points; i++)
			field[i] += (amplitude[1][x] - amplitude[0][x])*shapes->shape[x*3*points + i];
}

/* Integral of the field times mode j. */
static double work_on(const double *field, const struct hawser_modes *modes, int j)
{
	const struct hawser_grid *grid = &modes->grid;
	int points = grid->points;
	const double *shape = modes->shape + (size_t)j*(size_t)points*3;
	double sum = 0.0;

	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, grid->s[p]);
		const double *q = shape + 3*p;
		double x = field[p], y = field[points + p];

		sum += grid->weight[p]*(q[0]*(x*at.ex + y*at.ey) + q[1]*(y*at.ex - x*at.ey) +
		                        q[2]*field[2*points + p]);
	}
	return sum;
}

/* Displacement at the shape points, and strain a there and on the line: `answer` of the harmonic. */
static enum hawser_status show(struct hawser_harmonic *h, const struct hawser_rom *rom,
                               const struct hawser_modes *modes, const double *field,
                               const struct hawser__support_shapes *shapes,
                               const double amplitude[2][HAWSER__AXES],
                               struct hawser_report *report)
{
	const struct hawser_grid *grid = &modes->grid;
	int points = rom->shapes.points, line = rom->line.points;

	h->answer = calloc(2*4*(size_t)points + 1, sizeof *h->answer);
	h->answer_line = calloc(2*(size_t)line + 1, sizeof *h->answer_line);
	if (!h->answer || !h->answer_line)
		return hawser__no_memory(report, "rom");
	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, rom->shapes.s[p]);
		double *out = h->answer + 4*p, global[3];

		for (int axis = 0; axis < 3; axis++)
			hawser__grid_at(&global[axis], grid, field + axis*grid->points, 1, 1,
			                rom->shapes.s[p]);
		out[0] = global[0]*at.ex + global[1]*at.ey;
		out[1] = global[1]*at.ex - global[0]*at.ey;
		out[2] = global[2];
	}
	for (int x = 0; x < HAWSER__AXES; x++)
		for (int p = 0; p < points + line; p++) {
			double strain, share = amplitude[1][x] - amplitude[0][x];

			hawser__grid_at(&strain, grid, shapes->strain + (size_t)x*3*(size_t)grid->points,
			                3, 1, p < points ? rom->shapes.s[p] : rom->line.s[p - points]);
			*(p < points ? &h->answer[4*p + 3] : &h->answer_line[p - points]) +=
				share*strain;
		}
	return HAWSER_OK;
}

/* Viscous force per velocity of all points, scaled. */
static double viscous(const struct hawser_scene *scene, const struct hawser_modes *modes)
{
	switch (scene->damping.kind) {
	case HAWSER_DAMPING_ALPHA:
		return scene->damping.alpha*modes->time_unit/modes->statics.span.rho;
	case HAWSER_DAMPING_RAYLEIGH:
		return scene->damping.mass*modes->time_unit;
	case HAWSER_DAMPING_NONE:
	case HAWSER_DAMPING_RATIO:
		break;
	}
	return 0.0;
}

/* Another harmonic of the model, with a zero f. */
static struct hawser_harmonic *append(struct hawser_rom *rom, int k, enum hawser_phase phase,
                                      int power)
{
	struct hawser_harmonic *h = realloc(rom->harmonic,
	                                    ((size_t)rom->harmonics + 1)*sizeof *h);

	if (!h)
		return NULL;
	rom->harmonic = h;
	h += rom->harmonics++;
	*h = (struct hawser_harmonic){.k = k, .phase = phase, .omega_power = power,
		.f = calloc((size_t)rom->n, sizeof(double))};
	return h->f ? h : NULL;
}

/* r = field*wave(k tau): its displacement, inertia and damping. */
static enum hawser_status add(struct hawser_rom *rom, const struct hawser_modes *modes, int moving,
                              int condensed, const struct hawser_scene *scene, int k,
                              enum hawser_phase phase,
                              const struct hawser__support_shapes *shapes, double *field,
                              const double amplitude[2][HAWSER__AXES],
                              struct hawser_report *report)
{
	double air = viscous(scene, modes)*k*(phase == HAWSER_COS ? 1.0 : -1.0);
	struct hawser_harmonic *h = append(rom, k, phase, 0), *inertia = h;
	size_t count = 3*(size_t)modes->grid.points;
	enum hawser_status status = h ? HAWSER_OK : hawser__no_memory(report, "rom");

	set_field(field, shapes, amplitude);
	if (!status)
		status = show(h, rom, modes, field, shapes, amplitude, report);
	for (int i = 0; !status && i < (air != 0.0 ? 2 : 1); i++) {
		/* cos'' = -k^2 Omega^2 cos; cos' = -k Omega sin, sin' = k Omega cos */
		double factor = i == 0 ? (double)k*k : air;

		inertia = append(rom, k, i == 0 ? phase : phase == HAWSER_COS ? HAWSER_SIN : HAWSER_COS,
		                 i == 0 ? 2 : 1);
		if (!inertia)
			return hawser__no_memory(report, "rom");
		for (int j = 0; j < rom->n; j++)
			inertia->f[j] = factor*work_on(field, modes, j);
		if (!condensed)
			continue;
		for (size_t p = 0; p < count; p++)
			field[p] *= factor;
		status = hawser__rom_answer_field(rom, rom->harmonics - 1, modes, moving, field, report);
		for (size_t p = 0; p < count; p++)
			field[p] /= factor;
	}
	return status;
}

enum hawser_status hawser__support_forces(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          int moving, int condensed,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	struct hawser__support_shapes shapes;
	double *field = malloc(3*(size_t)modes->grid.points*sizeof *field);
	enum hawser_status status = hawser__support_shapes_make(&shapes, modes, report);

	if (!status && !field)
		status = hawser__no_memory(report, "rom");
	for (int k = 1; !status && k <= HAWSER__SUPPORT_TOP; k++)
		for (int sine = 0; !status && sine < 2; sine++) {
			double amplitude[2][HAWSER__AXES];
			int any = 0;

			for (int i = 0; i < 2*HAWSER__AXES; i++) {
				struct hawser__signal signal;
				double *to = &amplitude[i/HAWSER__AXES][i%HAWSER__AXES];

				hawser__support_signal(&signal, scene, i/HAWSER__AXES, i%HAWSER__AXES,
				                       rom->length);
				*to = sine ? signal.s[k] : signal.c[k];
				any |= *to != 0.0;
			}
			if (any)
				status = add(rom, modes, moving, condensed, scene, k,
				             sine ? HAWSER_SIN : HAWSER_COS, &shapes, field, amplitude,
				             report);
		}
	hawser__support_shapes_clear(&shapes);
	free(field);
	return status;
}
