/* statics/models.c - the table of static models, and their errors. A new model is a function of the
 * type in the table, and a row here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>

#include "statics/models.h"

/* The same catenary with an infinite EA. */
static enum hawser_status inextensible_solve(struct hawser_statics *st,
                                             const struct hawser_span *span,
                                             enum hawser_given given, double value,
                                             enum hawser_branch branch,
                                             struct hawser_report *report)
{
	enum hawser_status status = hawser__statics_check(span, given, value, branch, report);
	struct hawser_span stiff = *span;

	stiff.EA = INFINITY;
	return status ? status : hawser_statics_solve(st, &stiff, given, value, branch, report);
}

static const struct hawser_statics_model table[] = {
	{"catenary", "the elastic catenary", "doc/theory-statics.md; B (2.82)-(2.87)",
	 hawser_statics_solve, hawser_statics_at},
	{"inextensible", "the catenary without stretch", "B (2.90)", inextensible_solve,
	 hawser_statics_at},
	{"parabola", "weight per length of the span, no stretch", "B (2.91)-(2.94)",
	 hawser__parabola_solve, hawser__parabola_at},
};
enum { MODELS = sizeof table/sizeof *table };

const struct hawser_statics_model *hawser_statics_model(int index)
{
	return index >= 0 && index < MODELS ? &table[index] : NULL;
}

/* y of the elastic catenary at x. dx/dS = 1/sqrt(1 + slope^2) + epsilon > 0. */
static double height(const struct hawser_statics *st, double x)
{
	double lo = 0.0, hi = st->length0, S = hi*(x/st->span.d), error, next;
	struct hawser_profile_point point;

	for (int i = 0; i < 100; i++) {
		point = hawser_statics_at(st, S);
		error = point.x - x;
		if (error > 0.0)
			hi = S;
		else
			lo = S;
		next = S - error/(1.0/hypot(1.0, point.slope) + st->epsilon);
		if (!(next > lo && next < hi))
			next = 0.5*(lo + hi);
		if (fabs(next - S) <= 4.0*DBL_EPSILON*st->length0)
			break;
		S = next;
	}
	return point.y - error*point.slope; /* correct the remaining error of x along the tangent */
}

void hawser_statics_compare(struct hawser_statics_error *error,
                            const struct hawser_statics_model *model,
                            const struct hawser_statics *st, const struct hawser_statics *catenary)
{
	enum { points = 201 };

	error->H = st->H/catenary->H - 1.0;
	error->T0 = st->T0/catenary->T0 - 1.0;
	error->T1 = st->T1/catenary->T1 - 1.0;
	error->length0 = st->length0/catenary->length0 - 1.0;
	error->length = st->length/catenary->length - 1.0;
	error->sag = st->sag/catenary->sag - 1.0;
	error->position = 0.0;
	for (int i = 1; i < points - 1; i++) {
		struct hawser_profile_point point = model->at(st, st->length0*i/(points - 1));

		error->position = fmax(error->position, fabs(point.y - height(catenary, point.x)));
	}
}
