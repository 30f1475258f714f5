/* Quadratic drag of air: the derivative of its force against differences, the loss of energy against
 * the dissipation, the resonance of one mode and of several against the describing function and against
 * the motion from rest after a long time; drag alone leaves out shapes that it does not damp; wind.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/folds.h>
#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "tests/tap.h"

static const struct hawser_span span = {.EA = 4e8, .rho = 6.0, .g = 9.81, .d = 250.0, .h = 10.0};
static struct hawser_report report;

static int solve(struct hawser_modes *modes, int n)
{
	struct hawser_modes_options options = {.n = n};
	struct hawser_statics statics;

	return ok(!hawser_statics_solve(&statics, &span, HAWSER_GIVEN_H, 8e4, HAWSER_BRANCH_TAUT,
	                                &report) &&
	          !hawser_modes_solve(modes, &statics, &options, &report), "%d modes %s", n,
	          report.message);
}

/* By Simpson's rule in 4000 intervals: force on coordinate j at velocities v, in units of the model. */
static double by_simpson(const struct hawser_modes *modes, double c, const double *v, int j)
{
	enum { cuts = 4000 };
	double l = modes->statics.l, sum = 0.0;

	for (int i = 0; i <= cuts; i++) {
		double q = 0.0, b = 0.0, own[3] = {0.0};

		for (int k = 0; k < modes->n; k++) {
			double phi[3];

			hawser_modes_at(modes, phi, NULL, k, l*i/cuts);
			q += v[k]*phi[1];
			b += v[k]*phi[2];
			if (k == j)
				memcpy(own, phi, sizeof own);
		}
		sum += (i == 0 || i == cuts ? 1.0 : i%2 ? 4.0 : 2.0)*hypot(q, b)*(q*own[1] + b*own[2]);
	}
	return -c*span.d/span.rho*sum*l/cuts/3.0;
}

static void check_force(const struct hawser_modes *modes)
{
	enum { N = 6 };
	const struct hawser_scene scene = {.damping = {.drag = 0.05}};
	const double u[N] = {0.0}, h = 1e-6;
	double v[N], a[N], ahead[N], back[N], by_u[N*N], by_v[N*N], by_omega[N], worst = 0.0, gap = 0.0;
	double largest = 0.0;
	struct hawser_rom rom;

	if (!ok(!hawser_rom_build(&rom, modes, &scene, &report), "a model with drag %s", report.message))
		return;
	for (int draw = 0; draw < 4; draw++) {
		for (int j = 0; j < N; j++)
			v[j] = sin(1.7*draw + 2.385*j*j + 0.3);
		hawser_rom_acceleration_jacobian(&rom, a, by_u, by_v, by_omega, u, v, 0.0, 1.0);
		for (int j = 0; j < N; j++) {
			gap = fmax(gap, fabs(a[j] - by_simpson(modes, 0.05, v, j)));
			largest = fmax(largest, fabs(a[j]));
		}
		for (int k = 0; k < N; k++) {
			double keep = v[k];

			v[k] = keep + h;
			hawser_rom_acceleration(&rom, ahead, u, v, 0.0, 1.0);
			v[k] = keep - h;
			hawser_rom_acceleration(&rom, back, u, v, 0.0, 1.0);
			v[k] = keep;
			for (int j = 0; j < N; j++)
				worst = fmax(worst, fabs(by_v[j*N + k] - (ahead[j] - back[j])/(2.0*h)));
		}
	}
	ok(gap < 1e-3*largest, "force at random velocities against Simpson's rule: %.1e of %.1e", gap,
	   largest);
	ok(worst < 1e-7*largest, "its derivative against differences: %.1e", worst);
	hawser_rom_clear(&rom);
}

