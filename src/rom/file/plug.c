/* rom/file/plug.c - a model whose forces are a function: of a shared library (hawser/plugin.h), or that
 * of the water on a net (rom/terms/morison.h).
 *
 *    a(u, v, tau, Omega)    acceleration
 *    K, D      minus its mean derivatives by u and v over a period, at rest and at Omega = 1
 *    f_k       its Fourier coefficients there, k = 0 to 4
 *
 * The model has K, D and harmonics f_k, from which natural frequencies and the first guess of an orbit
 * follow, and the function adds the rest, a + K u + D v - sum of f_k: the sum is a, whatever K, D and f
 * are. Its derivatives are compared with differences at random states before anything is computed
 * with them, since a wrong one would show only as bad convergence and wrong stability.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/plugin.h>

#include "core/report.h"
#include "rom/energy/kernel.h"
#include "rom/build/model.h"
#include "rom/file/plug.h"
#include "rom/file/read.h"

enum { PHASES = 32, TRIALS = 8, MOST = HAWSER_ROM_MAX };
#define STEP 1e-4  /* of differences, relative to the state or 1e-2; chosen */
#define WRONG 1e-6 /* relative difference of a derivative that counts as wrong, besides ten times the
                    * change of the difference in half the step; chosen */

/* The structure of a call at a state. */
struct at {
	const struct hawser_plugin *of;
	const double *parameter;
	double tau, omega;
	double *u, *v; /* [n] */
	double relaxation;
	const struct hawser__rom_morison *water;
};

/* The same of equations of first order. */
static int call_rate(const struct at *at, double *a, double *by_u, double *by_v)
{
	double J[MOST*MOST], bend[MOST*MOST], r = at->relaxation;
	size_t n = (size_t)at->of->n;

	memset(J, 0, n*n*sizeof *J);
	memset(bend, 0, n*n*sizeof *bend);
	if (at->of->rate(a, J, bend, at->u, at->v, at->parameter))
		return 1;
	if (by_u)
		memcpy(by_u, J, n*n*sizeof *J);
	for (size_t j = 0; r >= 0.0 && j < n; j++) {
		a[j] = r*(a[j] - at->v[j]);
		for (size_t k = 0; k < n; k++) {
			size_t i = j*n + k;

			a[j] += J[i]*at->v[k];
			if (!by_u)
				continue;
			by_u[i] = bend[i] + r*J[i];
			by_v[i] = J[i] - (j == k ? r : 0.0);
		}
	}
	return 0;
}

static int call(const struct at *at, double *a, double *by_u, double *by_v, double *by_omega)
{
	size_t n;

	if (at->water) {
		hawser__rom_morison_at(at->water, a, by_u, by_v, by_omega, at->u, at->v, at->tau, at->omega, 0);
		return 0;
	}
	n = (size_t)at->of->n;
	memset(a, 0, n*sizeof *a);
	if (by_u) {
		memset(by_u, 0, n*n*sizeof *by_u);
		memset(by_v, 0, n*n*sizeof *by_v);
		memset(by_omega, 0, n*sizeof *by_omega);
	}
	if (!at->of->acceleration)
		return call_rate(at, a, by_u, by_v);
	return at->of->acceleration(a, by_u, by_v, by_omega, at->u, at->v, at->tau, at->omega,
	                            at->parameter);
}

