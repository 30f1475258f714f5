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
 * Entries that are zero in some models have a value in all, but for those that are round-off.
 *
 * Reference: Berrut and Trefethen, SIAM Review 46 (2004) 501.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <cblas.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/law.h>

#include "core/report.h"
#include "response/family/smooth.h"
#include "rom/energy/kernel.h"

enum { PATIENCE = 24, /* models that are made before: fewer than interpolation takes */
	FIRST = 8, MOST = 128, KEPT = 8, TAIL = 3, PARTS = 400 };
#define ROUND_OFF 2e-11  /* of the modes (EXACT in study/map/family.c), relative */
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
	double p[KEPT];
	long used[KEPT], calls;
};

/* --- the numbers of a model --- */

/* `count` numbers, `stride` bytes apart. */
struct part {
	char *at;
	size_t count, stride;
};

struct parts {
	int count;
	struct part part[PARTS];
};

static void take_part(struct parts *parts, void *at, size_t count, size_t stride)
{
	if (at && count > 0 && parts->count < PARTS)
		parts->part[parts->count++] = (struct part){at, count, stride};
}

static void plain(struct parts *parts, double *at, size_t count)
{
	take_part(parts, at, count, sizeof *at);
}

static void list_parts(struct parts *parts, struct hawser_rom *rom)
{
	size_t n = (size_t)rom->n, pairs = n*(n + 1)/2;
	size_t points = (size_t)rom->shapes.points, line = (size_t)rom->line.points;

	parts->count = 0;
	plain(parts, rom->K, n*n);
	plain(parts, rom->D, n*n);
	plain(parts, rom->mass, n*n);
	plain(parts, rom->carried, n*n);
	take_part(parts, rom->Q ? &rom->Q->value : NULL, (size_t)rom->quads, sizeof *rom->Q);
	take_part(parts, rom->C ? &rom->C->value : NULL, (size_t)rom->cubics, sizeof *rom->C);
	take_part(parts, rom->term ? &rom->term->value : NULL, (size_t)rom->terms, sizeof *rom->term);
	for (int h = 0; h < rom->harmonics; h++) {
		struct hawser_harmonic *one = &rom->harmonic[h];

		plain(parts, one->f, n);
		plain(parts, one->D, n*n);
		plain(parts, one->K, n*n);
		take_part(parts, one->Q ? &one->Q->value : NULL, (size_t)one->quads, sizeof *one->Q);
		take_part(parts, one->term ? &one->term->value : NULL, (size_t)one->terms,
		          sizeof *one->term);
		plain(parts, one->answer, HAWSER__ANSWER(rom));
		plain(parts, one->answer_line, HAWSER__ANSWER_LINE(rom));
	}
	plain(parts, &rom->length, 1);
	plain(parts, &rom->time, 1);
	plain(parts, &rom->force, 1);
	plain(parts, rom->shapes.s, points);
	plain(parts, rom->shapes.tangent, 2*points);
	plain(parts, rom->shapes.stretch, points);
	plain(parts, rom->shapes.shape, 3*n*points);
	plain(parts, rom->shapes.slope, 3*n*points);
	plain(parts, rom->shapes.second_shape, 3*pairs*points);
	plain(parts, rom->shapes.second_slope, 3*pairs*points);
	plain(parts, &rom->shapes.mach2, 1);
	plain(parts, &rom->shapes.EA, 1);
	plain(parts, rom->shapes.axes[0], 9);
	plain(parts, rom->line.s, line);
	plain(parts, rom->line.stretch, line);
	plain(parts, rom->line.slope, 3*n*line);
	plain(parts, rom->line.second_slope, 3*pairs*line);
	plain(parts, rom->contacts.turn, n*(size_t)rom->contacts.count);
	take_part(parts, rom->range ? &rom->range->largest : NULL, n, sizeof *rom->range);
}

