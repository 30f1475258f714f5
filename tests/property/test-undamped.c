/* Undamped and nearly undamped models: multipliers on the unit circle, which round-off puts on
 * either side. Counts and events must be those of the model. Harmonic balance and shooting share
 * neither orbits nor multipliers, so that each confirms the other; the boundaries of a combination
 * resonance have a closed form. The expectations hold under every kernel of OpenBLAS.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/frf.h>
#include <hawser/modes.h>
#include <hawser/rom.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static const char *const methods[] = {"balance", "shooting"};
static unsigned long long state;

static double uniform(double low, double high)
{
	state = state*6364136223846793005ULL + 1442695040888963407ULL;
	return low + (high - low)*(double)(state >> 11)/9007199254740992.0;
}

/* n coordinates, diagonal K and D, a load at cos Omega t; room for entries. */
static void begin(struct hawser_rom *rom, int n, const double *w, const double *f, double damping)
{
	*rom = (struct hawser_rom){.n = n, .time = 1.0, .length = 1.0, .harmonics = 1};
	rom->D = calloc((size_t)n*n, sizeof(double));
	rom->K = calloc((size_t)n*n, sizeof(double));
	rom->Q = calloc(8*(size_t)n*n, sizeof *rom->Q);
	rom->C = calloc(8*(size_t)n*n, sizeof *rom->C);
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0].k = 1;
	rom->harmonic[0].f = calloc((size_t)n, sizeof(double));
	for (int j = 0; j < n; j++) {
		rom->D[j*(n + 1)] = damping;
		rom->K[j*(n + 1)] = w[j]*w[j];
		rom->harmonic[0].f[j] = f[j];
	}
}

/* Energy c u_a^2 u_b. */
static void add_cubic_energy(struct hawser_rom *rom, int a, int b, double c)
{
	if (a == b) {
		rom->Q[rom->quads++] = (struct hawser_quad){a, a, a, 3.0*c};
		return;
	}
	rom->Q[rom->quads++] = (struct hawser_quad){a, a < b ? a : b, a < b ? b : a, 2.0*c};
	rom->Q[rom->quads++] = (struct hawser_quad){b, a, a, c};
}

/* Energy c u_a^2 u_b^2. */
static void add_quartic_energy(struct hawser_rom *rom, int a, int b, double c)
{
	if (a == b) {
		rom->C[rom->cubics++] = (struct hawser_cubic){a, a, a, a, 4.0*c};
		return;
	}
	rom->C[rom->cubics++] = (struct hawser_cubic){a, a, b, b, 2.0*c};
	rom->C[rom->cubics++] = (struct hawser_cubic){b, a, a, b, 2.0*c};
}

/* Trace, with the checks that hold for every undamped model: at most half of the multipliers are
 * outside, since the inverse of each is a multiplier, and every change of the count has its event. */
static int trace(struct hawser_frf *frf, struct hawser_rom *rom, const char *name, const char *method,
                 double from, double to)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};
	int strange = 0, most = 0, changes = 0, width = 0;
	enum hawser_status status;

	options.method = method;
	options.from = from;
	options.to = to;
	options.max_points = 1500;
	status = hawser_frf_trace(frf, rom, &options, &report);
	/* without damping an orbit may grow until it is ill-conditioned, and is then refused */
	ok(!status || status == HAWSER_ERR_CONVERGENCE, "%s, %s: %d points, %d events %s", name, method,
	   frf->points, frf->events, report.message);
	for (int e = 0; e < frf->events; e++) {
		strange += frf->event[e].suspected || !frf->event[e].located;
		width += frf->event[e].kind == HAWSER_TORUS ? 2 : 1;
	}
	for (int p = 0; p < frf->points; p++) {
		most = frf->point[p].unstable > most ? frf->point[p].unstable : most;
		changes += p > 0 ? abs(frf->point[p].unstable - frf->point[p - 1].unstable) : 0;
	}
	ok(strange == 0 && most <= rom->n && changes <= width && frf->sample_disagreements == 0,
	   "%s, %s: %d of %d multipliers outside at most, changes by %d, events make for %d, %d of them "
	   "not confirmed, %d samples disagree", name, method, most, 2*rom->n, changes, width, strange,
	   frf->sample_disagreements);
	return !status;
}

