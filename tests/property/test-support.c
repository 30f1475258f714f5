/* Moving supports: the terms of the reduced model against the energy without expansion; closed forms
 * of a taut string; Irvine's stiffness at the end; rigid motion; response against full order.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/linear.h>
#include <hawser/modes.h>
#include <hawser/scene.h>

#include "rom/condense/support.h"
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
	"tension: {H: 12 kN}\nmodel: {condense: none}\n"

#define MOVING "support: {A: {motion: [0.2, -0.1, 0.15], phase: 0.6, harmonic: 2}, " \
	"B: {motion: [0.1, 0.3, -0.2], phase: -1.2}}\n"

/* Force on the model with the amplitudes and the state times t, minus that of the energy without
 * expansion. */
static double gap(const struct hawser_modes *modes, struct hawser_scene scene, double t, double *size)
{
	struct hawser_rom rom, exact;
	double u[8], v[8] = {0.0}, a[8], b[8], worst = 0.0;

	for (int e = 0; e < 2; e++)
		for (int x = 0; x < 3; x++)
			scene.support[e].motion[x] *= t;
	if (hawser_rom_build(&rom, modes, &scene, NULL) ||
	    hawser_rom_build_exact(&exact, modes, &scene, NULL))
		return NAN;
	for (int j = 0; j < rom.n; j++)
		u[j] = t*0.01*cos(1.3*j + 0.4)/(1 + j);
	*size = 0.0;
	for (int i = 0; i < 5; i++) {
		hawser_rom_acceleration(&rom, a, u, v, 1.1*i, 0.7);
		hawser_rom_acceleration(&exact, b, u, v, 1.1*i, 0.7);
		for (int j = 0; j < rom.n; j++) {
			worst = fmax(worst, fabs(a[j] - b[j]));
			*size = fmax(*size, fabs(b[j]));
		}
	}
	hawser_rom_clear(&rom);
	hawser_rom_clear(&exact);
	return worst;
}

/* All terms up to third order agree with the exact energy: the rest is of fourth order. */
static void check_orders(const char *text)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	double size, large, small, smaller;

	if (!is_read(&scene, text) || !solve(&modes, &scene, 6))
		return;
	large = gap(&modes, scene, 0.1, &size);
	small = gap(&modes, scene, 0.05, &size);
	smaller = gap(&modes, scene, 0.025, &size);
	ok(large/small > 14.0 && large/small < 18.0 && small/smaller > 14.0 && small/smaller < 18.0,
	   "the difference from the exact energy is of fourth order: factors %.2f, %.2f",
	   large/small, small/smaller);
	ok(smaller < 1e-3*size, "and small: %.1e of %.1e", smaller, size);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

#define TAUT "g: 1e-6\ncable: {EA: 400 MN, rho: 16 kg/m}\nspan: {d: 100 m, h: 0 m}\n" \
	"tension: {H: 1 MN}\n"

/* The tension of a string varies by EA A/L0: x'' + w^2 (1 + e cos(Omega t)) x = 0, unstable between 2
 * w sqrt(1 -+ e/2) in Omega, up to e^2. */
static void check_tongue(void)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct hawser_linear *linear = NULL;
	const double A = 2e-3, T = 1e6, EA = 4e8, l = 100.0/(1.0 + T/EA);
	double w = M_PI/100.0*sqrt(T*(1.0 + T/EA)/16.0), e = EA*A/l/T, log_modulus[2], argument[2], error;
	double edge[2];

	if (!is_read(&scene, TAUT "support: {B: {motion: [2 mm, 0, 0]}}\n") || !solve(&modes, &scene, 1) ||
	    !ok(!hawser_rom_build_linear(&rom, &modes, &scene, NULL) &&
	        !hawser_linear_open(&linear, 1, NULL), "linear model"))
		return;
	w *= rom.time;
	close_to(sqrt(rom.K[0]), w, 1e-6, "the first frequency of a string");
	for (int side = 0; side < 2; side++) {
		double in = 2.0*w, out = 2.0*w*(side ? 1.02 : 0.98);

		for (int i = 0; i < 40; i++) {
			double middle = 0.5*(in + out);

			if (hawser_linear_multipliers(linear, log_modulus, argument, &error, &rom, middle,
			                              NULL))
				break;
			*(fmax(log_modulus[0], log_modulus[1]) > 1e-8 ? &in : &out) = middle;
		}
		edge[side] = 0.5*(in + out)/(2.0*w);
	}
	/* the transverse stiffness of a stretched string: k = T/l times 1/(1 - stretch) terms: T/EA */
	close_to(edge[1] - edge[0], 0.5*e, 1e-2, "width of the tongue");
	ok(fabs(edge[1] + edge[0] - 2.0) < e*e, "about twice the frequency: %.2e", edge[1] + edge[0] - 2.0);
	hawser_linear_free(linear);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* The period doubling of the response at the edge of that tongue, with damping: Omega = 2 w (1 +
 * sqrt(e^2 - 16 zeta^2)/4) to first order. */
