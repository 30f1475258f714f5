/* rom/file/read_own.c - what only own models have: a mass matrix, terms, equations of first order,
 * and named parameters (hawser-rom(5)).
 *
 *   M x'' + ... = f     multiplied by M^-1 on reading, so that the coordinates stay those of the file
 *   x' = g(x, tau)      becomes x'' = dg/dt - r (x' - g), r > 0. The defect c = x' - g satisfies
 *                       c' = -r c, so that every periodic motion has c = 0, and these are the periodic
 *                       motions of x' = g. Its multipliers are among those of the new equations; the n
 *                       others are exp(-r T), of perturbations of c, and always stable
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <jansson.h>
#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rom/file/read.h"

#define LEAST_RCOND 1e-13 /* of a mass matrix; below, the equations have no digits left; chosen */

/* --- terms --- */

/* [j, [k, ...], [l, ...], value] */
static enum hawser_status read_term(const struct hawser__parser *reader, struct hawser_term *term,
                                    int n,
                                    const json_t *entry, const char *where)
{
	enum hawser_status status;
	char place[80];

	if (!json_is_array(entry) || json_array_size(entry) != 4)
		return hawser__wrong(reader, "%s: [j, [coordinates], [velocities], value] is wanted", where);
	snprintf(place, sizeof place, "%s: the equation j", where);
	if ((status = hawser__read_integer(reader, &term->j, json_array_get(entry, 0), 0, n - 1, place)))
		return status;
	for (size_t part = 1; part < 3; part++) {
		const json_t *list = json_array_get(entry, part);
		size_t count = json_array_size(list);

		if (!json_is_array(list))
			return hawser__wrong(reader, "%s: a list of the indices of %s is wanted", where,
			                     part == 1 ? "coordinates" : "velocities");
		for (size_t i = 0; i < count; i++) {
			if (term->factors == HAWSER_TERM_FACTORS)
				return hawser__wrong(reader, "%s: more than %d factors", where,
				                     HAWSER_TERM_FACTORS);
			snprintf(place, sizeof place, "%s: factor %d", where, term->factors + 1);
			status = hawser__read_integer(reader, &term->factor[term->factors++],
			                              json_array_get(list, i), 0, n - 1, place);
			if (status)
				return status;
		}
		term->rates = part == 2 ? (int)count : 0;
	}
	if (term->factors == 0)
		return hawser__wrong(reader, "%s has no factor: a constant force is an f of a harmonic of k 0",
		                     where);
	snprintf(place, sizeof place, "%s: the value", where);
	return hawser__read_number(reader, &term->value, json_array_get(entry, 3), place);
}

/* Room for `more` terms at the end of the list. */
static struct hawser_term *extend(struct hawser_term **term, const int *terms, size_t more)
{
	struct hawser_term *larger = realloc(*term, ((size_t)*terms + more + 1)*sizeof *larger);

	if (!larger)
		return NULL;
	*term = larger;
	return larger + *terms;
}

enum hawser_status hawser__read_terms(const struct hawser__parser *reader, struct hawser_term **term,
                                      int *terms, int n, const json_t *list, const char *name)
{
	enum hawser_status status = HAWSER_OK;
	size_t count = json_array_size(list);
	struct hawser_term *at;

	if (!json_is_array(list))
		return hawser__wrong(reader, "%s: a list of entries is wanted", name);
	if (!(at = extend(term, terms, count)))
		return hawser__no_memory(reader->report, "rom");
	for (size_t i = 0; !status && i < count; i++) {
		char where[48];

		snprintf(where, sizeof where, "%s[%zu]", name, i);
		at[i] = (struct hawser_term){.j = 0};
		status = read_term(reader, &at[i], n, json_array_get(list, i), where);
		*terms += !status;
	}
	return status;
}

enum hawser_status hawser__quads_to_terms(struct hawser_harmonic *h, struct hawser_report *report)
{
	struct hawser_term *at = extend(&h->term, &h->terms, (size_t)h->quads);

