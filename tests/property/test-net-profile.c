/* Methods of the statics of nets on random cables, their certificate and their performance profile.
 *
 * The certificate is checked by two routes: a shooting method for a hanging chain, which has two
 * unknowns and shares no code with it or with the methods, and the energy of displaced shapes.
 * With HAWSER_LONG all 1600 cables of B 3.2.3, without relaxation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/nets/comparison.h"
#include "tests/tap.h"

enum { FEW = 12, ALL = 1600 };

/* --- a hanging chain by shooting --- */

/* Chain from (0, 0): the force of the first element is n, that of each next one has the weight of an
 * element more. x [elements + 1][2], or NULL; end: its end; K: derivative of the end by n. */
static long double shoot(long double end[2], long double K[3], double (*x)[2],
                         const struct net_cable *cable, const long double n[2])
{
	long double L = (long double)cable->length0/cable->elements, w = (long double)cable->rho*cable->g*L;
	long double energy = 0.0L;

	end[0] = end[1] = K[0] = K[1] = K[2] = 0.0L;
	for (int i = 0; i <= cable->elements; i++) {
		long double v = n[1] + i*w, T = sqrtl(n[0]*n[0] + v*v), a = L/T, b = L/cable->EA;

		if (x) {
			x[i][0] = (double)end[0];
			x[i][1] = (double)end[1];
		}
		if (i == cable->elements)
			break;
		end[0] += (a + b)*n[0];
		end[1] += (a + b)*v;
		K[0] += b + a*(v/T)*(v/T);
		K[1] -= a*(n[0]/T)*(v/T);
		K[2] += b + a*(n[0]/T)*(n[0]/T);
		energy += L*T + b*T*T/2.0L;
	}
	return energy - n[0]*cable->d - n[1]*cable->h;
}

/* The chain's force n by Newton's method with halved steps: the energy above is convex in n. */
static int chain(long double n[2], double (*x)[2], const struct net_cable *cable)
{
	long double chord = hypotl(cable->d, cable->h), W = (long double)cable->rho*cable->g*cable->length0;
	long double N = fmaxl(0.3L*W, cable->EA*(chord/cable->length0 - 1.0L)), end[2], K[3], energy;

	n[0] = N*cable->d/chord;
	n[1] = N*cable->h/chord - W/2.0L;
	for (int i = 0; i < 200; i++) {
		long double r[2], det, d[2], step = 1.0L, trial[2], e[2], k[3];

		energy = shoot(end, K, NULL, cable, n);
		r[0] = end[0] - cable->d;
		r[1] = end[1] - cable->h;
		if (hypotl(r[0], r[1]) <= 1e-16L*chord) {
			shoot(end, K, x, cable, n);
			return 1;
		}
		det = K[0]*K[2] - K[1]*K[1];
		d[0] = -(K[2]*r[0] - K[1]*r[1])/det;
		d[1] = -(K[0]*r[1] - K[1]*r[0])/det;
		for (int half = 0; half < 60; half++, step /= 2.0L) {
			trial[0] = n[0] + step*d[0];
			trial[1] = n[1] + step*d[1];
			if (shoot(e, k, NULL, cable, trial) <=
			    energy + 1e-4L*step*(r[0]*d[0] + r[1]*d[1]) + 1e-17L*(N + W)*chord)
				break;
		}
		n[0] = trial[0];
		n[1] = trial[1];
	}
	return 0;
}

/* --- the certificate --- */

static double energy_of(const struct net_cable *cable, const struct hawser_net_statics *st)
{
	double L = cable->length0/cable->elements, w = cable->rho*cable->g*L, sum = 0.0;

	for (int i = 0; i < cable->elements; i++) {
		const double *a = st->point[i].x, *b = st->point[i + 1].x;
		double p = fmax(hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]) - L, 0.0);

		sum += cable->EA/L*p*p/2.0 + w*(a[1] + b[1])/2.0;
	}
	return sum;
}

/* The solution against the chain; then displaced: the gap must bound the energy that is too much. */
static void certified(unsigned number, double *off, double *force, double *sharp)
{
	struct net_cable cable = net_cable(7, number);
	double size = hypot(cable.d, cable.h), energy, (*x)[2] = calloc(101, sizeof *x);
	struct hawser_report report = {0};
	struct net_certificate before, after;
	struct hawser_net_statics st;
	struct hawser_net net;
	double half = cable.rho*cable.g*cable.length0/cable.elements/2.0;
	long double n[2];
	int bounded = 1, refused = 1;

	if (!x || net_cable_open(&net, &cable, &report) ||
	    hawser_net_solve(&st, &net, NULL, &report) ||
	    net_certify(&before, &net, &st, &report) || !chain(n, x, &cable)) {
		ok(0, "cable %u: %s", number, report.message);
		free(x);
		return;
	}
	for (int i = 0; i <= cable.elements; i++)
		*off = fmax(*off, hypot(st.point[i].x[0] - x[i][0], st.point[i].x[1] - x[i][1])/size);
	/* at the end half an element of weight is added to its force */
	*force = fmax(*force, fabs(st.member[0].T_from/(double)hypotl(n[0], n[1] - half) - 1.0));
	energy = energy_of(&cable, &st);
	for (double part = 1e-1; part > 1e-3; part /= 7.0) {
		int i = 1 + (int)(number % (unsigned)(cable.elements - 1));
		double more;

		st.point[i].x[number % 3] += part*size;
		if (net_certify(&after, &net, &st, &report))
			ok(0, "cable %u: %s", number, report.message);
		more = energy_of(&cable, &st) - energy;
		bounded &= after.gap >= more*(1.0 - 1e-6);
		refused &= !after.right;
		*sharp = fmax(*sharp, after.gap/more);
		st.point[i].x[number % 3] -= part*size;
	}
	if (!before.right || before.compressed > 0 || !bounded || !refused)
		ok(0, "cable %u: right %d, compressed %d, bounded %d, refused %d", number, before.right,
		   before.compressed, bounded, refused);
	hawser_net_statics_clear(&st);
	hawser_net_clear(&net);
	free(x);
}

