/* rom/condense/support.c - inertia and damping of the quasi-static displacement of moving supports.
 *
 *    s_E,x(tau)   displacement of end E, or of the foundation of its springs, along axis x:
 *                 motion*cos(harmonic*tau + phase)
 *    psi_x        quasi-static displacement by a unit displacement of end B along x (support_shape.c);
 *                 by that of end A it is the unit vector minus psi_x, but for springs
 *    r            sum over ends and axes of s times that displacement
 *    u            displacement relative to r, expanded in the modes: it vanishes at rigid ends
 *
 * The axes are those of the plane in which the cable hangs. The total displacement is r + u. r is in
 * equilibrium with all springs and without a load, so that the linear elastic forces of r on u vanish.
 * Its inertia and its damping by still air are loads on u,
 *
 *    - r'' - alpha r'       (scaled; the mass per length is 1)
 *
 * and so are, at attachments and at ends with a mass, -m r'' and the forces -c r' of dampers, r there
 * relative to what they are fixed to (attach.damper_to). The condensed modes respond to them as to any
 * other load (answer_make.c, follow.h), but for the dampers' forces: their responses to these are
 * coordinates of the model (dampers.c). Damping that is proportional to the stiffness has no force in
 * r, and a ratio of critical damping refers to u.
 * The terms of higher degree of the strain energy are in support_energy.c (doc/theory-rom.md, "Moving
 * supports").
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "core/vec3.h"
#include "modes/label.h"
#include "rom/build/model.h"
#include "rom/condense/condense.h"
#include "rom/terms/ends.h"
#include "rom/terms/history.h"
#include "rom/condense/support.h"
#include "statics/frame.h"

int hawser__support_moves(const struct hawser_scene *scene)
{
	for (int end = 0; end < 2; end++)
		for (int axis = 0; scene && scene->support[end].present && axis < HAWSER__AXES; axis++)
			if (scene->support[end].motion[axis] != 0.0 || scene->support[end].given[axis])
				return 1;
	return 0;
}

int hawser__support_given(const struct hawser_scene *scene)
{
	for (int end = 0; end < 2; end++)
		for (int axis = 0; scene && scene->support[end].present && axis < HAWSER__AXES; axis++)
			if (scene->support[end].given[axis])
				return 1;
	return 0;
}

double hawser__support_weight(int number, int end, int axis, const struct hawser_statics *statics)
{
	double unit[HAWSER__AXES] = {0.0}, in[HAWSER__AXES];

	unit[axis] = 1.0;
	hawser_statics_from_global(statics, in, unit);
	if (number >= HAWSER__AXES)
		return end == 0 ? in[number - HAWSER__AXES] : 0.0;
	return end == 0 ? -in[number] : in[number];
}

/* Displacement of `end` (0: A, 1: B), or with end 2 of B relative to A, along `axis` of the plane of
 * the cable, scaled. */
static void support_signal(struct hawser__signal *signal, const struct hawser_scene *scene, int end,
                           int axis, const struct hawser_statics *statics)
{
	memset(signal, 0, sizeof *signal);
	for (int e = 0; e < 2; e++) {
		double phase = scene->support[e].phase, size, in[3];
		int k = scene->support[e].harmonic;

		if (!scene->support[e].present || (end != 2 && end != e))
			continue;
		hawser_statics_from_global(statics, in, scene->support[e].motion);
		size = in[axis]/statics->span.d*(end == 2 && e == 0 ? -1.0 : 1.0);
		if (size == 0.0)
			continue;
		signal->c[k] += size*cos(phase);
		/* exactly zero in phase and in opposite phase */
		signal->s[k] -= phase == 0.0 || fabs(phase) == M_PI ? 0.0 : size*sin(phase);
	}
}

