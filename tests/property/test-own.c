/* Own models by routes that share no code: forces of all terms against differences; a forced Rayleigh
 * oscillator against GSL's integrator; a mass matrix against modal coordinates that are computed here;
 * equations of first order against those of second; harmonics with Q and C against the same waves
 * written out; parameters against files with their values.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <stdlib.h>
#include <unistd.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "tests/tap.h"

static struct hawser_report report;

static int open_text(struct hawser_rom *rom, const char *text)
{
	char path[] = "/tmp/hawser-own-XXXXXX";
	int file = mkstemp(path), fine = file >= 0;

	fine = fine && write(file, text, strlen(text)) == (ssize_t)strlen(text);
	if (file >= 0)
		close(file);
	report.message[0] = '\0';
	fine = fine && !hawser_rom_open(rom, path, &report);
	unlink(path);
	return ok(fine, "%.60s... read %s", text, report.message);
}

static double noise(unsigned *seed)
{
	*seed = *seed*1664525u + 1013904223u;
	return (*seed >> 8)/8388608.0 - 1.0;
}

/* Jacobians at random states against central differences. */
static void differentiated(const char *text, unsigned seed)
{
	enum { N = 3 };
	double u[2*N], a[N], ahead[N], back[N], by_u[N*N], by_v[N*N], by_omega[N], h = 1e-6, worst = 0.0;
	struct hawser_rom rom;
	int n;

	if (!open_text(&rom, text))
		return;
	n = rom.n;
	for (int t = 0; t < 20; t++) {
		double tau = 3.0*noise(&seed), omega = 1.3 + 0.5*noise(&seed);

		for (int i = 0; i < 2*n; i++)
			u[i] = noise(&seed);
		hawser_rom_acceleration_jacobian(&rom, a, by_u, by_v, by_omega, u, u + n, tau, omega);
		hawser_rom_acceleration(&rom, ahead, u, u + n, tau, omega);
		for (int j = 0; j < n; j++)
			worst = fmax(worst, fabs(a[j] - ahead[j]));
		for (int i = 0; i <= 2*n; i++) {
			double *x = i < 2*n ? &u[i] : &omega, keep = *x;

			*x = keep + h;
			hawser_rom_acceleration(&rom, ahead, u, u + n, tau, omega);
			*x = keep - h;
			hawser_rom_acceleration(&rom, back, u, u + n, tau, omega);
			*x = keep;
			for (int j = 0; j < n; j++) {
				double d = (ahead[j] - back[j])/(2.0*h);
				double got = i < n ? by_u[j*n + i] : i < 2*n ? by_v[j*n + i - n] : by_omega[j];

				worst = fmax(worst, fabs(d - got));
			}
		}
	}
	ok(worst < 2e-8, "derivatives of its forces: %.1e", worst);
	hawser_rom_clear(&rom);
}

/* --- against GSL --- */

/* u'' - 0.2 u' + u + 0.1 u'^3 - 0.05 u^2 u' + 0.02 u^5 = 0.5 cos(omega t) */
static int rayleigh(double t, const double *y, double *f, void *omega)
{
	f[0] = y[1];
	f[1] = 0.2*y[1] - y[0] - 0.1*pow(y[1], 3) + 0.05*y[0]*y[0]*y[1] - 0.02*pow(y[0], 5) +
	       0.5*cos(*(double *)omega*t);
	return GSL_SUCCESS;
}

static void integrate_gsl(double *y, double omega, double to)
{
	gsl_odeiv2_system system = {rayleigh, NULL, 2, &omega};
	gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3,
	                                                          1e-13, 1e-13);
	double t = 0.0;

	gsl_odeiv2_driver_apply(driver, &t, to, y);
	gsl_odeiv2_driver_free(driver);
}

#define RAYLEIGH "{\"n\": 1, \"K\": [[1]], \"D\": [[-0.2]], \"terms\": [[0, [], [0, 0, 0], 0.1], " \
	"[0, [0, 0], [0], -0.05], [0, [0, 0, 0, 0, 0], [], 0.02]], \"harmonics\": [{\"k\": 1, " \
		"\"f\": [0.5]}]}"

