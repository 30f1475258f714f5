/* response/cycle/export.c - equilibria and limit cycles of a family of models as AUTO-07p equations.
 *
 *    x_i      Chebyshev points of the range, cos(pi i/N), i = 0 .. N, where models are taken as rows
 *    c_k      coefficients of a row's value, (2/N) sum'' v_i cos(pi i k/N), halves at the ends
 *
 * N is doubled until the last coefficients are round-off (response/family/smooth.c interpolates in the
 * same points, for models as they are).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/family.h>

#include "core/report.h"
#include "response/cycle/hopf.h"
#include "response/family/numbers.h"
#include "rom/file/auto.h"

enum { COARSEST = 8, FINEST = 128, TAIL = 3 };
#define NOTHING 1e-14 /* coefficient that is left out, relative to the largest of its row; chosen */

/* A row at point `at`. */
struct sample {
	struct hawser__row row;
	int at;
};

static int by_kind(const struct hawser__row *a, const struct hawser__row *b)
{
	return memcmp(a, b, offsetof(struct hawser__row, factor) + sizeof a->factor);
}

static int by_product(const void *a, const void *b)
{
	const struct sample *one = a, *other = b;
	int order = by_kind(&one->row, &other->row);

	return order ? order : one->at - other->at;
}

/* A model's values in the units of the first one. */
static void to_units(struct hawser__row *row, const struct hawser_rom *rom,
                     const struct hawser_rom *first)
{
	int rates = 0;

	for (int f = 0; f < row->factors; f++)
		rates += row->factor[f] >= rom->n;
	row->value *= pow(rom->length/first->length, 1.0 - row->factors)*
	              pow(rom->time/first->time, rates - 2.0);
}

/* The rows of the models at the points of degree N: *all [*count], sorted. */
static enum hawser_status sample_rows(struct sample **all, int *count,
                                      const struct hawser_rom_family *family,
                                      const struct hawser_rom *first,
                                      const struct hawser_auto_options *o, int degree,
                                      struct hawser_report *report)
{
	*count = 0;
	for (int i = 0; i <= degree; i++) {
		double p = 0.5*(o->to + o->from + cos(M_PI*i/degree)*(o->to - o->from));
		const struct hawser_rom *rom;
		struct hawser__row *row;
		struct sample *more;
		int rows;
		enum hawser_status status = family->model(family->context, &rom, p, report);

		if (status)
			return status;
		if (rom->harmonics != first->harmonics)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
			                    "the model at %.9g has other constant forces than the first one: "
			                    "choose another range", p);
		hawser__rows(&row, &rows, rom->first ? rom->first : rom);
		more = row ? realloc(*all, ((size_t)*count + (size_t)rows + 1)*sizeof *more) : NULL;
		*all = more ? more : *all;
		for (int r = 0; more && r < rows; r++) {
			if (!rom->first)
				to_units(&row[r], rom, first);
			more[(*count)++] = (struct sample){row[r], i};
		}
		free(row);
		if (!more)
			return hawser__no_memory(report, "rom");
	}
	qsort(*all, (size_t)*count, sizeof **all, by_product);
	return HAWSER_OK;
}

/* Samples that are of one product become one row, and coefficients [degree + 1]; returns the rows.
 * *error: the largest of the last coefficients, relative to the largest value of a row with as many
 * factors. */
static int transform(struct hawser__row *row, double *coefficient, double *error,
                     const struct sample *all, int count, int degree)
{
	double most[HAWSER_TERM_FACTORS + 1] = {0.0};
	int rows = 0;

	*error = 0.0;
	for (int i = 0; i < count; i++)
		most[all[i].row.factors] = fmax(most[all[i].row.factors], fabs(all[i].row.value));
	for (int first = 0, last; first < count; first = last, rows++) {
		double *c = coefficient + (size_t)rows*((size_t)degree + 1);

		row[rows] = all[first].row;
		memset(c, 0, ((size_t)degree + 1)*sizeof *c);
		for (last = first; last < count && !by_kind(&all[last].row, &all[first].row); last++)
			for (int k = 0; k <= degree; k++)
				c[k] += (all[last].at%degree ? 1.0 : 0.5)*(k%degree ? 2.0 : 1.0)/degree*
				        all[last].row.value*cos(M_PI*k*all[last].at/degree);
		for (int k = degree; k > degree - TAIL; k--)
			*error = fmax(*error, fabs(c[k])/most[row[rows].factors]);
	}
	return rows;
}

