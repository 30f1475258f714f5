/* Invariant circles of the period map at a torus point of a forced Rayleigh oscillator: the distance in
 * Omega grows with the square of the size, the rotation number begins at the angle of the multiplier; a
 * long integration by another method stays on the circle and turns by the rotation number.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <unistd.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>

#include "response/torus/torus.h"
#include "tests/tap.h"

#define RAYLEIGH "{\"hawser_rom\": 1, \"n\": 1, \"K\": [[1]], \"D\": [[-0.2]], " \
	"\"terms\": [[0, [], [0, 0, 0], 0.1], " \
	"[0, [0, 0], [0], -0.05], [0, [0, 0, 0, 0, 0], [], 0.02]], \"harmonics\": [{\"k\": 1, " \
	"\"f\": [0.5]}]}"

static struct hawser_report report;

/* The polynomial at t. */
static void at(double out[2], const struct hawser__torus *torus, double t)
{
	int N = torus->points;

	out[0] = out[1] = 0.0;
	for (int i = 0; i < N; i++) {
		double s = t - 2.0*M_PI*i/N;
		double c = fabs(sin(0.5*s)) < 1e-12 ? 1.0 : sin(0.5*N*s)/(N*sin(0.5*s));

		out[0] += c*torus->x[2*i];
		out[1] += c*torus->x[2*i + 1];
	}
}

/* CVODE from a point of the circle: the largest distance after k periods from where the circle says. */
static void integrated(const struct hawser__torus *torus, const struct hawser_rom *rom)
{
	double T = 2.0*M_PI/torus->omega, gap = 0.0, want[2];
	struct hawser_integrate_options options = {.omega = torus->omega, .until = 40.0*T, .every = T,
		.method = "adams", .rtol = 1e-13, .atol = 1e-14, .initial = torus->x};
	struct hawser_trajectory run;

	ok(!hawser_integrate(&run, rom, &options, &report), "integrated %s", report.message);
	for (int k = 0; k < run.rows; k++) {
		at(want, torus, k*torus->rho);
		gap = fmax(gap, hypot(run.state[2*k] - want[0], run.state[2*k + 1] - want[1]));
	}
	ok(gap < 1e-9, "40 periods of CVODE stay within %.1e of the circle, and turn with it", gap);
	hawser_trajectory_clear(&run);
}

static void refused(const struct hawser_rom *rom, const struct hawser_frf *frf, int e)
{
	double omega = frf->event[e].omega;
	const double far[] = {1e9, 1e9};
	struct hawser__torus torus;
	int p = 0;

	while (p < frf->points - 1 && frf->multiplier[4*p + 1] != 0.0)
		p++;
	ok(!hawser__torus_open(&torus, rom, 9, omega, &report) &&
	   hawser__torus_begin(&torus, frf->state + 2*p, frf->point[p].omega, 0.01, &report) ==
	   HAWSER_ERR_ARGUMENT, "real multipliers: %s", report.message);
	hawser__torus_clear(&torus);
	ok(!hawser__torus_open(&torus, rom, 9, omega, &report) &&
	   hawser__torus_begin(&torus, far, omega, 0.01, &report) == HAWSER_ERR_CONVERGENCE,
	   "a motion that escapes: %s", report.message);
	hawser__torus_clear(&torus);
	ok(!hawser__torus_open(&torus, rom, 9, omega, &report) &&
	   !hawser__torus_begin(&torus, frf->event_state + 2*e, omega, 1e9, &report) &&
	   hawser__torus_correct(&torus, 1, &report) == HAWSER_ERR_CONVERGENCE, "too large: %s",
	   report.message);
	hawser__torus_clear(&torus);
}

CASE(property_torus)
{
	struct hawser_frf_options options = {.from = 0.8, .to = 1.3};
	char path[] = "/tmp/hawser-torus-XXXXXX";
	struct hawser_rom rom;
	struct hawser_frf frf;
	int file = mkstemp(path), fine;

	fine = file >= 0 && write(file, RAYLEIGH, strlen(RAYLEIGH)) == (ssize_t)strlen(RAYLEIGH) &&
	       !close(file) && !hawser_rom_open(&rom, path, &report);
	unlink(path);
	if (!ok(fine && !hawser_frf_trace(&frf, &rom, &options, &report), "a response %s", report.message))
		return done_testing();
	for (int e = 0; e < frf.events; e++) {
		double off[3], turn[3], angle;
		struct hawser__torus torus;

		if (frf.event[e].kind != HAWSER_TORUS)
			continue;
		for (int s = 0; s < 3; s++) {
			fine = !hawser__torus_open(&torus, &rom, 41, frf.event[e].omega, &report) &&
			       !hawser__torus_begin(&torus, frf.event_state + 2*e, frf.event[e].omega,
			                            0.01*(1 << s), &report);
			angle = torus.rho;
			fine = fine && !hawser__torus_correct(&torus, 1, &report);
			ok(fine && torus.defect < 1e-11 && torus.tail < 1e-9,
			   "circle at Omega %.9g: rho %.9g, %d iterations, defect %.1e, tail %.1e %s",
			   torus.omega, torus.rho, torus.iterations, torus.defect, torus.tail, report.message);
			off[s] = torus.omega - frf.event[e].omega;
			turn[s] = torus.rho - angle;
			if (s == 2)
				integrated(&torus, &rom);
			hawser__torus_clear(&torus);
		}
		ok(fabs(off[1]/off[0] - 4.0) < 0.05 && fabs(off[2]/off[1] - 4.0) < 0.2,
		   "the distance grows with the square: %.3e %.3e %.3e", off[0], off[1], off[2]);
		ok(fabs(turn[0]) < 1e-2 && fabs(turn[1]/turn[0] - 4.0) < 0.1,
		   "so does the rotation number from the multiplier's: %.3e %.3e", turn[0], turn[1]);
	}
	for (int e = 0; e < frf.events; e++)
		if (frf.event[e].kind == HAWSER_TORUS)
			refused(&rom, &frf, e);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return done_testing();
}
