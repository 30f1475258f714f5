/* response/locus/own_line.c - a bifurcation of an autonomous model on a line across its locus, by
 * Newton's method.
 *
 *    y        unknowns [k]: of an equilibrium its coordinates; of a cycle its state at the phase 0 [m],
 *             its frequency and, where rotations leave the model as it is, a rotation in a period
 *    F(y, t)  defects: accelerations; or the change of the state over a period, and rows that hold the
 *             cycle where it was along its motion (and the rotation); J = dF/dy
 *    B        what is singular: J at folds and branch points; A + 1 at doublings and A - exp(i theta)
 *             at tori, with the derivative A [m][m] of the state after a period, a part of J; at Hopf
 *             points A - i omega, with the matrix A of u' = A u or (u, u')' = A (u, u')
 *    g        [B b; c^H 0] [v; g] = [0; 1], and w of the adjoint: g = 0 where B is singular. Its
 *             derivative is - w^H (dB) v, that by y - w^H (J(y + h v) - J(y - h v))/2h, since second
 *             derivatives are symmetric
 *
 * Equations: F = 0 and g = 0 for y, t and, of a pair, theta or omega. At a branch point w^T dF/dt is
 * 0, and the matrix has a kernel, v: the shortest step is taken.
 *
 * Reference: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, chapters 3
 * and 4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "response/cycle/cycle.h"
#include "response/cycle/hopf.h"
#include "response/branch/return_map.h"
#include "response/locus/locus_own.h"
#include "response/orbit/shooting.h"
#include "response/time/flow.h"

#define SMALL_Y 1e-3  /* size of y, below which lengths are relative to this; chosen */
#define ALONG_V 1e-4  /* of y, by which it is moved for second derivatives; chosen */
#define ASIDE_T 1e-5  /* of the line, in units of the ranges, for derivatives by t; chosen */
#define ARRIVED_AT 1e-10 /* last step, relative; the next would be its square */
#define WORSE 2.0     /* factor of a step from the last one at which it is given up; chosen */
#define KERNEL 1e-7   /* singular value of a branch point's kernel, relative; chosen */
#define MESH 0.1      /* error of a period, in tolerances, at which its mesh is fine enough; chosen */
enum { MOST_STEPS = 8, INVERSE_STEPS = 3, FINEST = 1 << 16 };

struct system {
	struct hawser__own_line *line;
	const struct hawser_rom *rom;
	int cycle, torus, hopf, pair; /* pair: of the last two, theta and omega */
	int n, m, k, rows;           /* rows: of B */
	double *y, *F, *J;           /* of an equilibrium the derivative by u' is behind that by u in J */
	double *side, *spare, *plus, *minus; /* [k], [k], [k][k], [k][k] of other places */
	double *rates;               /* [n] u' of an equilibrium, 0 but for differences */
	double *anchor, *along, *turn, *around; /* [m] old state, its motion; [n][n]; [m] rotated */
	double *A, *by_omega, *work;
	double complex *B, *v, *w, *b, *c, *g_y; /* [rows + 1]^2, [rows + 1] */
	lapack_int *pivot;
	double *matrix, *rhs, *value; /* [k + 2]^2, [k + 2] */
	double complex mu, g, g_t;
	double mesh;
	struct hawser__flow flow;
	struct hawser__hold hold;
};

/* x [m] is turned to `to`. */
static void rotate(const struct system *s, double *to, const double *x)
{
	for (int i = 0; i < 2; i++)
		cblas_dgemv(CblasRowMajor, CblasNoTrans, s->n, s->n, 1.0, s->turn, s->n, x + i*s->n, 1, 0.0,
		            to + i*s->n, 1);
}

static enum hawser_status open_system(struct system *s, const struct hawser__own_spot *spot,
                                      struct hawser_report *report)
{
	size_t n = (size_t)s->rom->n, m = 2*n, k = m + 2, r = m + 3;
	int turns = 0;
	enum hawser_status status = s->cycle ? hawser__flow_init(&s->flow, s->rom, report) : HAWSER_OK;