/* 1 if event e and the next one are torus points or period doublings so close to each other that
 * the growth between them is less than the error of the multipliers of one method, which then does
 * not detect them. */
static int narrow(const struct hawser_frf *frf, int e)
{
	const struct hawser_frf_event *event = &frf->event[e];

	return e + 1 < frf->events && event[0].kind == event[1].kind &&
	       (event[0].kind == HAWSER_TORUS || event[0].kind == HAWSER_PERIOD_DOUBLING) &&
	       event[1].unstable[1] == event[0].unstable[0] &&
	       fabs(event[1].omega/event[0].omega - 1.0) < 1e-4;
}

/* Both methods find the same events, in the range that both cover. Returns their number, and in
 * `omega` the first ones. */
static int check_model(struct hawser_rom *rom, const char *name, double from, double to, double *omega,
                       int room)
{
	struct hawser_frf frf[2] = {{0}, {0}};
	int complete = 1, events, differ = hawser_rom_compile(rom, NULL), at[2] = {0, 0};
	int skipped[2] = {0, 0};
	double worst = 0.0;

	for (int k = 0; k < 2; k++)
		complete = trace(&frf[k], rom, name, methods[k], from, to) && complete;
	events = frf[0].events;
	while (at[0] < events && at[1] < frf[1].events) {
		const struct hawser_frf_event *a = &frf[0].event[at[0]], *b = &frf[1].event[at[1]];
		double apart = fabs(a->omega/b->omega - 1.0)/(a->error + b->error);
		int k = apart < 1.0 && a->kind == b->kind ? -1 : narrow(&frf[0], at[0]) ? 0
		        : narrow(&frf[1], at[1]) ? 1 : -1;

		if (k >= 0) {
			at[k] += 2;
			skipped[k] += 2;
			continue;
		}
		differ += a->kind != b->kind;
		worst = fmax(worst, apart);
		if (at[0] < room)
			omega[at[0]] = a->omega;
		at[0]++;
		at[1]++;
	}
	ok(differ == 0 && worst < 1.0 &&
	   (!complete || events - skipped[0] == frf[1].events - skipped[1]),
	   "%s: the same %d events (%d), %.2g of the errors apart", name, events, frf[1].events, worst);
	for (int k = 0; k < 2; k++)
		hawser_frf_clear(&frf[k]);
	return events;
}

static void check_duffing(double damping, const char *name)
{
	struct hawser_rom rom;
	double omega[1] = {0.0};

	begin(&rom, 1, (double[]){1.0}, (double[]){0.1}, damping);
	add_quartic_energy(&rom, 0, 0, 0.025);
	ok(check_model(&rom, name, 2.0, 0.8, omega, 1) == 1, "one fold");
	close_to(omega[0], 1.0825077658, 1e-9, "where it is without damping");
	hawser_rom_clear(&rom);
}

/* Period doublings by internal resonance 1:2, and a fold between them. */
static void check_two_to_one(double damping, const char *name)
{
	struct hawser_rom rom;
	double omega[3] = {0.0};

	begin(&rom, 2, (double[]){1.0, 2.0}, (double[]){0.1, 0.05}, damping);
	add_cubic_energy(&rom, 0, 1, 0.1);
	add_quartic_energy(&rom, 0, 0, 0.025);
	add_quartic_energy(&rom, 1, 1, 0.05);
	ok(check_model(&rom, name, 2.5, 1.3, omega, 3) == 3, "three events");
	close_to(omega[0], 2.0379475262, 1e-8, "period doubling");
	close_to(omega[1], 2.0337859298, 1e-8, "fold");
	close_to(omega[2], 2.2567565840, 1e-8, "period doubling");
	hawser_rom_clear(&rom);
}

/* Stiffness 2 depth cos(Omega t) between the two: a combination resonance about w1 + w2, where two
 * pairs of multipliers meet and leave the circle. To first order it is depth/sqrt(w1 w2) wide on each
 * side. */
static void check_combination(double damping, const char *name)
{
	const double w[2] = {1.0, 2.0}, depth = 0.005;
	struct hawser_rom rom;
	double omega[2] = {0.0}, half = depth/sqrt(w[0]*w[1]);

	begin(&rom, 2, w, (double[]){0.1, 0.05}, damping);
	rom.harmonic[0].K = calloc(4, sizeof(double));
	rom.harmonic[0].K[1] = rom.harmonic[0].K[2] = 2.0*depth;
	ok(check_model(&rom, name, 2.9, 3.1, omega, 2) == 2, "two events");
	ok(fabs(omega[0] - 3.0 + half) < half*half && fabs(omega[1] - 3.0 - half) < half*half,
	   "at the boundaries of the combination resonance to first order: %g, %g, half width %g",
	   omega[0] - 3.0, omega[1] - 3.0, half);
	hawser_rom_clear(&rom);
}

