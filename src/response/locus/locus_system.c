/* response/locus/locus_system.c - memory of the system, its evaluation and its solution; see locus.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/determinant.h"
#include "core/report.h"
#include "response/locus/locus.h"
#include "rom/energy/kernel.h"
#include "rom/terms/terms.h"

#define CLOSE 1e-6 /* distance of a matrix whose kernel serves as the tangent, relative; chosen */
enum { LARGEST = 1500, MOST_ORDER = 200 };
#define AT_REST 1e-9 /* size of the orbit below which defects are relative to this; chosen */

enum hawser_status hawser__locus_open(struct hawser__locus *locus,
                                      const struct hawser_rom_family *family,
                                      const struct hawser_locus_options *options,
                                      struct hawser_report *report)
{
	const double begin[2] = {options->from, options->at};
	enum hawser_status status;

	*locus = (struct hawser__locus){.kind = options->kind, .family = family, .plane = options->plane,
		.report = report, .centre = {INFINITY, INFINITY},
		.kappa = options->kind == HAWSER_PERIOD_DOUBLING ? 0.5 : 0.0};
	status = locus->plane
	         ? locus->plane->model(locus->plane->context, &locus->rom, begin, report)
	         : family->model(family->context, &locus->rom, options->at, report);
	if (status)
		return status;
	locus->n = locus->rom->n;
	locus->time = locus->plane ? 1.0 : locus->rom->time;
	locus->most = (LARGEST/locus->n - 1)/2;
	locus->most = locus->most > MOST_ORDER ? MOST_ORDER : locus->most;
	for (int p = 0; p < locus->rom->harmonics; p++)
		locus->varying_damping |= locus->rom->harmonic[p].D != NULL;
	locus->more = hawser__rom_more(locus->rom);
	locus->varying_damping |= locus->more;
	locus->log_modulus = calloc(4*(size_t)locus->n, sizeof(double));
	if (!locus->log_modulus)
		return hawser__no_memory(report, "locus");
	locus->argument = locus->log_modulus + 2*(size_t)locus->n;
	locus->barred = calloc(2*(size_t)locus->n, 1);
	if (!locus->barred)
		return hawser__no_memory(report, "locus");
	return hawser__monodromy_init(&locus->monodromy, locus->n, report);
}

void hawser__locus_close(struct hawser__locus *locus)
{
	free(locus->memory);
	free(locus->memory_c);
	free(locus->pivot);
	free(locus->log_modulus);
	free(locus->barred);
	free(locus->load);
	hawser__monodromy_release(&locus->monodromy);
}

/* Take `count` numbers from the memory at *used, or with memory NULL count only. */
static double *take(double *memory, size_t *used, size_t count)
{
	double *at = memory ? memory + *used : NULL;

	*used += count;
	return at;
}
static double complex *take_c(double complex *memory, size_t *used, size_t count)
{
	double complex *at = memory ? memory + *used : NULL;

	*used += count;
	return at;
}

static size_t lay_out(struct hawser__locus *to, double *memory)
{
	size_t used = 0, n = (size_t)to->n, R = (size_t)to->rows, K = 2*(size_t)to->width + 1;
	size_t P = (size_t)to->coefficients, size = (size_t)to->size, n2 = n*n;

	to->basis = take(memory, &used, R*K);
	to->u = take(memory, &used, R*n);
	to->du = take(memory, &used, R*n);
	to->force = take(memory, &used, 2*R*n);
	to->tangent = take(memory, &used, R*n2);
	to->damping = take(memory, &used, R*n2);
	to->plus = take(memory, &used, R*n2);
	to->minus = take(memory, &used, R*n2);
	to->shifted = take(memory, &used, R*n);
	to->square = take(memory, &used, R*n);
	to->slope = take(memory, &used, to->more ? R*n2 : 0);
	to->plus_v = take(memory, &used, to->more ? R*n2 : 0);
	to->minus_v = take(memory, &used, to->more ? R*n2 : 0);
	to->resist = take(memory, &used, to->more ? K*n2 : 0);
	to->velocity = take(memory, &used, to->more ? R*n : 0);
	to->shifted_v = take(memory, &used, to->more ? R*n : 0);
	to->work = take(memory, &used, hawser__rom_tangents_work(to->rom, to->rows) + 1);
	to->T = take(memory, &used, K*n2);
	to->D = take(memory, &used, K*n2);
	to->F = take(memory, &used, K*n);
	to->other[0] = take(memory, &used, K*n);
	to->other[1] = take(memory, &used, K*n);
	to->by[0] = take(memory, &used, P);
	to->by[1] = take(memory, &used, P);
	to->J = take(memory, &used, P*P);
	to->J_factors = take(memory, &used, P*P);
	to->M = take(memory, &used, size*size);
	to->rhs = take(memory, &used, size);
	to->balance = take(memory, &used, size);
	to->scale = take(memory, &used, P + n);
	to->x = take(memory, &used, P + n + 1);
	to->R = take(memory, &used, (P + n + 1)*(P + n + 1));
	return used;
}

