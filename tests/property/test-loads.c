/* The list of loads: forces on the modes against an adaptive quadrature; a piece along the whole cable
 * and two halves against the section load; the taut string with a partial load, a force at a point and
 * a wave against closed forms; two multiples of the frequency; the condensed model against full order.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>
#include <hawser/modes.h>
#include <hawser/scene.h>
#include "rom/condense/answer.h"
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static int solve(struct hawser_modes *modes, const struct hawser_scene *scene, int n)
{
	struct hawser_modes_options options = {.n = n};
	struct hawser_statics statics;
	struct hawser_report report = {.message = ""};

	return ok(!hawser_statics_scene(&statics, scene, &report) &&
	          !hawser_modes_solve(modes, &statics, &options, &report), "modes %s", report.message);
}

#define INCLINED "cable: {EA: 2 MN, rho: 8 kg/m}\nspan: {d: 100 m, h: 37 m}\n" \
	"tension: {H: 12 kN}\n"

/* --- forces on the modes --- */

struct density {
	const struct hawser_modes *modes;
	const struct hawser_load_piece *piece;
	int mode;
	double tau, length; /* m */
};

/* Power per length on the mode at the unstretched length S, from the definitions in scene.h. */
static double density(const struct density *of, double S)
{
	double s = S/of->length*of->modes->statics.l, phi[3];
	struct hawser_frame_point at = hawser_statics_frame(&of->modes->statics, s);
	const double *f = of->piece->force[0] != 0.0 ? of->piece->force : of->piece->per_length;
	double angle = of->piece->harmonic*of->tau + of->piece->phase;

	if (of->piece->wave != 0.0)
		angle -= 2.0*M_PI*S/of->piece->wave;
	hawser_modes_at(of->modes, phi, NULL, of->mode, s);
	if (of->piece->frame == HAWSER_FRAME_LOCAL)
		return cos(angle)*(phi[0]*f[0] + phi[1]*f[1] + phi[2]*f[2]);
	return cos(angle)*((phi[0]*at.ex - phi[1]*at.ey)*f[0] + (phi[0]*at.ey + phi[1]*at.ex)*f[1] +
	                   phi[2]*f[2]);
}

/* Adaptive Simpson rule. */
static double simpson(const struct density *of, double a, double b, double fa, double fm, double fb,
                      double tolerance, int depth)
{
	double m = 0.5*(a + b), left = density(of, 0.5*(a + m)), right = density(of, 0.5*(m + b));
	double whole = (b - a)/6.0*(fa + 4.0*fm + fb);
	double parts = (b - a)/12.0*(fa + 4.0*left + 2.0*fm + 4.0*right + fb);

	if (depth == 0 || fabs(parts - whole) < tolerance)
		return parts + (parts - whole)/15.0;
	return simpson(of, a, m, fa, left, fm, 0.5*tolerance, depth - 1) +
	       simpson(of, m, b, fm, right, fb, 0.5*tolerance, depth - 1);
}

static double work(const struct density *of)
{
	const struct hawser_load_piece *p = of->piece;
	double a = p->from_length ? p->from : p->from*of->length;
	double b = p->to_length ? p->to : p->to*of->length, sum = 0.0;

	if (p->force[0] != 0.0)
		return density(of, p->at_length ? p->at : p->at*of->length);
	for (int i = 0; i < 16; i++) {
		double x = a + (b - a)*i/16.0, y = a + (b - a)*(i + 1)/16.0;

		sum += simpson(of, x, y, density(of, x), density(of, 0.5*(x + y)), density(of, y), 1e-11,
		               30);
	}
	return sum;
}

static void check_forces(void)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom;
	double worst = 0.0, most = 0.0;

	if (!is_read(&scene, INCLINED "model: {condense: none}\nloads: [{per_length: [1, 2, -1], "
	          "from: 13.7 %, to: 71 m, harmonic: 2, phase: 1.1}, "
	          "{force: [120, -60, 30], at: 17.3 m, frame: local}, "
	          "{per_length: [0.3, -1, 0.5], wave: 17 m, phase: -0.4, from: 0.1}, "
	          "{per_length: [0, 1, 0], frame: local, wave: -61 m, harmonic: 3, to: 66 %}]\n") ||
	    !solve(&modes, &scene, 7) || !ok(!hawser_rom_build_linear(&rom, &modes, &scene, NULL), "model"))
		return;
	ok(rom.harmonics == 6, "harmonics: %d", rom.harmonics);
	for (int j = 0; j < modes.n; j++)
		for (double tau = 0.3; tau < 6.0; tau += 1.7) {
			double want = 0.0, got = 0.0;

			for (int i = 0; i < scene.loads; i++)
				want += work(&(struct density){&modes, &scene.piece[i], j, tau,
				                               modes.statics.length0});
			for (int h = 0; h < rom.harmonics; h++)
				got += rom.harmonic[h].f[j]*(rom.harmonic[h].phase == HAWSER_COS
				                             ? cos(rom.harmonic[h].k*tau)
				                             : sin(rom.harmonic[h].k*tau));
			worst = fmax(worst, fabs(got*rom.force - want));
			most = fmax(most, fabs(want));
		}
	ok(worst < 1e-10*most, "forces on modes against an adaptive rule: %.1e", worst/most);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* Written and read again, the list is the same. */