static void add_lane(const struct hawser_rom *rom, const struct hawser__more *to, const double *u,
                     const double *v, double tau, double omega)
{
	const struct hawser_rom_plug *plug = rom->plug;
	double own_u[MOST], own_v[MOST], a[MOST], by_omega[MOST], by_u[MOST*MOST], by_v[MOST*MOST];
	int n = rom->n, base = rom->base > 1 ? rom->base : 1, derive = to->by_u != NULL;
	const struct at at = {plug->of, plug->parameter, base*tau, base*omega, own_u, own_v,
		plug->relaxation, plug->water};

	for (int j = 0; j < n; j++) {
		own_u[j] = u[j*to->stride];
		own_v[j] = v[j*to->stride];
	}
	if (call(&at, a, derive ? by_u : NULL, derive ? by_v : NULL, derive ? by_omega : NULL))
		a[0] = NAN;
	for (int j = 0; j < n; j++) {
		double rest = a[j];

		for (int k = 0; k < n; k++)
			rest += plug->K[j*n + k]*own_u[k] + plug->D[j*n + k]*own_v[k];
		for (int k = 0; k < HAWSER_PLUG_WAVES; k++)
			rest -= plug->wave[2*k*n + j]*cos(k*at.tau) + plug->wave[(2*k + 1)*n + j]*sin(k*at.tau);
		to->force[j*to->stride] += rest;
		if (derive && to->by_omega)
			to->by_omega[j*to->stride] += base*by_omega[j];
	}
	for (int i = 0; derive && i < n*n; i++) {
		to->by_u[i*to->stride] += to->sign*(by_u[i] + plug->K[i]);
		to->by_v[i*to->stride] += to->sign*(by_v[i] + plug->D[i]);
	}
}

void hawser__plug_add(const struct hawser_rom *rom, const struct hawser__more *to, const double *u,
                      const double *v, const double *tau, double omega)
{
	for (int lane = 0; lane < to->stride; lane++) {
		struct hawser__more one = *to;

		one.force += lane;
		one.by_u = to->by_u ? to->by_u + lane : NULL;
		one.by_v = to->by_v ? to->by_v + lane : NULL;
		one.by_omega = to->by_omega ? to->by_omega + lane : NULL;
		add_lane(rom, &one, u + lane, v + lane, tau[lane], omega);
	}
}

void hawser__plug_free(struct hawser_rom_plug *plug)
{
	if (!plug)
		return;
	free(plug->parameter);
	free(plug->K);
	free(plug->D);
	free(plug->wave);
	hawser__rom_morison_free(plug->water);
	free(plug);
}

/* --- examination --- */

static double noise(unsigned *seed)
{
	*seed = *seed*1664525u + 1013904223u;
	return (*seed >> 8)/8388608.0 - 1.0;
}

/* slope [n] by central differences of width h. */
static int difference(double *slope, const struct at *at, double *x, double h, double *work)
{
	double keep = *x, *back = work + at->of->n;
	int failed;

	*x = keep + h;
	failed = call(at, work, NULL, NULL, NULL);
	*x = keep - h;
	failed |= call(at, back, NULL, NULL, NULL);
	*x = keep;
	for (int j = 0; j < at->of->n; j++)
		slope[j] = (work[j] - back[j])/(2.0*h);
	return failed;
}

static enum hawser_status refuse(const char *name, const char *entry, double given, double found,
                                 struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                    "%s: %s of its function is %.9g at a random state, and differences of the "
	                    "acceleration are %.9g: correct the derivative", name, entry, given, found);
}

/* One state: work [7 n + 2 n^2]. */
static enum hawser_status examine_at(struct at *at, const char *name, double *work,
                                     struct hawser_report *report)
{
	int n = at->of->n;
	double *a = work, *again = a + n, *coarse = again + n, *fine = coarse + n, *room = fine + n;
	double *by_omega = room + 2*n, *by_u = by_omega + n, *by_v = by_u + n*n;
	char entry[48];

