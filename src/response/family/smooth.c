/* response/family/smooth.c - models over a range of a parameter by interpolation.
 *
 *    x_i      Chebyshev points of the range, -1 to 1: cos(pi i/N), i = 0 .. N
 *    m_i      the numbers of the model there: K, D, entries of Q, C and terms, harmonics, shapes
 *    m(x)     their polynomial of degree N, by the barycentric formula
 *    c_k      its Chebyshev coefficients, (2/N) sum' m_i cos(pi i k/N)
 *
 * A model of a scene takes modes and quadratures, a thousand times as long as an orbit's step. Its
 * numbers are analytic functions of the parameter, so that the polynomial converges geometrically;
 * N is doubled, with the models that there are, until the last coefficients are round-off of the
 * modes. Where modes veer too fast or something begins within the range, it does not converge, and
 * each model is made.
 *
 * Reference: Berrut and Trefethen, SIAM Review 46 (2004) 501.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/family/numbers.h"
#include "response/family/smooth.h"
#include "rom/energy/kernel.h"

enum { FIRST = 8, MOST = 128, KEPT = 8, TAIL = 3 };
#define FASTER 0.1       /* least ratio of the errors of a degree and the one before; chosen */
#define BEYOND 0.01      /* of the range, to which derivatives and corrections lead; chosen */

struct hawser__smooth_models {
	int degree;
	double from, to;
	size_t numbers;
	double *value;             /* [degree + 1][numbers] */
	double *now;               /* [numbers] */
	struct hawser_rom pattern; /* with all entries */
	struct hawser_rom kept[KEPT];
	int fits[KEPT]; /* 1: the model has all entries, and is compiled */
	double p[KEPT];
	long used[KEPT], calls;
};

/* A model that has something else that depends on the parameter. */
static int has_more(const struct hawser_rom *rom)
{
	return rom->ramp || rom->history || rom->ends || rom->known.modes > 0 || rom->drag || rom->plug ||
	       rom->first || rom->exact;
}

static int same_parts(const struct hawser__number_parts *a, const struct hawser__number_parts *b)
{
	int i = 0;

	while (i < a->count && i < b->count && a->part[i].count == b->part[i].count)
		i++;
	return a->count == b->count && i == a->count && i < HAWSER__PARTS;
}

/* --- interpolation --- */

/* weight [degree + 1] of the models for that at x. */
static void weigh(double *weight, int degree, double x)
{
	double sum = 0.0;

	for (int i = 0; i <= degree; i++) {
		double apart = x - cos(M_PI*i/degree);

		if (apart == 0.0) {
			memset(weight, 0, ((size_t)degree + 1)*sizeof *weight);
			weight[i] = 1.0;
			return;
		}
		weight[i] = (i%2 ? -1.0 : 1.0)*(i%degree ? 1.0 : 0.5)/apart;
		sum += weight[i];
	}
	cblas_dscal(degree + 1, 1.0/sum, weight, 1);
}

static void combine(struct hawser__smooth_models *of, const double *weight)
{
	cblas_dgemv(CblasRowMajor, CblasTrans, of->degree + 1, (int)of->numbers, 1.0, of->value,
	            (int)of->numbers, weight, 1, 0.0, of->now, 1);
}

/* The largest of the last coefficients, relative to the largest number of its part. */
static double last_coefficients(struct hawser__smooth_models *of,
                                const struct hawser__number_parts *parts)
{
	int degree = of->degree;
	double weight[MOST + 1], worst = 0.0;

	for (int k = degree; k > degree - TAIL; k--) {
		size_t at = 0;

		for (int i = 0; i <= degree; i++)
			weight[i] = (i%degree ? 2.0 : 1.0)/degree*cos(M_PI*i*k/degree);
		combine(of, weight);
		for (int q = 0; q < parts->count; q++) {
			double most = 0.0, last = 0.0;

			for (size_t e = 0; e < parts->part[q].count; e++, at++) {
				last = fmax(last, fabs(of->now[at]));
				for (int i = 0; i <= degree; i++)
					most = fmax(most, fabs(of->value[(size_t)i*of->numbers + at]));
			}
			worst = fmax(worst, most > 0.0 ? last/most : 0.0);
		}
	}
	return worst;
}

/* The numbers of the models, in their order from `to` to `from`. *error: that of
 * their polynomial; INFINITY: they have not the same ones. */
static enum hawser_status gather(struct hawser__smooth_models *of, double *error,
                                 struct hawser_rom *const rom[], struct hawser_report *report)
{
	int nodes = of->degree + 1;
	struct hawser__number_parts first, parts;

	*error = INFINITY;
	for (int i = 0; i < nodes; i++)
		if (has_more(rom[i]) || rom[i]->harmonics != rom[0]->harmonics)
			return HAWSER_OK;
	if (!hawser__same_entries(rom, nodes))
		return hawser__no_memory(report, "frf");
	hawser__number_parts(&first, rom[0]);
	of->numbers = 0;
	for (int q = 0; q < first.count; q++)
		of->numbers += first.part[q].count;
	free(of->value);
	free(of->now);
	of->value = malloc((size_t)nodes*of->numbers*sizeof *of->value);
	of->now = malloc(of->numbers*sizeof *of->now);
	if (!of->value || !of->now)
		return hawser__no_memory(report, "frf");
	for (int i = 0; i < nodes; i++) {
		double *to = of->value + (size_t)i*of->numbers;

		hawser__number_parts(&parts, rom[i]);
		if (!same_parts(&first, &parts))
			return HAWSER_OK;
		for (int q = 0; q < parts.count; q++)
			for (size_t e = 0; e < parts.part[q].count; e++)
				*to++ = *hawser__number(&parts.part[q], e);
	}
	*error = last_coefficients(of, &first);
	return HAWSER_OK;
}

