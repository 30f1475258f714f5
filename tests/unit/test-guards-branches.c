/* Errors of library functions that the program never causes, for curves: boundaries of beams,
 * branches of frequencies, maps. Statuses and messages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/beam.h>
#include <hawser/map.h>

#include "beam/boundary.h"
#include "modes/sweep/branches.h"
#include "tests/tap.h"

static struct hawser_report report;

static void refused(enum hawser_status got, enum hawser_status want, const char *message)
{
	ok(got == want && report.status == want && strstr(report.message, message), "%s: %s",
	   hawser_status_name(got), report.message);
	report = (struct hawser_report){.status = HAWSER_OK};
}

static const enum hawser_status no_convergence = HAWSER_ERR_CONVERGENCE;

/* --- boundaries of beams --- */

/* A family with a tension; below parameter 0 the tension and the bending rigidity are zero. */
static enum hawser_status at_tension(struct hawser_beam *beam, void *context, double parameter,
                                     struct hawser_report *why)
{
	(void)context;
	(void)why;
	*beam = (struct hawser_beam){.theta = parameter < 0.0 ? 0.0 : 1.0,
	                             .tension = fmax(parameter, 0.0)};
	return HAWSER_OK;
}

static enum hawser_status at_the_same(struct hawser_beam *beam, void *context, double parameter,
                                     struct hawser_report *why)
{
	(void)parameter;
	return at_tension(beam, context, 1.0, why);
}

static void boundary(const struct hawser_beam_integrals *is)
{
	struct hawser_beam_family family = {at_tension, NULL};
	struct hawser_beam_boundary_options options = {.from = 1.0, .to = 2.0, .modes = 2,
		.max_points = 3};
	struct hawser_beam_boundary curve;

	refused(hawser_beam_boundary(&curve, is, &family, &options, &report), no_convergence,
	        "3 points were not enough for the boundary");
	hawser_beam_boundary_clear(&curve);
}

static void equation(const struct hawser_beam_integrals *is)
{
	static const double along[3] = {1.0, 0.0, 0.0};
	struct hawser_beam_family family = {at_tension, NULL}, same = {at_the_same, NULL};
	struct hawser__onset_equation e;
	struct hawser__beam_sample stop;
	struct hawser_beam beam;
	double speed[64], u[3] = {1.0}, tangent[3];
	int count, buckled, iterations;
	enum hawser_status status = at_tension(&beam, NULL, 1.0, &report);

	status = status ? status : hawser_beam_static_speeds(speed, &count, &buckled, is, &beam, &report);
	status = status ? status : hawser__beam_sample(&stop, is, &beam, speed[0], 2, &report);
	if (!ok(!status, "a static speed: %s", report.message))
		return;
	if (ok(!hawser__onset_open(&e, HAWSER__STATIC, is, &family, &report), "its equation")) {
		hawser__onset_border(&e, &stop, 0.0);
		u[1] = 3.0*speed[0];
		refused(hawser__onset_correct(&e, u, along, &iterations, &report), no_convergence,
		        "the boundary was lost near the parameter 1, speed ");
		u[0] = -1.0;
		u[1] = 0.0;
		refused(hawser__onset_correct(&e, u, along, &iterations, &report), no_convergence,
		        "the boundary's equation is singular at -0.99");
		e.family = &same;
		u[0] = 1.0;
		refused(hawser__onset_tangent(&e, tangent, u, &report), no_convergence,
		        "the boundary has no unique tangent at the parameter 1, speed 0");
	}
	hawser__onset_clear(&e);
	hawser__beam_sample_clear(&stop);
}

/* --- branches of frequencies --- */

/* A sweep for the test. With *jump 0, H falls by 1 % from x = -infinity to infinity, and gaps that
 * fall with H have no minimum; with *jump 1, H is discontinuous at x = 0. */
static enum hawser_status statics_at(struct hawser_statics *statics, const struct hawser__branches *all,
                                double x, struct hawser_report *why)
{
	const int *jump = all->context;
	double H = *jump ? (x < 0.0 ? 4e5 : 3e3) : 5e4 - 500.0*atan(x)/M_PI;

	return hawser_statics_solve(statics, &all->span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, why);
}

