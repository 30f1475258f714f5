/* modes/branches_meet.c - where two branches in the plane are closest, and whether they cross.
 *
 *   x     the abscissa of the sweep: log of H, or the speed
 *   r(x)  relative gap of the sorted neighbours k, k + 1: 2 (w2 - w1)/(w2 + w1)
 *   w     half-width of a veering: where r is sqrt(2) times its least value
 *
 * For two modes that meet, omega^2 are the eigenvalues of a 2 x 2 matrix whose diagonal crosses and
 * whose other element couples them: r^2 = slope^2 (x - x0)^2 + gap^2 to leading order, whether they
 * are coupled or not. So a parabola through three points of r^2 finds x0 and the gap of both kinds,
 * with superlinear convergence, where r itself has a corner; it is safeguarded by golden section.
 * The gap decides what it is: two branches of one parameter cross only where a symmetry uncouples
 * them (J. von Neumann, E. Wigner, Phys. Z. 30 (1929) 467), and then down to round-off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "modes/branches.h"

enum { ITERATIONS = 60, SHIFTS = 40 };
static const double golden = 0.381966011250105;
/* x0 is wanted to this part of the half-width: the gap is then good to its square. */
static const double width_part = 1e-5;
/* Narrower ones than this part of the sweep's step get stops of their own, wider than the second. */
static const double narrow = 1.5, invisible = 1e-4;
/* By which part of itself a wide gap grows on either side, at a speed. */
static const double rise = 0.1;

struct probe {
	double x, f; /* f = r^2 */
	double omega;
	struct hawser_statics statics;
};

static struct probe of_stop(const struct hawser__stop *stop, int k)
{
	double r = hawser__stop_gap(stop, k);

	return (struct probe){stop->x, r*r,
	                      0.5*(stop->mode[k].omega + stop->mode[k + 1].omega), stop->statics};
}

static enum hawser_status look(struct probe *probe, struct hawser__branches *all, int k, double x,
                               struct hawser_report *report)
{
	struct hawser__stop stop;
	enum hawser_status status;

	if (all->need < k + 2)
		all->need = k + 2;
	status = hawser__stop_solve(&stop, all, x, 0, report);
	if (status)
		return status;
	*probe = of_stop(&stop, k);
	hawser__stop_clear(&stop);
	return HAWSER_OK;
}

/* Shift p[3] (ascending x) outwards until the middle one is the lowest. Where the ends of a step show
 * a veering that is about as wide as the step, its middle may be just outside. */
static enum hawser_status bracket(struct probe *p, struct hawser__branches *all, int k,
                                  struct hawser_report *report)
{
	char here[HAWSER__HERE];

	for (int i = 0; i < SHIFTS; i++) {
		enum hawser_status status;

		if (p[1].f <= p[0].f && p[1].f <= p[2].f)
			return HAWSER_OK;
		if (p[0].f < p[2].f) {
			double x = p[0].x - 1.618*(p[1].x - p[0].x);

			p[2] = p[1];
			p[1] = p[0];
			status = look(&p[0], all, k, x, report);
		} else {
			double x = p[2].x + 1.618*(p[2].x - p[1].x);

			p[0] = p[1];
			p[1] = p[2];
			status = look(&p[2], all, k, x, report);
		}
		if (status)
			return status;
	}
	all->course->say(here, sizeof here, &p[1].statics);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, all->course->where, SHIFTS,
	                       sqrt(p[1].f),
	                       "the modes %d and %d in the plane exchange their shapes near %s "
	                       "but get no closest there: ask for more points", k + 1, k + 2, here);
}

/* Vertex of the parabola through p[3], and its curvature. Divided differences. */
static double vertex(double *curvature, const struct probe *p)
{
	double left = (p[1].f - p[0].f)/(p[1].x - p[0].x);
	double right = (p[2].f - p[1].f)/(p[2].x - p[1].x);

	*curvature = (right - left)/(p[2].x - p[0].x);
	return 0.5*(p[0].x + p[1].x) - 0.5*left/(*curvature);
}

static double section(const struct probe *p)
{
	if (p[2].x - p[1].x > p[1].x - p[0].x)
		return p[1].x + golden*(p[2].x - p[1].x);
	return p[1].x - golden*(p[1].x - p[0].x);
}

/* The new point replaces an end; the lowest one is the middle. */
static void narrow_down(struct probe *p, const struct probe *new)
{
	int side = new->x > p[1].x; /* 1: right of the middle */

	if (new->f < p[1].f) {
		p[side ? 0 : 2] = p[1];
		p[1] = *new;
	} else {
		p[side ? 2 : 0] = *new;
	}
}