/* The energy lost over a free motion is the integral of -F . v over time. */
static void check_energy(const struct hawser_modes *modes)
{
	enum { N = 6 };
	const struct hawser_scene scene = {.damping = {.drag = 0.3}};
	double start[2*N] = {2e-3, -3e-3, 1e-3, 1.5e-3, 0.0, 1e-3, 4e-3}, lost = 0.0, first, last;
	struct hawser_integrate_options options = {.until = 40.0, .every = 0.01, .initial = start};
	struct hawser_trajectory run;
	struct hawser_rom rom;

	if (hawser_rom_build(&rom, modes, &scene, &report) ||
	    !ok(!hawser_integrate(&run, &rom, &options, &report), "free decay %s", report.message))
		return;
	for (int i = 0; i < run.rows; i++) {
		const double *u = run.state + (size_t)i*2*N, *v = u + N;
		double still[N], moving[N], none[N] = {0.0};

		hawser_rom_acceleration(&rom, still, u, none, 0.0, 1.0);
		hawser_rom_acceleration(&rom, moving, u, v, 0.0, 1.0);
		for (int j = 0; j < N; j++)
			lost -= (i == 0 || i == run.rows - 1 ? 0.5 : 1.0)*0.01*(moving[j] - still[j])*v[j];
	}
	first = hawser_rom_energy(&rom, run.state, run.state + N);
	last = hawser_rom_energy(&rom, run.state + (size_t)(run.rows - 1)*2*N,
	                         run.state + (size_t)(run.rows - 1)*2*N + N);
	ok(last < 0.9*first, "the energy falls to %.3f of the initial one", last/first);
	close_to(lost, first - last, 1e-5, "what is lost is what drag dissipates");
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

/* One mode out of plane at resonance: F cos(omega t) against 8/(3 pi) c'' omega^2 A^2, with c'' = c'
 * times the integral of |B|^3. The amplitude is so small that the cable is linear. */
static void check_resonance(const struct hawser_modes *modes)
{
	const struct hawser_scene scene = {.damping = {.drag = 0.4},
		.load = {.present = 1, .per_length = {0.0, 0.0, 1e-4}, .extent = {0.0, 1.0}},
		.model = {.inertia = HAWSER_INERTIA_NONE, .condense = HAWSER_CONDENSE_NONE}};
	double u = 0.0, one = 1.0, c, omega, A, worst = 0.0;
	struct hawser_frf_options options = {0};
	struct hawser_modes first = {.n = 0};
	const int kept[] = {0};
	struct hawser_rom rom;
	struct hawser_frf frf;
	double force;

	if (!ok(!hawser_modes_select(&first, modes, kept, 1, &report) &&
	        !hawser_rom_build(&rom, &first, &scene, &report), "one mode %s", report.message))
		return;
	hawser_rom_acceleration(&rom, &force, &u, &one, M_PI_2, 1.0);
	c = -force;
	omega = sqrt(rom.K[0]);
	A = sqrt(fabs(rom.harmonic[0].f[0])*3.0*M_PI/(8.0*c))/omega;
	close_to(c, -by_simpson(&first, 0.4, &one, 0), 1e-9, "a half wave: drag at velocity 1");
	options.from = 0.98*omega;
	options.to = 1.02*omega;
	if (ok(!hawser_frf_trace(&frf, &rom, &options, &report), "response %s", report.message)) {
		double top = 0.0;

		for (int p = 0; p < frf.points; p++) {
			top = fmax(top, frf.coordinate[p]);
			worst = fmax(worst, frf.point[p].liouville);
		}
		ok(!strcmp(frf.method, "shooting"), "by shooting");
		close_to(top, A, 2e-3, "peak by the describing function");
		ok(worst < 1e-5, "multipliers and contraction agree to %.1e", worst);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&first);
}

/* The largest |u_j| over the last `rows` rows. */
static double late(const struct hawser_trajectory *run, int n, int j, int rows)
{
	double most = 0.0;

	for (int i = run->rows - rows; i < run->rows; i++)
		most = fmax(most, fabs(run->state[(size_t)i*2*(size_t)n + (size_t)j]));
	return most;
}

/* Six modes with drag as the only damping: the peak, and the motion from rest after 160 periods. */
static void check_several(const struct hawser_modes *modes)
{
	const struct hawser_scene scene = {.damping = {.drag = 1.7},
		.load = {.present = 1, .per_length = {0.0, 0.0, 0.1}, .extent = {0.0, 1.0}}};
	struct hawser_integrate_options options = {0};
	struct hawser_frf_options range = {0};
	struct hawser_trajectory run = {0};
	struct hawser_rom rom;
	struct hawser_frf frf = {0};
	double one[6] = {1.0}, u[6] = {0.0}, force[6], A;
	int top = 0;

	if (!ok(!hawser_rom_build(&rom, modes, &scene, &report) && rom.n == 6, "six modes %s",
	        report.message))
		return;
	hawser_rom_acceleration(&rom, force, u, one, M_PI_2, 1.0);
	A = sqrt(fabs(rom.harmonic[0].f[0])*3.0*M_PI/(8.0*-force[0])/rom.K[0]);
	range.from = 0.9*sqrt(rom.K[0]);
	range.to = 1.1*sqrt(rom.K[0]);
	if (!ok(!hawser_frf_trace(&frf, &rom, &range, &report), "response of six %s", report.message))
		return;
	for (int p = 0; p < frf.points; p++)
		if (frf.coordinate[p*6] > frf.coordinate[top*6])
			top = p;
	close_to(frf.coordinate[top*6], A, 5e-3, "peak of six modes by the describing function");
	options.omega = frf.point[top].omega;
	options.every = 2.0*M_PI/options.omega/40.0;
	options.until = 160.0*40.0*options.every;
	if (ok(!hawser_integrate(&run, &rom, &options, &report), "from rest %s", report.message))
		close_to(late(&run, 6, 0, 40), frf.coordinate[top*6], 3e-3, "from rest after 160 periods");
	hawser_trajectory_clear(&run);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* Shapes for the inertia of condensed modes move along the cable. Drag alone leaves them undamped, so
 * that there are none; the error is stated. With little linear damping they are there. */
static void check_shapes(const struct hawser_modes *modes)
{
	struct hawser_scene scene = {.damping = {.drag = 0.01},
		.load = {.present = 1, .per_length = {0.0, 0.0, 30.0}, .extent = {0.0, 1.0}}};
	struct hawser_modes first = {.n = 0};
	const int kept[] = {0};
	struct hawser_rom rom;

	if (!ok(!hawser_modes_select(&first, modes, kept, 1, &report) &&
	        !hawser_rom_build(&rom, &first, &scene, &report), "built: %s", report.message))
		return;
	ok(rom.n == 1 && rom.inertia.shapes == 0 && rom.inertia.shift > 2e-4 &&
	   rom.inertia.left == rom.inertia.shift, "drag alone: no shapes, resonance frequencies off by "
	   "%.1e", rom.inertia.shift);
	hawser_rom_clear(&rom);
	scene.damping.kind = HAWSER_DAMPING_RATIO;
	scene.damping.ratio = 1e-3;
	if (ok(!hawser_rom_build(&rom, &first, &scene, &report), "built: %s", report.message))
		ok(rom.inertia.shapes > 0, "with a ratio: %d shapes", rom.inertia.shapes);
	hawser_rom_clear(&rom);
	scene.load.per_length[2] = 0.05;
	if (ok(!hawser_rom_build(&rom, &first, &scene, &report), "built: %s", report.message))
		ok(rom.n == 1, "at small amplitudes none");
	hawser_rom_clear(&rom);
	hawser_modes_clear(&first);
}

static void refuse(enum hawser_status status, const char *text)
{
	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, text), "refused: %s", report.message);
}

