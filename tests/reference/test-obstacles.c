/* Spans over obstacles from their scenes: published and independent numbers, mirrored scenes, the
 * balance of forces, limits of friction, and what is refused.
 *
 * B: Bertrand, 2022. Own numbers: of an independent program in another language.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <hawser/obstacles.h>

#include "tests/tap.h"

static char path[] = "test-obstacles.XXXXXX";

static void put(const char *text)
{
	FILE *file = fopen(path, "w");

	if (file) {
		fputs(text, file);
		fclose(file);
	}
}

/* Solve the scene of a text. */
static enum hawser_status solve(struct hawser_obstacles *scene, struct hawser_obstacles_statics *st,
                                const char *text, struct hawser_report *report)
{
	enum hawser_status status;

	put(text);
	status = hawser_obstacles_open(scene, path, NULL, 0, report);
	if (!status)
		status = hawser_obstacles_solve(st, scene, report);
	if (status)
		hawser_obstacles_clear(scene);
	return status;
}

static int solved(struct hawser_obstacles *scene, struct hawser_obstacles_statics *st, const char *text)
{
	struct hawser_report report = {0};
	enum hawser_status status = solve(scene, st, text, &report);

	return !status || ok(0, "%s: %s", hawser_status_name(status), report.message);
}

static void done(struct hawser_obstacles *scene, struct hawser_obstacles_statics *st)
{
	hawser_obstacles_statics_clear(st);
	hawser_obstacles_clear(scene);
}

static double H_A(const struct hawser_line_statics *st)
{
	return st->T_A*cos(st->angle_A);
}

static double H_B(const struct hawser_line_statics *st)
{
	return st->T_B*cos(st->angle_B);
}

/* B Table 2.1, own numbers; Figure 2.9 shows these cables beside those without the sheave. */
static void table_2_1(void)
{
	static const struct { double L, yB, c[2], H1, H2, wrap; } row[3] = {
		{50.5, 0.0, {25.0, -3.0}, 2707.575, 2707.575, 0.477766},
		{50.5, 0.0, {37.5, -4.0}, 3831.428, 3940.200, 0.237402},
		{51.0, 8.0, {25.0, -1.0}, 4123.718, 4235.143, 0.164304},
	};
	struct hawser_obstacles scene;
	struct hawser_obstacles_statics st;
	char text[512];

	for (int i = 0; i < 3; i++) {
		snprintf(text, sizeof text,
		         "cable: {EA: .inf, rho: 5.56 kg/m}\nspan: {d: 50 m, h: %g m}\n"
		         "tension: {length0: %g m}\nobstacles:\n"
		         "  - {circle: {centre: [%g m, %g m], radius: 3 m}, friction: 0.1}\n",
		         row[i].yB, row[i].L, row[i].c[0], row[i].c[1]);
		if (!solved(&scene, &st, text))
			continue;
		close_to(H_A(&st.st), row[i].H1, 2e-7, "B Table 2.1: H on the left");
		close_to(H_B(&st.st), row[i].H2, 2e-7, "H on the right");
		close_to(st.st.contact[0].wrap, row[i].wrap, 3e-6, "angle of contact");
		ok(st.friction && !st.slide[0].status && !st.slide[1].status && !st.clear.status,
		   "both limits of friction, and the cable without the sheave");
		if (i == 0)
			close_to(st.slide[1].st.contact[0].T_out/st.slide[1].st.contact[0].T_in, 1.052066, 5e-7,
			         "line 1, about to slide toward B: T2/T1");
		ok(H_A(&st.slide[1].st) < H_A(&st.st) && H_A(&st.st) < H_A(&st.slide[0].st) &&
		   H_B(&st.slide[0].st) < H_B(&st.st) && H_B(&st.st) < H_B(&st.slide[1].st),
		   "the state without tangential force is between the limits");
		done(&scene, &st);
	}
}

