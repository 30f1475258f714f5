/* rom/terms/travel.c - terms of the model of a cable that travels along its length.
 *
 *    nu, V      steady speed and amplitude of its fluctuation, scaled (struct hawser_motion)
 *    G, M'      integrals of Phi_j . Phi_k' (skew) and of Phi_j' . Phi_k'
 *    g, d       integrals of Phi_j . x' and of Phi_j' . x', x the steady shape
 *
 * With the speed n(t), a particle of the apparent cable has the acceleration q.. + 2 n q.' + n. q'
 * + n^2 q''. Statics and modes include the mean of n^2 (statics/travel.c). The remaining terms on
 * the left side of the model, with q = x + u, are
 *
 *      2 n G u. + n. (G u + g) - (n^2 - mean) (M' u + d)
 *
 * where the last term was integrated by parts with fixed ends. For n = nu + V sin(Omega t), and n^2
 * - mean = 2 nu V sin(Omega t) - V^2/2 cos(2 Omega t), these are 2 nu G in D, and three harmonics.
 * For a cable that is braked, n = nu + Delta s(t) with s from 0 to 1, they are a ramp with terms in
 * s, s^2 and ds/dt (Bertrand 2022, 5.69-5.79 with the signs of doc/errata.md).
 *
 * The condensed modes respond to the forces g and d as well. When the speed changes, this is most
 * of the response of a cable: the tension of a taut one varies by rho n. (S - L/2) along its
 * length. With w_jk, their displacement per u_j u_k (condense.h), the integrals of w_jk' . x' and
 * w_jk . x' are added to M' and G in the stiffness (follow.h has them without w_jk). They follow the
 * gyroscopic forces too (travel_modes.c). Neglected are those of second order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/condense/follow.h"
#include "rom/energy/project.h"
#include "rom/terms/travel.h"

struct convection {
	int n;
	double *G, *M; /* [n][n] */
	double *g, *d; /* [n] */
};

static void convection_clear(struct convection *c)
{
	free(c->G);
	free(c->M);
	free(c->g);
	free(c->d);
}

/* A level span is symmetric about mid-span: entries of G and g between equal parities, and of M'
 * and d between different ones, are round-off and set to zero. */
static enum hawser_status clean(struct convection *c, const struct hawser_modes *modes,
                                struct hawser_report *report)
{
	int n = c->n, *anti = malloc((size_t)n*sizeof *anti);

	if (!anti)
		return hawser__no_memory(report, "rom");
	if (hawser__rom_mirror(anti, modes)) {
		for (int i = 0; i < n*n; i++)
			*(anti[i/n] == anti[i%n] ? &c->G[i] : &c->M[i]) = 0.0;
		for (int j = 0; j < n; j++)
			*(anti[j] ? &c->d[j] : &c->g[j]) = 0.0;
	}
	free(anti);
	return HAWSER_OK;
}

static enum hawser_status convection_make(struct convection *c, const struct hawser_modes *modes,
                                          struct hawser_report *report)
{
	size_t n = (size_t)modes->n;

