/* Models in the coordinates of their modes: u = V q moves as before, and K is diagonal; refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/rom.h>

#include "tests/tap.h"

enum { N = 3 };

static const char text[] =
	"{\"hawser_rom\": 1, \"n\": 3,%s"
	" \"K\": [[3, -1, 0.2], [-1, 2, -0.5], [0.2, -0.5, 4]],"
	" \"D\": [[0.2, 0.05, 0], [-0.03, 0.1, 0], [0, 0.02, 0.3]],"
	" \"Q\": [[0, 0, 1, 0.7], [1, 2, 2, -0.4], [2, 0, 2, 1.1]],"
	" \"C\": [[0, 0, 0, 1, 0.3], [1, 1, 1, 1, 0.5], [2, 0, 1, 2, -0.6]],%s"
	" \"harmonics\": [{\"k\": 1, \"phase\": \"cos\", \"f\": [0.1, 0, 0.2],"
	" \"K\": [[0, 0.1, 0], [0, 0, 0], [0.2, 0, 0]]},"
	" {\"k\": 2, \"phase\": \"sin\", \"f\": [0, 0.3, 0], \"Q\": [[1, 0, 2, 0.8]]}]}";

static enum hawser_status open_with(struct hawser_rom *rom, const char *mass, const char *more,
                               struct hawser_report *report)
{
	FILE *stream = fopen("modal.json", "w");

	if (!stream)
		return HAWSER_ERR_IO;
	fprintf(stream, text, mass, more);
	fclose(stream);
	return hawser_rom_open(rom, "modal.json", report);
}

static void multiply(double *u, const double *V, const double *q)
{
	for (int j = 0; j < N; j++) {
		u[j] = 0.0;
		for (int i = 0; i < N; i++)
			u[j] += V[j*N + i]*q[i];
	}
}

/* The accelerations of both models in the same motion. */
static double difference(const struct hawser_rom *old, const struct hawser_rom *modal, const double *V)
{
	static const double q[N] = {0.31, -0.42, 0.23}, p[N] = {-0.11, 0.37, 0.19};
	double u[N], v[N], a[N], b[N], c[N], worst = 0.0;

	multiply(u, V, q);
	multiply(v, V, p);
	for (double tau = 0.1; tau < 6.0; tau += 0.7) {
		hawser_rom_acceleration(old, a, u, v, tau, 1.3);
		hawser_rom_acceleration(modal, b, q, p, tau, 1.3);
		multiply(c, V, b);
		for (int j = 0; j < N; j++)
			worst = fmax(worst, fabs(c[j] - a[j]));
	}
	return worst;
}

static void turned(const char *mass)
{
	struct hawser_rom old = {0}, modal = {0};
	struct hawser_report report = {.message = ""};
	double V[N*N], off = 0.0;

	if (!ok(!open_with(&old, mass, "", &report) && !open_with(&modal, mass, "", &report) &&
	        !hawser_rom_modal(&modal, V, &report), "in the coordinates of its modes%s %s",
	        *mass ? ", with a mass" : "", report.message))
		return;
	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++)
			off = fmax(off, i == j ? modal.K[i*N + i] <= (i ? modal.K[(i - 1)*(N + 1)] : 0.0)
			                       : fabs(modal.K[i*N + j]));
	ok(off == 0.0, "  K is diagonal, ascending (%g)", off);
	off = difference(&old, &modal, V);
	ok(off < 1e-13, "  the same motion (%g)", off);
	hawser_rom_clear(&old);
	hawser_rom_clear(&modal);
}

static void refused(const char *more, const char *why)
{
	struct hawser_rom rom = {0};
	struct hawser_report report = {.message = ""};
	double V[N*N];
	enum hawser_status status = open_with(&rom, "", more, &report);

	ok(!status && hawser_rom_modal(&rom, V, &report) && strstr(report.message, why), "refused: %s: %s",
	   why, report.message);
	hawser_rom_clear(&rom);
}

CASE(property_rom_modal)
{
	turned("");
	turned(" \"M\": [[2, 0.3, 0], [0.3, 1, 0.1], [0, 0.1, 1.5]],");
	refused(" \"terms\": [[0, [0, 0], [1], 0.4]],", "terms");
	return done_testing();
}
