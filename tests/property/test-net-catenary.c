/* Exact catenaries against quadrature and differences, against meshes, and against the statics of
 * spans; random nets, of which none may fail.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/statics.h>

#include "net/statics/catenary.h"
#include "tests/net-random.h"
#include "tests/tap.h"

/* Chord by Simpson's rule. */
static void quadrature(double sum[3], const struct hawser__net_catenary *cable, const double F[3])
{
	enum { N = 2000 };

	memset(sum, 0, 3*sizeof *sum);
	for (int i = 0; i <= N; i++) {
		double S = cable->length0*i/N, t[3], T = cable->soft*cable->soft;

		for (int k = 0; k < 3; k++) {
			t[k] = F[k] + cable->p[k]*(cable->length0/2.0 - S);
			T += t[k]*t[k];
		}
		for (int k = 0; k < 3; k++)
			sum[k] += (i == 0 || i == N ? 1.0 : i%2 ? 4.0 : 2.0)*cable->length0/(3.0*N)*
			          (t[k]/sqrt(T) + t[k]/cable->EA);
	}
}

/* Worst of: chord against quadrature, flexibility against differences of the chord, both per length,
 * and stiffness times flexibility against 1. */
static void element(void)
{
	uint64_t state = 3;
	double worst[3] = {0.0, 0.0, 0.0};

	for (int round = 0; round < 600; round++) {
		struct hawser__net_catenary cable = {.length0 = pow(10.0, 4.0*uniform(&state) - 2.0),
		                                     .EA = pow(10.0, 2.0 + 6.0*uniform(&state))};
		double F[3], chord[3], sum[3], H[3][3], K[3][3], size = pow(10.0, 4.0*uniform(&state) - 2.0);
		double w = round%3 ? size*pow(10.0, 3.0*uniform(&state) - 3.0)/cable.length0 : 0.0;

		cable.soft = round%2 ? 1e-2*size : 0.0;
		for (int k = 0; k < 3; k++) {
			F[k] = size*(2.0*uniform(&state) - 1.0) + (k == 0)*2.0*size;
			cable.p[k] = w*(2.0*uniform(&state) - 1.0);
		}
		hawser__catenary(chord, H, &cable, F);
		hawser__catenary_stiffness(K, &cable, F);
		if (round < 60) {
			quadrature(sum, &cable, F);
			for (int k = 0; k < 3; k++)
				worst[0] = fmax(worst[0], fabs(chord[k] - sum[k])/cable.length0);
		}
		for (int j = 0; j < 3; j++) {
			double step = 1e-4*size, G[3] = {F[0], F[1], F[2]}, up[3], down[3];

			G[j] = F[j] + step;
			hawser__catenary(up, NULL, &cable, G);
			G[j] = F[j] - step;
			hawser__catenary(down, NULL, &cable, G);
			for (int i = 0; i < 3; i++) {
				double one = K[i][0]*H[0][j] + K[i][1]*H[1][j] + K[i][2]*H[2][j];

				worst[1] = fmax(worst[1], fabs((up[i] - down[i])/(2.0*step) - H[i][j])*size/
				                          cable.length0);
				worst[2] = fmax(worst[2], fabs(one - (i == j)));
			}
		}
	}
	ok(worst[0] <= 1e-10, "chord against quadrature: %.1e of the length", worst[0]);
	ok(worst[1] <= 1e-7, "flexibility against differences: %.1e", worst[1]);
	ok(worst[2] <= 1e-6, "stiffness times flexibility against 1: %.1e", worst[2]);
}