	if (!at)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < h->quads; i++)
		at[i] = (struct hawser_term){.j = h->Q[i].j, .factors = 2, .factor = {h->Q[i].k, h->Q[i].l},
			.value = h->Q[i].value};
	h->terms += h->quads;
	h->quads = 0;
	return HAWSER_OK;
}

enum hawser_status hawser__cubics_to_terms(struct hawser_harmonic *h, const struct hawser_cubic *C,
                                           int cubics, struct hawser_report *report)
{
	struct hawser_term *at = extend(&h->term, &h->terms, (size_t)cubics);

	if (!at)
		return hawser__no_memory(report, "rom");
	for (int i = 0; i < cubics; i++)
		at[i] = (struct hawser_term){.j = C[i].j, .factors = 3, .factor = {C[i].k, C[i].l, C[i].m},
			.value = C[i].value};
	h->terms += cubics;
	return HAWSER_OK;
}

/* --- the mass matrix --- */

/* x [n][columns] becomes M^-1 x. */
static void divide(double *x, const double *inverse, double *row, int n, int columns)
{
	for (int c = 0; x && c < columns; c++) {
		for (int j = 0; j < n; j++)
			row[j] = x[j*columns + c];
		for (int i = 0; i < n; i++) {
			double sum = 0.0;

			for (int j = 0; j < n; j++)
				sum += inverse[i*n + j]*row[j];
			x[i*columns + c] = sum;
		}
	}
}

/* An entry of equation j becomes one in each equation i with (M^-1)_ij. */
#define SPREAD(type, list, count)                                                             \
	do {                                                                                  \
		struct type *all = malloc(((size_t)(count)*(size_t)n + 1)*sizeof *all);       \
		int to = 0;                                                                   \
                                                                                              \
		if (!all)                                                                     \
			return hawser__no_memory(report, "rom");                              \
		for (int e = 0; e < (count); e++)                                             \
			for (int i = 0; i < n; i++)                                           \
				if (inverse[i*n + (list)[e].j] != 0.0) {                      \
					all[to] = (list)[e];                                  \
					all[to].value *= inverse[i*n + (list)[e].j];          \
					all[to++].j = i;                                      \
				}                                                             \
		free(list);                                                                   \
		(list) = all;                                                                 \
		(count) = to;                                                                 \
	} while (0)

enum hawser_status hawser__rom_divide(struct hawser_rom *rom, const double *inverse, double *row,
                                      struct hawser_report *report)
{
	int n = rom->n;

	divide(rom->D, inverse, row, n, n);
	divide(rom->K, inverse, row, n, n);
	SPREAD(hawser_quad, rom->Q, rom->quads);
	SPREAD(hawser_cubic, rom->C, rom->cubics);
	SPREAD(hawser_term, rom->term, rom->terms);
	for (int h = 0; h < rom->harmonics; h++) {
		struct hawser_harmonic *harmonic = &rom->harmonic[h];

		divide(harmonic->f, inverse, row, n, 1);
		divide(harmonic->D, inverse, row, n, n);
		divide(harmonic->K, inverse, row, n, n);
		SPREAD(hawser_quad, harmonic->Q, harmonic->quads);
		SPREAD(hawser_term, harmonic->term, harmonic->terms);
	}
	return HAWSER_OK;
}

