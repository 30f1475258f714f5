/* Linear response of nets to waves: reference case W20 of doc/water.md, a body on springs, in regular
 * waves and in a sea; W12, a buoy on a tether; and what is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <string.h>

#include <hawser/net_waves.h>

#include "tests/tap.h"

/* A body between two cables along x, held along y and z: 8000 x'' + 5000 x = 2050 |r| r + 6000 u'.
 * It is at the bed, where waves have no vertical velocity. */
struct wavy_body {
	struct hawser_net net;
	struct hawser_net_node node[3];
	struct hawser_net_cable cable[2];
};

static void wavy_body(struct wavy_body *body, const struct hawser_waves_given *given)
{
	static char name[] = "body";
	struct hawser_report report = {0};
	struct hawser_net *net = &body->net;

	memset(body, 0, sizeof *body);
	*net = (struct hawser_net){.name = name, .g = 9.81, .node = body->node, .cable = body->cable,
	                           .nodes = 3, .cables = 2,
	                           .water = {.density = 1025.0, .given = *given}};
	for (int i = 0; i < 3; i++) {
		body->node[i].x[0] = 100.0*(i - 1);
		body->node[i].x[1] = -given->depth;
		memset(body->node[i].held, 1, 3);
	}
	body->node[1].held[0] = 0;
	body->node[1].mass = 6000.0;
	body->node[1].buoy = (struct hawser_water_buoy){6000.0, 4000.0/1025.0, 4.0, 0.5};
	for (int i = 0; i < 2; i++) {
		body->cable[i].from = i;
		body->cable[i].to = i + 1;
		body->cable[i].EA = 2500.0*99.0;
		body->cable[i].value = 99.0;
		body->cable[i].elements = 1 + i;
	}
	if (hawser_waves_make(&net->water.waves, given, &report) != HAWSER_OK)
		ok(0, "waves: %s", report.message);
}

static struct hawser_net_waves wavy_response(const struct hawser_net *net,
                                             struct hawser_net_waves_options *options)
{
	static const struct hawser_net_probe probe[2] = {{1, -1, 0.0}, {-1, 0, 0.5}};
	struct hawser_report report = {0};
	struct hawser_net_waves waves;
	enum hawser_status status;

	options->probe = probe;
	options->probes = 2;
	status = hawser_net_waves_solve(&waves, net, options, &report);
	ok(!status, "response: %s", status ? report.message : "solved");
	return waves;
}

/* W20 in waves of 8 s whose velocity has the amplitude 1 m/s at the body. */
static void wavy_regular(void)
{
	const double omega = 2.0*acos(-1.0)/8.0, a = sinh(hawser_wave_number(omega, 11.0, 9.81)*11.0)/omega;
	struct hawser_net_waves_options options = {.from = omega, .to = omega, .points = 1};
	struct hawser_net_waves waves;
	struct wavy_body body;

	wavy_body(&body, &(struct hawser_waves_given){.height = 2.0*a, .period = 8.0, .depth = 11.0});
	waves = wavy_response(&body.net, &options);
	close_to(a*waves.x[0], 2.435624, 2e-7, "W20: amplitude in regular waves");
	close_to(waves.size[0][0], a*waves.x[0], 1e-15, "  that of the scene's height");
	close_to(waves.x[3], 0.5*waves.x[0], 1e-12, "  half of it in the middle of a cable");
	close_to(waves.T[1], 2500.0*waves.x[0], 1e-12, "  tension of the cable");
	ok(fabs(waves.x[1]) + fabs(waves.x[2]) < 1e-12, "  along x alone");
	ok(waves.iterations < 40 && waves.touching == 0, "  %d iterations", waves.iterations);
	hawser_net_waves_clear(&waves);
	/* half the height: less drag, more response per metre near the resonance */
	body.net.water.given.height = a;
	waves = wavy_response(&body.net, &options);
	ok(a*waves.x[0] > 2.6, "  half the height: %g m per metre more", a*waves.x[0]);
	hawser_net_waves_clear(&waves);
	hawser_waves_clear(&body.net.water.waves);
}

/* The standard deviation of x by the scalar equation, the body at the height y; that of the water. */
static double wavy_scalar(double *s_u, const struct hawser_waves *sea, double y)
{
	double s_r = 0.3, s_x = 0.0;

	for (int n = 0; n < 200; n++) {
		double sum[3] = {0.0}, c = 2050.0*sqrt(8.0/acos(-1.0))*s_r;

		for (int i = 0; i < sea->count; i++) {
			const struct hawser_wave *wave = &sea->wave[i];
			double w = wave->omega, a2 = 0.5*wave->amplitude*wave->amplitude;
			double u = w*cosh(wave->k*(sea->depth + y))/sinh(wave->k*sea->depth);
			double complex x = (c - 6000.0*I*w)*u/(5000.0 - 8000.0*w*w - I*w*c), r = u + I*w*x;

			sum[0] += a2*u*u;
			sum[1] += a2*creal(x*conj(x));
			sum[2] += a2*creal(r*conj(r));
		}
		*s_u = sqrt(sum[0]);
		s_x = sqrt(sum[1]);
		s_r = 0.5*(s_r + sqrt(sum[2]));
	}
	return s_x;
}