static void check_doubling(void)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options options = {.samples = HAWSER_NONE, .step_max = 0.1};
	const double A = 4e-3, T = 1e6, EA = 4e8, e = EA*A/(100.0/(1.0 + T/EA))/T, zeta = 5e-4;
	double w;

	if (!is_read(&scene, TAUT "support: {B: {motion: [4 mm, 0.1 mm, 0.1 mm]}}\n"
	          "damping: {ratio: 0.0005}\n") || !solve(&modes, &scene, 1) ||
	    !ok(!hawser_rom_build(&rom, &modes, &scene, NULL), "model"))
		return;
	w = sqrt(rom.K[0]);
	options.from = 2.02*w;
	options.to = 2.002*w;
	if (!ok(!hawser_frf_trace(&frf, &rom, &options, NULL) && frf.events == 1 &&
	        frf.event[0].kind == HAWSER_PERIOD_DOUBLING, "one period doubling"))
		return;
	close_to(frf.event[0].omega/(2.0*w) - 1.0, 0.25*sqrt(e*e - 16.0*zeta*zeta), 2e-2,
	         "its distance from twice the frequency");
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* A point of a string: displacement and transverse force T w'. */
struct wave {
	double complex w, force;
};

static struct wave carry(struct wave from, double complex kappa, double T, double x)
{
	return (struct wave){from.w*ccos(kappa*x) + from.force/(T*kappa)*csin(kappa*x),
	                     from.force*ccos(kappa*x) - T*kappa*from.w*csin(kappa*x)};
}

struct across {
	const char *what, *text;
	double at[2], mass[2], damper[2], spring[2];
	int modes;
	double limit;
	int more; /* 1: with HAWSER_LONG only */
};

/* Steady response of a string with two attachments to the motion A cos(Omega t) of end B across it,
 * damped by air: w'' = -kappa^2 w, kappa = sqrt(rho Omega^2 - i alpha Omega)/sqrt(T), between them, and
 * the force changes by (k + i c Omega - m Omega^2) w at them. */
