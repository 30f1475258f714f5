/* output/output.h - what results become: tables, JSON, pictures. Formats only: every number that is
 * written here was computed by a stage upstream or by the command that calls.
 *
 * Nothing leaves half-written: a file appears under its name complete, or not at all; a number that
 * is not finite is refused with HAWSER_ERR_NAN and its name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_OUTPUT_H
#define HAWSER_OUTPUT_OUTPUT_H

#include <stdio.h>

#include <jansson.h>

#include <hawser/hawser.h>

#include "core/file.h"

/* --- table.c: tab-separated values --- */

struct hawser__cell {
	double number;
	const char *word; /* static string; NULL for a number */
};

/* Filled in any order of comments and columns, then cell by cell along the rows. A failure sticks
 * and is told by _write. All zero is an empty table. */
struct hawser__table {
	char **comment, **column;
	int comments, columns;
	size_t rows; /* made as they are written, see _rows */
	void (*fill)(struct hawser__table *row, const void *context, size_t index);
	const void *context;
	struct hawser__cell *cell; /* [cells] row-major */
	size_t cells, capacity;
	int failed; /* an allocation did */
};
void hawser__table_comment(struct hawser__table *table, const char *format, ...)
	HAWSER_PRINTF(2, 3);
void hawser__table_column(struct hawser__table *table, const char *format, ...) HAWSER_PRINTF(2, 3);
void hawser__table_number(struct hawser__table *table, double number);
void hawser__table_word(struct hawser__table *table, const char *word); /* "": no value */
/* `count` rows that are not kept: `fill` puts the cells of row `index` into `row`, or none to leave
 * it out; it is called again for each check and each writing, and its context must last until then.
 * They come before what is put cell by cell. */
void hawser__table_rows(struct hawser__table *table, size_t count,
                        void (*fill)(struct hawser__table *row, const void *context, size_t index),
                        const void *context);