static enum hawser_status read_mass(const struct hawser__parser *reader, struct hawser_rom *rom,
                                    const json_t *value)
{
	lapack_int n = rom->n, info;
	size_t n2 = (size_t)n*(size_t)n;
	double *inverse = malloc((n2 + (size_t)n)*sizeof *inverse), rcond = 0.0, norm;
	lapack_int *pivot = malloc((size_t)n*sizeof *pivot);
	enum hawser_status status = HAWSER_OK;

	rom->mass = malloc(n2*sizeof *rom->mass);
	if (!inverse || !pivot || !rom->mass)
		status = hawser__no_memory(reader->report, "rom");
	if (!status)
		status = hawser__read_array(reader, rom->mass, value, (size_t[]){(size_t)n, (size_t)n}, 2,
		                            "M");
	if (!status && (rom->ramp || json_object_get(reader->root, "shapes")))
		status = hawser__wrong(reader, "M goes with models that have neither a ramp nor shapes: those "
		                       "have unit mass");
	if (!status) {
		memcpy(inverse, rom->mass, n2*sizeof *inverse);
		norm = LAPACKE_dlange(LAPACK_ROW_MAJOR, '1', n, n, inverse, n);
		info = LAPACKE_dgetrf(LAPACK_ROW_MAJOR, n, n, inverse, n, pivot);
		if (info == 0)
			LAPACKE_dgecon(LAPACK_ROW_MAJOR, '1', n, inverse, n, norm, &rcond);
		if (info == 0 && rcond > LEAST_RCOND)
			info = LAPACKE_dgetri(LAPACK_ROW_MAJOR, n, inverse, n, pivot);
		if (hawser__lapack_starved(info))
			status = hawser__no_memory(reader->report, "rom");
		else if (info || !(rcond > LEAST_RCOND))
			status = hawser__wrong(reader, "M is singular (reciprocal condition number %.1e): "
			                       "eliminate coordinates without mass", rcond);
		else
			status = hawser__rom_divide(rom, inverse, inverse + n2, reader->report);
	}
	free(inverse);
	free(pivot);
	return status;
}

/* --- first order --- */

/* The time derivative of terms [count], added to the list *to. */
static int differentiate(struct hawser_term **to, int *terms, const struct hawser_term *term, int count)
{
	struct hawser_term *at = extend(to, terms, (size_t)count*HAWSER_TERM_FACTORS);

	for (int e = 0; at && e < count; e++)
		/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): as_terms() fills all */
		for (int i = 0; i < term[e].factors; i++) {
			struct hawser_term t = term[e];

			t.factor[i] = term[e].factor[t.factors - 1];
			t.factor[t.factors - 1] = term[e].factor[i];
			t.rates = 1;
			*at++ = t;
			(*terms)++;
		}
	return !at;
}

/* Q and C as terms, in a new list. */
static struct hawser_term *as_terms(const struct hawser_quad *Q, int quads,
                                    const struct hawser_cubic *C,
                                    int cubics, const struct hawser_term *term, int terms)
{
	struct hawser_term *all = malloc(((size_t)quads + (size_t)cubics + (size_t)terms + 1)*sizeof *all);
	struct hawser_term *at = all;

	for (int i = 0; all && i < quads; i++)
		*at++ = (struct hawser_term){.j = Q[i].j, .factors = 2, .factor = {Q[i].k, Q[i].l},
			.value = Q[i].value};
	for (int i = 0; all && i < cubics; i++)
		*at++ = (struct hawser_term){.j = C[i].j, .factors = 3, .factor = {C[i].k, C[i].l, C[i].m},
			.value = C[i].value};
	if (all && terms)
		memcpy(at, term, (size_t)terms*sizeof *term);
	return all;
}

static void times(double *x, double factor, int count)
{
	for (int i = 0; x && i < count; i++)
		x[i] *= factor;
}

static double *copy(const double *x, int count)
{
	double *to = x ? malloc(((size_t)count + 1)*sizeof *to) : NULL;

	if (to)
		memcpy(to, x, (size_t)count*sizeof *to);
	return to;
}

