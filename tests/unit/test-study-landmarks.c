/* Folds and peaks of synthetic curves with known peaks, and their matching.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/study.h>

#include "tests/tap.h"

enum { most_points = 4000 };
static struct hawser_frf_point point[most_points];
static double probe[most_points][3];

/* A branch that bends: two resonances of y, at arclength 2.385 and 6.1, a weak one of x, none of
 * z. */
static double y_at(double s)
{
	return 1.3/(1.0 + 4.0*pow(s - 2.385, 2)) + 0.71/(1.0 + 9.0*pow(s - 6.1, 2));
}

static double omega_at(double s)
{
	return 1.0 + 0.1*s + 0.05*sin(1.7*s);
}

/* Points of uneven spacing, with the mean `mean`. */
static struct hawser_frf curve(double mean)
{
	struct hawser_frf frf = {.n = 1, .probes = 1, .point = point, .probe = &probe[0][0]};
	double s = 0.0;

	while (s < 9.0 && frf.points < most_points) {
		point[frf.points] = (struct hawser_frf_point){.omega = omega_at(s), .arc = s};
		probe[frf.points][0] = 0.004*y_at(s + 0.3);
		probe[frf.points][1] = y_at(s);
		probe[frf.points][2] = 0.0;
		frf.points++;
		s += mean*(1.0 + 0.4*sin(7.0*frf.points));
	}
	return frf;
}

/* The maxima of y_at, each displaced slightly towards the other. */
static double true_top(double near)
{
	double low = near - 0.1, high = near + 0.1;

	for (int i = 0; i < 200; i++) {
		double a = low + (high - low)/3.0, b = high - (high - low)/3.0;

		if (y_at(a) < y_at(b))
			low = a;
		else
			high = b;
	}
	return 0.5*(low + high);
}

static double worst_of(double mean, double *stated)
{
	const double near[] = {2.385, 6.1};
	struct hawser_frf frf = curve(mean);
	struct hawser_landmark *list = NULL;
	double worst = 0.0;
	int count = 0;

	*stated = 0.0;
	if (!ok(!hawser_landmarks(&list, &count, &frf, NULL, NULL) && count == 2,
	        "two peaks at steps of %g (%d)", mean, count)) {
		free(list);
		return NAN;
	}
	for (int i = 0; i < 2; i++) {
		double top = true_top(near[i]);
		double off = fmax(fabs(list[i].omega/omega_at(top) - 1.0),
		                  fabs(list[i].size/y_at(top) - 1.0));

		ok(list[i].kind == HAWSER_LANDMARK_PEAK && list[i].probe == 0 && list[i].axis == 1 &&
		   list[i].turn == 0, "a peak of y");
		ok(off <= fmax(list[i].omega_error, list[i].size_error), "its error, %.1e, is within "
		   "the one stated: %.1e", off, fmax(list[i].omega_error, list[i].size_error));
		worst = fmax(worst, off);
		*stated = fmax(*stated, fmax(list[i].omega_error, list[i].size_error));
	}
	free(list);
	return worst;
}

/* Five points of a smooth function: the position of its maximum to fourth order. */
static void check_order(void)
{
	double stated[3], coarse = worst_of(0.16, &stated[0]), fine = worst_of(0.04, &stated[1]);
	double order = log(coarse/fine)/log(4.0);

	ok(order > 3.3, "the peak's error falls with order %.2f: %.1e, %.1e", order, coarse, fine);
	ok(stated[1] < 1e-3, "stated error %.1e", stated[1]);
}

static void check_choice(void)
{
	struct hawser_landmark_options options = {.smallest = 0.0};
	struct hawser_frf frf = curve(0.05);
	struct hawser_landmark *list;
	int count, found;

	options.faintest = 1e-3;
	found = !hawser_landmarks(&list, &count, &frf, &options, NULL);
	ok(found && count == 4,
	   "the faint component counts where it is asked for (%d)", count);
	free(list);
	options = (struct hawser_landmark_options){.smallest = 0.0};
	options.smallest = 0.6;
	found = !hawser_landmarks(&list, &count, &frf, &options, NULL);
	ok(found && count == 1,
	   "smaller peaks do not where they are not (%d)", count);
	free(list);
	options = (struct hawser_landmark_options){.smallest = 0.0};
	options.prominence = 0.95;
	found = !hawser_landmarks(&list, &count, &frf, &options, NULL);
	ok(found && count == 1,
	   "only one falls to a twentieth on either side (%d)", count);
	free(list);
	/* a ripple of one percent must not cause peaks */
	for (int i = 0; i < frf.points; i++)
		probe[i][1] *= 1.0 + 0.004*(i % 2);
	found = !hawser_landmarks(&list, &count, &frf, NULL, NULL);
	ok(found && count == 2,
	   "a ripple makes no peaks (%d)", count);
	free(list);
}