/* W20 in a sea, by the scalar equation; then the mesh against it, at the bed. */
static void wavy_sea(void)
{
	struct hawser_waves_given given = {
		.Hs = 3.0, .Tp = 9.0, .depth = 60.0, .seed = HAWSER_NONE, .components = 200};
	struct hawser_net_waves_options options = {.points = 7};
	struct hawser_net_waves waves;
	struct wavy_body body;
	double s_x, s_u;

	wavy_body(&body, &given);
	s_x = wavy_scalar(&s_u, &body.net.water.waves, -10.0);
	close_to(s_u, 0.29807, 1e-4, "W20: the water in a sea");
	close_to(s_x, 0.75374, 1e-4, "  the motion");
	hawser_waves_clear(&body.net.water.waves);
	given.depth = 19.0;
	given.components = 70;
	wavy_body(&body, &given);
	waves = wavy_response(&body.net, &options);
	s_x = wavy_scalar(&s_u, &body.net.water.waves, -19.0);
	close_to(waves.size[0][0], s_x, 1e-7, "  the mesh as the scalar equation");
	close_to(waves.T_size[0][1], 2500.0*s_x, 1e-7, "  tension of its cable");
	ok(waves.spectrum[3] > 0.0 && waves.omega[6] < 5.0*2.0*acos(-1.0)/9.0, "  over the sea's range");
	hawser_net_waves_clear(&waves);
	hawser_waves_clear(&body.net.water.waves);
}

/* W12: a buoy on a tether from the bed, in waves of 4 m; its linear response by another program. */
static void wavy_tether(void)
{
	const double omega = 2.0*acos(-1.0)/9.0;
	const struct hawser_net_probe probe = {1, -1, 0.0};
	struct hawser_net_waves_options options = {
		.from = omega, .to = omega, .points = 1, .probe = &probe, .probes = 1};
	struct hawser_report report = {0};
	struct hawser_net_waves waves;
	struct wavy_body body;
	enum hawser_status status;

	wavy_body(&body, &(struct hawser_waves_given){.height = 4.0, .period = 9.0, .depth = 60.0});
	body.net.nodes = 2;
	body.net.cables = 1;
	memset(body.node[0].x, 0, sizeof body.node[0].x);
	body.node[0].x[1] = -60.0;
	memset(&body.node[1], 0, sizeof body.node[1]);
	body.node[1].mass = 3000.0;
	body.node[1].buoy = (struct hawser_water_buoy){3000.0, 8.0, 3.0, 0.5};
	body.cable[0] = (struct hawser_net_cable){.from = 0, .to = 1, .EA = 8e6, .rho = 6.0, .value = 48.0,
		.elements = 10, .line = {0.08, 1.2, 0.02, 1.0, 0.1}};
	status = hawser_net_waves_solve(&waves, &body.net, &options, &report);
	ok(!status, "W12: %s", status ? report.message : "solved");
	close_to(waves.size[0][0], 2.445, 3e-3, "W12: linear motion of the buoy");
	close_to(waves.T_size[0][0], 6944.0, 3e-3, "W12: linear tension at the bed");
	hawser_net_waves_clear(&waves);
	hawser_waves_clear(&body.net.water.waves);
}

static int wavy_stop(void *data, const struct hawser_progress_state *state)
{
	(void)data;
	return state->done == 3;
}

static void wavy_refused(void)
{
	struct hawser_net_waves_options options = {.points = 1};
	struct hawser_report report = {0};
	struct hawser_net_waves waves;
	struct wavy_body body;

	wavy_body(&body, &(struct hawser_waves_given){.height = 2.0, .period = 8.0, .depth = 40.0});
	body.net.ratio = 0.01;
	ok(hawser_net_waves_solve(&waves, &body.net, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "rayleigh"), "refused: %s", report.message);
	body.net.ratio = 0.0;
	options.iterations = 1;
	ok(hawser_net_waves_solve(&waves, &body.net, &options, &report) == HAWSER_ERR_CONVERGENCE &&
	   waves.omega == NULL, "not converged: %s", report.message);
	options.iterations = 0;
	body.net.motions = 1;
	ok(hawser_net_waves_solve(&waves, &body.net, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "motions of supports"), "refused: %s", report.message);
	body.net.motions = 0;
	options.progress.function = wavy_stop;
	options.points = 5;
	ok(hawser_net_waves_solve(&waves, &body.net, &options, &report) == HAWSER_OK &&
	   waves.interrupted && waves.points == 3, "ended by the caller after %d points", waves.points);
	hawser_net_waves_clear(&waves);
	hawser_waves_clear(&body.net.water.waves);
	ok(hawser_net_waves_solve(&waves, &body.net, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "no waves"), "refused: %s", report.message);
}

CASE(reference_net_waves)
{
	wavy_regular();
	wavy_sea();
	wavy_tether();
	wavy_refused();
	return done_testing();
}