static void check_written(void)
{
	struct hawser_scene scene, back;
	char *text = NULL;
	size_t size;
	FILE *stream = open_memstream(&text, &size);

	if (!is_read(&scene, INCLINED "loads: [{per_length: [1, 2, -1], from: 13.7 %, to: 71 m, "
	             "harmonic: 2, phase: 1.1, wave: -3}, "
	             "{force: [120, -60, 30], at: 17.3 m, frame: local, name: a}]\n"))
		return;
	ok(!hawser_scene_write(&scene, stream, NULL), "written");
	fclose(stream);
	if (is_read(&back, text))
		ok(back.loads == 2 && !memcmp(back.piece, scene.piece, 2*sizeof *scene.piece),
		   "the same loads");
	free(text);
	hawser_scene_clear(&back);
	hawser_scene_clear(&scene);
}

/* --- the same load in other words --- */

static double apart(const double *a, const double *b, size_t count)
{
	double worst = 0.0, most = 0.0;

	if (!a || !b)
		return a == b ? 0.0 : INFINITY;
	for (size_t i = 0; i < count; i++) {
		worst = fmax(worst, fabs(a[i] - b[i]));
		most = fmax(most, fabs(b[i]));
	}
	return most > 0.0 ? worst/most : worst;
}

/* Forces and stiffness; of the answers, with `shown`, whose integrals along undivided and divided
 * elements differ by the error of the elements. */
static double unlike(const struct hawser_rom *a, const struct hawser_rom *b, int shown)
{
	const struct hawser_harmonic *x = a->harmonic, *y = b->harmonic;
	size_t n = (size_t)a->n, points = (size_t)a->shapes.points;

	if (a->n != b->n || a->harmonics != b->harmonics || a->cubics != b->cubics)
		return INFINITY;
	if (!shown)
		return fmax(apart(x->f, y->f, n), apart(x->K, y->K, n*n));
	return fmax(apart(x->answer, y->answer, 8*points),
	            apart(x->answer_line, y->answer_line, 2*(size_t)a->line.points));
}

static void check_same(void)
{
	static const char *const text[] = {
		INCLINED "load: {frame: global, per_length: [0.4, 1, 0.7]}\n",
		INCLINED "loads: [{per_length: [0.4, 1, 0.7]}]\n",
		INCLINED "loads: [{per_length: [0.4, 1, 0.7], to: 0.5}, "
			"{per_length: [0.4, 1, 0.7], from: 0.5}]\n",
		INCLINED "load: {frame: global, per_length: [0.4, 0, 0.7], extent: [0, 0.37]}\n"
			"loads: [{per_length: [0.4, 0, 0.7], from: 0.37, to: 1}, {per_length: [0, 1, 0]}]\n"};
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom[4];

	for (int i = 0; i < 4; i++) {
		if (!is_read(&scene, text[i]) || !solve(&modes, &scene, 5) ||
		    !ok(!hawser_rom_build(&rom[i], &modes, &scene, NULL), "model"))
			return;
		hawser_modes_clear(&modes);
		hawser_scene_clear(&scene);
	}
	ok(unlike(&rom[1], &rom[0], 0) == 0.0 && unlike(&rom[1], &rom[0], 1) == 0.0,
	   "a piece of the whole length");
	for (int i = 2; i < 4; i++)
		ok(unlike(&rom[i], &rom[0], 0) < 1e-13 && unlike(&rom[i], &rom[0], 1) < 1e-7,
		   "%s: %.1e, %.1e", i == 2 ? "two halves" : "with the section", unlike(&rom[i], &rom[0], 0),
		   unlike(&rom[i], &rom[0], 1));
	for (int i = 0; i < 4; i++)
		hawser_rom_clear(&rom[i]);
}

/* --- a taut string --- */

#define TAUT "g: 1e-6\ncable: {EA: 40 MN, rho: 16 kg/m}\nspan: {d: 100 m, h: 0 m}\n" \
	"tension: {H: 1 MN}\n"

