/* Responses of a string with an absorber in its middle, across its plane, against routes of their own:
 * the closed form of the string, Den Hartog's equal peaks, the antiresonance, the decay of damped
 * modes, and a nonlinear energy sink against the string's sine modes integrated here.
 *
 *    c    w/v, where the string has the waves sin(w x/c); Z the force of the absorber over the
 *         displacement of its point, w^2 m (k + i w b)/(k + i w b - m w^2)
 *    mu   m phi^2/(phi's modal mass) = 2 m/(rho L): the ratio of masses in Den Hartog's formulas
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/damped.h>
#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "tests/tap.h"

static struct hawser_report report;

/* A taut string of 10 m, so light against its tension that it does not sag; mass and load per length of
 * the stretched string. */
#define STRETCH (1.0 + 9e4/1e7)
static const double L = 10.0, rho = 4.0, T = 9e4, load = 0.02;

static struct hawser_scene scene_of(double m, double k, double b, double k3)
{
	return (struct hawser_scene){
		.model = {.modes = 1}, /* a number; build() has it */
		.g = 1e-3, .cable = {.EA = 1e7, .rho = rho*STRETCH}, .span = {.d = L},
		.tension = {.given = HAWSER_GIVEN_H, .value = T, .branch = HAWSER_BRANCH_TAUT},
		.load = {.present = 1, .frame = HAWSER_FRAME_GLOBAL, .per_length = {0.0, 0.0, load*STRETCH},
		         .extent = {0.0, 1.0}},
		.attachments = 1,
		.attach = {{.at = 0.5, .absorber_mass = m, .absorber_stiffness = k, .absorber_damping = b,
		            .absorber_cubic = k3, .absorber_direction = {0.0, 0.0, 1.0}}},
	};
}

/* The model of `n` modes. */
static int build(struct hawser_rom *rom, const struct hawser_scene *scene, int n)
{
	const struct hawser_modes_options options = {.n = n};
	struct hawser_modes modes = {.n = 0};
	struct hawser_statics st;
	int done = !hawser_statics_scene(&st, scene, &report) &&
	           !hawser_modes_solve(&modes, &st, &options, &report) &&
	           !hawser_rom_build(rom, &modes, scene, &report);

	hawser_modes_clear(&modes);
	return ok(done, "a model of %d modes %s", n, report.message);
}

static double first_of(void)
{
	return M_PI/L*sqrt(T/rho);
}

/* --- linear --- */

/* Displacement of the middle of a string with viscous damping alpha per length. */
static double complex middle(const struct hawser_attachment *a, double alpha, double w)
{
	double complex stiff = a->absorber_stiffness + I*w*a->absorber_damping;
	double complex Z = w*w*a->absorber_mass*stiff/(stiff - a->absorber_mass*w*w);
	double complex inertia = rho*w*w - I*w*alpha, beta = csqrt(inertia/T), S, C, at, A;

	S = csin(0.5*beta*L);
	C = ccos(0.5*beta*L);
	at = -load/inertia;
	A = at*(Z*(1.0 - C) - 2.0*T*beta*S)/(2.0*T*beta*C - Z*S);
	return at*(1.0 - C) + A*S;
}

static int mid_of(const struct hawser_rom *rom)
{
	for (int p = 0; p < rom->shapes.points; p++)
		if (!strcmp(rom->shapes.name[p], "mid"))
			return p;
	return 0;
}

/* The response over `from` to `to` times the first frequency; 1 if it was found. */
static int trace(struct hawser_frf *frf, const struct hawser_rom *rom, double from, double to)
{
	const struct hawser_frf_options options = {.from = from*first_of()*rom->time,
	                                           .to = to*first_of()*rom->time, .skip_events = 1,
	                                           .samples = HAWSER_NONE};

	return ok(!hawser_frf_trace(frf, rom, &options, &report), "response %s", report.message);
}

static double z_of(const struct hawser_frf *frf, const struct hawser_rom *rom, int point)
{
	return rom->length*frf->probe[((size_t)point*(size_t)frf->probes + (size_t)mid_of(rom))*3 + 2];
}

