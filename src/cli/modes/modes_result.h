/* cli/modes/modes_result.h - modes of a cable, at rest or travelling, as a table, as JSON and as
 * a picture. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_RESULT_H
#define HAWSER_CLI_MODES_RESULT_H

#include <hawser/campbell.h>
#include <hawser/net.h>
#include <hawser/obstacles.h>
#include <hawser/ropeway_modes.h>

#include "cli/frame/cli.h"
#include "cli/frame/view.h"
#include "cli/model/key_sweep.h"
#include "output/fields/fields.h"
#include "output/structures/structures.h"

/* --- modes_ropeway.c: hawser modes of a scene of kind `ropeway`, and what modes of a span over
 * obstacles share with it --- */

enum { CLI_MODES_SPAN = 2*HAWSER_ROPEWAY_NAME + 4 };

/* A span between two towers of a lane. */
struct cli_modes_span {
	const char *lane, *label; /* label is name */
	char name[CLI_MODES_SPAN]; /* "p0 to p1" */
};

struct cli_ropeway_modes {
	const struct cli_common *common;
	struct hawser_ropeway ropeway;    /* empty if it is a span over obstacles */
	struct hawser_ropeway_statics st; /* the same */
	struct hawser_line_modes modes;
	struct hawser_line_freedom freedom[HAWSER_ROPEWAY_FREEDOMS]; /* [modes.freedoms] */
	int lanes, towers, spans;
	struct cli_modes_span *span; /* [spans] of both lanes */
	double *share;               /* [modes.n][spans] of the kinetic energy */
	int points;                  /* of a lane in shapes; 0: none */
	int rows;                    /* lanes*points */
	double *S, *x, *y;           /* [rows] m */
	const char **lane;           /* [rows] */
	double *shape;               /* [rows][modes.n][parts of P, Q, B] */
};