	s->n = (int)n;
	s->m = (int)m;
	s->y = hawser__hold(&s->hold, 4*k, sizeof(double));
	s->J = hawser__hold(&s->hold, 3*k*k + m*m + 4*m + 3*m*m, sizeof(double));
	s->anchor = hawser__hold(&s->hold, 3*m + n*n, sizeof(double));
	s->B = hawser__hold(&s->hold, r*r + 5*r, sizeof(double complex));
	s->pivot = hawser__hold(&s->hold, r + 1, sizeof *s->pivot);
	s->matrix = hawser__hold(&s->hold, (k + 2)*(k + 4), sizeof(double));
	s->rates = hawser__hold(&s->hold, n, sizeof(double));
	if (!status && s->hold.short_of_memory)
		status = hawser__no_memory(report, "locus");
	if (status)
		return status;
	s->F = s->y + k;
	s->side = s->F + k;
	s->spare = s->side + k;
	s->plus = s->J + k*k;
	s->minus = s->plus + k*k;
	s->A = s->minus + k*k;
	s->by_omega = s->A + m*m;
	s->work = s->by_omega + m;
	s->along = s->anchor + m;
	s->around = s->along + m;
	s->turn = s->around + m;
	s->v = s->B + r*r;
	s->w = s->v + r;
	s->b = s->w + r;
	s->c = s->b + r;
	s->g_y = s->c + r;
	s->rhs = s->matrix + (k + 2)*(k + 2);
	s->value = s->rhs + k + 2;
	s->k = s->cycle ? s->m + 1 : s->n;
	memcpy(s->y, spot->state, (s->cycle ? m : n)*sizeof(double));
	if (s->cycle) {
		s->y[m] = spot->omega;
		memcpy(s->anchor, spot->state, m*sizeof(double));
		memcpy(s->along, spot->state + n, n*sizeof(double));
		hawser_rom_acceleration(s->rom, s->along + n, s->anchor, s->anchor + n, 0.0, spot->omega);
		status = hawser__cycle_turn(s->turn, &turns, s->rom, report);
		if (turns)
			rotate(s, s->around, s->anchor);
		if (s->line->gone == 0)
			s->line->gone = 1 + (turns && hawser__apart(s->around, s->along, s->m));
		s->k = s->m + s->line->gone;
	}
	s->rows = s->line->kind == HAWSER_PERIOD_DOUBLING || s->torus ? s->m : s->k;
	s->mu = s->rows == s->k ? 0.0 : s->torus ? cexp(I*spot->angle) : -1.0;
	if (s->hopf) {
		s->rows = s->rom->first ? s->n : s->m;
		s->mu = I*spot->omega;
	}
	return status;
}

/* F and J (row-major) of a cycle. */
static void derive_cycle(struct system *s, double *F, double *J, const double *y)
{
	int m = s->m, k = s->k, steps = s->line->steps;
	struct hawser__stretch period = {.h = 2.0*M_PI/steps, .steps = steps, .count = 1};

	memcpy(F, y, (size_t)m*sizeof *F);
	s->mesh = hawser__flow_derive(&s->flow, F, s->A, s->by_omega, NULL, &period, y[m])/
	          cblas_dnrm2(m, y, 1);
	memset(J, 0, (size_t)k*k*sizeof *J);
	memset(F + m, 0, (size_t)(k - m)*sizeof *F);
	for (int i = 0; i < m; i++) {
		memcpy(J + (size_t)i*k, s->A + (size_t)i*m, (size_t)m*sizeof *J);
		J[(size_t)i*k + i] -= 1.0;
		J[(size_t)i*k + m] = s->by_omega[i];
		J[(size_t)m*k + i] = s->along[i];
		F[i] -= y[i];
		F[m] += s->along[i]*(y[i] - s->anchor[i]);
	}
	if (k == m + 1)
		return;
	rotate(s, s->work, y);
	for (int i = 0; i < m; i++) {
		J[(size_t)i*k + m + 1] = s->work[i];
		J[(size_t)(m + 1)*k + i] = s->around[i];
		F[i] += y[m + 1]*s->work[i];
		F[m + 1] += s->around[i]*(y[i] - s->anchor[i]);
	}
	for (int half = 0; half < 2; half++)
		for (int i = 0; i < s->n; i++)
			for (int j = 0; j < s->n; j++)
				J[(size_t)(half*s->n + i)*k + half*s->n + j] += y[m + 1]*s->turn[i*s->n + j];
}