static void check_across(const struct across *row)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom;
	struct hawser_frf frf;
	struct hawser_frf_options options = {.samples = HAWSER_NONE,
		.step_max = getenv("HAWSER_LONG") ? 0.02 : 0.1};
	const double A = 1e-4, T = 1e6, L = 100.0, alpha = 2.0;
	double rho = 16.0/(1.0 + T/4e8), worst = 0.0, most = 0.0;
	char text[1000];

	/* alpha and rho per unstretched length: the same factor */
	snprintf(text, sizeof text, TAUT "support: {B: {motion: [0, 0, 0.1 mm], phase: 0.8}}\n"
	         "damping: {alpha: 2 kg/m/s}\n%s", row->text);
	if (!is_read(&scene, text) || !solve(&modes, &scene, row->modes) ||
	    !ok(!hawser_rom_build(&rom, &modes, &scene, NULL), "model"))
		return;
	options.from = 0.8*M_PI/L*sqrt(T/rho)*rom.time;
	options.to = 1.2*M_PI/L*sqrt(T/rho)*rom.time;
	if (!ok(!hawser_frf_trace(&frf, &rom, &options, NULL) && frf.points > 5, "response"))
		return;
	for (int i = 0; i < frf.points; i++) {
		double W = frf.point[i].omega/rom.time, from = 0.0;
		double complex kappa = csqrt(rho*W*W - I*alpha/(1.0 + T/4e8)*W)/sqrt(T), w[3];
		struct wave at = {0.0, 1.0};

		for (int p = 0, k = 0; p < 4; ) {
			double probe = 0.25*L*(p + 1), stop = k < 2 ? L*row->at[k] : 2.0*L;
			double to = fmin(probe, stop);

			at = carry(at, kappa, T, to - from);
			from = to;
			if (to == probe && p < 3)
				w[p] = at.w;
			p += to == probe;
			if (to != stop)
				continue;
			at.force += (row->spring[k] + I*row->damper[k]*W - row->mass[k]*W*W)*at.w;
			k++;
		}
		for (int p = 0; p < 3; p++) {
			double want = cabs(A*w[p]/at.w);

			most = fmax(most, want);
			worst = fmax(worst, fabs(frf.probe[9*i + 3*p + 2]*rom.length - want));
		}
	}
	ok(worst < row->limit*most, "%s: displacement in closed form to %.1e of %.2g m", row->what,
	   worst/most, most);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

static const struct across across[] = {
	{.what = "a bare string", .text = "", .at = {0.1, 0.2}, .modes = 8, .limit = 2e-4, .more = 1},
	{.what = "with masses", .text = "attach: [{at: 13 %, mass: 300}, {at: 62 %, mass: 700}]\n",
	 .at = {0.13, 0.62}, .mass = {300.0, 700.0}, .modes = 8, .limit = 2e-4},
	{.what = "with a damper and a mass",
	 .text = "attach: [{at: 7 %, damper: [0, 0, 20 kN s/m]}, {at: 62 %, mass: 700}]\n",
	 .at = {0.07, 0.62}, .mass = {0.0, 700.0}, .damper = {2e4, 0.0}, .modes = 10,
	 .limit = 3e-4, .more = 1},
	{.what = "with a spring and a mass",
	 .text = "attach: [{at: 17 %, spring: [0, 0, 40 kN/m]}, {at: 62 %, mass: 700}]\n",
	 .at = {0.17, 0.62}, .mass = {0.0, 700.0}, .spring = {4e4, 0.0}, .modes = 8, .limit = 2e-4},
	{.what = "with a spring and a damper at one point",
	 .text = "attach: [{at: 7 %, spring: [0, 0, 300 kN/m], damper: [0, 0, 20 kN s/m]}, "
	         "{at: 62 %, mass: 700}]\n", .at = {0.07, 0.62}, .mass = {0.0, 700.0},
	 .spring = {3e5, 0.0}, .damper = {2e4, 0.0}, .modes = 10, .limit = 3e-4},
	{.what = "with a spring and a mass, not condensed",
	 .text = "attach: [{at: 17 %, spring: [0, 0, 40 kN/m]}, {at: 62 %, mass: 700}]\n"
	         "model: {condense: none}\n",
	 .at = {0.17, 0.62}, .mass = {0.0, 700.0}, .spring = {4e4, 0.0}, .modes = 12, .limit = 3e-4,
	 .more = 1},
};

/* Horizontal stiffness at end B, N/m: twice the energy of its unit displacement. */
static double end_stiffness(const struct hawser_modes *modes, double *end)
{
	struct hawser__support_shapes shapes;
	double sum = 0.0;

	if (hawser__support_shapes_make(&shapes, modes, NULL))
		return NAN;
	for (int p = 0; p < shapes.points; p++) {
		struct hawser_frame_point at = hawser_statics_frame(&modes->statics, modes->grid.s[p]);
		const double *x = shapes.strain + 3*p;
		double k = sqrt(1.0 + at.u*at.u)/(1.0 + at.strain);

		sum += modes->grid.weight[p]*(x[0]*x[0]/modes->statics.epsilon + k*x[1]*x[1]);
	}
	*end = shapes.shape[shapes.points - 1];
	hawser__support_shapes_clear(&shapes);
	return sum*modes->statics.H/modes->statics.span.d;
}

