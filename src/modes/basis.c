/* modes/basis.c - all Galerkin modes of a polynomial basis.
 *
 *   x      coefficients of the strains, as in compliance.c: the strain energy is x.x/2
 *   G      displacements of the functions at the grid's points, times sqrt(weight): M = G'G
 *   C      displacements of end B, which must vanish; Z an orthonormal basis of its null space
 *   G Z = U S V'      singular values, 1/omega
 *
 * The columns of U are the displacements of the modes, orthonormal on the grid, and Z V/S are their
 * strains. The whole spectrum is needed, up to longitudinal modes with 1/omega^2 of order
 * epsilon/N^4. These eigenvalues of M are smaller than the round-off of its largest one, so that
 * the symmetric eigensolver of compliance.c, which computes the lowest modes, cannot be used. The
 * columns of G are graded in the same way, with sqrt(epsilon) for stretch; Householder reflections
 * by C preserve the grading, and one-sided Jacobi computes the small singular values of such a
 * matrix to full relative accuracy (J. Demmel, K. Veselic, SIAM J. Matrix Anal. Appl. 13 (1992)
 * 1204).
 *
 * The modes are not refined outside the basis: they are the solutions of the Galerkin problem, so
 * that mass and stiffness are diagonal and the modes span the same space as the polynomials.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "modes/bending/bending.h"
#include "modes/cable.h"
#include "modes/compliance.h"
#include "modes/label.h"
#include "modes/methods.h"
#include "modes/spectral.h"

/* Largest number of functions per component: with more the decomposition takes minutes. */
enum { MOST = 400 };

/* The result in one plane: `count` modes by ascending omega. */
struct part {
	int count, D, degree;
	double *omega;        /* [count] */
	double *strain;       /* [count][strains] */
	double *displacement; /* [count][displacements] */
};

/* Matrices are column-major. */
struct work {
	int n, rows;    /* functions and springs; displacements */
	int held;       /* D + springs: constraints */
	double *G;      /* [n] columns of `rows` */
	double *C;      /* [held] columns of n, then its QR */
	double *ends;   /* [held] columns of n: C before its factorisation */
	double *x;      /* [n - held] columns of n; V, then Z V */
	double *S;      /* [n] */
	double *scratch; /* [points] and [n] */
	double tau[HAWSER__MAX_FORCES];
	struct hawser__hold hold;
};

static void part_clear(struct part *part)
{
	free(part->omega);
	free(part->strain);
	free(part->displacement);
}

static void work_clear(struct work *w)
{
	hawser__hold_clear(&w->hold);
}

static int work_init(struct work *w, struct part *part, const struct hawser__cable *cable,
                     const struct hawser__plane *plane)
{
	size_t D = (size_t)part->D, held = D + (size_t)plane->springs;
	size_t n = D*(size_t)part->degree*(size_t)cable->grid.elements + (size_t)plane->springs +
	           (size_t)plane->joints + (size_t)plane->absorbers;
	size_t rows = hawser__displacements(plane, &cable->grid);

	*w = (struct work){.n = (int)n, .rows = (int)rows, .held = (int)held};
	part->count = (int)(n - held);
	w->G = hawser__hold(&w->hold, n*rows + 1, sizeof *w->G);
	w->C = hawser__hold(&w->hold, n*held + 1, sizeof *w->C);
	w->ends = hawser__hold(&w->hold, n*held + 1, sizeof *w->ends);
	w->x = hawser__hold(&w->hold, n*n + 1, sizeof *w->x);
	w->S = hawser__hold(&w->hold, n + 1, sizeof *w->S);
	w->scratch = hawser__hold(&w->hold, (size_t)cable->grid.points + n + 1, sizeof *w->scratch);
	part->omega = hawser__numbers(n, 1);
	part->strain = hawser__numbers(n, hawser__strains(plane, &cable->grid));
	part->displacement = hawser__numbers(n, rows);
	return !w->hold.short_of_memory && part->omega && part->strain && part->displacement;
}

