/* output/fields/fields.c - values of fields: units, and reading a member of a row. See fields.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "output/fields/fields.h"

static const struct {
	const char *suffix, *name;
} unit_text[HAWSER__UNITS] = {
	[HAWSER__NONE] = {"", ""},
	[HAWSER__M] = {"_m", "m"},
	[HAWSER__S] = {"_s", "s"},
	[HAWSER__RAD_S] = {"_rad_s", "rad/s"},
	[HAWSER__PER_S] = {"_1_s", "1/s"},
	[HAWSER__M_S] = {"_m_s", "m/s"},
	[HAWSER__M_S2] = {"_m_s2", "m/s^2"},
	[HAWSER__J] = {"_J", "J"},
	[HAWSER__PER_M] = {"_1_m", "1/m"},
	[HAWSER__HZ] = {"_Hz", "Hz"},
	[HAWSER__M_ALREADY] = {"_m", "m"},
	[HAWSER__RAD_S_M2] = {"_rad_s_m2", "rad/s/m^2"},
	[HAWSER__NEWTON] = {"_N", "N"},
	[HAWSER__METRE] = {"_m", "m"},
	[HAWSER__METRE_S] = {"_m_s", "m/s"},
	[HAWSER__RADIAN_S] = {"_rad_s", "rad/s"},
	[HAWSER__HERTZ] = {"_Hz", "Hz"},
	[HAWSER__RADIAN] = {"_rad", "rad"},
	[HAWSER__SECOND] = {"_s", "s"},
	[HAWSER__BYTE] = {"_bytes", "bytes"},
	[HAWSER__NEWTON_M] = {"_N_m", "N/m"},
	[HAWSER__METRE_S2] = {"_m_s2", "m/s^2"},
	[HAWSER__METRE_S3] = {"_m_s3", "m/s^3"},
	[HAWSER__METRE_S4] = {"_m_s4", "m/s^4"},
	[HAWSER__NEWTON_METRE] = {"_Nm", "N.m"},
	[HAWSER__NEWTON_SECOND] = {"_Ns", "N.s"},
	[HAWSER__NEWTON_METRE_SECOND] = {"_Nms", "N.m.s"},
	[HAWSER__MOMENT_PER_METRE] = {"_Nm_per_m", "N.m/m"},
	[HAWSER__KILOGRAM] = {"_kg", "kg"},
	[HAWSER__KILOGRAM_M] = {"_kg_m", "kg/m"},
};

const struct hawser__scale hawser__si = {
	.factor = {[HAWSER__NONE] = 1.0, [HAWSER__M] = 1.0, [HAWSER__S] = 1.0, [HAWSER__RAD_S] = 1.0,
	           [HAWSER__PER_S] = 1.0, [HAWSER__M_S] = 1.0, [HAWSER__J] = 1.0},
	.si = 1,
};

struct hawser__scale hawser__scale_of(double length, double omega, double energy, int si)
{
	return (struct hawser__scale){
		.factor = {[HAWSER__NONE] = 1.0, [HAWSER__M] = length, [HAWSER__S] = 1.0/omega,
		           [HAWSER__RAD_S] = omega, [HAWSER__PER_S] = omega,
		           [HAWSER__M_S] = length*omega, [HAWSER__J] = energy},
		.si = si};
}

double hawser__in_unit(double value, enum hawser__unit unit, const struct hawser__scale *scale)
{
	const double *factor = scale->factor;

	switch (unit) {
	case HAWSER__M_S2:
		return value*factor[HAWSER__M]*factor[HAWSER__RAD_S]*factor[HAWSER__RAD_S];
	case HAWSER__HERTZ:
		return value/(2.0*M_PI);
	case HAWSER__PER_M:
		return value/factor[HAWSER__M];
	case HAWSER__RAD_S_M2:
		return value*factor[HAWSER__RAD_S]/(factor[HAWSER__M]*factor[HAWSER__M]);
	default:
		return unit < HAWSER__BASE ? value*factor[unit] : value;
	}
}

const char *hawser__unit_suffix(enum hawser__unit unit, const struct hawser__scale *scale)
{
	/* cppcheck-suppress arrayIndexOutOfBoundsCond ; the array has HAWSER__UNITS elements */
	return unit >= HAWSER__FIXED || scale->si ? unit_text[unit].suffix : "";
}