/* `rate` gets the derivative of the wave of h; h becomes r times itself, with the derivatives of u. */
static int raise_harmonic(struct hawser_harmonic *h, struct hawser_harmonic *rate, double r, int n)
{
	double slope = h->phase == HAWSER_COS ? -h->k : h->k;
	struct hawser_term *all = as_terms(h->Q, h->quads, NULL, 0, h->term, h->terms);
	int count = h->quads + h->terms, failed = !all;

	*rate = (struct hawser_harmonic){.k = h->k, .omega_power = h->omega_power + 1,
		.phase = h->phase == HAWSER_COS ? HAWSER_SIN : HAWSER_COS, .load_power = h->load_power,
		.f = copy(h->f, n), .K = copy(h->K, n*n), .term = all, .terms = count};
	free(h->Q);
	h->Q = NULL;
	h->quads = 0;
	free(h->term);
	h->term = as_terms(NULL, 0, NULL, 0, all, failed ? 0 : count);
	h->terms = count;
	failed = failed || !h->term || (h->f && !rate->f) || (h->K && !rate->K);
	for (int i = 0; !failed && i < count; i++) {
		h->term[i].value *= r;
	}
	failed = failed || differentiate(&h->term, &h->terms, all, count);
	for (int i = 0; !failed && i < count; i++)
		all[i].value *= slope;
	h->D = copy(h->K, n*n);
	failed = failed || (h->K && !h->D);
	times(h->f, r, n);
	times(h->K, r, n*n);
	times(rate->f, slope, n);
	times(rate->K, slope, n*n);
	if (h->k == 0) { /* constant: the derivative is 0, and its D belongs to the model */
		times(rate->f, 0.0, n);
		times(rate->K, 0.0, n*n);
	}
	return failed;
}

static enum hawser_status check_first(const struct hawser__parser *reader, const struct hawser_rom *rom)
{
	for (int i = 0; i < rom->n*rom->n; i++)
		if (rom->D[i] != 0.0)
			return hawser__wrong(reader, "D in a model of first_order, which has no accelerations: its "
			                     "equations are u' + K u + ... = f");
	for (int i = 0; i < rom->terms; i++)
		if (rom->term[i].rates > 0)
			return hawser__wrong(reader, "terms[%d] has velocities, in a model of first_order", i);
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];

		if (harmonic->D || harmonic->omega_power > 1)
			return hawser__wrong(reader, "harmonics[%d] has %s, in a model of first_order", h,
			                     harmonic->D ? "a D" : "omega_power 2");
		if (harmonic->k == 0 && (harmonic->K || harmonic->quads > 0 || harmonic->terms > 0))
			return hawser__wrong(reader, "harmonics[%d] of k 0 has more than an f, in a model of "
			                     "first_order: constant terms belong to the model", h);
		for (int i = 0; i < harmonic->terms; i++)
			if (harmonic->term[i].rates > 0)
				return hawser__wrong(reader, "harmonics[%d] has terms with velocities, in a model of "
				                     "first_order", h);
	}
	return rom->ramp ? hawser__wrong(reader, "a ramp in a model of first_order") : HAWSER_OK;
}

double hawser__relaxation(const double *K, int n)
{
	double largest = 0.0;

	for (int j = 0; j < n; j++) {
		double row = 0.0;

		for (int k = 0; k < n; k++)
			row += fabs(K[j*n + k]);
		largest = fmax(largest, row);
	}
	return largest > 0.0 ? largest : 1.0;
}

static enum hawser_status raise_order(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      double r)
{
	int n = rom->n, count = rom->quads + rom->cubics + rom->terms, given = rom->harmonics;
	struct hawser_term *all = as_terms(rom->Q, rom->quads, rom->C, rom->cubics, rom->term, rom->terms);
	struct hawser_harmonic *more = realloc(rom->harmonic, (2*(size_t)given + 1)*sizeof *more);
	int failed = !all || !more;

	if (more)
		rom->harmonic = more;
	failed = failed || differentiate(&rom->term, &rom->terms, all, count);
	for (int i = 0; !failed && i < rom->terms; i++)
		rom->term[i].value *= rom->term[i].rates == 0 ? r : 1.0;
	for (int h = 0; !failed && h < given; h++) {
		failed = raise_harmonic(&rom->harmonic[h], &more[given + h], r, n);
		rom->harmonics++;
	}
	free(all);
	if (failed)
		return hawser__no_memory(reader->report, "rom");
	for (int i = 0; i < rom->quads; i++)
		rom->Q[i].value *= r;
	for (int i = 0; i < rom->cubics; i++)
		rom->C[i].value *= r;
	for (int i = 0; i < n*n; i++) {
		rom->D[i] = rom->K[i] + (i%(n + 1) == 0 ? r : 0.0);
		rom->K[i] *= r;
	}
	for (int h = 0; h < given; h++) { /* with k = 0 the D of a harmonic would be a part of D */
		if (rom->harmonic[h].k == 0) {
			free(rom->harmonic[h].D);
			rom->harmonic[h].D = NULL;
		}
		if (rom->harmonic[given + h].k == 0)
			rom->harmonic[given + h].phase = HAWSER_COS;
	}
	return HAWSER_OK;
}

