/* The model of a travelling cable by a second route: the equation of motion in actual coordinates,
 * with the momentary speed, projected on the same shapes. This route does not use the apparent
 * cable, harmonics or ramps:
 *
 *   rho int Phi_j.(q.. + 2 v q.' + v. q') dS - rho v^2 int Phi_j'.q' dS
 *     + int T q'/|q'|.Phi_j' dS + rho g int Phi_j.y dS + alpha int Phi_j.q. dS
 *     = int Phi_j.f dS,   T = EA (|q'| - 1)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/gyroscopic.h>
#include <hawser/rom.h>
#include "rom/build/model.h"
#include "tests/tap.h"

enum { N = 7 };

static struct hawser_scene scene_of(double h, double speed, double fluctuation,
                                    enum hawser_hold hold)
{
	struct hawser_scene scene = {.cable = {.EA = 4e6, .rho = 2.385}, .span = {97.3, h}, .g = 9.81};

	scene.tension.given = HAWSER_GIVEN_T0;
	scene.tension.value = 9.1e3;
	scene.travel.present = 1;
	scene.travel.speed = speed;
	scene.travel.fluctuation = fluctuation;
	scene.travel.hold = hold;
	scene.damping.kind = HAWSER_DAMPING_ALPHA;
	scene.damping.alpha = 0.317;
	scene.load.present = 1;
	scene.load.frame = HAWSER_FRAME_GLOBAL;
	scene.load.per_length[0] = 1.3;
	scene.load.per_length[1] = -7.1;
	scene.load.per_length[2] = 2.9;
	scene.load.extent[1] = 1.0;
	scene.model.condense = HAWSER_CONDENSE_NONE;
	return scene;
}

static int solve(struct hawser_statics *st, struct hawser_modes *modes,
                 const struct hawser_scene *scene, int n)
{
	struct hawser_modes_options options = {.n = n, .tolerance = 1e-11};
	struct hawser_report report = {.message = ""};
	int fine = !hawser_statics_scene(st, scene, &report) &&
	           !hawser_modes_solve(modes, st, &options, &report);

	return ok(fine, "steady state and %d modes%s", n, report.message);
}

/* --- the second route --- */

/* A field in local axes (e, n, z), in global axes. */
static void turn(double out[3], const struct hawser_frame_point *at, const double *local)
{
	out[0] = local[0]*at->ex - local[1]*at->ey;
	out[1] = local[0]*at->ey + local[1]*at->ex;
	out[2] = local[2];
}