/* Assemble G and C, one function at a time. */
static void assemble(struct work *w, const struct part *part, const struct hawser__cable *cable,
                     const struct hawser__plane *plane)
{
	const struct hawser_grid *grid = &cable->grid;
	double *unit = w->scratch + grid->points, *strain = part->strain, end[HAWSER__MAX_D];
	int functions = w->n - plane->springs - plane->joints - plane->absorbers, lump;

	for (int i = 0; i < w->n - plane->springs; i++) { /* the strains of springs displace nothing */
		int f = i < functions ? i : i + plane->springs;
		double *G = w->G + (size_t)f*(size_t)w->rows;

		unit[f] = 1.0;
		hawser__compliance_strain(strain, unit, plane, grid, &cable->reference,
		                          part->degree);
		unit[f] = 0.0;
		hawser__compliance_displace(G, end, w->scratch, strain, plane, grid,
		                            &cable->reference);
		for (int c = 0; c < part->D; c++) {
			w->C[c*w->n + f] = end[c];
			for (int p = 0; p < grid->points; p++)
				G[c*grid->points + p] *= sqrt(grid->weight[p]);
		}
		for (int k = 0; k < part->D*(plane->lumps + plane->absorbers); k++)
			G[part->D*grid->points + k] *= sqrt(hawser__row_mass(&lump, plane, k));
	}
	hawser__spring_constraints(w->C + part->D*w->n, w->C, w->n, part->D*part->degree, plane, grid);
}

/* Correct the columns of x so that end B does not move. In the highest modes the entries for
 * stretch are of order 1 and those for rotation of order sqrt(epsilon), but the Householder
 * reflections leave absolute errors of the order of round-off in all entries, and an entry for
 * rotation displaces the end 1/sqrt(epsilon) times as far. The displacement ends'x is accurate
 * relative to its terms. With ends = Q R the component of x along the columns of Q, (R')^-1 ends'x,
 * is therefore subtracted. Returns LAPACKE's info. */
static int hold_end(struct work *w, int D, int count)
{
	int n = w->n, info = 0;
	double *part = w->scratch; /* [n] */

	for (int k = 0; k < count && !info; k++) {
		double *x = w->x + (size_t)k*(size_t)n;

		memset(part, 0, (size_t)n*sizeof *part);
		cblas_dgemv(CblasColMajor, CblasTrans, n, D, 1.0, w->ends, n, x, 1, 0.0, part, 1);
		cblas_dtrsv(CblasColMajor, CblasUpper, CblasTrans, CblasNonUnit, D, w->C, n, part, 1);
		info = LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', 'N', n, 1, D, w->C, n, w->tau, part, n);
		cblas_daxpy(n, -1.0, part, 1, x, 1);
	}
	return info;
}

/* Compute U (in the last columns of G), S, and x = Z V. Returns LAPACKE's info. */
static int decompose(struct work *w, const struct part *part)
{
	int n = w->n, D = w->held, count = part->count, info;
	double stat[6] = {0.0};

	memcpy(w->ends, w->C, (size_t)n*(size_t)D*sizeof *w->ends);
	/* NOLINTNEXTLINE(clang-analyzer-unix.Malloc): the caller clears both */
	info = LAPACKE_dgeqrf(LAPACK_COL_MAJOR, n, D, w->C, n, w->tau);
	if (!info)
		info = LAPACKE_dormqr(LAPACK_COL_MAJOR, 'R', 'N', w->rows, n, D, w->C, n, w->tau, w->G,
		                      w->rows);
	if (!info)
		info = LAPACKE_dgesvj(LAPACK_COL_MAJOR, 'G', 'U', 'V', w->rows, count,
		                      w->G + (size_t)D*(size_t)w->rows, w->rows, w->S, 0, w->x + D, n,
		                      stat);
	if (info)
		return info;
	cblas_dscal(count, stat[0], w->S, 1);
	info = LAPACKE_dormqr(LAPACK_COL_MAJOR, 'L', 'N', n, count, D, w->C, n, w->tau, w->x, n);
	return info ? info : hold_end(w, D, count);
}