/* A model that has something else that depends on the parameter. */
static int has_more(const struct hawser_rom *rom)
{
	return rom->ramp || rom->history || rom->ends || rom->known.modes > 0 || rom->drag || rom->plug ||
	       rom->first || rom->exact;
}

static int same_parts(const struct parts *a, const struct parts *b)
{
	int i = 0;

	while (i < a->count && i < b->count && a->part[i].count == b->part[i].count)
		i++;
	return a->count == b->count && i == a->count && i < PARTS;
}

static double *number(const struct part *part, size_t i)
{
	return (double *)(void *)(part->at + i*part->stride);
}

/* --- lists with the same entries --- */

/* Entries begin with `key` integers. */
struct list {
	void **array;
	int *count, key;
	size_t size, value; /* bytes, of an entry and before its value */
};

enum { OWN = 3, EACH = 2 };

/* List i of a model: its Q, C and terms, then those of harmonics; 0: there are no more. */
static int list_of(struct list *list, struct hawser_rom *rom, int i)
{
	struct hawser_harmonic *h = i < OWN ? NULL : &rom->harmonic[(i - OWN)/EACH];
	int is_term = h ? (i - OWN)%EACH : i == 2;

	if (i >= OWN + EACH*rom->harmonics)
		return 0;
	if (is_term)
		*list = (struct list){h ? (void **)&h->term : (void **)&rom->term, h ? &h->terms : &rom->terms,
			3 + HAWSER_TERM_FACTORS, sizeof(struct hawser_term), offsetof(struct hawser_term, value)};
	else if (i == 1)
		*list = (struct list){(void **)&rom->C, &rom->cubics, 4, sizeof(struct hawser_cubic),
			offsetof(struct hawser_cubic, value)};
	else
		*list = (struct list){h ? (void **)&h->Q : (void **)&rom->Q, h ? &h->quads : &rom->quads, 3,
			sizeof(struct hawser_quad), offsetof(struct hawser_quad, value)};
	return 1;
}

static int order(const void *a, const void *b, int key)
{
	const int *left = a, *right = b;
	int i = 0;

	while (i < key && left[i] == right[i])
		i++;
	return i == key ? 0 : left[i] < right[i] ? -1 : 1;
}

static int by_three(const void *a, const void *b)
{
	return order(a, b, 3);
}

static int by_four(const void *a, const void *b)
{
	return order(a, b, 4);
}

static int by_term(const void *a, const void *b)
{
	return order(a, b, 3 + HAWSER_TERM_FACTORS);
}

static double *value_of(const struct list *list, void *array, size_t e)
{
	return (double *)(void *)((char *)array + e*list->size + list->value);
}

/* The order of an entry of terms, whose values differ by powers of the unit of length; 0 of others. */
static int order_of(const struct list *list, const char *entry)
{
	return list->key > 4 ? ((const int *)(const void *)entry)[1] : 0;
}

/* Of `count` sorted entries, one of each kind, with its largest value; what is round-off against the
 * largest of its order is left out, since it would break a symmetry of the model. Returns how many there
 * are. */
static size_t keep_kinds(const struct list *list, char *all, size_t count,
                         int (*compare)(const void *, const void *))
{
	double most[HAWSER_TERM_FACTORS + 1] = {0.0};
	size_t kinds = 0, kept = 0;

	for (size_t e = 0; e < count; e++) {
		char *entry = all + e*list->size;
		double size = fabs(*value_of(list, all, e));
		int order;

		if (kinds > 0 && !compare(entry, all + (kinds - 1)*list->size))
			size = fmax(size, *value_of(list, all, kinds - 1));
		else
			memmove(all + kinds++*list->size, entry, list->size);
		*value_of(list, all, kinds - 1) = size;
		order = order_of(list, all + (kinds - 1)*list->size);
		most[order] = fmax(size, most[order]);
	}
	for (size_t e = 0; e < kinds; e++)
		if (*value_of(list, all, e) > ROUND_OFF*most[order_of(list, all + e*list->size)])
			memmove(all + kept++*list->size, all + e*list->size, list->size);
	return kept;
}