/* With n modes, to `tolerance` of the closed form. */
static void equal_peaks(double mu, int n, double tolerance)
{
	double w1 = first_of(), m = 0.5*mu*rho*L, own = w1/(1.0 + mu);
	double ratio = sqrt(3.0*mu/(8.0*pow(1.0 + mu, 3.0))), mean;
	const struct hawser_scene scene = scene_of(m, m*own*own, 2.0*ratio*m*w1, 0.0);
	/* of the first mode: 4 load/(pi rho w1^2); times Den Hartog's height */
	double height = 4.0*load/(M_PI*rho*w1*w1)*sqrt(1.0 + 2.0/mu), worst = 0.0, peak[3] = {0.0};
	struct hawser_rom rom;
	struct hawser_frf frf;
	int peaks = 0;

	if (!build(&rom, &scene, n) || !trace(&frf, &rom, 0.85, 1.15))
		return;
	for (int p = 0; p < frf.points; p++) {
		double z = z_of(&frf, &rom, p);

		worst = fmax(worst, fabs(z/cabs(middle(&scene.attach[0], 0.0,
		                                       frf.point[p].omega/rom.time)) - 1.0));
		if (p > 0 && p + 1 < frf.points && z > z_of(&frf, &rom, p - 1) &&
		    z > z_of(&frf, &rom, p + 1) && peaks < 3)
			peak[peaks++] = z;
	}
	ok(worst < tolerance, "mu = %g: %d points of the closed form of the string to %.1e", mu, frf.points,
	   worst);
	/* The absorber's point yields by other modes too, which detunes it by the order mu. The peaks lie
	 * sqrt(mu) apart, so that they differ by the order sqrt(mu), and their mean by mu. */
	mean = 0.5*(peak[0] + peak[1]);
	ok(peaks == 2 && fabs(peak[0]/peak[1] - 1.0) < 0.25*sqrt(mu) && fabs(mean/height - 1.0) < 0.2*mu,
	   "two peaks of %.5g and %.5g, mean %.5g, by Den Hartog %.5g", peak[0], peak[1], mean, height);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* The point of an undamped absorber is at rest at its own frequency. */
static void antiresonance(void)
{
	double w1 = first_of(), m = 1.3, own = 0.83*w1;
	struct hawser_scene scene = scene_of(m, m*own*own, 0.0, 0.0);
	struct hawser_rom rom;
	struct hawser_frf frf;
	double stroke, at;

	scene.damping.kind = HAWSER_DAMPING_ALPHA;
	scene.damping.alpha = 0.3*STRETCH;
	if (!build(&rom, &scene, 8) || !trace(&frf, &rom, 0.83, 0.86))
		return;
	at = z_of(&frf, &rom, 0);
	close_to(z_of(&frf, &rom, frf.points - 1), cabs(middle(&scene.attach[0], 0.3, 0.86*w1)), 1e-5,
	         "beyond the antiresonance");
	ok(at < 2e-5*z_of(&frf, &rom, frf.points - 1), "at the absorber's frequency its point is at "
	   "rest: %.1e m", at);
	/* its spring holds what the ends do not: k s = 2 T times the slope of the string at the middle */
	stroke = rom.length*frf.probe[(size_t)(frf.probes - 1)*3 + 2];
	{
		double complex inertia = rho*own*own - I*own*0.3, beta = csqrt(inertia/T);
		double complex by = 2.0*T*beta*load/inertia*(1.0 - ccos(0.5*beta*L))/csin(0.5*beta*L);

		close_to(stroke, cabs(by)/scene.attach[0].absorber_stiffness, 1e-4, "the stroke there");
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* --- decay --- */

/* Successive maxima of u_j by parabolas: *rate and *omega of the decay over the last `count`. */
static int decrement(double *rate, double *omega, const struct hawser_trajectory *run, int n, int j,
                     int count)
{
	double t[400], y[400];
	int found = 0;

	for (int i = 1; i + 1 < run->rows && found < 400; i++) {
		double a = run->state[(size_t)(i - 1)*2*(size_t)n + (size_t)j];
		double b = run->state[(size_t)i*2*(size_t)n + (size_t)j];
		double c = run->state[(size_t)(i + 1)*2*(size_t)n + (size_t)j], d = a - 2.0*b + c;

		if (b <= a || b < c || b <= 0.0)
			continue;
		t[found] = run->time[i] + 0.5*(a - c)/d*(run->time[1] - run->time[0]);
		y[found++] = b - 0.125*(a - c)*(a - c)/d;
	}
	if (found <= count)
		return 0;
	*omega = 2.0*M_PI*count/(t[found - 1] - t[found - 1 - count]);
	*rate = log(y[found - 1]/y[found - 1 - count])/(t[found - 1] - t[found - 1 - count]);
	return 1;
}

static void decay(void)
{
	double w1 = first_of(), m = 1.0, own = 0.6*w1, rate = 0.0, omega = 0.0;
	struct hawser_scene scene = scene_of(m, m*own*own, 2.0*0.35*m*own, 0.0);
	const struct hawser_damped_options sought = {.n = 8};
	struct hawser_integrate_options options = {0};
	struct hawser_trajectory run = {0};
	struct hawser_damped exact;
	struct hawser_statics st;
	struct hawser_rom rom;
	double initial[100] = {0.0}, least = -INFINITY, by = 0.0;

	scene.load.present = 0;
	if (!build(&rom, &scene, 10) ||
	    !ok(!hawser_statics_scene(&st, &scene, &report) &&
	        !hawser_damped_solve(&exact, &st, &scene, &sought, &report), "damped modes %s",
	        report.message))
		return;
	for (int i = 0; i < exact.n; i++)
		if (exact.mode[i].plane == HAWSER_OUT_OF_PLANE && exact.mode[i].re > least &&
		    fabs(exact.mode[i].omega/rom.time/w1 - 1.0) < 0.3) {
			least = exact.mode[i].re;
			by = exact.mode[i].omega;
		}
	for (int j = 0; j < rom.n && j < 4; j++)
		if (strstr(rom.label[j], "out"))
			initial[j] = 1e-6;
	options.initial = initial;
	options.until = 40.0*2.0*M_PI/by;
	options.every = options.until/4000.0;
	if (ok(!hawser_integrate(&run, &rom, &options, &report), "decay %s", report.message)) {
		int j = 0;

		while (j + 1 < rom.n && initial[j] == 0.0)
			j++;
		ok(decrement(&rate, &omega, &run, rom.n, j, 12), "it oscillates");
		close_to(rate, least, 1e-3, "rate of the decay, that of the damped mode");
		close_to(omega, by, 1e-5, "and its frequency");
	}
	hawser_trajectory_clear(&run);
	hawser_damped_clear(&exact);
	hawser_rom_clear(&rom);
}

/* --- a nonlinear energy sink: the sines of the string and the sink, by Runge and Kutta --- */

enum { SINES = 24, STATE = 2*(SINES + 1) };

static int sines; /* their number */

static void slopes(double *d, const double *y, const struct hawser_attachment *a, double alpha,
                   double w, double t)
{
	double pull, here = 0.0, moved = y[sines], fast = y[2*sines + 1], v = 0.0, s;

	for (int i = 0; i < sines; i++) {
		here += (i%2 ? -1.0 : 1.0)*y[i];
		v += (i%2 ? -1.0 : 1.0)*y[sines + 1 + i];
	}
	s = moved - here;
	pull = a->absorber_stiffness*s + a->absorber_cubic*s*s*s + a->absorber_damping*(fast - v);
	for (int i = 0; i < sines; i++) { /* sin((2i + 1) pi x/L): modal mass rho L/2 */
		double k = (2.0*i + 1.0)*M_PI/L, f = 2.0*load/k*cos(w*t) + (i%2 ? -1.0 : 1.0)*pull;

		d[i] = y[sines + 1 + i];
		d[sines + 1 + i] = 2.0*f/(rho*L) - T*k*k/rho*y[i] - alpha/rho*y[sines + 1 + i];
	}
	d[sines] = fast;
	d[2*sines + 1] = -pull/a->absorber_mass;
}

/* The largest displacement of the middle and stroke over the last period of `periods`. */
static void with_sines(double *z, double *stroke, const struct hawser_attachment *a, double alpha,
                     double w, int periods)
{
	enum { STEPS = 320 };
	const double part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0/6, 1.0/3, 1.0/3, 1.0/6};
	double y[STATE] = {0.0}, h = 2.0*M_PI/w/STEPS;

	*z = *stroke = 0.0;
	for (int i = 0; i < periods*STEPS; i++) {
		double k[4][STATE], x[STATE], here = 0.0;

		for (int r = 0; r < 4; r++) {
			for (int j = 0; j < 2*(sines + 1); j++)
				x[j] = y[j] + (r ? part[r]*h*k[r - 1][j] : 0.0);
			slopes(k[r], x, a, alpha, w, (i + part[r])*h);
		}
		for (int r = 0; r < 4; r++)
			for (int j = 0; j < 2*(sines + 1); j++)
				y[j] += h*weight[r]*k[r][j];
		for (int j = 0; j < sines; j++)
			here += (j%2 ? -1.0 : 1.0)*y[j];
		if (i >= (periods - 1)*STEPS) {
			*z = fmax(*z, fabs(here));
			*stroke = fmax(*stroke, fabs(y[sines] - here));
		}
	}
}

/* The same for all sines: what is left out yields in proportion to 1/sines. */
static void by_sines(double *z, double *stroke, const struct hawser_attachment *a, double alpha,
                     double w, int periods)
{
	double fewer[2];

	sines = SINES/2;
	with_sines(&fewer[0], &fewer[1], a, alpha, w, periods);
	sines = SINES;
	with_sines(z, stroke, a, alpha, w, periods);
	*z += *z - fewer[0];
	*stroke += *stroke - fewer[1];
}

/* Without linear spring, but for one of a hundredth of the frequency. */
static void sink(void)
{
	const double alpha = 4.0, m = 0.9, w1 = first_of(), b = 12.0;
	struct hawser_scene scene = scene_of(m, m*1e-4*w1*w1, b, 7e11);
	struct hawser_integrate_options options = {0};
	struct hawser_frf_options range = {.skip_events = 1, .samples = HAWSER_NONE};
	struct hawser_trajectory run = {0};
	struct hawser_frf frf;
	struct hawser_rom rom;
	double z, stroke, linear, most = 0.0, w = 0.97*w1;
	int rows = 0, mid;

	scene.damping.kind = HAWSER_DAMPING_ALPHA;
	scene.damping.alpha = alpha*STRETCH;
	if (!build(&rom, &scene, 14))
		return;
	mid = mid_of(&rom);
	by_sines(&z, &stroke, &scene.attach[0], alpha, w, 160);
	{
		struct hawser_attachment soft = scene.attach[0];

		soft.absorber_cubic = 0.0;
		linear = cabs(middle(&soft, alpha, w));
	}
	ok(fabs(z/linear - 1.0) > 0.05, "the sink matters: %.4g m, without its cubic spring %.4g m", z,
	   linear);
	options.omega = range.from = w*rom.time;
	range.to = 1.01*range.from;
	options.every = 2.0*M_PI/options.omega/80.0;
	options.until = 160.0*80.0*options.every;
	if (ok(!hawser_integrate(&run, &rom, &options, &report), "from rest %s", report.message)) {
		rows = run.rows;
		for (int i = rows - 81; i < rows; i++) {
			double xyz[3];

			hawser_rom_displacement(&rom, xyz, mid, run.state + (size_t)i*2*(size_t)rom.n);
			most = fmax(most, rom.length*fabs(xyz[2]));
		}
		close_to(most, z, 1e-3, "integrated: the middle");
	}
	if (ok(!hawser_frf_trace(&frf, &rom, &range, &report), "response %s", report.message)) {
		close_to(z_of(&frf, &rom, 0), z, 1e-4, "response: the middle");
		close_to(rom.length*frf.probe[(size_t)(frf.probes - 1)*3 + 2], stroke, 1e-4, "the stroke");
	}
	hawser_frf_clear(&frf);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

CASE(property_absorber_response)
{
	if (getenv("HAWSER_LONG"))
		equal_peaks(0.05, 6, 1e-3);
	equal_peaks(0.01, 6, 1e-3);
	if (getenv("HAWSER_LONG"))
		equal_peaks(0.01, 16, 1e-5);
	antiresonance();
	decay();
	sink();
	return done_testing();
}