int hawser__support_factor(struct hawser__signal *signal, const struct hawser_scene *scene, int number,
                           const struct hawser_statics *statics)
{
	int any = 0;

	support_signal(signal, scene, number < HAWSER__AXES ? 2 : 0, number%HAWSER__AXES, statics);
	for (int i = 0; i < 2*HAWSER__AXES; i++)
		any |= scene->support[i/HAWSER__AXES].present &&
		       scene->support[i/HAWSER__AXES].given[i%HAWSER__AXES] &&
		       hawser__support_weight(number, i/HAWSER__AXES, i%HAWSER__AXES, statics) != 0.0;
	for (int k = 0; k <= HAWSER__SUPPORT_TOP; k++)
		any |= signal->c[k] != 0.0 || signal->s[k] != 0.0;
	return any;
}

/* --- the field --- */

enum { MARKS = HAWSER_ATTACH_MAX + 2 };

/* r of one harmonic. */
struct field {
	const struct hawser__support_shapes *shapes;
	double factor[HAWSER__SUPPORT_MOST];  /* of the shapes */
	double rigid[HAWSER__AXES];           /* translation with end A */
	double *r;                            /* [3][points] */
	double at[MARKS][3];                  /* at the points of label.h */
	double *force;                        /* [3][points] of its inertia or damping, */
	double point[MARKS][3];               /* and at these points, */
	double stroke[HAWSER_ATTACH_MAX];     /* and on the strokes of absorbers, of which r has none */
};

static void set_field(struct field *field, int count)
{
	const struct hawser__support_shapes *shapes = field->shapes;
	size_t points = (size_t)shapes->points, marks = (size_t)count;

	for (size_t i = 0; i < 3*points; i++)
		field->r[i] = field->rigid[i/points];
	for (size_t m = 0; m < 3*marks; m++)
		field->at[m/3][m%3] = field->rigid[m%3];
	for (size_t x = 0; x < (size_t)shapes->count; x++) {
		for (size_t i = 0; i < 3*points; i++)
			field->r[i] += field->factor[x]*shapes->shape[x*3*points + i];
		for (size_t m = 0; m < 3*marks; m++)
			field->at[m/3][m%3] += field->factor[x]*shapes->at[3*marks*x + m];
	}
}

/* Work of the forces on mode j. */
static double work_on(const struct field *field, const struct hawser_modes *modes, int j)
{
	const struct hawser_grid *grid = &modes->grid;
	int points = grid->points;
	const double *shape = modes->shape + (size_t)j*(size_t)points*3, *force = field->force;
	double sum = 0.0, u[3];

	for (int p = 0; p < points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, grid->s[p]);
		const double f[3] = {force[p], force[points + p], force[2*points + p]};

		hawser__frame_in(u, &at, f);
		sum += grid->weight[p]*hawser__dot(u, shape + 3*p);
	}
	for (int i = 0; i < hawser__points(&modes->statics); i++) {
		hawser__modes_attached(u, modes, j, i);
		for (int c = 0; c < 3; c++)
			sum += field->point[i][c]*u[c];
		if (i < modes->statics.attachments)
			sum += field->stroke[i]*hawser__stroke(modes, j, i);
	}
	return sum;
}

/* Displacement at the shape points: `answer` of the harmonic. The strains are in ends.c. */
static enum hawser_status show(struct hawser_harmonic *h, const struct hawser_rom *rom,
                               const struct hawser_modes *modes, const struct field *field,
                               struct hawser_report *report)
{
	int points = rom->shapes.points;

	h->answer = calloc(2*4*(size_t)points + 1, sizeof *h->answer);
	if (!h->answer)
		return hawser__no_memory(report, "rom");
	for (int p = 0; p < points; p++)
		hawser__displaced_at(h->answer + 4*p, rom, &modes->statics, &modes->grid, field->r, NULL, p);
	return HAWSER_OK;
}

/* Displacement along axis c of what an attachment's damper is fixed to. */
static double fixed_to(const struct field *field, const struct hawser_attached *at, int c)
{
	double end = at->damper_to == 2 ? field->rigid[c] + field->factor[c] : field->rigid[c];

	return at->damper_to ? end : 0.0;
}