static double dot(const double *a, const double *b)
{
	return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

/* Accelerations q..[n] in 1/s^2 times the unit of coordinates, at the speed v and its rate dv
 * (SI). */
static void direct(double *acceleration, const struct hawser_modes *modes,
                   const struct hawser_scene *scene, const double *u, const double *rate, double v,
                   double dv, double phase)
{
	const struct hawser_statics *st = &modes->statics;
	const struct hawser_grid *grid = &modes->grid;
	double m = st->motion.mach2, d = scene->span.d, rho = scene->cable.rho, EA = scene->cable.EA;
	double mass = 0.0;

	memset(acceleration, 0, (size_t)modes->n*sizeof *acceleration);
	for (int p = 0; p < grid->points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(st, grid->s[p]);
		double S = grid->s[p]*d*(1.0 - m), dS = grid->weight[p]*d*(1.0 - m);
		double stretch = 1.0 + hawser_statics_actual_at(st, S).T/EA, r;
		double slope[3] = {stretch*at.ex, stretch*at.ey, 0.0}, w[3] = {0}, ws[3] = {0}, b[3];

		for (int k = 0; k < modes->n; k++) {
			size_t row = ((size_t)k*grid->points + p)*3;
			double phi[3], dphi[3];

			turn(phi, &at, modes->shape + row);
			turn(dphi, &at, modes->slope + row);
			for (int i = 0; i < 3; i++) {
				slope[i] += u[k]*dphi[i]/(1.0 - m); /* d u/d S, u in m */
				w[i] += rate[k]*d*phi[i];
				ws[i] += rate[k]*dphi[i]/(1.0 - m);
			}
		}
		r = sqrt(dot(slope, slope));
		for (int i = 0; i < 3; i++)
			b[i] = scene->load.per_length[i]*cos(phase) - scene->damping.alpha*w[i]
			       - rho*(2.0*v*ws[i] + dv*slope[i]) - (i == 1 ? rho*scene->g : 0.0);
		for (int j = 0; j < modes->n; j++) {
			size_t row = ((size_t)j*grid->points + p)*3;
			double phi[3], dphi[3];

			turn(phi, &at, modes->shape + row);
			turn(dphi, &at, modes->slope + row);
			acceleration[j] += dS*dot(phi, b) + dS*(rho*v*v - EA*(r - 1.0)/r)*dot(dphi, slope)
			                   /(d*(1.0 - m));
			if (j == 0)
				mass += dS*rho*d*dot(phi, phi);
		}
	}
	for (int j = 0; j < modes->n; j++)
		acceleration[j] /= mass;
}

static double uniform(void)
{
	return 2.0*rand()/RAND_MAX - 1.0;
}

/* At random states and times, with coordinates of the order `size`. Returns the largest relative
 * difference. */
static double difference(const struct hawser_rom *rom, const struct hawser_modes *modes,
                         const struct hawser_scene *scene, double size)
{
	double worst = 0.0, largest = 0.0, per = 1.0/(rom->time*rom->time);

	srand(1); /* the same random states for every size */
	for (int trial = 0; trial < 20; trial++) {
		double u[N], v[N], got[N], want[N], t = 3.7*fabs(uniform()), Omega = 1.7;
		double speed = scene->travel.speed + scene->travel.fluctuation*sin(Omega*t);
		double rate = scene->travel.fluctuation*Omega*cos(Omega*t);
		int over = 0;

		if (scene->travel.braking > 0.0) {
			double change = scene->travel.final - scene->travel.speed;

			over = t >= scene->travel.braking;
			speed += change*(over ? 1.0 : t/scene->travel.braking);
			rate = over ? 0.0 : change/scene->travel.braking;
		}
		for (int j = 0; j < rom->n; j++) {
			u[j] = size*uniform();
			v[j] = 3.0*size*uniform();
		}
		hawser_rom_acceleration(rom, got, u, v, Omega*t, Omega*rom->time);
		if (rom->ramp)
			hawser__rom_ramp(rom, got, NULL, NULL, u, v, t/rom->time, over);
		for (int j = 0; j < rom->n; j++)
			v[j] /= rom->time;
		direct(want, modes, scene, u, v, speed, rate, Omega*t);
		for (int j = 0; j < rom->n; j++) {
			worst = fmax(worst, fabs(got[j]*per - want[j]));
			largest = fmax(largest, fabs(want[j]));
		}
	}
	return worst/largest;
}

static void check_route(double h, double speed, double fluctuation, enum hawser_hold hold,
                        double braking, double final)
{
	struct hawser_scene scene = scene_of(h, speed, fluctuation, hold);
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom exact, quartic;
	double off, near, far;

	scene.travel.braking = braking;
	scene.travel.final = final;
	if (!solve(&st, &modes, &scene, N))
		return;
	if (!ok(!hawser_rom_build_exact(&exact, &modes, &scene, NULL) &&
	        !hawser_rom_build(&quartic, &modes, &scene, NULL), "models"))
		return;
	off = difference(&exact, &modes, &scene, 0.02);
	ok(off < 1e-9, "h %g, %g + %g m/s, hold %d, braking %g s: exact energy within %.1e", h, speed,
	   fluctuation, hold, braking, off);
	far = difference(&quartic, &modes, &scene, 0.002);
	near = difference(&quartic, &modes, &scene, 0.001);
	ok(far < 1e-3 && near < 0.15*far, "fourth order: %.1e, and %.1e at half of it",
	   far, near);
	hawser_rom_clear(&exact);
	hawser_rom_clear(&quartic);
	hawser_modes_clear(&modes);
}

/* --- structure --- */

static void check_structure(void)
{
	struct hawser_scene scene = scene_of(0.0, 21.3, 1.7, HAWSER_HOLD_TENSION);
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom rom;
	double damping, skew = 0.0, symmetry = 0.0;
	int crossed = 0;

	if (!solve(&st, &modes, &scene, N) ||
	    !ok(!hawser_rom_build(&rom, &modes, &scene, NULL), "a model"))
		return;
	damping = scene.damping.alpha*rom.time/scene.cable.rho;
	for (int j = 0; j < N; j++)
		for (int k = 0; k < N; k++) {
			double D = rom.D[j*N + k] - (j == k ? damping : 0.0);
			int other = modes.mode[j].plane != modes.mode[k].plane;

			skew = fmax(skew, fabs(D + rom.D[k*N + j] - (j == k ? damping : 0.0)));
			for (int i = 1; i < rom.harmonics; i++) {
				const double *K = rom.harmonic[i].K;
				double sign = rom.harmonic[i].omega_power ? -1.0 : 1.0;

				symmetry = fmax(symmetry, fabs(K[j*N + k] - sign*K[k*N + j]));
				crossed |= other && K[j*N + k] != 0.0;
			}
			crossed |= other && D != 0.0;
		}
	ok(skew < 1e-16, "the gyroscopic terms are skew: %.1e", skew);
	ok(symmetry == 0.0, "K of sin and cos 2 symmetric, of the rate skew: %.1e", symmetry);
	ok(!crossed, "and keep the planes apart");
	ok(rom.harmonics == 4 && rom.harmonic[0].f && !rom.harmonic[0].K && rom.harmonic[1].D &&
	   rom.harmonic[1].phase == HAWSER_SIN && rom.harmonic[2].omega_power == 1 &&
	   rom.harmonic[3].k == 2, "the load, and three harmonics of the speed");
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

/* The model as text, to the last digit. */
static char *text_of(const struct hawser_scene *scene)
{
	struct hawser_statics st;
	struct hawser_modes modes;
	struct hawser_rom rom;
	char *text = NULL;

	if (!solve(&st, &modes, scene, 4))
		return NULL;
	if (!hawser_rom_build(&rom, &modes, scene, NULL) && hawser_rom_text(&rom, &text, NULL))
		text = NULL;
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	return text;
}

static void check_rest(void)
{
	struct hawser_scene still = scene_of(11.0, 0.0, 0.0, HAWSER_HOLD_TENSION), steady;
	char *rest, *zero, *level;

	zero = text_of(&still);
	still.travel.hold = HAWSER_HOLD_LENGTH;
	level = text_of(&still);
	still.travel.present = 0;
	rest = text_of(&still);
	ok(rest && zero && level && !strcmp(rest, zero) && !strcmp(rest, level),
	   "at speed 0 the resting model to the last bit, however held");
	free(rest);
	free(zero);
	free(level);
	steady = scene_of(11.0, 9.0, 0.0, HAWSER_HOLD_TENSION);
	zero = text_of(&steady);
	ok(zero && !strstr(zero, "sin") && !strstr(zero, "omega_power\": 1") && strstr(zero, "mach2"),
	   "a steady speed has no harmonics of its own");
	free(zero);
}

/* --- tension --- */

/* In the equilibrium of the model the probes have the actual tension of the steady state;
 * displaced, EA times the actual strain. */
static void check_tension(void)
{
	struct hawser_scene scene = scene_of(11.0, 40.0, 0.0, HAWSER_HOLD_LENGTH);
	struct hawser_statics st, actual;
	struct hawser_modes modes;
	struct hawser_rom rom;
	double u[N] = {0.0}, least, most, worst = 0.0, m;

	if (!solve(&st, &modes, &scene, N) ||
	    !ok(!hawser_rom_build(&rom, &modes, &scene, NULL), "a model"))
		return;
	actual = hawser_statics_actual(&st);
	m = st.motion.mach2;
	for (int p = 0; p < rom.shapes.points; p++) {
		double S = rom.shapes.s[p]*rom.length*(1.0 - m);
		double T = hawser_statics_actual_at(&st, S).T;

		worst = fmax(worst, fabs(hawser_rom_tension(&rom, p, u)/T - 1.0));
	}
	ok(worst < 1e-12, "tension of the steady state at the probes: %.1e", worst);
	ok(hawser_rom_tensions(&rom, &least, &most, u) &&
	   fabs(most/fmax(actual.T0, actual.T1) - 1.0) < 1e-12, "and its largest, at an end");
	for (int j = 0; j < N; j++)
		u[j] = 0.01*uniform();
	for (int p = 0; p < rom.shapes.points; p++) {
		double S = rom.shapes.s[p]*rom.length*(1.0 - m), slope[3] = {0.0}, T;

		for (int j = 0; j < N; j++)
			for (int i = 0; i < 3; i++)
				slope[i] += u[j]*rom.shapes.slope[((size_t)j*rom.shapes.points + p)*3 + i]
				            /(1.0 - m);
		slope[0] += 1.0 + hawser_statics_actual_at(&st, S).T/scene.cable.EA;
		T = scene.cable.EA*(sqrt(dot(slope, slope)) - 1.0);
		worst = fmax(worst, fabs(hawser_rom_tension(&rom, p, u) - T)/most);
	}
	ok(worst < 1e-9, "displaced: %.1e", worst);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
}

/* --- condensed modes --- */

/* T_jks of a model: the coefficient of u_k u_s in equation j, twice it where k = s. */
static double third(const struct hawser_rom *rom, int j, int k, int s)
{
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		if (q->j == j && q->k == (k < s ? k : s) && q->l == (k < s ? s : k))
			return k == s ? 2.0*q->value : q->value;
	}
	return 0.0;
}

/* Change of the harmonics' K of the three lowest modes by condensation, against a sum over all
 * modes of a basis: a mode s that follows the force f_s statically adds T_jks f_s/omega_s^2 to the
 * stiffness. */
static void check_condensed(double h)
{
	struct hawser_scene scene = scene_of(h, 21.3, 1.7, HAWSER_HOLD_TENSION);
	const int lowest[3] = {0, 1, 2};
	struct hawser_modes all = {.n = 0}, few = {.n = 0};
	struct hawser_statics st;
	struct hawser_rom whole, raw, condensed;

	scene.load.present = 0;
	if (!ok(!hawser_statics_scene(&st, &scene, NULL) &&
	        !hawser_modes_basis(&all, &st, 14, 4, NULL) &&
	        !hawser_modes_select(&few, &all, lowest, 3, NULL), "all modes of a basis"))
		return;
	if (!ok(!hawser_rom_build(&whole, &all, &scene, NULL) &&
	        !hawser_rom_build(&raw, &few, &scene, NULL), "models of all and of three"))
		return;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	scene.model.inertia = HAWSER_INERTIA_NONE; /* coordinates of the modes themselves */
	ok(!hawser_rom_build(&condensed, &few, &scene, NULL), "and of three with the others condensed");
	for (int p = 0; p < 3; p++) {
		double worst = 0.0, largest = 0.0;

		for (int i = 0; i < 9; i++) {
			double added = condensed.harmonic[p].K[i] - raw.harmonic[p].K[i], sum = 0.0;

			for (int s = 3; s < whole.n; s++)
				sum += third(&whole, i/3, i%3, s)*whole.harmonic[p].f[s]
				       /whole.K[s*(whole.n + 1)];
			worst = fmax(worst, fabs(added - sum));
			largest = fmax(largest, fabs(sum));
		}
		ok(worst < 1e-6*largest && largest > 0.0, "h %g, harmonic %d: %.3g added to K, within "
		   "%.1e", h, p, largest, worst/largest);
	}
	hawser_rom_clear(&whole);
	hawser_rom_clear(&raw);
	hawser_rom_clear(&condensed);
	hawser_modes_clear(&all);
	hawser_modes_clear(&few);
}

/* --- gyroscopic inertia of the condensed modes --- */

enum { FEW = 6, FIRST = 3 };

/* The first frequencies of u'' + D u' + K u = 0, ascending. */
static int frequencies(double omega[FIRST], const struct hawser_rom *rom)
{
	double A[4*FEW*FEW] = {0.0}, re[2*FEW], im[2*FEW];

	for (int j = 0; j < FEW; j++) {
		A[2*FEW*j + FEW + j] = 1.0;
		for (int k = 0; k < FEW; k++) {
			A[2*FEW*(FEW + j) + k] = -rom->K[j*FEW + k];
			A[2*FEW*(FEW + j) + FEW + k] = -rom->D[j*FEW + k];
		}
	}
	if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', 2*FEW, A, 2*FEW, re, im, NULL, 1, NULL, 1))
		return 0;
	for (int i = 0; i < FIRST; i++) {
		omega[i] = INFINITY;
		for (int e = 0; e < 2*FEW; e++)
			if (im[e] > (i ? omega[i - 1]*(1.0 + 1e-9) : 0.0))
				omega[i] = fmin(omega[i], im[e]);
	}
	return 1;
}

/* Largest error of them by the complex modes of the cable. */
static double off(const struct hawser_rom *rom, const struct hawser_modes *exact)
{
	double omega[FIRST], worst = frequencies(omega, rom) ? 0.0 : INFINITY;

	for (int i = 0; i < FIRST; i++)
		worst = fmax(worst, fabs(omega[i]/exact->mode[i].omega - 1.0));
	return worst;
}

/* Largest entry of Y' (1 + 4 nu^2 sum of G_js G_ks/w_s^2) Y - 1, Y rom->carried, s over the modes of
 * `all` that are not the first ones. */
static double unlike(const struct hawser_rom *rom, const struct hawser_modes *all)
{
	double *G = malloc((size_t)all->n*(size_t)all->n*sizeof *G), M[FEW*FEW], worst = 0.0;
	double nu = all->statics.motion.nu;

	hawser_modes_convection(all, G, NULL, NULL, NULL);
	for (int j = 0; j < FEW; j++)
		for (int k = 0; k < FEW; k++) {
			M[j*FEW + k] = j == k;
			for (int s = FEW; s < all->n; s++)
				M[j*FEW + k] += 4.0*nu*nu*G[j*all->n + s]*G[k*all->n + s]/
				                pow(all->mode[s].omega, 2);
		}
	for (int e = 0; e < FEW*FEW; e++) {
		double sum = e/FEW == e%FEW ? -1.0 : 0.0;

		for (int i = 0; i < FEW*FEW; i++)
			sum += rom->carried[i/FEW*FEW + e/FEW]*M[i]*rom->carried[i%FEW*FEW + e%FEW];
		worst = fmax(worst, fabs(sum));
	}
	free(G);
	return worst;
}

/* At 0.3 of the speed of waves. */
static void check_carried(double h)
{
	struct hawser_scene scene = scene_of(h, 18.6, 0.0, HAWSER_HOLD_TENSION);
	struct hawser_modes_options options = {.n = FIRST};
	struct hawser_rom bare, carrying;
	struct hawser_modes few, all, exact;
	struct hawser_statics st;

	scene.damping.alpha = 0.0;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	if (!solve(&st, &few, &scene, FEW))
		return;
	scene.model.inertia = HAWSER_INERTIA_NONE;
	if (ok(!hawser_complex_modes_solve(&exact, &st, &options, NULL) &&
	       !hawser_modes_basis(&all, &st, 40, 40, NULL) &&
	       !hawser_rom_build(&bare, &few, &scene, NULL), "h %g: complex modes, a basis, a model", h)) {
		scene.model.inertia = HAWSER_INERTIA_AUTO;
		ok(!hawser_rom_build(&carrying, &few, &scene, NULL) && carrying.carried && !bare.carried,
		   "and one with gyroscopic inertia");
		ok(off(&carrying, &exact) < 0.2*off(&bare, &exact),
		   "h %g: frequencies of %d modes are off by %.1e, without it by %.1e", h, FEW,
		   off(&carrying, &exact), off(&bare, &exact));
		ok(unlike(&carrying, &all) < 1e-4, "h %g: by the sum over a basis, to %.1e", h,
		   unlike(&carrying, &all));
		hawser_rom_clear(&carrying);
		hawser_rom_clear(&bare);
		hawser_modes_clear(&all);
		hawser_modes_clear(&exact);
	}
	hawser_modes_clear(&few);
}

CASE(property_rom_travel)
{
	check_condensed(0.0);
	check_condensed(11.0);
	check_route(0.0, 12.7, 0.0, HAWSER_HOLD_TENSION, 0.0, 0.0);
	check_route(11.0, 12.7, 2.385, HAWSER_HOLD_TENSION, 0.0, 0.0);
	check_route(-30.0, 55.0, 4.1, HAWSER_HOLD_LENGTH, 0.0, 0.0);
	check_route(11.0, 0.0, 3.0, HAWSER_HOLD_TENSION, 0.0, 0.0);
	check_route(11.0, 30.0, 0.0, HAWSER_HOLD_LENGTH, 2.1, 0.0);
	check_route(11.0, 0.0, 0.0, HAWSER_HOLD_LENGTH, 2.1, -13.0);
	check_structure();
	check_rest();
	check_tension();
	check_carried(0.0);
	check_carried(11.0);
	return done_testing();
}