	c->n = modes->n;
	c->G = malloc(n*n*sizeof *c->G);
	c->M = malloc(n*n*sizeof *c->M);
	c->g = malloc(n*sizeof *c->g);
	c->d = malloc(n*sizeof *c->d);
	if (!c->G || !c->M || !c->g || !c->d)
		return hawser__no_memory(report, "rom");
	hawser_modes_convection(modes, c->G, c->M, c->g, c->d);
	for (size_t i = 0; i < n*n; i++)
		if (!isfinite(c->G[i]) || !isfinite(c->M[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, "rom",
			                    "the shapes of the modes %zu and %zu are not finite",
			                    i/n + 1, i%n + 1);
	return clean(c, modes, report);
}

/* *to = factor * from [count]; stays NULL if the factor is 0. Returns whether memory sufficed. */
static int scaled(double **to, double factor, const double *from, int count)
{
	if (factor == 0.0)
		return 1;
	*to = malloc((size_t)count*sizeof **to);
	for (int i = 0; *to && i < count; i++)
		(*to)[i] = factor*from[i];
	return *to != NULL;
}

/* s (f - D u. - K u) with f = kf*load, D = kD*G and K = kK*stiffness. */
static int fill(double **f, double **D, double **K, const struct convection *c, double kf,
                const double *load, double kD, double kK, const double *stiffness)
{
	return scaled(f, kf, load, c->n) && scaled(D, kD, c->G, c->n*c->n) &&
	       scaled(K, kK, stiffness, c->n*c->n);
}

static enum hawser_status fluctuate(struct hawser_rom *rom, const struct convection *c,
                                    const struct hawser_motion *motion,
                                    struct hawser_report *report)
{
	double nu = motion->nu, V = motion->swing;
	struct hawser_harmonic *h = realloc(rom->harmonic,
	                                    ((size_t)rom->harmonics + 3)*sizeof *h);

	if (!h)
		return hawser__no_memory(report, "rom");
	rom->harmonic = h;
	h += rom->harmonics;
	rom->harmonics += 3;
	h[0] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_SIN};
	h[1] = (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS, .omega_power = 1};
	h[2] = (struct hawser_harmonic){.k = 2, .phase = HAWSER_COS};
	if (fill(&h[0].f, &h[0].D, &h[0].K, c, 2.0*nu*V, c->d, 2.0*V, -2.0*nu*V, c->M) &&
	    fill(&h[1].f, &h[1].D, &h[1].K, c, -V, c->g, 0.0, V, c->G) &&
	    fill(&h[2].f, &h[2].D, &h[2].K, c, -0.5*V*V, c->d, 0.0, 0.5*V*V, c->M))
		return HAWSER_OK;
	return hawser__no_memory(report, "rom");
}

/* From nu to nu + change within `time`. */
static enum hawser_status slow_down(struct hawser_rom *rom, const struct convection *c, double nu,
                                    double change, double time, struct hawser_report *report)
{
	struct hawser_ramp *ramp = calloc(1, sizeof *ramp);
	struct hawser_ramp_term *once, *twice, *rate;

	rom->ramp = ramp;
	if (!ramp)
		return hawser__no_memory(report, "rom");
	ramp->time = time;
	once = &ramp->term[HAWSER_RAMP_LINEAR];
	twice = &ramp->term[HAWSER_RAMP_SQUARE];
	rate = &ramp->term[HAWSER_RAMP_RATE];
	if (fill(&once->f, &once->D, &once->K, c, 2.0*nu*change, c->d, 2.0*change, -2.0*nu*change,
	         c->M) &&
	    fill(&twice->f, &twice->D, &twice->K, c, change*change, c->d, 0.0, -change*change, c->M) &&
	    fill(&rate->f, &rate->D, &rate->K, c, -change, c->g, 0.0, change, c->G))
		return HAWSER_OK;
	return hawser__no_memory(report, "rom");
}

double hawser__travel_change(const struct hawser_modes *modes, const struct hawser_scene *scene)
{
	const struct hawser_statics *st = &modes->statics;
	double unit = sqrt(st->span.rho/st->H)/(1.0 - st->motion.mach2);

	return (scene->travel.final - st->motion.speed)*unit;
}

enum hawser_status hawser__rom_travel(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser_report *report)
{
	const struct hawser_motion *motion = &modes->statics.motion;
	int brakes = scene && scene->travel.braking > 0.0;
	struct convection c = {0};
	enum hawser_status status;

