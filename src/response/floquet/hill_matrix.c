/* response/floquet/hill_matrix.c - see hill_matrix.h.
 *
 *    p       highest harmonic of D and K: blocks (m, l) with |m - l| > p are zero
 *    centre  harmonics -c - q to c, c = p/2, q = 1 for lambda = i Omega/2 and otherwise 0. They are
 *            at least p, so that only the centre couples the harmonics above and below; and
 *            for a multiplier +1 or -1 those below are the conjugates of those above
 *    tail    harmonics above the centre, in groups of p, eliminated from the highest group on
 *    w       p n, order of a group
 *
 * The matrix is block tridiagonal in the groups. Elimination from both ends towards the centre
 * stores two groups only; each group is eliminated with partial pivoting inside the group. The
 * harmonics below the centre at lambda are the conjugates of those above it at the conjugate of
 * lambda.
 *
 * The test function is the determinant of the whole matrix. That of the centre after elimination
 * would have poles where the tail alone is singular. The eigenvalues of the monodromy matrix give
 * the same zeros. Stiff coordinates, however, need no short steps here: the equations contain their
 * response in each harmonic exactly, whatever their frequency.
 *
 * Reference: Magnus and Winkler, Hill's Equation, 2.3; Meyer and Golub, block elimination.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/hot.h"
#include "core/report.h"
#include "response/floquet/hill_matrix.h"

#define NEGLIGIBLE 1e-22   /* bound of the relative change by further harmonics: far below
                            * round-off */
#define MOST_HARMONICS 2000 /* with more harmonics, the computation of multipliers is faster */
#define AFFORDABLE 5e7     /* operations of a determinant; above, the computation of multipliers is
                            * faster */
#define LEAST_GROUPS 2     /* groups of harmonics above the centre; one is enough for constant
                            * coefficients */

static int highest(const struct hawser__variational *system)
{
	int p = system->order > system->order_d ? system->order : system->order_d;

	return p > 1 ? p : 1;
}

/* --- how many harmonics --- */

/* Sum over the harmonics of |coefficient| of entry e. */
static double coupling(const double *series, int order, size_t n2, size_t e)
{
	double sum = 0.0;

	for (int k = 1; k <= order; k++)
		sum += 0.5*hypot(series[(2*(size_t)k - 1)*n2 + e], series[2*(size_t)k*n2 + e]);
	return sum;
}

/* Largest ratio of the coupling of harmonic m with its neighbours to its diagonal term. */
static double ratio(const struct hawser__variational *system, const double *couples, double *own,
                    double kappa)
{
	int n = system->n;
	size_t n2 = (size_t)n*n;
	double most = 0.0;

	for (int j = 0; j < n; j++) {
		size_t e = (size_t)j*(n + 1);

		own[j] = sqrt(hypot(0.5*system->K[e] - kappa*kappa, 0.5*kappa*system->D[e]));
	}
	for (int i = 0; i < n; i++) {
		double sum = 0.0;

		for (int j = 0; j < n; j++)
			sum += (couples[i*n + j] + kappa*couples[n2 + i*n + j])/(own[i]*own[j]);
		most = fmax(most, sum);
	}
	return most;
}

int hawser__hill_harmonics(const struct hawser__variational *system, const double lambda[2])
{
	int n = system->n, p = highest(system), m;
	size_t n2 = (size_t)n*n;
	double *couples = malloc((2*n2 + (size_t)n)*sizeof *couples), *own = hawser__behind(couples, 2*n2);
	double left = 1.0, w = (double)p*n, groups;

	if (!couples)
		return 0;
	for (size_t e = 0; e < n2; e++) {
		couples[e] = coupling(system->K, system->order, n2, e);
		couples[n2 + e] = coupling(system->D, system->order_d, n2, e);
	}
	/* the harmonics above the centre couple to those beyond and back */
	for (m = p/2; m < MOST_HARMONICS && (left > NEGLIGIBLE || m < p/2 + LEAST_GROUPS*p); m += p) {
		double most = 0.0;

		for (int k = 1; k <= p; k++)
			most = fmax(most, ratio(system, couples, own,
			                        (m + k)*system->omega - fabs(lambda[1])));
		left = fmin(1e30, left*most*most);
	}
	free(couples);
	groups = (double)(m - p/2)/p;
	return m < MOST_HARMONICS && 40.0*groups*w*w*w < AFFORDABLE ? m : 0;
}

