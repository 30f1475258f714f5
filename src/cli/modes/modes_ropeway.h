/* cli/modes/modes_ropeway.h - hawser modes of a scene of kind `ropeway`, and what modes of a span over
 * obstacles share with it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_ROPEWAY_H
#define HAWSER_CLI_MODES_ROPEWAY_H

#include <hawser/ropeway_modes.h>

#include "cli/frame/view.h"
#include "output/structures/plot_ropeway_modes.h"

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

#endif