	rom->shapes.mach2 = motion->mach2;
	if (motion->nu == 0.0 && motion->swing == 0.0 && !brakes)
		return HAWSER_OK;
	status = convection_make(&c, modes, report);
	for (int i = 0; !status && i < rom->n*rom->n; i++)
		rom->D[i] += 2.0*motion->nu*c.G[i];
	if (!status && motion->swing > 0.0)
		status = fluctuate(rom, &c, motion, report);
	if (!status && brakes)
		status = slow_down(rom, &c, motion->nu,
		                   hawser__travel_change(modes, scene),
		                   scene->travel.braking/rom->time, report);
	convection_clear(&c);
	return status;
}

/* --- condensed modes --- */

/* Integrated by parts: the work of x' on v is that of -x on v'. */
void hawser__speed_pull(struct hawser__stations *stations, int squared)
{
	const struct hawser_statics *st = &stations->modes->statics;
	struct hawser_profile_point middle = hawser_statics_at(st, 0.5*st->length0);

	for (int i = 0; i < stations->count; i++) {
		struct hawser_frame_point at = hawser_statics_frame(st, stations->s[i]);
		struct hawser_profile_point x = hawser_statics_at(st, stations->s[i]*st->span.d);
		double dx = (x.x - middle.x)/st->span.d, dy = (x.y - middle.y)/st->span.d;
		double *p = stations->p + 3*i;

		p[0] = squared ? 1.0 + at.strain : -(dx*at.ex + dy*at.ey);
		p[1] = squared ? 0.0 : dx*at.ey - dy*at.ex;
		p[2] = 0.0;
	}
}

/* g [n][n] and d [n][n] receive T_jk of follow.h. */
static enum hawser_status follow(double *g, double *d, const struct hawser_modes *modes, int moving,
                                 struct hawser_report *report)
{
	struct hawser__stations stations;
	enum hawser_status status = hawser__stations_make(&stations, modes, moving, NULL, 0,
	                                                  report);

	for (int squared = 0; !status && squared < 2; squared++) {
		hawser__speed_pull(&stations, squared);
		hawser__follow(&stations);
		(void)hawser__follow_stiffness(squared ? d : g, &stations);
	}
	hawser__stations_clear(&stations);
	return status;
}

/* *K [count] += factor * from; *K may be NULL for zero. Returns whether memory sufficed. */
static int add(double **K, double factor, const double *from, int count)
{
	if (factor != 0.0 && !*K)
		*K = calloc((size_t)count, sizeof **K);
	for (int i = 0; factor != 0.0 && *K && i < count; i++)
		(*K)[i] += factor*from[i];
	return factor == 0.0 || *K;
}

enum hawser_status hawser__rom_travel_condensed(struct hawser_rom *rom,
                                                const struct hawser_modes *modes, int moving,
                                                const struct hawser_scene *scene,
                                                struct hawser_report *report)
{
	double nu = modes->statics.motion.nu, V = modes->statics.motion.swing;
	int n2 = rom->n*rom->n, good = 1;
	enum hawser_status status = HAWSER_OK;
	double *g, *d;

	if (V == 0.0 && !rom->ramp)
		return HAWSER_OK;
	g = malloc((size_t)n2*sizeof *g);
	d = malloc((size_t)n2*sizeof *d);
	good = g && d;
	if (good)
		status = follow(g, d, modes, moving, report);
	if (good && !status && V > 0.0) {
		struct hawser_harmonic *h = rom->harmonic + rom->harmonics - 3;

		good = add(&h[0].K, 2.0*nu*V, d, n2) && add(&h[1].K, -V, g, n2) &&
		       add(&h[2].K, -0.5*V*V, d, n2);
	}
	if (good && !status && rom->ramp) {
		struct hawser_ramp_term *term = rom->ramp->term;
		double change = hawser__travel_change(modes, scene);

		good = add(&term[HAWSER_RAMP_LINEAR].K, 2.0*nu*change, d, n2) &&
		       add(&term[HAWSER_RAMP_SQUARE].K, change*change, d, n2) &&
		       add(&term[HAWSER_RAMP_RATE].K, -change, g, n2);
	}
	free(g);
	free(d);
	return good ? status : hawser__no_memory(report, "rom");
}
