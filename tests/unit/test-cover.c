/* The branches that cover a range: a Duffing oscillator within its range of two stable motions, and
 * two uncoupled oscillators, a softening and a hardening one, whose response from either end covers
 * only a part of the range. The second route is the slow sweep in both directions, and each branch
 * of one oscillator alone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/cover.h>

#include "tests/tap.h"

static void *copy(const void *from, size_t size)
{
	void *to = malloc(size);

	if (!to)
		abort();
	return memcpy(to, from, size);
}

/* n = 1: hardening, natural frequency 1; n = 2: a softening one of frequency 1, and a hardening one of
 * frequency 3. */
static void make(struct hawser_rom *rom, int n)
{
	const double D1[] = {0.05}, K1[] = {1.0}, f1[] = {0.2};
	const double D2[] = {0.04, 0.0, 0.0, 0.1}, K2[] = {1.0, 0.0, 0.0, 9.0}, f2[] = {0.06, 1.0};
	const struct hawser_cubic one[] = {{0, 0, 0, 0, 0.4}};
	const struct hawser_cubic two[] = {{0, 0, 0, 0, -0.15}, {1, 1, 1, 1, 4.0}};

	*rom = (struct hawser_rom){.n = n, .time = 1.0, .length = 1.0, .harmonics = 1, .cubics = n};
	rom->D = n == 1 ? copy(D1, sizeof D1) : copy(D2, sizeof D2);
	rom->K = n == 1 ? copy(K1, sizeof K1) : copy(K2, sizeof K2);
	rom->C = n == 1 ? copy(one, sizeof one) : copy(two, sizeof two);
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0].k = 1;
	rom->harmonic[0].f = n == 1 ? copy(f1, sizeof f1) : copy(f2, sizeof f2);
	ok(!hawser_rom_compile(rom, NULL), "compiled");
}

static void trace(struct hawser_frf *first, struct hawser_cover *cover, const struct hawser_rom *rom,
                  struct hawser_frf_options *options)
{
	enum hawser_status status = hawser_frf_trace(first, rom, options, NULL);

	ok(!status, "first branch: %s after %d points", hawser_frf_end_name(first->end), first->points);
	status = hawser_cover_trace(cover, first, rom, options, NULL);
	ok(!status, "%d further branches, %d gaps", cover->branches, cover->gaps);
}

static int folds(const struct hawser_frf *frf)
{
	int count = 0;

	for (int e = 0; e < frf->events; e++)
		count += frf->event[e].kind == HAWSER_FOLD;
	return count;
}

/* Smallest distance, over the range, of the amplitudes of a sweep from those of a branch, by linear
 * interpolation. */
static double from_sweep(const struct hawser_sweep *sweep, const struct hawser_frf *frf, int n, int j)
{
	double worst = 0.0;

	for (int i = 0; i < sweep->points; i++) {
		double best = INFINITY, a = sweep->coordinate[(size_t)i*n + j];

		for (int p = 0; p + 1 < frf->points; p++) {
			double x = frf->point[p].omega, y = frf->point[p + 1].omega;
			double s = (sweep->omega[i] - x)/(y - x);

			if (s >= 0.0 && s <= 1.0)
				best = fmin(best, fabs(frf->coordinate[(size_t)p*n + j]*(1.0 - s) +
				                       frf->coordinate[(size_t)(p + 1)*n + j]*s - a)/a);
		}
		worst = fmax(worst, best);
	}
	return worst;
}

