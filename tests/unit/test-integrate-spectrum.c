/* Amplitude spectra: tones on bins and between bins, the mean, and a second route to every number.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/integrate-models.h"

#define ROWS 1024

static double frequency[ROWS], amplitude[ROWS], samples[ROWS];
static int bins;

/* samples = mean + amplitude a at `cycles` in the whole record, phase p */
static void tone(int rows, double a, double cycles, double p)
{
	for (int i = 0; i < rows; i++)
		samples[i] += a*cos(2.0*M_PI*cycles*i/rows + p);
}

static void fill(int rows, double mean)
{
	for (int i = 0; i < rows; i++)
		samples[i] = mean;
}

static void transform(int rows, double dt)
{
	if (hawser_spectrum(frequency, amplitude, &bins, samples, rows, dt, NULL)) {
		printf("Bail out! no spectrum\n");
		exit(1);
	}
}

static double largest_outside(int low, int high)
{
	double worst = 0.0;

	for (int b = 0; b < bins; b++)
		if (b < low || b > high)
			worst = fmax(worst, amplitude[b]);
	return worst;
}

static void check_tones(void)
{
	fill(ROWS, 0.0);
	tone(ROWS, 2.385, 37.0, 0.4);
	transform(ROWS, 0.02);
	ok(bins == ROWS/2 + 1, "%d bins", bins);
	close_to(frequency[37], 37.0/(ROWS*0.02), 1e-15, "frequency of bin 37");
	close_to(amplitude[37], 2.385, 1e-13, "a tone on a bin shows its amplitude");
	close_to(amplitude[36], 2.385/2.0, 1e-13, "half of it below");
	close_to(amplitude[38], 2.385/2.0, 1e-13, "half of it above");
	ok(largest_outside(36, 38) < 1e-13, "and nothing elsewhere: %.1e", largest_outside(36, 38));

	fill(ROWS, 0.0);
	tone(ROWS, 2.385, 37.5, 0.4);
	transform(ROWS, 0.02);
	close_to(amplitude[37], 2.385*8.0/(3.0*M_PI), 1e-4, "half-way below: 8/(3 pi) of it");
	close_to(amplitude[38], 2.385*8.0/(3.0*M_PI), 1e-4, "half-way above: the same");
	ok(largest_outside(27, 48) < 2e-3*2.385, "ten bins away, below 2e-3 of it");

	fill(ROWS, 0.0);
	tone(ROWS, 1.0, 40.0, 0.1);
	tone(ROWS, 1e-6, 55.0, 1.7);
	transform(ROWS, 1.0);
	close_to(amplitude[40], 1.0, 1e-13, "two tones: the strong one");
	/* round-off of the strong tone: 1e-14 of it */
	close_to(amplitude[55], 1e-6, 1e-8, "and one a million times weaker");
}

static void check_mean(void)
{
	fill(ROWS, 0.0);
	tone(ROWS, 0.7, 12.3, 0.9);
	transform(ROWS, 1.0);
	ok(amplitude[0] < 1e-15, "bin 0 is empty: %.1e", amplitude[0]);

	double bin12 = amplitude[12], bin1 = amplitude[1];

	fill(ROWS, 1234.5);
	tone(ROWS, 0.7, 12.3, 0.9);
	transform(ROWS, 1.0);
	close_to(amplitude[12], bin12, 1e-11, "a mean of 1234.5 changes nothing");
	close_to(amplitude[1], bin1, 1e-9, "not even next to bin 0");
	fill(ROWS, -3.25);
	transform(ROWS, 1.0);
	ok(largest_outside(1, 0) < 1e-15, "a constant has no spectrum: %.1e", largest_outside(1, 0));
}

/* Against the sum of the definition, for an even and an odd length, including the Nyquist bin. */
static void check_sum(int rows)
{
	double worst = 0.0, mean = 0.0, sum = 0.0;
	uint64_t seed = 7;

	for (int i = 0; i < rows; i++)
		samples[i] = model_random(&seed);
	transform(rows, 0.5);
	for (int i = 0; i < rows; i++) {
		double w = 0.5 - 0.5*cos(2.0*M_PI*i/rows);

		sum += w;
		mean += w*samples[i];
	}
	mean /= sum;
	for (int b = 0; b < bins; b++) {
		double re = 0.0, im = 0.0, side = b == 0 || 2*b == rows ? 1.0 : 2.0;

		for (int i = 0; i < rows; i++) {
			double x = (0.5 - 0.5*cos(2.0*M_PI*i/rows))*(samples[i] - mean);

			re += x*cos(2.0*M_PI*b*i/rows);
			im += x*sin(2.0*M_PI*b*i/rows);
		}
		worst = fmax(worst, fabs(amplitude[b] - side*hypot(re, im)/sum));
	}
	ok(bins == rows/2 + 1 && worst < 1e-14, "%d samples: the plain sum within %.1e", rows, worst);
}

