/* response/surge.c - the tension of a cable whose travel speed changes, including axial waves.
 *
 *    f_s(t)   force of the change of speed and of the load on linear mode s, by harmonics and ramp
 *             (rom.h)
 *    y_s      its linear response from rest at t = 0, y'' + D_s y' + omega_s^2 y = f_s
 *    z(t)     static response of the whole cable to the forces at that time (rom/answer_make.c)
 *    a_s      strain along the cable of mode s
 *
 * The condensed modes of a model respond statically, so that its tension lacks two effects of a
 * sudden change: axial waves, which may be as large as the static response, and the motion of
 * transverse modes that are not kept. Both are linear to good accuracy and are added to the strain
 * of the model:
 *
 *      a of z(t) + sum over s of a_s (y_s - f_s/omega_s^2)  -  sum over the kept j of a_j y_j
 *
 * with the modes s of the curved cable from a basis of FUNCTIONS per component in the plane. The
 * first sum is the dynamic response of these modes beyond the static one, which z contains without
 * truncation. The second sum removes the part that the model's own coordinates contain. During the
 * ramp, and after its end, forces are polynomials of time or sines, so that y_s is known in closed
 * form.
 *
 * d'Alembert's solution for a straight cable has no truncation error and was tried. For sagging
 * cables its least tension is too high by 5 % and more, since waves are coupled with the transverse
 * motion, and since it omits the effect of the squared speed. Neglected are the ratio of the travel
 * speed to the wave speed, the change of the stiffness of omitted modes by the change of speed, and
 * second-order terms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/integrate.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/answer.h"
#include "rom/build.h"
#include "rom/kernel.h"

enum { FUNCTIONS = 48 };     /* per component: 2*48 modes are within HAWSER_ROM_MAX */
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
static const double smooth = 0.5; /* largest phase of the fastest kept mode between two rows for
                                   * Hermite interpolation: its error is smooth^4/384 of the motion
                                   * of that mode */

/* Linear modes with their motion, of one model. */
struct part {
	const struct hawser_rom *rom;
	double sign;
	double *y;                      /* [n] at the present time, without the static response if sign
	                                 * > 0 */
	double complex *root, *swing;   /* [n][2] roots of the free motion, and its amplitudes */
	double begin;                   /* time at which this free motion began */
	int over;                       /* 1: after the ramp */
};

struct surge {
	const struct hawser_rom *rom;
	struct hawser_modes modes;
	struct hawser_rom all;          /* linear model of the whole basis, with the static responses to
	                                 * its forces */
	double omega;
	struct part part[2];            /* of `all`, and of `rom` */
	double *extra;                  /* [places] */
	double *tension, *rest;         /* [places], and of the steady state */
	double change;                  /* N, largest change of the tension so far */
	double *u;                      /* [n] */
};

static void part_clear(struct part *part)
{
	free(part->y);
	free(part->root);
	free(part->swing);
}

static void surge_clear(struct surge *surge)
{
	part_clear(&surge->part[0]);
	part_clear(&surge->part[1]);
	hawser_rom_clear(&surge->all);
	hawser_modes_clear(&surge->modes);
	free(surge->extra);
	free(surge->tension);
	free(surge->rest);
	free(surge->u);
}

/* --- one mode --- */

static double stiffness(const struct part *part, int s)
{
	return part->rom->K[(size_t)s*((size_t)part->rom->n + 1)];
}

static double damping(const struct part *part, int s)
{
	return part->rom->D[(size_t)s*((size_t)part->rom->n + 1)];
}

/* Coefficients [3] of the force of the ramp on mode s, a polynomial of time. */
static void ramp_force(double c[3], const struct part *part, int s)
{
	const struct hawser_ramp *ramp = part->rom->ramp;
	double f[HAWSER_RAMP_TERMS];

	memset(c, 0, 3*sizeof *c);
	if (!ramp)
		return;
	for (int i = 0; i < HAWSER_RAMP_TERMS; i++)
		f[i] = ramp->term[i].f ? ramp->term[i].f[s] : 0.0;
	if (part->over) {
		c[0] = f[HAWSER_RAMP_LINEAR] + f[HAWSER_RAMP_SQUARE];
		return;
	}
	c[0] = f[HAWSER_RAMP_RATE]/ramp->time;
	c[1] = f[HAWSER_RAMP_LINEAR]/ramp->time;
	c[2] = f[HAWSER_RAMP_SQUARE]/(ramp->time*ramp->time);
}

