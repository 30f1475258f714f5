/* response/locus/folds_system.c - evaluation and solution of the equations of a fold. See folds.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/determinant.h"
#include "core/report.h"
#include "response/locus/folds.h"
#include "rom/energy/kernel.h"

enum { RESIDUAL = 0, BY_OMEGA, BY_LOAD, KERNEL, SIDES };

enum hawser_status hawser__fold_open(struct hawser__fold *fold, const struct hawser_rom *rom,
                                     struct hawser_report *report)
{
	enum hawser_status status;
	size_t size;

	*fold = (struct hawser__fold){.L = 1.0};
	if ((status = hawser__load_open(&fold->load, rom, report)) ||
	    (status = hawser__balance_init(&fold->balance, &fold->load.rom, report)))
		return status;
	fold->balance.dense = 1;
	if ((status = hawser__balance_arrange(&fold->balance, report)))
		return status;
	fold->size = fold->balance.base.size + 1;
	size = (size_t)fold->size;
	fold->b = calloc(8*size, sizeof(double)); /* b and the seven arrays below */
	if (!fold->b)
		return hawser__no_memory(report, "folds");
	fold->c = fold->b + size;
	fold->wave_v = fold->c + size;
	fold->wave_w = fold->wave_v + size;
	fold->wave_g = fold->wave_w + size;
	fold->zero = fold->wave_g + size;
	fold->step = fold->zero + size;
	fold->weight = fold->step + size;
	return HAWSER_OK;
}

void hawser__fold_close(struct hawser__fold *fold)
{
	hawser__hold_clear(&fold->unknowns);
	hawser__hold_clear(&fold->times);
	free(fold->b);
	hawser__balance_release(&fold->balance);
	hawser__load_clear(&fold->load);
}

static int make_unknowns(struct hawser__fold *fold, int P)
{
	struct hawser__hold *hold = &fold->unknowns;
	size_t row = (size_t)P + 1;

	hawser__hold_clear(hold);
	fold->room = 0;
	fold->A = hawser__hold(hold, row*row, sizeof(double));
	fold->pivot = hawser__hold(hold, row, sizeof(int));
	fold->x = hawser__hold(hold, SIDES*row, sizeof(double));
	fold->w = hawser__hold(hold, row, sizeof(double));
	fold->F = hawser__hold(hold, row, sizeof(double));
	fold->g_y = hawser__hold(hold, row, sizeof(double));
	if (hold->short_of_memory)
		return 1;
	fold->room = P;
	return 0;
}

static int make_samples(struct hawser__fold *fold, int rows)
{
	const struct hawser_rom *rom = &fold->load.rom;
	struct hawser__hold *hold = &fold->times;
	size_t n = (size_t)rom->n, R = (size_t)rows;

	hawser__hold_clear(hold);
	fold->samples = 0;
	fold->time_u = hawser__hold(hold, R*n, sizeof(double));
	fold->time_v = hawser__hold(hold, R*n, sizeof(double));
	fold->time_w = hawser__hold(hold, R*n, sizeof(double));
	fold->time_q = hawser__hold(hold, R*n, sizeof(double));
	fold->force = hawser__hold(hold, R*n, sizeof(double));
	fold->plus = hawser__hold(hold, R*n*n, sizeof(double));
	fold->minus = hawser__hold(hold, R*n*n, sizeof(double));
	fold->work = hawser__hold(hold, hawser__rom_tangents_work(rom, rows) + 1, sizeof(double));
	if (hold->short_of_memory)
		return 1;
	fold->samples = rows;
	return 0;
}

/* Allocate memory for the current set of active unknowns. */
static enum hawser_status reserve(struct hawser__fold *fold, struct hawser_report *report)
{
	int P = fold->balance.unknowns, rows = fold->balance.base.rows;

	if ((fold->room < P && make_unknowns(fold, P)) ||
	    (fold->samples < rows && make_samples(fold, rows)))
		return hawser__no_memory(report, "folds");
	return HAWSER_OK;
}

struct hawser__metric hawser__fold_metric(struct hawser__fold *fold)
{
	int last = fold->size - 1;

	memcpy(fold->weight, fold->balance.base.weight, (size_t)last*sizeof(double));
	fold->weight[last] = 1.0/(fold->L*fold->L);
	return (struct hawser__metric){fold->size, fold->weight};
}

