/* response/cycle/hopf.c - see hopf.h.
 *
 *    x = (u, u') [m], of equations of first order u; x' = A x + B(x, x)/2 + C(x, x, x)/6 + ...
 *    q, p    A q = i w q, A' p = -i w p, <q, q> = <p, q> = 1
 *    l1      Re[<p, C(q, q, q*)> - 2 <p, B(q, A^-1 B(q, q*))>
 *               + <p, B(q*, (2 i w - A)^-1 B(q, q))>]/(2 w)
 *
 * On the centre manifold z' = (g + i w) z + w l1 z |z|^2, where g is the growth rate and x = z q +
 * z* q*, so that the square of the amplitude of coordinate j changes by -4 |q_j|^2 g'/(w l1) per
 * unit of the parameter.
 *
 * Reference: Kuznetsov, Elements of Applied Bifurcation Theory, 3rd ed., (5.34).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/cycle/hopf.h"
#include "rom/terms/drag.h"

/* Distance of the two models whose difference is the derivative by the parameter, relative to its
 * size: the error by third derivatives is about 1e-8. */
#define NUDGE 1e-4
#define MOST_STEPS 20 /* of Newton's method for a Hopf point */
#define NEAR 1e-11    /* and its last step, relative */
#define SAME 1e-6     /* distance of eigenvalues that are one, relative, and of vectors; chosen */
#define ROUND_OFF 1e-12 /* of the first Lyapunov coefficient, relative to its terms; chosen */

struct form {
	const struct hawser_rom *rom; /* of first order: as it stands */
	const struct hawser_rom *whole;
	int n, m;
	double *x;                    /* [2n] the equilibrium */
	double *A, *by_u, *by_v, *acceleration; /* [2n][2n] column-major, [n][n], [n][n], [n + 2n] */
	double *re, *im, *left, *right;
	double complex *q, *p, *star, *work, *part, *matrix;
	lapack_int *pivot;
	struct hawser__hold hold;
};

static enum hawser_status open_form(struct form *form, int n, struct hawser_report *report)
{
	size_t m = 2*(size_t)n;

	*form = (struct form){.n = n};
	form->x = hawser__hold(&form->hold, m, sizeof(double));
	form->A = hawser__hold(&form->hold, m*m, sizeof(double));
	form->by_u = hawser__hold(&form->hold, m*m, sizeof(double));
	form->acceleration = hawser__hold(&form->hold, 3*m, sizeof(double));
	form->re = hawser__hold(&form->hold, 2*m, sizeof(double));
	form->left = hawser__hold(&form->hold, m*m, sizeof(double));
	form->right = hawser__hold(&form->hold, m*m, sizeof(double));
	form->q = hawser__hold(&form->hold, 5*m, sizeof(double complex));
	form->matrix = hawser__hold(&form->hold, m*m, sizeof(double complex));
	form->pivot = hawser__hold(&form->hold, m, sizeof *form->pivot);
	if (form->hold.short_of_memory)
		return hawser__no_memory(report, "hopf");
	form->by_v = form->by_u + (size_t)n*n;
	form->im = form->re + m;
	form->p = form->q + m;
	form->star = form->p + m;
	form->work = form->star + m;
	form->part = form->work + m;
	return HAWSER_OK;
}

/* --- second and third derivatives --- */

/* value times a product of entries of x, on the left side of equation j. */
struct product {
	int j, factors;
	int at[HAWSER_TERM_FACTORS];
	double value;
};

/* The sum over the ways to replace `count` factors by the vectors a, b (and c). */
static double complex replaced(const struct product *product, const double *x,
                               const double complex *const vector[], int count, unsigned gone)
{
	double complex sum = 0.0;

	if (count == 0) {
		sum = product->value;
		for (int f = 0; f < product->factors; f++)
			sum *= gone >> f & 1u ? 1.0 : x[product->at[f]];
		return sum;
	}
	for (int f = 0; f < product->factors; f++)
		if (!(gone >> f & 1u))
			sum += vector[0][product->at[f]]*replaced(product, x, vector + 1, count - 1,
			                                          gone | 1u << f);
	return sum;
}

static void take_term(double complex *out, const struct form *form, const struct hawser_term *term,
                      const double complex *const vector[], int count)
{
	struct product product = {.j = term->j, .factors = term->factors, .value = term->value};

	for (int f = 0; f < term->factors; f++)
		product.at[f] = term->factor[f] + (f < term->factors - term->rates ? 0 : form->n);
	out[product.j] -= replaced(&product, form->x, vector, count, 0);
}