/* How a scene of kind ropeway is opened: options of the command line, or NULL: as the scene says. */
struct cli_ropeway_choice {
	const char *contact, *load_case, *sliding;
};
/* Open the scene of the command line, with these choices in it; *load_case is an index. */
enum hawser_status cli_ropeway_open(struct hawser_ropeway *ropeway, int *load_case,
                                    const struct cli_common *common, const char *command,
                                    const struct cli_ropeway_choice *choice,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* n: number of modes, 0 for the default; points: of a lane in shapes, 0: none. */
enum hawser_status cli_modes_ropeway(const struct cli_common *common,
                                     const struct cli_ropeway_choice *choice, int n, int points,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Points of all lanes, equidistant in S, and the shapes at them: of->rows and what is [rows]. */
enum hawser_status cli_ropeway_shapes(struct cli_ropeway_modes *of,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Comments on grid and shapes. */
void cli_ropeway_modes_comments(struct hawser__table *table, const struct cli_ropeway_modes *of);
/* Draw: what the picture has of the modes and of the spans is filled in. */
enum hawser_status cli_ropeway_modes_draw(const char *path,
                                          struct hawser__ropeway_modes_picture *picture,
                                          const struct cli_ropeway_modes *of,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* Release what a result has, but for ropeway, st and modes. */
void cli_ropeway_modes_free(struct cli_ropeway_modes *of);

/* modes_ropeway_fields.c */
extern const struct hawser__list cli_modes_ropeway_list, cli_modes_ropeway_points;
extern const struct hawser__field cli_modes_ropeway_field[], cli_modes_ropeway_point[],
                                  cli_modes_ropeway_member[], cli_modes_ropeway_shapes[],
                                  cli_modes_ropeway_stats[];
/* Bits of the view. */
enum { CLI_MODES_RUNS = 1, CLI_MODES_REST = 2, CLI_MODES_SHAPES = 4, CLI_MODES_LOOP = 8,
       CLI_MODES_ROPEWAY = 16 };

struct cli_modes_result {
	const struct cli_common *common;
	const char *view; /* of the picture: "components", "profile" or "waves" */
	struct hawser_scene scene;
	struct hawser_modes modes; /* complex if the cable travels */
	int points;    /* of a shape; 0: no shapes in table and JSON */
	double *S;     /* [points] m */
	double *shape; /* [points][n][parts] see cli_modes_sample */
};
/* S and shape, where there are points. */
enum hawser_status cli_modes_sample(struct cli_modes_result *result,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct cli_showing cli_modes_showing;

/* --- campbell_result.c: a Campbell diagram as table, JSON and picture --- */

struct cli_campbell_result {
	const struct cli_common *common;
	struct hawser_scene scene;
	struct hawser_campbell campbell;
	int hertz;      /* unit of table and picture */
	double spacing; /* m */
	int harmonics;  /* number of excitation lines; 0 without a spacing */
	struct hawser_campbell_resonance *resonance; /* [resonances] */
	int resonances;
};

/* Convert rad/s to the unit of the table. */
double cli_campbell_in_unit(const struct cli_campbell_result *result, double omega);
extern const struct cli_showing cli_campbell_showing;
/* Title of the axis of speed, re or im. */
struct hawser__axis cli_campbell_axis(const char *column,
                                      const struct cli_campbell_result *result);
enum hawser_status cli_campbell_draw(const char *path, const void *result,
                                     struct hawser_report *report);
void cli_campbell_free(struct cli_campbell_result *result);

/* --- irvine_result.c: a sweep of the tension as table, JSON and picture --- */

enum cli_irvine_unit { CLI_NORMALISED = 0, CLI_RAD_S, CLI_HZ, CLI_PERIOD, CLI_IRVINE_UNITS };
enum { CLI_IRVINE_SPEEDS = 12 };
extern const char *const cli_irvine_units[]; /* "rad/s" */

/* A sweep, and the analytic frequencies that the picture shows with it. */
struct cli_irvine_sweep {
	struct hawser_irvine irvine;
	int overlays;     /* curves of the analytic method: the places in each plane that the branches
	                   * have somewhere; 0 without a picture, or without such a method */
	double *analytic; /* [stations][overlays] rad/s, NAN where no branch has the place */
};

struct cli_irvine_result {
	const struct cli_common *common;
	struct hawser_scene scene;
	int sweeps;             /* one sweep for each speed */
	int moving;             /* 1: the cable travels in one of them, or --speeds is given */
	struct cli_irvine_sweep sweep[CLI_IRVINE_SPEEDS]; /* [sweeps] */
	enum cli_irvine_unit unit;
	struct hawser_statics own; /* of the scene itself; H = 0: it has none */
	int over_value;         /* abscissa of the picture: 1: the swept quantity, 0: lambda */
};

/* "N" or "m" */
const char *cli_irvine_si(enum hawser_given sweep);
/* Convert rad/s at the tension H (N) to the unit of the table. */
double cli_irvine_in_unit(const struct cli_irvine_result *result, double omega, double H);
/* The actual H of a station. */
double cli_irvine_tension(const struct hawser_irvine_station *station);
/* 1 if there is an analytic method for this motion. */
int cli_irvine_has_analytic(const struct hawser_irvine *irvine);
/* Frequencies by the analytic method, for the picture. */
enum hawser_status cli_irvine_overlay(struct cli_irvine_result *result,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct cli_showing cli_irvine_showing;
enum hawser_status cli_irvine_draw(const char *path, const void *result,
                                   struct hawser_report *report);
void cli_irvine_free(struct cli_irvine_result *result);

/* --- modes_damped.c: damped modes of one span, or over a key of its scene --- */

/* Where the least damped of modes 1 to `modes` of a plane is damped most. */
struct cli_damped_best {
	double value, ratio; /* of the key, in SI; of critical */
	int plane, modes;
	int number;          /* the least damped mode */
	int end;             /* 1: the value is an end of the range */
};

struct cli_damped_result {
	const struct cli_common *common;
	struct hawser_scene scene; /* or, of a net: */
	struct hawser_net net;     /* as it was read; cables 0: none */
	struct hawser_damped_sweep sweep; /* without key: one point */
	const char *key; /* NULL: none */
	struct cli_damped_best best[2]; /* [bests] */
	int bests, n;
	int wind;                  /* 1: the scene has one */
	struct cli_key_sweep range; /* its values, in SI; .logarithmic: of --log */
};
/* `over`: as key_sweep.h says, or NULL. The scene, or the net, is loaded. */
enum hawser_status cli_damped_solve(struct cli_damped_result *result, const char *over, int n,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_damped_free(struct cli_damped_result *result);
extern const struct cli_showing cli_damped_showing;
extern const struct hawser__field cli_damped_field[], cli_damped_member[];

/* --- modes_model.c: hawser modes of a reduced model --- */

/* The `n` slowest, or all (n 0). */
enum hawser_status cli_modes_model(const struct cli_common *common, int n,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_modes_model_field[], cli_modes_model_member[];

/* --- modes_net.c: hawser modes of a scene of kind `net` --- */

/* n: number of modes, 0 for the default; shapes 1: at the nodes of the mesh in JSON too; vtk: a file,
 * or NULL; contact: in place of contact.modes, or NULL. */
enum hawser_status cli_modes_net(const struct cli_common *common, int n, int shapes, const char *vtk,
                                 const char *contact, struct hawser_report *report) HAWSER_MUST_CHECK;

/* Columns of the table, keys of JSON. */
extern const struct hawser__field cli_modes_net_field[], cli_modes_net_member[];

/* --- modes_obstacles.c: hawser modes of a span over obstacles --- */

/* contact: slip or stick, or NULL: as the scene says. n: number of modes, 0 for the default;
 * points: in shapes, 0: none. */
enum hawser_status cli_modes_obstacles(const struct cli_common *common, const char *contact, int n,
                                       int points, struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_modes_obstacles_member[];

/* --- track_ropeway.c: frequencies of a ropeway, or of a span over obstacles, along a sweep:
 * modes --over, campbell, irvine --- */

enum cli_swept {
	CLI_SWEPT_SPEED,   /* campbell */
	CLI_SWEPT_TENSION, /* irvine: what the scene gives in bottom.tension */
	CLI_SWEPT_KEY      /* modes --over */
};

struct cli_track {
	const struct cli_common *common;
	const char *command;
	enum cli_swept swept;
	int obstacles;              /* 1: the scene is a span over obstacles; swept is CLI_SWEPT_KEY */
	const char *from, *to;      /* NULL: the default */
	int points, n;              /* 0: the default */
	const char *over;           /* KEY=FROM:TO:POINTS */
	int logarithmic;
	const char *unit;           /* "rad/s", "Hz" or NULL: Hz */
	const char *spacing;        /* of campbell: NULL: of the scene */
	int harmonics;
	struct cli_ropeway_choice choice;
	/* set by cli_track_run */
	struct hawser_ropeway ropeway; /* of the scene as it is */
	struct hawser_obstacles span;  /* or this one */
	struct hawser_ropeway_track track;
	int load_case, hertz;
	struct cli_key_sweep sweep; /* of what is swept: a name, its unit in the table, the values */
	char (*name)[CLI_MODES_SPAN]; /* [lanes*(towers + 1)] of the spans: "p0 to p1" */
	struct hawser_campbell_resonance *resonance; /* [resonances] with the passing of carriers */
	int resonances;
	double distance;            /* m, between carriers; 0: none */
};
enum hawser_status cli_track_run(struct cli_track *track,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

/* track_fields.c */
unsigned cli_track_view(const struct cli_track *track);
extern const struct hawser__field cli_track_field[], cli_track_member[];
extern const struct hawser__list cli_track_rows;
enum hawser_status cli_track_name_spans(struct cli_track *track,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
