/* Curves of invariant circles of a forced Rayleigh oscillator from its torus points to the ends of the
 * range: growth against the eigenvalues of Jorba's operator, and against the model in reversed time,
 * whose circles are the same and repel; amplitudes against a long integration by another method, on the
 * circle and from beside it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>
#include <unistd.h>

#include <hawser/integrate.h>

#include "response/torus/torus.h"
#include "tests/tap.h"

#define MODEL(D, c) "{\"hawser_rom\": 1, \"n\": 1, \"K\": [[1]], \"D\": [[" D "]], " \
	"\"terms\": [[0, [], [0, 0, 0], " c "]], \"harmonics\": [{\"k\": 1, \"f\": [0.5]}]}"
enum { PERIODS = 400, SAMPLES = 100 };

static struct hawser_report report;

static int open_model(struct hawser_rom *rom, const char *text)
{
	char path[] = "/tmp/hawser-tori-XXXXXX";
	int file = mkstemp(path), fine;

	fine = file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text) && !close(file) &&
	       !hawser_rom_open(rom, path, &report);
	unlink(path);
	return fine;
}

/* The model in reversed time has the orbit with the other sign of the velocity. */
static int trace(struct hawser_tori *tori, const struct hawser_rom *rom, const struct hawser_frf *frf,
                 int event, int max_points)
{
	struct hawser_tori_options options = {.from = 0.72, .to = 1.3, .max_points = max_points};

	return !hawser_tori_trace(tori, rom, frf, event, &options, &report);
}

/* Eigenvalues of Jorba's operator at a circle: several with the modulus that `growth` says, and 1. */
static void operator(const struct hawser_rom *rom, const struct hawser_frf *frf, int event)
{
	enum { N = 41, SIZE = 2*N };
	static double matrix[SIZE*SIZE], re[SIZE], im[SIZE];
	double exponent[2] = {0.0}, error = 1.0, trivial = 1.0;
	struct hawser__torus torus;
	int near = 0, fine;

	fine = !hawser__torus_open(&torus, rom, N, frf->event[event].omega, &report) &&
	       !hawser__torus_begin(&torus, frf->event_state + 2*event, frf->event[event].omega, 0.4,
	                            &report) && !hawser__torus_correct(&torus, 1, &report) &&
	       !hawser__torus_growth(&torus, exponent, &error);
	for (int i = 0; i < N; i++)
		for (int j = 0; j < N; j++)
			for (int a = 0; a < 4; a++)
				matrix[(2*i + a/2)*SIZE + 2*j + a%2] = torus.A[4*j + a]*hawser__torus_cardinal(
					N, 2.0*M_PI*(i - j)/N - torus.rho, 0);
	fine = fine && !LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', SIZE, matrix, SIZE, re, im, NULL, SIZE,
	                              NULL, SIZE);
	for (int k = 0; k < SIZE; k++) {
		trivial = fmin(trivial, hypot(re[k] - 1.0, im[k]));
		near += fabs(log(hypot(re[k], im[k])) - exponent[0]) < 1e-6;
	}
	ok(fine && error < 1e-6 && exponent[0] < -1e-2 && near > 10 && trivial < 1e-8,
	   "growth %.9g (error %.1e): log of %d eigenvalues of Jorba's operator; one is 1 to %.1e",
	   exponent[0], error, near, trivial);
	hawser__torus_clear(&torus);
}

/* Least and greatest amplitude of a period in a long motion from `state`, of which the first half is
 * left out. */
static void integrated(const struct hawser_rom *rom, const struct hawser_tori *tori, int i, double off)
{
	double T = 2.0*M_PI/tori->point[i].omega, least = INFINITY, most = 0.0;
	double state[2] = {off*tori->state[2*i], off*tori->state[2*i + 1]};
	struct hawser_integrate_options options = {.omega = tori->point[i].omega, .until = PERIODS*T,
		.every = T/SAMPLES, .method = "adams", .rtol = 1e-9, .atol = 1e-10, .initial = state};
	struct hawser_trajectory run;

	ok(!hawser_integrate(&run, rom, &options, &report), "integrated %s", report.message);
	for (int k = PERIODS/2; k < PERIODS; k++) {
		double top = 0.0;

		for (int s = 0; s <= SAMPLES; s++)
			top = fmax(top, fabs(run.state[2*(k*SAMPLES + s)]));
		least = fmin(least, top);
		most = fmax(most, top);
	}
	/* The integration sees as many periods only: their least amplitude is not less, and the nearest one
	 * to a kink is off by the slope, about 1, times 2 pi/PERIODS. */
	ok(least > tori->coordinate_least[i] - 2e-3 && least < tori->coordinate_least[i] + 0.06 &&
	   fabs(most - tori->coordinate_most[i]) < 1e-3,
	   "amplitudes at Omega %.6f from %.4f to %.4f, integrated %.4f to %.4f", tori->point[i].omega,
	   tori->coordinate_least[i], tori->coordinate_most[i], least, most);
	hawser_trajectory_clear(&run);
}