static size_t lay_out_c(struct hawser__locus *to, double complex *memory)
{
	size_t used = 0, n = (size_t)to->n, R = (size_t)to->rows, N = (size_t)to->coefficients + n + 1;

	to->A = take_c(memory, &used, to->kind == HAWSER_TORUS ? N*N : 0);
	to->b = take_c(memory, &used, N);
	to->c = take_c(memory, &used, N);
	to->v = take_c(memory, &used, N);
	to->w = take_c(memory, &used, N);
	to->wave = take_c(memory, &used, N);
	to->exponential = take_c(memory, &used, R*(size_t)to->blocks);
	to->vt = take_c(memory, &used, R*n);
	to->dv = take_c(memory, &used, R*n);
	to->ddv = take_c(memory, &used, R*n);
	to->wt = take_c(memory, &used, R*n);
	to->q = take_c(memory, &used, R*n);
	to->q_v = take_c(memory, &used, R*n);
	for (int k = 0; k < 3; k++)
		to->kept[k] = take_c(memory, &used, to->more && to->kind == HAWSER_TORUS ? R*n : 0);
	to->g_y = take_c(memory, &used, (size_t)to->coefficients);
	to->T_c = take_c(memory, &used, ((size_t)to->width + 1)*n*n);
	to->D_c = take_c(memory, &used, ((size_t)to->width + 1)*n*n);
	to->pair = take_c(memory, &used, 2*n*n);
	return used;
}

enum hawser_status hawser__locus_arrange(struct hawser__locus *locus, int order)
{
	int n = locus->n, half = locus->kind == HAWSER_PERIOD_DOUBLING, highest = 0;

	for (int p = 0; p < locus->rom->harmonics; p++)
		highest = locus->rom->harmonic[p].k > highest ? locus->rom->harmonic[p].k : highest;
	locus->order = order;
	locus->width = 2*order + 1;
	locus->rows = (hawser__locus_degree(locus->rom) + 2)*order + 8 + 2*highest;
	locus->coefficients = n*(2*order + 1);
	locus->size = LOCUS_FIRST + locus->coefficients;
	locus->low = -order - half;
	locus->blocks = 2*order + 1 + half;
	locus->wide = locus->blocks*n;
	free(locus->memory);
	free(locus->memory_c);
	free(locus->pivot);
	locus->memory = calloc(lay_out(locus, NULL), sizeof(double));
	locus->memory_c = calloc(lay_out_c(locus, NULL), sizeof(double complex));
	locus->pivot = calloc(2*((size_t)locus->size + (size_t)n), sizeof(int));
	if (!locus->memory || !locus->memory_c || !locus->pivot)
		return hawser__no_memory(locus->report, "locus");
	lay_out(locus, locus->memory);
	lay_out_c(locus, locus->memory_c);
	locus->pivot_M = locus->pivot + locus->size + n;
	locus->closeness = INFINITY;
	for (int r = 0; r < locus->rows; r++) {
		double *at = locus->basis + (size_t)r*(2*locus->width + 1);

		at[0] = 1.0;
		for (int h = 1; h <= locus->width; h++) {
			double tau = 2.0*M_PI*((double)((long)r*h%locus->rows)/locus->rows);

			at[2*h - 1] = cos(tau);
			at[2*h] = sin(tau);
		}
	}
	return HAWSER_OK;
}

/* Conjugate symmetry of the real kinds: m and -m (or -m - 1) have conjugate coefficients. */
static void symmetrise(const struct hawser__locus *locus, double complex *x)
{
	int n = locus->n, last = locus->blocks - 1;
	double size = 0.0;

	for (int k = 0; locus->kind != HAWSER_TORUS && 2*k <= last; k++)
		for (int j = 0; j < n; j++) {
			double complex *a = x + k*n + j, *b = x + (last - k)*n + j;
			double complex mean = 0.5*(*a + conj(*b));

			*a = mean;
			*b = conj(mean);
		}
	for (int k = 0; k < locus->wide; k++)
		size += creal(x[k])*creal(x[k]) + cimag(x[k])*cimag(x[k]);
	for (int k = 0; k < locus->wide; k++)
		x[k] /= sqrt(size);
}

