/* output/fields/fields_table.c - columns and rows of tables, and the list of fields. See fields.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "output/fields/fields.h"

/* Columns in the order of the table; returns their number. */
static int order(const struct hawser__field *column[HAWSER__COLUMNS],
                 const struct hawser__field *field, const struct hawser__view *view)
{
	int count = 0;

	for (; !hawser__is_end(field) && count < HAWSER__COLUMNS; field++) {
		int at = count;

		if (!field->column || !hawser__is_shown(field, view))
			continue;
		for (; at > 0 && column[at - 1]->place > field->place; at--)
			column[at] = column[at - 1];
		column[at] = field;
		count++;
	}
	return count;
}

static const char *suffix_of(const struct hawser__field *field, enum hawser__unit unit,
                             const struct hawser__scale *scale)
{
	return field->flags & HAWSER__BARE ? "" : hawser__unit_suffix(unit, scale);
}

/* The unit in which a column is shown; of a model without units there is none. */
static struct hawser__shown_unit shown_in(const struct hawser__field *field, enum hawser__unit unit,
                                          const struct hawser__view *view)
{
	if (unit == HAWSER__NONE)
		return hawser__shown_unit(field->si ? field->si(view->context) : "");
	return hawser__shown_unit(*hawser__unit_suffix(unit, &view->scale) ? hawser__unit_name(unit)
	                                                                   : "");
}

static void column_name(struct hawser__table *table, const char *before, const char *name,
                        const struct hawser__field *field, enum hawser__unit unit,
                        const struct hawser__view *view)
{
	struct hawser__shown_unit shown = shown_in(field, unit, view);
	char full[2*HAWSER__NAME_SIZE], end[HAWSER__UNIT_SIZE + 2];

	hawser__unit_end(end, sizeof end, shown.name);
	snprintf(full, sizeof full, "%s%s", before, name);
	if (shown.changed && unit == HAWSER__NONE)
		hawser__unit_cut(full, field->si(view->context));
	hawser__table_column(table, "%s%s", full,
	                     shown.changed ? end : suffix_of(field, unit, &view->scale));
	if (unit == HAWSER__NONE && field->si)
		hawser__unit_cut(full, field->si(view->context));
	hawser__table_about(table, full, field->axis ? field->axis : "", field->doc, shown.name);
}

static void column_names(struct hawser__table *table, const struct hawser__field *field,
                         const struct hawser__view *view)
{
	int count = field->vector ? field->vector->count(view->context) : 0;
	char name[HAWSER__NAME_SIZE];

	if (field->named)
		field->named(name, sizeof name, view->context);
	if (!field->vector)
		column_name(table, "", field->named ? name : field->column, field, field->unit, view);
	for (int k = 0; k < count; k++) {
		field->vector->name(name, sizeof name, view->context, k);
		column_name(table, field->column, name, field,
		            hawser__vector_unit(field, count, k, view), view);
	}
}

void hawser__fields_columns(struct hawser__table *table, const struct hawser__field *field,
                            const struct hawser__view *view)
{
	const struct hawser__field *column[HAWSER__COLUMNS];
	int count = order(column, field, view);

	for (int k = 0; k < count; k++)
		column_names(table, column[k], view);
}

static void blank(struct hawser__table *table, int count)
{
	for (int k = 0; k < count; k++)
		hawser__table_word(table, "");
}

static void cell(struct hawser__table *table, struct hawser__value value)
{
	switch (value.is) {
	case HAWSER__IS_UNKNOWN:
		hawser__table_word(table, "");
		break;
	case HAWSER__IS_WORD:
		hawser__table_word(table, value.word);
		break;
	case HAWSER__IS_NUMBER:
		hawser__table_number(table, value.number);
		break;
	default:
		hawser__table_number(table, (double)value.integer);
	}
}

/* A cell in the unit of its column. */
static void cell_in(struct hawser__table *table, struct hawser__value value,
                    const struct hawser__field *field, enum hawser__unit unit,
                    const struct hawser__view *view)
{
	if (value.is == HAWSER__IS_NUMBER)
		value.number /= shown_in(field, unit, view).per;
	cell(table, value);
}

static void vector_cells(struct hawser__table *table, const struct hawser__field *field,
                         const struct hawser__at *at, const struct hawser__view *view)
{
	int count = field->vector->count(view->context);
	const double *values = hawser__member(field, at, count);

	if (!values)
		blank(table, count);
	for (int k = 0; values && k < count; k++)
		cell_in(table, hawser__vector_at(field, at, values, count, k, view), field,
		        hawser__vector_unit(field, count, k, view), view);
}

/* The field with the column name of `wanted`, or NULL. */
static const struct hawser__field *find(const struct hawser__field *field,
                                        const struct hawser__field *wanted)
{
	for (; !hawser__is_end(field); field++)
		if (field->column && strcmp(field->column, wanted->column) == 0)
			return field;
	return NULL;
}

static void cells(struct hawser__table *table, const struct hawser__field *columns,
                  const struct hawser__field *field, const struct hawser__at *at,
                  const struct hawser__view *view)
{
	const struct hawser__field *column[HAWSER__COLUMNS];
	int count = order(column, columns, view);

	for (int k = 0; k < count; k++) {
		const struct hawser__field *own = column[k];

		if (columns != field && !(own = find(field, column[k])))
			blank(table, column[k]->vector ? column[k]->vector->count(view->context) : 1);
		else if (own->vector)
			vector_cells(table, own, at, view);
		else
			cell_in(table, hawser__value_of(own, at, view), own, own->unit, view);
	}
}

