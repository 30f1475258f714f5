/* modes/sweep/branches_crossover.c - locate the points at which two in-plane branches are closest, and
 * classify them as crossings or veerings.
 *
 *   x     the abscissa of the sweep: log of H, or the speed
 *   r(x)  relative gap of the sorted frequencies k and k + 1: 2 (w2 - w1)/(w2 + w1)
 *   w     half-width of a veering: the distance from x0 at which r is sqrt(2) times its minimum
 *
 * Near x0 the two values of omega^2 are the eigenvalues of a symmetric 2 x 2 matrix whose diagonal
 * elements become equal at x0 and whose off-diagonal element couples the two modes. Hence r^2 =
 * slope^2 (x - x0)^2 + gap^2 to leading order, coupled or not. The vertex of a parabola through
 * three points of r^2 therefore converges superlinearly to x0 for crossings and veerings, whereas r
 * itself has a corner at a crossing. Golden section safeguards the iteration. The gap decides the
 * kind: branches of one parameter cross only if a symmetry uncouples them (J. von Neumann, E.
 * Wigner, Phys. Z. 30 (1929) 467), and the gap is then zero up to round-off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/grow.h"
#include "core/report.h"
#include "modes/sweep/branches.h"

enum { ITERATIONS = 60, SHIFTS = 40 };
static const double golden = 0.381966011250105;
/* Tolerance of x0 relative to the half-width; the relative error of the gap is its square,
 * 1e-10. */
static const double width_part = 1e-5;
/* Samples are inserted at a veering whose half-width is between these two multiples of the step: a
 * wider one is resolved already, a narrower one cannot be seen in a picture. */
static const double narrow = 1.5, invisible = 1e-4;
/* Of a travelling cable: a wide veering is listed if the gap grows by this fraction on either
 * side. */
static const double rise = 0.1;

struct probe {
	double x, f; /* f = r^2 */
	double omega;
	struct hawser_statics statics;
};

static struct probe of_sample(const struct hawser__sample *sample, int k)
{
	double r = hawser__sample_gap(sample, k);

	return (struct probe){sample->x, r*r,
	                      0.5*(sample->mode[k].omega + sample->mode[k + 1].omega), sample->statics};
}

static enum hawser_status evaluate(struct probe *probe, struct hawser__branches *all, int k, double x,
                                   struct hawser_report *report)
{
	struct hawser__sample sample;
	enum hawser_status status;

	if (all->need < k + 2)
		all->need = k + 2;
	status = hawser__sample_solve(&sample, all, x, 0, report);
	if (status)
		return status;
	*probe = of_sample(&sample, k);
	hawser__sample_clear(&sample);
	return HAWSER_OK;
}

/* Shift p[3] (ascending x) outwards until the middle one is the lowest. If a veering is about as
 * wide as the step in which it was detected, its minimum may lie just outside the step. */
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
			status = evaluate(&p[0], all, k, x, report);
		} else {
			double x = p[2].x + 1.618*(p[2].x - p[1].x);

			p[0] = p[1];
			p[1] = p[2];
			status = evaluate(&p[2], all, k, x, report);
		}
		if (status)
			return status;
	}
	all->sweep->describe(here, sizeof here, &p[1].statics);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, all->sweep->where, SHIFTS,
	                       sqrt(p[1].f),
	                       "the modes %d and %d in the plane exchange their shapes near %s "
	                       "but their gap has no minimum there: give more points", k + 1, k + 2,
	                       here);
}

/* Vertex of the parabola through p[3] by divided differences, and its second divided difference. */
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

/* Shrink the bracket by a new point; the lowest point becomes the middle one. */
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

/* The next abscissa to evaluate; p[1].x itself if the iteration has converged. */
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
	/* If both ends are far away, a small step does not prove convergence: the previous vertex was
	 * computed from the same two ends. Evaluate at the distance of the half-width, which at a
	 * crossing equals the error of x0. */
	if (near > 100.0*width && width > 4e-16*size)
		return x < p[1].x ? p[1].x - width : p[1].x + width;
	return p[1].x;
}

/* p[3] brackets a minimum; p[1] converges to it. */
static enum hawser_status descend(struct probe *p, struct hawser__branches *all, int k,
                                  struct hawser_report *report)
{
	for (int i = 0; i < ITERATIONS; i++) {
		double x = next_place(p);
		struct probe new;
		enum hawser_status status;

		if (x == p[1].x || sqrt(p[1].f) <= 1e-2*all->options.crossing)
			return HAWSER_OK;
		status = evaluate(&new, all, k, x, report);
		if (status)
			return status;
		narrow_down(p, &new);
	}
	return HAWSER_OK; /* 60 golden sections shrink the bracket below round-off */
}

