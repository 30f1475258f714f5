/* study/map/map_rows_file.c - the rows of a map in its checkpoint.
 *
 * The file is that of the points of other maps (map_checkpoint.c): each record of a row has a kind in
 * its first mark. A row counts once its last record is there. Rows with a reason that the file does not
 * have are computed again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/map_rows.h"

enum kind { BEGIN, ANSWER, TURN, END };
enum { MARKS = 6 };

static enum hawser_status add(struct hawser__map_rows_file *file, double at, double fixed,
                              const struct hawser_map_sample *sample, const double marks[MARKS],
                              struct hawser_report *report)
{
	const struct hawser__map_record record = {.x = at + 0.0, .y = fixed + 0.0, .sample = *sample};

	return hawser__map_checkpoint_add(&file->checkpoint, &record, marks, report);
}

/* Whether everything about the row is in its records. */
static int complete(const struct hawser__map_row *row)
{
	for (int i = 0; i < row->count; i++)
		if (row->answer[i].sample.code != HAWSER_MAP_OK &&
		    row->answer[i].sample.code != HAWSER_MAP_SLACK)
			return 0;
	return row->ready && !row->incomplete;
}

enum hawser_status hawser__map_rows_file_add(struct hawser__map_rows_file *file,
                                             const struct hawser__map_row *row,
                                             struct hawser_report *report)
{
	const struct hawser_map_sample none = {.value = 0.0};
	const double begin[MARKS] = {BEGIN}, end[MARKS] = {END};
	enum hawser_status status;

	if (file->checkpoint.fd < 0 || !complete(row))
		return HAWSER_OK;
	status = add(file, row->at[0], row->fixed, &none, begin, report);
	for (int i = 0; i < row->count && !status; i++) {
		const struct hawser__map_answer *answer = &row->answer[i];
		const double marks[MARKS] = {ANSWER, answer->least, answer->most, answer->tension,
		                             answer->branches, answer->stable};

		status = add(file, row->at[i], row->fixed, &answer->sample, marks, report);
	}
	for (int i = 0; i < row->turns && !status; i++) {
		const struct hawser__map_turn *turn = &row->turn[i];
		const double marks[MARKS] = {TURN, turn->error, turn->kind, turn->side};

		status = add(file, turn->at, row->fixed, &none, marks, report);
	}
	return status ? status : add(file, row->at[0], row->fixed, &none, end, report);
}

/* --- reading --- */

static enum hawser_status take_turn(struct hawser__map_row *row,
                                    const struct hawser__map_record *record, const double *marks,
                                    struct hawser_report *report)
{
	if (hawser__more(&row->turn, row->turns, sizeof *row->turn))
		return hawser__no_memory(report, "map");
	row->turn[row->turns++] = (struct hawser__map_turn){
		record->x, marks[1], (enum hawser_event_kind)marks[2], (int)marks[3]};
	return HAWSER_OK;
}

static enum hawser_status take(void *context, const struct hawser__map_record *record,
                               const double *marks, struct hawser_report *report)
{
	struct hawser__map_rows_file *file = context;
	struct hawser__map_row *row = file->open;
	enum kind kind = (enum kind)marks[0];

	if (kind == BEGIN) {
		row = NULL;
		for (int j = 0; j < file->rows; j++)
			if (file->row[j].fixed == record->y)
				row = &file->row[j];
		if (row && !row->answer)
			row->answer = calloc((size_t)row->count, sizeof *row->answer);
		if (row && !row->answer)
			return hawser__no_memory(report, "map");
		if (row)
			row->turns = row->ready = 0;
		file->open = row;
		file->answers = 0;
		return HAWSER_OK;
	}
	if (!row)
		return HAWSER_OK;
	if (kind == TURN)
		return take_turn(row, record, marks, report);
	if (kind == ANSWER && file->answers < row->count && record->x == row->at[file->answers]) {
		row->answer[file->answers++] = (struct hawser__map_answer){record->sample, marks[1], marks[2],
			marks[3], (int)marks[4], (int)marks[5]};
	} else if (kind == END) {
		row->ready = file->answers == row->count;
		file->open = NULL;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__map_rows_file_open(struct hawser__map_rows_file *file, const char *path,
                                              const char *identity, const char *settings,
                                              struct hawser__map_row *row, int rows,
                                              struct hawser_report *report)
{
	struct hawser__map_taker taker = {take, file};
	enum hawser_status status;

	*file = (struct hawser__map_rows_file){.row = row, .rows = rows, .checkpoint = {.fd = -1}};
	status = hawser__map_checkpoint_open(&file->checkpoint, path, identity, settings, MARKS, &taker,
	                                     report);
	for (int j = 0; j < rows && !status; j++) {
		if (!row[j].ready) {
			free(row[j].answer);
			row[j].answer = NULL;
			row[j].turns = 0;
			continue;
		}
		for (int i = 0; i < row[j].count; i++)
			hawser__map_row_explain(&row[j], &row[j].answer[i], NULL);
	}
	return status;
}
