/* output/output.h - output of results as tables, JSON and pictures. This stage formats only: all
 * numbers are computed by earlier stages or by the calling command.
 *
 * A file is written completely or not at all. A number that is not finite causes HAWSER_ERR_NAN;
 * the message names it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_OUTPUT_H
#define HAWSER_OUTPUT_OUTPUT_H

#include <stdio.h>

#include <jansson.h>

#include <hawser/hawser.h>

#include "core/file.h"
#include "output/drawing/axis.h"

/* --- table.c: tab-separated values --- */

struct hawser__cell {
	double number;
	const char *word; /* static string; NULL for a number */
};

/* Comments and columns are added in any order, then the cells row by row. The first failure is
 * recorded and reported by _write. Zero is an empty table. */
struct hawser__table {
	char **comment, **column;
	int comments, columns;
	size_t rows; /* number of rows generated on output, see _rows */
	void (*fill)(struct hawser__table *row, const void *context, size_t index);
	const void *context;
	void *owned; /* freed by _clear; or NULL */
	json_t *about; /* of each column an object, see _about; or NULL */
	struct hawser__cell *cell; /* [cells] row-major */
	size_t cells;
	int failed; /* 1: an allocation failed */
};
/* Numbers with an SI unit are shown in the units that the user has chosen (units.h). */
void hawser__table_comment(struct hawser__table *table, const char *format, ...)
	HAWSER_PRINTF(2, 3);
/* The same as it stands: for the user's own words, and times of computation. */
void hawser__table_remark(struct hawser__table *table, const char *format, ...)
	HAWSER_PRINTF(2, 3);
void hawser__table_column(struct hawser__table *table, const char *format, ...) HAWSER_PRINTF(2, 3);
/* What the column added last is, for JSON: `key`, its name without unit, the title of an axis, which
 * may have gnuplot's markup, the meaning, and the unit in which the table shows it; "" for none. */
void hawser__table_about(struct hawser__table *table, const char *key, const char *title,
                         const char *meaning, const char *unit);
void hawser__table_number(struct hawser__table *table, double number);
void hawser__table_word(struct hawser__table *table, const char *word); /* "": no value */
/* `count` rows that are not stored but generated on output: `fill` puts the cells of row `index`
 * into `row`, or none to omit the row. It is called again for each check and each output; the
 * context must remain valid until then. These rows precede those put cell by cell. */
void hawser__table_rows(struct hawser__table *table, size_t count,
                        void (*fill)(struct hawser__table *row, const void *context, size_t index),
                        const void *context);
