/* response/time/surge.c - the tension of a cable whose travel speed changes, including axial waves.
 *
 *    f_s(t)   force of the change of speed and of the load on linear mode s, by harmonics and ramp
 *             (rom.h)
 *    y_s      its linear response from rest at t = 0, y'' + D_s y' + omega_s^2 y = f_s
 *    z(t)     static response of the whole cable to the forces at that time
 *             (rom/condense/answer_make.c)
 *    a_s      strain along the cable of mode s
 *
 * The condensed modes of a model respond statically, so that its tension lacks two effects of a
 * sudden change: axial waves, which may be as large as the static response, and the motion of
 * transverse modes that are not kept. The motion of these transverse modes is not linear: the change
 * of speed changes their stiffness and damping, and so does the tension. Therefore a second model,
 * the finer one, has the lowest FINER modes of the plane at least, and is integrated from rest in
 * step with the run. What is above its modes is linear to good accuracy and is added to its strain:
 *
 *      a of z(t)  -  sum over s of a_s f_s/omega_s^2  +  sum over the s above it of a_s y_s
 *
 * with the modes s of the curved cable from a basis of FUNCTIONS per component in the plane. The
 * first sum removes what z contains of these modes; z has no truncation error.
 *
 * If the run began at rest, and nothing moves out of the plane, the tension is that of the finer
 * model. Else the difference between it and the planar part of the model of the run, which begins at
 * rest too, is added to the tension of the run.
 *
 * Linear responses of all modes, also with the changes of D and K by the ramp, were tried instead of
 * a finer model. For a span braked from 18 to 2 m/s (doc/theory-travel-rom.md) they were off by up to
 * 4 %, depending on the number of modes of the run; the finer model is off by 0.1 % with any.
 * d'Alembert's solution for a straight cable has no truncation error and was tried. For sagging
 * cables its least tension is too high by 5 % and more, since waves are coupled with the transverse
 * motion, and since it omits the effect of the squared speed. Neglected are the ratio of the travel
 * speed to the wave speed, and terms of second order in the waves.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/integrate.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/time/surge_parts.h"
#include "rom/condense/answer.h"
#include "rom/build/build.h"
#include "rom/energy/kernel.h"

enum { FUNCTIONS = 48 };     /* per component: 2*48 modes are within HAWSER_ROM_MAX */
enum { FINER = 14 };         /* modes of the finer model: with 10 to 32 the least tension of the
                              * span of doc/theory-travel-rom.md differs by 0.4 % at most */
enum { RESOLVED = 30 };      /* transverse modes that this basis resolves: pi functions a wave */
enum { A_CROSSING = 48 };    /* samples during the transit of an axial wave from end to end; chosen */
enum { SAMPLES_MOST = 100000 };
/* The stated error has two parts; S is the largest change of the tension anywhere, T the least
 * tension before. S^2/T is the second-order part, which linear waves lack: the change of the
 * tension changes the transverse stiffness by S/T, and by this fraction the part of S that is due
 * to transverse motion, which is at most S. The factor 0.75 lies between the mean of a ramp, 1/2,
 * and its end, 1. The other part, proportional to S, is for the basis and for the neglected
 * gyroscopic forces and stiffness changes of the omitted modes. Its factor is empirical: 316 random
 * scenes of four seeds needed 0.093 at most (doc/theory-travel-rom.md). */
static const double second_order = 0.75, coarse = 0.1;
enum { FINEST = 20 };        /* up to which it has more; chosen for its time */
/* Its number of modes, over the index of the mode that stretches the cable most, is not between these.
 * For the span of doc/theory-travel-rom.md this index is 8, and the least tension is off by 4 % with 8
 * modes, by 1.5 % with 6, and by 0.4 % at most from 10 on; for another one it is 14, with 12 % for 14,
 * 4 % for 15, 3 % for 4 to 12, and 1 % for 20. */
static const double below = 0.7, above = 1.3;
static const double planar_within = 1e-9; /* largest coordinate out of the plane over the largest in it,
                                           * up to which a run is in the plane; chosen */
static const double smooth = 0.5; /* largest phase of the fastest kept mode between two rows for
                                   * Hermite interpolation: its error is smooth^4/384 of the motion
                                   * of that mode */