/* Where to look next; p[1].x itself where it is settled. */
static double next_place(const struct probe *p)
{
	double curvature, x = vertex(&curvature, p), size = fabs(p[1].x), width, least;
	double near = fmin(p[1].x - p[0].x, p[2].x - p[1].x);

	if (!(x > p[0].x && x < p[2].x) || !(curvature > 0.0))
		return section(p);
	width = sqrt(p[1].f/curvature);
	least = 4e-16*size + width_part*width;
	if (fabs(x - p[1].x) > least)
		return x;
	/* A small step says nothing where both other points are far off: the first guess was made from
	 * the same two. Look at the distance of the half-width, which at a crossing is the error. */
	if (near > 100.0*width && width > 4e-16*size)
		return x < p[1].x ? p[1].x - width : p[1].x + width;
	return p[1].x;
}

/* p[3] brackets a least value: p[1] becomes it. */
static enum hawser_status descend(struct probe *p, struct hawser__branches *all, int k,
                                  struct hawser_report *report)
{
	for (int i = 0; i < ITERATIONS; i++) {
		double x = next_place(p);
		struct probe new;
		enum hawser_status status;

		if (x == p[1].x || sqrt(p[1].f) <= 1e-2*all->options.crossing)
			return HAWSER_OK;
		status = look(&new, all, k, x, report);
		if (status)
			return status;
		narrow_down(p, &new);
	}
	return HAWSER_OK; /* golden section has shrunk the bracket by far */
}

static enum hawser_status record(struct hawser__branches *all, int k, const struct probe *at,
                                 struct hawser_report *report)
{
	double gap = sqrt(at->f);

	if (all->meetings == all->meeting_capacity) {
		int capacity = 2*all->meeting_capacity + 16;
		struct hawser__meeting *more = realloc(all->meeting, (size_t)capacity*sizeof *more);

		if (!more)
			return hawser__no_memory(report, all->course->where);
		all->meeting = more;
		all->meeting_capacity = capacity;
	}
	all->meeting[all->meetings++] = (struct hawser__meeting){
		.k = k, .x = at->x, .gap = gap, .omega = at->omega, .statics = at->statics,
		.kind = gap <= all->options.crossing ? HAWSER_CROSSING : HAWSER_VEERING};
	return HAWSER_OK;
}

static enum hawser_status locate(struct hawser__branches *all, int k, struct probe *p,
                                 struct hawser_report *report)
{
	struct hawser_report detail = {0};
	enum hawser_status status;

	if (p[0].x > p[2].x) {
		struct probe other = p[0];

		p[0] = p[2];
		p[2] = other;
	}
	status = bracket(p, all, k, &detail);
	if (!status)
		status = descend(p, all, k, &detail);
	if (!status)
		return record(all, k, &p[1], report);
	if (status == HAWSER_ERR_NO_SOLUTION && all->course->ends)
		return HAWSER_OK;
	if (report)
		*report = detail;
	return status;
}

enum hawser_status hawser__branches_meet(struct hawser__branches *all, int k,
                                         const struct hawser__stop *a, const struct hawser__stop *b,
                                         struct hawser_report *report)
{
	struct probe p[3] = {of_stop(a, k), of_stop(a, k), of_stop(b, k)};
	double left = sqrt(p[0].f), right = sqrt(p[2].f), part = left/(left + right);
	enum hawser_status status;

	/* where straight lines would cross */
	part = fmin(fmax(part, 0.02), 0.98);
	status = look(&p[1], all, k, a->x + part*(b->x - a->x), report);
	return status ? status : locate(all, k, p, report);
}

/* --- veerings wider than a step --- */

/* Is a meeting of the places k, k + 1 known between the two? */
static int known(const struct hawser__branches *all, int k, double x, double other)
{
	for (int i = 0; i < all->meetings; i++)
		if (all->meeting[i].k == k && all->meeting[i].x >= fmin(x, other) &&
		    all->meeting[i].x <= fmax(x, other))
			return 1;
	return 0;
}

static int has(const struct hawser__branches *all, int i, int k)
{
	return i >= 0 && i < all->stops && k + 1 < all->stop[i].in;
}

/* Two modes that meet turn into each other by half of atan((x - x0)/w) on either side. Have the
 * shapes turned by half of that at least from stop i - 1 to i + 1? Two that merely come near,
 * uncoupled, have not. */
