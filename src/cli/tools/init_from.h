/* cli/tools/init_from.h - scenes from the input files of other programs for moorings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_INIT_FROM_H
#define HAWSER_CLI_INIT_FROM_H

#include <stdio.h>

#include <hawser/status.h>

/* Write to standard output the scene of kind `net` of a file of MoorDyn (version 2) or MoorPy. What
 * scenes cannot say is named on standard error. HAWSER_ERR_SCENE with the line for a wrong file. */
enum hawser_status cli_init_from(const char *path, struct hawser_report *report) HAWSER_MUST_CHECK;

/* What such a file has, in its own axes: z upwards. */
enum { CLI_MOORING_NAME = 32, CLI_MOORING_PATH = 1024 };
struct cli_mooring_type {
	char name[CLI_MOORING_NAME];
	double diameter, mass, EA;   /* m, kg/m, N */
	double dynamic;              /* N: EA of quick motions; 0: none */
	double BA;                   /* N s; negative: minus the damping ratio of an element */
	double normal, tangential;   /* coefficients of drag */
	double added_normal, added_tangential;
};
struct cli_mooring_body {
	int id, moves;        /* moves: 1: a rigid body; 0: its points are supports */
	double x[3], mass, centre[3], inertia[3]; /* centre: from x; inertia about it */
	double volume, CdA, added; /* of a sphere at x */
};
struct cli_mooring_point {
	int id, held, body;   /* body: 1 + index; 0: none */
	double x[3], mass, volume, CdA, added;
};
struct cli_mooring_line {
	int id, type, end[2]; /* type, points: indices */
	double length;
	int elements;
};
struct cli_mooring_failure {
	int line, point;      /* indices */
	double time, tension; /* s, N; 0: not by it */
};
struct cli_mooring {
	const char *path;
	int number;           /* of the line that is read */
	struct cli_mooring_type *type;
	struct cli_mooring_body *body;
	struct cli_mooring_point *point;
	struct cli_mooring_line *line;
	struct cli_mooring_failure *failure;
	int types, bodies, points, lines, failures;
	double g, density, depth, stiffness, damping, friction; /* depth: NAN: not given */
	char bed[CLI_MOORING_PATH]; /* file of the bathymetry, "": none */
};
/* init_write.c. _bed: the file of the bathymetry, as an option has it or beside the file of the
 * mooring; 0: none can be read. */
int cli_mooring_bed(struct cli_mooring *mooring, const char *name);
/* The scene, whose text the caller frees; if it cannot be read as it is, standard error says why. */
enum hawser_status cli_mooring_scene(char **text, size_t *size, const struct cli_mooring *mooring,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