static enum hawser_status record(struct hawser__branches *all, int k, const struct probe *at,
                                 struct hawser_report *report)
{
	double gap = sqrt(at->f);

	if (hawser__more(&all->crossover, all->crossovers, sizeof *all->crossover))
		return hawser__no_memory(report, all->sweep->where);
	all->crossover[all->crossovers++] = (struct hawser__crossover){
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
	if (status == HAWSER_ERR_NO_SOLUTION && all->sweep->ends)
		return HAWSER_OK;
	if (report)
		*report = detail;
	return status;
}

enum hawser_status hawser__branches_locate(struct hawser__branches *all, int k,
                                         const struct hawser__sample *a, const struct hawser__sample *b,
                                         struct hawser_report *report)
{
	struct probe p[3] = {of_sample(a, k), of_sample(a, k), of_sample(b, k)};
	double left = sqrt(p[0].f), right = sqrt(p[2].f), part = left/(left + right);
	enum hawser_status status;

	/* first estimate: the frequencies are linear in x and cross */
	part = fmin(fmax(part, 0.02), 0.98);
	status = evaluate(&p[1], all, k, a->x + part*(b->x - a->x), report);
	return status ? status : locate(all, k, p, report);
}

/* --- veerings wider than a step --- */

/* Is a crossover of the places k, k + 1 known between x and `other`? */
static int known(const struct hawser__branches *all, int k, double x, double other)
{
	for (int i = 0; i < all->crossovers; i++)
		if (all->crossover[i].k == k && all->crossover[i].x >= fmin(x, other) &&
		    all->crossover[i].x <= fmax(x, other))
			return 1;
	return 0;
}

static int has(const struct hawser__branches *all, int i, int k)
{
	return i >= 0 && i < all->samples && k + 1 < all->sample[i].in;
}

/* At a veering the two shapes rotate into each other by the angle atan((x - x0)/w)/2. Is the
 * rotation from sample i - 1 to i + 1 at least half of that? It is not for two uncoupled branches
 * with a minimum of their gap. */
static int turned(const struct hawser__branches *all, int k, int i, const struct probe *p)
{
	const struct hawser__sample *a = all->sample + i - 1, *b = all->sample + i + 1;
	double mixed = 0.5*(hawser__sample_correlation(a, k, b, k + 1, all) +
	                    hawser__sample_correlation(a, k + 1, b, k, all));
	double curvature, x0 = vertex(&curvature, p), w = sqrt(p[1].f/fabs(curvature));
	double expected = 0.5*fabs(atan((p[2].x - x0)/w) - atan((p[0].x - x0)/w));

	return asin(sqrt(fmin(mixed, 1.0))) > 0.5*expected;
}

/* Does the gap grow by `rise` on the way from sample i, before it is as small as there again? */
static int rises(const struct hawser__branches *all, int k, int i, int way)
{
	double least = hawser__sample_gap(all->sample + i, k);

	for (int j = i + way; has(all, j, k); j += way) {
		double gap = hawser__sample_gap(all->sample + j, k);

		if (gap > (1.0 + rise)*least)
			return 1;
		if (gap < least)
			return 0;
	}
	return 0;
}

/* Is the minimum at sample i a distinct veering? The Coriolis force of a travelling cable couples
 * all shapes, so that they rotate without any veering; there the gap must also have a minimum in i
 * that is clearly below its values on both sides. */
static int distinct(const struct hawser__branches *all, int k, int i)
{
	return !all->sweep->moving || (rises(all, k, i, -1) && rises(all, k, i, 1));
}

static enum hawser_status check_wide(struct hawser__branches *all, int k, int i,
                                     struct hawser_report *report)
{
	const struct hawser__sample *sample = all->sample + i;
	struct probe p[3];

	if (!has(all, i - 1, k) || !has(all, i, k) || !has(all, i + 1, k))
		return HAWSER_OK;
	for (int j = 0; j < 3; j++)
		p[j] = of_sample(sample + j - 1, k);
	if (p[1].f > p[0].f || p[1].f >= p[2].f || known(all, k, p[0].x, p[2].x) ||
	    !turned(all, k, i, p) || !distinct(all, k, i))
		return HAWSER_OK;
	return locate(all, k, p, report);
}

/* Index of the last sample before x in the order of the sweep; -1 if there is none. */
static int before(const struct hawser__branches *all, double x)
{
	int way = all->sample[all->samples - 1].x > all->sample[0].x ? 1 : -1, i = -1;

	while (i + 1 < all->samples && way*all->sample[i + 1].x <= way*x)
		i++;
	return i;
}

/* Insert samples at and near the centre of a veering that is narrow compared with its step. */
static enum hawser_status add_samples(struct hawser__branches *all, const struct hawser__crossover *at,
                                      struct hawser_report *report)
{
	static const double place[] = {-3.0, -1.0, 0.0, 1.0, 3.0};
	int i = before(all, at->x);
	double step, distance, width, gap;
	enum hawser_status status = HAWSER_OK;

