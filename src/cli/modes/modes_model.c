/* cli/modes/modes_model.c - hawser modes of a reduced model: its linear motions about u = 0.
 *
 *   K, D   with terms of one factor and constant ones
 *   A      first-order matrix. u'' + D u' + K u = 0: [0 I; -K -D], of order 2n. Equations
 *          u' = g(u): -K of u'' = g (struct hawser_rom, first), of order n
 *   l      its eigenvalues; of a conjugate pair the one above the real axis
 *
 * The model need not be that of a cable: K and D may be any matrices, so that l may be real, and the
 * motion unstable. LAPACK's balanced QR algorithm finds all of them; its orders are small.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/modes/modes_result.h"
#include "core/hold.h"
#include "core/report.h"

struct motion {
	double omega, re, ratio;
	double *amplitude, *phase; /* [n] of the coordinates, the largest 1 with phase 0 */
};
struct result {
	const struct cli_common *common;
	struct cli_model model;
	int motions, turns;    /* turns: some terms depend on Omega */
	struct motion *motion; /* [motions] by omega, then by re */
	double *part;          /* what they point to */
};

/* --- fields --- */

struct row {
	struct motion motion;
	int index;
	const double *amplitude, *phase;
};

#define OF(member) HAWSER__AT(struct row, member)
const struct hawser__field cli_modes_model_field[] = {
	{"index", "index", "from 1, by frequency", OF(index)},
	{"omega", "omega", "circular frequency: imaginary part of the eigenvalue", OF(motion.omega),
	 .unit = HAWSER__RAD_S},
	{"re", "re", "real part of the eigenvalue: above 0 the motion grows", OF(motion.re),
	 .unit = HAWSER__PER_S},
	{"damping_ratio", "damping_ratio", "fraction of critical damping: -re over the modulus",
	 OF(motion.ratio)},
	{"amplitude", "u_", "amplitude of each coordinate, the largest 1",
	 HAWSER__VECTOR_AT(struct row, amplitude, cli_coordinates)},
	{"phase", NULL, "phase of each coordinate to the largest (rad)",
	 HAWSER__VECTOR_AT(struct row, phase, cli_coordinates)},
	HAWSER__END,
};
#undef OF

static const void *row_at(void *to, const void *parent, size_t index)
{
	const struct motion *motion = &((const struct result *)parent)->motion[index];

	*(struct row *)to = (struct row){.motion = *motion, .index = (int)index + 1,
	                                 .amplitude = motion->amplitude, .phase = motion->phase};
	return to;
}
static const struct hawser__list row_list = HAWSER__MADE_ROWS(
	struct row, cli_modes_model_field, struct result, motions, row_at);
const struct hawser__field cli_modes_model_member[] = {
	{"", NULL, "", HAWSER__PART_OF(struct result, model, cli_si_field)},
	{"modes", NULL, "by frequency", HAWSER__OBJECTS_OF(row_list)},
	HAWSER__END,
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_model_head(result->common, "modes", "linear", &result->model, 0);
}

/* Whether a force acts at rest. */
static int is_pushed(const struct hawser_rom *rom)
{
	for (int h = 0; h < rom->harmonics; h++)
		for (int j = 0; rom->harmonic[h].k == 0 && rom->harmonic[h].f && j < rom->n; j++)
			if (rom->harmonic[h].f[j] != 0.0)
				return 1;
	return 0;
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;

	hawser__table_comment(table, "linear motions about u = 0 of %d coordinates%s%s%s",
	                      result->model.rom.n,
	                      result->model.rom.first ? ", equations of first order" : "",
	                      is_pushed(&result->model.rom)
	                      ? "; u = 0 is no equilibrium, since a constant force acts" : "",
	                      result->turns ? "; without constant terms that depend on Omega" : "");
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	(void)path;
	(void)of;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "modes", "modes of a reduced model have no "
	                    "picture, since its file has no shapes; hawser frf --plot draws its response");
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &row_list,
                                           .fields = cli_modes_model_member, .draw = draw};

/* --- eigenvalues --- */