struct string {
	double T, L, k; /* tension over stretch, N; unstretched length, m; wave number, 1/m */
};

/* Displacement at S by a unit load per length on [a, b] in phase: the integral of the response to a
 * force. */
static double spread(const struct string *x, double S, double a, double b)
{
	double below = fmin(fmax(S, a), b), k = x->k, sum = 0.0;

	if (below > a) /* points nearer to A than S */
		sum += sin(k*(x->L - S))*(cos(k*a) - cos(k*below))/k;
	if (b > below)
		sum += sin(k*S)*(cos(k*(x->L - b)) - cos(k*(x->L - below)))/k;
	return sum/(x->T*k*sin(k*x->L));
}

static double point(const struct string *x, double S, double at)
{
	return sin(x->k*fmin(S, at))*sin(x->k*(x->L - fmax(S, at)))/(x->T*x->k*sin(x->k*x->L));
}

/* Complex amplitude by the unit load exp(-i kappa S). */
static double complex running(const struct string *x, double S, double kappa)
{
	double complex particular = -1.0/(x->T*(x->k*x->k - kappa*kappa)), end = cexp(-I*kappa*x->L);

	return particular*(cexp(-I*kappa*S) - cos(x->k*S) -
	                   (end - cos(x->k*x->L))*sin(x->k*S)/sin(x->k*x->L));
}

/* Displacement along z at a probe by the linear model. */
static double swing(const struct hawser_rom *rom, int p, double tau, double omega)
{
	struct hawser_rom_moment moment = {.tau = tau, .omega = omega};
	double u[64] = {0.0}, xyz[3];

	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *of = &rom->harmonic[h];
		double W = of->k*omega, wave = of->phase == HAWSER_COS ? cos(of->k*tau) : sin(of->k*tau);

		for (int j = 0; j < rom->n; j++)
			u[j] += wave*of->f[j]/(rom->K[j*(rom->n + 1)] - W*W);
	}
	hawser_rom_displacement_at(rom, xyz, p, u, &moment);
	return xyz[2]*rom->length;
}

/* Relative error with n modes, half of them along z. */
static double string_error(const struct hawser_scene *scene, int kind, int n)
{
	const double part[3] = {0.25, 0.5, 0.75}, tau = 0.7, T = 1e6, EA = 4e7;
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct string x = {.T = T/(1.0 + T/EA), .L = 100.0/(1.0 + T/EA)};
	double omega, worst = 0.0, most = 0.0;

	if (!solve(&modes, scene, n) ||
	    !ok(!hawser_rom_build_linear(&rom, &modes, scene, NULL) &&
	        !hawser__rom_answers(&rom, &modes, modes.n, scene, NULL), "model"))
		return NAN;
	omega = 1.37*sqrt(rom.K[0]);
	x.k = omega/rom.time*sqrt(16.0/x.T);
	for (int p = 0; p < 3; p++) {
		double S = part[p]*x.L, want, got = swing(&rom, p, tau, omega);

		want = kind == 0 ? cos(tau)*2.0*spread(&x, S, 0.137*x.L, 0.42*x.L)
		       : kind == 1 ? cos(tau)*300.0*point(&x, S, 31.0)
		       : creal(cexp(I*(tau + 0.5))*2.0*running(&x, S, 2.0*M_PI/23.0));
		worst = fmax(worst, fabs(got - want));
		most = fmax(most, fabs(want));
	}
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	return worst/most;
}

/* What the response of the modes left out lacks is of sixth order in 1/n for each, fifth in sum. */
static void check_string(const char *loads, int kind)
{
	struct hawser_scene scene;
	double few, many;
	char text[512];

	snprintf(text, sizeof text, "%s%s", TAUT, loads);
	if (!is_read(&scene, text))
		return;
	few = string_error(&scene, kind, 16);
	many = string_error(&scene, kind, 32);
	ok(few < 3e-4 && many < 3e-6 && many < few/20.0, "%.50s: %.1e, %.1e", loads, few, many);
	hawser_scene_clear(&scene);
}

/* --- several harmonics --- */

