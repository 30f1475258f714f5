/* rom/file/formula.c - sums, products and powers of numbers and named parameters:
 *
 *    sum      product { + product | - product }
 *    product  sign { * sign | / sign }
 *    sign     - sign | power
 *    power    primary [ ^ sign ]
 *    primary  number | name | name ( sum ) | ( sum )
 *
 * Names are parameters, pi, and the functions below.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/locale.h"
#include "rom/file/read.h"

#define DEEPEST 50 /* brackets and signs */

struct formula {
	const char *text, *at;
	const struct hawser_parameter *parameter;
	int count, depth, failed;
	char *wrong;
	size_t size;
};

static const struct { const char *name; double (*value)(double x); } functions[] = {
	{"sqrt", sqrt}, {"sin", sin}, {"cos", cos}, {"tan", tan}, {"exp", exp}, {"log", log}, {"abs", fabs},
};
enum { FUNCTIONS = sizeof functions/sizeof *functions };

static double fail(struct formula *formula, const char *why, const char *what, int length)
{
	if (!formula->failed)
		snprintf(formula->wrong, formula->size, why, length, what);
	formula->failed = 1;
	return NAN;
}

static int next(struct formula *formula)
{
	while (isspace((unsigned char)*formula->at))
		formula->at++;
	return *formula->at;
}

static int accept(struct formula *formula, int c)
{
	int found = next(formula) == c;

	formula->at += found;
	return found;
}

static double sum(struct formula *formula);

static double bracket(struct formula *formula)
{
	double value = sum(formula);

	return accept(formula, ')') ? value : fail(formula, "a bracket is open%.*s", "", 0);
}

static size_t name_length(const char *name)
{
	size_t length = 0;

	if (isalpha((unsigned char)*name))
		while (isalnum((unsigned char)name[length]) || name[length] == '_')
			length++;
	return length;
}

static double named(struct formula *formula)
{
	const char *name = formula->at;
	size_t length = name_length(name);

	formula->at += length;
	for (int i = 0; i < formula->count; i++)
		if (strlen(formula->parameter[i].name) == length &&
		    !strncmp(formula->parameter[i].name, name, length))
			return formula->parameter[i].value;
	if (length == 2 && !strncmp(name, "pi", 2))
		return M_PI;
	for (int i = 0; i < FUNCTIONS; i++)
		if (strlen(functions[i].name) == length && !strncmp(functions[i].name, name, length))
			return accept(formula, '(') ? functions[i].value(bracket(formula))
			       : fail(formula, "%.*s needs its argument in brackets", name, (int)length);
	return fail(formula, "%.*s is no parameter of the file", name, (int)length);
}

static double primary(struct formula *formula)
{
	int c = next(formula);
	char *end;
	double value;

	if (accept(formula, '('))
		return bracket(formula);
	if (isalpha(c))
		return named(formula);
	if (!isdigit(c) && c != '.')
		return c ? fail(formula, "\"%.*s\" is unexpected", formula->at, 1)
		         : fail(formula, "a number or name is missing at the end%.*s", "", 0);
	value = strtod(formula->at, &end);
	formula->at = end > formula->at ? end : formula->at + 1;
	return value;
}

static double sign(struct formula *formula)
{
	double value;

	if (++formula->depth > DEEPEST)
		return fail(formula, "it is nested too deeply%.*s", "", 0);
	if (accept(formula, '-')) {
		value = -sign(formula);
	} else {
		value = primary(formula);
		if (accept(formula, '^'))
			value = pow(value, sign(formula));
	}
	formula->depth--;
	return value;
}

static double product(struct formula *formula)
{
	double value = sign(formula);

	for (;;) {
		if (accept(formula, '*'))
			value *= sign(formula);
		else if (accept(formula, '/'))
			value /= sign(formula);
		else
			return value;
	}
}

static double sum(struct formula *formula)
{
	double value = product(formula);

	for (;;) {
		if (accept(formula, '+'))
			value += product(formula);
		else if (accept(formula, '-'))
			value -= product(formula);
		else
			return value;
	}
}

int hawser__formula(double *value, const char *text, const struct hawser_parameter *parameter,
                    int count, char *wrong, size_t size)
{
	struct formula formula = {.text = text, .at = text, .parameter = parameter, .count = count,
		.wrong = wrong, .size = size};
	struct hawser__locale locale;

	hawser__locale_begin(&locale);
	*value = sum(&formula);
	hawser__locale_end(&locale);
	if (!formula.failed && next(&formula))
		fail(&formula, "\"%.*s\" is unexpected", formula.at, 1);
	if (!formula.failed && !isfinite(*value))
		fail(&formula, "its value is not finite%.*s", "", 0);
	return formula.failed;
}

int hawser__formula_name(const char *name)
{
	size_t length = strlen(name);

	if (length == 0 || length >= sizeof ((struct hawser_parameter *)0)->name ||
	    name_length(name) != length || !strcmp(name, "pi") || !strcmp(name, "Omega"))
		return 0;
	for (int i = 0; i < FUNCTIONS; i++)
		if (!strcmp(name, functions[i].name))
			return 0;
	return 1;
}