/* B Table 3.5; the printed numbers have no weight of the cable on the sheave. */
static void table_3_5(void)
{
	static const struct { double c[2], left, right, printed; } row[2] = {
		{{150.0, -8.0}, 28935.7, 28935.7, 28937.0}, {{50.0, -5.0}, 52295.98, 52126.54, 52294.0}};
	struct hawser_obstacles scene;
	struct hawser_obstacles_statics st;
	char text[512];

	for (int i = 0; i < 2; i++) {
		snprintf(text, sizeof text,
		         "kind: span\ncable: {EA: 1.5 GN, rho: 5.56 kg/m}\nspan: {d: 300 m, h: 0 m}\n"
		         "tension: {length0: 301 m}\nobstacles:\n"
		         "  - {circle: {centre: [%g m, %g m], radius: 10 m}, side: above}\n",
		         row[i].c[0], row[i].c[1]);
		if (!solved(&scene, &st, text))
			continue;
		close_to(H_A(&st.st), row[i].left, 2e-6, "B Table 3.5: H on the left");
		close_to(H_B(&st.st), row[i].right, 2e-6, "H on the right");
		close_to(H_A(&st.st), row[i].printed, 6e-5, "printed");
		ok(!st.friction, "no friction, no limits");
		done(&scene, &st);
	}
}

/* A random span with up to three circles, as text; mirrored: seen from behind. */
struct random_span {
	double d, h, rho, EA, length, c[3][2], R[3], mu[3];
	int n, side[3], sliding;
};

static double uniform(unsigned *seed, double low, double high)
{
	*seed = *seed*1664525u + 1013904223u;
	return low + (high - low)*(*seed >> 8)/16777216.0;
}

static struct random_span draw(unsigned *seed)
{
	struct random_span of = {.d = uniform(seed, 40.0, 400.0), .rho = uniform(seed, 0.5, 8.0),
		.EA = exp(uniform(seed, log(1e6), log(1e10)))};

	of.h = of.d*uniform(seed, -0.3, 0.3);
	of.n = 1 + (int)uniform(seed, 0.0, 3.0);
	of.sliding = (int)uniform(seed, 0.0, 3.15); /* 3: history */
	for (int i = 0; i < of.n; i++) {
		double x = of.d*(i + 1.0)/(of.n + 1.0), R = of.d*uniform(seed, 0.002, 0.04);

		of.R[i] = R;
		of.mu[i] = uniform(seed, 0.0, 0.4);
		of.side[i] = i == 1 ? -1 : 1;
		of.c[i][0] = x;
		of.c[i][1] = of.h*x/of.d + of.side[i]*(of.d*uniform(seed, 0.0, 0.06) - R);
	}
	of.length = of.d*uniform(seed, 1.08, 1.2);
	return of;
}

static void write_span(char *text, size_t size, const struct random_span *of, int mirrored)
{
	static const char *const sliding[] = {"none", "toward-A", "toward-B"};
	char how[96];
	int used;

	if (of->sliding == 3)
		snprintf(how, sizeof how, "history, path: [%.17g, %.17g], winch: %s", 1.03*of->length,
		         0.997*of->length, mirrored ? "B" : "A");
	else
		snprintf(how, sizeof how, "%s",
		         sliding[mirrored && of->sliding ? 3 - of->sliding : of->sliding]);
	used = snprintf(text, size,
	                "cable: {EA: %.17g, rho: %.17g}\nspan: {d: %.17g, h: %.17g}\n"
	                "tension: {length0: %.17g}\ncontact: {sliding: %s}\nobstacles:\n",
	                of->EA, of->rho, of->d, mirrored ? -of->h : of->h, of->length, how);

	for (int k = 0; k < of->n; k++) {
		int i = mirrored ? of->n - 1 - k : k;

		used += snprintf(text + used, size - (size_t)used,
		                 "  - {circle: {centre: [%.17g, %.17g], radius: %.17g}, side: %s, "
		                 "friction: %.17g}\n", mirrored ? of->d - of->c[i][0] : of->c[i][0],
		                 mirrored ? of->c[i][1] - of->h : of->c[i][1], of->R[i],
		                 of->side[i] > 0 ? "above" : "below", of->mu[i]);
	}
}

