/* Harmonic balance of models with terms of any degree, against shooting, which evaluates the terms
 * along the motion: orbits, multipliers and events of random models with u'^3, u^2 u', u^5, u^3 u'^2
 * and terms of harmonics, with a power of Omega too; a chain that is large enough for the
 * factorisation by blocks; a closed form.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/frf.h>

#include "tests/tap.h"

#define TOLERANCE 1e-12

static struct hawser_report report;
static char text[20000];
static int length;

static double noise(unsigned *seed)
{
	*seed = *seed*1664525u + 1013904223u;
	return (*seed >> 8)/8388608.0 - 1.0;
}

static int open_text(struct hawser_rom *rom)
{
	char path[] = "/tmp/hawser-terms-XXXXXX";
	int file = mkstemp(path), fine = file >= 0 && write(file, text, (size_t)length) == length;

	if (file >= 0)
		close(file);
	report.message[0] = '\0';
	fine = fine && !hawser_rom_open(rom, path, &report);
	unlink(path);
	return fine || ok(0, "%s", report.message);
}

#define PUT(...) (length += snprintf(text + length, sizeof text - (size_t)length, __VA_ARGS__))

/* [n][n] with `own` near the diagonal's values. */
static void put_matrix(const char *key, int n, double own, double step, double other, unsigned *seed)
{
	PUT("\"%s\": [", key);
	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			PUT("%s%.6f%s", k ? ", " : j ? ", [" : "[",
			    j == k ? own + step*j + 0.1*own*noise(seed) : other*noise(seed),
			    k == n - 1 ? "]" : "");
	PUT("]");
}

static void put_factors(int count, int n, unsigned *seed)
{
	PUT("[");
	for (int i = 0; i < count; i++)
		PUT("%s%d", i ? ", " : "", (int)((noise(seed) + 1.0)*0.4999*n));
	PUT("], ");
}

static void put_terms(int count, int n, double size, unsigned *seed)
{
	static const int kind[][2] = {{0, 3}, {2, 1}, {5, 0}, {3, 2}, {1, 1}, {0, 2}, {1, 2}, {3, 0}};

	for (int i = 0; i < count; i++) {
		const int *of = kind[i%8];

		PUT("%s[%d, ", i ? ", " : "\"terms\": [", (int)((noise(seed) + 1.0)*0.4999*n));
		put_factors(of[0], n, seed);
		put_factors(of[1], n, seed);
		PUT("%.6f]", size*noise(seed));
	}
	PUT("]");
}

static void make(int n, unsigned seed)
{
	length = 0;
	PUT("{\"n\": %d, ", n);
	put_matrix("K", n, 1.0, 1.7, 0.1, &seed);
	PUT(", ");
	put_matrix("D", n, 0.08, 0.05, 0.02, &seed);
	PUT(", ");
	put_terms(8, n, 0.02, &seed);
	length--; /* of the bracket */
	for (int j = 0; j < n; j++) /* large motions decay */
		PUT(", [%d, [], [%d, %d, %d], 0.05], [%d, [%d, %d, %d], [], 0.2], "
		    "[%d, [%d, %d, %d, %d, %d], [], 0.05]", j, j, j, j, j, j, j, j, j, j, j, j, j, j);
	PUT("]");
	PUT(", \"harmonics\": [{\"k\": 1, \"f\": [0.22");
	for (int j = 1; j < n; j++)
		PUT(", %.6f", 0.1*noise(&seed));
	PUT("]}, {\"k\": 1, \"phase\": \"sin\", \"omega_power\": 1, ");
	put_terms(5, n, 0.02, &seed);
	PUT("}, {\"k\": 2, \"omega_power\": 2, ");
	put_terms(2, n, 0.01, &seed);
	PUT("}]}");
}