	if (call(at, a, by_u, by_v, by_omega) || call(at, again, NULL, NULL, NULL))
		return HAWSER_OK; /* no value there */
	for (int j = 0; j < n; j++)
		if (!(fabs(a[j] - again[j]) <= 1e-12*(1.0 + fabs(a[j]))) && !isnan(again[j]))
			return refuse(name, "the acceleration with derivatives", a[j], again[j], report);
	for (int i = 0; i <= 2*n; i++) {
		double *x = i < n ? &at->u[i] : i < 2*n ? &at->v[i - n] : &at->omega;
		double h = STEP*fmax(fabs(*x), 1e-2);
		const double *given = i < n ? by_u : i < 2*n ? by_v : by_omega;

		if (difference(coarse, at, x, h, room) || difference(fine, at, x, 0.5*h, room))
			continue;
		for (int j = 0; j < n; j++) {
			double is = i < 2*n ? given[j*n + i%n] : given[j];
			double within = WRONG*(1.0 + fabs(is) + fabs(fine[j])) + 10.0*fabs(fine[j] - coarse[j]) +
			                1e-14*fabs(a[j])/h;

			if (fabs(is - fine[j]) <= within || isnan(fine[j]))
				continue;
			if (i < 2*n)
				snprintf(entry, sizeof entry, "%s[%d][%d]", i < n ? "by_u" : "by_v", j, i%n);
			else
				snprintf(entry, sizeof entry, "by_omega[%d]", j);
			return refuse(name, entry, is, fine[j], report);
		}
	}
	return HAWSER_OK;
}

/* *still: the phase and the frequency change nothing. */
static enum hawser_status examine(struct hawser_rom_plug *plug, const char *name, double *work,
                                  struct hawser_report *report)
{
	const struct hawser_plugin *of = plug->of;
	struct at at = {.of = of, .parameter = plug->parameter, .u = work, .v = work + of->n,
		.relaxation = plug->relaxation};
	double *a = work + 2*of->n, *other = a + of->n;
	enum hawser_status status = HAWSER_OK;
	unsigned seed = 20u;

	plug->still = 1;
	for (int t = 0; t < TRIALS && !status; t++) {
		double size = pow(10.0, -(t%4));

		for (int j = 0; j < of->n; j++) {
			at.u[j] = size*noise(&seed);
			at.v[j] = size*noise(&seed);
		}
		at.tau = at.omega = 1.0;
		plug->still &= !call(&at, a, NULL, NULL, NULL);
		at.tau = M_PI*noise(&seed);
		at.omega = 1.0 + 0.5*noise(&seed);
		plug->still &= !call(&at, other, NULL, NULL, NULL) &&
		               !memcmp(a, other, (size_t)of->n*sizeof *a);
		status = examine_at(&at, name, work + 2*of->n, report);
	}
	return status;
}

/* --- the model --- */

/* K, D and the waves, from a period at rest at a frequency; work [2 n^2 + 4 n]. Returns 1 if a value is
 * missing. */
static int linearise(struct hawser_rom_plug *plug, int n, double omega, double *work)
{
	double *rest = work, *a = work + 2*n, *by_omega = a + n, *by_u = by_omega + n, *by_v = by_u + n*n;
	struct at at = {.of = plug->of, .parameter = plug->parameter, .omega = omega, .u = rest,
		.v = rest + n, .relaxation = plug->relaxation, .water = plug->water};

	memset(rest, 0, 2*(size_t)n*sizeof *rest);
	for (int i = 0; i < PHASES; i++) {
		at.tau = 2.0*M_PI*i/PHASES;
		if (call(&at, a, by_u, by_v, by_omega))
			return 1;
		for (int e = 0; e < n*n; e++) {
			plug->K[e] -= by_u[e]/PHASES;
			plug->D[e] -= by_v[e]/PHASES;
		}
		for (int k = 0; k < HAWSER_PLUG_WAVES; k++)
			for (int j = 0; j < n; j++) {
				plug->wave[2*k*n + j] += (k ? 2.0 : 1.0)*a[j]*cos(k*at.tau)/PHASES;
				plug->wave[(2*k + 1)*n + j] += (k ? 2.0 : 0.0)*a[j]*sin(k*at.tau)/PHASES;
			}
	}
	return 0;
}

/* The forces at rest as harmonics, behind those that the model has. */
static enum hawser_status add_waves(struct hawser_rom *rom, const struct hawser_rom_plug *plug,
                                    struct hawser_report *report)
{
	size_t n = (size_t)rom->n, room = (size_t)rom->harmonics + 2*HAWSER_PLUG_WAVES;
	void *list = realloc(rom->harmonic, room*sizeof *rom->harmonic);