struct surge {
	const struct hawser_rom *rom;
	struct hawser_modes modes;
	struct hawser_rom all;          /* linear model of the whole basis, with the static responses to
	                                 * its forces */
	struct hawser_rom finer;        /* model of the first modes of that basis */
	struct hawser_rom planar;       /* `rom` without forces out of the plane; its harmonics are its
	                                 * own, the rest belongs to `rom`. n = 0: not needed */
	double omega;
	struct hawser__lone_modes lone; /* of `all`, from those of `finer` on */
	struct hawser__surge_run run, less; /* of `finer` and `planar` */
	double *extra;                  /* [HAWSER__EXTRA(places)] */
	double *tension, *rest, *minus; /* [places] at present, of the steady state, of `planar` */
	double change;                  /* N, largest change of the tension so far */
	double *u;                      /* [n] */
	struct hawser__hold hold;
};

static void surge_clear(struct surge *surge)
{
	for (int h = 0; surge->planar.harmonic && h < surge->planar.harmonics; h++)
		free(surge->planar.harmonic[h].f);
	free(surge->planar.harmonic);
	hawser__lone_modes_clear(&surge->lone);
	hawser__surge_run_clear(&surge->run);
	hawser__surge_run_clear(&surge->less);
	hawser_rom_clear(&surge->finer);
	hawser_rom_clear(&surge->all);
	hawser_modes_clear(&surge->modes);
	hawser__hold_clear(&surge->hold);
}

/* --- the plane --- */

static int out_of_plane(const struct hawser_rom *rom, int j)
{
	const double *slope = rom->line.slope + 3*(size_t)j*(size_t)rom->line.points;
	double in = 0.0, out = 0.0;

	for (int p = 0; p < rom->line.points; p++) {
		in += fabs(slope[3*p]) + fabs(slope[3*p + 1]);
		out += fabs(slope[3*p + 2]);
	}
	return out > in;
}

/* Whether the run begins at rest at t = 0 and nothing moves out of the plane. */
static int rests_and_planar(const struct hawser_trajectory *run, const struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n, rows = (size_t)run->rows;
	double in = 0.0, out = 0.0;

	if (run->time[0] != 0.0)
		return 0;
	for (size_t i = 0; i < 2*n; i++)
		if (run->state[i] != 0.0)
			return 0;
	for (size_t j = 0; j < n; j++) {
		double *most = out_of_plane(rom, (int)j) ? &out : &in;

		for (size_t row = 0; row < rows; row++)
			*most = fmax(*most, fabs(run->state[2*n*row + j]));
	}
	return out <= planar_within*in;
}

/* surge->planar from `rom`. */
static enum hawser_status make_planar(struct surge *surge, const struct hawser_rom *rom,
                                      struct hawser_report *report)
{
	struct hawser_harmonic *copy = calloc((size_t)rom->harmonics + 1, sizeof *copy);
	size_t size = (size_t)rom->n*sizeof(double);
	int good = copy != NULL;

	surge->planar = *rom;
	surge->planar.harmonic = copy;
	for (int h = 0; good && h < rom->harmonics; h++) {
		copy[h] = rom->harmonic[h];
		copy[h].f = NULL;
		if (rom->harmonic[h].f)
			good = (copy[h].f = malloc(size)) != NULL;
		for (int j = 0; good && copy[h].f && j < rom->n; j++)
			copy[h].f[j] = out_of_plane(rom, j) ? 0.0 : rom->harmonic[h].f[j];
	}
	return good ? HAWSER_OK : hawser__no_memory(report, "surge");
}

/* --- the cable --- */

/* surge->extra: strain at time t beyond that of the finer model's coordinates. */
static void strain_at(struct surge *surge, double t)
{
	const struct hawser_rom_moment moment = {.tau = surge->omega*t, .omega = surge->omega, .time = t};
	int places = surge->rom->line.points;

	memset(surge->extra, 0, (size_t)places*sizeof *surge->extra);
	(void)hawser__rom_answer_strains(&surge->all, surge->extra, &moment);
	hawser__lone_modes_at(&surge->lone, t, surge->omega);
	for (int s = 0; s < surge->all.n; s++) {
		const double *slope = surge->all.line.slope + 3*(size_t)s*(size_t)places;
		double y = surge->lone.y[s] - surge->lone.held[s];

		for (int p = 0; p < places; p++)
			surge->extra[p] += y*slope[3*p];
	}
}

