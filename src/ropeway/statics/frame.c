/* ropeway/statics/frame.c - catenaries joined at the towers, B 6.2.2: which batteries support the
 * rope and which press it down, and at what slope the rope passes them.
 *
 * The carriers of lane `up` are spread over the rope. Each catenary begins with the tension at
 * which the one before ends, as over sheaves without friction. Where the vertical force of the rope
 * jumps up (B 6.8), the battery is above the rope.
 *
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/statics.h>

#include "core/report.h"
#include "ropeway/statics/line.h"

static const double *place(const struct hawser_ropeway *rw, int i)
{
	return i < 0 ? rw->bottom : i < rw->towers ? rw->tower[i].at : rw->top;
}

const char *hawser__file_line(char text[HAWSER__FILE_LINE], int line)
{
	text[0] = '\0';
	if (line > 0)
		snprintf(text, HAWSER__FILE_LINE, ", line %d,", line);
	return text;
}

const char *hawser__tension_given(char text[HAWSER__TENSION_GIVEN], const struct hawser_ropeway *rw)
{
	static const char *const key[] = {"counterweight", "T0", "length0", "T_empty"};
	char line[HAWSER__FILE_LINE];

	snprintf(text, HAWSER__TENSION_GIVEN, " (bottom.tension.%s = %.9g %s%s sets the tension "
	         "at the bottom station)",
	         key[rw->tension], rw->value, rw->tension == HAWSER_ROPEWAY_LENGTH0 ? "m" : "N",
	         hawser__file_line(line, rw->tension_line));
	return text;
}

enum hawser_status hawser__in_file(struct hawser_report *report, enum hawser_status status,
                                   const char *name)
{
	enum { NAME = 100 }; /* characters of the name that are shown, from its end */
	char message[sizeof report->message];

	if (!report || (status != HAWSER_ERR_NO_SOLUTION && status != HAWSER_ERR_ARGUMENT &&
	                status != HAWSER_ERR_CONVERGENCE && status != HAWSER_ERR_NAN) || !name)
		return status;
	if (strlen(name) > NAME)
		name += strlen(name) - NAME;
	memcpy(message, report->message, sizeof message);
	snprintf(report->message, sizeof report->message, "%s: %.530s", name, message);
	return status;
}

static const char *name_of(const struct hawser_ropeway *rw, int tower)
{
	return tower < 0 ? "bottom" : tower < rw->towers ? rw->tower[tower].name : "top";
}

/* One catenary after the other, from the tension T0. V [2*(towers + 1)] gets the vertical forces at
 * both ends of each, H [towers + 1]; *length their unstretched lengths together. */
static enum hawser_status join(double *V, double *H, double *length, const struct hawser_ropeway *rw,
                               double rho, double T0, struct hawser_report *report)
{
	struct hawser_statics st;
	struct hawser_report inner;
	char given[HAWSER__TENSION_GIVEN];
	enum hawser_status status;

	*length = 0.0;
	for (int i = 0; i <= rw->towers; i++) {
		const double *a = place(rw, i - 1), *b = place(rw, i);
		struct hawser_span span = {.EA = rw->EA, .rho = rho, .g = rw->g, .d = b[0] - a[0],
		                           .h = b[1] - a[1]};

		status = hawser_statics_solve(&st, &span, HAWSER_GIVEN_T0, T0, HAWSER_BRANCH_TAUT, &inner);
		if (status)
			return hawser__fail(report, status, "ropeway", "the rope with the carriers spread over it, "
			                    "%s to %s: %.420s%s", name_of(rw, i - 1), name_of(rw, i), inner.message,
			                    hawser__tension_given(given, rw));
		V[2*i] = st.V0;
		V[2*i + 1] = st.V1;
		H[i] = st.H;
		*length += st.length0;
		T0 = st.T1;
	}
	return HAWSER_OK;
}

/* The tension at which the empty rope has the given length, if it is straight: for the sides of
 * batteries the sag matters little. */