static void fill_row(struct hawser__table *table, const void *context, size_t index)
{
	const struct hawser__maker *maker = context;
	const struct hawser__field *field = maker->list->field;
	struct hawser__at at;
	union hawser__room room;

	if (hawser__make_row(&at, &room, maker->list, &maker->at, index))
		cells(table, field, field, &at, &maker->view);
}

void hawser__fields_table(struct hawser__table *table, const struct hawser__list *list,
                          const void *parent, const struct hawser__view *view)
{
	struct hawser__maker *maker = malloc(sizeof *maker);

	hawser__fields_columns(table, list->field, view);
	table->owned = maker;
	table->failed |= !maker;
	if (!maker)
		return;
	*maker = (struct hawser__maker){list, {parent, parent, 0, 0}, *view};
	hawser__table_rows(table, hawser__count_of(list, &maker->at), fill_row, maker);
}

void hawser__fields_rows(struct hawser__table *table, const struct hawser__field *columns,
                         const struct hawser__list *list, const void *parent,
                         const struct hawser__view *view)
{
	const struct hawser__at of = {parent, parent, 0, 0};
	size_t count = hawser__count_of(list, &of);

	for (size_t i = 0; i < count; i++) {
		struct hawser__at at;
		union hawser__room room;

		if (hawser__make_row(&at, &room, list, &of, i))
			cells(table, columns ? columns : list->field, list->field, &at, view);
	}
}

void hawser__fields_row(struct hawser__table *table, const struct hawser__field *columns,
                        const struct hawser__field *field, const void *row,
                        const struct hawser__view *view)
{
	const struct hawser__at at = {row, row, 0, 0};

	cells(table, columns ? columns : field, field, &at, view);
}

void hawser__fields_curves(struct hawser__table *table, const struct hawser__curve_lists *of,
                           const void *parent, const struct hawser__view *view)
{
	const struct hawser__field *columns = of->points->field;
	const struct hawser__at whole = {parent, parent, 0, 0};
	union hawser__room room[3];
	struct hawser__at curve, point, event;

	hawser__fields_columns(table, columns, view);
	for (size_t c = 0; c < hawser__count_of(of->curves, &whole); c++) {
		size_t e = 0;

		if (!hawser__make_row(&curve, &room[0], of->curves, &whole, c))
			continue;
		for (size_t i = 0; i < hawser__count_of(of->points, &curve); i++) {
			if (hawser__make_row(&point, &room[1], of->points, &curve, i))
				cells(table, columns, columns, &point, view);
			for (; e < hawser__count_of(of->events, &curve); e++) {
				if (!hawser__make_row(&event, &room[2], of->events, &curve, e))
					continue;
				if (*(const int *)((const char *)event.row + of->after) > (int)i)
					break;
				cells(table, columns, of->events->field, &event, view);
			}
		}
	}
}

void hawser__fields_comments(struct hawser__table *table, const struct hawser__field *field,
                             const void *row, const struct hawser__view *view)
{
	const struct hawser__at at = {row, row, 0, 0};

	for (; !hawser__is_end(field); field++) {
		const char *unit = hawser__unit_name(field->unit);

		if (hawser__is_shown(field, view) && field->kind == HAWSER__REAL)
			hawser__table_comment(table, "%s = %.12g%s%s", field->key,
			                      hawser__value_of(field, &at, view).number, *unit ? " " : "",
			                      unit);
	}
}

static int is_named(const char *name, const char *wanted)
{
	return name && strcmp(name, wanted) == 0;
}

/* The SI unit for an axis; "" if the model has no units, "1" for a pure number. */
static const char *unit_of(const struct hawser__field *field, const struct hawser__view *view)
{
	if (*hawser__unit_suffix(field->unit, &view->scale))
		return hawser__unit_name(field->unit);
	return field->unit == HAWSER__NONE || view->scale.pure ? "1" : "";
}

struct hawser__axis hawser__fields_axis(const struct hawser__field *field, const char *name,
                                        const struct hawser__view *view, double largest)
{
	while (!hawser__is_end(field) &&
	       !(field->axis && (is_named(field->column, name) || is_named(field->key, name)) &&
	         hawser__is_shown(field, view)))
		field++;
	if (hawser__is_end(field))
		return (struct hawser__axis){.per = 1.0};
	return hawser__axis_of(field->axis, unit_of(field, view), largest);
}

/* --- the list of fields --- */

static void print_line(FILE *stream, int indent, const char *name, const struct hawser__field *field)
{
	const char *unit = hawser__unit_name(field->unit);

	fprintf(stream, "%*s%-*s  %s%s%s%s\n", indent, "", 26 - indent, name, field->doc,
	        *unit ? " (" : "", unit, *unit ? ")" : "");
}

static void print_fields(FILE *stream, const struct hawser__field *field, int json, int indent)
{
	for (; !hawser__is_end(field); field++) {
		char name[96];

		if (json ? !field->key : !field->column)
			continue;
		if (json)
			snprintf(name, sizeof name, "%s", field->key);
		else
			snprintf(name, sizeof name, "%s%s%s", field->column,
			         field->vector ? field->vector->shown : "",
			         suffix_of(field, field->unit, &hawser__si));
		if (*name)
			print_line(stream, indent, name, field);
		if (!json || (field->flags & HAWSER__BRIEF))
			continue;
		if (field->list)
			print_fields(stream, field->list->field, json, indent + (*name ? 2 : 0));
		if (field->inner)
			print_fields(stream, field->inner, json, indent + (*name ? 2 : 0));
	}
}

void hawser__fields_print(FILE *stream, const char *what, const struct hawser__field *field,
                          int json)
{
	fprintf(stream, "\n%s\n", what);
	print_fields(stream, field, json, 2);
}