/* A fold of known size between points 2 and 3. */
static void check_fold(void)
{
	struct hawser_frf_event event = {.kind = HAWSER_FOLD, .omega = 1.2, .arc = 2.4, .after = 2};
	struct hawser_frf frf = {.n = 1, .probes = 1, .points = 6, .point = point,
	                         .probe = &probe[0][0], .events = 1, .event = &event};
	struct hawser_landmark *list = NULL;
	int count = 0;

	for (int i = 0; i < 6; i++) {
		point[i] = (struct hawser_frf_point){.omega = 1.2 - 0.01*pow(i - 2.4, 2), .arc = i};
		for (int a = 0; a < 3; a++)
			probe[i][a] = (1.0 + 0.1*i)*(a + 1.0);
	}
	if (!ok(!hawser_landmarks(&list, &count, &frf, NULL, NULL) && count == 1, "a fold (%d)",
	        count))
		return;
	ok(list->turn == 1 && list->kind == HAWSER_LANDMARK_FOLD && list->probe == -1,
	   "Omega is largest there");
	close_to(list->size, 1.24*sqrt(14.0), 1e-13, "its size");
	close_to(list->omega, 1.2, 0.0, "its Omega is the event's");
	free(list);
	event.kind = HAWSER_TORUS;
	ok(!hawser_landmarks(&list, &count, &frf, NULL, NULL) && count == 0, "a torus is none");
	free(list);
}

/* --- matching --- */

static struct hawser_landmark fold(int turn, double omega, double size)
{
	return (struct hawser_landmark){.kind = HAWSER_LANDMARK_FOLD, .probe = -1, .axis = -1,
	                                .turn = turn, .omega = omega, .size = size};
}

static struct hawser_landmark peak(int axis, double omega, double size)
{
	return (struct hawser_landmark){.kind = HAWSER_LANDMARK_PEAK, .axis = axis, .omega = omega,
	                                .size = size};
}

static void check_match(const char *what, const struct hawser_landmark *a, int n,
                        const struct hawser_landmark *b, int m, const int *want)
{
	int partner[16], right = 1;

	if (!ok(!hawser_landmarks_match(partner, a, n, b, m, NULL, NULL), "%s", what))
		return;
	for (int i = 0; i < n; i++) {
		right &= partner[i] == want[i];
		printf("# %d: partner %d\n", i, partner[i]);
	}
	ok(right, "%s: as it should be", what);
}

static void check_matching(void)
{
	const struct hawser_landmark four[] = {fold(1, 1.25, 2.0), fold(-1, 1.1, 1.1),
	                                       fold(1, 2.6, 0.5), fold(-1, 2.4, 0.3)};
	const struct hawser_landmark two[] = {fold(1, 2.62, 0.52), fold(-1, 2.41, 0.31)};
	const struct hawser_landmark wrong[] = {fold(-1, 1.25, 2.0), fold(1, 1.1, 1.1)};
	const struct hawser_landmark close[] = {fold(1, 1.20, 2.0), fold(-1, 1.195, 1.9),
	                                        fold(1, 1.25, 2.0), fold(-1, 1.1, 1.1)};
	const struct hawser_landmark far[] = {fold(1, 1.42, 2.0), fold(-1, 1.1, 0.3)};
	const struct hawser_landmark peaks[] = {peak(1, 1.2, 0.3), peak(2, 1.2, 1.0)};
	const struct hawser_landmark zs[] = {peak(2, 1.21, 1.0), peak(1, 1.0, 0.3)};

	check_match("itself", four, 4, four, 4, (int[]){0, 1, 2, 3});
	check_match("a pair missing", two, 2, four, 4, (int[]){2, 3});
	check_match("a pair extra", four, 4, two, 2, (int[]){-1, -1, 0, 1});
	check_match("turning the other way", wrong, 2, four, 4, (int[]){-1, -1});
	check_match("an extra pair close by: the nearer one is taken", close, 4, four, 2,
	            (int[]){-1, -1, 0, 1});
	check_match("too far in Omega, too far in size", far, 2, four, 4, (int[]){-1, -1});
	check_match("peaks of other components", peaks, 2, zs, 2, (int[]){-1, 0});
	check_match("nothing to match with", four, 4, NULL, 0, (int[]){-1, -1, -1, -1});
	check_match("nothing", NULL, 0, four, 4, NULL);
}

/* Peaks in a different order cannot be aligned: one of the two crossing pairs is omitted. */
static void check_crossing(void)
{
	const struct hawser_landmark a[] = {peak(1, 1.0, 1.0), peak(1, 1.05, 1.3)};
	const struct hawser_landmark b[] = {peak(1, 1.05, 1.3), peak(1, 1.0, 1.0)};
	int partner[2];

	ok(!hawser_landmarks_match(partner, a, 2, b, 2, NULL, NULL), "crossing");
	ok((partner[0] < 0) + (partner[1] < 0) == 1, "one pair is left: %d %d", partner[0],
	   partner[1]);
}

CASE(unit_study_landmarks)
{
	check_order();
	check_choice();
	check_fold();
	check_matching();
	check_crossing();
	return done_testing();
}