/* Windows of whole periods, by the amplitude of a sine in them. */
static void check_window(void)
{
	struct hawser_spectrum_window w = hawser_spectrum_window(101, 5.0);

	ok(w.rows == 100 && w.periods == 20.0 && w.off == 0.0 && w.loss == 0.0,
	   "101 samples, 5 to a period: %d", w.rows);
	w = hawser_spectrum_window(101, 10.0/3.0);
	ok(w.rows == 100 && w.off == 0.0, "3 periods of 10 samples: %d", w.rows);
	w = hawser_spectrum_window(99, 100.0/7.0); /* 57 intervals are 3.99 periods */
	ok(w.rows == 57 && fabs(w.off + 0.01) < 1e-12, "7 periods of 100 do not fit: %d", w.rows);
	for (int k = 0; k < 4; k++) {
		double period = (const double[]){5.0, 7.5, 2.0*M_PI, 23.85}[k];
		int bin;

		w = hawser_spectrum_window(397, period);
		bin = (int)lround(w.periods);
		fill(w.rows, 0.3);
		tone(w.rows, 2.385, w.periods, 0.4);
		transform(w.rows, 0.02);
		ok(w.rows > 198 && w.rows <= 397 && fabs(w.off) < 0.02, "period %g: %d rows, off by %g",
		   period, w.rows, w.off);
		close_to(amplitude[bin], 2.385*(1.0 - w.loss), 1e-6, "it shows what the loss says");
	}
	w = hawser_spectrum_window(10, 40.0);
	ok(w.rows == 10 && w.off < -0.5 && w.loss > 0.15, "less than a period: off by %g", w.off);
}

static void check_refusals(void)
{
	struct hawser_report report = {0};

	fill(16, 1.0);
	ok(hawser_spectrum(frequency, amplitude, &bins, samples, 3, 1.0, &report) ==
	   HAWSER_ERR_ARGUMENT && strstr(report.message, "4"), "three samples: %s", report.message);
	ok(hawser_spectrum(frequency, amplitude, &bins, samples, 16, 0.0, &report) ==
	   HAWSER_ERR_ARGUMENT && strstr(report.message, "interval"), "dt 0: %s", report.message);
	samples[5] = NAN;
	ok(hawser_spectrum(frequency, amplitude, &bins, samples, 16, 1.0, &report) ==
	   HAWSER_ERR_NAN && strstr(report.message, "sample 5"), "NaN: %s", report.message);
}

/* 400 samples of a tone of 3.7 and of a small one, `cycles` in all of them, dt 0.05: what is folded. */
static void check_line_above(double cycles, double small, double at, double times)
{
	static double rates[ROWS];
	double span = 400*0.05, folded, where;

	fill(400, 0.7);
	tone(400, 3.7, 31.3, 0.4);
	tone(400, small, cycles, 1.1);
	for (int i = 0; i < 400; i++)
		rates[i] = -2.0*M_PI/span*(3.7*31.3*sin(2.0*M_PI*31.3*i/400 + 0.4) +
		                           small*cycles*sin(2.0*M_PI*cycles*i/400 + 1.1));
	ok(!hawser_spectrum_folded(&folded, &where, samples, rates, 400, 0.05, NULL), "%g cycles", cycles);
	if (times > 0.0) {
		close_to(folded, times*small, 2e-3, "its amplitude");
		close_to(where*span, at, 1e-12, "and where it appears");
	} else {
		ok(folded < 2e-5*3.7, "nothing is folded: %.1e", folded/3.7);
	}
}

static void check_lines_above(void)
{
	check_line_above(150.0, 0.02, 150.0, 0.0);
	check_line_above(337.0, 0.02, 63.0, 1.0);
	check_line_above(369.0, 0.02, 31.0, 1.0); /* under the large line */
	check_line_above(437.0, 0.02, 37.0, 1.0);
	check_line_above(763.0, 0.02, 37.0, 2.0);
}

/* The spectrum of a run of a Duffing oscillator: odd harmonics only. */
static void check_run(void)
{
	const double initial[2] = {1.0, 0.0};
	struct hawser_rom rom = model_oscillator(0.0, 1.0, 1.0, 0.0);
	/* period 4 K(1/2)/sqrt(2), K(m = 1/4) = 1.685750354812596 */
	double period = 4.0*1.685750354812596/sqrt(2.0);
	struct hawser_trajectory run = model_run(&rom, NULL, 0.0, 16.0*period, period/64.0, 1e-12,
	                                         initial);

	for (int i = 0; i < ROWS; i++)
		samples[i] = run.state[2*i];
	transform(ROWS, period/64.0);
	close_to(frequency[16], 1.0/period, 1e-12, "bin 16 is the oscillator's frequency");
	ok(amplitude[16] > 0.9 && amplitude[48] > 0.01 && amplitude[48] < 0.05,
	   "first harmonic %.4f, third %.4f", amplitude[16], amplitude[48]);
	ok(amplitude[32] < 1e-10 && amplitude[64] < 1e-10, "no even ones: %.1e", amplitude[32]);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
}

CASE(unit_integrate_spectrum)
{
	check_tones();
	check_mean();
	check_sum(37);
	check_sum(48);
	check_window();
	check_lines_above();
	check_refusals();
	check_run();
	return done_testing();
}