/* surge->tension at time t; surge->u is the state of the run. */
static enum hawser_status tension_at(struct surge *surge, double t, struct hawser_report *report)
{
	const struct hawser_rom *rom = surge->rom;
	enum hawser_status status = hawser__surge_run_at(&surge->run, t, report);

	if (!status && surge->planar.n > 0)
		status = hawser__surge_run_at(&surge->less, t, report);
	if (status)
		return status;
	strain_at(surge, t);
	hawser__rom_tensions_all(&surge->finer, surge->tension, surge->run.y, surge->extra);
	if (surge->planar.n == 0)
		return HAWSER_OK;
	hawser__rom_tensions_all(rom, surge->minus, surge->less.y, NULL);
	for (int p = 0; p < rom->line.points; p++)
		surge->tension[p] -= surge->minus[p];
	hawser__rom_tensions_all(rom, surge->minus, surge->u, NULL);
	for (int p = 0; p < rom->line.points; p++)
		surge->tension[p] += surge->minus[p];
	return HAWSER_OK;
}

/* The linear modes of the whole cable; z without the inertia that y_s contains. */
static enum hawser_status make_all(struct surge *surge, const struct hawser_statics *statics,
                                   const struct hawser_scene *scene, struct hawser_report *report)
{
	enum hawser_status status = hawser_modes_basis(&surge->modes, statics, FUNCTIONS, 0, report);

	if (!status)
		status = hawser__rom_begin(&surge->all, &surge->modes, scene, report);
	if (!status)
		status = hawser__rom_finish(&surge->all, &surge->modes, scene, report);
	if (!status)
		status = hawser__rom_answers(&surge->all, &surge->modes, 0, scene, report);
	for (int h = 0; !status && h < surge->all.harmonics; h++) {
		size_t count = HAWSER__ANSWER_LINE(&surge->all)/2;

		if (surge->all.harmonic[h].answer_line)
			memset(surge->all.harmonic[h].answer_line + count, 0, count*sizeof(double));
	}
	return status;
}

/* Index from 0 of the mode that stretches the cable most as a whole, by its part in the flexibility
 * (integral of a_s)^2/omega_s^2: with a sagging cable a transverse one. */
static int stretching_mode(const struct hawser_rom *all, int transverse)
{
	int best = 0, places = all->line.points;
	double most = 0.0;

	for (int s = 0; s < transverse && s < RESOLVED; s++) {
		const double *slope = all->line.slope + 3*(size_t)s*(size_t)places;
		double mean = 0.0, part;

		for (int p = 0; p < places; p++)
			mean += slope[3*p];
		part = mean*mean/all->K[(size_t)s*((size_t)all->n + 1)];
		if (part > most) {
			most = part;
			best = s;
		}
	}
	return best;
}

/* Number of modes of the finer model: FINER, and as many as the run has in the plane, but none that is
 * axial; and a distance from the mode that stretches the cable most. Where the last mode is close to
 * it in frequency, its static response to pairs of modes is wrong. */
static int finer_modes(const struct surge *surge)
{
	int count = 0, transverse = 0;
	double stretching;

	for (int j = 0; j < surge->rom->n; j++)
		count += !out_of_plane(surge->rom, j);
	while (transverse < surge->modes.n &&
	       surge->modes.mode[transverse].family == HAWSER_TRANSVERSE)
		transverse++;
	stretching = stretching_mode(&surge->all, transverse) + 1.0;
	count = count > FINER ? count : FINER;
	if (count > below*stretching && count < above*stretching)
		count = above*stretching <= FINEST ? (int)ceil(above*stretching)
		                                   : (int)floor(below*stretching);
	if (count > transverse)
		count = transverse;
	return count > 1 ? count : 1;
}

static enum hawser_status make_finer(struct surge *surge, const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	struct hawser_modes lowest = surge->modes;
	struct hawser_scene condensed = *scene;

	lowest.n = finer_modes(surge);
	condensed.model.condense = HAWSER_CONDENSE_STATIC;
	return hawser_rom_build(&surge->finer, &lowest, &condensed, report);
}