static void take_quad(double complex *out, const struct form *form, const struct hawser_quad *quad,
                      const double complex *const vector[], int count)
{
	const struct product product = {quad->j, 2, {quad->k, quad->l}, quad->value};

	out[product.j] -= replaced(&product, form->x, vector, count, 0);
}

/* out [m]: the derivative of order `count` in the directions of the vectors [m]. */
static void derivative(double complex *out, const struct form *form,
                       const double complex *const vector[], int count)
{
	const struct hawser_rom *rom = form->rom;
	double complex *to = out + (form->m - form->n);

	memset(out, 0, (size_t)form->m*sizeof *out);
	for (int i = 0; count == 2 && i < rom->quads; i++)
		take_quad(to, form, &rom->Q[i], vector, count);
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];
		const struct product product = {c->j, 3, {c->k, c->l, c->m}, c->value};

		to[c->j] -= replaced(&product, form->x, vector, count, 0);
	}
	for (int i = 0; i < rom->terms; i++)
		take_term(to, form, &rom->term[i], vector, count);
	if (rom->drag) {
		const double complex *const rate[] = {vector[0] + form->n, vector[1] + form->n,
		                                      count > 2 ? vector[2] + form->n : NULL};

		hawser__drag_form(rom->drag, to, rate, count);
	}
	for (int h = 0; h < rom->harmonics; h++) {
		for (int i = 0; count == 2 && i < rom->harmonic[h].quads; i++)
			take_quad(to, form, &rom->harmonic[h].Q[i], vector, count);
		for (int i = 0; i < rom->harmonic[h].terms; i++)
			take_term(to, form, &rom->harmonic[h].term[i], vector, count);
	}
}

/* --- vectors --- */

static double complex dot(const double complex *a, const double complex *b, int m)
{
	double complex sum = 0.0;

	for (int i = 0; i < m; i++)
		sum += conj(a[i])*b[i];
	return sum;
}

/* b = (shift - A)^-1 b; form->A is that of the equilibrium. 1: singular. */
static int resolve(struct form *form, double complex *b, double complex shift)
{
	int m = form->m;

	for (int i = 0; i < m*m; i++)
		form->matrix[i] = (i%(m + 1) == 0 ? shift : 0.0) - form->A[i];
	return LAPACKE_zgesv(LAPACK_COL_MAJOR, m, 1, (lapack_complex_double *)form->matrix, m, form->pivot,
	                     (lapack_complex_double *)b, m) != 0;
}

/* --- a model that may be rotated --- */

/* x becomes the part of x that goes round with i G = k, and other the rest. */
static void divide(double complex *x, double complex *other, const double *G, int n, int m)
{
	double complex *turned = other;
	double square = 0.0;

	for (int i = 0; i < m; i++) {
		turned[i] = 0.0;
		for (int k = 0; k < n; k++)
			turned[i] += G[i%n*n + k]*x[i/n*n + k];
	}
	square = creal(dot(turned, turned, m))/creal(dot(x, x, m));
	for (int i = 0; i < m; i++) {
		double complex half = square > 0.0 ? 0.5*(x[i] - I*turned[i]/sqrt(square)) : x[i];

		other[i] = x[i] - half;
		x[i] = half;
	}
}

/* x [m] = a x + b y. */
static void blend(double complex *x, double complex a, double complex b, const double complex *y,
                  int m)
{
	for (int i = 0; i < m; i++)
		x[i] = a*x[i] + b*y[i];
}

/* Two pairs are one where the model may be rotated by G: q and p become those of a rotation, or of a
 * motion in one direction, in which both rotations are equal. */
static void choose_turning(struct form *form, const double *G, int turning)
{
	int m = form->m, n = form->n;
	double complex *q = form->q, *p = form->p, *rest = form->work, *p_rest = form->part;
	double size[2];

	divide(q, rest, G, n, m);
	divide(p, p_rest, G, n, m);
	size[0] = sqrt(creal(dot(q, q, m)));
	size[1] = sqrt(creal(dot(rest, rest, m)));
	if (size[0] <= SAME*size[1] || size[1] <= SAME*size[0] || turning) {
		int second = size[0] <= SAME*size[1];

		blend(q, !second, second, rest, m);
		blend(p, !second, second, p_rest, m);
	} else {
		double complex a = conj(size[0]/dot(p, q, m)), b = conj(size[1]/dot(p_rest, rest, m));

		blend(q, 1.0/size[0], 1.0/size[1], rest, m);
		blend(p, a, b, p_rest, m);
	}
}