/* rom->first becomes the model as it stands, with x'' for x'. */
static enum hawser_status keep_first(const struct hawser__parser *reader, struct hawser_rom *rom,
                                     json_t *root)
{
	const struct hawser__parser again = {.name = reader->name, .report = reader->report,
		.parameter = reader->parameter, .parameters = reader->parameters, .plain = 1};

	if (!(rom->first = calloc(1, sizeof *rom->first)))
		return hawser__no_memory(reader->report, "rom");
	return hawser__read_model(&again, rom->first, root);
}

enum hawser_status hawser__read_own(const struct hawser__parser *reader, struct hawser_rom *rom,
                                    json_t *root)
{
	const json_t *terms = json_object_get(root, "terms"), *M = json_object_get(root, "M");
	const json_t *first = json_object_get(root, "first_order");
	const json_t *rate = json_object_get(root, "relaxation");
	enum hawser_status status = HAWSER_OK;
	double r;

	if (json_object_get(root, "periods"))
		status = hawser__read_integer(reader, &rom->periods, json_object_get(root, "periods"), 1, 100,
		                              "periods");
	if (!status && terms)
		status = hawser__read_terms(reader, &rom->term, &rom->terms, rom->n, terms, "terms");
	if (!status && M)
		status = read_mass(reader, rom, M);
	if (!status && first && !json_is_boolean(first))
		status = hawser__wrong(reader, "first_order: true or false is wanted");
	if (!status && rate && !json_is_true(first))
		status = hawser__wrong(reader, "relaxation is for models of first_order: true");
	if (status || !json_is_true(first) || reader->plain)
		return status;
	r = hawser__relaxation(rom->K, rom->n);
	if (rate)
		status = hawser__read_positive(reader, &r, root, "relaxation", "the model");
	if (!status)
		status = check_first(reader, rom);
	if (!status)
		status = keep_first(reader, rom, root);
	return status ? status : raise_order(reader, rom, r);
}

/* --- parameters --- */

enum hawser_status hawser__read_parameters(struct hawser__parser *reader,
                                           struct hawser_parameter *parameter, const json_t *root,
                                           const struct hawser_parameter *set, int sets)
{
	json_t *object = json_object_get(root, "parameters"), *value;
	enum hawser_status status = HAWSER_OK;
	const char *name;

	reader->parameter = parameter;
	reader->parameters = 0;
	if (object && !json_is_object(object))
		return hawser__wrong(reader, "parameters: an object of names and numbers is wanted");
	json_object_foreach(object, name, value) {
		struct hawser_parameter *now = &parameter[reader->parameters];
		char where[64];

		if (!hawser__formula_name(name))
			return hawser__wrong(reader, "parameters: \"%.40s\" can't be a name: write a letter, "
			                     "then up "
			                     "to %d letters, digits and _, and no name of a function", name,
			                     (int)sizeof now->name - 2);
		if (reader->parameters == HAWSER_PARAMETERS)
			return hawser__wrong(reader, "more than %d parameters", HAWSER_PARAMETERS);
		*now = (struct hawser_parameter){.value = 0.0};
		memcpy(now->name, name, strlen(name));
		snprintf(where, sizeof where, "parameters.%s", name);
		if ((status = hawser__read_number(reader, &now->value, value, where)))
			return status;
		for (int i = 0; i < sets; i++)
			if (set[i].set && !strcmp(set[i].name, name))
				now->value = set[i].value;
		reader->parameters++;
	}
	return status;
}