/* Every number is finite and nothing failed. */
enum hawser_status hawser__table_check(const struct hawser__table *table,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__table_print_comments(const struct hawser__table *table, FILE *stream);
/* Comments as `# ...`, a row of column names, rows with 17 digits. */
enum hawser_status hawser__table_write(const struct hawser__table *table, const char *path,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__table_clear(struct hawser__table *table);

/* --- json.c --- */

struct hawser__json;

/* A list whose elements are made as they are written, see _list. */
struct hawser__json_list {
	json_t *place; /* an empty array in the result */
	size_t count;
	void (*fill)(struct hawser__json *json, json_t *list, const void *context, int part,
	             size_t index);
	const void *context;
	int part;
};
enum { HAWSER__JSON_LISTS = 64 };

/* A result being built. The first failure (a number that is not finite, no memory) sticks and is
 * told by _write. */
struct hawser__json {
	json_t *root; /* object */
	enum hawser_status status;
	struct hawser_report report;
	struct hawser__json_list list[HAWSER__JSON_LISTS]; /* [lists] */
	int lists;
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
/* An array whose elements are not kept, in an object: `fill` appends element `index` of the
 * caller's list `part` to `list`, or nothing to leave it out. Each is made once here, to be
 * checked, and again as it is written; the context must last until then. */
void hawser__json_list(struct hawser__json *json, json_t *into, const char *key, size_t count,
                       void (*fill)(struct hawser__json *json, json_t *list, const void *context,
                                    int part, size_t index),
                       const void *context, int part);
enum hawser_status hawser__json_write(const struct hawser__json *json, const char *path,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__json_clear(struct hawser__json *json);

/* --- gnuplot.c: pictures through the gnuplot program --- */

/* A picture being described: `script` takes gnuplot commands and inline data. */
struct hawser__picture {
	FILE *script;
	const char *path;
	double width, height; /* cm */
	double left, middle; /* of the panel, for its label */
};
/* Is there a gnuplot, and is the extension of `path` .svg, .png or .pdf ("-" is SVG)? Asked before
 * a long computation. HAWSER_ERR_ARGUMENT, HAWSER_ERR_PROGRAM. NULL is fine. */
enum hawser_status hawser__picture_check(const char *path,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__picture_begin(struct hawser__picture *picture, const char *path,
                                         double width_cm, double height_cm,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* Run gnuplot and put the picture in place. Ends the use of *picture, as _abort does. */
enum hawser_status hawser__picture_finish(struct hawser__picture *picture,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* For signal handlers, on the thread that draws: 1 where gnuplot may be running, which is then
 * ended; the picture fails. */
int hawser__picture_stop(void);
void hawser__picture_abort(struct hawser__picture *picture);
/* Inner frame of the next panel, as fractions of the picture from its lower left corner. */
void hawser__picture_panel(struct hawser__picture *picture, double left, double right,
                           double bottom, double top);
/* Title of the panel's vertical axis, at a place of its own: gnuplot would put it beside the tics'
 * labels, and drop it from the picture where these are long. */
void hawser__picture_ylabel(struct hawser__picture *picture, const char *format, ...)
	HAWSER_PRINTF(2, 3);
/* At most so many tics between low and high on axis 'x' or 'y'. */
void hawser__picture_tics(struct hawser__picture *picture, char axis, double low, double high,
                          int most);

/* --- plot_*.c: one picture a command; all arrays in SI --- */

enum hawser_status hawser__plot_statics(const char *path, const struct hawser_statics *statics,
                                        const struct hawser_profile_point *profile, int points,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Compatibility curves of one cable as its tension varies: epsilon against delta and against
 * eta. */
enum hawser_status hawser__plot_compatibility(const char *path, const struct hawser_statics *here,
                                              const struct hawser_statics *curve, int points,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;

/* Steady states over the speed: tension held and taut, tension held and slack, length held. */
enum { HAWSER__SPEEDS_CURVES = 3 };
struct hawser__speeds {
	struct {
		int points;         /* 0: there is no such curve */
		const double *rows; /* [points][3] speed (m/s), sag (m), T0 (N) */
	} curve[HAWSER__SPEEDS_CURVES];
	double limit; /* m/s, or NAN */
};
enum hawser_status hawser__plot_speeds(const char *path, const struct hawser__speeds *speeds,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Deflections of static models over delta; curve [models][points], the first model is the exact
 * one. */
struct hawser__deflections {
	int models, points;
	const char *const *name; /* [models] */
	const struct hawser_statics *curve; /* [models][points] at the same horizontal tensions */
	const struct hawser_statics *here;  /* of the first model */
};
enum hawser_status hawser__plot_deflections(const char *path,
                                            const struct hawser__deflections *deflections,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* The first modes' components against unstretched arclength, up to twelve panels. */
enum hawser_status hawser__plot_modes(const char *path, const struct hawser_modes *modes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Branches of frequencies along a sweep, in the units of the titles. */
struct hawser__diagram {
	int stations, branches, in_plane, overlays, marks;
	int logarithmic;             /* the abscissa */
	int moving;                  /* the panel names the speed, */
	double speed;                /* m/s */
	const char *x_title, *y_title;
	const double *x;             /* [stations] */
	const double *y;             /* [stations][branches] those in the plane first */
	const double *overlay;       /* [stations][overlays] dashed, NAN for nothing */
	const double *mark_x;        /* [marks] where two branches are closest */
	const double *mark_y;        /* [marks][2] on both of them; NAN on one that is not shown */
	const int *veers;            /* [marks] 1: a veering, 0: a crossing */
};
enum { HAWSER__DIAGRAMS = 12 };
/* diagram[count], each a panel with the axes of the first. */
enum hawser_status hawser__plot_irvine(const char *path, const struct hawser__diagram *diagram,
                                       int count, struct hawser_report *report) HAWSER_MUST_CHECK;

/* Eigenvalues over the speed, in the unit of the titles, a column a plane. */
struct hawser__campbell {
	int stations, branches, in_plane, marks, harmonics;
	const char *unit;        /* "rad/s" */
	const double *speed;     /* [stations] m/s */
	const double *re, *im;   /* [stations][branches] those in the plane first */
	const double *mark_x;    /* [marks] m/s, where two branches in the plane are closest */
	const double *mark_y;    /* [marks][2] on both of them; NAN on one that is not shown */
	const int *veers;        /* [marks] 1: a veering, 0: a crossing */
	double slope;            /* of the first harmonic's line, per m/s */
	double limit;            /* m/s, end of the steady state; NAN where it is not shown */
};
enum hawser_status hawser__plot_campbell(const char *path, const struct hawser__campbell *diagram,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* The first modes as displacements of the span: in the plane about the static profile, out of plane
 * seen from above; enlarged, up to twelve panels. */
enum hawser_status hawser__plot_displaced(const char *path, const struct hawser_modes *modes,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* Modes of a travelling cable, up to twelve panels: real and imaginary parts of their components;
 * the leading one at moments of a period with its waves downstream and upstream; the span at
 * moments. */
enum hawser_status hawser__plot_complex_modes(const char *path,
                                              const struct hawser_complex_modes *modes,
                                              struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__plot_waves(const char *path, const struct hawser_complex_modes *modes,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__plot_passing(const char *path, const struct hawser_complex_modes *modes,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* What one run of a method gave and took. */
struct hawser__cost {
	const char *method;       /* runs of one method stand together */
	int basis, automatic;     /* resolution, and whether the method chose it */
	double frequency, shape;  /* largest errors */
	double stated;            /* largest error of a frequency as the method states it */
	double seconds, bytes;    /* bytes 0: not known */
};
/* Errors against time, at most 32 methods. */
enum hawser_status hawser__plot_compare(const char *path, const struct hawser__cost *run, int runs,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* What a fidelity's response is off the reference's: largest relative errors, NAN for none. */
struct hawser__precision {
	const char *family;  /* runs of one family stand together */
	int number;          /* of modes */
	double seconds;      /* of the processor */
	double fold, peak, amplitude; /* frequencies of folds and peaks, amplitudes of peaks */
	int incomplete;      /* it lacks folds or peaks, or has some of its own */
};
/* Error of the frequencies against time, and against the number of modes. */
enum hawser_status hawser__plot_precision(const char *path, const struct hawser__precision *run,
                                          int runs, const char *reference,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* One curve of a history: a probe's displacement component, or a coordinate. */
struct hawser__signal {
	const char *label;   /* "y, mid" */
	const double *value; /* [rows] */
	const double *rate;  /* [rows] its time derivative */
	const double *amplitude; /* [bins] spectrum */
};
struct hawser__history {
	int rows, bins, signals;
	int settled_from;    /* first row of the part drawn in the phase plane */
	const double *time;  /* [rows] */
	const double *frequency; /* [bins] */
	double forcing;      /* frequency of the forcing in the unit of `frequency`, 0 for none */
	int scaled;          /* units are s, m, Hz; otherwise the model's own */
	const struct hawser__signal *signal; /* [signals], at most three */
};
enum hawser_status hawser__plot_integrate(const char *path, const struct hawser__history *history,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* A frequency response, in SI where the model has units. */
/* A located peak of a curve. */
struct hawser__response_peak {
	int curve;
	double omega, amplitude;
};
struct hawser__response_event {
	enum hawser_event_kind kind;
	double omega;
	int after;       /* index of the last point before it */
	double fraction; /* of the way from there to the next point */
};
struct hawser__response_curve {
	const char *label; /* "mid-span"; "" where the panel says it all */
	int panel;         /* index into panel_label */
	const double *amplitude; /* [points] */
};
struct hawser__response_sweep {
	const char *label; /* "up-sweep" */
	int points;
	const double *omega;     /* [points] */
	const double *amplitude; /* [curves][points] */
};
/* Another curve over it, dotted: an approximation, or a backbone. */
struct hawser__response_overlay {
	const char *label;
	int points;
	const double *omega;     /* [points] */
	const double *amplitude; /* [curves][points] */
};
struct hawser__response {
	int points, curves, panels, events, peaks, naturals, sweeps, logarithmic, overlays;
	int scaled;
	const double *omega; /* [points] */
	const int *unstable; /* [points] count of multipliers outside the unit circle */
	const char *const *panel_label; /* [panels] axis titles */
	const struct hawser__response_curve *curve; /* [curves] */
	const struct hawser__response_event *event; /* [events] */
	const struct hawser__response_peak *peak; /* [peaks] */
	const double *natural; /* [naturals] natural frequencies, ascending */
	const struct hawser__response_sweep *sweep; /* [sweeps], at most two */
	const struct hawser__response_overlay *overlay; /* [overlays], at most four */
	double from, to;
};
enum hawser_status hawser__plot_frf(const char *path, const struct hawser__response *response,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Fold curves (Omega, load factor), and responses at the model's own load (Omega, amplitude). */
struct hawser__folds_line {
	int points;
	const double *x, *y; /* [points] */
	const int *unstable; /* [points] 0 or 1; of a response */
};
struct hawser__folds_mark {
	enum hawser_folds_kind kind;
	double omega, load;
};
struct hawser__folds_picture {
	int curves, responses, marks, scaled;
	const struct hawser__folds_line *curve;    /* [curves] */
	const struct hawser__folds_line *response; /* [responses] the main one, then the detached */
	const struct hawser__folds_mark *mark;     /* [marks] */
	const char *label;       /* of the amplitude */
	double from, to, load_to;
};
enum hawser_status hawser__plot_folds(const char *path, const struct hawser__folds_picture *folds,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

/* Eigenvalues of travelling beams over their speed, a colour for each beam, or each branch of
 * one. */
struct hawser__beam_curve {
	const struct hawser_beam_sweep *sweep;
	double v_crit, v_bif;       /* scaled, NAN for none */
	double per_speed, per_rate; /* shown units per scaled one */
	char label[48];
};
struct hawser__beam_picture {
	int variants, dimensional;
	const struct hawser__beam_curve *curve; /* [variants] */
};
enum hawser_status hawser__plot_beam_sweep(const char *path, const struct hawser__beam_picture *picture,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* Boundaries over a parameter. */
struct hawser__beam_line {
	int points, colour, dashed;
	const double *x, *y; /* [points] y NAN: a gap */
	char label[96];
};
struct hawser__beam_lines {
	int lines, dimensional;
	const char *x_title;
	double per;          /* units of x in one of its title's */
	const struct hawser__beam_line *line; /* [lines] */
};
enum hawser_status hawser__plot_beam_lines(const char *path, const struct hawser__beam_lines *picture,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* Motions: a deflection, its logarithm, and a rate of energy, each over time. */
struct hawser__beam_history {
	int rows;
	const double *time, *y, *rate; /* [rows] shown units */
	char label[96];
};
struct hawser__beam_histories {
	int count, dimensional;
	const struct hawser__beam_history *history; /* [count] */
};
enum hawser_status hawser__plot_beam_motion(const char *path,
                                            const struct hawser__beam_histories *histories,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* A map over two parameters. */
struct hawser__map_picture {
	int nx, ny, segments;
	const double *x, *y;      /* [nx], [ny] pixels' middles, equidistant */
	const double *value;      /* [ny][nx] NAN where there is none */
	const double *segment;    /* [segments][4] x, y of both ends of pieces of boundary lines */
	double per[2];            /* units of x and y in one of their titles' */
	const char *x_title, *y_title, *title;
	double border;            /* the value at which stability is lost; NAN: it tells none */
	int logarithmic, whole;   /* colours by the logarithm; values are whole numbers */
	const char *line_title;   /* what changes on the boundary lines */
	int holes;                /* some values are NAN */
};
enum hawser_status hawser__plot_map(const char *path, const struct hawser__map_picture *map,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* Boundaries of stability in a plane of two parameters. */
struct hawser__hill_line {
	int kind;            /* enum hawser_hill_kind; -1: a characteristic value, -2: an expansion */
	int points;
	const double *at;    /* [points][2] */
};
struct hawser__hill_picture {
	int lines;
	const struct hawser__hill_line *line; /* [lines] */
	const char *x_title, *y_title;
	double per[2];       /* units of x and y in one of their titles' */
	int boxes;           /* where it is unstable: */
	const double *box;   /* [boxes][4] x and y of the lower left and the upper right corner */
	double from[2], to[2];
};
enum hawser_status hawser__plot_hill(const char *path, const struct hawser__hill_picture *hill,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Energy and frequency at [points][2]. */
enum hawser_status hawser__plot_energy(const char *path, const double *at, int points, int scaled,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
