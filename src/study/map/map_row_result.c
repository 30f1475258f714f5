/* study/map/map_row_result.c - the answers of a row, and why some have no value.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/map/map_rows.h"

void hawser__map_note(char **text, const char *message)
{
	free(*text);
	*text = message ? strdup(message) : NULL;
}

void hawser__map_row_clear(struct hawser__map_row *row)
{
	free(row->answer);
	free(row->turn);
	for (int k = 0; k < HAWSER_MAP_CODES; k++)
		free(row->why[k]);
	free(row->broken);
	free(row->state);
	free(row->kept_at);
	*row = (struct hawser__map_row){.at = NULL};
}

void hawser__map_row_explain(struct hawser__map_row *row, const struct hawser__map_answer *answer,
                             const char *message)
{
	enum hawser_map_code code = answer->sample.code;
	char text[160];

	if (code == HAWSER_MAP_OK || row->why[code])
		return;
	if (code == HAWSER_MAP_SLACK) {
		snprintf(text, sizeof text, "the least tension in the response is %.4g N: a cable cannot "
		         "carry that", answer->tension);
		message = text;
	} else if (code == HAWSER_MAP_NO_STATE) {
		message = "no periodic response with the period of the load is stable";
	}
	hawser__map_note(&row->why[code], message ? message : "no curve of responses passes this value");
}

void hawser__map_row_fill(struct hawser__map_row *row, int from, int to, enum hawser_map_code code,
                          const char *message)
{
	for (int i = from; i < to; i++)
		row->answer[i] = (struct hawser__map_answer){.sample = {.code = code}, .tension = NAN};
	if (to > from && !row->why[code])
		hawser__map_note(&row->why[code], message);
}