/* F and J at y and t; 1 where there is no model or no number. */
static int derive(struct system *s, double *F, double *J, const double *y, double t)
{
	const struct hawser_rom_family *family = &s->line->family;
	int n = s->n;

	if (family->model(family->context, &s->rom, t, NULL))
		return 1;
	if (s->cycle && (hawser__flow_place(&s->flow, s->rom) || !(y[s->m] > 0.0)))
		return 1;
	if (s->cycle)
		derive_cycle(s, F, J, y);
	else
		hawser_rom_acceleration_jacobian(s->rom->first ? s->rom->first : s->rom, F, J, J + n*n,
		                                 s->work, y, s->rates, 0.0, 1.0);
	return !isfinite(cblas_dnrm2(s->k, F, 1));
}

/* An entry of B, without mu, from J. */
static double entry(const struct system *s, const double *J, int i, int j)
{
	int n = s->n;

	if (!s->hopf || s->rows == n) /* A of a cycle is J with 1 more */
		return J[(size_t)i*s->k + j] + (i == j && s->cycle && s->rows != s->k ? 1.0 : 0.0);
	if (i < n)
		return j == n + i;
	return j < n ? J[(size_t)(i - n)*n + j] : J[(size_t)n*n + (size_t)(i - n)*n + j - n];
}

/* v, w and g, from J; 1 where the bordered matrix is singular. */
static int set_vectors(struct system *s)
{
	int r = s->rows, size = r + 1;

	for (int j = 0; j < r; j++)
		for (int i = 0; i < r; i++)
			s->B[(size_t)j*size + i] = entry(s, s->J, i, j) - (i == j ? s->mu : 0.0);
	for (int i = 0; i < r; i++) {
		s->B[(size_t)r*size + i] = s->b[i];
		s->B[(size_t)i*size + r] = conj(s->c[i]);
	}
	s->B[(size_t)r*size + r] = 0.0;
	if (LAPACKE_zgetrf_work(LAPACK_COL_MAJOR, size, size, s->B, size, s->pivot) != 0)
		return 1;
	for (int adjoint = 0; adjoint < 2; adjoint++) {
		double complex *x = adjoint ? s->w : s->v;

		memset(x, 0, (size_t)size*sizeof *x);
		x[r] = 1.0;
		LAPACKE_zgetrs_work(LAPACK_COL_MAJOR, adjoint ? 'C' : 'N', size, 1, s->B, size, s->pivot, x,
		                    size);
	}
	s->g = s->v[r];
	return 0;
}

/* b and c from w and v, and first from numbers that have nothing to do with them. */
static void set_borders(struct system *s, int first)
{
	double size[2] = {1.0, 1.0};

	if (!first) {
		size[0] = cblas_dznrm2(s->rows, s->w, 1);
		size[1] = cblas_dznrm2(s->rows, s->v, 1);
	}
	for (int i = 0; i < s->rows; i++) {
		s->b[i] = first ? sin(1.0 + 2.385*i) : s->w[i]/size[0];
		s->c[i] = first ? cos(1.0 + 1.618*i) : s->v[i]/size[1];
	}
}