/* Check that all numbers are finite and that no allocation failed. */
enum hawser_status hawser__table_check(const struct hawser__table *table,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__table_print_comments(const struct hawser__table *table, FILE *stream);
/* Write comments as `# ...`, a row of column names, and rows with 17 digits a number. */
enum hawser_status hawser__table_write(const struct hawser__table *table, const char *path,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for a reader, on standard output: columns side by side, and 7 digits a number. */
enum hawser_status hawser__table_show(const struct hawser__table *table,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__table_clear(struct hawser__table *table);

/* --- json.c --- */

struct hawser__json;

/* A list whose elements are generated on output, see _list. */
struct hawser__json_list {
	json_t *place; /* an empty array in the result */
	size_t count;
	void (*fill)(struct hawser__json *json, json_t *list, const void *context, int part,
	             size_t index);
	const void *context;
	int part;
};
enum { HAWSER__JSON_LISTS = 64 };

/* A result being built. The first failure (a number that is not finite, no memory) is recorded and
 * reported by _write. */
struct hawser__json {
	json_t *root; /* object */
	enum hawser_status status;
	struct hawser_report report;
	struct hawser__json_list list[HAWSER__JSON_LISTS]; /* [lists] */
	int lists;
	struct hawser__json_members {
		const json_t *place; /* a member of root in their place, or NULL */
		int (*write)(FILE *stream, const void *context);
		const void *context;
	} members;
	void *owned[HAWSER__JSON_LISTS]; /* [owns] freed by _clear */
	int owns;
};
void hawser__json_begin(struct hawser__json *json);
/* Members of an object (or, with key NULL, elements of an array) `into`. */
void hawser__json_number(struct hawser__json *json, json_t *into, const char *key, double number);
void hawser__json_integer(struct hawser__json *json, json_t *into, const char *key, long number);
void hawser__json_flag(struct hawser__json *json, json_t *into, const char *key, int flag);
void hawser__json_text(struct hawser__json *json, json_t *into, const char *key, const char *text);
void hawser__json_null(struct hawser__json *json, json_t *into, const char *key);
json_t *hawser__json_object(struct hawser__json *json, json_t *into, const char *key);
json_t *hawser__json_array(struct hawser__json *json, json_t *into, const char *key);
/* factor*numbers[0..count). */
void hawser__json_numbers(struct hawser__json *json, json_t *into, const char *key,
                          const double *numbers, int count, double factor);
/* An array in an object whose elements are not stored: `fill` appends element `index` of the
 * caller's list `part` to `list`, or nothing to omit it. Each element is generated once by this
 * call, to be checked, and again on output; the context must remain valid until then. */
void hawser__json_list(struct hawser__json *json, json_t *into, const char *key, size_t count,
                       void (*fill)(struct hawser__json *json, json_t *list, const void *context,
                                    int part, size_t index),
                       const void *context, int part);
/* Members of the root that `write` prints on output, at this place between the others: their text, each
 * but the first on a line after ",\n ". It returns nonzero if memory ran out; the context must remain
 * valid until then. At most one such call for a result. */
void hawser__json_members(struct hawser__json *json,
                          int (*write)(FILE *stream, const void *context), const void *context);
enum hawser_status hawser__json_write(const struct hawser__json *json, const char *path,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__json_clear(struct hawser__json *json);

/* --- gnuplot.c: pictures through the gnuplot program --- */

enum { HAWSER__NO_SCALE = -1 }; /* its axes are no quantities, or nothing is plotted */
/* A picture being built: `script` receives gnuplot commands and inline data. */
struct hawser__picture {
	FILE *script;
	const char *path;
	double width, height; /* cm */
	double more;          /* cm: for more than two rows of the legend, below */
	int scale;            /* of the panel that was plotted last: bit 1: x is logarithmic,
		bit 2: y is; or */
	double left, middle; /* of the panel, for its label */
};
/* Check, before a long computation, that gnuplot is available and that the extension of `path` is
 * .svg, .png, .pdf, .eps or .tex ("-" is SVG), or .gp: the script. Statuses: HAWSER_ERR_ARGUMENT,
 * HAWSER_ERR_PROGRAM. NULL is legal. */
enum hawser_status hawser__picture_check(const char *path,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for an animation, whose name is known to end in .gif. */
enum hawser_status hawser__picture_check_gif(const char *path,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__picture_begin(struct hawser__picture *picture, const char *path,
                                         double width_cm, double height_cm,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* Run gnuplot and write the picture. *picture must not be used afterwards, as after _abort. */
enum hawser_status hawser__picture_finish(struct hawser__picture *picture,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* For signal handlers, on the thread that draws: if gnuplot may be running, end it and return 1;
 * the picture then fails. */
int hawser__picture_stop(void);
void hawser__picture_abort(struct hawser__picture *picture);
/* Inner frame of the next panel, as fractions of the picture from its lower left corner. Vertical
 * places stand in the script as "screen up(0.25)", since the title and the legend may make the
 * picture higher. */
void hawser__picture_panel(struct hawser__picture *picture, double left, double right,
                           double bottom, double top);
/* Title of the vertical axis of the panel, at a fixed position. gnuplot would place it beside the
 * tic labels, and outside the picture if these are long. */
void hawser__picture_ylabel(struct hawser__picture *picture, const char *format, ...)
	HAWSER_PRINTF(2, 3);
/* Set at most the given number of tics between low and high on axis 'x' or 'y'. */
void hawser__picture_tics(struct hawser__picture *picture, char axis, double low, double high,
                          int most);
/* A user's text, which has no markup, within single quotes (data 0) or as a word of a block of data. */
void hawser__picture_literal(FILE *script, const char *text, int data);
/* A logarithmic axis ("x", "y" or "cb"): tics at powers of ten, up to a ratio `fine` of the ends (30
 * has room anywhere) at 1, 2 and 5 times them. */
void hawser__picture_log_tics(struct hawser__picture *picture, const char *axis, double low,
                              double high, double fine);

/* --- plot_*.c: one picture per command; arrays in SI, to be divided by `per` of their axis, but where
 * the comment says in the units of the titles --- */

/* A point of a profile in global axes; slope is dy/dx. */
struct hawser__spot {
	double S, x, y, T, slope, z;
};
struct hawser__span_picture {
	const struct hawser_scene *scene;
	const struct hawser__spot *profile; /* [points] */
	const struct hawser__spot *kink;    /* [kinks][2], both sides of each attachment, by S */
	int points, kinks;
	int turned; /* 1: the cable hangs in another plane, and a panel shows it from above */
};
/* axis[4]: x, height, tension, z. */
enum hawser_status hawser__plot_statics(const char *path, const struct hawser__span_picture *of,
                                        const struct hawser__axis *axis,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The first modes' components against unstretched arclength, up to twelve panels; of a travelling cable
 * real and imaginary parts. */
enum hawser_status hawser__plot_modes(const char *path, const struct hawser_modes *modes,
                                      const struct hawser__axis *S,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* The first modes as magnified displacements of the span, up to twelve panels: in-plane modes about
 * the static profile, out-of-plane modes seen from above; of a travelling cable at instants of a
 * period. */
enum hawser_status hawser__plot_displaced(const char *path, const struct hawser_modes *modes,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* The leading component of modes of a travelling cable at instants of a period, with its downstream and
 * upstream waves. */
enum hawser_status hawser__plot_waves(const char *path, const struct hawser_modes *modes,
                                      const struct hawser__axis *S,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Errors and cost of one run of a method. */
struct hawser__cost {
	const char *method;       /* the runs of a method are adjacent */
	int basis, automatic;     /* resolution, and whether the method chose it */
	double frequency, shape;  /* largest errors */
	double stated;            /* largest error estimate of a frequency */
	double seconds;
};
/* Errors against time, at most 32 methods. */
enum hawser_status hawser__plot_compare(const char *path, const struct hawser__cost *run, int runs,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Largest relative errors of the response of a fidelity with respect to the reference, NAN for
 * none. */
struct hawser__precision {
	const char *family;  /* the runs of a family are adjacent */
	int number;          /* number of modes */
	double seconds;      /* processor time */
	double fold, peak, amplitude; /* errors of frequencies of folds and peaks, amplitudes of
	                               * peaks */
	int incomplete;      /* 1: folds or peaks are missing or spurious */
};
/* Error of the frequencies against time, and against the number of modes. */
enum hawser_status hawser__plot_precision(const char *path, const struct hawser__precision *run,
                                          int runs, const char *reference,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* A map over two parameters. */
struct hawser__map_picture {
	int nx, ny, segments;
	const double *x, *y;      /* [nx], [ny] pixels' middles, equidistant */
	const double *value;      /* [ny][nx] NAN where there is none */
	const double *segment;    /* [segments][4] x, y of both ends of pieces of boundary lines */
	struct hawser__axis x_axis, y_axis;
	const char *title;
	double border;            /* value of the stability boundary; NAN if the quantity has none */
	int logarithmic, whole;   /* 1: logarithmic colours; 1: values are integers */
	const char *line_title;   /* what changes on the boundary lines */
	int holes;                /* 1: some values are NAN */
	int basins;               /* > 0: values are numbers of so many responses, 0 (none) or -1 (no
	                           * bounds), each with its colour */
};
enum hawser_status hawser__plot_map(const char *path, const struct hawser__map_picture *map,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