/* --- eigenvectors --- */

static void set_matrix(struct form *form, const struct hawser_rom *rom)
{
	form->whole = rom;
	form->rom = rom->first ? rom->first : rom;
	form->m = hawser__autonomous_matrix(form->A, form->by_u, form->by_v, form->acceleration, rom,
	                                    form->x, form->x + form->n);
}

/* How far a pair is from the wanted one. */
static double off(const struct form *form, int i, double guess)
{
	return guess > 0.0 ? hypot(form->re[i], form->im[i] - guess) : fabs(form->re[i]);
}

/* Whether another eigenvalue is that of index i. */
static int is_double(const struct form *form, int i)
{
	int found = 0;

	for (int k = 0; k < form->m; k++)
		found |= k != i && hypot(form->re[k] - form->re[i], form->im[k] - form->im[i]) <=
		                   SAME*fabs(form->im[i]);
	return found;
}

/* q and p of the eigenvalue nearest to i guess, or to the axis, and *value. */
static enum hawser_status eigenvectors(struct form *form, double complex *value, double guess,
                                       int turning, struct hawser_report *report)
{
	int m = form->m, best = -1, info, turns = 0;
	double complex length;
	enum hawser_status status = HAWSER_OK;

	info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'V', 'V', m, form->A, m, form->re, form->im, form->left, m,
	                     form->right, m);
	for (int i = 0; !info && i < m; i++)
		if (form->im[i] > 0.0 && (best < 0 || off(form, i, guess) < off(form, best, guess)))
			best = i;
	if (hawser__lapack_starved(info))
		return hawser__no_memory(report, "hopf");
	if (best < 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf",
		                    "the pair of eigenvalues of a Hopf point was not found");
	*value = form->re[best] + I*form->im[best];
	for (int i = 0; i < m; i++) {
		form->q[i] = form->right[(size_t)best*m + i] + I*form->right[(size_t)(best + 1)*m + i];
		form->p[i] = form->left[(size_t)best*m + i] + I*form->left[(size_t)(best + 1)*m + i];
	}
	if (is_double(form, best))
		status = hawser__cycle_turn(form->by_u, &turns, form->whole, report);
	if (turns)
		choose_turning(form, form->by_u, turning);
	length = csqrt(dot(form->q, form->q, m));
	for (int i = 0; i < m; i++)
		form->q[i] /= length;
	length = conj(dot(form->p, form->q, m));
	for (int i = 0; i < m; i++)
		form->p[i] /= length;
	for (int i = 0; i < m; i++)
		form->star[i] = conj(form->q[i]);
	return status;
}

/* --- the normal form --- */

/* Add a multiple of <p, part>. */
static void add_product(double complex *sum, double *size, double times, const struct form *form)
{
	double complex more = times*dot(form->p, form->part, form->m);

	*sum += more;
	*size += cabs(more);
}

/* NAN where a matrix is singular (a zero-Hopf point, a 1:2 resonance); 0 where it is round-off. */
static double coefficient(struct form *form, double omega)
{
	const double complex *q = form->q, *star = form->star, *work = form->work;
	double complex sum = 0.0;
	double size = 0.0;

	derivative(form->part, form, (const double complex *[]){q, q, star}, 3);
	add_product(&sum, &size, 1.0, form);
	derivative(form->work, form, (const double complex *[]){q, star}, 2);
	if (resolve(form, form->work, 0.0)) /* - A^-1 B */
		return NAN;
	derivative(form->part, form, (const double complex *[]){q, work}, 2);
	add_product(&sum, &size, 2.0, form);
	derivative(form->work, form, (const double complex *[]){q, q}, 2);
	if (resolve(form, form->work, 2.0*I*omega))
		return NAN;
	derivative(form->part, form, (const double complex *[]){star, work}, 2);
	add_product(&sum, &size, 1.0, form);
	return fabs(creal(sum)) <= ROUND_OFF*size ? 0.0 : creal(sum)/(2.0*omega);
}

/* The derivative of the growth rate along the branch of equilibria at p; the matrix of the model
 * there is in form->A. */