/* A from the Jacobian assembled by harmonic balance, row-major: LAPACK sees A^T. */
static int factor(struct hawser__fold *fold)
{
	const struct hawser__balance *balance = &fold->balance;
	int P = balance->unknowns, row = P + 1;

	for (int i = 0; i < P; i++) {
		memcpy(fold->A + (size_t)i*row, balance->matrix + (size_t)i*row,
		       (size_t)P*sizeof(double));
		fold->A[(size_t)i*row + P] = fold->b[balance->slot[i]];
		fold->A[(size_t)P*row + i] = fold->c[balance->slot[i]];
	}
	fold->A[(size_t)P*row + P] = 0.0;
	fold->solves++;
	fold->balance.base.cost.dense += 2.0/3.0*pow(row, 3.0);
	if (LAPACKE_dgetrf_work(LAPACK_COL_MAJOR, row, row, fold->A, row, fold->pivot) != 0)
		return 1;
	hawser__determinant(&fold->sign, fold->A, fold->pivot, row);
	return 0;
}

/* x [sides][P + 1]: A x = x, or with A^T. */
static void solve(const struct hawser__fold *fold, double *x, int sides, int transposed)
{
	int row = fold->balance.unknowns + 1;

	LAPACKE_dgetrs_work(LAPACK_COL_MAJOR, transposed ? 'N' : 'T', row, sides, fold->A, row,
	               fold->pivot, x, row);
}

static double *side(const struct hawser__fold *fold, int k)
{
	return fold->x + (size_t)k*(fold->balance.unknowns + 1);
}

/* Right-hand sides: -F, -F_omega W, -F_load L, and the last unit vector. */
static void fill_sides(struct hawser__fold *fold)
{
	const struct hawser__balance *balance = &fold->balance;
	int P = balance->unknowns;
	double *residual = side(fold, RESIDUAL), *omega = side(fold, BY_OMEGA);
	double *load = side(fold, BY_LOAD), *kernel = side(fold, KERNEL);

	hawser__fold_by_load(fold, load);
	for (int i = 0; i < P; i++) {
		fold->F[i] = balance->defect[balance->slot[i]]*balance->row_scale[i];
		residual[i] = -fold->F[i];
		omega[i] = -balance->matrix[(size_t)i*(P + 1) + P];
		load[i] *= -fold->L;
		kernel[i] = 0.0;
	}
	residual[P] = omega[P] = load[P] = 0.0;
	kernel[P] = 1.0;
}

double hawser__fold_defect(struct hawser__fold *fold, const double *z, int derive)
{
	hawser__load_set(&fold->load, z[fold->size - 1]);
	return fold->balance.base.ops->defects(&fold->balance.base, z, derive);
}

enum hawser_status hawser__fold_evaluate(struct hawser__fold *fold, double *residual,
                                         const double *z, struct hawser_report *report)
{
	struct hawser__balance *balance = &fold->balance;
	enum hawser_status status = reserve(fold, report);
	int P = balance->unknowns;
	double defect;

	if (status)
		return status;
	*residual = NAN;
	defect = hawser__fold_defect(fold, z, 1);
	balance->factored = 0; /* the scales are those of this orbit; the old factors are invalid */
	hawser__balance_scale(balance);
	hawser__balance_set_border(balance, fold->zero);
	hawser__balance_assemble(balance);
	if (!isfinite(defect) || factor(fold))
		return HAWSER_OK;
	fill_sides(fold);
	memset(fold->w, 0, (size_t)P*sizeof(double));
	fold->w[P] = 1.0;
	solve(fold, fold->w, 1, 1);
	fold->F_omega = -cblas_ddot(P, fold->w, 1, side(fold, BY_OMEGA), 1);
	fold->F_load = -cblas_ddot(P, fold->w, 1, side(fold, BY_LOAD), 1);
	solve(fold, fold->x, SIDES, 0);
	fold->g = side(fold, KERNEL)[P];
	hawser__fold_differentiate(fold);
	*residual = defect;
	return HAWSER_OK;
}

