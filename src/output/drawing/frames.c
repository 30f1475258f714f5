/* output/drawing/frames.c - see figure.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "output/drawing/figure.h"
#include "output/output.h"

static const char mark[] = "hawser-panel ";
/* px: lower panels hold a legend only. */
static const double lowest = 20.0;

void hawser__frames_ask(struct hawser__picture *picture)
{
	if (picture->scale != HAWSER__NO_SCALE)
		fprintf(picture->script,
		        "print '%s', GPVAL_TERM_XMIN, GPVAL_TERM_XMAX, GPVAL_TERM_YMIN, GPVAL_TERM_YMAX, "
		        "GPVAL_X_MIN, GPVAL_X_MAX, GPVAL_Y_MIN, GPVAL_Y_MAX, %d\n", mark, picture->scale);
	picture->scale = HAWSER__NO_SCALE;
}

int hawser__frames_answer(const char *line)
{
	return strncmp(line, mark, strlen(mark)) == 0;
}

void hawser__frames_write(FILE *to, FILE *messages, double height)
{
	const char *between = "";
	char line[400];

	rewind(messages);
	fputs("data-panels=\"", to);
	while (fgets(line, sizeof line, messages)) {
		double v[9];

		if (!hawser__frames_answer(line) ||
		    /* NOLINTNEXTLINE(cert-err34-c): what the script prints */
		    sscanf(line + sizeof mark - 1, "%lf %lf %lf %lf %lf %lf %lf %lf %lf", &v[0], &v[1],
		           &v[2], &v[3],
		           &v[4], &v[5], &v[6], &v[7], &v[8]) != 9 || !(v[3] - v[2] > lowest))
			continue;
		fprintf(to, "%s%.2f %.2f %.2f %.2f %.10g %.10g %.10g %.10g %.0f", between, v[0], v[1],
		        height - v[3], height - v[2], v[4], v[5], v[6], v[7], v[8]);
		between = ";";
	}
	fputs("\" ", to);
}
