/* cli/sweep/sweep.h - hawser sweep: one command over variations of a scene, its results in one table.
 *
 *    key         a key of the scene that is varied
 *    axis        keys that vary together: one (--over), or the columns of a list (--list)
 *    variation   a combination of values of all axes; numbered from 0, the last axis changes first
 *    packed      the result of a variation as text, see sweep_pack.c
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_SWEEP_H
#define HAWSER_CLI_SWEEP_H

#include "cli/frame/progress.h"
#include "cli/frame/within.h"
#include "output/fields/units.h"

enum { CLI_SWEEP_OVERS = 16, CLI_SWEEP_KEYS = 32,
       CLI_SWEEP_MOST = 10000000, /* variations: some hundred bytes of memory each */
       CLI_SWEEP_SET = 320 };     /* size of KEY=VALUE */

/* --- sweep_plan.c: which variations --- */

struct cli_sweep_key {
	char key[128], unit[HAWSER__UNIT_SIZE]; /* unit: as the user wrote it, or "" */
	char column[192];
	int numbers;   /* 1: all values are numbers with that unit */
	char **text;   /* [values of its axis] as --set takes them; NULL for a range */
	double *number; /* [values of its axis] if numbers */
};
struct cli_sweep_axis {
	int first, keys; /* of the plan's keys */
	long values;
};
struct cli_sweep_plan {
	struct cli_sweep_key key[CLI_SWEEP_KEYS]; /* [keys] */
	struct cli_sweep_axis axis[CLI_SWEEP_OVERS + 1]; /* [axes] */
	int keys, axes;
	long count; /* variations */
};
/* over [overs]: values of --over; list: of --list, or NULL. Clear in any case. */
enum hawser_status cli_sweep_plan_open(struct cli_sweep_plan *plan, const struct cli_common *common,
                                       const char *const *over, int overs, const char *list,
                                       struct hawser_report *report)
	HAWSER_MUST_CHECK;
void cli_sweep_plan_clear(struct cli_sweep_plan *plan);
/* --- sweep_check.c: keys and values against the scene --- */

/* Read the scene, with these keys set. */
enum hawser_status cli_sweep_reads(const struct cli_common *own, char (*set)[CLI_SWEEP_SET], int sets,
                                   struct hawser_report *report);
/* The place of a key's value in a variation. */
long cli_sweep_at(const struct cli_sweep_plan *plan, int key, long variation);
/* "KEY=VALUE" of a key, as --set takes it. */
void cli_sweep_set(char set[CLI_SWEEP_SET], const struct cli_sweep_plan *plan, int key,
                   long variation);
/* "tension.T0 = 60 kN, span.h = 10". */
void cli_sweep_name(char *text, size_t size, const struct cli_sweep_plan *plan, long variation);

/* --- sweep_pack.c: what is kept of the result of a variation --- */

enum cli_sweep_pick { CLI_SWEEP_ALL, CLI_SWEEP_LAST, CLI_SWEEP_MAX, CLI_SWEEP_MIN };
enum { CLI_SWEEP_KEEPS = 64 };
struct cli_sweep_choice {
	const char *rows; /* "values", "table", or a list of the result, such as "peaks" */
	const char *keep[CLI_SWEEP_KEEPS]; /* [keeps] columns; none: all */
	int keeps;
	enum cli_sweep_pick pick;
	const char *by;   /* column of CLI_SWEEP_MAX and _MIN */
	const struct cli_command *command;
};

