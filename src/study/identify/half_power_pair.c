/* study/identify/half_power_pair.c - the amplitudes of two close modes; see half_power.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_cdf.h>

#include "study/identify/half_power.h"
#include "study/identify/identify.h"

enum { EQUAL = HAWSER__HALF_EQUAL, SHAPES = HAWSER__HALF_SHAPES, MOST = HAWSER__HALF_MOST };
/* FEWEST: points that correlated ones count as at least. Steps of the fit, the first ones from each
 * beginning. */
enum { FEWEST = 5, FIRST_STEPS = 30, STEPS = 200 };

/* --- what all fits share --- */

void hawser__half_join(double R[MOST][MOST + 1], double row[MOST + 1], int count)
{
	for (int j = 0; j < count; j++) {
		double r = hypot(R[j][j], row[j]), c = r > 0.0 ? R[j][j]/r : 1.0;
		double s = r > 0.0 ? row[j]/r : 0.0;

		for (int k = j; k <= count; k++) {
			double upper = c*R[j][k] + s*row[k];

			row[k] = c*row[k] - s*R[j][k];
			R[j][k] = upper;
		}
	}
}

void hawser__half_solve(double *p, const double R[MOST][MOST + 1], int count)
{
	for (int j = count - 1; j >= 0; j--) {
		p[j] = R[j][count];
		for (int k = j + 1; k < count; k++)
			p[j] -= R[j][k]*p[k];
		p[j] /= R[j][j];
	}
}

double hawser__half_spread(const double R[MOST][MOST + 1], const double *g, int count)
{
	double v[MOST], sum = 0.0;

	for (int j = 0; j < count; j++) {
		v[j] = g[j];
		for (int i = 0; i < j; i++)
			v[j] -= R[i][j]*v[i];
		v[j] /= R[j][j];
		sum += v[j]*v[j];
	}
	return sqrt(sum);
}

/* Standard deviation of a point. With a correlation rho of neighbours, n points count as n (1 -
 * rho)/(1 + rho), but at least FEWEST: smooth residuals, which a curve that is not of the fitted kind
 * causes, do not average out. */
double hawser__half_deviation(const struct hawser__half_residuals *residuals, int count, int unknowns)
{
	double rho = residuals->sum > 0.0 ? fmax(residuals->lag/residuals->sum, 0.0) : 0.0;
	double loss = fmin((1.0 + rho)/(1.0 - rho), (double)count/FEWEST);

	return sqrt(residuals->sum*loss/(count - unknowns));
}

/* --- two modes --- */

double complex hawser__half_pair_at(double complex by[SHAPES],
                                    const struct hawser__half_pair_of *pair, const double *q, double w)
{
	double scale = 2.0*pair->ratio*pair->wp*pair->wp;
	double complex H = 0.0;

	by[0] = by[1] = by[2] = by[EQUAL] = 0.0;
	for (int k = 0; k < 2; k++) {
		double side = k ? 1.0 : -1.0, wk = pair->wp*(1.0 + pair->ratio*(q[0] + side*q[1]));
		double xi = pair->ratio*exp(q[2] + (pair->unknowns > EQUAL ? side*q[EQUAL] : 0.0));
		double re = wk*wk - w*w, im = 2.0*xi*wk*w, size = re*re + im*im;
		double complex by_xi, inverse = re/size - I*im/size, part = scale*inverse;
		double complex slope = -q[3 + k]*part*inverse;
		double complex by_w = slope*(2.0*wk + 2.0*I*xi*w)*pair->wp*pair->ratio;

		by[3 + k] = part;
		by[0] += by_w;
		by[1] += side*by_w;
		by_xi = slope*I*im;
		by[2] += by_xi;
		by[EQUAL] += side*by_xi;
		H += q[3 + k]*part;
	}
	return H;
}

/* Unknowns but the ratio, and their places in q. OTHERS: beginnings. */
enum { REST = HAWSER__HALF_EQUAL - 1, OTHERS = 7 };
static const int rest[REST] = {0, 1, 3, 4};