/* The list gets these entries, with zeros for those that it has not; 0: memory is short. */
static int give_kinds(const struct list *list, const char *kinds, size_t count,
                      int (*compare)(const void *, const void *))
{
	char *own = malloc((count + 1)*list->size);

	if (!own)
		return 0;
	memcpy(own, kinds, count*list->size);
	for (size_t e = 0; e < count; e++)
		*value_of(list, own, e) = 0.0;
	for (size_t e = 0; e < (size_t)*list->count; e++) {
		char *to = bsearch((char *)*list->array + e*list->size, own, count, list->size, compare);

		if (to)
			*value_of(list, to, 0) += *value_of(list, *list->array, e);
	}
	free(*list->array);
	*list->array = own;
	*list->count = (int)count;
	return 1;
}

/* Give list i of each model the entries that it has in any; 0: memory is short. */
static int unify(struct hawser_rom *const rom[], int roms, int i)
{
	struct list list = {0};
	size_t count = 0;
	int (*compare)(const void *, const void *), good = 1;
	char *all = NULL;

	for (int r = 0; r < roms; r++) {
		char *more;

		(void)list_of(&list, rom[r], i);
		more = realloc(all, (count + (size_t)*list.count + 1)*list.size);
		if (!more) {
			free(all);
			return 0;
		}
		all = more;
		if (*list.count > 0)
			memcpy(all + count*list.size, *list.array, (size_t)*list.count*list.size);
		count += (size_t)*list.count;
	}
	compare = list.key == 3 ? by_three : list.key == 4 ? by_four : by_term;
	qsort(all, count, list.size, compare);
	count = keep_kinds(&list, all, count, compare);
	for (int r = 0; good && r < roms; r++) {
		(void)list_of(&list, rom[r], i);
		good = give_kinds(&list, all, count, compare);
	}
	free(all);
	return good;
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
static double last_coefficients(struct hawser__smooth_models *of, const struct parts *parts)
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
	struct parts first, parts;
	struct list list;

	*error = INFINITY;
	for (int i = 0; i < nodes; i++)
		if (has_more(rom[i]) || rom[i]->harmonics != rom[0]->harmonics)
			return HAWSER_OK;
	for (int i = 0; list_of(&list, rom[0], i); i++)
		if (!unify(rom, nodes, i))
			return hawser__no_memory(report, "frf");
	list_parts(&first, rom[0]);
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

		list_parts(&parts, rom[i]);
		if (!same_parts(&first, &parts))
			return HAWSER_OK;
		for (int q = 0; q < parts.count; q++)
			for (size_t e = 0; e < parts.part[q].count; e++)
				*to++ = *number(&parts.part[q], e);
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
	struct parts parts;
	struct list list, whole;

	for (int i = 0; list_of(&list, rom, i); i++) {
		(void)list_of(&whole, &of->pattern, i);
		memcpy(*list.array, *whole.array, (size_t)*whole.count*whole.size);
		*list.count = *whole.count;
	}
	weigh(weight, of->degree, 2.0*(p - of->from)/(of->to - of->from) - 1.0);
	combine(of, weight);
	list_parts(&parts, rom);
	for (int q = 0; q < parts.count; q++)
		for (size_t e = 0; e < parts.part[q].count; e++)
			*number(&parts.part[q], e) = *from++;
	return hawser_rom_compile(rom, report);
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

	for (int degree = FIRST; !status && error > ROUND_OFF && error < FASTER*before && degree <= MOST;
	     degree *= 2) {
		enum hawser_status end = make_nodes(rom, made, degree, maker);

		before = error;
		error = INFINITY;
		if (end == HAWSER_ERR_MEMORY)
			status = hawser__no_memory(report, "frf");
		of->degree = degree;
		if (!end)
			status = gather(of, &error, rom, report);
	}
	if (!status && error <= ROUND_OFF) {
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
	if (smooth->asked <= PATIENCE && ++smooth->asked > PATIENCE)
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