/* Forced motion of mode s at time t: value and rate; and the static response to the force. */
static void forced(double motion[2], double *held, const struct part *part, int s, double t,
                   double omega)
{
	double k = stiffness(part, s), d = damping(part, s), c[3], p[3];

	ramp_force(c, part, s);
	p[2] = c[2]/k;
	p[1] = (c[1] - 2.0*d*p[2])/k;
	p[0] = (c[0] - d*p[1] - 2.0*p[2])/k;
	motion[0] = p[0] + t*(p[1] + t*p[2]);
	motion[1] = p[1] + 2.0*t*p[2];
	*held = (c[0] + t*(c[1] + t*c[2]))/k;
	for (int h = 0; h < part->rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &part->rom->harmonic[h];
		double w = harmonic->k*omega;
		double complex force, answer;

		if (!harmonic->f)
			continue;
		force = harmonic->f[s]*pow(omega, harmonic->omega_power)*cexp(I*w*t)*
		        (harmonic->phase == HAWSER_SIN ? -I : 1.0);
		answer = force/(k - w*w + I*w*d);
		motion[0] += creal(answer);
		motion[1] += creal(I*w*answer);
		*held += creal(force)/k;
	}
}

static void free_motion(double motion[2], const struct part *part, int s, double t)
{
	double complex value = 0.0, rate = 0.0;

	for (int i = 0; i < 2; i++) {
		double complex root = part->root[2*s + i];
		double complex term = part->swing[2*s + i]*cexp(root*(t - part->begin));

		value += term;
		rate += root*term;
	}
	motion[0] = creal(value);
	motion[1] = creal(rate);
}

/* Start the free motion from the state of mode s at time t. */
static void begin_mode(struct part *part, int s, const double state[2], double t, double omega)
{
	double complex *root = part->root + 2*(size_t)s, *swing = part->swing + 2*(size_t)s;
	double motion[2], held, y, v;

	forced(motion, &held, part, s, t, omega);
	y = state[0] - motion[0];
	v = state[1] - motion[1];
	swing[0] = (v - root[1]*y)/(root[0] - root[1]);
	swing[1] = y - swing[0];
}

static int part_make(struct part *part, const struct hawser_rom *rom, double sign, double omega)
{
	const double rest[2] = {0.0, 0.0};
	size_t n = (size_t)rom->n;

	*part = (struct part){.rom = rom, .sign = sign};
	part->y = malloc(n*sizeof *part->y);
	part->root = malloc(2*n*sizeof *part->root);
	part->swing = malloc(2*n*sizeof *part->swing);
	if (!part->y || !part->root || !part->swing)
		return 0;
	for (int s = 0; s < rom->n; s++) {
		double half = 0.5*damping(part, s), k = stiffness(part, s);
		double complex root = csqrt(half*half - k);

		/* critical damping: the roots coincide; a small difference is harmless */
		if (cabs(root) < 1e-6*sqrt(k))
			root = 1e-6*sqrt(k);
		part->root[2*s] = -half + root;
		part->root[2*s + 1] = -half - root;
		begin_mode(part, s, rest, 0.0, omega);
	}
	return 1;
}

/* At the end of the ramp the force has a different form. */
static void pass_end(struct part *part, double omega)
{
	double end = part->rom->ramp->time;

	for (int s = 0; s < part->rom->n; s++) {
		double motion[2], more[2], held;

		part->over = 0;
		forced(motion, &held, part, s, end, omega);
		free_motion(more, part, s, end);
		part->y[s] = motion[0] + more[0];
		more[1] += motion[1];
		more[0] = part->y[s];
		part->over = 1;
		/* the other amplitudes are no longer used, and the start time is set once for all */
		begin_mode(part, s, more, end, omega);
	}
	part->begin = end;
}

static void move(struct part *part, double t, double omega)
{
	if (part->rom->ramp && !part->over && t >= part->rom->ramp->time)
		pass_end(part, omega);
	for (int s = 0; s < part->rom->n; s++) {
		double motion[2], more[2], held;

		forced(motion, &held, part, s, t, omega);
		free_motion(more, part, s, t);
		part->y[s] = motion[0] + more[0] - (part->sign > 0.0 ? held : 0.0);
	}
}

