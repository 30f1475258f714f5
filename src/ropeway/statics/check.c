/* ropeway/statics/check.c - is a line one that can be solved?
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include "core/report.h"
#include "ropeway/statics/line.h"

static const char where[] = "line";

const char *hawser__line_name(char text[HAWSER__LINE_CALLED], const struct hawser_line *line,
                              int sheave)
{
	if (sheave < 0 || sheave >= line->sheaves)
		snprintf(text, HAWSER__LINE_CALLED, "end %s", sheave < 0 ? "A" : "B");
	else if (line->sheave[sheave].name[0] && line->sheave[sheave].file_line > 0)
		snprintf(text, HAWSER__LINE_CALLED, "sheave %d (%.*s, line %d)", sheave + 1,
		         HAWSER_LINE_NAME - 1, line->sheave[sheave].name, line->sheave[sheave].file_line);
	else if (line->sheave[sheave].name[0])
		snprintf(text, HAWSER__LINE_CALLED, "sheave %d (%.*s)", sheave + 1, HAWSER_LINE_NAME - 1,
		         line->sheave[sheave].name);
	else
		snprintf(text, HAWSER__LINE_CALLED, "sheave %d", sheave + 1);
	return text;
}

static enum hawser_status bad(struct hawser_report *report, const char *what, double value,
                              const char *rule)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "%s is %g: it has to be %s", what, value,
	                    rule);
}

static enum hawser_status check_rope(const struct hawser_line *line, struct hawser_report *report)
{
	static const char *const given[] = {"the tension at end A, N,", "the tension at end B, N,",
	                                    "the unstretched length, m,"};
	double thrust = line->rho*line->speed*line->speed;

	if (!(line->EA > 0.0))
		return bad(report, "EA, N,", line->EA, "positive (infinite: no stretch)");
	if (!(line->rho >= 0.0 && isfinite(line->rho)))
		return bad(report, "rho, kg/m,", line->rho, "finite and not negative");
	if (!(line->g >= 0.0 && isfinite(line->g)))
		return bad(report, "g, m/s^2,", line->g, "finite and not negative");
	if (!isfinite(line->speed))
		return bad(report, "the speed of the rope, m/s,", line->speed, "finite");
	if (!(thrust < line->EA))
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "at %g m/s rho*speed^2 = %g N is not below EA = %g N: no rope can run so "
		                    "fast",
		                    line->speed, thrust, line->EA);
	for (int k = 0; k < 2; k++)
		if (!isfinite(line->A[k]) || !isfinite(line->B[k]))
			return bad(report, "a coordinate of the ends, m,",
			           isfinite(line->A[k]) ? line->B[k] : line->A[k],
			           "finite");
	if (!(line->B[0] > line->A[0]))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "end B at x = %g m has to be to the right of end A at x = %g m", line->B[0],
		                    line->A[0]);
	if ((int)line->given < HAWSER_LINE_T_A || line->given > HAWSER_LINE_LENGTH0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d does not name what is given of a line: T_A, T_B or length0",
		                    (int)line->given);
	if (!(line->value > 0.0 && isfinite(line->value)))
		return bad(report, given[line->given], line->value, "positive and finite");
	if ((int)line->sliding < HAWSER_LINE_NONE || line->sliding > HAWSER_LINE_HELD)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%d does not name a sliding of the rope: none, toward A, toward B or held",
		                    (int)line->sliding);
	return HAWSER_OK;
}

static enum hawser_status check_sheave(const struct hawser_line *line, int i,
                                       struct hawser_report *report)
{
	const struct hawser_line_sheave *s = &line->sheave[i];
	char name[HAWSER__LINE_CALLED];
	const char *what = !isfinite(s->centre[0]) || !isfinite(s->centre[1]) ? "centre is not finite"
		: !(s->radius >= 0.0 && isfinite(s->radius)) ? "radius has to be finite and not negative"
		: s->side != 1 && s->side != -1 ? "side has to be 1 (rope above) or -1 (rope below)"
		: !(s->friction >= 0.0 && s->friction <= 10.0) ? "friction coefficient has to be from 0 to 10"
		: line->sliding == HAWSER_LINE_HELD && !(fabs(s->grip) <= s->friction)
			? "grip has to be from -friction to friction"
		: !(s->inertia >= 0.0 && isfinite(s->inertia)) ? "inertia has to be finite and not negative"
		: NULL;
	const double *ends[2] = {line->A, line->B};

	hawser__line_name(name, line, i);
	if (what)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%s (centre %g, %g m, radius %g m, friction %g, inertia %g kg m^2): its "
		                    "%s", name,
		                    s->centre[0], s->centre[1], s->radius, s->friction, s->inertia, what);
	if (!(s->centre[0] > (i ? line->sheave[i - 1].centre[0] : line->A[0]) && s->centre[0] < line->B[0]))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%s is at x = %g m: centres of sheaves have to be between the ends, each "
		                    "to the "
		                    "right of the one before", name, s->centre[0]);
	for (int k = 0; k < 2; k++)
		if (hypot(ends[k][0] - s->centre[0], ends[k][1] - s->centre[1]) <= s->radius)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "end %s at (%g, %g) m is inside %s, whose centre is at (%g, %g) m and "
			                    "radius is "
			                    "%g m", k ? "B" : "A", ends[k][0], ends[k][1], name, s->centre[0],
			                    s->centre[1], s->radius);
	for (int j = 0; j < i; j++) {
		const struct hawser_line_sheave *o = &line->sheave[j];
		double gap = hypot(o->centre[0] - s->centre[0], o->centre[1] - s->centre[1]);
		char other[HAWSER__LINE_CALLED];

		if (!(gap < o->radius + s->radius))
			continue;
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                    "%s and %s overlap by %g m", hawser__line_name(other, line, j), name,
		                    o->radius + s->radius - gap);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__line_check(const struct hawser_line *line, struct hawser_report *report)
{
	enum hawser_status status = check_rope(line, report);

	if (!status && (line->sheaves < 0 || line->masses < 0 || (line->sheaves && !line->sheave) ||
	                (line->masses && !line->mass)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "%d sheaves and %d masses are none",
		                    line->sheaves, line->masses);
	for (int i = 0; !status && i < line->sheaves; i++)
		status = check_sheave(line, i, report);
	for (int i = 0; !status && i < line->masses; i++) {
		const struct hawser_line_mass *m = &line->mass[i];

		if (!(m->body >= 0.0 && isfinite(m->body)))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where, "mass %d has a body of %g kg: give "
			                    "one that is finite and not negative", i + 1, m->body);
		if (!(m->mass >= 0.0 && isfinite(m->mass)) || !(m->hanger >= 0.0 && isfinite(m->hanger)))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "mass %d is %g kg on a hanger of %g m: both have to be finite and not "
			                    "negative",
			                    i + 1, m->mass, m->hanger);
		if (!(m->S >= (i ? line->mass[i - 1].S : 0.0)) || !isfinite(m->S) ||
		    (line->given == HAWSER_LINE_LENGTH0 && m->S > line->value))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "mass %d is at S = %g m: masses have to be on the rope, by ascending "
			                    "S", i + 1,
			                    m->S);
	}
	return status;
}
