/* response/family/numbers.c - all numbers of a model that depend on a parameter.
 *
 * Entries that are zero in some of the models have a value in all, but for those that are round-off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/law.h>

#include "response/family/numbers.h"
#include "rom/energy/kernel.h"

static void take_part(struct hawser__number_parts *parts, void *at, size_t count, size_t stride)
{
	if (at && count > 0 && parts->count < HAWSER__PARTS)
		parts->part[parts->count++] = (struct hawser__number_part){at, count, stride};
}

static void plain(struct hawser__number_parts *parts, double *at, size_t count)
{
	take_part(parts, at, count, sizeof *at);
}

void hawser__number_parts(struct hawser__number_parts *parts, struct hawser_rom *rom)
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

double *hawser__number(const struct hawser__number_part *part, size_t i)
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
 * largest of its order is left out, since it would break a symmetry of the model. Returns how many
 * there are. */
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
		if (*value_of(list, all, e) > HAWSER__ROUND_OFF*most[order_of(list, all + e*list->size)])
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

int hawser__same_entries(struct hawser_rom *const rom[], int roms)
{
	struct list list;

	for (int i = 0; list_of(&list, rom[0], i); i++)
		if (!unify(rom, roms, i))
			return 0;
	return 1;
}

void hawser__copy_entries(struct hawser_rom *to, struct hawser_rom *from)
{
	struct list list, whole;

	for (int i = 0; list_of(&list, to, i); i++) {
		(void)list_of(&whole, from, i);
		if (*whole.count > 0)
			memcpy(*list.array, *whole.array, (size_t)*whole.count*whole.size);
		*list.count = *whole.count;
	}
}

int hawser__has_entries(struct hawser_rom *rom, struct hawser_rom *from)
{
	struct list list, whole;
	int i = 0;

	while (list_of(&list, rom, i) && list_of(&whole, from, i) && *list.count == *whole.count)
		i++;
	return !list_of(&list, rom, i);
}
