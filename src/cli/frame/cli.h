/* cli/frame/cli.h - the program: a table of commands, each with a table of options. A command
 * parses its options, calls the library, converts between a model's scale and SI, and prints.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_CLI_H
#define HAWSER_CLI_CLI_H

#include <stddef.h>

#include <hawser/hawser.h>
#include "cli/model/fixed.h"
#include "cli/frame/option.h"
#include "output/output.h"
#include "output/drawing/picture_choice.h"
#include "scene/tree_keys.h"

#define CLI_STEP 0.005 /* longest step of a response, as a part of its range, by default */
/* --set options, further inputs, and different options of some kinds of inputs, in one call */
enum { CLI_SETS = 64, CLI_MORE_INPUTS = 99, CLI_GIVEN = 64 };

/* Settings of every command; the first member of each command's own. */
struct cli_common {
	const char *input; /* scene or model; "-" is standard input */
	struct hawser_document *document; /* its text, read when it is asked for: document.c */
	const char *library; /* the same as input if that is a shared library (hawser/plugin.h); or NULL */
	const char *more[CLI_MORE_INPUTS]; /* [mores] after the first, if the command's input has "..." */
	int mores;
	const char *second; /* the second argument of a command whose `input` has two words; or NULL */
	const char *json, *tsv, *plot; /* files to write, or NULL */
	const char *gp; /* a file for the script of the picture besides; or NULL */
	struct hawser__picture_choice picture;
	struct cli_lane_choice lane; /* of commands that make models */
	const char *units; /* list of units for tables, or NULL: SI */
	const char *set[CLI_SETS];
	int sets;
	const struct cli_option *given[CLI_GIVEN]; /* [givens] each once */
	int givens;
	int quiet, help;
	int reproducible; /* 1: omit from results what differs between runs */
	int delivered;    /* 1: another option has written files, so that the table is not printed */
	double started; /* monotonic clock, s */
	char *const *word; /* [words] of the command line, after the command's name */
	int words;
};

struct cli_listing; /* view.h */
/* The input is a file or a word (kinds.h). With an option --help of its own, it has no common ones. */
struct cli_command {
	const char *name, *input, *summary;
	const char *const *notes; /* lines for --help, ended by NULL; may be NULL */
	const struct cli_option *options; /* ended by CLI_NO_OPTION */
	const void *defaults; /* of the settings; NULL: all zero */
	size_t size;          /* of the settings */
	int needs_input;
	enum hawser_status (*run)(void *settings, struct hawser_report *report);
	const struct cli_listing *listing; /* for hawser help columns */
	unsigned takes; /* bits of enum cli_kind: inputs of which kinds; besides those with this part */
	size_t part;    /* CLI_PART(statics): of the records of kinds (kinds.h); 0: none */
};
/* All commands, in the groups and the order of hawser --help: X is the row that a new command adds. */
#define CLI_COMMANDS(GROUP, X) \
	GROUP("Scenes") \
	X(init) X(check) X(plan) X(schema) \
	GROUP("Statics and modes") \
	X(statics) X(modes) X(irvine) X(campbell) X(beam) \
	GROUP("Models and motion in time") \
	X(rom) X(integrate) X(transient) X(trajectory) X(tow) X(tow_steady) \
	GROUP("Periodic motions and stability") \
	X(frf) X(orbit) X(folds) X(locus) X(nnm) X(mms) X(hill) \
	GROUP("Maps, variations and comparisons") \
	X(map) X(merge) X(sweep) \
	X(compare) X(compare_modes) X(compare_mms) X(compare_motion) \
	GROUP("Measurements") \
	X(damping) X(identify) \
	GROUP("Reports and shells") \
	X(report) X(completion)
#define CLI_NO_GROUP(title)
#define CLI_DECLARE(command) extern const struct cli_command cli_##command;
CLI_COMMANDS(CLI_NO_GROUP, CLI_DECLARE)
#undef CLI_DECLARE

