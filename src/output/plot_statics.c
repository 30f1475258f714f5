/* output/plot_statics.c - the span: profile and chord above, tension along the cable below.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "output/output.h"
#include "output/style.h"

#define MARK "pt 7 ps 0.7 lc rgb 'black'"

/* The profile with both sides of each mass, at which the tension jumps, and the attachments. */
static void data(FILE *script, const struct hawser_statics *statics,
                 const struct hawser_profile_point *profile, int points, double unit)
{
	int i, next = 0;

	fputs("$profile << END\n", script);
	for (i = 0; i < points; i++) {
		for (; next < statics->attachments && statics->attached[next].S <= profile[i].S; next++) {
			struct hawser_profile_point at = hawser_statics_at(statics, statics->attached[next].S);
			double before = at.slope - statics->delta*statics->attached[next].m;

			fprintf(script, "%.9g %.9g %.12g\n%.9g %.9g %.12g\n", at.x, at.y,
			        statics->H*hypot(1.0, before)/unit, at.x, at.y, at.T/unit);
		}
		fprintf(script, "%.9g %.9g %.12g\n", profile[i].x, profile[i].y, profile[i].T/unit);
	}
	fputs("END\n$attached << END\n", script);
	for (i = 0; i < statics->attachments; i++) {
		struct hawser_profile_point at = hawser_statics_at(statics, statics->attached[i].S);

		fprintf(script, "%.9g %.9g\n", at.x, at.y);
	}
	fprintf(script, "END\n$chord << END\n0 0\n%.9g %.9g\nEND\n", statics->span.d,
	        statics->span.h);
}

enum hawser_status hawser__plot_statics(const char *path, const struct hawser_statics *statics,
                                        const struct hawser_profile_point *profile, int points,
                                        const struct hawser__axis *axis,
                                        struct hawser_report *report)
{
	struct hawser__legend entries = {0};
	struct hawser__picture picture;
	enum hawser_status status = hawser__picture_begin(&picture, path, 16.0, 12.4, report);
	FILE *script = picture.script;

	if (status)
		return status;
	data(script, statics, profile, points, axis[2].per);
	fprintf(script, "set xrange [0:%.9g]\nset format x ''\n", statics->span.d);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.62, 0.97);
	hawser__picture_ylabel(&picture, "%s", axis[1].title);
	fprintf(script, "plot $chord using 1:2 with lines lt 7 lw 0.8 dt (8,6), "
	        "$profile using 1:2 with lines lt 1%s\n"
	        "set format x '%%g'\nset xlabel '%s'\n",
	        statics->attachments ? ", $attached using 1:2 with points " MARK : "", axis[0].title);
	hawser__picture_panel(&picture, 0.13, 0.97, 0.21, 0.56);
	hawser__picture_ylabel(&picture, "%s", axis[2].title);
	fputs("plot $profile using 1:3 with lines lt 2\n", script);
	hawser__legend_add(&entries, "chord", "with lines lt 7 lw 0.8 dt (8,6)");
	hawser__legend_add(&entries, "cable", "with lines lt 1");
	if (statics->attachments)
		hawser__legend_add(&entries, "attachments", "with points " MARK);
	hawser__legend_draw(&picture, &entries);
	return hawser__picture_finish(&picture, report);
}