static double tension_of(const struct hawser_ropeway *rw)
{
	double chord = 0.0, loop;

	if (rw->tension == HAWSER_ROPEWAY_COUNTERWEIGHT)
		return 0.5*rw->value;
	if (rw->tension != HAWSER_ROPEWAY_LENGTH0)
		return rw->value;
	for (int i = 0; i <= rw->towers; i++)
		chord += hypot(place(rw, i)[0] - place(rw, i - 1)[0], place(rw, i)[1] - place(rw, i - 1)[1]);
	loop = 2.0*chord + 3.14159265358979323846*(rw->bottom_radius + rw->top_radius);
	return rw->EA*(loop/rw->value - 1.0);
}

/* Sides and slopes from the vertical forces. */
static void take(struct hawser__frame *frame, const double *V, const double *H)
{
	const struct hawser_ropeway *rw = frame->ropeway;

	for (int i = 0; i < rw->towers; i++) {
		enum hawser_ropeway_battery battery = rw->tower[i].battery;

		frame->side[i] = battery == HAWSER_ROPEWAY_AUTO ? (V[2*i + 2] > V[2*i + 1] ? -1 : 1)
		                 : battery == HAWSER_ROPEWAY_SUPPORT ? 1 : -1;
		frame->slope[i] = 0.5*(atan2(V[2*i + 1], H[i]) + atan2(V[2*i + 2], H[i + 1]));
	}
}

/* Without a tension at which all catenaries exist: the slopes of the chords. */
static void take_chords(struct hawser__frame *frame)
{
	const struct hawser_ropeway *rw = frame->ropeway;

	for (int i = 0; i < rw->towers; i++) {
		const double *a = place(rw, i - 1), *b = place(rw, i), *c = place(rw, i + 1);
		double before = atan2(b[1] - a[1], b[0] - a[0]), behind = atan2(c[1] - b[1], c[0] - b[0]);

		frame->side[i] = rw->tower[i].battery == HAWSER_ROPEWAY_COMPRESSION ? -1 : 1;
		frame->slope[i] = 0.5*(before + behind);
	}
}

enum hawser_status hawser__frame_open(struct hawser__frame *frame, const struct hawser_ropeway *rw,
                                      struct hawser_report *report)
{
	double *V = malloc(3*((size_t)rw->towers + 1)*sizeof *V), *H = V ? V + 2*(rw->towers + 1) : NULL;
	double T0 = tension_of(rw), rho = rw->rho, length;
	int chosen = 0;
	enum hawser_status status = V ? HAWSER_OK : hawser__no_memory(report, "ropeway");

	memset(frame, 0, sizeof *frame);
	frame->ropeway = rw;
	frame->tension = T0;
	frame->side = calloc((size_t)rw->towers + 1, sizeof *frame->side);
	frame->slope = calloc((size_t)rw->towers + 1, sizeof *frame->slope);
	if (!status && (!frame->side || !frame->slope))
		status = hawser__no_memory(report, "ropeway");
	if (rw->spacing > 0.0)
		rho += rw->mass[HAWSER_ROPEWAY_UP]/rw->spacing;
	for (int i = 0; i < rw->towers; i++) {
		chosen += rw->tower[i].battery == HAWSER_ROPEWAY_AUTO;
		frame->trains |= rw->tower[i].sheaves > 0;
		frame->sheaves += rw->tower[i].sheaves ? rw->tower[i].sheaves : 1;
	}
	for (int i = 0; i <= rw->towers; i++)
		frame->reach += 2.0*hypot(place(rw, i)[0] - place(rw, i - 1)[0],
		                          place(rw, i)[1] - place(rw, i - 1)[1]);
	if (!status && !(T0 > 0.0))
		status = hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "ropeway", "the loop is too long: with "
		                      "tension.length0 = %.9g m it is slack even if it is straight between the "
		                      "towers; shorten it, or give T_empty instead", rw->value);
	if (!status) {
		status = join(V, H, &length, rw, rho, T0, report);
		if (!status)
			take(frame, V, H);
		else if (status == HAWSER_ERR_NO_SOLUTION && !chosen) {
			take_chords(frame);
			status = HAWSER_OK; /* the line itself says why, if it has none either */
		}
	}
	free(V);
	if (status)
		hawser__frame_clear(frame);
	return status;
}

void hawser__frame_clear(struct hawser__frame *frame)
{
	free(frame->side);
	free(frame->slope);
	memset(frame, 0, sizeof *frame);
}