static void describe(char *text, size_t size, const struct hawser_statics *statics)
{
	snprintf(text, size, "H = %.6g N", statics->H);
}

static void branches(void)
{
	static const struct hawser__sweep sweep = {.where = "sweep", .statics_at = statics_at,
	                                           .describe = describe};
	static const struct hawser_span span = {1e6, 6.0, 9.81, 250.0, 0.0};
	static const double ends[] = {-1.0, 1.0}, apart[] = {-1.0, -0.9};
	int jump = 0, enough, none[2] = {0};
	struct hawser__branches all = {.sweep = &sweep, .context = &jump, .span = span,
		.options = {.n = 8, .method = "spectral", .tolerance = 1e-8, .correlation = 0.75,
		            .crossing = 1e-8, .least_step = 0.1}};

	if (!ok(!hawser__branches_open(&all, &report) &&
	        !hawser__branches_follow(&all, apart, 2, &report), "two samples: %s", report.message))
		return;
	refused(hawser__branches_locate(&all, 0, &all.sample[0], &all.sample[1], &report), no_convergence,
	        "the modes 1 and 2 in the plane exchange their shapes near ");
	all.need = 700;
	all.ask = 900;
	refused(hawser__branches_enough(&enough, &all, none, &all.sample[0].statics, &report),
	        no_convergence, "more than 1000 modes are needed to follow the branches requested");
	hawser__branches_clear(&all);
	jump = 1;
	all = (struct hawser__branches){.sweep = &sweep, .context = &jump, .span = span,
		.options = all.options};
	if (ok(!hawser__branches_open(&all, &report), "a sweep with a jump"))
		refused(hawser__branches_follow(&all, ends, 2, &report), no_convergence,
		        "three or more branches in the plane change their shapes within a step of 0.1");
	hawser__branches_clear(&all);
}

/* --- points of maps without a value, and the reasons --- */

static void told(struct hawser_map_source *source, double x, double y, enum hawser_map_code code,
                 const char *message)
{
	struct hawser_map_sample sample = {.code = HAWSER_MAP_OK};
	struct hawser_map_field field;
	void *worker = NULL;
	int sound;

	if (!ok(!hawser_map_cable_open(&field, source, &report), "a map of %s %s", source->quantity,
	        report.message))
		return;
	sound = !field.open(&worker, field.context, &report) &&
	        (!field.prepare || !field.prepare(field.context, &x, &y, 1, 1, &report)) &&
	        !field.point(worker, &sample, NULL, x, y, &report);
	ok(sound && sample.code == code && strstr(report.message, message), "%s: %s",
	   hawser_map_code_name(sample.code), report.message);
	report = (struct hawser_report){.status = HAWSER_OK};
	field.close(worker);
	hawser_map_cable_close(&field);
}

static void points(void)
{
	static const char *const set[] = {"model.condense=static", "model.modes=3", "tension.T0=40000",
	                                  "load.per_length=[0, 80, 0]"};
	struct hawser_map_source source = {.quantity = "multiplier", .key = {"Omega", "factor.load"},
		.from = {-1.0, 0.5}, .to = {1.0, 1.5}};
	struct hawser_scene scene;
	const char *path = source_file("notebooks-data/scenes/b-table-4.2.yaml");

	if (!ok(!hawser_scene_open(&scene, path, set, 4, &report), "a deep span %s", report.message))
		return;
	source.scene = &scene;
	told(&source, -0.5, 1.0, HAWSER_MAP_REFUSED, "Omega = -0.5: it must be greater than zero");
	source.quantity = "amplitude";
	source.from[0] = 0.2;
	told(&source, 1.0, 1.0, HAWSER_MAP_SLACK, "N: a cable cannot carry that");
	hawser_scene_clear(&scene);
}

CASE(unit_guards_branches)
{
	struct hawser_beam_integrals is;

	if (!ok(!hawser_beam_method(0)->fill(&is, HAWSER_ENDS_SIMPLE, 8, &report), "integrals"))
		return done_testing();
	boundary(&is);
	equation(&is);
	hawser_beam_integrals_clear(&is);
	branches();
	points();
	return done_testing();
}