static enum hawser_status pair_residuals(void *context, double *r, double *J, const double *x)
{
	const struct hawser__half_pair_of *pair = context;
	double from_rest[SHAPES] = {0.0};
	const double *q = pair->held ? from_rest : x;
	const struct hawser__half_table *table = pair->table;
	int count = pair->span.last - pair->span.first + 1;

	for (int j = 0; pair->held && j < REST; j++)
		from_rest[rest[j]] = x[j];
	from_rest[2] = pair->held ? *pair->held : 0.0;
	for (int i = 0; i < count; i++) {
		double complex by[SHAPES];
		int at = pair->span.first + i;
		double complex H = hawser__half_pair_at(by, pair, q, table->omega[at]);

		if (r)
			r[i] = cabs(H) - table->a[at]/table->a[table->best];
		for (int j = 0; !r && j < (pair->held ? REST : pair->unknowns); j++)
			J[j*count + i] = creal(conj(H)*by[pair->held ? rest[j] : j])/fmax(cabs(H), DBL_MIN);
	}
	return HAWSER_OK;
}

/* Confidence interval and scatter of the pair q. */
static void judge_pair(struct hawser__half_fit *two, const struct hawser__half_pair_of *pair,
                       const double *q, double confidence)
{
	const struct hawser__half_table *table = pair->table;
	int count = pair->span.last - pair->span.first + 1;
	int m = pair->unknowns;
	double R[MOST][MOST + 1] = {{0.0}}, apart = m > EQUAL ? q[EQUAL] : 0.0;
	double mean, deviation, joint;
	struct hawser__half_residuals residuals = {0.0, 0.0, 0.0};

	mean = pair->ratio*exp(q[2])*cosh(apart);
	for (int i = pair->span.first; i <= pair->span.last; i++) {
		double complex by[SHAPES], H = hawser__half_pair_at(by, pair, q, table->omega[i]);
		double row[MOST + 1] = {0.0};

		for (int j = 0; j < m; j++)
			row[j] = creal(conj(H)*by[j])/fmax(cabs(H), DBL_MIN);
		hawser__half_join(R, row, m);
		hawser__half_add(&residuals, cabs(H) - table->a[i]/table->a[table->best]);
	}
	two->scatter = hawser__half_deviation(&residuals, count, m);
	two->sum = residuals.sum;
	deviation = fmax(8.0*DBL_EPSILON*(1.0 + 1.0/pair->ratio), two->scatter);
	/* both ratios at once: Scheffe's factor */
	joint = deviation*sqrt(2.0*gsl_cdf_fdist_Pinv(confidence, 2, count - m));
	deviation *= gsl_cdf_tdist_Pinv(0.5 + 0.5*confidence, count - m);
	two->ratio = mean;
	two->both = 0.0;
	two->ratio_error = deviation*hawser__half_spread((const double (*)[MOST + 1])R, (double[SHAPES]){
		[2] = mean, [EQUAL] = mean*tanh(apart)}, m);
	two->apart = fabs(mean*tanh(apart));
	for (int k = 0; k < 2; k++) {
		double side = k ? 1.0 : -1.0, xi = pair->ratio*exp(q[2] + side*apart);

		two->both = fmax(two->both, fabs(xi - mean) +
			joint*hawser__half_spread((const double (*)[MOST + 1])R, (double[SHAPES]){
				[2] = xi, [EQUAL] = side*xi}, m));
	}
}

/* The best of the fits from several pairs with one ratio. Returns 0 if there is none. */
static int begin_pair(double q[SHAPES], const struct hawser__least_squares *problem)
{
	/* equal parts, unequal ones, and of different signs */
	static const double begin[][SHAPES] = {{0.0, 0.3, -0.05, 0.5, 0.5}, {0.0, 0.7, -0.3, 0.6, 0.5},
		{0.1, 0.5, -0.1, 0.8, 0.2}, {-0.1, 0.5, -0.1, 0.2, 0.8}, {0.1, 0.4, 0.1, 1.2, -0.15},
		{-0.1, 0.4, 0.1, -0.15, 1.2}, {0.2, 0.5, 0.1, 1.7, -0.7}, {-0.2, 0.5, 0.1, -0.7, 1.7},
		{0.4, 0.3, 0.2, 2.8, -2.0}, {-0.4, 0.3, 0.2, -2.0, 2.8}};
	double least = INFINITY;

	for (size_t k = 0; k < sizeof begin/sizeof *begin; k++) {
		double from[SHAPES], sum;
		int steps;

		memcpy(from, begin[k], sizeof from);
		if (hawser__least_squares(from, &sum, &steps, problem) || !(sum < least))
			continue;
		least = sum;
		memcpy(q, from, sizeof from);
	}
	return isfinite(least);
}