static void certificates(void)
{
	double off = 0.0, force = 0.0, sharp = 0.0;

	for (unsigned i = 0; i < 40; i++)
		certified(i, &off, &force, &sharp);
	ok(off < 1e-9, "chains by shooting: %.1e of the chord off", off);
	ok(force < 1e-6, "and their first forces %.1e, where EA is up to 1e7 times the weight", force);
	ok(sharp >= 1.0, "certified, and refused if displaced: the gap is at most %.3g times the energy "
	   "that is too much", sharp);
}

/* --- the comparison --- */

static const struct net_score *score_of(const struct net_comparison *of,
                                               const char *name)
{
	for (int w = 0; w < of->ways; w++)
		if (!strcmp(of->score[w].way->name, name))
			return &of->score[w];
	return NULL;
}

static void counts(const struct net_comparison *of)
{
	static const char *const certain[] = {"automatic", "interior-point", "mixed", "mixed/chord",
	                                      "forces"};
	double *value = calloc((size_t)of->nets, sizeof *value);

	for (int w = 0; w < of->ways; w++) {
		const struct net_score *score = &of->score[w];
		double best = INFINITY;

		ok(score->solved + score->compressed + score->failed == of->nets && score->wrong == 0,
		   "%s: %d solved, %d compressed, %d failed, %d wrong; median %g iterations",
		   score->way->name, score->solved, score->compressed, score->failed, score->wrong,
		   score->iterations[0]);
		for (int by = 0; value && by < 2; by++) {
			int finite = 0, rising = 1;

			net_comparison_profile(value, of, w, by);
			for (int i = 0; i < of->nets; i++) {
				finite += isfinite(value[i]) != 0;
				rising &= i == 0 || value[i] >= value[i - 1];
			}
			best = by ? best : value[0];
			if (finite != score->solved || !rising)
				ok(0, "%s: a profile that ends at %d", score->way->name, finite);
		}
		if (!(best >= 1.0) || (score->best > 0.0 && best > 1.0))
			ok(0, "%s: %g times as slow as the fastest, which it is for %g", score->way->name, best,
			   score->best);
	}
	for (int i = 0; i < 5; i++)
		ok(score_of(of, certain[i])->solved == of->nets, "%s solves all %d", certain[i], of->nets);
	free(value);
}

/* All 1600 cables. The figures are those of an independent program with other cables. */
static void all(void)
{
	static const struct {
		const char *name;
		double part, within;    /* solved; three standard deviations of two samples of 1600 */
		double iterations[3];   /* 0: not compared */
	} row[] = {
		{"mixed", 1.0, 0.0, {7, 10, 12}},
		{"interior-point", 1.0, 0.0, {11, 13, 17}},
		{"mixed/chord", 1.0, 0.0, {0}},
		{"two-sided", 0.298, 0.05, {0}},
		{"regularised", 0.650, 0.05, {0}},
	};
	struct hawser_report report = {0};

	for (size_t k = 0; k < sizeof row/sizeof *row; k++) {
		struct net_comparison of;
		struct net_comparison_options options = {.nets = ALL, .way = row[k].name, .repeats = 1};

		if (!ok(!net_compare(&of, &options, &report), "%s: %s", row[k].name, report.message))
			continue;
		close_to(of.score->solved/(double)ALL, row[k].part, row[k].within, row[k].name);
		ok(of.score->wrong == 0, "%s: none wrong", row[k].name);
		for (int i = 0; i < 3 && row[k].iterations[i] > 0.0; i++)
			ok(of.score->iterations[i] == row[k].iterations[i], "%s: %g iterations", row[k].name,
			   of.score->iterations[i]);
		net_comparison_clear(&of);
	}
}

CASE(property_net_profile)
{
	struct net_comparison of;
	struct net_comparison_options options = {.nets = FEW, .seed = 3, .steps = 2000,
	                                                .repeats = 1};
	struct hawser_report report = {0};

	certificates();
	if (ok(!net_compare(&of, &options, &report), "comparison: %s", report.message)) {
		counts(&of);
		ok(score_of(&of, "two-sided")->compressed > 0, "two-sided ends with compressed elements");
		ok(score_of(&of, "regularised")->failed > 0, "regularised fails for some");
		net_comparison_clear(&of);
	}
	options.way = "newton";
	ok(net_compare(&of, &options, &report) == HAWSER_ERR_ARGUMENT &&
	   strstr(report.message, "there is no method newton"), "a wrong name: %s", report.message);
	if (getenv("HAWSER_LONG"))
		all();
	return done_testing();
}