/* Largest relative difference of two mirrored states. */
static double unlike(const struct hawser_line_statics *a, const struct hawser_line_statics *b)
{
	int n = a->line->sheaves;
	double worst = fmax(fabs(a->T_A/b->T_B - 1.0), fabs(a->T_B/b->T_A - 1.0));

	for (int i = 0; i < n; i++) {
		const struct hawser_line_contact *p = &a->contact[i], *q = &b->contact[n - 1 - i];

		if (p->touches != q->touches)
			return INFINITY;
		if (!p->touches)
			continue;
		worst = fmax(worst, fabs(p->T_in/q->T_out - 1.0));
		worst = fmax(worst, fabs(p->wrap - q->wrap));
		worst = fmax(worst, fabs(p->force[0] + q->force[0])/a->T_A);
	}
	return worst;
}

/* Defect of the balance of the whole rope over its largest tension. */
static double unbalanced(const struct hawser_line_statics *st)
{
	double sum[2] = {st->reaction_A[0] + st->reaction_B[0],
	                 st->reaction_A[1] + st->reaction_B[1] - st->line->rho*st->line->g*st->length0};

	for (int i = 0; i < st->line->sheaves; i++)
		for (int k = 0; k < 2 && st->contact[i].touches; k++)
			sum[k] += st->contact[i].force[k];
	return hypot(sum[0], sum[1])/fmax(st->T_A, st->T_B);
}

/* Steps of a path in which Coulomb's law does not hold at a circle: rope passes although friction has
 * not its largest value, or against it. */
static int unlawful(const struct hawser_obstacles *scene, const struct hawser_obstacles_path *way)
{
	int n = scene->line.sheaves, count = 0;

	for (int i = n; i < way->points*n; i++) {
		double p = way->slid[i] - way->slid[i - n], mu = scene->line.sheave[i % n].friction;

		count += fabs(p) > 1.1e-11*way->value[i/n] && fabs(way->grip[i] - (p > 0.0 ? mu : -mu)) > 1e-9;
		count += !(fabs(way->grip[i]) <= mu);
	}
	return count;
}

static void mirrored(void)
{
	struct hawser_obstacles scene[2];
	struct hawser_obstacles_statics st[2];
	double worst = 0.0, force = 0.0;
	unsigned seed = 2107;
	int count = getenv("HAWSER_LONG") ? 2000 : 12, touching = 0, limits = 0, n = 0, none = 0;
	int paths = 0, wrong = 0, slips = 0;
	char text[2048];

	for (; n < count; n++) {
		struct random_span of = draw(&seed);
		struct hawser_report report = {0};
		enum hawser_status status;

		write_span(text, sizeof text, &of, 0);
		status = solve(&scene[0], &st[0], text, &report);
		if (status) { /* a slack rope with much friction */
			none++;
			continue;
		}
		write_span(text, sizeof text, &of, 1);
		if (!solved(&scene[1], &st[1], text)) {
			done(&scene[0], &st[0]);
			continue;
		}
		worst = fmax(worst, unlike(&st[0].st, &st[1].st));
		force = fmax(force, unbalanced(&st[0].st));
		if (scene[0].history) {
			paths++;
			wrong += unlawful(&scene[0], &st[0].path);
			slips += st[0].path.slid[(st[0].path.points - 1)*of.n] != 0.0;
		}
		for (int i = 0; i < of.n; i++)
			touching += st[0].st.contact[i].touches;
		if (st[0].friction && !st[0].slide[0].status && !st[1].slide[1].status) {
			worst = fmax(worst, unlike(&st[0].slide[0].st, &st[1].slide[1].st));
			limits++;
		}
		done(&scene[0], &st[0]);
		done(&scene[1], &st[1]);
	}
	ok(worst < 1e-9, "%d random spans, %d contacts, %d limits: mirrored ones differ by %.1e", n,
	   touching, limits, worst);
	ok(wrong == 0 && paths > 0 && slips > 0, "%d have a history: Coulomb's law fails in %d steps, and "
	   "%d slip", paths, wrong, slips);
	ok(none <= n/200, "%d of them are refused", none);
	ok(touching > n && limits > n/5, "most of them touch, and have limits");
	ok(force < 1e-12, "forces in balance to %.1e of the tension", force);
}