/* From q, or, with `unknowns` EQUAL, from anywhere. Returns 0 if there is no fit. */
int hawser__half_pair(double q[SHAPES], struct hawser__half_fit *two,
                      struct hawser__half_pair_of *pair, int unknowns)
{
	struct hawser__least_squares problem = {.unknowns = unknowns,
		.count = pair->span.last - pair->span.first + 1, .residuals = pair_residuals,
		.context = pair, .least_step = 1e-10, .steps = FIRST_STEPS};
	double sum;
	int steps;

	pair->unknowns = unknowns;
	if (unknowns == EQUAL && !begin_pair(q, &problem))
		return 0;
	problem.steps = STEPS;
	if (hawser__least_squares(q, &sum, &steps, &problem))
		return 0;
	judge_pair(two, pair, q, pair->table->confidence);
	return isfinite(two->ratio) && isfinite(two->ratio_error);
}

/* --- pairs that noise hides --- */

/* Whether pairs with the ratio of `held` have a sum of squares below `limit`: from the last ones x, or
 * from `others`. */
static int reaches(double x[REST], struct hawser__half_pair_of *pair, double held, double limit,
                   int others)
{
	/* equal parts, unequal ones, and of different signs; the distance follows the ratio */
	static const double begin[OTHERS][REST] = {{0.0, 1.0, 0.5, 0.5}, {0.5, 1.0, 0.8, 0.2},
		{-0.5, 1.0, 0.2, 0.8}, {0.5, 1.0, 1.2, -0.15}, {-0.5, 1.0, -0.15, 1.2},
		{1.0, 1.0, 2.8, -2.0}, {-1.0, 1.0, -2.0, 2.8}};
	struct hawser__least_squares problem = {.unknowns = REST,
		.count = pair->span.last - pair->span.first + 1, .residuals = pair_residuals,
		.context = pair, .least_step = 1e-6, .steps = FIRST_STEPS};
	double sum = INFINITY, apart = sqrt(2.0*fabs(held)), from[REST];
	int steps;

	pair->held = &held;
	for (int k = -1; k < others && !(sum <= limit); k++) {
		for (int j = 0; j < REST; j++)
			from[j] = k < 0 ? x[j] : begin[k][j]*(j < 2 ? apart : 1.0);
		if (hawser__least_squares(from, &sum, &steps, &problem))
			sum = INFINITY;
	}
	pair->held = NULL;
	if (!(sum <= limit))
		return 0;
	memcpy(x, from, sizeof from);
	return 1;
}

void hawser__half_reach(double reach[2], const double q[SHAPES], double sum,
                        const struct hawser__half_pair_of *of)
{
	enum { MARCH = 12, HALVE = 4 };
	static const double step = 0.015; /* of the logarithm of the ratio; chosen */
	struct hawser__half_pair_of pair = *of;
	int free_points = pair.span.last - pair.span.first + 1 - EQUAL;
	double t = gsl_cdf_tdist_Pinv(0.5 + 0.5*pair.table->confidence, free_points);
	double limit = sum*(1.0 + t*t/free_points);

	for (int k = 0; k < 2; k++) {
		double x[REST], inside = q[2], change = k ? step : -step;

		for (int j = 0; j < REST; j++)
			x[j] = q[rest[j]];
		for (int i = 0; i < MARCH && reaches(x, &pair, inside + change, limit, OTHERS); i++)
			inside += change;
		for (int i = 0; i < HALVE; i++) {
			change *= 0.5;
			if (reaches(x, &pair, inside + change, limit, 0))
				inside += change;
		}
		reach[k] = pair.ratio*exp(inside + change);
	}
}