/* Both methods from the same frequency: the first points are motions at it. */
static void compare(int n, unsigned seed)
{
	struct hawser_frf_options options = {.from = 0.6, .to = 1.6, .tolerance = TOLERANCE,
		.event_tolerance = 1e-11, .max_points = 400};
	const char *method[2] = {"shooting", "balance"};
	struct hawser_frf frf[2] = {{0}};
	double gap = 0.0, size = 0.0, multiplier = 0.0, event = 0.0, product = 0.0;
	struct hawser_rom rom = {0};
	int same;

	make(n, seed);
	if (!open_text(&rom))
		return;
	for (int i = 0; i < 2; i++) {
		options.method = method[i];
		if (hawser_frf_trace(&frf[i], &rom, &options, &report))
			ok(0, "%s of model %u: %s", method[i], seed, report.message);
	}
	if (frf[0].points && frf[1].points) {
		for (int i = 0; i < 2*n; i++) {
			gap = fmax(gap, fabs(frf[0].state[i] - frf[1].state[i]));
			size = fmax(size, fabs(frf[0].state[i]));
		}
		for (int i = 0; i < 4*n; i++)
			multiplier = fmax(multiplier, fabs(frf[0].multiplier[i] - frf[1].multiplier[i]));
		for (int p = 0; p < frf[1].points; p++)
			product = fmax(product, frf[1].point[p].liouville);
		same = frf[0].events == frf[1].events;
		for (int e = 0; same && e < frf[0].events; e++)
			event = fmax(event, frf[0].event[e].kind == frf[1].event[e].kind
			                    ? fabs(frf[0].event[e].omega/frf[1].event[e].omega - 1.0) : 1.0);
		ok(gap < 1e-10*size && multiplier < 1e-9 && product < 1e-9,
		   "model %u of %d: both methods to %.1e, multipliers to %.1e, Liouville %.1e", seed, n,
		   gap/size, multiplier, product);
		ok(same && event < 1e-8, "and %d and %d events, the same to %.1e", frf[0].events,
		   frf[1].events, event);
		ok(frf[1].sampled > 0 && frf[1].sample_gap < 1e-8 && !frf[1].sample_disagreements,
		   "%d points again by shooting: to %.1e", frf[1].sampled, frf[1].sample_gap);
	}
	hawser_frf_clear(&frf[0]);
	hawser_frf_clear(&frf[1]);
	hawser_rom_clear(&rom);
}

/* u'' + c u'^5 + u = F cos(t): at Omega = 1 the damping alone balances the load, c (5/8) v^5 = F for
 * the amplitude v, up to higher harmonics of relative order c^2 v^8. */
static void check_closed_form(void)
{
	struct hawser_frf_options options = {.from = 0.9, .to = 1.0, .method = "balance"};
	struct hawser_frf frf = {0};
	struct hawser_rom rom = {0};

	length = 0;
	PUT("{\"n\": 1, \"K\": [[1]], \"terms\": [[0, [], [0, 0, 0, 0, 0], 1e-4]], "
	    "\"harmonics\": [{\"k\": 1, \"f\": [6.25e-5]}]}");
	if (!open_text(&rom))
		return;
	if (ok(!hawser_frf_trace(&frf, &rom, &options, &report), "a damper of fifth order %s",
	       report.message))
		close_to(frf.coordinate[frf.points - 1], 1.0, 1e-5, "its amplitude, 5/8 c v^5 = F");
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

/* A chain with u'^3 in each link, whose matrix is factorised by blocks. */
static void check_chain(int n)
{
	struct hawser_frf_options options = {.from = 0.3, .to = 0.305, .method = "balance",
		.tolerance = 1e-8};
	struct hawser_frf frf = {0};
	struct hawser_rom rom = {0};

	length = 0;
	PUT("{\"n\": %d, \"terms\": [[0, [], [0, 0, 0], 0.2]", n);
	for (int j = 1; j < n; j++)
		PUT(", [%d, [], [%d, %d, %d], 0.1], [%d, [%d, %d, %d, %d, %d], [], 0.05], "
		    "[%d, [%d, %d], [], 0.2]", j, j, j - 1, j, j, j, j, j, j, j, j, j, j);
	for (int m = 0; m < 2; m++)
		for (int e = 0; e < n*n; e++) {
			int j = e/n, k = e%n;

			PUT("%s%.6g%s", e ? k ? ", " : ", [" : m ? "], \"D\": [[" : "], \"K\": [[",
			    (m ? 0.02 : 1.0)*(j == k ? 2.0 : abs(j - k) == 1 ? -1.0 : 0.0),
			    k == n - 1 ? "]" : "");
		}
	PUT("], \"harmonics\": [{\"k\": 1, \"f\": [0.1");
	for (int j = 1; j < n; j++)
		PUT(", %g", 0.02*(j%3));
	PUT("]}]}");
	if (!open_text(&rom))
		return;
	if (ok(!hawser_frf_trace(&frf, &rom, &options, &report), "a chain of %d %s", n, report.message)) {
		ok(frf.point[0].steps*n > 150, "%d coefficients a coordinate: by blocks",
		   frf.point[0].steps);
		ok(frf.sampled > 0 && frf.sample_gap < 1e-6 && !frf.sample_disagreements,
		   "%d points again by shooting: to %.1e", frf.sampled, frf.sample_gap);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(property_balance_terms)
{
	int more = getenv("HAWSER_LONG") ? 60 : 3;

	check_closed_form();
	for (int i = 0; i < more; i++)
		compare(1 + i%3, 7u + 13u*(unsigned)i);
	check_chain(12);
	return done_testing();
}