const char *hawser__unit_name(enum hawser__unit unit)
{
	return unit_text[unit].name;
}

enum hawser__unit hawser__unit_of_column(const char *column)
{
	size_t length = strlen(column), longest = 0;
	enum hawser__unit found = HAWSER__NONE;

	for (int unit = 0; unit < HAWSER__UNITS; unit++) {
		size_t size = strlen(unit_text[unit].suffix);

		if (size > longest && size < length &&
		    strcmp(column + length - size, unit_text[unit].suffix) == 0) {
			found = (enum hawser__unit)unit;
			longest = size;
		}
	}
	return found;
}

const void *hawser__member(const struct hawser__field *field, const struct hawser__at *at,
                           int count)
{
	const char *place = field->from == HAWSER__IN_ROW ? at->row : at->parent;
	size_t stride = (size_t)(field->stride ? field->stride : field->vector ? count : 1);
	size_t index = at->index;
	int along = field->from >= HAWSER__ALONG_ROWS;
	const void *array = NULL;

	if (field->number || field->word || (field->vector && field->vector->number))
		return at->row;
	place += field->offset;
	if (!along && field->kind != HAWSER__VECTOR)
		return place;
	memcpy(&array, place, sizeof array);
	if (!along || !array)
		return array;
	if (at->inner > 0 && field->from == HAWSER__ALONG_OUTER)
		index /= at->inner;
	else if (at->inner > 0 && field->from == HAWSER__ALONG_INNER)
		index %= at->inner;
	return (const char *)array + field->within +
	       (index*stride + (size_t)field->item)*(field->step ? field->step : field->size);
}

/* Read an integer of any size, as enumerations and flags have. */
static long integer_at(const struct hawser__field *field, const void *member)
{
	long wide;
	int usual;

	switch (field->size) {
	case sizeof(signed char):
		return *(const signed char *)member;
	case sizeof wide:
		memcpy(&wide, member, sizeof wide);
		return wide;
	default:
		memcpy(&usual, member, sizeof usual);
		return usual;
	}
}

static struct hawser__value number_value(double number, unsigned flags)
{
	struct hawser__value value = {.is = HAWSER__IS_NUMBER, .number = number};

	if (isinf(number) && (flags & HAWSER__MISSING))
		value = (struct hawser__value){.is = HAWSER__IS_WORD, .word = "missing"};
	else if ((isnan(number) && (flags & (HAWSER__NULL | HAWSER__OMIT))) ||
	         (isinf(number) && (flags & HAWSER__INFINITE)))
		value.is = HAWSER__IS_UNKNOWN;
	return value;
}

struct hawser__value hawser__integer_value(long integer, unsigned flags)
{
	if (integer == HAWSER__NO_INTEGER || (integer < 0 && (flags & HAWSER__FROM_1)))
		return (struct hawser__value){.is = HAWSER__IS_UNKNOWN};
	return (struct hawser__value){.is = HAWSER__IS_INTEGER,
	                              .integer = integer + ((flags & HAWSER__FROM_1) != 0)};
}

static struct hawser__value flag_value(long flag)
{
	return (struct hawser__value){
		.is = flag == HAWSER__NO_INTEGER ? HAWSER__IS_UNKNOWN : HAWSER__IS_FLAG, .integer = flag != 0};
}

static struct hawser__value word_value(const char *word, unsigned flags)
{
	int unknown = !word || (!*word && (flags & HAWSER__OMIT));

	return (struct hawser__value){.is = unknown ? HAWSER__IS_UNKNOWN : HAWSER__IS_WORD,
	                              .word = word};
}

