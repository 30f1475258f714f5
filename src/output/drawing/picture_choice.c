/* output/drawing/picture_choice.c - what the user has chosen of pictures: size, title, ranges of
 * the axes.
 *
 * Every picture is a script of gnuplot. Here it is read line by line and changed where the choice
 * asks for it, so that the functions that draw do not know of it. A panel begins with "set lmargin";
 * a range is set before each of its "plot", for the first panel and for those that have its axis: the
 * same range of x, the same title of y. Marks (arrows, labels) beyond the range are left out, since
 * gnuplot would draw them outside of the axes. A title needs room above: all places that are
 * fractions of the picture's height are made smaller.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "output/output.h"
#include "output/drawing/picture_choice.h"

#define TITLE_CM 0.9 /* height of the line of the title */
enum { X, Y, AXES, TEXT = 512, DROPPED = 64 };

static struct hawser__picture_choice chosen;

void hawser__picture_choose(const struct hawser__picture_choice *choice)
{
	chosen = *choice;
}

/* Part of the height that the picture itself has. */
static double below_title(double height)
{
	double all = chosen.height > 0.0 ? chosen.height : height + TITLE_CM;

	return chosen.title ? 1.0 - TITLE_CM/all : 1.0;
}

double hawser__picture_size(double size[2], double width, double height)
{
	double factor;

	size[0] = chosen.width > 0.0 ? chosen.width : width;
	size[1] = chosen.height > 0.0 ? chosen.height : height + (chosen.title ? TITLE_CM : 0.0);
	factor = fmin(size[0]/width, size[1]*below_title(height)/height);
	return factor < 1.0 ? factor : 1.0;
}

/* What the script has said so far. */
struct state {
	FILE *to;
	double part;               /* of the height: below_title */
	int panels, plots, legend; /* legend: 1: the panel has samples of lines alone */
	int logarithmic[AXES];
	char range[AXES][TEXT], first[AXES][TEXT];   /* "[0:250]"; that of the first panel */
	char title[TEXT], first_title[TEXT];         /* of the vertical axis */
	char format[AXES][TEXT];
	int changed[AXES];         /* 1: the range of this axis is not that of the script */
	unsigned long long dropped; /* numbers of arrows that were left out, bits: their labels go too */
};

static void keep(char to[TEXT], const char *text)
{
	snprintf(to, TEXT, "%.*s", (int)strcspn(text, "\n"), text);
}

/* 1 if the chosen range of an axis is for the panel. */
static int is_for(const struct state *s, int axis)
{
	if (!chosen.range[axis].given || s->legend)
		return 0;
	if (s->panels <= 1)
		return 1;
	return axis == X ? *s->range[X] && !strcmp(s->range[X], s->first[X])
	                 : !strcmp(s->title, s->first_title);
}

static void read_scale(struct state *s, const char *line)
{
	int on = line[0] == 's'; /* set, unset */
	const char *axes = strstr(line, "logscale") + strlen("logscale");

	for (int axis = X; axis < AXES; axis++)
		if (strchr(axes, "xy"[axis]) || (!on && !strpbrk(axes, "xy")))
			s->logarithmic[axis] = on;
}

static void read_line(struct state *s, const char *line)
{
	if (!strncmp(line, "set lmargin", 11)) {
		s->panels++;
		s->legend = 0;
	}
	if (!strncmp(line, "set key at screen", 17) && s->plots)
		s->legend = 1;
	if (!strncmp(line, "unset arrow", 11))
		s->dropped = 0;
	if (!strncmp(line, "set logscale", 12) || !strncmp(line, "unset logscale", 14))
		read_scale(s, line);
	for (int axis = X; axis < AXES; axis++) {
		char range[] = "set xrange ", format[] = "set format x ";

		range[4] = format[11] = "xy"[axis];
		if (!strncmp(line, range, strlen(range)))
			keep(s->range[axis], line + strlen(range));
		if (!strncmp(line, format, strlen(format)))
			keep(s->format[axis], line + strlen(format));
	}
	if (!strncmp(line, "set autoscale", 13))
		for (int axis = X; axis < AXES; axis++)
			if (strchr(line + 13, "xy"[axis]) || !strpbrk(line + 13, "xy"))
				keep(s->range[axis], "[*:*]");
	if (!strncmp(line, "set label 1000 ", 15))
		snprintf(s->title, TEXT, "%.*s", (int)(strstr(line, "at screen") - line), line);
}

/* 1 if a number is beyond the chosen range of its axis. */
static int beyond(const struct state *s, int axis, const char *text)
{
	char *end;
	double value = strtod(text, &end);

	return end != text && is_for(s, axis) &&
	       (value < chosen.range[axis].low || value > chosen.range[axis].high);
}

/* 1 if the line draws a mark at a place of the axes that is beyond a chosen range: "at 3.2,4",
 * "from first 3, graph 0". */
static int is_outside(struct state *s, const char *line)
{
	int outside, number;

	const char *at = !strncmp(line, "set arrow", 9) ? strstr(line, " from ")
	                 : !strncmp(line, "set label", 9) ? strstr(line, " at ") : NULL, *second;

	if (!at)
		return 0;
	if (sscanf(line, "set label %d", &number) == 1 && number > 0 &&
	    number < DROPPED && s->dropped >> number & 1)
		return !strncmp(at, " at graph", 9);
	at = strchr(at + 1, ' ') + 1;
	if (!strncmp(at, "first ", 6))
		at += 6;
	second = strchr(at, ',');
	outside = beyond(s, X, at) || (second && beyond(s, Y, second + 1));
	if (outside && sscanf(line, "set arrow %d", &number) == 1 && number > 0 && number < DROPPED)
		s->dropped |= 1ull << number;
	return outside;
}