/* The force of the dampers of attachment i on what they are fixed to, scaled; returns whether there are
 * any. */
static int damper_force(double force[3], const struct field *field, const struct hawser_statics *st,
                        int i)
{
	const struct hawser_attached *at = &st->attached[i];
	double axis[3][3], moved[3];
	int any = 0;

	hawser_statics_damper(axis, st, i);
	for (int c = 0; c < 3; c++) {
		moved[c] = field->at[i][c] - fixed_to(field, at, c);
		force[c] = 0.0;
	}
	for (int c = 0; c < 3; c++) {
		double pull = at->damper[c]/sqrt(st->span.rho*st->H)*hawser__dot(axis[c], moved);

		for (int k = 0; k < 3; k++)
			force[k] += pull*axis[c][k];
		any |= at->damper[c] > 0.0;
	}
	return any;
}

/* Forces of unit inertia (rate = 0) or damping (1) of r, times `factor`; those of dampers of
 * attachments only with `dampers`. Returns whether there are any. */
static int set_force(struct field *field, const struct hawser_scene *scene,
                     const struct hawser_modes *modes, int rate, double factor, int dampers)
{
	const struct hawser_statics *st = &modes->statics;
	double t = modes->time_unit, on_cable = 1.0, on_mass = 1.0;
	size_t points = (size_t)modes->grid.points;
	int any;

	if (rate) {
		on_mass = scene->damping.kind == HAWSER_DAMPING_RAYLEIGH ? scene->damping.mass*t : 0.0;
		on_cable = scene->damping.kind == HAWSER_DAMPING_ALPHA
		           ? scene->damping.alpha*t/st->span.rho : on_mass;
	}
	any = on_cable != 0.0;
	for (size_t i = 0; i < 3*points; i++)
		field->force[i] = factor*on_cable*field->r[i];
	for (int i = 0; i < st->attachments; i++) {
		const double *a = st->attached[i].absorber_axis, *r = field->at[i];

		/* the damping of the scene does not act on absorbers */
		field->stroke[i] = rate ? 0.0 : factor*st->attached[i].absorber*
		                                (a[0]*r[0] + a[1]*r[1] + a[2]*r[2]);
	}
	for (int i = 0; i < hawser__points(st); i++) {
		double each = on_mass*(rate ? hawser__point_bare(st, i) : hawser__point(st, i).m);
		double force[3] = {0.0};

		any |= each != 0.0;
		if (rate && dampers && i < st->attachments)
			any |= damper_force(force, field, st, i);
		for (int c = 0; c < 3; c++)
			field->point[i][c] = factor*(each*field->at[i][c] + force[c]);
	}
	return any;
}

/* Another harmonic of the model, with a zero f. */
static struct hawser_harmonic *append(struct hawser_rom *rom, int k, enum hawser_phase phase,
                                      int power)
{
	struct hawser_harmonic *h = hawser__rom_harmonic(rom, k, phase);

	if (!h)
		return NULL;
	h->omega_power = power;
	h->f = hawser__numbers((size_t)rom->n, 1);
	return h->f ? h : NULL;
}

/* r = field*wave(k tau), or (signal >= 0) times a signal of the history: its displacement, inertia and
 * damping. */
static enum hawser_status add(struct hawser_rom *rom, const struct hawser_modes *modes, int moving,
                              int condensed, const struct hawser_scene *scene, int k,
                              enum hawser_phase phase, int signal, struct field *field,
                              struct hawser_report *report)
{
	struct hawser_harmonic *h = append(rom, k, phase, 0);
	enum hawser_status status = h ? HAWSER_OK : hawser__no_memory(report, "rom");