/* --- elimination --- */

/* A complex matrix by rows of `width` doubles, real and imaginary parts separately. */
struct square {
	double *re, *im;
	double *scale; /* [harmonics - least + 1][n], set_scales */
	int least;
	int width; /* HAWSER_PADDED */
};

/* Subtract f times row k from row i, from the block of column `from` on. */
HAWSER_PART void subtract(double *re, double *im, const double *kre, const double *kim, double fr,
                          double fi, int from, int width)
{
	for (int b = from/HAWSER_BLOCK*HAWSER_BLOCK; b < width; b += HAWSER_BLOCK) {
		const hawser__vec x = *(const hawser__vec *)(kre + b), y = *(const hawser__vec *)(kim + b);

		*(hawser__vec *)(re + b) -= fr*x - fi*y;
		*(hawser__vec *)(im + b) -= fr*y + fi*x;
	}
}

static void exchange(double *a, double *b, int width)
{
	for (int i = 0; i < width; i++) {
		double keep = a[i];

		a[i] = b[i];
		b[i] = keep;
	}
}

/* A product of many pivots, as value times 2^exponent. */
struct product {
	double re, im;
	int exponent;
};

HAWSER_PART void multiply(struct product *by, double re, double im)
{
	double keep = by->re*re - by->im*im;

	by->im = by->re*im + by->im*re;
	by->re = keep;
}

static void rescale(struct product *of)
{
	int exponent = 0;
	double size = fmax(fabs(of->re), fabs(of->im));

	if (!(size > 0.0 && isfinite(size)))
		return;
	(void)frexp(size, &exponent);
	of->re = ldexp(of->re, -exponent);
	of->im = ldexp(of->im, -exponent);
	of->exponent += exponent;
}

/* Eliminate the first w columns of all `rows` rows, with pivots from the first w rows. The Schur
 * complement is below and to the right. `value` is multiplied by the product of the pivots. */
HAWSER_HOT
static void eliminate(double *re, double *im, struct product *value, int width, int w, int rows)
{
	for (int k = 0; k < w; k++) {
		double *kre, *kim, most = -1.0, size;
		int at = k;

		for (int i = k; i < w; i++) {
			double x = re[i*width + k], y = im[i*width + k];

			if (x*x + y*y > most) {
				most = x*x + y*y;
				at = i;
			}
		}
		kre = re + (size_t)k*width;
		kim = im + (size_t)k*width;
		if (at != k) {
			exchange(kre, re + (size_t)at*width, width);
			exchange(kim, im + (size_t)at*width, width);
			multiply(value, -1.0, 0.0);
		}
		multiply(value, kre[k], kim[k]);
		size = kre[k]*kre[k] + kim[k]*kim[k];
		for (int i = k + 1; i < rows && size > 0.0; i++) {
			double *ire = re + (size_t)i*width, *iim = im + (size_t)i*width;
			double fr = (ire[k]*kre[k] + iim[k]*kim[k])/size;
			double fi = (iim[k]*kre[k] - ire[k]*kim[k])/size;

			if (fr != 0.0 || fi != 0.0)
				subtract(ire, iim, kre, kim, fr, fi, k + 1, width);
		}
	}
}

/* What rows and columns of the harmonics from square->least on are divided by, inverted. */
static void set_scales(double *scale, const struct hawser__variational *system, double imaginary,
                       int first, int last)
{
	double least = system->omega*system->omega;

	for (int m = first; m <= last; m++, scale += system->n) {
		double km = imaginary + m*system->omega;

		for (int i = 0; i < system->n; i++) {
			double own = fabs(system->K[(size_t)i*(system->n + 1)]);

			scale[i] = 1.0/sqrt((0.5*own > least ? 0.5*own : least) + km*km);
		}
	}
}