	if (i < 0 || i + 1 >= all->samples)
		return HAWSER_OK;
	step = fabs(all->sample[i + 1].x - all->sample[i].x);
	distance = fabs(all->sample[i].x - at->x);
	gap = hawser__sample_gap(all->sample + i, at->k);
	width = distance*at->gap/sqrt(fmax(gap*gap - at->gap*at->gap, 1e-300));
	if (!(width > invisible*step && width < narrow*step))
		return HAWSER_OK;
	for (int j = 0; j < 5 && !status; j++) {
		double x = at->x + place[j]*width;
		struct hawser__sample sample;

		i = before(all, x);
		if (i < 0 || i + 1 >= all->samples || fabs(x - all->sample[i].x) < 0.1*width)
			continue;
		status = hawser__sample_solve(&sample, all, x, 0, report);
		sample.inserted = 1;
		if (!status)
			status = hawser__branches_insert(all, i + 1, &sample, report);
	}
	return status;
}

enum hawser_status hawser__branches_veerings(struct hawser__branches *all,
                                             struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int most = 0;

	for (int i = 0; i < all->samples; i++)
		most = all->sample[i].in > most ? all->sample[i].in : most;
	for (int k = 0; k + 1 < most; k++) {
		hawser__branches_tell(all, (double)k/most);
		for (int i = 1; i + 1 < all->samples && !status; i++)
			status = check_wide(all, k, i, report);
	}
	for (int i = 0; i < all->crossovers && !status; i++)
		if (all->crossover[i].kind == HAWSER_VEERING)
			status = add_samples(all, all->crossover + i, report);
	return status;
}

/* --- the result --- */

/* Sort into the order of the sweep, by insertion: there are few. */
static void sort_crossovers(struct hawser__branches *all, int way)
{
	for (int i = 1; i < all->crossovers; i++) {
		struct hawser__crossover one = all->crossover[i];
		int j = i;

		for (; j > 0 && way*all->crossover[j - 1].x > way*one.x; j--)
			all->crossover[j] = all->crossover[j - 1];
		all->crossover[j] = one;
	}
}

/* The two branches of a crossover, one of which was asked for, swap their places where they cross. */
static void read_crossover(void *result, struct hawser__branches *all,
                           const struct hawser__crossover *at)
{
	int below = all->at[at->k], above = all->at[at->k + 1];

	if (at->kind == HAWSER_CROSSING) {
		all->at[at->k] = above;
		all->at[at->k + 1] = below;
	}
	if (below < all->in || above < all->in)
		all->sweep->crossover(result, at, below + 1, above + 1);
}

void hawser__branches_read(void *result, struct hawser_irvine_branch *branch,
                           struct hawser__branches *all)
{
	int way = all->sample[all->samples - 1].x > all->sample[0].x ? 1 : -1, next = 0;
	size_t branches = (size_t)all->in + (size_t)all->out;

	for (int b = 0; b < all->in + all->out; b++)
		branch[b] = b < all->in ? (struct hawser_irvine_branch){HAWSER_IN_PLANE, b + 1}
		                        : (struct hawser_irvine_branch){HAWSER_OUT_OF_PLANE, b - all->in + 1};
	sort_crossovers(all, way);
	for (int k = 0; k < all->at_capacity; k++)
		all->at[k] = k;
	for (int i = 0; i < all->samples; i++) {
		const struct hawser__sample *sample = all->sample + i;
		size_t row = (size_t)i*branches;

		for (; next < all->crossovers && way*all->crossover[next].x < way*sample->x; next++)
			read_crossover(result, all, all->crossover + next);
		all->sweep->station(result, i, sample);
		for (int place = 0; place < sample->in; place++)
			if (all->at[place] < all->in)
				all->sweep->branch(result, row + (size_t)all->at[place], place, sample->mode + place);
		for (int b = 0; b < all->out; b++)
			all->sweep->branch(result, row + (size_t)(all->in + b), b, sample->mode + sample->in + b);
	}
	for (; next < all->crossovers; next++)
		read_crossover(result, all, all->crossover + next);
}