/* Against Irvine's stiffness of a parabola (1981, 2.3), EA/L_e/(1 + lambda^2/12), in which H/EA and the
 * square of the slope are neglected; and against the elastic catenary with the end displaced. */
static void check_end_stiffness(void)
{
	const double H = 3e4, EA = 6e7, d = 200.0, q = 9.81*d/H, Le = d*(1.0 + q*q/8.0), h = 1e-3;
	const double lambda2 = q*q*d/(H*Le/EA);
	struct hawser_span span = {2e6, 8.0, 9.81, 100.0, 37.0};
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_statics st, more, less;
	struct hawser_modes_options options = {.n = 3};
	double end;

	if (!is_read(&scene, "cable: {EA: 60 MN, rho: 1 kg/m}\nspan: {d: 200 m, h: 0}\n"
	          "tension: {H: 30 kN}\n") || !solve(&modes, &scene, 2))
		return;
	close_to(end_stiffness(&modes, &end), EA/Le/(1.0 + lambda2/12.0), 2e-3,
	         "stiffness of a parabola along the chord");
	ok(end > 0.99 && end < 1.01, "the displacement ends at 1: %.5f", end);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	if (!ok(!hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, 1.2e4, HAWSER_BRANCH_TAUT, NULL) &&
	        !hawser_modes_solve(&modes, &st, &options, NULL), "a deep inclined span"))
		return;
	span.d += h;
	ok(!hawser_statics_solve(&more, &span, HAWSER_GIVEN_LENGTH0, st.length0, HAWSER_BRANCH_TAUT,
	                         NULL), "displaced");
	span.d -= 2.0*h;
	ok(!hawser_statics_solve(&less, &span, HAWSER_GIVEN_LENGTH0, st.length0, HAWSER_BRANCH_TAUT,
	                         NULL), "displaced");
	close_to(end_stiffness(&modes, &end), (more.H - less.H)/(2.0*h), 1e-6,
	         "stiffness of the elastic catenary");
	hawser_modes_clear(&modes);
}