/* What options say of each other (struct cli_option), of those that are given. */
enum hawser_status cli_rules_check(const struct cli_command *command, const struct cli_common *common,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* The settings of a command with their defaults, for free(); NULL when out of memory. */
void *cli_settings(const struct cli_command *command);
enum hawser_status cli_parse(void *settings, const struct cli_command *command, int argc,
                             char **argv, struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_print_help(const struct cli_command *command, FILE *stream);
void cli_print_columns(const struct cli_command *command, FILE *stream);
extern const struct cli_option cli_common_options[];
/* The command's own and the common options, without headings; NULL beyond the last. */
const struct cli_option *cli_option_row(const struct cli_command *command, int index);
const struct cli_option *cli_common_of(const struct cli_command *command);
const struct cli_command *cli_command_row(int index); /* from 0; NULL beyond the last */

/* nearest.c: the name that is nearest to a misspelt one, or NULL. */
const char *cli_nearest(const char *name, const char *const *names, int count);

/* --- document.c: the input of the command, read once --- */

enum hawser_status cli_document(const struct hawser_document **document,
                                const struct cli_common *common,
                                struct hawser_report *report) HAWSER_MUST_CHECK;
/* What the input describes. What cannot be read is taken for a span, whose reader tells why. */
enum hawser_kind cli_kind(const struct cli_common *common);
/* cli_read_scene, cli_read_net ... a scene of the kind, with the overrides of the command line. After
 * a failure it is all zero. */
#define CLI_KINDS_OF_SCENES(X) X(scene, ) HAWSER_SCENE_KINDS(X)
#define CLI_OPEN(name, NAME) \
	enum hawser_status cli_read_##name(struct hawser_##name *name, \
	                                   const struct cli_common *common, \
	                                   struct hawser_report *report) HAWSER_MUST_CHECK;
CLI_KINDS_OF_SCENES(CLI_OPEN)
#undef CLI_OPEN

/* --- model.c: a model from the scene or model file of the command line --- */

struct cli_model {
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes;
	struct hawser_rom rom;
	int has_scene;   /* of a span; otherwise the model came from a file, a ropeway or a net */
	struct cli_made *made; /* model/made.h: what it is made from; NULL: of a span, or of a file */
	struct hawser_rom_source source; /* its text, if it has parameters; else all zero */
	int reproducible; /* 1: no times in the results */
	int starved;     /* 1: out of memory while its range was judged (cli_range_warn) */
	int automatic;   /* 1: modes are to be chosen; until then rom contains its units only */
	struct hawser_accuracy accuracy; /* the choice, if automatic; not to be moved in memory */
	double *natural; /* [naturals] natural.c: natural frequencies, scaled, ascending */
	int naturals;
	struct cli_basis {
		int functions;  /* functions per component; 0: no full-order model, or not checked */
		double error;   /* largest relative error of a natural frequency up to `to` (scaled) */
		double to, lacks; /* lacks: hawser_rom_full_lacks */
		enum hawser_plane plane; /* of the mode with the largest error */
		int number;
	} basis;
	struct cli_exact exact;
	struct cli_model_error error; /* of cli_exact_range; of responses, it is in the result */
};
const char *cli_input_name(const struct cli_common *common); /* "<stdin>" for "-" */
/* Most modes of a model whose ranges (hawser/law.h) are sought unasked: half a second; chosen. */
enum { CLI_JUDGED = 40 };
/* n > 0 overrides the scene's modes. With modes: auto the model is made later, for the range of
 * frequencies, by cli_choice_build or _trace. _entries: one of more than CLI_JUDGED modes is only
 * written (hawser_rom_build_entries). */
enum hawser_status cli_model_load(struct cli_model *model, const struct cli_common *common, int n,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_model_entries(struct cli_model *model, const struct cli_common *common, int n,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for a reduced-model file. A scene is read, but nothing is computed from it. */
enum hawser_status cli_model_or_scene(struct cli_model *model, const struct cli_common *common,
                                      int n, struct hawser_report *report) HAWSER_MUST_CHECK;
/* library.c: the function in a shared library. */
enum hawser_status cli_library_open(struct hawser_rom_source *source, const char *path,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_model_clear(struct cli_model *model);
/* SI per scaled unit of length and of frequency; 1 if the model has no units. */
double cli_per_length(const struct cli_model *model);
double cli_per_omega(const struct cli_model *model);
/* The scene alone, with n > 0 overriding model.modes. */
enum hawser_status cli_scene_load(struct hawser_scene *scene, const struct cli_common *common,
                                  int n, struct hawser_report *report) HAWSER_MUST_CHECK;
struct hawser_modes_options cli_modes_options(const struct hawser_scene *scene);

/* known.c. Extend the model of a scene with a given number of modes: condensed modes up to several
 * times the forcing frequency `omega` (scaled) get their linear response. _lacks: returns 1 if the
 * forcing frequency exceeds half of the highest frequency that the model knows, with a message. */
enum hawser_status cli_known(struct cli_model *model, double omega,
                             struct hawser_report *report) HAWSER_MUST_CHECK;
int cli_known_lacks(char *text, size_t size, const struct cli_model *model, double omega);
/* known.c: the tolerance of orbits that are followed over two parameters, if the user gives none (0): a
 * hundredth of what models of scenes are good for at best; 0: the library's, for files of models. */
double cli_tolerance(double given, const struct cli_model *model);
/* known.c: up to where a response is that of the modes, and of waves that do not break, scaled;
 * INFINITY: no such end is known. */
double cli_modes_end(const struct cli_model *model);
/* known.c: the frequency at which carriers pass at the speed of the scene, scaled; 0: not said. */
double cli_passing(const struct cli_model *model);
void cli_known_warn(const struct cli_model *model, double omega);

/* basis.c. Checks the natural frequencies of a full-order model up to twice `omega` (scaled), at least
 * the first of each plane; HAWSER_ERR_CONVERGENCE if the relative error of one is 1 or more. The result
 * is written as a comment and to JSON, and a large error is a warning. For other models nothing is
 * checked or written. */
enum hawser_status cli_basis_check(struct cli_model *model, double omega,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* Modes (scaled) up to `to`, by the spectral method's own choice of its basis: at least 12. */
enum hawser_status cli_modes_up_to(struct hawser_modes *modes, const struct hawser_statics *statics,
                                   double to, struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_basis_comment(struct hawser__table *table, const struct cli_model *model);
void cli_basis_warn(const struct cli_model *model);

/* choice.c: modes: auto. Natural frequencies and units before the modes are chosen. */
enum hawser_status cli_choice_prepare(struct cli_model *model,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Choose modes by estimated motions in a scaled range of frequencies, and build the model; does
 * nothing without modes: auto. */
enum hawser_status cli_choice_build(struct cli_model *model, double from, double to,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* The response with the requested accuracy. On failure *frf has the points computed before. */
enum hawser_status cli_choice_trace(struct hawser_frf *frf, struct cli_model *model,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* The chosen modes and the reasons, as comments; for JSON see cli_choice_field (view.h). */
void cli_choice_comments(struct hawser__table *table, const struct cli_model *model);

/* A comment about the scene's quadratic drag, if it has any, and `how` it is computed. choice.c. */
void cli_drag_comment(struct hawser__table *table, const struct cli_model *model, const char *how);
/* natural.c: K, D [n][n] of small motions about u = 0, with terms of one factor and constant ones. 1:
 * some terms depend on Omega, and are left out. */
int cli_linear(double *K, double *D, const struct hawser_rom *rom);
/* The number by which other commands know natural frequency k: of a model of chosen modes, that of
 * the mode among all of the structure. */
int cli_natural_number(const struct cli_model *model, int k);
/* Sets `natural`: undamped, with gyroscopic forces, as hawser modes prints them. */
enum hawser_status cli_natural(struct cli_model *model,
                               struct hawser_report *report) HAWSER_MUST_CHECK;

/* quantity.c: parse "80 kN", or a number in `unit`, to that unit. NULL does not change *value. */
enum cli_sign { CLI_ANY, CLI_NOT_NEGATIVE, CLI_ABOVE_ZERO };
enum hawser_status cli_quantity(double *value, const char *text, const char *unit, enum cli_sign sign,
                                const char *command, const char *option,
                                struct hawser_report *report) HAWSER_MUST_CHECK;
/* Parse "0.3 Hz", "2 rad/s", "0.6w1", or a number in the model's unit; scaled result. */
enum hawser_status cli_frequency(double *omega, const char *text, const char *option,
                                 const struct cli_model *model,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
/* Parse --from and --to, which must differ; `command` is for the message. NULL: 0.6w1 and 3.3w1, or
 * where the modes end, or waves break (cli_modes_end). */
enum hawser_status cli_range(double *from, double *to, const char *from_text, const char *to_text,
                             const char *command, const struct cli_model *model,
                             struct hawser_report *report) HAWSER_MUST_CHECK;
/* Parse "20 s", "50 T" (periods, scaled), or a number in the model's unit; scaled result. */
enum hawser_status cli_time(double *time, const char *text, const char *option, double period,
                            const struct cli_model *model,
                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* words.c: the index of `text` in words[count]; otherwise the message names all words. */
enum hawser_status cli_choose(int *index, const char *command, const char *option, const char *text,
                              const char *const *words, int count,
                              struct hawser_report *report) HAWSER_MUST_CHECK;
/* Check that a method for modes exists: of a travelling cable, or (travels 0) of one at rest. */
enum hawser_status cli_choose_method(const char *command, const char *text, int travels,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* state.c: read a state [2n] from a file: JSON (a list, {"u", "v"}, {"state"}, or the last of
 * {"states"}) or plain numbers, in m and m/s if the model has units. Scaled result; free it. */
enum hawser_status cli_state_open(double **state, const char *path, const struct cli_model *model,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* Fail if both the scene and the state (path, or NULL) are on standard input. */
enum hawser_status cli_state_check(const char *option, const char *path,
                                   const struct cli_common *common,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- last.c --- */

/* The end of an earlier result, scaled. */
struct cli_last {
	double *state;  /* [2n] u then u' */
	double t;       /* of a run */
	double omega;   /* forcing frequency, there */
	int swept;      /* 1: a run with --Omega-to */
	int direction;  /* of a response, in Omega: 1, -1; 0: not given in the result */
	enum hawser_frf_end end; /* of a response */
};
/* Read it from a JSON result of `command` (integrate or frf) of the same model. Release by _clear. */
enum hawser_status cli_last_open(struct cli_last *last, const char *path, const char *command,
                                 const struct cli_model *model, const struct cli_common *common,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_last_clear(struct cli_last *last);

/* --- deliver.c: output of results --- */

/* A picture, drawn when everything else is ready. */
struct cli_drawing {
	enum hawser_status (*draw)(const char *path, const void *context,
	                           struct hawser_report *report);
	const void *context;
};
/* Check, before the computation, that the outputs can be written. */
enum hawser_status cli_outputs_check(const struct cli_common *common,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for up to CLI_MORE_OUTPUTS additional files of other options. */
enum { CLI_MORE_OUTPUTS = 3 };
struct cli_output {
	const char *option, *path;
};
enum hawser_status cli_outputs_check_with(const struct cli_common *common,
                                          const struct cli_output *more, int count,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* A result as a table, as JSON and as a picture (NULL: the command has none). Table and JSON are
 * written by functions, or follow from the other members: the first comments and JSON members from
 * `head`, then further comments, the rows of a list of fields, and the members of JSON and of its
 * `stats`. JSON is created only if it is requested. */
struct hawser__field;
struct hawser__list;
struct cli_head; /* view.h */
struct cli_showing {
	void (*table)(struct hawser__table *table, const void *result);
	void (*json)(struct hawser__json *json, const void *result);
	enum hawser_status (*draw)(const char *path, const void *result, struct hawser_report *report);
	struct cli_head (*head)(const void *result);
	void (*comments)(struct hawser__table *table, const void *result);
	const struct hawser__list *rows; /* or NULL: the columns are up to `more` */
	void (*more)(struct hawser__table *table, const void *result); /* more rows; or NULL */
	const struct hawser__field *fields, *stats; /* stats: or NULL */
};
enum hawser_status cli_show(const struct cli_common *common, const struct cli_showing *showing,
                            const void *result, struct hawser_report *report) HAWSER_MUST_CHECK;

/* Append the second message: the result of a failed run (--partial) could not be written either. */
void cli_report_also(struct hawser_report *report, const struct hawser_report *second);

/* echo.c: the first comments and members of every result. */
void cli_echo_table(struct hawser__table *table, const struct cli_common *common,
                    const char *command, const struct hawser_scene *scene, const char *method);
void cli_echo_json(struct hawser__json *json, const struct cli_common *common,
                   const char *command, const struct hawser_scene *scene);
/* Add "stats" with the wall time so far; further members may be added to it. */
json_t *cli_stats_json(struct hawser__json *json, const struct cli_common *common);
double cli_seconds(void); /* monotonic clock */
double cli_processor_seconds(void); /* of the calling thread */
/* N: the peak inertial tension by the fluctuation of the travel speed at the forcing frequency `omega`
 * (scaled), which a modal model without condensed modes omits; 0 if the model has it. And a comment. */
double cli_speeding_tension(const struct cli_model *model, double omega);
void cli_speeding_comment(struct hawser__table *table, const struct cli_model *model, double omega);
/* Say it on standard error, also with --quiet, and in `warnings` of the JSON that is written next. */
void cli_warn(const char *warning);
/* The same, and in its picture a few words. */
void cli_caution(const char *brief, const char *warning);
/* A file of --vtk, or NULL: its name, and that it can be written. */
enum hawser_status cli_vtk_check(const char *path, const char *command,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
/* Warn of implausible quantities of the scene (plausible.h). */
void cli_warn_doubts(const struct hawser_scene *scene);
/* Vortices of a wind that no mode of the model can follow: that of their frequency has about the number
 * of a string's. */
void cli_warn_wake(const struct hawser_scene *scene, const struct hawser_statics *statics);
enum { CLI_WARNING_SIZE = 1000 };

/* --- signals.c --- */

/* From this call on, Ctrl-C, SIGTERM and SIGHUP set cli_interrupted to the signal. The program is ended
 * 0.6 s later, unless it is writing results. Called once, from main. */
void cli_catch_interrupts(void);
int cli_interrupted(void);
/* Results are being written: to files (1), or to standard output (0), perhaps an unread pipe. */
void cli_writing(int to_files);
/* The file `path` is complete (NULL and "-" are no files). The message of an interrupt then does not
 * say that nothing was written. */
void cli_written(const char *path);

/* --- statics_curves.c: one cable at different tensions --- */

/* Several static models for the same cable, and the equilibria of the cable as its tension varies. */
struct cli_curves {
	int models, points; /* the first `models` rows of the library's table */
	struct hawser_statics *here;       /* [models] for the scene's given quantity */
	enum hawser_status *status;        /* [models] status of that equilibrium */
	struct hawser_report *report;      /* [models] reason why there is none */
	struct hawser_statics *curve;      /* [models][points] over the horizontal tension, ascending */
};
/* from, to: N, or 0 for a range chosen by weight and stiffness. `models`: all of the table, or 1. */
enum hawser_status cli_curves_fill(struct cli_curves *curves, const struct hawser_scene *scene,
                                   int models, int points, double from, double to,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_curves_clear(struct cli_curves *curves);
void cli_models_rows(struct hawser__table *table, const struct cli_curves *curves);
enum hawser_status cli_compatibility_draw(const char *path, const struct cli_curves *curves,
                                          struct hawser_report *report);
enum hawser_status cli_models_draw(const char *path, const struct cli_curves *curves,
                                   struct hawser_report *report);

/* --- statics_speeds.c: one cable at different travel speeds --- */

enum { CLI_SPEEDS_KINDS = 3 };
struct cli_speeds_curve {
	const char *hold, *name; /* "tension", "slack" */
	int points, folds;       /* 1: ends in a fold, where taut and slack state coincide */
	double to;               /* m/s */
	struct hawser_statics *state; /* [points] as the library has them, by speed */
};
struct cli_speeds {
	struct hawser_span span;
	enum hawser_given given; /* kind of the held tension: H, T0, T1 */
	double value;            /* N */
	double fluctuation, from, to, limit; /* m/s; to 0: chosen automatically */
	int folds;
	struct cli_speeds_curve curve[CLI_SPEEDS_KINDS];
};
/* *speeds is all zero except for from and to. */
enum hawser_status cli_speeds_fill(struct cli_speeds *speeds, const struct hawser_scene *scene,
                                   int points, struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_speeds_clear(struct cli_speeds *speeds);
void cli_speeds_rows(struct hawser__table *table, const struct cli_speeds *speeds);
enum hawser_status cli_speeds_draw(const char *path, const struct cli_speeds *speeds,
                                   struct hawser_report *report);

/* --- *_result.c, *_draw.c: output of large results --- */

struct cli_sweep {
	int direction; /* 1 up, -1 down */
	struct hawser_sweep run;
};
struct cli_mms_result;
struct cli_backbone;
/* A further curve in the picture of a response, with the response's probes and coordinates,
 * scaled. */
struct cli_overlay {
	const char *label;
	int points;
	const double *omega, *probe, *coordinate;
	int beside; /* 0: over the curves, such as a backbone; another response behind them: 1: its stable
	             * parts, 2: the unstable ones. A line has a gap where an amplitude is NAN */
};
enum { CLI_OVERLAYS = 4 };
struct cli_frf_result {
	const struct cli_common *common;
	const char *command;  /* name of the command for the head of the result; NULL: frf */
	const struct cli_mms_result *scales; /* modulation equations, also for the head; or NULL */
	const struct cli_backbone *backbone; /* or NULL */
	const struct cli_overlay *overlay; /* [overlays] for the picture */
	const struct hawser_tori *tori; /* [curves] frf --tori (frf_tori.h), or NULL */
	const struct cli_model *model;
	const struct hawser_frf *frf;
	const struct hawser_landmark *peak; /* [peaks] */
	int highest; /* peaks that stand on a terminal in place of the points; 0: those points */
	int peaks, located; /* located: 1: peaks were searched for; the list may be empty */
	const struct cli_sweep *sweep; /* [sweeps] */
	int sweeps, overlays, curves;
	double from, to; /* scaled */
	const struct cli_over *over; /* frf --over: the parameter, or NULL */
	struct cli_model_error error;
	struct cli_certificate *certificate; /* model/certificate.h, or NULL */
	int multipliers; /* in JSON too */
	int direction;   /* direction of Omega at the last point: 1, -1; 0: no point */
	const char *scale; /* "auto", "linear", "log" */
	const struct cli_frf_result *other; /* [others] further branches (frf_cover.h) */
	const double *gap; /* [gaps][2] scaled Omega: parts of the range in which no branch was found */
	const struct cli_missed *missed; /* [misses] what was not followed (frf_cover.h) */
	int others, gaps, misses, label_every; /* label_every: 0: of events alone */
	int observed;   /* most unstable multipliers of further branches, not asked for; 0: no limit */
	int unsearched; /* 1: further branches are not searched for, since the model is too far off */
	int chosen;     /* 1: the motion at which it begins was given */
	int costly;     /* 1: the search for them ended at its limit of work */
	double allowed; /* that of the curve and that of further branches, s */
};
/* "Omega = 1.4 rad/s" of a point at `omega` (scaled), or "damping.alpha = 0.1 kg/m/s" with --over. */
struct cli_place {
	char text[120];
};
struct cli_place cli_frf_place(const struct cli_frf_result *result, double omega, double parameter);
/* The value of the member `direction` of a result. */
int cli_frf_direction(const struct hawser_frf *frf);
/* Warning k about a result, from 0: slackness, parts of the range without a branch and the like
 * (frf_notes.c). 1: text [size] is it; 0: there is nothing to say; -1: no further k. */
int cli_frf_note(char *text, size_t size, const struct cli_frf_result *result, int k);
/* Say all that is warned of. */
void cli_frf_warn(struct cli_model *model, const struct cli_frf_result *result);
/* Whether the model has damping: without it stability is undecided everywhere. */
int cli_frf_damped(const struct cli_frf_result *result);
void cli_frf_peak_comments(struct hawser__table *table, const struct cli_frf_result *result);
void cli_frf_comments(struct hawser__table *table, const void *result);
extern const struct cli_showing cli_frf_showing;
/* A table of the peaks in place of the points. */
struct cli_showing cli_frf_show_peaks(const struct cli_frf_result *result);
/* Number of peaks of displacements, of all branches. */
int cli_frf_displacements(const struct cli_frf_result *result);
enum hawser_status cli_frf_draw(const char *path, const void *result, struct hawser_report *report);
/* Write "Amplitude of z, mid-span (m)" in gnuplot's markup; probes may have any name. */
void cli_probe_label(char *label, size_t size, char component, const char *probe, const char *unit);

#endif