static void unfold(struct part *part, const struct work *w, const struct hawser__cable *cable,
                   const struct hawser__plane *plane)
{
	const struct hawser_grid *grid = &cable->grid;
	size_t rows = (size_t)w->rows, strains = hawser__strains(plane, grid);
	size_t values = (size_t)part->D*(size_t)grid->points;

	for (int k = 0; k < part->count; k++) {
		const double *U = w->G + ((size_t)w->held + (size_t)k)*rows;
		double *strain = part->strain + (size_t)k*strains;
		double *displacement = part->displacement + (size_t)k*rows;

		part->omega[k] = 1.0/w->S[k];
		hawser__compliance_strain(strain, w->x + (size_t)k*(size_t)w->n, plane, grid,
		                          &cable->reference, part->degree);
		cblas_dscal((int)strains, part->omega[k], strain, 1);
		for (size_t i = 0; i < values; i++)
			displacement[i] = U[i]/sqrt(grid->weight[i%(size_t)grid->points]);
		for (size_t i = values; i < rows; i++) { /* not used without a mass */
			int lump;
			double mass = hawser__row_mass(&lump, plane, (int)(i - values));

			displacement[i] = mass > 0.0 ? U[i]/sqrt(mass) : 0.0;
		}
	}
}

static enum hawser_status solve(struct part *part, const struct hawser__cable *cable, int plane,
                                struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int info;
	struct work w;

	if (!work_init(&w, part, cable, &cable->plane[plane])) {
		status = hawser__no_memory(report, "modes");
		goto done;
	}
	assemble(&w, part, cable, &cable->plane[plane]);
	info = decompose(&w, part);
	if (info) {
		status = hawser__lapack_starved(info) ? hawser__no_memory(report, "modes")
			: hawser__fail(report, HAWSER_ERR_NAN, "modes",
			               "the modes of a basis of %d functions a component did not come "
			               "out: check EA, rho, d and the tension of the span",
			               part->count/part->D);
		goto done;
	}
	unfold(part, &w, cable, &cable->plane[plane]);
done:
	work_clear(&w);
	return status;
}

/* Error estimate of omega: its relative change by one step with the exact operator, as for the
 * refined modes (spectral.c), plus the round-off of that step. The round-off of the decomposition
 * is part of the change and needs no separate estimate. copy and work are [D + 1][points] each. */
static double error_of(const struct part *part, const struct hawser__cable *cable, int plane, int k,
                       double *copy, double *work)
{
	const struct hawser_grid *grid = &cable->grid;
	const struct hawser__plane *problem = &cable->plane[plane];
	size_t rows = hawser__displacements(problem, grid);
	double *strain = copy + rows, omega = part->omega[k], better;

	cblas_dcopy((int)rows, part->displacement + (size_t)k*rows, 1, copy, 1);
	hawser__compliance_apply(copy, strain, omega, problem, grid, &cable->reference,
	                         work);
	better = sqrt(hawser__energy_product(strain, strain, problem, grid)/
	              hawser__mass_product(copy, copy, problem, grid));
	return hawser__spectral_estimate(fabs(better/omega - 1.0), grid->elements);
}