/* Solve the 3x3 system in place, with row pivoting. *sign is that of its determinant. */
static int solve_three(double m[3][4], double x[3], int *sign)
{
	*sign = 1;
	for (int k = 0; k < 3; k++) {
		int best = k;

		for (int i = k + 1; i < 3; i++)
			if (fabs(m[i][k]) > fabs(m[best][k]))
				best = i;
		for (int j = 0; j < 4; j++) {
			double keep = m[k][j];

			m[k][j] = m[best][j];
			m[best][j] = keep;
		}
		if (!(fabs(m[k][k]) > 0.0))
			return 1;
		if ((m[k][k] < 0.0) != (best != k))
			*sign = -*sign;
		for (int i = k + 1; i < 3; i++) {
			double factor = m[i][k]/m[k][k];

			for (int j = k; j < 4; j++)
				m[i][j] -= factor*m[k][j];
		}
	}
	for (int k = 2; k >= 0; k--) {
		x[k] = m[k][3];
		for (int j = k + 1; j < 3; j++)
			x[k] -= m[k][j]*x[j];
		x[k] /= m[k][k];
	}
	return 0;
}

/* <row, dy> of a solution's coefficients. */
static double on_row(const struct hawser__fold *fold, const double *row, const double *x)
{
	const struct hawser__balance *balance = &fold->balance;
	double sum = 0.0;

	for (int i = 0; i < balance->unknowns; i++) {
		int slot = balance->slot[i];

		sum += balance->base.weight[slot]*row[slot]*balance->col_scale[i]*x[i];
	}
	return sum;
}

int hawser__fold_solve(struct hawser__fold *fold, double *dz, const double *row, int homogeneous,
                       double last)
{
	const struct hawser__balance *balance = &fold->balance;
	int P = balance->unknowns, at_omega = fold->size - 2, at_load = fold->size - 1;
	const double *p = side(fold, RESIDUAL), *po = side(fold, BY_OMEGA);
	const double *pl = side(fold, BY_LOAD), *v = side(fold, KERNEL);
	double keep = homogeneous ? 0.0 : 1.0, W = balance->base.W, x[3];
	/* rows: A's last component, g, the plane; unknowns: dOmega/W, dload/L, a */
	double m[3][4] = {
		{po[P], pl[P], fold->g, -keep*p[P]},
		{fold->g_omega + cblas_ddot(P, fold->g_y, 1, po, 1),
		 fold->g_load + cblas_ddot(P, fold->g_y, 1, pl, 1),
		 cblas_ddot(P, fold->g_y, 1, v, 1),
		 -keep*(fold->g + cblas_ddot(P, fold->g_y, 1, p, 1))},
		{on_row(fold, row, po) + balance->base.weight[at_omega]*row[at_omega]*W,
		 on_row(fold, row, pl) + row[at_load]/fold->L, on_row(fold, row, v),
		 last - keep*on_row(fold, row, p)},
	};

	if (solve_three(m, x, &fold->orientation))
		return 1;
	fold->orientation *= fold->sign < 0.0 ? -1 : 1;
	/* a prediction from points with other active pairs has nonzero values at inactive positions */
	for (int i = 0; i < at_omega; i++)
		dz[i] = keep*(balance->at[i] - balance->given[i]);
	for (int i = 0; i < P; i++)
		dz[balance->slot[i]] = balance->col_scale[i]*
		                       (keep*p[i] + x[0]*po[i] + x[1]*pl[i] + x[2]*v[i]);
	dz[at_omega] = W*x[0];
	dz[at_load] = fold->L*x[1];
	return 0;
}

void hawser__fold_update(struct hawser__fold *fold)
{
	const struct hawser__balance *balance = &fold->balance;
	int P = balance->unknowns;
	const double *v = side(fold, KERNEL);
	double length_v = cblas_dnrm2(P, v, 1), length_w = cblas_dnrm2(P, fold->w, 1);

	memset(fold->b, 0, (size_t)fold->size*sizeof(double));
	memset(fold->c, 0, (size_t)fold->size*sizeof(double));
	for (int i = 0; i < P; i++) {
		fold->c[balance->slot[i]] = v[i]/length_v;
		fold->b[balance->slot[i]] = fold->w[i]/length_w;
	}
}

enum hawser_status hawser__fold_border(struct hawser__fold *fold, const double *z,
                                       struct hawser_report *report)
{
	double residual;
	enum hawser_status status = HAWSER_OK;

	/* an arbitrary vector: it must not be orthogonal to the null vectors */
	for (int i = 0; i < fold->size; i++) {
		fold->b[i] = sin(1.0 + 2.385*i);
		fold->c[i] = cos(1.0 + 1.618*i);
	}
	for (int k = 0; !status && k < 3; k++) {
		status = hawser__fold_evaluate(fold, &residual, z, report);
		if (status || !isfinite(residual))
			break;
		hawser__fold_update(fold);
	}
	return status;
}