/* The model at p, in one of those that are kept. */
static enum hawser_status set_model(struct hawser__smooth_models *of, struct hawser_rom *rom,
                                    double p, struct hawser_report *report)
{
	double weight[MOST + 1];
	const double *from = of->now;
	struct hawser__number_parts parts;
	int *fits = &of->fits[rom - of->kept];
	enum hawser_status status;

	if (!*fits)
		hawser__copy_entries(rom, &of->pattern);
	weigh(weight, of->degree, 2.0*(p - of->from)/(of->to - of->from) - 1.0);
	combine(of, weight);
	hawser__number_parts(&parts, rom);
	for (int q = 0; q < parts.count; q++)
		for (size_t e = 0; e < parts.part[q].count; e++)
			*hawser__number(&parts.part[q], e) = *from++;
	if (*fits)
		return hawser__rom_refill(rom, report);
	status = hawser_rom_compile(rom, report);
	*fits = !status && hawser__has_entries(rom, &of->pattern);
	return status;
}

/* --- the models --- */

static void free_models(struct hawser__smooth_models *of)
{
	for (int i = 0; of && i < KEPT; i++)
		hawser_rom_clear(&of->kept[i]);
	if (of) {
		hawser_rom_clear(&of->pattern);
		free(of->value);
		free(of->now);
	}
	free(of);
}

/* rom[degree + 1] are those of `made` [MOST + 1] with NULL for those that are missing. A model that
 * cannot be made ends the attempt. */
static enum hawser_status make_nodes(struct hawser_rom **rom, struct hawser_rom *made, int degree,
                                     const struct hawser__model_maker *maker)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; !status && i <= degree; i++) {
		double x = cos(M_PI*i/degree);

		rom[i] = &made[i*(MOST/degree)];
		if (rom[i]->n == 0)
			status = maker->make(maker->context, rom[i],
			                     0.5*((maker->to + maker->from) + x*(maker->to - maker->from)), NULL);
	}
	return status;
}

static enum hawser_status open_models(struct hawser__smooth *smooth,
                                      const struct hawser__model_maker *maker,
                                      struct hawser_report *report)
{
	struct hawser__smooth_models *of = calloc(1, sizeof *of);
	struct hawser_rom *made = calloc(MOST + 1, sizeof *made), *rom[MOST + 1];
	enum hawser_status status = of && made ? HAWSER_OK : hawser__no_memory(report, "frf");
	double error = 1.0, before = HUGE_VAL;

	for (int degree = FIRST; !status && error > HAWSER__ROUND_OFF && error < FASTER*before &&
	     degree <= MOST; degree *= 2) {
		enum hawser_status end = make_nodes(rom, made, degree, maker);

		before = error;
		error = INFINITY;
		if (end == HAWSER_ERR_MEMORY)
			status = hawser__no_memory(report, "frf");
		of->degree = degree;
		if (!end)
			status = gather(of, &error, rom, report);
	}
	if (!status && error <= HAWSER__ROUND_OFF) {
		of->from = maker->from;
		of->to = maker->to;
		of->pattern = *rom[KEPT];
		*rom[KEPT] = (struct hawser_rom){.n = 0};
		for (int i = 0; i < KEPT; i++) {
			of->kept[i] = *rom[i];
			*rom[i] = (struct hawser_rom){.n = 0};
		}
		smooth->models = of;
		of = NULL;
	}
	for (int i = 0; made && i <= MOST; i++)
		hawser_rom_clear(&made[i]);
	free(made);
	free_models(of);
	return status;
}

enum hawser_status hawser__smooth_model(struct hawser__smooth *smooth,
                                        const struct hawser_rom **rom,
                                        const struct hawser__model_maker *maker, double p,
                                        struct hawser_report *report)
{
	double margin = BEYOND*(maker->to - maker->from);
	struct hawser__smooth_models *of;
	enum hawser_status status = HAWSER_OK;
	int oldest = 0;

	*rom = NULL;
	if (smooth->asked <= HAWSER__SMOOTH_PATIENCE && ++smooth->asked > HAWSER__SMOOTH_PATIENCE)
		status = open_models(smooth, maker, report);
	of = smooth->models;
	if (status || !of || !(p >= of->from - margin && p <= of->to + margin))
		return status;
	for (int i = 0; i < KEPT; i++) {
		if (of->used[i] > 0 && of->p[i] == p) {
			of->used[i] = ++of->calls;
			*rom = &of->kept[i];
			return HAWSER_OK;
		}
		if (of->used[i] < of->used[oldest])
			oldest = i;
	}
	of->used[oldest] = 0;
	status = set_model(of, &of->kept[oldest], p, report);
	if (status)
		return status;
	of->p[oldest] = p;
	of->used[oldest] = ++of->calls;
	*rom = &of->kept[oldest];
	return HAWSER_OK;
}

void hawser__smooth_clear(struct hawser__smooth *smooth)
{
	free_models(smooth->models);
	*smooth = (struct hawser__smooth){0};
}