	if (!list)
		return hawser__no_memory(report, "rom");
	rom->harmonic = list;
	for (int i = 0; i < 2*HAWSER_PLUG_WAVES; i++) {
		struct hawser_harmonic *harmonic = &rom->harmonic[rom->harmonics];

		if (i == 1 || (i > 1 && plug->still)) /* there is no sine of 0 */
			continue;
		*harmonic = (struct hawser_harmonic){.k = i/2, .phase = i%2 ? HAWSER_SIN : HAWSER_COS,
			.f = malloc(n*sizeof *harmonic->f)};
		rom->harmonics++;
		if (!harmonic->f)
			return hawser__no_memory(report, "rom");
		memcpy(harmonic->f, plug->wave + (size_t)i*n, n*sizeof *harmonic->f);
	}
	return HAWSER_OK;
}

static enum hawser_status fill(struct hawser_rom *rom, const struct hawser_rom_plug *plug,
                               struct hawser_report *report)
{
	size_t n = (size_t)rom->n;
	enum hawser_status status = add_waves(rom, plug, report);

	memcpy(rom->K, plug->K, n*n*sizeof *rom->K);
	memcpy(rom->D, plug->D, n*n*sizeof *rom->D);
	return status ? status : hawser_rom_compile(rom, report);
}

/* 1 if all of the model at rest are numbers. */
static int is_finite(const struct hawser_rom_plug *plug, size_t n)
{
	double sum = 0.0;

	for (size_t i = 0; i < n*n; i++)
		sum += 0.0*plug->K[i] + 0.0*plug->D[i];
	for (size_t i = 0; i < 2*HAWSER_PLUG_WAVES*n; i++)
		sum += 0.0*plug->wave[i];
	return sum == 0.0;
}

static int set_room(struct hawser_rom_plug *plug, size_t n)
{
	plug->K = calloc(n*n, sizeof *plug->K);
	plug->D = calloc(n*n, sizeof *plug->D);
	plug->wave = calloc(2*HAWSER_PLUG_WAVES*n, sizeof *plug->wave);
	return plug->K && plug->D && plug->wave;
}

enum hawser_status hawser__plug_join(struct hawser_rom *rom, struct hawser__rom_morison *water,
                                     double omega, struct hawser_report *report)
{
	size_t n = (size_t)rom->n;
	double *work = calloc(2*n*n + 4*n, sizeof *work);
	struct hawser_rom_plug *plug = rom->plug = calloc(1, sizeof *plug);
	enum hawser_status status = HAWSER_OK;

	if (!plug) {
		hawser__rom_morison_free(water);
		free(work);
		return hawser__no_memory(report, "rom");
	}
	plug->water = water;
	plug->still = !water->waves && water->columns == water->n;
	if (!work || !set_room(plug, n))
		status = hawser__no_memory(report, "rom");
	else if (linearise(plug, rom->n, omega, work) || !is_finite(plug, n))
		status = hawser__fail(report, HAWSER_ERR_NAN, "rom", "the force of the water has no value at "
		                      "rest");
	free(work);
	if (status)
		return status;
	memset(plug->K, 0, n*n*sizeof *plug->K);
	cblas_daxpy((int)(n*n), 1.0, plug->D, 1, rom->D, 1);
	return plug->still ? HAWSER_OK : add_waves(rom, plug, report);
}