/* With half the work of a curve, and of the further branches, the first points are the same. */
static void test_limited(const struct hawser_frf *first, const struct hawser_cover *cover,
                         const struct hawser_rom *rom, const struct hawser_frf_options *all)
{
	struct hawser_frf_options options = *all;
	struct hawser_frf half;
	struct hawser_cover part;
	int same = 1;

	options.most_work = 0.5*hawser_orbit_work(&first->cost, rom);
	ok(options.most_work > 0.0 && !hawser_frf_trace(&half, rom, &options, NULL), "half the work");
	for (int p = 0; p < half.points; p++)
		same &= p < first->points && half.point[p].omega == first->point[p].omega;
	ok(half.end == HAWSER_END_WORK && half.points > 2 && half.points < first->points && same,
	   "%d of %d points, the same: %s", half.points, first->points, hawser_frf_end_name(half.end));
	ok(!hawser_cover_needed(&half, &options), "nothing more is searched for");
	hawser_frf_clear(&half);
	options.most_work = 0.5*cover->work;
	ok(!hawser_cover_trace(&part, first, rom, &options, NULL) && !cover->costly && part.costly &&
	   part.branches == 1 && part.branch[0].end == HAWSER_END_WORK && part.gaps == 1 &&
	   part.work < 0.9*cover->work, "half of the other branch, and a gap");
	hawser_cover_clear(&part);
	options.most_work = cover->work;
	ok(!hawser_cover_trace(&part, first, rom, &options, NULL) && !part.costly && part.gaps == 0 &&
	   part.work == cover->work, "with just what it takes, nothing is left out");
	hawser_cover_clear(&part);
}

/* From the upper end, on the lower branch, the curve returns; the upper branch begins at the other
 * end. */
static void test_returned(void)
{
	struct hawser_frf_options options = {.from = 1.6, .to = 0.8};
	struct hawser_sweep_options up = {.from = 0.8, .to = 1.6, .count = 81};
	struct hawser_frf first;
	struct hawser_cover cover;
	struct hawser_sweep sweep;
	struct hawser_rom rom;
	double gap;

	make(&rom, 1);
	trace(&first, &cover, &rom, &options);
	ok(first.end == HAWSER_END_RETURNED && hawser_cover_needed(&first, &options), "returned");
	ok(cover.branches == 1 && cover.gaps == 0 && cover.branch[0].end == HAWSER_END_RANGE &&
	   cover.branch[0].branch == 2 && folds(&cover.branch[0]) == 0, "one branch covers the range");
	ok(!hawser_sweep_run(&sweep, &rom, &up, NULL), "a sweep up");
	gap = from_sweep(&sweep, &cover.branch[0], 1, 0);
	ok(gap < 2e-3, "which has the amplitudes of that branch: off by %.1e", gap);
	hawser_sweep_clear(&sweep);
	test_limited(&first, &cover, &rom, &options);
	hawser_cover_clear(&cover);
	hawser_frf_clear(&first);
	options.from = 0.8;
	options.to = 2.6;
	trace(&first, &cover, &rom, &options);
	ok(first.end == HAWSER_END_RANGE && !hawser_cover_needed(&first, &options) &&
	   cover.branches == 0 && cover.gaps == 0, "a curve that covers the range leaves nothing");
	hawser_frf_clear(&first);
	hawser_cover_clear(&cover);
	hawser_rom_clear(&rom);
}

/* Both ends lie in a range of two stable motions, so that both curves return: the branch between
 * them is found from the middle. */
static void test_between(void)
{
	struct hawser_frf_options options = {.from = 0.85, .to = 4.2};
	struct hawser_frf first;
	struct hawser_cover cover;
	struct hawser_rom rom;
	double least = INFINITY, most = 0.0;

	make(&rom, 2);
	trace(&first, &cover, &rom, &options);
	ok(first.end == HAWSER_END_RETURNED, "the first branch: %s", hawser_frf_end_name(first.end));
	ok(cover.branches >= 2 && cover.branch[0].end == HAWSER_END_RETURNED, "the second: %s",
	   cover.branches > 0 ? hawser_frf_end_name(cover.branch[0].end) : "-");
	for (int k = 1; k < cover.branches; k++)
		for (int p = 0; p < cover.branch[k].points; p++) {
			least = fmin(least, cover.branch[k].point[p].omega);
			most = fmax(most, cover.branch[k].point[p].omega);
		}
	ok(cover.branches == 3 && cover.gaps == 0 && least == 0.85 && most == 4.2,
	   "%d from the middle, over %.4g to %.4g", cover.branches - 1, least, most);
	hawser_cover_clear(&cover);
	hawser_frf_clear(&first);
	hawser_rom_clear(&rom);
}

CASE(unit_cover)
{
	test_returned();
	test_between();
	return done_testing();
}