/* --- the cable --- */

/* surge->extra: strain at time t beyond that of the model's coordinates. */
static void strain_at(struct surge *surge, double t)
{
	const struct hawser_rom_moment moment = {.tau = surge->omega*t, .omega = surge->omega, .time = t};
	int places = surge->rom->line.points;

	memset(surge->extra, 0, (size_t)places*sizeof *surge->extra);
	(void)hawser__rom_answer_strains(&surge->all, surge->extra, &moment);
	for (int i = 0; i < 2; i++) {
		struct part *part = &surge->part[i];

		move(part, t, surge->omega);
		for (int s = 0; s < part->rom->n; s++) {
			const double *slope = part->rom->line.slope + 3*(size_t)s*(size_t)places;
			double y = part->sign*part->y[s];

			for (int p = 0; p < places; p++)
				surge->extra[p] += y*slope[3*p];
		}
	}
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

static enum hawser_status surge_make(struct surge *surge, const struct hawser_rom *rom,
                                     const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, double omega,
                                     struct hawser_report *report)
{
	size_t places = (size_t)rom->line.points;
	enum hawser_status status;

	surge->rom = rom;
	surge->omega = omega;
	status = make_all(surge, statics, scene, report);
	if (status)
		return status;
	surge->extra = malloc(places*sizeof *surge->extra);
	surge->tension = malloc(places*sizeof *surge->tension);
	surge->u = malloc((size_t)rom->n*sizeof *surge->u);
	surge->rest = malloc(places*sizeof *surge->rest);
	if (!surge->extra || !surge->tension || !surge->rest || !surge->u ||
	    !part_make(&surge->part[0], &surge->all, 1.0, omega) ||
	    !part_make(&surge->part[1], rom, -1.0, omega))
		return hawser__no_memory(report, "surge");
	memset(surge->u, 0, (size_t)rom->n*sizeof *surge->u);
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

static void look(struct hawser_surge *result, struct surge *surge, const struct hawser_scene *scene,
                 double t)
{
	const struct hawser_rom *rom = surge->rom;
	const struct hawser_rom_moment moment = {.tau = surge->omega*t, .omega = surge->omega, .time = t};
	double least, most, v = speed_at(surge, scene, t), taken = scene->cable.rho*v*v;

	strain_at(surge, t);
	hawser__rom_tensions_all(rom, surge->tension, surge->u, surge->extra);
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
		top = fmax(top, stiffness(&surge->part[1], s));
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

enum hawser_status hawser_surge_look(struct hawser_surge *result, const struct hawser_trajectory *run,
                                     const struct hawser_rom *rom,
                                     const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, double omega,
                                     struct hawser_report *report)
{
	struct surge surge = {.rom = rom};
	struct hawser_trajectory again = {.rows = 0};
	enum hawser_status status = HAWSER_OK;
	double crossing, step, span;

	*result = (struct hawser_surge){.least = HUGE_VAL, .most = -HUGE_VAL, .spare = HUGE_VAL};
	if (!scene->travel.present || rom->exact || rom->line.points < 1 || run->rows < 2 ||
	    rom->shapes.EA <= 0.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "surge",
		                    "axial waves of a change of the travel speed require a scene with "
		                    "`travel`, a model of it without the exact energy, and a run");
	status = surge_make(&surge, rom, statics, scene, omega, report);
	if (!status)
		status = closer(&again, &surge, run, report);
	if (status)
		goto done;
	if (again.rows > 1)
		run = &again;
	crossing = statics->l*sqrt(statics->epsilon);
	span = run->time[run->rows - 1] - run->time[0];
	step = fmax(crossing/A_CROSSING, span/SAMPLES_MOST);
	for (int row = 0; row < run->rows; row++) {
		double from = run->time[row], to = row + 1 < run->rows ? run->time[row + 1] : from;
		int count = to > from ? (int)ceil((to - from)/step) : 1;

		for (int i = 0; i < count; i++) {
			double t = from + (to - from)*i/count;

			interpolate(&surge, run, row, t);
			look(result, &surge, scene, t);
		}
	}
	result->error = estimated(&surge);
	if (!isfinite(result->least) || !isfinite(result->most))
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
