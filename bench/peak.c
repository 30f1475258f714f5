/* bench/peak.c - cost of a point of a response compared with the peak performance of the processor.
 *
 *   peak [SCENE]
 *
 * The peak is measured on one core: independent multiply-adds in registers, with vectors of 256 and
 * of 512 bits, and a dgemm of order 1000. Then, for condensed models of the scene of increasing
 * size, the response from 0.6 to 3.3 times the first frequency at the default tolerance: time and
 * counted additions and multiplications per point; and a period map with its derivatives alone.
 *
 * Operations are counted as the method requires them (hawser_orbit_cost). Padding of vectors with
 * zeros, the multipliers, the condition estimate and the amplitudes are not counted, but are
 * included in the time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/hawser.h>

#include "bench/clock.h"
#include "core/hot.h"
#include "response/time/flow.h"

enum { ORDER = 1000, TURNS = 5, SEGMENTS = 4 };
static const double time_limit_secs = 0.1;

static volatile double sink; /* keeps the results alive */

/* `count` times 12 independent multiply-adds of vectors in registers. */
#define MULTIPLY_ADDS(name, type) \
	static double name(long count) \
	{ \
		type x[12], a = {1.0}, b = {1e-9}; \
		double sum = 0.0; \
		for (int i = 0; i < 12; i++) \
			x[i] = a*(double)i; \
		for (long c = 0; c < count; c++) { \
			HAWSER_UNROLL \
			for (int i = 0; i < 12; i++) \
				x[i] = x[i]*a + b; \
		} \
		for (int i = 0; i < 12; i++) \
			sum += x[i][0]; \
		return sum; \
	}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
typedef double wide __attribute__((vector_size(64), aligned(8), may_alias));

__attribute__((target("arch=x86-64-v3"))) MULTIPLY_ADDS(multiply_adds, hawser__vec)
__attribute__((target("arch=x86-64-v4"))) MULTIPLY_ADDS(wide_multiply_adds, wide)
#define HAVE_WIDE (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl"))
#define HAVE_FMA (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#else
MULTIPLY_ADDS(multiply_adds, hawser__vec)
#define wide_multiply_adds multiply_adds
#define HAVE_WIDE 0
#define HAVE_FMA 1
#endif

/* Gflop/s of a loop of multiply-adds on vectors of `lanes`: the best of five. */
static double loop_peak(double (*loop)(long), int lanes)
{
	double best = 0.0;

	for (int turn = 0; turn < TURNS; turn++) {
		long count = 3000000;
		double start = cpu_secs();

		sink = loop(count);
		best = fmax(best, 2e-9*12.0*lanes*(double)count/(cpu_secs() - start));
	}
	return best;
}

static double dgemm_peak(void)
{
	size_t size = (size_t)ORDER*ORDER;
	double *a = malloc(3*size*sizeof *a), best = 0.0;

	if (!a)
		return 0.0;
	for (size_t i = 0; i < 3*size; i++)
		a[i] = 1.0/(double)(i + 1);
	for (int turn = 0; turn < TURNS; turn++) {
		double start = cpu_secs();

		cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, ORDER, ORDER, ORDER, 1.0, a,
		            ORDER, a + size, ORDER, 0.0, a + 2*size, ORDER);
		best = fmax(best, 2e-9*ORDER*(double)size/(cpu_secs() - start));
	}
	sink = a[2*size];
	free(a);
	return best;
}

static enum hawser_status model(struct hawser_rom *rom, const char *path, int n,
                                struct hawser_report *report)
{
	const char *const sets[] = {"model.condense=static"};
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes = {.n = 0};
	struct hawser_modes_options options = {.n = n, .tolerance = 1e-11};
	enum hawser_status status = hawser_scene_open(&scene, path, sets, 1, report);

	if (status)
		return status;
	if (!(status = hawser_statics_scene(&statics, &scene, report)) &&
	    !(status = hawser_modes_solve(&modes, &statics, &options, report)))
		status = hawser_rom_build(rom, &modes, &scene, report);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return status;
}

