/* Motion of a deep inclined span with a nonlinear energy sink and an absorber: the full-order model
 * against a chain of masses and springs in time, whose absorbers are masses of their own; conservation
 * of energy. The chain shares nothing with the library but the positions at rest from which it relaxes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/integrate.h>

#include "tests/tap.h"

static struct hawser_report report;

static const double omega = 2.1, until = 5.0; /* rad/s, s */
static const struct hawser_scene scene = {
	.g = 9.81,
	.cable = {.EA = 2e6, .rho = 3.0},
	.span = {.d = 90.0, .h = 35.0},
	.tension = {.given = HAWSER_GIVEN_T0, .value = 6e3, .branch = HAWSER_BRANCH_TAUT},
	.load = {.present = 1, .frame = HAWSER_FRAME_GLOBAL, .per_length = {0.0, 9.0, 6.0},
	         .extent = {0.0, 1.0}},
	.attachments = 2,
	.attach = {{.at = 0.25, .mass = 10.0, .absorber_mass = 30.0, .absorber_stiffness = 60.0,
	            .absorber_cubic = 900.0, .absorber_damping = 9.0,
	            .absorber_direction = {0.3, -0.9, 0.0}},
	           {.at = 0.5, .absorber_mass = 20.0, .absorber_stiffness = 110.0,
	            .absorber_direction = {0.0, 0.0, 1.0}}},
};

/* --- the chain --- */

enum { LINKS = 96, NODES = LINKS + 1, STATE = 3*NODES + 2 };

struct chain {
	int n;
	double h;              /* unstretched length of a link */
	double axis[2][3];
	double still;          /* damping while it relaxes, 1/s; the absorbers are held */
};

static int joint_of(const struct chain *c, int a)
{
	return (int)lround(scene.attach[a].at*c->n);
}

/* Accelerations a [STATE] at x, v: nodes, then strokes. */
static void accelerate(double *a, const struct chain *c, const double *x, const double *v, double t)
{
	const double *load = scene.load.per_length;
	double wave = c->still > 0.0 ? 0.0 : cos(omega*t);
	int n = c->n;

	memset(a, 0, STATE*sizeof *a);
	for (int i = 0; i < n; i++) {
		double e[3], l = 0.0, T;

		for (int k = 0; k < 3; k++) {
			e[k] = x[3*i + 3 + k] - x[3*i + k];
			l += e[k]*e[k];
		}
		l = sqrt(l);
		T = scene.cable.EA*(l/c->h - 1.0);
		for (int k = 0; k < 3; k++) {
			a[3*i + k] += T*e[k]/l;
			a[3*i + 3 + k] -= T*e[k]/l;
		}
	}
	for (int i = 1; i < n; i++) {
		double m = scene.cable.rho*c->h;

		for (int k = 0; k < 3; k++)
			a[3*i + k] += load[k]*wave*c->h - (k == 1)*m*scene.g - c->still*m*v[3*i + k];
		for (int b = 0; b < 2; b++) {
			const struct hawser_attachment *at = &scene.attach[b];
			double s = x[3*NODES + b], own = at->absorber_mass, R, along = 0.0;
			const double *d = c->axis[b];

			if (joint_of(c, b) != i)
				continue;
			a[3*i + 1] -= (at->mass + own)*scene.g;
			m += at->mass;
			if (c->still > 0.0) {
				m += own;
				continue;
			}
			R = at->absorber_stiffness*s + at->absorber_cubic*s*s*s +
			    at->absorber_damping*v[3*NODES + b];
			for (int k = 0; k < 3; k++)
				along += a[3*i + k]*d[k];
			/* own (A.d + s'') = -R, (m + own) A + own s'' d = F */
			for (int k = 0; k < 3; k++)
				a[3*i + k] = (a[3*i + k] - along*d[k])/(m + own) + (along + R)/m*d[k];
			a[3*NODES + b] = -R/own - (along + R)/m;
			m = 0.0;
			break;
		}
		for (int k = 0; k < 3 && m > 0.0; k++)
			a[3*i + k] /= m;
	}
	memset(a, 0, 3*sizeof *a);
	memset(a + 3*n, 0, 3*sizeof *a);
}

static void step(struct chain *c, double *x, double *v, double t, double dt)
{
	static double a[4][STATE], y[STATE], w[STATE], k[4][STATE];
	const double part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0/6, 1.0/3, 1.0/3, 1.0/6};

	for (int r = 0; r < 4; r++) {
		for (int i = 0; i < STATE; i++) {
			y[i] = x[i] + (r ? part[r]*dt*k[r - 1][i] : 0.0);
			w[i] = v[i] + (r ? part[r]*dt*a[r - 1][i] : 0.0);
			k[r][i] = w[i];
		}
		accelerate(a[r], c, y, w, t + part[r]*dt);
	}
	for (int r = 0; r < 4; r++)
		for (int i = 0; i < STATE; i++) {
			x[i] += dt*weight[r]*k[r][i];
			v[i] += dt*weight[r]*a[r][i];
		}
}