/* With one circle each tension between the limits is an equilibrium: a smaller coefficient has its
 * limits within, and the ratio is that of the capstan law. */
static void capstan(void)
{
	static const double mu[3] = {0.0, 0.15, 0.3};
	double T[3], ratio[3], wrap[3];
	struct hawser_obstacles scene;
	struct hawser_obstacles_statics st;
	char text[512];

	for (int i = 0; i < 3; i++) {
		snprintf(text, sizeof text,
		         "cable: {EA: .inf, rho: 1e-6}\nspan: {d: 20, h: -3}\ntension: {T0: 5 kN}\n"
		         "contact: {sliding: toward-B}\nobstacles:\n"
		         "  - {circle: {centre: [9, 5], radius: 2}, friction: %g}\n", mu[i]);
		if (!solved(&scene, &st, text))
			return;
		T[i] = st.st.T_B;
		ratio[i] = st.st.contact[0].T_out/st.st.contact[0].T_in;
		wrap[i] = st.st.contact[0].wrap;
		done(&scene, &st);
	}
	for (int i = 0; i < 3; i++)
		close_to(ratio[i], exp(mu[i]*wrap[i]), 1e-8, "almost no weight: e^(mu wrap)");
	ok(T[0] < T[1] && T[1] < T[2], "T1 grows with the friction: %.1f, %.1f, %.1f N", T[0], T[1], T[2]);
}

/* free: the tensions of no friction; limits that do not exist are told. */
static void turning(void)
{
	static const char scene_text[] =
		"cable: {EA: 40 MN, rho: 4}\nspan: {d: 200, h: 10}\ntension: {T0: 60 kN}\nobstacles:\n"
		"  - {circle: {centre: [90, 1], radius: 8}, friction: 0.4, rotation: %s}\n";
	struct hawser_obstacles scene;
	struct hawser_obstacles_statics st;
	double T[2] = {0.0, 0.0};
	char text[512];

	for (int i = 0; i < 2; i++) {
		snprintf(text, sizeof text, scene_text, i ? "free" : "locked");
		if (!solved(&scene, &st, text))
			return;
		T[i] = st.st.T_B;
		ok(st.friction == !i, "%s", i ? "free: nothing holds the rope" : "locked: there are limits");
		if (i)
			close_to(st.st.contact[0].T_out - st.st.contact[0].T_in,
			         -4.0*9.81*8.0*(cos(st.st.contact[0].angle_in) - cos(st.st.contact[0].angle_out)),
			         2e-3, "no moment about the axis of the circle, but for the stretch");
		done(&scene, &st);
	}
	ok(T[0] == T[1], "free as locked without tangential force");
}

/* The contact of modes, and modes of B Table 3.5, line 2 (Table 3.6 does not say where its sheave is):
 * a mesh gives 1.22338, 2.43481, 2.44519 and 3.47141 rad/s with slip, 1e-4 from the exact ones
 * (doc/theory-ropeway-modes.md). */
static void modes(void)
{
	static const struct {
		const char *of, *contact, *error;
		enum hawser_line_contact_kind kind;
	} row[] = {
		{"friction: 0.1", "{}", NULL, HAWSER_LINE_STICK},
		{"friction: 0.1", "{sliding: toward-A}", NULL, HAWSER_LINE_SLIP},
		{"friction: 0.1", "{modes: slip}", NULL, HAWSER_LINE_SLIP},
		{"friction: 0.1, rotation: free, inertia: 20", "{}", NULL, HAWSER_LINE_ROLL},
		{"friction: 0", "{}", NULL, HAWSER_LINE_SLIP},
		{"friction: 0", "{modes: stick}", "does not stick to it", HAWSER_LINE_STICK},
	};
	static const double mesh[4] = {1.22338, 2.43481, 2.44519, 3.47141};

	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		struct hawser_obstacles scene;
		struct hawser_obstacles_statics st;
		struct hawser_report report = {0};
		enum hawser_line_contact_kind kind;
		enum hawser_status status;
		char text[512];
		int loose;

		snprintf(text, sizeof text,
		         "cable: {EA: 1.5 GN, rho: 5.56}\nspan: {d: 300, h: 0}\ntension: {length0: 301}\n"
		         "obstacles:\n  - {circle: {centre: [50, -5], radius: 10}, %s}\ncontact: %s\n",
		         row[i].of, row[i].contact);
		if (!solved(&scene, &st, text))
			continue;
		status = hawser_obstacles_contact(&kind, &loose, &scene, &st.st, &report);
		ok(row[i].error ? status && strstr(report.message, row[i].error)
		                : !status && kind == row[i].kind && !loose, "%s, contact: %s: %s", row[i].of,
		   row[i].contact, status ? report.message : hawser_line_contact_name(kind));
		if (i == 2) {
			const struct hawser_line_statics *lane = &st.st;
			const struct hawser_line_modes_options options = {.n = 4, .contact = kind};
			struct hawser_line_modes of;

			if (ok(!hawser_line_modes_solve(&of, &lane, 1, &options, &report), "modes"))
				for (int k = 0; k < 4; k++)
					close_to(of.mode[k].omega/of.time_unit, mesh[k], 1.5e-4, "a mode with slip");
			hawser_line_modes_clear(&of);
		}
		done(&scene, &st);
	}
}