/* A packed result; text [size] is followed by a NUL; owned. */
struct cli_sweep_packed {
	char *text;
	size_t size;
};
/* Run the command line argv [argc] and pack its result, or why there is none. HAWSER_ERR_MEMORY. */
enum hawser_status cli_sweep_pack(struct cli_sweep_packed *packed,
                                  const struct cli_sweep_choice *choice,
                                  int argc, char **argv, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* The same for a process that has ended without a result. */
enum hawser_status cli_sweep_pack_failure(struct cli_sweep_packed *packed,
                                          enum hawser_status status,
                                          const char *message, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* The status in a packed result. */
enum hawser_status cli_sweep_status(const char *packed);
/* The message of a variation without result, or NULL; its length in *length. */
const char *cli_sweep_why(const struct cli_sweep_packed *packed, int *length);

/* --- sweep_take.c: columns and rows of a result --- */

/* A column: its name, and the same without unit. */
struct cli_sweep_column {
	char *name, *bare;
};
/* Texts of cells: a number, "'word", "t" and "f" for true and false; NULL or "": none. */
struct cli_sweep_row {
	char **cell; /* [cells] of the first columns */
	int cells;
};
struct cli_sweep_rows {
	struct cli_sweep_column *column; /* [columns] */
	struct cli_sweep_row *row;       /* [rows] */
	int columns;
	long rows;
	int failed;    /* 1: an allocation failed */
	char *missing; /* a message: what was asked for and is not there; or NULL */
};
void cli_sweep_take(struct cli_sweep_rows *rows, const struct cli_taken *result,
                    const struct cli_sweep_choice *choice);
/* --- sweep_choose.c --- */

/* Keep what the user has chosen of the rows and columns. */
void cli_sweep_choose(struct cli_sweep_rows *rows, const struct cli_sweep_choice *choice);
/* The first message about what is missing. */
void cli_sweep_miss(struct cli_sweep_rows *rows, const char *format, ...) HAWSER_PRINTF(2, 3);
void cli_sweep_rows_clear(struct cli_sweep_rows *rows);

/* --- sweep_run.c: all variations, by several processes --- */

struct cli_study {
	const struct cli_common *common;
	struct cli_sweep_plan plan;
	struct cli_sweep_choice choice;
	char **word;     /* [words] of each command line: command, scene, options */
	int words;
	char *line;      /* the command as the user wrote it, for comments */
	int processes;
	struct hawser__ranks *ranks; /* of mpirun; or NULL */
	int part, parts; /* --part; parts 0: all variations */
	long done;       /* variations of it that have been computed */
	const char *checkpoint; /* or NULL */
	struct cli_sweep_packed *packed; /* [plan.count] results; text NULL: not yet */
};
/* The result of one variation. */
enum hawser_status cli_sweep_compute(struct cli_sweep_packed *packed, const struct cli_study *sweep,
                                     long variation, struct hawser_report *report) HAWSER_MUST_CHECK;
/* Compute those that are not yet there. Fails if the first one that has a result lacks a column
 * that is asked for. */
enum hawser_status cli_sweep_run(struct cli_study *sweep, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Refuse options of the sweep among the words, from `words` on, of its command. */
enum hawser_status cli_sweep_place(const struct cli_study *sweep, int words,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* HAWSER_ERR_SCENE where no variation can be read: a key or a unit is wrong. */
enum hawser_status cli_sweep_check(const struct cli_study *sweep, const struct cli_common *common,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- sweep_ranks.c: ranks, which compute the same in the same order up to cli_sweep_run --- */

/* `threads`: of --threads; 0: not given. */
enum hawser_status cli_sweep_ranks_open(struct cli_study *sweep, int threads,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
int cli_sweep_is_worker(const struct cli_study *sweep);
/* In a worker in place of cli_sweep_run. */
enum hawser_status cli_sweep_serve(struct cli_study *sweep,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* Returns `status`, the one that the command ends with, whose report it may complete. */
enum hawser_status cli_sweep_ranks_close(struct cli_study *sweep, enum hawser_status status,
                                         struct hawser_report *report);

/* --- sweep_file.c: the checkpoint --- */

/* A text that is the same for the same version, command line, files, variations and columns. */
enum { CLI_SWEEP_IDENTITY = 160 };
enum hawser_status cli_sweep_identity(char identity[CLI_SWEEP_IDENTITY],
                                      const struct cli_study *sweep,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Join the checkpoints of parts, from [count], in the new file `to`; *results: their number. */
enum hawser_status cli_sweep_merge(long *results, const char *to, const char *const *from, int count,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* 1 if the file begins as the checkpoint of a sweep does. */
int cli_sweep_file_is(const char *path);

struct cli_sweep_file {
	int fd; /* -1: none */
	const char *path;
};
/* Open or create it, and read the results of this sweep that it has. */
enum hawser_status cli_sweep_file_open(struct cli_sweep_file *file, struct cli_study *sweep,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_sweep_file_add(struct cli_sweep_file *file, long variation,
                                      const struct cli_sweep_packed *packed,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_sweep_file_close(struct cli_sweep_file *file);

/* --- sweep_result.c: the table and JSON --- */

/* A row of the table. */
struct cli_sweep_line {
	long variation;
	const char *cell; /* its cells, NUL behind each; NULL: none */
	const struct cli_sweep_head *head;
};
/* The columns of some variations, and the place of each in the table. */
struct cli_sweep_head {
	char *text; /* as packed */
	int *place; /* [columns] */
	int columns;
	struct cli_sweep_head *next;
};
struct cli_sweep_result {
	const struct cli_study *sweep;
	char **column; /* [columns] of results */
	int columns;
	struct cli_sweep_line *line; /* [lines] */
	long lines, failed, warned;
	struct cli_sweep_head *head;
	int *status;           /* [plan.count] exit statuses */
	const char **message;  /* [plan.count] of failures, or NULL */
	const char **warning;  /* [plan.count] the first, or NULL */
};
/* Takes the packed results apart, in place. */
enum hawser_status cli_sweep_result_open(struct cli_sweep_result *result, struct cli_study *sweep,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_sweep_result_clear(struct cli_sweep_result *result);
/* The number in a cell of column `column` of the results; NAN: none. */
double cli_sweep_number(const struct cli_sweep_line *line, int column);
extern const struct cli_showing cli_sweep_showing;

/* --- sweep_draw.c, sweep_map.c --- */

/* Check, before the computation, that the variations can be drawn. */
enum hawser_status cli_sweep_draw_check(const struct cli_sweep_plan *plan,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* Axes of a column and of a key, in gnuplot's markup. */
struct hawser__axis cli_sweep_column_axis(const char *column, double largest);
struct hawser__axis cli_sweep_key_axis(const struct cli_sweep_key *key, double largest);
/* 1 if two keys vary, each over numbers at equal distances. */
int cli_sweep_is_map(const struct cli_sweep_plan *plan);
/* A column over these keys, of the first row of each variation. */
enum hawser_status cli_sweep_map(const char *path, const struct cli_sweep_result *result, int column,
                                 double largest, struct hawser_report *report) HAWSER_MUST_CHECK;

enum hawser_status cli_sweep_draw(const char *path, const void *result,
                                  struct hawser_report *report);

/* --- sweep_run.c: the variations of a sweep while they are computed --- */

enum { CLI_SWEEP_PROCESSES = 1024 }; /* two pipes each, of the files that a process may open */

struct cli_sweep_run {
	struct cli_study *sweep;
	struct cli_sweep_file file;
	long count;       /* variations, of the part if it is one */
	long done, fresh; /* fresh: not from the checkpoint */
	long next;        /* the first that is neither done nor handed out */
	long first;       /* all before this are done, and have no result */
	int checked;      /* 1: the first result has been looked at */
	double began;
	struct cli_watch watch;
};

/* Keep a result, whose text is then owned by the sweep. */
enum hawser_status cli_sweep_finish(struct cli_sweep_run *run, long variation,
                                    struct cli_sweep_packed packed, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* The next variation to compute; the number of all: none is left. */
long cli_sweep_next(struct cli_sweep_run *run);
/* Show the progress. Returns nonzero if the user has interrupted. */
int cli_sweep_watch(struct cli_sweep_run *run);
/* The message after an interrupt. */
enum hawser_status cli_sweep_interrupted(const struct cli_sweep_run *run,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* sweep_processes.c: all variations by so many processes. */
enum hawser_status cli_sweep_together(struct cli_sweep_run *run, int count,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* sweep_ranks.c: among the ranks of the sweep. */
enum hawser_status cli_sweep_among(struct cli_sweep_run *run,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
