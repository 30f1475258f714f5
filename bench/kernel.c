/* bench/kernel.c - evaluations per second of a reduced model's restoring force and of its tangent,
 * against a naive dense loop over all n^3 and n^4 entries (nested as in Horner's scheme, to avoid
 * needless products). Verifies before it times.
 *
 * The models are derivatives of a random potential V = sum_{a<=b<=c} q_abc u_a u_b u_c +
 * sum_{a<=b<=c<=d} c_abcd u_a u_b u_c u_d. In the case "parity-sparse" the even coordinates
 * represent out-of-plane modes, which enter every monomial an even number of times, as for a span
 * at rest; other monomials are zero. The naive loop uses the third and fourth derivatives of V, not
 * the library's list of monomials, so that an error in one does not cancel in the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/rom.h>
#include "bench/clock.h"
#include "bench/kernel.h"
#include "rom/energy/kernel.h"

enum { states = 64 };                  /* different u, so that no loop can be hoisted */
static const double time_limit_secs = 0.25; /* of each timing */
static const double error_allowed = 1e-13;  /* relative to the sum of the moduli of the terms */

/* The naive model: full arrays. Q and C are coefficients of the force from the second and third
 * derivatives: r_j = K_jk u_k + Q_jkl u_k u_l + C_jklm u_k u_l u_m, symmetric in all indices. */
struct dense {
	int n;
	double *K, *Q, *C;
};

static uint64_t seed = 88172645463325252u;

static double uniform(void) /* in (-1, 1) */
{
	seed ^= seed << 13;
	seed ^= seed >> 7;
	seed ^= seed << 17;
	return (double)(int64_t)seed/9223372036854775808.0;
}

/* Number of distinct permutations of `count` sorted indices. */
static int orders(const int *index, int count)
{
	int total = 1, run = 1;

	for (int i = 1; i < count; i++) {
		run = index[i] == index[i - 1] ? run + 1 : 1;
		total = total*(i + 1)/run;
	}
	return total;
}

/* 1 if the potential may contain a monomial of these coordinates. */
static int allowed(const int *index, int count, int parity)
{
	int even = 0;

	for (int i = 0; i < count; i++)
		even += index[i] % 2 == 0;
	return !parity || even % 2 == 0;
}

static void insert(int *sorted, const int *index, int count)
{
	for (int i = 0; i < count; i++) {
		int at = i;

		for (; at > 0 && sorted[at - 1] > index[i]; at--)
			sorted[at] = sorted[at - 1];
		sorted[at] = index[i];
	}
}

/* Fill a symmetric array of `rank` indices: a random value for every sorted index, the same for all
 * its permutations. */
static void fill_symmetric(double *array, int n, int rank, int parity)
{
	int index[4] = {0}, sorted[4];
	size_t total = 1;

	for (int i = 0; i < rank; i++)
		total *= (size_t)n;
	for (size_t at = 0; at < total; at++) {
		size_t rest = at, home = 0;

		for (int i = rank; i-- > 0; rest /= (size_t)n)
			index[i] = (int)(rest % (size_t)n);
		insert(sorted, index, rank);
		for (int i = 0; i < rank; i++)
			home = home*(size_t)n + (size_t)sorted[i];
		/* the sorted index comes first in this order */
		if (home == at)
			array[at] = allowed(sorted, rank, parity) ? uniform() : 0;
		else
			array[at] = array[home];
	}
}

static int dense_new(struct dense *dense, int n, int parity)
{
	size_t m = (size_t)n;

	dense->n = n;
	dense->K = calloc(m*m, sizeof *dense->K);
	dense->Q = calloc(m*m*m, sizeof *dense->Q);
	dense->C = calloc(m*m*m*m, sizeof *dense->C);
	if (!dense->K || !dense->Q || !dense->C)
		return 0;
	for (int j = 0; j < n; j++)
		dense->K[j*n + j] = (j + 1.0)*(j + 1.0);
	fill_symmetric(dense->Q, n, 3, parity);
	fill_symmetric(dense->C, n, 4, parity);
	return 1;
}

static void dense_free(struct dense *dense)
{
	free(dense->K);
	free(dense->Q);
	free(dense->C);
}

static int nonzeros(const double *array, size_t count)
{
	int found = 0;

	for (size_t i = 0; i < count; i++)
		found += array[i] != 0;
	return found;
}

static void list_quads(struct hawser_rom *rom, const struct dense *dense)
{
	int n = dense->n;

	for (int j = 0; j < n; j++)
		for (int k = 0; k < n; k++)
			for (int l = k; l < n; l++) {
				double value = dense->Q[(j*n + k)*n + l];

				if (value != 0)
					rom->Q[rom->quads++] = (struct hawser_quad){
						j, k, l, value*orders((int[]){k, l}, 2)};
			}
}

static void list_cubics(struct hawser_rom *rom, const struct dense *dense)
{
	int n = dense->n;

	for (int at = 0; at < n*n*n*n; at++) {
		int j = at/(n*n*n), k = at/(n*n) % n, l = at/n % n, m = at % n;

		if (k <= l && l <= m && dense->C[at] != 0)
			rom->C[rom->cubics++] = (struct hawser_cubic){
				j, k, l, m, dense->C[at]*orders((int[]){k, l, m}, 3)};
	}
}