/* What cannot be. */
static void refused(void)
{
	static const struct { const char *text, *says; } row[] = {
		{"cable: {EA: .inf, rho: 5}\nspan: {d: 50, h: 0}\ntension: {length0: 50.5}\nobstacles:\n"
		 "  - {circle: {centre: [37.5, 3], radius: 3}}\n", "shorter than the shortest way"},
		{"cable: {EA: .inf, rho: 5}\nspan: {d: 50, h: 0}\ntension: {length0: 50.00000000000005}\n"
		 "obstacles:\n  - {circle: {centre: [37.5, -8], radius: 3}}\n", "not determined"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 100 N}\nobstacles:\n"
		 "  - {circle: {centre: [37.5, 0], radius: 3}}\n", "the tension is too low"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {H: 100 N}\nobstacles:\n"
		 "  - {circle: {centre: [37.5, 0], radius: 3}}\n", ":3:11: tension.H: not yet"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 1 kN}\nobstacles:\n"
		 "  - {plane: {point: [0, 0]}}\n", ":5:6: obstacles.plane: not yet"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 1 kN}\nobstacles:\n"
		 "  - {circle: {centre: [47, 0], radius: 3}}\n", ":5:5: end B at (50, 0) m is inside"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 1 kN}\nobstacles:\n"
		 "  - {circle: {centre: [30, 0], radius: 3}}\n  - {circle: {centre: [20, 0], radius: 3}}\n",
		 ":6:5: sheave 2 (s1, line 6) is at x = 20 m"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 1 kN}\nobstacles:\n"
		 "  - {circle: {centre: [30, 0], radius: 3}, inertia: 4}\n", "give rotation: free"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 1 kN}\nobstacles:\n"
		 "  - {circle: {centre: [30, 0], radius: 3}}\ncontact: {sliding: history}\n",
		 ":6:1: contact.sliding: history needs contact.path"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 1 kN}\ncontact: {}\n",
		 "the section obstacles is missing"},
		{"cable: {EA: 1 GN, rho: 5}\nspan: {d: 50, h: 0}\ntension: {T0: 1 kN}\nobstacles:\n"
		 "  - {circle: {centre: [30, 0], radius: 3}}\nmodel: {modes: 3}\n", ":6:1: model: not yet"},
	};

	for (size_t i = 0; i < sizeof row/sizeof *row; i++) {
		struct hawser_obstacles scene;
		struct hawser_obstacles_statics st;
		struct hawser_report report = {0};
		enum hawser_status status = solve(&scene, &st, row[i].text, &report);

		ok(status && strstr(report.message, row[i].says), "%s", report.message);
	}
}

CASE(reference_obstacles)
{
	int file = mkstemp(path);

	if (!ok(file >= 0, "a file for scenes"))
		return done_testing();
	close(file);
	table_2_1();
	table_3_5();
	mirrored();
	capstan();
	turning();
	modes();
	refused();
	unlink(path);
	return done_testing();
}