/* g_y += - factor w^H (J(y + h x) - J(y - h x))/2h, x the real or the imaginary part of v. */
static int add_second(struct system *s, double t, int imaginary)
{
	double size = 0.0, h;
	int moved = s->rows < s->k ? s->rows : s->k, above = s->hopf ? s->rows - s->n : 0;

	for (int i = 0; i < s->rows; i++)
		size = hypot(size, imaginary ? cimag(s->v[i]) : creal(s->v[i]));
	if (!(size > 0.0))
		return 0;
	h = ALONG_V*fmax(cblas_dnrm2(s->k, s->y, 1), SMALL_Y)/size;
	for (int sign = -1; sign <= 1; sign += 2) {
		memcpy(s->side, s->y, (size_t)s->k*sizeof *s->side);
		for (int i = 0; i < moved; i++)
			s->side[i] += sign*h*(imaginary ? cimag(s->v[i]) : creal(s->v[i]));
		for (int i = 0; i < above; i++)
			s->rates[i] = sign*h*(imaginary ? cimag(s->v[s->n + i]) : creal(s->v[s->n + i]));
		if (derive(s, s->spare, sign > 0 ? s->plus : s->minus, s->side, t))
			return 1;
	}
	memset(s->rates, 0, (size_t)s->n*sizeof *s->rates);
	for (int i = above; i < s->rows; i++)
		for (int j = 0; j < s->k; j++) {
			size_t at = (size_t)(i - above)*s->k + j;

			s->g_y[j] -= (imaginary ? I : 1.0)*conj(s->w[i])*(s->plus[at] - s->minus[at])/(2.0*h);
		}
	return 0;
}

/* The column of t of F in s->side, and g_t. */
static int by_line(struct system *s, double t)
{
	memset(s->side, 0, (size_t)s->k*sizeof *s->side);
	s->g_t = 0.0;
	for (int sign = -1; sign <= 1; sign += 2) {
		double share = sign/(2.0*ASIDE_T);

		if (derive(s, s->spare, s->plus, s->y, t + sign*ASIDE_T))
			return 1;
		cblas_daxpy(s->k, share, s->spare, 1, s->side, 1);
		for (int i = 0; i < s->rows; i++)
			for (int j = 0; j < s->rows; j++)
				s->g_t -= share*conj(s->w[i])*entry(s, s->plus, i, j)*s->v[j];
	}
	return 0;
}

/* The matrix of Newton's method (row-major) and its right side; 1 where there is none. */
static int fill_system(struct system *s, double t)
{
	int k = s->k, size = k + 1 + s->pair;
	double complex turned = 0.0;

	memset(s->g_y, 0, (size_t)k*sizeof *s->g_y);
	if (add_second(s, t, 0) || (s->pair && add_second(s, t, 1)) || by_line(s, t))
		return 1;
	memset(s->matrix, 0, (size_t)size*size*sizeof *s->matrix);
	for (int i = 0; i < k; i++) {
		memcpy(s->matrix + (size_t)i*size, s->J + (size_t)i*k, (size_t)k*sizeof *s->matrix);
		s->matrix[(size_t)i*size + k] = s->side[i];
		s->rhs[i] = -s->F[i];
	}
	for (int i = 0; i < s->rows; i++)
		turned += conj(s->w[i])*s->v[i];
	for (int part = 0; part <= s->pair; part++) {
		double *row = s->matrix + (size_t)(k + part)*size;
		const double complex turn = part ? -I : 1.0;

		for (int j = 0; j < k; j++)
			row[j] = creal(turn*s->g_y[j]);
		row[k] = creal(turn*s->g_t);
		if (s->pair)
			row[k + 1] = creal(turn*I*(s->torus ? s->mu : 1.0)*turned);
		s->rhs[k + part] = -creal(turn*s->g);
	}
	return 0;
}