/* The same model in the library's form. */
static enum hawser_status rom_new(struct hawser_rom *rom, const struct dense *dense,
                                  struct hawser_report *report)
{
	size_t n = (size_t)dense->n;

	memset(rom, 0, sizeof *rom);
	rom->n = dense->n;
	rom->length = rom->time = rom->force = 1;
	rom->D = calloc(n*n, sizeof *rom->D);
	rom->K = malloc(n*n*sizeof *rom->K);
	rom->Q = malloc((size_t)(nonzeros(dense->Q, n*n*n) + 1)*sizeof *rom->Q);
	rom->C = malloc((size_t)(nonzeros(dense->C, n*n*n*n) + 1)*sizeof *rom->C);
	if (!rom->D || !rom->K || !rom->Q || !rom->C)
		return HAWSER_ERR_MEMORY;
	memcpy(rom->K, dense->K, n*n*sizeof *rom->K);
	list_quads(rom, dense);
	list_cubics(rom, dense);
	return hawser_rom_compile(rom, report);
}

static void naive_restoring(const struct dense *dense, double *restoring, const double *u)
{
	int n = dense->n;

	for (int j = 0; j < n; j++) {
		double force = 0;

		for (int jk = j*n; jk < (j + 1)*n; jk++) {
			double stiffness = dense->K[jk];

			for (int l = 0; l < n; l++) {
				const double *c = dense->C + (jk*n + l)*n;
				double slope = dense->Q[jk*n + l];

				for (int m = 0; m < n; m++)
					slope += c[m]*u[m];
				stiffness += slope*u[l];
			}
			force += stiffness*u[jk - j*n];
		}
		restoring[j] = force;
	}
}

static void naive_tangent(const struct dense *dense, double *restoring, double *tangent,
                          const double *u)
{
	int n = dense->n;

	naive_restoring(dense, restoring, u);
	for (int jk = 0; jk < n*n; jk++) {
		double sum = dense->K[jk];

		for (int l = 0; l < n; l++) {
			const double *c = dense->C + (jk*n + l)*n;
			double slope = 0;

			for (int m = 0; m < n; m++)
				slope += c[m]*u[m];
			sum += (2*dense->Q[jk*n + l] + 3*slope)*u[l];
		}
		tangent[jk] = sum;
	}
}

/* Largest difference between the two models over all states, relative to the sum of the moduli of
 * the terms. */
static double disagreement(const struct hawser_rom *rom, const struct dense *dense,
                           const struct dense *moduli, const double *u, double *work)
{
	int n = dense->n;
	double *ours = work, *theirs = ours + n + n*n, *size = theirs + n + n*n;
	double worst = 0;

	for (int s = 0; s < states; s++, u += n) {
		double *modulus = size + n + n*n;

		for (int j = 0; j < n; j++)
			modulus[j] = fabs(u[j]);
		hawser_rom_tangent(rom, ours, ours + n, u);
		naive_tangent(dense, theirs, theirs + n, u);
		naive_tangent(moduli, size, size + n, modulus);
		for (int i = 0; i < n + n*n; i++)
			worst = fmax(worst, fabs(ours[i] - theirs[i])/(size[i] + 1e-300));
		hawser_rom_restoring(rom, ours, u);
		for (int i = 0; i < n; i++)
			worst = fmax(worst, fabs(ours[i] - theirs[i])/(size[i] + 1e-300));
	}
	return worst;
}

/* Largest difference between tangents computed in one call and one by one, relative to the largest
 * entry. */
static double block_disagreement(const struct hawser_rom *rom, const double *u, double *all,
                                 double *work)
{
	int n = rom->n;
	double *one = all + states*(n + n*n), worst = 0, largest = 0;

	hawser__rom_tangents(rom, all, all + states*n, u, states, work);
	for (int s = 0; s < states; s++) {
		hawser_rom_tangent(rom, one, one + n, u + s*n);
		for (int i = 0; i < n + n*n; i++) {
			double other = i < n ? all[s*n + i] : all[states*n + s*n*n + i - n];

			largest = fmax(largest, fabs(one[i]));
			worst = fmax(worst, fabs(one[i] - other));
		}
	}
	return worst/largest;
}

/* The functions that are timed: one call for each model. */
struct sides {
	const struct hawser_rom *rom;
	const struct dense *dense;
	double *restoring, *tangent, *work;
};
static void ours_restoring(const struct sides *s, const double *u)
{
	hawser_rom_restoring(s->rom, s->restoring, u);
}
static void ours_tangent(const struct sides *s, const double *u)
{
	hawser_rom_tangent(s->rom, s->restoring, s->tangent, u);
}
static void theirs_restoring(const struct sides *s, const double *u)
{
	naive_restoring(s->dense, s->restoring, u);
}
static void theirs_tangent(const struct sides *s, const double *u)
{
	naive_tangent(s->dense, s->restoring, s->tangent, u);
}