/* Near a third of its first frequency the curve follows free motions without end. It is ended
 * early, because it climbs or because an orbit is ill-conditioned, and the message gives the
 * reason. */
static void check_climb(const struct hawser_rom *rom)
{
	struct hawser_frf_options options = {.method = "balance"};
	struct hawser_report report = {.message = ""};
	struct hawser_frf frf = {0};
	enum hawser_status status;

	options.from = 0.325*sqrt(rom->K[0]);
	options.to = 0.45*sqrt(rom->K[0]);
	status = hawser_frf_trace(&frf, rom, &options, &report);
	ok(status == HAWSER_ERR_CONVERGENCE && frf.points < 1000 &&
	   strstr(report.message, "without damping"), "after %d points: %s",
	   frf.points, report.message);
	hawser_frf_clear(&frf);
}

/* A cable without damping: between its resonances, and near a superharmonic one. */
static void check_cable(void)
{
	static const char text[] = "cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, h: 10 m}\n"
		"tension: {T0: 80 kN}\nload: {frame: local, per_length: [0.8 N/m, 0.8, 0.8]}\n";
	struct hawser_modes_options options = {.n = 3};
	struct hawser_scene scene;
	struct hawser_statics st;
	struct hawser_modes modes = {.n = 0};
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {0};

	if (ok(!read_text(&scene, text, NULL, NULL) && !hawser_statics_scene(&st, &scene, NULL) &&
	       !hawser_modes_solve(&modes, &st, &options, NULL) &&
	       !hawser_rom_build(&rom, &modes, &scene, NULL), "a cable") &&
	    trace(&frf, &rom, "cable", "balance", 1.1*sqrt(rom.K[0]), 1.3*sqrt(rom.K[0])))
		ok(frf.events == 0 && frf.undecided == frf.points && frf.end == HAWSER_END_RANGE,
		   "no events, on the unit circle everywhere");
	if (rom.n > 0)
		check_climb(&rom);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
}

/* Models `first` to `count` of a sequence. */
static void check_random(int first, int count)
{
	int events = 0;

	state = 0;
	for (int i = 0; i < count; i++) {
		int n = 2 + i%2;
		double w[3] = {1.0, (1 + i%3)*uniform(0.98, 1.02), uniform(2.3, 3.7)}, f[3];
		struct hawser_rom rom;
		char name[40];
		int found;

		for (int j = 0; j < n; j++)
			f[j] = uniform(-0.1, 0.1);
		begin(&rom, n, w, f, i%4 == 3 ? 1e-10 : 0.0);
		for (int a = 0; a < n; a++)
			for (int b = 0; b < n; b++) {
				add_cubic_energy(&rom, a, b, uniform(-0.1, 0.1));
				if (a <= b)
					add_quartic_energy(&rom, a, b, uniform(0.0, 0.05));
			}
		snprintf(name, sizeof name, "random model %d", i);
		found = i < first ? 0 : check_model(&rom, name, 2.6, 1.4, NULL, 0);
		events += found > 0 ? found : 0;
		hawser_rom_clear(&rom);
	}
	ok(events > count - first, "%d events of %d random models", events, count - first);
}

CASE(property_undamped)
{
	check_duffing(0.0, "Duffing");
	check_duffing(1e-12, "Duffing, damping 1e-12");
	check_duffing(1e-9, "Duffing, damping 1e-9");
	check_two_to_one(0.0, "two modes");
	check_two_to_one(2e-12, "two modes, damping 2e-12");
	check_two_to_one(2e-9, "two modes, damping 2e-9");
	check_combination(0.0, "combination");
	check_combination(2e-12, "combination, damping 2e-12");
	check_combination(2e-9, "combination, damping 2e-9");
	check_cable();
	check_random(0, 8);
	/* narrow regions of instability, and pairs of multipliers that pass -1 in one step */
	check_random(47, 48);
	check_random(53, 54);
	return done_testing();
}