	set_field(field, hawser__points(&modes->statics));
	if (!status)
		status = show(h, rom, modes, field, report);
	if (!status && signal >= 0)
		status = hawser__history_take(rom, &(struct hawser_history_factor){1, {signal}, 0}, report);
	for (int rate = 0; !status && rate < 2; rate++) {
		/* cos'' = -k^2 Omega^2 cos; cos' = -k Omega sin, sin' = k Omega cos */
		double factor = signal >= 0 ? -1.0 : !rate ? (double)k*k : phase == HAWSER_COS ? k : -k;

		if (!set_force(field, scene, modes, rate, factor, 1))
			continue;
		h = append(rom, k, !rate ? phase : phase == HAWSER_COS ? HAWSER_SIN : HAWSER_COS,
		           rate ? 1 : 2);
		if (!h)
			return hawser__no_memory(report, "rom");
		for (int j = 0; j < rom->n; j++)
			h->f[j] = work_on(field, modes, j);
		if (condensed && set_force(field, scene, modes, rate, factor, 0))
			status = hawser__rom_answer_field(rom, rom->harmonics - 1, modes, moving,
			                                  field->force, field->point[0], field->stroke,
			                                  report);
		if (!status && signal >= 0)
			status = hawser__history_take(rom, &(struct hawser_history_factor){1, {signal},
			                              rate ? 1 : 2}, report);
	}
	return status;
}

/* The amplitudes of harmonic k; returns whether one is not 0. */
static int set_amplitudes(struct field *field, const struct hawser_scene *scene, int k, int sine,
                          const struct hawser_statics *statics)
{
	struct hawser__signal signal;
	int any = 0;

	for (int i = 0; i < HAWSER__SUPPORT_MOST + HAWSER__AXES; i++) {
		double *to = i < HAWSER__SUPPORT_MOST ? &field->factor[i]
		             : &field->rigid[i - HAWSER__SUPPORT_MOST];

		(void)hawser__support_factor(&signal, scene, i < HAWSER__SUPPORT_MOST ? i : i - HAWSER__AXES,
		                             statics);
		*to = sine ? signal.s[k] : signal.c[k];
		any |= *to != 0.0;
	}
	return any;
}

/* The same of supports that move as a table says. */
static enum hawser_status add_given(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    int moving, int condensed, const struct hawser_scene *scene,
                                    struct field *field, struct hawser_report *report)
{
	struct hawser__signal unused;
	enum hawser_status status = hawser__history_begin(rom, scene, &modes->statics, report);

	for (int i = 0; !status && i < HAWSER__SUPPORT_MOST; i++) {
		if (!hawser__support_factor(&unused, scene, i, &modes->statics))
			continue;
		memset(field->factor, 0, sizeof field->factor);
		memset(field->rigid, 0, sizeof field->rigid);
		field->factor[i] = 1.0;
		if (i >= HAWSER__AXES)
			field->rigid[i - HAWSER__AXES] = 1.0;
		status = add(rom, modes, moving, condensed, scene, 1, HAWSER_COS, i, field, report);
	}
	return status;
}

enum hawser_status hawser__support_forces(struct hawser_rom *rom, const struct hawser_modes *modes,
                                          int moving, int condensed,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report)
{
	size_t count = 3*(size_t)modes->grid.points;
	struct hawser__support_shapes shapes;
	struct field field = {.shapes = &shapes, .r = malloc(2*count*sizeof(double))};
	enum hawser_status status = hawser__support_shapes_make(&shapes, modes, report);

	field.force = field.r + count;
	if (!status && !field.r)
		status = hawser__no_memory(report, "rom");
	if (!status)
		status = hawser__ends_set(rom, modes, &shapes, scene, report);
	for (int k = 1; !status && k <= HAWSER__SUPPORT_TOP; k++)
		for (int sine = 0; !status && sine < 2; sine++)
			if (set_amplitudes(&field, scene, k, sine, &modes->statics))
				status = add(rom, modes, moving, condensed, scene, k,
				             sine ? HAWSER_SIN : HAWSER_COS, -1, &field, report);
	if (!status && hawser__support_given(scene))
		status = add_given(rom, modes, moving, condensed, scene, &field, report);
	hawser__support_shapes_clear(&shapes);
	free(field.r);
	return status;
}