static void curve(const struct hawser_rom *rom, const struct hawser_frf *frf, int event)
{
	struct hawser_tori tori;
	double worst = 0.0, previous = 0.0;
	int shrinks = 0, unstable = 0;

	int fine = trace(&tori, rom, frf, event, 0);

	ok(fine && tori.points > 5, "%d circles from Omega %.6f %s",
	   tori.points, tori.from_at, report.message);
	for (int i = 0; i < tori.points; i++) {
		worst = fmax(worst, tori.point[i].error);
		shrinks += tori.point[i].size <= previous;
		unstable += tori.point[i].unstable > 0 || tori.point[i].growth >= 0.0;
		previous = tori.point[i].size;
	}
	ok(tori.end == HAWSER_TORI_RANGE && worst <= 1e-6 && !shrinks && !unstable,
	   "to the end of the range (%s), growing and attracting; largest error %.1e",
	   hawser_tori_end_name(tori.end), worst);
	ok(fabs(fmin(fabs(tori.point[tori.points - 1].omega - 0.72),
	             fabs(tori.point[tori.points - 1].omega - 1.3))) < 1e-12, "at Omega %.15g",
	   tori.point[tori.points - 1].omega);
	integrated(rom, &tori, tori.points/2, 1.0);
	integrated(rom, &tori, tori.points - 1, 1.1);
	hawser_tori_clear(&tori);
}

/* Circles and their growth in reversed time. */
static void reversed(const struct hawser_rom *rom, struct hawser_frf *frf, int event)
{
	struct hawser_tori ahead, back;
	struct hawser_rom mirror;
	double gap = 0.0, amplitude = 0.0;
	int fine, unstable = 0;

	fine = open_model(&mirror, MODEL("0.2", "-0.1")) && trace(&ahead, rom, frf, event, 12);
	frf->event_state[2*event + 1] *= -1.0;
	fine = fine && trace(&back, &mirror, frf, event, 12);
	ok(fine && ahead.points == 12 && back.points == 12, "in reversed time %s", report.message);
	frf->event_state[2*event + 1] *= -1.0;
	for (int i = 0; fine && i < back.points; i++) {
		gap = fmax(gap, fabs(ahead.point[i].growth + back.point[i].growth)/ahead.point[i].size);
		amplitude = fmax(amplitude, fabs(ahead.coordinate_most[i] - back.coordinate_most[i]) +
		                            fabs(ahead.coordinate_least[i] - back.coordinate_least[i]));
		unstable += back.point[i].unstable == 1;
	}
	ok(gap < 1e-5 && amplitude < 1e-3 && unstable == 12,
	   "the circles repel as they attract ahead: growth %.1e, amplitude %.1e, %d unstable", gap,
	   amplitude, unstable);
	hawser_tori_clear(&ahead);
	hawser_tori_clear(&back);
	hawser_rom_clear(&mirror);
}

static int stop(void *data, const struct hawser_progress_state *state)
{
	(void)data;
	return state->done == 3;
}

static void refused(const struct hawser_rom *rom, struct hawser_frf *frf, int event)
{
	struct hawser_tori_options options = {.from = 0.72, .to = 1.3}, empty = {.from = 1.0, .to = 1.0};
	struct hawser_tori_options stopped = {.from = 0.72, .to = 1.3, .progress = {stop, NULL}};
	struct hawser_frf without = *frf;
	struct hawser_rom large = *rom;
	struct hawser_tori tori;

	ok(hawser_tori_trace(&tori, rom, frf, -1, &options, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	ok(hawser_tori_trace(&tori, rom, frf, event, &empty, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	frf->period = 2;
	ok(hawser_tori_trace(&tori, rom, frf, event, &options, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	frf->period = 1;
	without.multiplier = calloc(4*(size_t)frf->points, sizeof(double));
	ok(without.multiplier &&
	   hawser_tori_trace(&tori, rom, &without, event, &options, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	free(without.multiplier);
	ok(!hawser_tori_trace(&tori, rom, frf, event, &stopped, &report) && tori.points == 3 &&
	   tori.end == HAWSER_TORI_INTERRUPTED, "interrupted");
	hawser_tori_clear(&tori);
	ok(trace(&tori, rom, frf, event, 4) && tori.points == 4 && tori.end == HAWSER_TORI_MAX_POINTS,
	   "ended by the number of points");
	hawser_tori_clear(&tori);
	options.most_circle = 21;
	options.tolerance = 1e-8;
	ok(!hawser_tori_trace(&tori, rom, frf, event, &options, &report) &&
	   tori.end == HAWSER_TORI_ROUGH && *tori.lost, "%s", tori.lost);
	hawser_tori_clear(&tori);
	options.most_circle = 3;
	ok(hawser_tori_trace(&tori, rom, frf, event, &options, &report) == HAWSER_ERR_CONVERGENCE, "%s",
	   report.message);
	hawser_tori_clear(&tori);
	large.n = 60;
	ok(hawser_tori_trace(&tori, &large, frf, event, &options, &report) == HAWSER_ERR_ARGUMENT, "%s",
	   report.message);
	hawser_tori_clear(NULL);
}

CASE(property_tori)
{
	struct hawser_frf_options options = {.from = 0.72, .to = 1.3};
	struct hawser_rom rom;
	struct hawser_frf frf;
	int last = -1;

	if (!ok(open_model(&rom, MODEL("-0.2", "0.1")) && !hawser_frf_trace(&frf, &rom, &options, &report),
	        "a response %s", report.message))
		return done_testing();
	for (int e = 0; e < frf.events; e++)
		if (frf.event[e].kind == HAWSER_TORUS) {
			curve(&rom, &frf, e);
			operator(&rom, &frf, e);
			last = e;
		}
	if (ok(last >= 0, "torus points")) {
		reversed(&rom, &frf, last);
		refused(&rom, &frf, last);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return done_testing();
}