/* A small motion that begins on the sum of the responses to both harmonics stays there. */
static void check_superposition(void)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct hawser_trajectory run;
	double start[8] = {0.0}, end[8] = {0.0}, omega, until, worst = 0.0, most = 0.0;

	if (!is_read(&scene, INCLINED "model: {inertia: none}\nloads: [{per_length: [0, 1e-4, 2e-4]}, "
	          "{force: [0, 0.01, 0.01], at: 0.3, harmonic: 2, phase: 0.8}]\n") ||
	    !solve(&modes, &scene, 4) || !ok(!hawser_rom_build(&rom, &modes, &scene, NULL), "model"))
		return;
	omega = 0.8*sqrt(rom.K[0]);
	until = 20.3;
	for (int h = 0; h < rom.harmonics; h++)
		for (int j = 0; j < rom.n; j++) {
			const struct hawser_harmonic *of = &rom.harmonic[h];
			double W = of->k*omega, a = of->f[j]/(rom.K[j*(rom.n + 1)] - W*W);
			int c = of->phase == HAWSER_COS;

			start[j] += c ? a : 0.0;
			start[rom.n + j] += c ? 0.0 : a*W;
			end[j] += a*(c ? cos(W*until) : sin(W*until));
		}
	if (!ok(!hawser_integrate(&run, &rom, &(struct hawser_integrate_options){.omega = omega,
	        .until = until, .every = until, .rtol = 1e-10, .atol = 1e-14, .initial = start}, NULL),
	        "a run"))
		return;
	for (int j = 0; j < rom.n; j++) {
		worst = fmax(worst, fabs(run.state[(run.rows - 1)*2*rom.n + j] - end[j]));
		most = fmax(most, fabs(end[j]));
	}
	ok(worst < 1e-4*most, "the sum of the responses at Omega and 2 Omega: %.1e", worst/most);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* --- a sagging span --- */

/* Relative distance of the displacements from full order with so many functions. */
static double from_full(const struct hawser_scene *scene, int functions)
{
	struct hawser_modes modes;
	struct hawser_rom rom, full;
	struct hawser_frf a, b;
	struct hawser_frf_options options = {.samples = HAWSER_NONE, .tolerance = 1e-6};
	double most = 0.0, worst = 0.0;

	if (!solve(&modes, scene, 6) ||
	    !ok(!hawser_rom_build(&rom, &modes, scene, NULL) &&
	        !hawser_rom_build_full(&full, &modes.statics, scene, functions, NULL), "models"))
		return NAN;
	options.from = 0.605*sqrt(rom.K[0]);
	options.to = 0.6*sqrt(rom.K[0]);
	if (!ok(!hawser_frf_trace(&a, &rom, &options, NULL) &&
	        !hawser_frf_trace(&b, &full, &options, NULL), "responses"))
		return NAN;
	for (int p = 0; p < 9; p++) {
		const double *x = a.probe + (size_t)(a.points - 1)*9, *y = b.probe + (size_t)(b.points - 1)*9;

		most = fmax(most, fabs(y[p]));
		worst = fmax(worst, fabs(x[p] - y[p]));
	}
	hawser_frf_clear(&a);
	hawser_frf_clear(&b);
	hawser_rom_clear(&rom);
	hawser_rom_clear(&full);
	hawser_modes_clear(&modes);
	return worst/most;
}

#define SAGGING "cable: {EA: 20 MN, rho: 8 kg/m}\nspan: {d: 100 m, h: -20 m}\ntension: {sag: 6 m}\n" \
	"damping: {ratio: 0.02}\n"

static void check_full(void)
{
	struct hawser_scene scene;
	double off, finer;

	if (!is_read(&scene, SAGGING "loads: [{per_length: [0, 2, 8], wave: 90 m}, "
	          "{per_length: [0, 0.5, 0.5], harmonic: 2, phase: 1}]\n"))
		return;
	off = from_full(&scene, getenv("HAWSER_LONG") ? 10 : 7);
	ok(off < 3e-3, "displacements against full order: %.1e", off);
	hawser_scene_clear(&scene);
	if (!getenv("HAWSER_LONG"))
		return;
	/* full order has no kink at a force: its error falls as the square of the number of functions */
	if (!is_read(&scene, SAGGING "loads: [{per_length: [0, 0.2, 0.6], from: 20 %, to: 60 %}, "
	          "{force: [0, 3, 5], at: 30 %, harmonic: 2, phase: 1}]\n"))
		return;
	off = from_full(&scene, 8);
	finer = from_full(&scene, 20);
	ok(finer < 4e-3 && finer < off/2.5, "with kinks: %.1e, %.1e", off, finer);
	hawser_scene_clear(&scene);
}

CASE(property_loads)
{
	check_forces();
	check_written();
	check_same();
	check_string("loads: [{per_length: [0, 0, 2], from: 13.7 %, to: 0.42}]", 0);
	check_string("loads: [{force: [0, 0, 300], at: 31 m}]", 1);
	check_string("loads: [{per_length: [0, 0, 2], wave: 23 m, phase: 0.5}]", 2);
	check_superposition();
	check_full();
	return done_testing();
}