static enum hawser_status growth(double *rate, struct form *form,
                                 const struct hawser_rom_family *family, double p, double wide,
                                 struct hawser_report *report)
{
	const struct hawser_rom *rom;
	int n = form->n, m = form->m;
	double *slope = form->re, *x = form->x;
	double complex sum = 0.0;
	enum hawser_status status = HAWSER_OK;

	memset(form->work, 0, (size_t)m*sizeof *form->work);
	for (int side = -1; !status && side <= 1; side += 2) {
		if ((status = family->model(family->context, &rom, p + side*wide, report)))
			return status;
		hawser__autonomous_matrix(form->left, form->by_u, form->by_v, form->acceleration, rom, x,
		                          x + n);
		for (int j = 0; j < n; j++)
			form->work[m - n + j] += side*form->acceleration[j]/(2.0*wide);
	}
	if (resolve(form, form->work, 0.0)) /* - A^-1 f_p: du/dp, and no velocities */
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf", "a fold at a Hopf point");
	for (int j = 0; j < n; j++)
		slope[j] = creal(form->work[j]);
	for (int side = -1; !status && side <= 1; side += 2) {
		if ((status = family->model(family->context, &rom, p + side*wide, report)))
			return status;
		for (int j = 0; j < n; j++)
			x[j] += side*wide*slope[j];
		hawser__autonomous_matrix(form->left, form->by_u, form->by_v, form->acceleration, rom, x,
		                          x + n);
		for (int j = 0; j < n; j++)
			x[j] -= side*wide*slope[j];
		for (int k = 0; k < m; k++)
			for (int j = 0; j < m; j++)
				sum += side*conj(form->p[j])*form->left[(size_t)k*m + j]*form->q[k];
	}
	*rate = creal(sum)/(2.0*wide);
	return status;
}

static int has_products_only(const struct hawser_rom *rom)
{
	return !rom->exact && (!rom->drag || hawser__drag_smooth(rom->drag)) && !rom->plug;
}

enum hawser_status hawser__hopf(struct hawser_hopf *hopf, double *rate, double *wave,
                                const struct hawser_rom_family *family, const double *u, double p,
                                double guess, double extent, struct hawser_report *report)
{
	const struct hawser_rom *rom;
	struct form form = {.n = 0};
	double complex value = 0.0;
	enum hawser_status status = family->model(family->context, &rom, p, report);

	*hopf = (struct hawser_hopf){.l1 = NAN, .turning = hopf->turning};
	if (!status)
		status = open_form(&form, rom->n, report);
	if (status)
		goto done;
	memcpy(form.x, u, (size_t)form.n*sizeof *u);
	set_matrix(&form, rom);
	if ((status = eigenvectors(&form, &value, guess, hopf->turning, report)))
		goto done;
	hopf->omega = cimag(value);
	*rate = creal(value);
	set_matrix(&form, rom);
	if (has_products_only(rom))
		hopf->l1 = coefficient(&form, hopf->omega);
	for (int j = 0; j < form.n; j++) {
		if (cabs(form.q[j]) > cabs(form.q[hopf->coordinate]))
			hopf->coordinate = j;
		wave[j] = creal(form.q[j]);
		wave[form.n + j] = -cimag(form.q[j]);
	}
	status = growth(&hopf->growth, &form, family, p, NUDGE*extent, report);
	hopf->swing = hopf->l1 == 0.0 ? NAN : -4.0*pow(cabs(form.q[hopf->coordinate]), 2)*hopf->growth
	                                      /(hopf->omega*hopf->l1);
done:
	hawser__hold_clear(&form.hold);
	return status;
}

enum hawser_status hawser__hopf_near(struct hawser_hopf *hopf, double *wave, double *u, double *p,
                                     const struct hawser_rom_family *family, double guess,
                                     double extent, struct hawser_report *report)
{
	const struct hawser_rom *rom;
	double rate;

	for (int i = 0; i < MOST_STEPS; i++) {
		enum hawser_status status = family->model(family->context, &rom, *p, report);

		if (!status)
			status = hawser__equilibrium_find(u, rom, 0, report);
		if (!status)
			status = hawser__hopf(hopf, &rate, wave, family, u, *p, guess, extent, report);
		if (status)
			return status;
		*p -= rate/hopf->growth;
		guess = hopf->omega;
		if (fabs(rate/hopf->growth) <= NEAR*extent)
			return HAWSER_OK;
		if (!isfinite(*p))
			break;
	}
	return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "frf", "the Hopf point was not found");
}