void hawser__locus_update(struct hawser__locus *locus)
{
	locus->closeness = INFINITY;
	memcpy(locus->b, locus->w, (size_t)locus->wide*sizeof *locus->b);
	memcpy(locus->c, locus->v, (size_t)locus->wide*sizeof *locus->c);
	symmetrise(locus, locus->b);
	symmetrise(locus, locus->c);
}

void hawser__locus_borders(struct hawser__locus *locus)
{
	/* arbitrary vectors, which must not be orthogonal to the null vectors */
	for (int k = 0; k < locus->wide; k++) {
		locus->b[k] = sin(1.0 + 2.385*k) + I*cos(3.0 + 1.271*k);
		locus->c[k] = cos(1.0 + 1.618*k) + I*sin(2.0 + 2.143*k);
	}
	symmetrise(locus, locus->b);
	symmetrise(locus, locus->c);
}

/* The part of the orbit beyond its harmonics, and of v, relative. */
static void estimate_mesh(struct hawser__locus *locus)
{
	int n = locus->n, H = locus->order, top = 2*H, N = locus->wide;
	double rest = 0.0, edge = 0.0, all = 0.0;

	for (int h = H + 1; h <= top; h++)
		for (int j = 0; j < n; j++) {
			double q = h*locus->omega, own = 0.5*locus->T[(size_t)j*(n + 1)] - q*q;
			double by = fmax(fabs(own), 0.1*q*q);

			rest += pow(locus->F[(2*h - 1)*n + j]/by, 2) + pow(locus->F[2*h*n + j]/by, 2);
		}
	for (int k = 0; k < N && locus->kind != HAWSER_RESONANCE; k++) {
		double a = cabs(locus->scale[k]*locus->v[k]);

		all += a*a;
		if (k < n || k >= N - n)
			edge += a*a;
	}
	locus->mesh = sqrt(rest)/locus->size_y;
	if (all > 0.0)
		locus->mesh = fmax(locus->mesh, edge/all); /* its square, since w's is as small */
}

static double length_of(const double *x, int count)
{
	return count > 0 ? cblas_dnrm2(count, x, 1) : 0.0;
}

/* The largest part of F, relative. */
static double defect(const struct hawser__locus *locus)
{
	int n = locus->n;
	double most = 0.0;

	for (int k = 0; k < locus->coefficients; k++) {
		int h = (k/n + 1)/2;
		double q = h*locus->omega, own = fabs(0.5*locus->T[(size_t)(k%n)*(n + 1)]);

		most = fmax(most, fabs(locus->F[k])/(own + q*q + locus->omega*locus->omega));
	}
	return most/locus->size_y;
}

enum hawser_status hawser__locus_evaluate(struct hawser__locus *locus, double *residual,
                                          const double *z)
{
	enum hawser_status status;

	*residual = INFINITY;
	if (locus->kind == HAWSER_TORUS) /* for the others it is exact */
		locus->kappa = z[LOCUS_KAPPA];
	locus->size_y = fmax(length_of(z + LOCUS_FIRST, locus->coefficients), AT_REST);
	if (!(locus->plane || z[LOCUS_OMEGA] > 0.0) || hawser__locus_place(locus, z[0], z[1]))
		return HAWSER_OK;
	hawser__locus_orbit(locus, z);
	hawser__locus_fields(locus, locus->F, z, 1);
	if (!isfinite(length_of(locus->F, locus->coefficients)))
		return HAWSER_OK;
	hawser__locus_series(locus);
	hawser__locus_jacobian(locus);
	if (locus->kind != HAWSER_RESONANCE && hawser__locus_vectors(locus))
		return HAWSER_OK;
	estimate_mesh(locus);
	status = locus->kind == HAWSER_RESONANCE ? hawser__locus_quadrature(locus, z)
	         : hawser__locus_differentiate(locus, z);
	if (!status)
		*residual = fmax(defect(locus), cabs(locus->g));
	return status;
}

/* Divide every row of the system by its largest entry. */
static void balance(struct hawser__locus *locus)
{
	int size = locus->size;
	double *most = locus->balance;

	memset(most, 0, (size_t)size*sizeof *most);
	for (int k = 0; k < size; k++)
		for (int i = 0; i < size; i++) {
			double x = fabs(locus->M[(size_t)k*size + i]);

			most[i] = x > most[i] ? x : most[i];
		}
	for (int i = 0; i < size; i++)
		most[i] = most[i] > 0.0 ? 1.0/most[i] : 1.0;
	for (int k = 0; k < size; k++)
		for (int i = 0; i < size; i++)
			locus->M[(size_t)k*size + i] *= most[i];
	for (int i = 0; i < size; i++)
		locus->rhs[i] *= most[i];
}