/* rhs becomes the step; 1 where the matrix is singular. */
static int solve_system(struct system *s)
{
	int size = s->k + 1 + s->pair, rank;

	if (s->line->kind == HAWSER_BRANCH_POINT)
		return LAPACKE_dgelsd(LAPACK_ROW_MAJOR, size, size, 1, s->matrix, size, s->rhs, 1, s->value,
		                      KERNEL, &rank) != 0;
	return LAPACKE_dgesv(LAPACK_ROW_MAJOR, size, 1, s->matrix, size, s->pivot, s->rhs, 1) != 0;
}

/* Of a fold: <w, F''(v, v)>, which is 0 at a cusp, for vectors of length 1. Its sign tells on which
 * side of the curve, along t, the two motions are that merge. */
static double bend_of(const struct system *s)
{
	double complex second = 0.0, aside = 0.0;
	double size = cblas_dznrm2(s->rows, s->v, 1);

	for (int i = 0; i < s->rows; i++) {
		second -= s->g_y[i]*s->v[i];
		aside += conj(s->w[i])*s->side[i];
	}
	return copysign(1.0, creal(aside))*creal(second)/(size*size*cblas_dznrm2(s->rows, s->w, 1));
}

/* Newton's method from y, t and mu. *step: the last one, relative. */
static int converge(struct system *s, double *t, double *step)
{
	double reach = *step, before = INFINITY;

	set_borders(s, 1);
	for (int i = 0; i < MOST_STEPS; i++) {
		if (derive(s, s->F, s->J, s->y, *t))
			return 0;
		for (int j = 0; j < INVERSE_STEPS; j++) {
			if (set_vectors(s))
				return 0;
			if (j < INVERSE_STEPS - 1)
				set_borders(s, 0);
		}
		if (fill_system(s, *t) || solve_system(s))
			return 0;
		cblas_daxpy(s->k, 1.0, s->rhs, 1, s->y, 1);
		*t += s->rhs[s->k];
		if (s->pair)
			s->mu = s->torus ? s->mu*cexp(I*s->rhs[s->k + 1]) : s->mu + I*s->rhs[s->k + 1];
		*step = fmax(cblas_dnrm2(s->k, s->rhs, 1)/fmax(cblas_dnrm2(s->k, s->y, 1), SMALL_Y),
		             fabs(s->rhs[s->k]));
		if (s->hopf)
			*step = fmax(*step, fabs(s->rhs[s->k + 1])/cabs(s->mu));
		if (!(fabs(*t) <= reach) || (i > 2 && *step > WORSE*before && *step > ARRIVED_AT))
			return 0;
		before = *step;
		if (*step > ARRIVED_AT)
			continue;
		if (!(s->mesh > MESH*s->line->tolerance && s->line->steps < FINEST))
			return 1;
		s->line->steps += s->line->steps/2;
		i = 0;
	}
	return 0;
}

static enum hawser_status meet(struct hawser__own_spot *spot, int *found,
                               struct hawser__own_line *line, double reach,
                               struct hawser_report *report)
{
	struct system s = {.line = line, .cycle = line->cycles, .torus = line->kind == HAWSER_TORUS,
		.hopf = line->kind == HAWSER_HOPF};
	struct hawser_hopf hopf = {.turning = 0};
	double t = 0.0, step = reach, rate;
	enum hawser_status status;