/* Entries of block (m, l) of the row that K and D begin with, without those of the diagonal. */
HAWSER_PART void fill_row(double *re, double *im, const struct hawser__variational *system,
                     const double lambda[2], int k, double side, double kl, size_t row)
{
	int n = system->n;
	size_t n2 = (size_t)n*n, cosine = k ? 2*(size_t)k - 1 : 0, sine = 2*(size_t)k;
	const double *a = system->K + cosine*n2 + row, *b = system->K + sine*n2 + row;

	for (int j = 0; j < n; j++) {
		re[j] = k <= system->order ? 0.5*a[j] : 0.0;
		im[j] = k && k <= system->order ? side*b[j] : 0.0;
	}
	if (k > system->order_d)
		return;
	a = system->D + cosine*n2 + row;
	b = system->D + sine*n2 + row;
	for (int j = 0; j < n; j++) {
		double dr = 0.5*a[j], di = k ? side*b[j] : 0.0;

		re[j] += lambda[0]*dr - kl*di;
		im[j] += lambda[0]*di + kl*dr;
	}
}

/* Put block (m, l), divided by the scales, at (row, column). */
HAWSER_HOT
static void fill(const struct square *to, const struct hawser__variational *system,
                 const double lambda[2], int m, int l, int row, int column)
{
	int n = system->n, d = m - l;
	double kl = lambda[1] + l*system->omega;
	const double *left = to->scale + (size_t)(m - to->least)*n;
	const double *right = to->scale + (size_t)(l - to->least)*n;

	for (int i = 0; i < n; i++) {
		double *re = to->re + (size_t)(row + i)*to->width + column;
		double *im = to->im + (size_t)(row + i)*to->width + column;

		fill_row(re, im, system, lambda, abs(d), d < 0 ? 0.5 : -0.5, kl, (size_t)i*n);
		if (d == 0) {
			re[i] += lambda[0]*lambda[0] - kl*kl;
			im[i] += 2.0*lambda[0]*kl;
		}
		for (int j = 0; j < n; j++) {
			re[j] *= left[i]*right[j];
			im[j] *= left[i]*right[j];
		}
	}
}

static void clear(const struct square *square, int rows)
{
	size_t size = (size_t)rows*square->width*sizeof(double);

	memset(square->re, 0, size);
	memset(square->im, 0, size);
}

/* Blocks of the rows of harmonics m.., columns of harmonics l.., p of each. */
static void fill_group(const struct square *to, const struct hawser__variational *system,
                       const double lambda[2], int p, int m, int l, int row, int column)
{
	for (int a = 0; a < p; a++)
		for (int b = 0; b < p; b++)
			if (abs(m + a - l - b) <= p)
				fill(to, system, lambda, m + a, l + b, row + a*system->n,
				     column + b*system->n);
}

/* Move the lower right block to the upper left. */
static void move_up(const struct square *square, int w)
{
	for (int i = 0; i < w; i++) {
		size_t to = (size_t)i*square->width, from = (size_t)(w + i)*square->width + w;

		memmove(square->re + to, square->re + from, (size_t)w*sizeof(double));
		memmove(square->im + to, square->im + from, (size_t)w*sizeof(double));
	}
}

/* The contribution of the harmonics above the centre to its block of the p harmonics up to c: the
 * lower right block of *work; `value` is multiplied by their determinant. */
static void tail(const struct square *work, struct product *value,
                 const struct hawser__variational *system, const double lambda[2], int harmonics)
{
	int p = highest(system), n = system->n, w = p*n, c = p/2, m = harmonics - p + 1;
	int width = work->width;

	clear(work, 2*w);
	fill_group(work, system, lambda, p, m, m, 0, 0);
	for (; m > c; m -= p) {
		for (int i = 0; i < w; i++) { /* the upper right block */
			memset(work->re + (size_t)i*width + w, 0, (size_t)(width - w)*sizeof(double));
			memset(work->im + (size_t)i*width + w, 0, (size_t)(width - w)*sizeof(double));
		}
		memset(work->re + (size_t)w*width, 0, (size_t)w*width*sizeof(double));
		memset(work->im + (size_t)w*width, 0, (size_t)w*width*sizeof(double));
		fill_group(work, system, lambda, p, m, m - p, 0, w);
		fill_group(work, system, lambda, p, m - p, m, w, 0);
		if (m - p > c)
			fill_group(work, system, lambda, p, m - p, m - p, w, w);
		eliminate(work->re, work->im, value, width, w, 2*w);
		rescale(value);
		if (m - p > c)
			move_up(work, w);
	}
}