static int turned(const struct hawser__branches *all, int k, int i, const struct probe *p)
{
	const struct hawser__stop *a = all->stop + i - 1, *b = all->stop + i + 1;
	double mixed = 0.5*(hawser__stop_correlation(a, k, b, k + 1, all) +
	                    hawser__stop_correlation(a, k + 1, b, k, all));
	double curvature, x0 = vertex(&curvature, p), w = sqrt(p[1].f/fabs(curvature));
	double expected = 0.5*fabs(atan((p[2].x - x0)/w) - atan((p[0].x - x0)/w));

	return asin(sqrt(fmin(mixed, 1.0))) > 0.5*expected;
}

/* Does the gap grow by `rise` on the way from stop i, before it is as small as there again? */
static int rises(const struct hawser__branches *all, int k, int i, int way)
{
	double least = hawser__stop_gap(all->stop + i, k);

	for (int j = i + way; has(all, j, k); j += way) {
		double gap = hawser__stop_gap(all->stop + j, k);

		if (gap > (1.0 + rise)*least)
			return 1;
		if (gap < least)
			return 0;
	}
	return 0;
}

/* Coriolis' force couples all shapes, so that they turn wherever the speed has its way: a veering is
 * only what also brings two branches nearer to each other than they are around it. */
static int distinct(const struct hawser__branches *all, int k, int i)
{
	return !all->course->moving || (rises(all, k, i, -1) && rises(all, k, i, 1));
}

static enum hawser_status wide(struct hawser__branches *all, int k, int i,
                               struct hawser_report *report)
{
	const struct hawser__stop *stop = all->stop + i;
	struct probe p[3];

	if (!has(all, i - 1, k) || !has(all, i, k) || !has(all, i + 1, k))
		return HAWSER_OK;
	for (int j = 0; j < 3; j++)
		p[j] = of_stop(stop + j - 1, k);
	if (p[1].f > p[0].f || p[1].f >= p[2].f || known(all, k, p[0].x, p[2].x) ||
	    !turned(all, k, i, p) || !distinct(all, k, i))
		return HAWSER_OK;
	return locate(all, k, p, report);
}

/* The stop before x in the order of the sweep; -1 where there is none. */
static int before(const struct hawser__branches *all, double x)
{
	int way = all->stop[all->stops - 1].x > all->stop[0].x ? 1 : -1, i = -1;

	while (i + 1 < all->stops && way*all->stop[i + 1].x <= way*x)
		i++;
	return i;
}

/* Stops at and beside the middle of a veering that is narrow against the step it happens in. */
static enum hawser_status show(struct hawser__branches *all, const struct hawser__meeting *at,
                               struct hawser_report *report)
{
	static const double place[] = {-3.0, -1.0, 0.0, 1.0, 3.0};
	int i = before(all, at->x);
	double step, distance, width, gap;
	enum hawser_status status = HAWSER_OK;

	if (i < 0 || i + 1 >= all->stops)
		return HAWSER_OK;
	step = fabs(all->stop[i + 1].x - all->stop[i].x);
	distance = fabs(all->stop[i].x - at->x);
	gap = hawser__stop_gap(all->stop + i, at->k);
	width = distance*at->gap/sqrt(fmax(gap*gap - at->gap*at->gap, 1e-300));
	if (!(width > invisible*step && width < narrow*step))
		return HAWSER_OK;
	for (int j = 0; j < 5 && !status; j++) {
		double x = at->x + place[j]*width;
		struct hawser__stop stop;

		i = before(all, x);
		if (i < 0 || i + 1 >= all->stops || fabs(x - all->stop[i].x) < 0.1*width)
			continue;
		status = hawser__stop_solve(&stop, all, x, 0, report);
		stop.inserted = 1;
		if (!status)
			status = hawser__branches_insert(all, i + 1, &stop, report);
	}
	return status;
}

enum hawser_status hawser__branches_veerings(struct hawser__branches *all,
                                             struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int most = 0;

	for (int i = 0; i < all->stops; i++)
		most = all->stop[i].in > most ? all->stop[i].in : most;
	for (int k = 0; k + 1 < most; k++)
		for (int i = 1; i + 1 < all->stops && !status; i++)
			status = wide(all, k, i, report);
	for (int i = 0; i < all->meetings && !status; i++)
		if (all->meeting[i].kind == HAWSER_VEERING)
			status = show(all, all->meeting + i, report);
	return status;
}

int hawser__branches_pair(int *below, int *above, struct hawser__branches *all,
                          const struct hawser__meeting *meeting)
{
	int k = meeting->k;

	*below = all->at[k];
	*above = all->at[k + 1];
	if (meeting->kind == HAWSER_CROSSING) {
		all->at[k] = *above;
		all->at[k + 1] = *below;
	}
	return *below < all->in || *above < all->in;
}