static void check_refusals(const struct hawser_modes *modes)
{
	struct hawser_scene scene = {.damping = {.drag = 0.4},
		.load = {.present = 1, .per_length = {0.0, 0.0, 1.0}, .extent = {0.0, 1.0}}};
	struct hawser_frf_options options = {.from = 1.0, .to = 2.0, .method = "balance"};
	struct hawser_folds_options folds_options = {.from = 1.0, .to = 2.0, .load_from = 0.5,
	                                             .load_to = 1.0};
	struct hawser_auto_options to_auto = {.from = 1.0, .to = 2.0};
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_folds folds;

	if (hawser_rom_build(&rom, modes, &scene, &report))
		return;
	refuse(hawser_frf_trace(&frf, &rom, &options, &report), "has no quadratic drag");
	refuse(hawser_folds_trace(&folds, &rom, &folds_options, &report), "has no quadratic drag");
	refuse(hawser_rom_save(&rom, "-", &report), "has no quadratic drag");
	refuse(hawser_rom_export_auto(&rom, "drag", &to_auto, &report), "has no quadratic drag");
	hawser_rom_clear(&rom);
	scene.support[1].present = 1;
	scene.support[1].motion[1] = 0.1;
	scene.support[1].harmonic = 1;
	refuse(hawser_rom_build(&rom, modes, &scene, &report), "supports at rest");
	scene.support[1].present = 0;
	scene.travel.present = 1;
	scene.travel.speed = 1.0;
	refuse(hawser_rom_build(&rom, modes, &scene, &report), "does not travel");
	/* a wind of 9 N/m by drag 0.4: 2 c w = 2 sqrt(0.4*9) = 3.79 along it */
	scene.travel.present = 0;
	scene.static_load.present = 1;
	scene.static_load.per_length[2] = -9.0;
	refuse(hawser_rom_build(&rom, modes, &scene, &report), "to 3.79 kg/m/s");
	scene.static_load.per_length[2] = 0.0;
	scene.static_load.per_length[1] = -9.0;
	ok(!hawser_rom_build(&rom, modes, &scene, &report), "a weight is no wind");
	hawser_rom_clear(&rom);
}

CASE(property_drag)
{
	struct hawser_modes modes;

	if (solve(&modes, 6)) {
		check_force(&modes);
		check_energy(&modes);
		check_resonance(&modes);
		check_several(&modes);
		check_shapes(&modes);
		check_refusals(&modes);
		hawser_modes_clear(&modes);
	}
	return done_testing();
}