/* Equal motion of both ends is a rigid motion: only its inertia loads the cable. */
static void check_rigid(void)
{
	struct hawser_scene scene;
	struct hawser_modes modes;
	struct hawser_rom rom;
	double worst = 0.0;

	if (!is_read(&scene, INCLINED
	             "support: {A: {motion: [0, 0.1, 0.2]}, B: {motion: [0, 0.1, 0.2]}}\n") ||
	    !solve(&modes, &scene, 5) || !ok(!hawser_rom_build(&rom, &modes, &scene, NULL), "model"))
		return;
	ok(rom.harmonics == 2 && rom.harmonic[1].omega_power == 2, "displacement and inertia only");
	for (int j = 0; j < rom.n; j++)
		worst = fmax(worst, fabs(rom.harmonic[1].f[j] -
		                         (0.1*modes.mode[j].participation[1] +
		                          0.2*modes.mode[j].participation[2])/rom.length));
	ok(worst < 1e-12, "the participation of the modes: %.1e", worst);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* The condensed model against full order, both ends moving. */
static void check_full(void)
{
	static const char *const text[] = {
		"cable: {EA: 400 MN, rho: 16 kg/m}\nspan: {d: 100 m, h: 50 m}\ntension: {T0: 1.6 MN}\n"
		"damping: {ratio: 0.02}\nsupport: {A: {motion: [0, 0.02, 0.01], phase: 0.7, harmonic: 2}, "
		"B: {motion: [-0.01, 0.04, 0.02]}}\n",
		"cable: {EA: 20 MN, rho: 8 kg/m}\nspan: {d: 100 m, h: -20 m}\ntension: {sag: 14 m}\n"
		"damping: {ratio: 0.02}\nsupport: {A: {motion: [0.03, 0.02, 0]}, "
		"B: {motion: [-0.01, 0, 0.03], phase: 1}}\nload: {frame: global, per_length: [0, 1, 0]}\n",
		"cable: {EA: 400 MN, rho: 16 kg/m}\nspan: {d: 100 m, h: 50 m}\ntension: {T0: 1.6 MN}\n"
		"attach: [{at: 30 %, mass: 200, spring: [0, 20 kN/m, 30 kN/m]},\n"
		"  {at: 6 %, damper: [0, 9e3, 9e3]}]\n"
		"damping: {ratio: 0.02}\nsupport: {A: {motion: [0, 0.02, 0.01], phase: 0.7, harmonic: 2}, "
		"B: {motion: [-0.01, 0.04, 0.02]}}\n"};

	for (int i = 0; i < (getenv("HAWSER_LONG") ? 3 : 2); i++) {
		struct hawser_scene scene;
		struct hawser_modes modes;
		struct hawser_rom rom, full;
		struct hawser_frf a, b;
		struct hawser_frf_options options = {.samples = HAWSER_NONE, .tolerance = 1e-7,
			.step_max = 0.2};
		const double *x, *y;
		double most = 0.0, worst = 0.0, tension;

		if (!is_read(&scene, text[i]) || !solve(&modes, &scene, 10) ||
		    !ok(!hawser_rom_build(&rom, &modes, &scene, NULL) &&
		        !hawser_rom_build_full(&full, &modes.statics, &scene,
		                               i == 2 ? 16 : 10, NULL), "models"))
			return;
		options.from = 0.605*sqrt(rom.K[0]);
		options.to = 0.6*sqrt(rom.K[0]);
		if (!ok(!hawser_frf_trace(&a, &rom, &options, NULL) &&
		        !hawser_frf_trace(&b, &full, &options, NULL), "responses"))
			return;
		x = a.probe + (size_t)(a.points - 1)*9;
		y = b.probe + (size_t)(b.points - 1)*9;
		for (int p = 0; p < 9; p++) {
			most = fmax(most, fabs(y[p]));
			worst = fmax(worst, fabs(x[p] - y[p]));
		}
		tension = fmax(fabs(a.tension[2*a.points - 2] - b.tension[2*b.points - 2]),
		               fabs(a.tension[2*a.points - 1] - b.tension[2*b.points - 1]));
		ok(worst < 2e-3*most, "displacements against full order: %.1e", worst/most);
		ok(tension < 0.03*(b.tension[2*b.points - 1] - b.tension[2*b.points - 2]),
		   "tensions: %.1e of their range", tension/(b.tension[2*b.points - 1] -
		                                             b.tension[2*b.points - 2]));
		hawser_frf_clear(&a);
		hawser_frf_clear(&b);
		hawser_rom_clear(&rom);
		hawser_rom_clear(&full);
		hawser_modes_clear(&modes);
		hawser_scene_clear(&scene);
	}
}

CASE(property_support)
{
	check_orders(INCLINED MOVING);
	check_orders(INCLINED MOVING "attach: [{at: 30 %, mass: 40, spring: [2 kN/m, 9 kN/m, 5 kN/m]},\n"
	             "  {at: 81 %, mass: 90, spring: [0, 1 kN/m, 0]}]\n");
	check_orders(INCLINED MOVING "load: {static: {per_length: [3, -2, 40]}}\n"
	             "temperature: {change: 30 K, expansion: 1.2e-5}\n");
	check_orders(INCLINED "support: {A: {motion: [0.2, -0.1, 0.15], phase: 0.6, harmonic: 2,\n"
	             "  stiffness: [90 kN/m, .inf, 7 kN/m]}, B: {motion: [0.1, 0.3, -0.2], phase: -1.2,\n"
	             "  stiffness: [30 kN/m, 60 kN/m, 4 kN/m], mass: 70 kg}}\n"
	             "attach: [{at: 30 %, mass: 40, spring: [2 kN/m, 9 kN/m, 5 kN/m]}]\n");
	check_tongue();
	check_doubling();
	for (size_t i = 0; i < sizeof across/sizeof *across; i++)
		if (!across[i].more || getenv("HAWSER_LONG"))
			check_across(&across[i]);
	check_end_stiffness();
	check_rigid();
	check_full();
	return done_testing();
}