/* Add the lower right block of *from, or its conjugate with the harmonics in reverse order. */
static void add_tail(const struct square *centre, const struct square *from, int at, int n, int p,
                     int below)
{
	int w = n*p;

	for (int i = 0; i < w; i++)
		for (int j = 0; j < w; j++) {
			int row = below ? (p - 1 - i/n)*n + i%n : i, column = below ? (p - 1 - j/n)*n + j%n : j;
			size_t to = (size_t)(at + row)*centre->width + (size_t)(at + column);
			size_t here = (size_t)(w + i)*from->width + (size_t)(w + j);

			centre->re[to] += from->re[here];
			centre->im[to] += below ? -from->im[here] : from->im[here];
		}
}

static enum hawser_status make_room(struct square *work, struct square *centre,
                                    struct hawser__hill_matrix *matrix, int w, int order,
                                    int scales, struct hawser_report *report)
{
	size_t one, all;

	work->width = HAWSER_PADDED(2*w);
	centre->width = HAWSER_PADDED(order);
	one = 2*(size_t)w*(size_t)work->width;
	all = 2*(one + (size_t)order*(size_t)centre->width) + (size_t)scales;
	if (all > matrix->room) {
		free(matrix->memory);
		matrix->memory = malloc(all*sizeof(double));
		matrix->room = matrix->memory ? all : 0;
		if (!matrix->memory)
			return hawser__no_memory(report, "hill");
	}
	work->re = matrix->memory;
	work->im = work->re + one;
	centre->re = work->im + one;
	centre->im = centre->re + (size_t)order*(size_t)centre->width;
	work->scale = centre->scale = centre->im + (size_t)order*(size_t)centre->width;
	return HAWSER_OK;
}

void hawser__hill_matrix_release(struct hawser__hill_matrix *matrix)
{
	free(matrix->memory);
	*matrix = (struct hawser__hill_matrix){.room = 0};
}

enum hawser_status hawser__hill_determinant(double value[3], int *exponent,
                                            struct hawser__hill_matrix *matrix,
                                            const struct hawser__variational *system,
                                            const double lambda[2], int harmonics,
                                            struct hawser_report *report)
{
	int n = system->n, p = highest(system), c = p/2, w = p*n;
	int half = lambda[0] == 0.0 && lambda[1] == 0.5*system->omega;
	int first = -c - half, order = (c - first + 1)*n;
	int real = lambda[0] == 0.0 && (half || lambda[1] == 0.0);
	struct square work, centre;
	enum hawser_status status = make_room(&work, &centre, matrix, w, order,
	                                      (harmonics - first + 1)*n, report);
	struct product above = {1.0, 0.0, 0}, below = {1.0, 0.0, 0};
	const double conjugate[2] = {lambda[0], -lambda[1]};
	double least = INFINITY; /* smallest pivot of the centre */

	if (status)
		return status;
	work.least = centre.least = first;
	set_scales(work.scale, system, lambda[1], first, harmonics);
	clear(&centre, order);
	for (int m = first; m <= c; m++)
		for (int l = first; l <= c; l++)
			if (abs(m - l) <= p)
				fill(&centre, system, lambda, m, l, (m - first)*n, (l - first)*n);
	tail(&work, &above, system, lambda, harmonics);
	add_tail(&centre, &work, order - w, n, p, 0);
	if (real) {
		below = above;
	} else {
		set_scales(work.scale, system, conjugate[1], first, harmonics);
		tail(&work, &below, system, conjugate, harmonics);
	}
	add_tail(&centre, &work, 0, n, p, 1);
	multiply(&above, below.re, -below.im);
	above.exponent += below.exponent;
	eliminate(centre.re, centre.im, &above, centre.width, order, order);
	rescale(&above);
	for (int k = 0; k < order; k++)
		least = fmin(least, hypot(centre.re[(size_t)k*centre.width + k],
		                          centre.im[(size_t)k*centre.width + k]));
	value[0] = above.re;
	value[1] = above.im;
	value[2] = least > 0.0 ? order*DBL_EPSILON*hypot(above.re, above.im)/least : 0.0;
	*exponent = above.exponent;
	return HAWSER_OK;
}