/* Merge both planes by ascending omega. */
static enum hawser_status finish(struct hawser_modes *modes, struct hawser__cable *cable,
                                 const struct part *part, struct hawser_report *report)
{
	size_t points = (size_t)cable->grid.points;
	int next[HAWSER__PLANES] = {0}, n = part[0].count + part[1].count;
	/* displacements and strains, and the work space of a step */
	size_t copies = 2*HAWSER__MAX_D*points + HAWSER__MAX_D*HAWSER__MAX_LUMPS +
	                HAWSER__MAX_SPRINGS + HAWSER__MAX_JOINTS +
	                (HAWSER__MAX_D + 1)*HAWSER__MAX_ABSORBERS;
	double *work = hawser__numbers(copies + (HAWSER__MAX_D + 1)*points, 1);
	enum hawser_status status = work ? hawser__modes_allocate(modes, n, (int)points, report)
	                                 : hawser__no_memory(report, "modes");

	for (int k = 0; !status && k < n; k++) {
		int q = next[1] == part[1].count ||
		        (next[0] < part[0].count && part[0].omega[next[0]] <= part[1].omega[next[1]])
		        ? 0 : 1;
		const struct hawser__plane *plane = &cable->plane[q];
		size_t strain = (size_t)next[q]*hawser__strains(plane, &cable->grid);
		size_t displacement = (size_t)next[q]*hawser__displacements(plane, &cable->grid);

		modes->mode[k].plane = (enum hawser_plane)q;
		modes->mode[k].omega = part[q].omega[next[q]];
		modes->mode[k].residual = error_of(&part[q], cable, q, next[q], work, work + copies);
		hawser__cable_fields(modes->shape + (size_t)k*3*points,
		                     modes->slope + (size_t)k*3*points, cable, q,
		                     part[q].strain + strain, part[q].displacement + displacement);
		if (modes->stroke)
			hawser__cable_strokes(modes->stroke + k*modes->statics.attachments, cable, q,
			                      part[q].strain + strain);
		next[q]++;
	}
	free(work);
	if (status)
		return status;
	modes->grid = cable->grid;
	cable->grid = (struct hawser_grid){0};
	return hawser__modes_label(modes, report);
}

enum hawser_status hawser_modes_basis(struct hawser_modes *modes,
                                      const struct hawser_statics *statics, int in_plane,
                                      int out_of_plane, struct hawser_report *report)
{
	int most = in_plane > out_of_plane ? in_plane : out_of_plane, elements, degree;
	const int functions[HAWSER__PLANES] = {statics->space ? most : in_plane,
	                                       statics->space ? 0 : out_of_plane};
	int bent[HAWSER__PLANES]; /* degrees with bending stiffness */
	struct hawser__cable cable = {0};
	struct part part[HAWSER__PLANES] = {{.D = statics->space ? 3 : 2}, {.D = 1}};
	enum hawser_status status = hawser__modes_check_statics(statics, report);

	*modes = (struct hawser_modes){0};
	if (status)
		return status;
	status = hawser__check_absorbers(statics, report);
	if (status)
		return status;
	if (in_plane < 0 || out_of_plane < 0 || most < 1 || most > MOST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes",
		                    "a basis of %d functions a component in the plane and %d out of "
		                    "it: give 0 to %d, not both 0", in_plane, out_of_plane,
		                    MOST);
	if (statics->bending.EI > 0.0) {
		status = hawser__flexure_functions(bent, statics, functions, report);
		return status ? status : hawser__flexure_basis(modes, statics, bent, 1.0, report);
	}
	degree = hawser__cable_split(&elements, statics, most);
	status = hawser__cable_init(&cable, statics, elements, degree, report);
	for (int q = 0; q < HAWSER__PLANES && !status; q++) {
		part[q].degree = functions[q] >= elements ? (functions[q] + 1)/elements : 1;
		if (functions[q] > 0)
			status = solve(&part[q], &cable, q, report);
	}
	modes->statics = *statics;
	if (!status)
		status = finish(modes, &cable, part, report);
	hawser__cable_clear(&cable);
	part_clear(&part[0]);
	part_clear(&part[1]);
	if (status) {
		hawser_modes_clear(modes);
		return status;
	}
	modes->method = "basis";
	modes->basis = degree*elements - 1;
	modes->time_unit = statics->span.d*sqrt(statics->span.rho/statics->H);
	return HAWSER_OK;
}