static void block_tangents(const struct sides *s, const double *u)
{
	hawser__rom_tangents(s->rom, s->restoring, s->restoring + states*s->rom->n, u, states,
	                     s->work);
}

static volatile double sink; /* keeps the results alive */

/* States per second, with `at_once` of them per call: the best of five timings, each long enough
 * for the clock. */
static double rate(void (*call)(const struct sides *, const double *), const struct sides *sides,
                   const double *u, int at_once)
{
	double best = 0;

	for (int turn = 0; turn < 5; turn++) {
		double start = clock_secs(), spent = 0;
		long calls = 0;

		while (spent < time_limit_secs/5) {
			for (int s = 0; s < states; s += at_once) {
				call(sides, u + s*sides->rom->n);
				sink = sides->restoring[0];
			}
			calls += states;
			spent = clock_secs() - start;
		}
		best = fmax(best, (double)calls/spent);
	}
	return best;
}

/* Number of multiplications and additions of a tangent, without those of the products u_l u_m. */
static double entries(const struct hawser_rom *rom)
{
	const struct hawser__kernel_panels *panels = rom->kernel->panels;
	double sum = 0;

	for (int p = 0; p < panels->count; p++)
		sum += panels->panel[p].rows*(panels->panel[p].b_end - panels->panel[p].a);
	return sum;
}

/* All states in one call, as in harmonic balance and the period map. */
static double show_block(const struct hawser_rom *rom, const double *u, double single)
{
	int n = rom->n;
	double *all = malloc((size_t)((states + 1)*(n + n*n))*sizeof *all);
	double *work = malloc((hawser__rom_tangents_work(rom, states) + 1)*sizeof *work);
	double error = INFINITY;

	if (all && work && (error = block_disagreement(rom, u, all, work)) < error_allowed) {
		struct sides sides = {.rom = rom, .restoring = all, .work = work};
		double many = rate(block_tangents, &sides, u, states);

		printf("    %-10s %12.4g /s   one by one %8.4g /s %6.1f times; %4.1f Gflop/s\n",
		       "tangents", many, single, many/single, 2e-9*entries(rom)*many);
	}
	free(all);
	free(work);
	return error;
}

static void show(const char *what, double ours, double theirs)
{
	printf("    %-10s %12.4g /s   naive %12.4g /s   %6.1f times\n", what, ours, theirs,
	       ours/theirs);
}

/* The same arrays with the moduli of the entries. */
static int dense_moduli(struct dense *moduli, const struct dense *dense)
{
	size_t n = (size_t)dense->n;

	if (!dense_new(moduli, dense->n, 0))
		return 0;
	for (size_t i = 0; i < n*n; i++)
		moduli->K[i] = fabs(dense->K[i]);
	for (size_t i = 0; i < n*n*n; i++)
		moduli->Q[i] = fabs(dense->Q[i]);
	for (size_t i = 0; i < n*n*n*n; i++)
		moduli->C[i] = fabs(dense->C[i]);
	return 1;
}

/* Verify and time one model. Returns 0 if the two models disagree. */
static int run(int n, int parity)
{
	struct dense dense = {0}, moduli = {0};
	struct hawser_rom rom;
	struct hawser_report report = {0};
	size_t block = (size_t)(n + n*n);
	double *u = malloc((size_t)(states*n)*sizeof *u), *work = malloc(4*block*sizeof *work);
	double error = INFINITY;

	memset(&rom, 0, sizeof rom);
	if (!u || !work || !dense_new(&dense, n, parity) || !dense_moduli(&moduli, &dense))
		goto done;
	for (int i = 0; i < states*n; i++)
		u[i] = uniform();
	if (rom_new(&rom, &dense, &report) != HAWSER_OK) {
		fprintf(stderr, "kernel: %s\n", report.message);
		goto done;
	}
	error = disagreement(&rom, &dense, &moduli, u, work);
	printf("  n %d, %s: %d quadratic and %d cubic monomials, error %.1e\n", n,
	       parity ? "parity-sparse" : "dense", rom.quads, rom.cubics, error);
	if (error < error_allowed) {
		struct sides sides = {&rom, &dense, work, work + n, NULL};
		double single = rate(ours_tangent, &sides, u, 1);

		show("restoring", rate(ours_restoring, &sides, u, 1),
		     rate(theirs_restoring, &sides, u, 1));
		show("tangent", single, rate(theirs_tangent, &sides, u, 1));
		error = fmax(error, show_block(&rom, u, single));
	}
done:
	hawser_rom_clear(&rom);
	dense_free(&dense);
	dense_free(&moduli);
	free(u);
	free(work);
	return error < error_allowed;
}

int main(void)
{
	int good;

	puts("kernel: restoring force, and restoring force with tangent, of a reduced model");
	good = run(3, 1) & run(5, 1) & run(8, 1) & run(12, 1) & run(16, 1) & run(20, 1) &
	       run(10, 0) & run(20, 0) & bench_cables();
	if (!good)
		fprintf(stderr, "kernel: the two sides disagree by more than %g\n", error_allowed);
	return good ? 0 : 1;
}