static enum hawser_status make_plug(struct hawser_rom *rom, const struct hawser_rom_source *source,
                                    double relaxation, double *work, struct hawser_report *report)
{
	const struct hawser_plugin *of = source->plugin;
	size_t n = (size_t)of->n, count = (size_t)of->parameters;
	struct hawser_rom_plug *plug;
	enum hawser_status status = hawser__rom_init(rom, of->n, report);

	if (status)
		return status;
	plug = rom->plug = calloc(1, sizeof *plug);
	if (plug) {
		plug->of = of;
		plug->relaxation = relaxation;
		plug->parameter = calloc(count + 1, sizeof *plug->parameter);
	}
	if (!plug || !set_room(plug, n) || !plug->parameter || !work)
		status = hawser__no_memory(report, "rom");
	for (size_t i = 0; !status && i < count; i++)
		plug->parameter[i] = source->parameter[i].value;
	if (!status)
		status = examine(plug, source->name, work, report);
	if (!status && (linearise(plug, of->n, 1.0, work) || !is_finite(plug, n)))
		status = hawser__fail(report, HAWSER_ERR_NAN, "rom",
		                      "%s: its function has no value at rest", source->name);
	if (!status)
		status = fill(rom, plug, report);
	return status;
}

enum hawser_status hawser__plug_make(struct hawser_rom *rom, const struct hawser_rom_source *source,
                                     struct hawser_report *report)
{
	size_t n = (size_t)source->plugin->n;
	double *work = calloc(2*n*n + 10*n, sizeof *work), relaxation = 0.0;
	struct hawser_rom *first = NULL;
	enum hawser_status status = HAWSER_OK;

	if (!source->plugin->acceleration) {
		first = calloc(1, sizeof *first);
		status = first ? make_plug(first, source, HAWSER__RATES_ALONE, work, report)
		               : hawser__no_memory(report, "rom");
		relaxation = status ? 1.0 : hawser__relaxation(first->K, (int)n);
	}
	*rom = (struct hawser_rom){.n = 0};
	if (!status)
		status = make_plug(rom, source, relaxation, work, report);
	free(work);
	if (status && first)
		hawser_rom_clear(first);
	if (status) {
		free(first);
		hawser_rom_clear(rom);
	} else {
		rom->first = first;
	}
	return status;
}

enum hawser_status hawser_rom_source_plugin(struct hawser_rom_source *source,
                                            const struct hawser_plugin *plugin, const char *name,
                                            struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int functions;

	*source = (struct hawser_rom_source){.plugin = plugin};
	if (!plugin)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%s: its function hawser_plugin returned no struct hawser_plugin", name);
	if (plugin->version < 1 || plugin->version > HAWSER_PLUGIN_VERSION)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%s is a library of version %d, and this program takes versions 1 to "
		                    "%d: compile it again", name, plugin->version, HAWSER_PLUGIN_VERSION);
	functions = (plugin->acceleration != NULL) + (plugin->version > 1 && plugin->rate != NULL);
	if (plugin->parameters > 0 && (!plugin->parameter || !plugin->value))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%s has %d parameters, and no list of their names or of their values",
		                    name, plugin->parameters);
	if (plugin->n < 1 || plugin->n > MOST || plugin->parameters < 0 ||
	    plugin->parameters > HAWSER_PARAMETERS || functions != 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%s has %d coordinates, %d parameters and %d functions: 1 to %d, 0 "
		                    "to %d and one are possible", name, plugin->n, plugin->parameters,
		                    functions, MOST, HAWSER_PARAMETERS);
	source->name = strdup(name);
	source->parameter = calloc((size_t)plugin->parameters + 1, sizeof *source->parameter);
	if (!source->name || !source->parameter)
		status = hawser__no_memory(report, "rom");
	for (int i = 0; !status && i < plugin->parameters; i++) {
		if (!plugin->parameter[i] || !hawser__formula_name(plugin->parameter[i]))
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                      "%s: parameter %d has the name \"%.40s\": write a letter, then up "
			                      "to 30 letters, digits and _, and no name of a function", name, i,
			                      plugin->parameter[i] ? plugin->parameter[i] : "");
		else
			memcpy(source->parameter[i].name, plugin->parameter[i], strlen(plugin->parameter[i]));
		source->parameter[i].value = plugin->value[i];
		source->parameters++;
	}
	if (status)
		hawser_rom_source_clear(source);
	return status;
}