	*found = 0;
	s.pair = s.torus || s.hopf;
	if (line->family.model(line->family.context, &s.rom, t, NULL))
		return HAWSER_OK;
	if (line->steps == 0 && line->cycles)
		line->steps = hawser__shooting_steps(s.rom, spot->omega, 1);
	if (s.torus && spot->angle == 0.0 &&
	    (status = hawser__own_judge_cycle(spot, s.rom, line, report)))
		return status;
	status = open_system(&s, spot, report);
	*found = !status && converge(&s, &t, &step) && (!s.hopf || cimag(s.mu) > 0.0) &&
	         !line->family.model(line->family.context, &s.rom, t, NULL);
	if (*found) {
		memset(spot->state, 0, (size_t)s.m*sizeof *spot->state);
		memcpy(spot->state, s.y, (size_t)(s.cycle ? s.m : s.n)*sizeof *spot->state);
		spot->omega = s.cycle ? s.y[s.m] : cimag(s.mu);
		spot->angle = s.torus ? spot->angle + remainder(carg(s.mu) - spot->angle, 2.0*M_PI)
		                      : s.mu == -1.0 ? M_PI : 0.0;
		spot->vanish = line->kind == HAWSER_FOLD ? bend_of(&s) : s.torus ? sin(spot->angle)
		               : s.hopf ? spot->omega : NAN;
		spot->time = s.rom->time;
		spot->error = fmax(step, s.mesh);
		for (int i = 0; i < 2; i++)
			spot->at[i] = line->base[i] + t*line->normal[i];
		status = s.cycle ? hawser__own_judge_cycle(spot, s.rom, line, report)
		                 : hawser__own_judge_rest(spot, s.rom, report);
		if (s.hopf && !status && !hawser__hopf(&hopf, &rate, s.rhs, &line->family, s.y, t, spot->omega,
		                                       1.0, NULL))
			spot->test[HAWSER__OWN_DEGENERATE] = hopf.l1;
	}
	if (s.cycle)
		hawser__flow_clear(&s.flow);
	hawser__hold_clear(&s.hold);
	return status;
}

/* The bifurcation on the line next to t = 0, from the guess that the spot has; *found: there is one
 * within `reach`. HAWSER_ERR_MEMORY. */
static enum hawser_status own_meet(struct hawser__own_spot *spot, int *found,
                                   struct hawser__own_line *line, double reach,
                                   struct hawser_report *report)
{
	for (int k = 0; k < HAWSER__OWN_TESTS; k++)
		spot->test[k] = NAN;
	spot->vanish = spot->beside_pair = NAN;
	return meet(spot, found, line, reach, report);
}

void hawser__own_copy(struct hawser__own_spot *to, const struct hawser__own_spot *from, int n)
{
	double *own = to->state;

	*to = *from;
	to->state = own;
	memcpy(own, from->state, 2*(size_t)n*sizeof *own);
}

void hawser__own_between(struct hawser__own_spot *to, const struct hawser__own_spot *a,
                         const struct hawser__own_spot *b, double s, int n)
{
	hawser__own_copy(to, b, n);
	to->omega += (s - 1.0)*(b->omega - a->omega);
	to->angle += (s - 1.0)*(b->angle - a->angle);
	for (int j = 0; j < 2*n; j++)
		to->state[j] += (s - 1.0)*(b->state[j] - a->state[j]);
}

double hawser__own_distance(const double a[2], const double b[2])
{
	return hypot(a[0] - b[0], a[1] - b[1]);
}

enum hawser_status hawser__own_across(struct hawser__own *own, struct hawser__own_spot *spot,
                                      int *found, const double base[2], const double direction[2],
                                      double reach, struct hawser_report *report)
{
	double length = hypot(direction[0], direction[1]);
	enum hawser_status status;

	for (int k = 0; k < 2; k++) {
		own->line.base[k] = base[k];
		own->line.normal[k] = (k ? -1.0 : 1.0)*direction[!k]/length;
	}
	own->locus->solves++;
	status = own_meet(spot, found, &own->line, reach, report);
	spot->test[HAWSER__OWN_START] = *found ? spot->at[1] - own->o->at/own->line.extent[1] : NAN;
	return status;
}

enum hawser_status hawser__own_at(struct hawser__own *own, double s, int *found,
                                  struct hawser_report *report)
{
	const double *a = own->here.at, *b = own->next.at;
	double direction[2] = {b[0] - a[0], b[1] - a[1]};
	double base[2] = {a[0] + s*direction[0], a[1] + s*direction[1]};

	hawser__own_between(&own->trial, &own->here, &own->next, s, own->line.n);
	return hawser__own_across(own, &own->trial, found, base, direction, hawser__own_distance(a, b),
	                          report);
}