/* Displacement of the middle and both strokes after `until`, out [5]. */
static void chain(double *out, const struct hawser_statics *st, int n)
{
	static double x[STATE], v[STATE];
	struct chain c = {.n = n, .h = st->length0/n, .still = 1.5};
	double start[3], dt = 1.2*c.h/sqrt(scene.cable.EA/scene.cable.rho);
	int steps = (int)ceil(until/dt);

	memset(x, 0, sizeof x);
	memset(v, 0, sizeof v);
	for (int b = 0; b < 2; b++) {
		const double *d = scene.attach[b].absorber_direction;
		double l = sqrt(d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);

		for (int k = 0; k < 3; k++)
			c.axis[b][k] = d[k]/l;
	}
	for (int i = 0; i <= n; i++) {
		struct hawser_profile_point p = hawser_statics_at(st, i*c.h);

		x[3*i] = p.x;
		x[3*i + 1] = p.y;
	}
	for (double t = 0.0; t < 10.0; t += dt)
		step(&c, x, v, t, dt);
	memset(v, 0, sizeof v);
	memcpy(start, x + 3*(n/2), sizeof start);
	c.still = 0.0;
	dt = until/steps;
	for (int i = 0; i < steps; i++)
		step(&c, x, v, i*dt, dt);
	for (int k = 0; k < 3; k++)
		out[k] = x[3*(n/2) + k] - start[k];
	out[3] = x[3*NODES];
	out[4] = x[3*NODES + 1];
}

/* --- the model --- */

static int model(double *out, const struct hawser_statics *st, int functions)
{
	struct hawser_trajectory run = {0};
	struct hawser_integrate_options options = {.omega = 1.0};
	struct hawser_rom rom;
	const double *u;
	double xyz[3];

	if (!ok(!hawser_rom_build_full(&rom, st, &scene, functions, &report), "built: %s", report.message))
		return 0;
	options.omega = omega*rom.time;
	options.until = options.every = until/rom.time;
	if (!ok(!hawser_integrate(&run, &rom, &options, &report), "integrated: %s", report.message))
		return 0;
	u = run.state + (size_t)(run.rows - 1)*2*(size_t)rom.n;
	hawser_rom_displacement(&rom, out, 1, u);
	for (int b = 0; b < 2; b++) {
		const double *d = scene.attach[b].absorber_direction;

		hawser_rom_displacement(&rom, xyz, 3 + b, u);
		out[3 + b] = (xyz[0]*d[0] + xyz[1]*d[1] + xyz[2]*d[2])/
		             sqrt(d[0]*d[0] + d[1]*d[1] + d[2]*d[2]);
	}
	for (int i = 0; i < 5; i++)
		out[i] *= rom.length;
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	return 1;
}

static void conserved(const struct hawser_statics *st)
{
	struct hawser_trajectory run = {0};
	struct hawser_integrate_options options = {.rtol = 1e-11};
	double initial[100] = {0.0}, drift = 0.0;
	struct hawser_rom rom;

	if (!ok(!hawser_rom_build_full(&rom, st, NULL, 6, &report), "built: %s", report.message))
		return;
	for (int j = 0; j < 5; j++)
		initial[rom.n + j] = 0.02/(j + 1);
	options.initial = initial;
	options.until = 8.0/rom.time;
	options.every = 0.5/rom.time;
	if (!ok(!hawser_integrate(&run, &rom, &options, &report), "integrated: %s", report.message))
		return;
	for (int i = 0; i < run.rows; i++)
		drift = fmax(drift, fabs(run.energy[i]/run.energy[0] - 1.0));
	ok(drift < 1e-9, "without damping the energy with a cubic spring is conserved: %.1e", drift);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

/* Largest difference of the displacements, m. */
static double apart(const double *a, const double *b)
{
	return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

CASE(property_absorber_motion)
{
	double coarse[5], fine[5], few[5], full[5], size;
	struct hawser_statics st;

	if (!ok(!hawser_statics_scene(&st, &scene, &report), "statics: %s", report.message) ||
	    !model(few, &st, 14) || !model(full, &st, 20))
		return done_testing();
	chain(coarse, &st, LINKS/2);
	chain(fine, &st, LINKS);
	for (int i = 0; i < 5; i++)
		fine[i] += (fine[i] - coarse[i])/3.0;
	size = hypot(hypot(full[0], full[1]), full[2]);
	ok(apart(full, fine) < 5e-3*size && apart(full, fine) < 0.25*apart(few, fine), "the middle moves "
	   "by %.4f m, from the chain %.1e m with 20 functions, %.1e m with 14", size, apart(full, fine),
	   apart(few, fine));
	for (int b = 3; b < 5; b++)
		ok(fabs(full[b]/fine[b] - 1.0) < 3e-3, "stroke %d: %.5f m, chain %.5f m", b - 2, full[b],
		   fine[b]);
	conserved(&st);
	return done_testing();
}