/* A [m][m]; returns m. matrix [2][n][n] is scratch. */
static size_t first_order(double *A, struct result *result, double *matrix)
{
	const struct hawser_rom *rom = &result->model.rom;
	size_t n = (size_t)rom->n, m = rom->first ? n : 2*n;
	double *K = matrix, *D = matrix + n*n;

	result->turns = cli_linear(K, D, rom->first ? rom->first : rom);
	memset(A, 0, m*m*sizeof *A);
	for (size_t j = 0; j < n; j++) {
		double *row = A + m*(rom->first ? j : n + j);

		if (!rom->first)
			A[m*j + n + j] = 1.0;
		for (size_t k = 0; k < n; k++) {
			row[k] = -K[j*n + k];
			if (!rom->first)
				row[n + k] = -D[j*n + k];
		}
	}
	return m;
}

/* The coordinates of eigenvector `column` [m][m]; the imaginary part, if any, is in the next one. */
static void scale(struct motion *motion, const double *vector, size_t n, size_t m, size_t column)
{
	size_t largest = 0;
	double turn;

	for (size_t j = 0; j < n; j++) {
		double re = vector[m*j + column], im = motion->omega > 0.0 ? vector[m*j + column + 1] : 0.0;

		motion->amplitude[j] = hypot(re, im);
		motion->phase[j] = atan2(im, re);
		if (motion->amplitude[j] > motion->amplitude[largest])
			largest = j;
	}
	turn = motion->phase[largest];
	for (size_t j = n; j-- > 0;)
		motion->phase[j] = motion->amplitude[j] > 0.0 ? remainder(motion->phase[j] - turn, 2.0*M_PI)
		                                              : 0.0;
	for (size_t j = 0; j < n; j++)
		if (j != largest)
			motion->amplitude[j] /= motion->amplitude[largest];
	motion->amplitude[largest] = 1.0;
}

static int by_frequency(const void *a, const void *b)
{
	const struct motion *x = a, *y = b;
	int order = (x->omega > y->omega) - (x->omega < y->omega);

	return order ? order : (x->re < y->re) - (x->re > y->re);
}

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	const struct hawser_rom *rom = &result->model.rom;
	size_t n = (size_t)rom->n, m = 2*n;
	double *A = malloc((2*m*m + 2*m)*sizeof *A), *vector = hawser__behind(A, m*m);
	double *re = hawser__behind(vector, m*m), *im = hawser__behind(re, m);
	int info;

	result->motion = calloc(m, sizeof *result->motion);
	result->part = calloc(2*m*n, sizeof *result->part);
	if (!A || !result->motion || !result->part) {
		free(A);
		return hawser__no_memory(report, "modes");
	}
	m = first_order(A, result, vector);
	info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', (lapack_int)m, A, (lapack_int)m, re, im, NULL, 1,
	                     vector, (lapack_int)m);
	for (size_t j = 0; info == 0 && j < m; j++) {
		struct motion *motion = &result->motion[result->motions];
		double size = hypot(re[j], im[j]);

		if (im[j] < 0.0)
			continue;
		*motion = (struct motion){
			.omega = im[j], .re = re[j] + 0.0, .ratio = size > 0.0 ? 0.0 - re[j]/size : 0.0,
			.amplitude = result->part + 2*n*(size_t)result->motions,
			.phase = result->part + 2*n*(size_t)result->motions + n};
		scale(motion, vector, n, m, j);
		result->motions++;
	}
	free(A);
	if (info)
		return hawser__lapack_starved(info) ? hawser__no_memory(report, "modes")
			: hawser__fail(report, HAWSER_ERR_CONVERGENCE, "modes", "the eigenvalues of the model's K "
			               "and D were not found: LAPACK's dgeev ended with %d", info);
	qsort(result->motion, (size_t)result->motions, sizeof *result->motion, by_frequency);
	return HAWSER_OK;
}

enum hawser_status cli_modes_model(const struct cli_common *common, int n,
                                   struct hawser_report *report)
{
	struct result result = {.common = common};
	enum hawser_status status = cli_model_load(&result.model, common, 0, report);

	if (!status)
		status = solve(&result, report);
	if (!status && n > 0 && n < result.motions)
		result.motions = n;
	if (!status)
		status = cli_show(common, &showing, &result, report);
	free(result.motion);
	free(result.part);
	cli_model_clear(&result.model);
	return status;
}