static enum hawser_status surge_make(struct surge *surge, const struct hawser_trajectory *run,
                                     const struct hawser_statics *statics,
                                     const struct hawser_scene *scene,
                                     struct hawser_report *report)
{
	const struct hawser_rom *rom = surge->rom;
	size_t places = (size_t)rom->line.points;
	double end = run->time[run->rows - 1];
	enum hawser_status status = make_all(surge, statics, scene, report);

	if (!status)
		status = make_finer(surge, scene, report);
	if (!status)
		status = hawser__surge_run_open(&surge->run, &surge->finer, surge->omega, end, report);
	if (!status && !rests_and_planar(run, rom)) {
		status = make_planar(surge, rom, report);
		if (!status)
			status = hawser__surge_run_open(&surge->less, &surge->planar, surge->omega, end,
			                                report);
	}
	if (status)
		return status;
	surge->extra = hawser__hold(&surge->hold, HAWSER__EXTRA(places), sizeof *surge->extra);
	surge->tension = hawser__hold(&surge->hold, places, sizeof *surge->tension);
	surge->minus = hawser__hold(&surge->hold, places, sizeof *surge->minus);
	surge->rest = hawser__hold(&surge->hold, places, sizeof *surge->rest);
	surge->u = hawser__hold(&surge->hold, (size_t)rom->n, sizeof *surge->u);
	if (surge->hold.short_of_memory ||
	    !hawser__lone_modes_make(&surge->lone, &surge->all, surge->finer.n, surge->omega))
		return hawser__no_memory(report, "surge");
	hawser__rom_tensions_all(rom, surge->rest, surge->u, NULL);
	return HAWSER_OK;
}

/* --- the run --- */

/* surge->u at time t between two rows, by Hermite's cubic. */
static void interpolate(struct surge *surge, const struct hawser_trajectory *run, int row, double t)
{
	int n = run->n, next = row + 1 < run->rows ? row + 1 : row;
	const double *a = run->state + (size_t)row*2*(size_t)n, *b = run->state + (size_t)next*2*(size_t)n;
	double step = run->time[next] - run->time[row], x = step > 0.0 ? (t - run->time[row])/step : 0.0;
	double x2 = x*x, x3 = x2*x;

	for (int j = 0; j < n; j++)
		surge->u[j] = (2.0*x3 - 3.0*x2 + 1.0)*a[j] + (3.0*x2 - 2.0*x3)*b[j] +
		              step*((x3 - 2.0*x2 + x)*a[n + j] + (x3 - x2)*b[n + j]);
}

/* Actual speed, m/s, at scaled time t. */
static double speed_at(const struct surge *surge, const struct hawser_scene *scene, double t)
{
	double time = t*surge->rom->time, part;

	if (!(scene->travel.braking > 0.0))
		return scene->travel.speed + scene->travel.fluctuation*sin(surge->omega*t);
	part = fmin(time/scene->travel.braking, 1.0);
	return scene->travel.speed + part*(scene->travel.final - scene->travel.speed);
}

static enum hawser_status look(struct hawser_surge *result, struct surge *surge,
                               const struct hawser_scene *scene, double t,
                               struct hawser_report *report)
{
	const struct hawser_rom *rom = surge->rom;
	const struct hawser_rom_moment moment = {.tau = surge->omega*t, .omega = surge->omega, .time = t};
	double rho = scene->cable.rho + scene->static_load.mass;
	double least, most, v = speed_at(surge, scene, t), taken = rho*v*v;
	enum hawser_status status = tension_at(surge, t, report);

	if (status)
		return status;
	(void)hawser_rom_tensions_at(rom, &least, &most, surge->u, &moment);
	for (int p = 0; p < rom->line.points; p++) {
		double T = surge->tension[p];

		if (!(T >= result->least)) {
			result->least = T;
			result->least_at = t;
		}
		if (!(T <= result->most)) {
			result->most = T;
			result->most_at = t;
		}
		if (!(T - taken >= result->spare)) {
			result->spare = T - taken;
			result->spare_at = t;
		}
		surge->change = fmax(surge->change, fabs(T - surge->rest[p]));
		result->beyond = fmax(result->beyond, fmax(least - T, T - most));
	}
	return HAWSER_OK;
}