/* A span between two supports, and a cable whose unstretched length is that of the span. */
static void span(void)
{
	const struct hawser_span steep = {.EA = 120e6, .rho = 6.0, .g = 9.81, .d = 200.0, .h = 5.0};
	struct hawser_report report = {0};
	struct hawser_statics statics;
	struct random_net r = {0};
	struct hawser_net_statics st;
	struct hawser_net_options options = {.method = "catenary"};
	char name[] = "span";

	if (!ok(!hawser_statics_solve(&statics, &steep, HAWSER_GIVEN_T0, 60e3, HAWSER_BRANCH_TAUT, &report),
	        "a span is solved"))
		return;
	r.net = (struct hawser_net){.name = name, .g = steep.g, .node = r.node, .cable = r.cable,
	                            .nodes = 2, .cables = 1};
	memset(r.node[0].held, 1, 3);
	memset(r.node[1].held, 1, 3);
	r.node[1].x[0] = steep.d;
	r.node[1].x[1] = steep.h;
	r.cable[0] = (struct hawser_net_cable){.to = 1, .EA = steep.EA, .rho = steep.rho,
	                                       .value = statics.length0, .elements = 10};
	if (!ok(!hawser_net_solve(&st, &r.net, &options, &report), "the same cable as a net"))
		return;
	close_to(st.member[0].T_from, statics.T0, 1e-11, "tension at A");
	close_to(st.member[0].T_to, statics.T1, 1e-11, "tension at B");
	close_to(st.member[0].T_min, statics.H, 1e-11, "least tension");
	close_to(st.member[0].length, statics.length, 1e-12, "stretched length");
	hawser_net_statics_clear(&st);
}

/* Random nets by catenaries and by meshes of 8 and 16 elements: energies per weight and size. A mesh
 * is the same energy for piecewise straight cables, so that it comes from above, the finer one closer;
 * it halves the error at least, if no cable has a fold that is shorter than an element. */
static void many(enum random_kind kind, int count)
{
	static const char *const name[] = {"heavy cables", "heavy and light cables", "bars"};
	struct hawser_net_options exact = {.method = "catenary"};
	struct hawser_report report = {0};
	uint64_t state = 20;
	int failed = 0, high = 0, slow = 0;
	double worst = 0.0;

	for (int i = 0; i < count; i++) {
		struct hawser_net_statics a, b[2];
		struct random_net r;
		double error[2] = {0.0, 0.0};

		random_net(&r, &state, kind);
		if (hawser_net_solve(&a, &r.net, &exact, &report)) {
			printf("# net %d: %s\n", i, report.message);
			failed++;
			continue;
		}
		for (int level = 0; level < 2; level++) {
			for (int c = 0; c < r.net.cables; c++)
				r.cable[c].elements = kind == BARS ? 1 : 8 << level;
			if (hawser_net_solve(&b[level], &r.net, NULL, &report)) {
				printf("# net %d, mesh: %s\n", i, report.message);
				failed++;
				continue;
			}
			error[level] = (b[level].energy - a.energy)/(fabs(a.energy) + r.weight*r.size + 1e-300);
			high += b[level].gap > 1e-8*(fabs(b[level].energy) + r.weight*r.size);
			hawser_net_statics_clear(&b[level]);
		}
		slow += error[1] > 0.5*error[0] + 1e-8;
		worst = fmax(worst, kind == BARS ? fabs(error[1]) : fmax(-error[1], error[1] - error[0]));
		hawser_net_statics_clear(&a);
	}
	ok(failed == 0, "%s: %d of %d nets failed", name[kind], failed, count);
	ok(high == 0, "%s: %d meshes with a gap", name[kind], high);
	ok(worst <= 1e-10, "%s: energies in the wrong order or, of bars, off by %.1e", name[kind],
	   worst);
	if (kind == HEAVY)
		ok(slow <= count/100, "%s: %d times the error of the energy was not halved at least",
		   name[kind], slow);
}

/* Too few iterations: refused, with what is left. */
static void cut(void)
{
	static const char *const method[] = {"cone", "interior-point", "forces", "catenary"};
	struct hawser_report report = {0};
	uint64_t state = 20;
	struct random_net r;

	random_net(&r, &state, HEAVY);
	for (int i = 0; i < 4; i++) {
		struct hawser_net_options options = {.method = method[i], .iterations = 1};
		struct hawser_net_statics st;

		ok(hawser_net_solve(&st, &r.net, &options, &report) == HAWSER_ERR_CONVERGENCE &&
		   report.residual > 0.0 && strstr(report.message, method[i]), "one iteration: %s",
		   report.message);
	}
}

CASE(property_net_catenary)
{
	int factor = getenv("HAWSER_LONG") ? 50 : 1;

	element();
	span();
	cut();
	many(HEAVY, 40*factor);
	many(SOME_LIGHT, 20*factor);
	many(BARS, 100*factor);
	return done_testing();
}