static void fill_orbit(struct hawser__locus *locus, const double *z, double keep)
{
	int size = locus->size, P = locus->coefficients;

	for (int i = 0; i < P; i++) {
		int barred = hawser__locus_is_barred(locus, i);

		locus->M[i] = barred ? 0.0 : locus->by[0][i];
		locus->M[(size_t)size + i] = barred ? 0.0 : locus->by[1][i];
		locus->rhs[i] = -keep*(barred ? z[LOCUS_FIRST + i] : locus->F[i]);
	}
	for (int j = 0; j < P; j++)
		memcpy(locus->M + (size_t)(LOCUS_FIRST + j)*size, locus->J + (size_t)j*P,
		       (size_t)P*sizeof(double));
}

/* A row of g: its real or imaginary part. */
static void fill_condition(struct hawser__locus *locus, int place, int imaginary, double keep)
{
	int size = locus->size, P = locus->coefficients;
	const double complex turn = imaginary ? -I : 1.0;

	locus->M[place] = creal(turn*locus->g_p[0]);
	locus->M[(size_t)size + place] = creal(turn*locus->g_p[1]);
	if (locus->kind == HAWSER_TORUS)
		locus->M[(size_t)LOCUS_KAPPA*size + place] = creal(turn*locus->g_kappa);
	for (int j = 0; j < P; j++)
		locus->M[(size_t)(LOCUS_FIRST + j)*size + place] = creal(turn*locus->g_y[j]);
	locus->rhs[place] = -keep*creal(turn*locus->g);
}

int hawser__locus_solve(struct hawser__locus *locus, double *dz, const double *z, const double *row,
                        int homogeneous, double last)
{
	int size = locus->size, P = locus->coefficients;
	double keep = homogeneous ? 0.0 : 1.0, sign;

	memset(locus->M, 0, (size_t)size*size*sizeof(double));
	memset(locus->rhs, 0, (size_t)size*sizeof(double));
	fill_orbit(locus, z, keep);
	fill_condition(locus, P, 0, keep);
	if (locus->kind == HAWSER_TORUS)
		fill_condition(locus, P + 1, 1, keep);
	else
		locus->M[(size_t)LOCUS_KAPPA*size + P + 1] = 1.0;
	for (int k = 0; k < size; k++)
		locus->M[(size_t)k*size + P + 2] = row[k];
	locus->rhs[P + 2] = last;
	balance(locus);
	locus->closeness = INFINITY;
	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, size, size, locus->M, size, locus->pivot_M) != 0)
		return 1;
	locus->solves++;
	locus->dense += 2.0/3.0*pow(size, 3.0);
	hawser__determinant(&sign, locus->M, locus->pivot_M, size);
	locus->orientation = sign < 0.0 ? -1 : 1;
	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', size, 1, locus->M, size, locus->pivot_M, locus->rhs,
	                    size);
	memcpy(dz, locus->rhs, (size_t)size*sizeof(double));
	return 0;
}

void hawser__locus_tangent(struct hawser__locus *locus, double *t, const double *z, const double *row,
                           const double *side)
{
	int size = locus->size;
	double along = 0.0;

	if (locus->closeness <= CLOSE) {
		memset(t, 0, (size_t)size*sizeof *t);
		t[locus->coefficients + 2] = 1.0; /* of the row of the plane */
		LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, 'N', size, 1, locus->M, size, locus->pivot_M, t, size);
	} else if (hawser__locus_solve(locus, t, z, row, 1, 1.0))
		memcpy(t, side, (size_t)size*sizeof *t);
	for (int k = 0; k < size; k++)
		along += row[k]*t[k];
	if (along < 0.0)
		cblas_dscal(size, -1.0, t, 1);
}

enum hawser_status hawser__locus_multipliers(struct hawser__locus *locus)
{
	return hawser__monodromy_multipliers(&locus->monodromy, locus->log_modulus, locus->argument,
	                                     locus->rom, locus->T, locus->width, locus->omega,
	                                     locus->report);
}

void hawser__locus_weights(double *weight, const struct hawser__locus *locus, const double *z)
{
	double size = 0.0;

	for (int i = 0; i < locus->coefficients; i++)
		size += z[LOCUS_FIRST + i]*z[LOCUS_FIRST + i];
	for (int i = 0; i < locus->size; i++)
		weight[i] = 1.0/(size + AT_REST*AT_REST);
	weight[LOCUS_OMEGA] = 1.0/(locus->extent[0]*locus->extent[0]);
	weight[LOCUS_PARAMETER] = 1.0/(locus->extent[1]*locus->extent[1]);
	weight[LOCUS_KAPPA] = 4.0;
}