struct hawser__value hawser__value_of(const struct hawser__field *field,
                                      const struct hawser__at *at, const struct hawser__view *view)
{
	const void *member = field->kind == HAWSER__CONSTANT || field->kind == HAWSER__INDEX
	                     ? NULL : hawser__member(field, at, 0);
	const char *word;
	double number;

	switch (field->kind) {
	case HAWSER__CONSTANT:
		return field->label ? word_value(field->label(field->item), 0)
		                    : hawser__integer_value(field->item, 0);
	case HAWSER__INDEX:
		return hawser__integer_value((long)(at->inner ? at->index % at->inner : at->index) + 1, 0);
	case HAWSER__REAL:
		if (field->number)
			number = field->number(at->row);
		else
			memcpy(&number, member, sizeof number);
		return number_value(hawser__in_unit(number, field->unit, &view->scale), field->flags);
	case HAWSER__INT:
		if (field->number)
			return hawser__integer_value((long)field->number(at->row), field->flags);
		return hawser__integer_value(integer_at(field, member), field->flags);
	case HAWSER__FLAG:
		return flag_value(field->number ? field->number(at->row) != 0.0 : integer_at(field, member));
	case HAWSER__NOT:
		return flag_value(integer_at(field, member) == 0);
	case HAWSER__LABEL:
		return word_value(field->label((int)integer_at(field, member)), field->flags);
	case HAWSER__CHARS:
		return word_value(member, field->flags);
	default:
		if (field->word)
			word = field->word(at->row);
		else
			memcpy(&word, member, sizeof word);
		return word_value(word, field->flags);
	}
}

enum hawser__unit hawser__vector_unit(const struct hawser__field *field, int count, int k,
                                      const struct hawser__view *view)
{
	enum hawser__unit rate = field->vector->rate;

	if (field->vector->unit)
		return field->vector->unit(view->context, k);
	return rate != HAWSER__NONE && k >= count/2 ? rate : field->unit;
}

struct hawser__value hawser__vector_at(const struct hawser__field *field,
                                       const struct hawser__at *at, const double *values, int count,
                                       int k, const struct hawser__view *view)
{
	const struct hawser__vector *vector = field->vector;
	double number = vector->number ? vector->number(view->context, at->parent, at->index, k)
	                               : values[k];

	return number_value(hawser__in_unit(number, hawser__vector_unit(field, count, k, view),
	                                    &view->scale),
	                    field->flags);
}

int hawser__is_shown(const struct hawser__field *field, const struct hawser__view *view)
{
	if (field->named) {
		char name[HAWSER__NAME_SIZE];

		field->named(name, sizeof name, view->context);
		if (!*name)
			return 0;
	}
	return field->when == 0 || (field->when & view->options) != 0;
}

int hawser__is_end(const struct hawser__field *field)
{
	return !field->key && !field->column && !field->doc;
}

static size_t integer_of(const void *parent, size_t at)
{
	int count;

	memcpy(&count, (const char *)parent + at, sizeof count);
	return (size_t)count;
}

size_t hawser__count_of(const struct hawser__list *list, const struct hawser__at *of)
{
	if (list->count)
		return list->count(of->row);
	if (list->part)
		return integer_of(of->parent, list->inner_at);
	if (list->column)
		return integer_of(of->parent, list->count_at);
	return integer_of(of->row, list->count_at)*(list->matrix ? integer_of(of->row, list->inner_at)
	                                                         : 1);
}

int hawser__make_row(struct hawser__at *at, union hawser__room *room,
                     const struct hawser__list *list, const struct hawser__at *of, size_t index)
{
	const char *stored = room->bytes;

	*at = (struct hawser__at){room, of->row, index, 0};
	if (list->part) {
		at->parent = of->parent;
		at->inner = integer_of(of->parent, list->inner_at);
		at->index += of->index*at->inner;
	} else if (list->column) {
		at->parent = of->parent;
		at->inner = integer_of(of->parent, list->inner_at);
		at->index = index*at->inner + of->index;
	} else if (list->matrix) {
		at->inner = integer_of(of->row, list->inner_at);
	}
	if (list->row) {
		memset(room->bytes, 0, list->size);
		at->row = list->row(room->bytes, at->parent, at->index);
		return at->row != NULL;
	}
	if (list->within)
		stored = (const char *)of->row + list->rows_at;
	else if (list->size > 0)
		memcpy(&stored, (const char *)of->row + list->rows_at, sizeof stored);
	at->row = stored + index*list->size;
	return 1;
}