static void check_gsl(void)
{
	struct hawser_frf_options options = {.from = 0.8, .to = 1.3};
	double gap = 0.0, slope = 0.0, y[4], *x, h = 1e-5;
	struct hawser_trajectory run;
	struct hawser_rom rom;
	struct hawser_frf frf;
	int torus = 0;

	if (!open_text(&rom, RAYLEIGH))
		return;
	ok(!hawser_frf_trace(&frf, &rom, &options, &report), "its response %s", report.message);
	for (int p = 3; p < frf.points; p += frf.points/6) {
		double omega = frf.point[p].omega, T = 2.0*M_PI/omega, A[4];

		x = frf.state + 2*(size_t)p;
		memcpy(y, x, 2*sizeof *y);
		integrate_gsl(y, omega, T);
		gap = fmax(gap, hypot(y[0] - x[0], y[1] - x[1])/hypot(x[0], x[1]));
		for (int i = 0; i < 2; i++) {
			memcpy(y, x, 2*sizeof *y);
			memcpy(y + 2, x, 2*sizeof *y);
			y[i] += h;
			y[2 + i] -= h;
			integrate_gsl(y, omega, T);
			integrate_gsl(y + 2, omega, T);
			A[i] = (y[0] - y[2])/(2.0*h);
			A[2 + i] = (y[1] - y[3])/(2.0*h);
		}
		slope = fmax(slope, fabs(log(A[0]*A[3] - A[1]*A[2]) - frf.multiplier[4*(size_t)p] -
		                         frf.multiplier[4*(size_t)p + 2]));
	}
	ok(gap < 1e-8, "GSL returns to the orbits: %.1e", gap);
	ok(slope < 1e-7, "and has the product of their multipliers: %.1e", slope);
	for (int e = 0; e < frf.events; e++)
		torus += frf.event[e].kind == HAWSER_TORUS;
	ok(torus == 2, "the forced oscillation is locked between two torus points (%d)", torus);
	y[0] = 0.3;
	y[1] = -0.2;
	ok(!hawser_integrate(&run, &rom, &(struct hawser_integrate_options){.omega = 1.1, .until = 20.0,
	                     .every = 20.0, .rtol = 1e-11, .initial = y}, &report), "%s", report.message);
	integrate_gsl(y, 1.1, 20.0);
	x = run.state + 2*(size_t)(run.rows - 1);
	ok(hypot(x[0] - y[0], x[1] - y[1]) < 1e-8, "the motion from a state: %.1e",
	   hypot(x[0] - y[0], x[1] - y[1]));
	hawser_trajectory_clear(&run);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* --- two files of the same model --- */

static int respond(struct hawser_frf *frf, struct hawser_rom *rom, const char *text, double from,
                   double to)
{
	struct hawser_frf_options options = {.from = from, .to = to, .method = "shooting"};

	if (!open_text(rom, text))
		return 0;
	return ok(!hawser_frf_trace(frf, rom, &options, &report), "its response %s", report.message);
}

static void same_events(const char *a, const char *b, double from, double to, int events,
                        const char *what)
{
	struct hawser_rom rom[2] = {{0}};
	struct hawser_frf frf[2] = {{0}};
	double worst = 0.0;

	if (respond(&frf[0], &rom[0], a, from, to) && respond(&frf[1], &rom[1], b, from, to)) {
		int same = frf[0].events == events && frf[1].events == events;

		for (int e = 0; same && e < events; e++)
			worst = fmax(worst, frf[0].event[e].kind == frf[1].event[e].kind
			                    ? fabs(frf[0].event[e].omega/frf[1].event[e].omega - 1.0) : 1.0);
		ok(same && worst < 1e-9, "%s: %d and %d of %d events, the same to %.1e", what, frf[0].events,
		   frf[1].events, events, worst);
	}
	for (int i = 0; i < 2; i++) {
		hawser_frf_clear(&frf[i]);
		hawser_rom_clear(&rom[i]);
	}
}

/* M = [[2, 0.5], [0.5, 1]], K = [[6, -1], [-1, 2]], a cubic spring on x_1 and one between both. The
 * modes of a pair of 2 by 2 matrices by hand: det(K - w M) = 0. */
static void check_mass(void)
{
	const double M[4] = {2.0, 0.5, 0.5, 1.0}, K[4] = {6.0, -1.0, -1.0, 2.0}, f[2] = {0.3, 0.1};
	double a = M[0]*M[3] - M[1]*M[2], b = -(K[0]*M[3] + K[3]*M[0] - 2.0*K[1]*M[1]);
	double c = K[0]*K[3] - K[1]*K[2], root = sqrt(b*b - 4.0*a*c), w[2] = {(-b - root)/(2.0*a),
		(-b + root)/(2.0*a)}, v[2][2], energy[2], u[4] = {0.3, -0.2, 0.1, 0.4};
	struct hawser_trajectory run;
	struct hawser_rom rom;
	char text[2000];
	int used;

	for (int i = 0; i < 2; i++) {
		double x = -(K[1] - w[i]*M[1]), y = K[0] - w[i]*M[0];
		double size = sqrt(M[0]*x*x + 2.0*M[1]*x*y + M[3]*y*y);

		v[i][0] = x/size;
		v[i][1] = y/size;
	}
	/* potential 0.2 x_1^4/4 + 0.5 (x_0 - x_1)^4/4, D = 0.03 K; x = sum of v_i q_i */
	used = snprintf(text, sizeof text, "{\"n\": 2, \"K\": [[%.17g, 0], [0, %.17g]], "
	                "\"D\": [[%.17g, 0], "
	                "[0, %.17g]], \"harmonics\": [{\"k\": 1, \"f\": [%.17g, %.17g]}], \"C\": [", w[0],
		w[1],
	                0.03*w[0], 0.03*w[1], v[0][0]*f[0] + v[0][1]*f[1], v[1][0]*f[0] + v[1][1]*f[1]);
	for (int e = 0; e < 16; e++) {
		int j = e/8, k = e/4%2, l = e/2%2, m = e%2;
		double value = 0.2*v[j][1]*v[k][1]*v[l][1]*v[m][1] + 0.5*(v[j][0] - v[j][1])*
		               (v[k][0] - v[k][1])*(v[l][0] - v[l][1])*(v[m][0] - v[m][1]);

		used += snprintf(text + used, sizeof text - (size_t)used, "%s[%d, %d, %d, %d, %.17g]",
		                 e ? ", " : "", j, k, l, m, value);
	}
	snprintf(text + used, sizeof text - (size_t)used, "]}");
#define PHYSICAL(damping, force) "{\"n\": 2, \"M\": [[2, 0.5], [0.5, 1]], \"K\": [[6, -1], [-1, " \
	"2]], " damping \
	"\"C\": [[0, 0, 0, 0, 0.5], [0, 0, 0, 1, -1.5], [0, 0, 1, 1, 1.5], [0, 1, 1, 1, -0.5], " \
	"[1, 0, 0, 0, -0.5], [1, 0, 0, 1, 1.5], [1, 0, 1, 1, -1.5], [1, 1, 1, 1, 0.7]]" force "}"
	same_events(PHYSICAL("\"D\": [[0.18, -0.03], [-0.03, 0.06]], ",
	                     ", \"harmonics\": [{\"k\": 1, \"f\": [0.3, 0.1]}]"), text, 0.8, 2.5, 2,
	            "a mass matrix and modal coordinates");
	if (!open_text(&rom, PHYSICAL("", "")))
		return;
	ok(!hawser_integrate(&run, &rom, &(struct hawser_integrate_options){.until = 50.0, .every = 50.0,
	                     .rtol = 1e-11, .initial = u}, &report), "undamped %s", report.message);
	for (int i = 0; i < 2; i++) {
		const double *x = i ? run.state + 4*(size_t)(run.rows - 1) : u;

		energy[i] = 0.5*(M[0]*x[2]*x[2] + 2.0*M[1]*x[2]*x[3] + M[3]*x[3]*x[3] + K[0]*x[0]*x[0] +
		                 2.0*K[1]*x[0]*x[1] + K[3]*x[1]*x[1]) + 0.05*pow(x[1], 4) +
		            0.125*pow(x[0] - x[1], 4);
		close_to(hawser_rom_energy(&rom, x, x + 2), energy[i], 1e-13, "the energy");
	}
	close_to(energy[1], energy[0], 1e-9, "is conserved");
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

#define DUFFING(parameter, C, f) "{\"n\": 1, " parameter "\"K\": [[1]], \"D\": [[0.05]], " C \
	", \"harmonics\": [" f "]}"

static void check_first(void)
{
	double u[4] = {0.3, -0.1, 0.0, 0.0}, *x, *y;
	struct hawser_integrate_options options = {.omega = 1.1, .until = 7.0, .every = 7.0, .rtol = 1e-11,
		.initial = u};
	struct hawser_trajectory first = {0}, second = {0};
	struct hawser_rom rom[2];
	const char *one = "{\"n\": 2, \"first_order\": true, \"K\": [[0, -1], [1, 0.05]], "
		"\"C\": [[1, 0, 0, 0, 0.1]], \"harmonics\": [{\"k\": 1, \"f\": [0, 0.18], "
		"\"Q\": [[1, 0, 0, 0.02]]}, {\"k\": 2, \"phase\": \"sin\", \"K\": [[0, 0], [0.03, 0]]}]}";
	const char *two = DUFFING("", "\"C\": [[0, 0, 0, 0, 0.1]]",
		"{\"k\": 1, \"f\": [0.18], \"Q\": [[0, 0, 0, 0.02]]}, "
		"{\"k\": 2, \"phase\": \"sin\", \"K\": [[0.03]]}");

	same_events(one, two, 0.7, 2.0, 2, "first order and second");
	if (!open_text(&rom[0], one) || !open_text(&rom[1], two))
		return;
	ok(!hawser_integrate(&first, &rom[0], &options, &report) &&
	   !hawser_integrate(&second, &rom[1], &options, &report), "integrated %s", report.message);
	x = first.state + 4*(size_t)(first.rows - 1);
	y = second.state + 2*(size_t)(second.rows - 1);
	ok(fabs(x[0] - y[0]) + fabs(x[1] - y[1]) < 1e-9,
	   "from a state whose velocities are not given: %.1e",
	   fabs(x[0] - y[0]) + fabs(x[1] - y[1]));
	for (int i = 0; i < 2; i++)
		hawser_rom_clear(&rom[i]);
	hawser_trajectory_clear(&first);
	hawser_trajectory_clear(&second);
}

static int sole_quad(struct hawser_rom *rom)
{
	struct hawser_quad *Q = malloc(sizeof *Q);

	if (Q)
		*Q = (struct hawser_quad){0, 0, 0, 1.0};
	rom->harmonic[0].quads = Q != NULL;
	rom->harmonic[0].Q = Q;
	return Q != NULL;
}

/* What a program can give and a file can't. */
static void check_refusals(void)
{
	struct hawser_rom rom;

	if (!open_text(&rom, DUFFING("", "\"terms\": [[0, [0, 0, 0], [], 0.1]]",
	                             "{\"k\": 1, \"f\": [0.18], \"omega_power\": 1}")))
		return;
	rom.term[0].factor[1] = 1;
	ok(hawser_rom_compile(&rom, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "terms: entry 0 of equation 0 has 3 factors"), "%s", report.message);
	rom.term[0].factor[1] = 0;
	ok(sole_quad(&rom) && hawser_rom_compile(&rom, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "harmonic 0: a Q with omega_power 1; it must be 0"), "%s",
		report.message);
	hawser_rom_clear(&rom);
}

/* A chain of n oscillators with cubic springs, driven at its end below its band. */
static int open_chain(struct hawser_rom *rom, int n)
{
	size_t m = (size_t)n;

	*rom = (struct hawser_rom){.n = n, .length = 1.0, .time = 1.0, .force = 1.0, .harmonics = 1,
		.K = calloc(m*m, sizeof(double)), .D = calloc(m*m, sizeof(double)),
		.C = calloc(9*m, sizeof *rom->C), .harmonic = calloc(1, sizeof *rom->harmonic)};
	if (!rom->K || !rom->D || !rom->C || !rom->harmonic)
		return 0;
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = calloc(m, sizeof(double))};
	if (!rom->harmonic[0].f)
		return 0;
	rom->harmonic[0].f[0] = 0.05;
	for (int i = 0; i < n; i++) {
		rom->C[rom->cubics++] = (struct hawser_cubic){i, i, i, i, 0.3};
		for (int j = i > 0 ? i - 1 : i; j <= i + 1 && j < n; j++)
			rom->K[i*n + j] = j == i ? 2.0 - 0.5*(i == 0 || i == n - 1) : -0.5;
		rom->D[i*n + i] = 0.03;
		for (int j = i - 1; j <= i + 1; j += 2) { /* 0.2 (x_i - x_j)^3 */
			if (j < 0 || j >= n)
				continue;
			rom->C[rom->cubics++] = (struct hawser_cubic){i, i, i, i, 0.2};
			rom->C[rom->cubics++] = (struct hawser_cubic){i, i, i, j, -0.6};
			rom->C[rom->cubics++] = (struct hawser_cubic){i, i, j, j, 0.6};
			rom->C[rom->cubics++] = (struct hawser_cubic){i, j, j, j, -0.2};
		}
	}
	return !hawser_rom_compile(rom, &report);
}

/* The motion does not reach the far end: a long chain is a short one. Of the long one the zeros of the
 * derivative are used, and the multipliers agree with the damping. */
static void check_chain(void)
{
	static const int size[] = {30, 101};
	struct hawser_rom rom[2] = {{0}};
	struct hawser_frf frf[2] = {{0}};
	double worst = 0.0;

	for (int i = 0; i < 2; i++) {
		struct hawser_frf_options options = {.from = 0.9, .to = 0.95, .max_points = 1,
			.skip_events = 1, .method = "shooting"};

		ok(open_chain(&rom[i], size[i]), "a chain of %d", size[i]);
		if (!ok(!hawser_frf_trace(&frf[i], &rom[i], &options, &report), "its motion %s",
		        report.message))
			goto done;
	}
	for (int j = 0; j < 10; j++)
		worst = fmax(worst, fabs(frf[0].coordinate[j] - frf[1].coordinate[j]));
	ok(worst < 1e-9 && frf[1].coordinate[0] > 0.1, "of any length, the same: %.1e of %g", worst,
	   frf[1].coordinate[0]);
	ok(frf[1].point[0].liouville < 1e-6, "multipliers and damping: %.1e", frf[1].point[0].liouville);
done:
	for (int i = 0; i < 2; i++) {
		hawser_frf_clear(&frf[i]);
		hawser_rom_clear(&rom[i]);
	}
}

/* cos(Omega t) and cos(3/2 Omega t), against cos(2 W t) and cos(3 W t) with W = Omega/2. */
static void check_periods(void)
{
	const char *half = DUFFING("\"periods\": 2, ", "\"C\": [[0, 0, 0, 0, 0.1]]",
	                           "{\"k\": 2, \"f\": [0.18]}, {\"k\": 3, \"f\": [0.1]}");
	const char *plain = DUFFING("", "\"C\": [[0, 0, 0, 0, 0.1]]",
	                            "{\"k\": 2, \"f\": [0.18]}, {\"k\": 3, \"f\": [0.1]}");
	double u[2] = {0.2, -0.1}, worst = 0.0, *x, *y;
	struct hawser_trajectory run[2] = {{0}};
	struct hawser_sweep sweep[2] = {{0}};
	struct hawser_rom_family family;
	struct hawser_frf over;
	struct hawser_rom rom[2] = {{0}};
	struct hawser_frf frf[2] = {{0}};

	if (!respond(&frf[0], &rom[0], half, 0.9, 1.7) || !respond(&frf[1], &rom[1], plain, 0.45, 0.85))
		return;
	for (int e = 0; e < frf[0].events && e < frf[1].events; e++)
		worst = fmax(worst, fabs(frf[0].event[e].omega/2.0/frf[1].event[e].omega - 1.0));
	ok(frf[0].events == frf[1].events && frf[0].events >= 2 && worst < 1e-12 && frf[0].period == 2,
	   "%d events at twice the frequency to %.1e, of %d periods", frf[0].events, worst, frf[0].period);
	for (int i = 0; i < 2; i++) {
		double omega = i ? 0.55 : 1.1;

		ok(!hawser_integrate(&run[i], &rom[i], &(struct hawser_integrate_options){.omega = omega,
		                     .until = 20.0, .every = 20.0, .rtol = 1e-11, .initial = u}, &report) &&
		   !hawser_sweep_run(&sweep[i], &rom[i], &(struct hawser_sweep_options){.from = 0.8*omega,
		                     .to = 0.9*omega, .count = 2}, &report), "integrated");
	}
	x = run[0].state + 2*(size_t)(run[0].rows - 1);
	y = run[1].state + 2*(size_t)(run[1].rows - 1);
	ok(fabs(x[0] - y[0]) + fabs(x[1] - y[1]) < 1e-12 &&
	   fabs(sweep[0].coordinate[1] - sweep[1].coordinate[1]) < 1e-12 &&
	   fabs(sweep[0].omega[1] - 2.0*sweep[1].omega[1]) < 1e-12, "the same motion in time, and swept");
	ok(!hawser_factor_open(&family, &rom[0], HAWSER_FACTOR_LOAD, 1.2, &report) &&
	   !hawser_frf_trace(&over, &rom[0], &(struct hawser_frf_options){.from = 0.2, .to = 1.0,
	                     .family = &family}, &report), "over the load");
	hawser_factor_close(&family);
	hawser_frf_clear(&frf[1]);
	ok(!hawser_frf_trace(&frf[1], &rom[1], &(struct hawser_frf_options){.from = 0.6, .to = 0.7,
	                     .max_points = 1, .start = over.state + 2*((size_t)over.points - 1)}, &report),
	   "there too");
	close_to(over.coordinate[over.points - 1], frf[1].coordinate[0], 1e-7, "the amplitude at its end");
	hawser_frf_clear(&over);
	for (int i = 0; i < 2; i++) {
		hawser_trajectory_clear(&run[i]);
		hawser_sweep_clear(&sweep[i]);
		hawser_frf_clear(&frf[i]);
		hawser_rom_clear(&rom[i]);
	}
}

CASE(property_own)
{
	gsl_set_error_handler_off();
	differentiated("{\"n\": 2, \"M\": [[2, 0.3], [0.1, 1]], \"K\": [[1, 0.2], [0.4, 3]], "
	               "\"Q\": [[0, 0, 1, 1]],"
	               " \"C\": [[1, 0, 1, 1, -2]], \"terms\": [[0, [], [0, 0, 1], 0.3], [1, [0, 1, "
		"1], [1], 2], "
	               "[1, [0, 0, 0, 0, 1], [], -1]], \"harmonics\": [{\"k\": 2, \"omega_power\": 2, "
	               "\"phase\": \"sin\", \"Q\": [[0, 0, 1, 0.7]], \"C\": [[1, 0, 0, 1, 0.4]], "
	               "\"terms\": [[0, [1], [0], 1]], \"D\": [[1, 2], [3, 4]]}]}", 3u);
	differentiated("{\"n\": 3, \"first_order\": true, \"relaxation\": 2.5, \"K\": [[0, -1, 0.3], "
	               "[1, 0.05, 0], "
	               "[0, 0, 1]], \"Q\": [[2, 0, 1, 1], [1, 2, 2, 1]], \"C\": [[1, 0, 0, 1, 0.1]], "
	               "\"terms\": [[2, [0, 0, 1, 1, 2], [], 0.1]], \"harmonics\": [{\"k\": 1, "
		"\"f\": [0, 0.18, 1], "
	               "\"K\": [[0, 1, 0], [0, 0, 0], [2, 0, 1]], \"Q\": [[1, 0, 0, 0.02]], "
		"\"omega_power\": 1}, "
	               "{\"k\": 0, \"f\": [1, 2, 3]}]}", 7u);
	check_refusals();
	check_gsl();
	check_mass();
	check_chain();
	check_first();
	check_periods();
	same_events(DUFFING("", "\"C\": [[0, 0, 0, 0, 0.1]]", "{\"k\": 1, \"f\": [0.18], \"C\": [[0, "
	                    "0, 0, 0, "
	                    "0.02]]}"),
	            DUFFING("", "\"terms\": [[0, [0, 0, 0], [], 0.1]]", "{\"k\": 1, \"f\": [0.18], "
	                    "\"terms\": [[0, [0, 0, 0], [], 0.02]]}"), 0.8, 2.0, 2, "C and terms");
	same_events(DUFFING("\"parameters\": {\"eps\": 0.1, \"twice\": \"2*eps\"}, ",
	                    "\"C\": [[0, 0, 0, 0, \"sqrt(eps^2) + (1 - 1)/3\"]]",
	                    "{\"k\": 1, \"f\": [\"-(-twice) - 0.02*cos(2*pi)\"]}"),
	            DUFFING("", "\"C\": [[0, 0, 0, 0, 0.1]]", "{\"k\": 1, \"f\": [0.18]}"), 0.8, 2.0, 2,
	            "formulas and numbers");
	return done_testing();
}