/* If rows are too far apart for interpolation, the motion is computed again with closer ones. */
static enum hawser_status closer(struct hawser_trajectory *to, const struct surge *surge,
                                 const struct hawser_trajectory *run, struct hawser_report *report)
{
	const struct hawser_rom *rom = surge->rom;
	double top = 0.0, widest = 0.0, span = run->time[run->rows - 1] - run->time[0];
	struct hawser_integrate_options options = {.omega = surge->omega, .begin = run->time[0],
		.until = run->time[run->rows - 1], .initial = run->state, .rtol = 1e-8, .atol = 1e-12};

	*to = (struct hawser_trajectory){.rows = 0};
	for (int s = 0; s < rom->n; s++)
		top = fmax(top, rom->K[(size_t)s*((size_t)rom->n + 1)]);
	for (int i = 1; i < run->rows; i++)
		widest = fmax(widest, run->time[i] - run->time[i - 1]);
	if (widest*sqrt(top) <= smooth)
		return HAWSER_OK;
	options.every = fmax(smooth/sqrt(top), span/SAMPLES_MOST);
	return hawser_integrate(to, rom, &options, report);
}

static double estimated(const struct surge *surge)
{
	double least = surge->rest[0];

	for (int p = 1; p < surge->rom->line.points; p++)
		least = fmin(least, surge->rest[p]);
	return surge->change*(coarse + second_order*surge->change/least);
}

/* All samples of the run. Below rho v^2 the motion is not well posed, and grows the faster the finer
 * the model: where that ends the run of the finer model, the samples before it are the result. */
static enum hawser_status look_along(struct hawser_surge *result, struct surge *surge,
                                     const struct hawser_trajectory *run,
                                     const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, struct hawser_report *report)
{
	double crossing = statics->l*sqrt(statics->epsilon);
	double span = run->time[run->rows - 1] - run->time[0];
	double step = fmax(crossing/A_CROSSING, span/SAMPLES_MOST);
	enum hawser_status status = HAWSER_OK;

	for (int row = 0; !status && row < run->rows; row++) {
		double from = run->time[row], to = row + 1 < run->rows ? run->time[row + 1] : from;
		int count = to > from ? (int)ceil((to - from)/step) : 1;

		for (int i = 0; !status && i < count; i++) {
			double t = from + (to - from)*i/count;

			interpolate(surge, run, row, t);
			status = look(result, surge, scene, t, report);
		}
	}
	return status == HAWSER_ERR_CONVERGENCE && result->spare < 0.0 ? HAWSER_OK : status;
}

enum hawser_status hawser_surge_look(struct hawser_surge *result, const struct hawser_trajectory *run,
                                     const struct hawser_rom *rom,
                                     const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, double omega,
                                     struct hawser_report *report)
{
	struct surge surge = {.rom = rom, .omega = omega};
	struct hawser_trajectory again = {.rows = 0};
	enum hawser_status status = HAWSER_OK;

	*result = (struct hawser_surge){.least = HUGE_VAL, .most = -HUGE_VAL, .spare = HUGE_VAL};
	if (!scene->travel.present || rom->exact || rom->line.points < 1 || run->rows < 2 ||
	    rom->shapes.EA <= 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "surge",
		                    "axial waves of a change of the travel speed require a scene with "
		                    "`travel`, a model of it without the exact energy, and a run");
	status = surge_make(&surge, run, statics, scene, report);
	if (!status)
		status = closer(&again, &surge, run, report);
	if (status)
		goto done;
	if (again.rows > 1)
		run = &again;
	status = look_along(result, &surge, run, statics, scene, report);
	result->error = estimated(&surge);
	if (!status && (!isfinite(result->least) || !isfinite(result->most)))
		status = hawser__fail(report, HAWSER_ERR_NAN, "surge",
		                      "the tension with the waves of the speed's change is not finite");
done:
	hawser_trajectory_clear(&again);
	surge_clear(&surge);
	return status;
}

double hawser_surge_steady(double rho, double EA, double length, double acceleration, double omega)
{
	double k = omega/sqrt(EA/rho), x = 0.5*k*length, largest = x < M_PI_2 ? sin(x) : 1.0;

	if (x < 1e-8)
		return 0.5*rho*acceleration*length;
	return rho*acceleration*largest/(k*fabs(cos(x)));
}