/* The least degree that has all coefficients above round-off. */
static int trim(double *coefficient, int rows, int degree)
{
	int least = 0;

	for (int r = 0; r < rows; r++) {
		const double *c = coefficient + (size_t)r*((size_t)degree + 1);
		double most = 0.0;

		for (int k = 0; k <= degree; k++)
			most = fmax(most, fabs(c[k]));
		for (int k = least + 1; k <= degree; k++)
			if (fabs(c[k]) > NOTHING*most)
				least = k;
	}
	for (int r = 0; r < rows; r++)
		memmove(coefficient + (size_t)r*((size_t)least + 1),
		        coefficient + (size_t)r*((size_t)degree + 1), ((size_t)least + 1)*sizeof *coefficient);
	return least;
}

/* The rows of the family over the range, and coefficients [rows][degree + 1], to be freed. */
static enum hawser_status interpolate(struct hawser__row **row, double **coefficient, int *rows,
                                      int *degree, const struct hawser_rom_family *family,
                                      const struct hawser_rom *first,
                                      const struct hawser_auto_options *o,
                                      struct hawser_report *report)
{
	double error = INFINITY;
	enum hawser_status status = HAWSER_OK;

	for (*degree = COARSEST; !status && error > HAWSER__ROUND_OFF && *degree <= FINEST; *degree *= 2) {
		struct sample *all = NULL;
		int count;

		free(*row);
		free(*coefficient);
		*row = NULL;
		*coefficient = NULL;
		status = sample_rows(&all, &count, family, first, o, *degree, report);
		if (!status) {
			*row = malloc(((size_t)count + 1)*sizeof **row);
			*coefficient = malloc(((size_t)count + 1)*((size_t)*degree + 1)*sizeof **coefficient);
			if (*row && *coefficient)
				*rows = transform(*row, *coefficient, &error, all, count, *degree);
			else
				status = hawser__no_memory(report, "rom");
		}
		free(all);
	}
	*degree /= 2;
	if (!status && error > HAWSER__ROUND_OFF)
		status = hawser__fail(report, HAWSER_ERR_CONVERGENCE, "rom",
		                      "the model is no smooth function of the parameter from %.9g to %.9g: its "
		                      "coefficients differ by %.1e from a polynomial of degree %d: take a "
		                      "shorter range", o->from, o->to, error, *degree);
	if (!status)
		*degree = trim(*coefficient, *rows, *degree);
	return status;
}

/* [n], to be freed. */
static enum hawser_status find_rest(double **rest, const struct hawser_rom_family *family,
                                    const double *u, double begin, struct hawser_report *report)
{
	const struct hawser_rom *rom;
	enum hawser_status status = family->model(family->context, &rom, begin, report);

	if (status)
		return status;
	*rest = calloc((size_t)rom->n, sizeof **rest);
	if (!*rest)
		return hawser__no_memory(report, "rom");
	if (u)
		memcpy(*rest, u, (size_t)rom->n*sizeof **rest);
	return hawser__equilibrium_find(*rest, rom, !u, report);
}

enum hawser_status hawser_family_export_auto(const struct hawser_rom_family *family, const char *name,
                                             double begin, const double *u, const char *stem,
                                             const struct hawser_auto_options *options,
                                             struct hawser_report *report)
{
	struct hawser_auto_options filled = *options;
	struct hawser__auto of = {.name = name, .begin = begin, .options = &filled};
	struct hawser__row *row = NULL;
	double *coefficient = NULL, *rest = NULL;
	struct hawser_rom first = {.n = 0};
	const struct hawser_rom *rom;
	enum hawser_status status = family->model(family->context, &rom, begin, report);

	if (!status && !hawser_rom_autonomous(rom))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                      "the model is forced: its response is exported over the frequency");
	if (!status)
		status = hawser__auto_check(rom, stem, &filled, report);
	if (!status)
		status = find_rest(&rest, family, u, begin, report);
	if (!status) /* its units stay, and the model goes */
		first = (struct hawser_rom){.n = rom->n, .length = rom->length, .time = rom->time,
			.harmonics = rom->harmonics};
	if (!status)
		status = interpolate(&row, &coefficient, &of.rows, &of.degree, family, &first, &filled, report);
	if (!status)
		status = family->model(family->context, &of.rom, begin, report);
	of.row = row;
	of.coefficient = coefficient;
	of.rest = rest;
	if (!status)
		status = hawser__auto_write(&of, stem, report);
	free(row);
	free(coefficient);
	free(rest);
	return status;
}