/* Write a number of the range as gnuplot reads it. */
static void put_limit(FILE *to, double limit)
{
	if (isfinite(limit))
		fprintf(to, "%.12g", limit);
	else
		fputc('*', to);
}

static void put_range(struct state *s, int axis)
{
	const struct hawser__picture_range *range = &chosen.range[axis];
	char name = "xy"[axis];

	if (!is_for(s, axis)) {
		if (s->changed[axis])
			fprintf(s->to, "set %crange %s\n", name, *s->range[axis] ? s->range[axis] : "[*:*]");
		s->changed[axis] = 0;
		return;
	}
	s->changed[axis] = 1;
	fprintf(s->to, "set %crange [", name);
	put_limit(s->to, range->low);
	fputc(':', s->to);
	put_limit(s->to, range->high);
	fprintf(s->to, "]\nset %ctics autofreq\n", name);
	if (s->logarithmic[axis] && isfinite(range->low) && isfinite(range->high)) {
		struct hawser__picture picture = {.script = s->to};

		hawser__picture_log_tics(&picture, (const char[]){name, '\0'}, range->low, range->high, 30.0);
		if (!strcmp(s->format[axis], "''")) /* the panel below has the numbers */
			fprintf(s->to, "set format %c ''\n", name);
	}
}

static void put_title(const struct state *s)
{
	fputs("set label 1002 '", s->to);
	hawser__picture_literal(s->to, chosen.title, 0);
	fprintf(s->to, "' at screen 0.5, screen %.4f center font ',13'\n", 0.5*(1.0 + s->part));
}

enum hawser_status hawser__picture_logarithmic(char axis, struct hawser_report *report)
{
	const struct hawser__picture_range *range = &chosen.range[axis == 'y' ? Y : X];

	if (!range->given || (range->high > 0.0 && (range->low > 0.0 || isinf(range->low))))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "picture",
	                    "--%crange %s: the axis is logarithmic: give limits above 0", axis,
	                    range->text);
}

/* Before a plot. */
static enum hawser_status prepare(struct state *s, struct hawser_report *report)
{
	for (int axis = X; axis < AXES; axis++) {
		if (s->panels <= 1) {
			keep(s->first[axis], s->range[axis]);
			keep(s->first_title, s->title);
		}
		if (is_for(s, axis) && s->logarithmic[axis]) {
			enum hawser_status status = hawser__picture_logarithmic("xy"[axis], report);

			if (status)
				return status;
		}
		put_range(s, axis);
	}
	if (chosen.title && !s->plots)
		put_title(s);
	return HAWSER_OK;
}

/* A line with its places, in fractions of the height, made smaller: "screen X, screen Y", the margins,
 * and "key at screen X, Y". */
static void put_places(const struct state *s, const char *line)
{
	const char *margin = strstr(line, "set tmargin at screen ");

	if (!margin)
		margin = strstr(line, "set bmargin at screen ");
	while (*line) {
		const char *screen = strstr(line, "screen "), *number;
		int first = 1;
		char *end;

		if (!screen)
			break;
		number = screen + strlen("screen ");
		strtod(number, &end);
		if (margin && screen == strstr(margin, "screen ")) {
			first = 0;
		} else if (*end == ',') {
			const char *next = end + 1 + strspn(end + 1, " ");
			int key = screen - line >= 7 && !strncmp(screen - 7, "key at ", 7);

			if (!strncmp(next, "screen ", 7))
				next += 7;
			else if (!key)
				next = NULL;
			first = !next;
			number = next ? next : number;
		}
		if (first) { /* no height */
			fwrite(line, 1, (size_t)(number - line), s->to);
			line = number;
			continue;
		}
		fwrite(line, 1, (size_t)(number - line), s->to);
		fprintf(s->to, "%.5g", s->part*strtod(number, &end));
		line = end;
	}
	fputs(line, s->to);
}

/* One line of the script; `data`: of a block of data. */
static enum hawser_status put_line(struct state *s, const char *line, int data,
                                   struct hawser_report *report)
{
	int plot = !data && !strncmp(line, "plot ", 5);
	enum hawser_status status = HAWSER_OK;

	if (!data)
		read_line(s, line);
	if (!data && is_outside(s, line))
		return HAWSER_OK;
	if (plot)
		status = prepare(s, report);
	if (s->part < 1.0 && !data && !plot)
		put_places(s, line);
	else
		fputs(line, s->to);
	s->plots += plot;
	return status;
}

enum hawser_status hawser__picture_adjust(FILE **script, double height, struct hawser_report *report)
{
	struct state s = {.to = NULL, .part = below_title(height)};
	char *line = NULL;
	size_t size = 0;
	int data = 0, titled = !chosen.title;
	enum hawser_status status = HAWSER_OK;

	if (!chosen.title && !chosen.range[X].given && !chosen.range[Y].given)
		return HAWSER_OK;
	s.to = tmpfile();
	while (s.to && !status && getline(&line, &size, *script) >= 0) {
		int begins = line[0] == '$' && strstr(line, " << END");

		if (s.plots == 1 && !titled) {
			fputs("unset label 1002\n", s.to); /* it is drawn, once */
			titled = 1;
		}
		status = put_line(&s, line, data || begins, report);
		data = begins || (data && strcmp(line, "END\n") != 0);
	}
	free(line);
	if (!status && (!s.to || ferror(*script) || fflush(s.to) || ferror(s.to)))
		status = hawser__fail(report, HAWSER_ERR_IO, "picture",
		                      "cannot write a temporary file for gnuplot: %s", strerror(errno));
	if (status) {
		if (s.to)
			fclose(s.to);
		return status;
	}
	fclose(*script);
	rewind(s.to);
	*script = s.to;
	return HAWSER_OK;
}