/* Gflop/s of the period map with derivatives: four segments of ten steps from a small state. */
static double flow_rate(const struct hawser_rom *rom)
{
	size_t m = 2*(size_t)rom->n;
	double *x = calloc(SEGMENTS*m*(m + 2), sizeof *x), best = 0.0, omega = 1.1*sqrt(rom->K[0]);
	struct hawser__stretch stretch = {0.0, M_PI/20.0, 10, SEGMENTS, M_PI/2.0};
	struct hawser__flow flow;

	if (!x || hawser__flow_init(&flow, rom, NULL)) {
		free(x);
		return 0.0;
	}
	for (int turn = 0; turn < TURNS; turn++) {
		double start = cpu_secs(), before = flow.flops;

		while (cpu_secs() < start + time_limit_secs) {
			for (size_t i = 0; i < SEGMENTS*m; i++)
				x[i] = 1e-3*(double)(i%7);
			hawser__flow_derive(&flow, x, x + 2*SEGMENTS*m, x + SEGMENTS*m, NULL, &stretch,
			                    omega);
		}
		best = fmax(best, 1e-9*(flow.flops - before)/(cpu_secs() - start));
	}
	hawser__flow_clear(&flow);
	free(x);
	return best;
}

static int run(const char *path, int n, double peak)
{
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {.points = 0};
	struct hawser_report report = {.message = ""};
	struct hawser_frf_options options = {.method = NULL};
	double best = INFINITY, liouville = 0.0, gflops, flow;
	int failed = 1;

	options.method = "shooting";
	if (model(&rom, path, n, &report))
		goto done;
	options.from = 0.6*sqrt(rom.K[0]);
	options.to = 3.3*sqrt(rom.K[0]);
	options.step_max = 0.005;
	for (int turn = 0; turn < 3; turn++) {
		double start = cpu_secs();

		hawser_frf_clear(&frf);
		if (hawser_frf_trace(&frf, &rom, &options, &report))
			goto done;
		best = fmin(best, cpu_secs() - start);
	}
	for (int i = 0; i < frf.points; i++)
		liouville = fmax(liouville, frf.point[i].liouville);
	gflops = 1e-9*frf.cost.flops/best;
	flow = flow_rate(&rom);
	printf("%4d %8d %7d %7d %10.1e %10.1f %12.1f %9.2f %7.1f %% %9.2f %7.1f %%\n", n,
	       rom.quads + rom.cubics, frf.points, frf.events, liouville, 1e6*best/frf.points,
	       1e-3*frf.cost.flops/frf.points, gflops, 100.0*gflops/peak, flow, 100.0*flow/peak);
	failed = 0;
done:
	if (failed)
		fprintf(stderr, "peak: %d modes: %s\n", n, report.message);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return failed;
}

int main(int argc, char **argv)
{
	static const int sizes[] = {3, 5, 8, 12, 16};
	double narrow, broad, dgemm, peak;
	int failed = 0;

	if (argc != 2) {
		fputs("peak: give a scene\n", stderr);
		return 1;
	}
	narrow = HAVE_FMA ? loop_peak(multiply_adds, 4) : 0.0;
	broad = HAVE_WIDE ? loop_peak(wide_multiply_adds, 8) : 0.0;
	dgemm = dgemm_peak();
	peak = fmax(narrow, dgemm);
	printf("peak of one core, Gflop/s: multiply-adds of 256 bits %.1f, of 512 bits %.1f, dgemm of "
	       "order %d %.1f\nparts are of %.1f, the larger of the first and the last\n", narrow,
	       broad, ORDER, dgemm, peak);
	puts("   n monomials  points  events  Liouville  us/point  kflop/point   Gflop/s  of peak  "
	     "flow Gflop/s  of peak");
	for (size_t i = 0; i < sizeof sizes/sizeof *sizes; i++)
		failed |= run(argv[1], sizes[i], peak);
	return failed;
}
