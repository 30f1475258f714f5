/* cli/tools/init_write.c - the scene of a mooring file. Its axes x, y, z with z upwards become x,
 * -z, y. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cli/frame/cli.h"
#include "cli/tools/init_from.h"
#include "core/file.h"
#include "core/report.h"

static void nodes(FILE *stream, const struct cli_mooring *mooring)
{
	fprintf(stream, "nodes:                    # [x, y, z] m; y is upwards\n");
	for (int i = 0; i < mooring->points; i++) {
		const struct cli_mooring_point *point = &mooring->point[i];

		fprintf(stream, "  P%d: [%.12g, %.12g, %.12g]\n", point->id, point->x[0], point->x[2],
		        0.0 - point->x[1]);
	}
	for (int i = 0; i < mooring->bodies; i++)
		if (mooring->body[i].moves)
			fprintf(stream, "  B%d: [%.12g, %.12g, %.12g]\n", mooring->body[i].id,
			        mooring->body[i].x[0], mooring->body[i].x[2], 0.0 - mooring->body[i].x[1]);
	fprintf(stream, "supports:\n");
	for (int i = 0; i < mooring->points; i++)
		if (mooring->point[i].held)
			fprintf(stream, "  P%d: fixed\n", mooring->point[i].id);
}

/* Masses and floats; a support needs neither. */
static void buoys(FILE *stream, const struct cli_mooring *mooring)
{
	int first = 1;

	for (int i = 0; i < mooring->points; i++) {
		const struct cli_mooring_point *point = &mooring->point[i];

		if (point->held || (point->mass == 0.0 && point->volume == 0.0 && point->CdA == 0.0))
			continue;
		if (first)
			fprintf(stream, "buoys:                    # kg, m^3, m^2\n");
		first = 0;
		fprintf(stream, "  P%d: {mass: %.12g, volume: %.12g, CdA: %.12g, added_mass: %.12g}\n",
		        point->id, point->mass, point->volume, point->CdA, point->added);
	}
	for (int i = 0; i < mooring->bodies; i++) {
		const struct cli_mooring_body *body = &mooring->body[i];

		if (body->moves)
			fprintf(stream, "%s  B%d: {volume: %.12g, CdA: %.12g, added_mass: %.12g}\n",
			        first ? "buoys:                    # m^3, m^2\n" : "", body->id, body->volume,
			        body->CdA, body->added);
		first = first && !body->moves;
	}
}

/* The z of MoorDyn is up, y here: the moments about x, y and z are those about its x, z and y. */
static void bodies(FILE *stream, const struct cli_mooring *mooring)
{
	int first = 1;

	for (int i = 0; i < mooring->bodies; i++) {
		const struct cli_mooring_body *body = &mooring->body[i];
		const double *J = body->inertia;

		if (!body->moves)
			continue;
		fprintf(stream, "%s  body%d:\n    nodes: [B%d", first ? "bodies:\n" : "", body->id, body->id);
		first = 0;
		for (int p = 0; p < mooring->points; p++)
			if (mooring->point[p].body == i + 1)
				fprintf(stream, ", P%d", mooring->point[p].id);
		fprintf(stream, "]\n    mass: %.12g\n    centre: [%.12g, %.12g, %.12g]\n", body->mass,
		        body->x[0] + body->centre[0], body->x[2] + body->centre[2],
		        0.0 - body->x[1] - body->centre[1]);
		if (J[0] + J[1] + J[2] > 0.0)
			fprintf(stream, "    inertia: [%.12g, %.12g, %.12g]\n", J[0], J[2], J[1]);
	}
}

/* Time (s) of damping: EA times it is BA; of a damping ratio, that of an element that oscillates. */
static double axial(const struct cli_mooring_type *type, const struct cli_mooring_line *line)
{
	if (type->BA >= 0.0)
		return type->BA/type->EA;
	return -type->BA*line->length/line->elements*sqrt(type->mass/type->EA);
}

static void cables(FILE *stream, const struct cli_mooring *mooring)
{
	fprintf(stream, "cables:                   # N, kg/m, m; axial: damping in s\n");
	for (int i = 0; i < mooring->lines; i++) {
		const struct cli_mooring_line *line = &mooring->line[i];
		const struct cli_mooring_type *type = &mooring->type[line->type];

		fprintf(stream, "  - {name: L%d, from: P%d, to: P%d, length0: %.12g, elements: %d,\n", line->id,
		        mooring->point[line->end[0]].id, mooring->point[line->end[1]].id, line->length,
		        line->elements);
		if (type->dynamic > 0.0)
			fprintf(stream, "     EA: {static: %.12g, dynamic: %.12g, viscosity: %.12g}, ", type->EA,
			        type->dynamic, type->BA);
		else
			fprintf(stream, "     EA: %.12g, axial: %.6g, ", type->EA, axial(type, line));
		fprintf(stream, "rho: %.12g, diameter: %.12g,\n"
		        "     drag: {normal: %.12g, tangential: %.12g},\n"
		        "     added_mass: {normal: %.12g, tangential: %.12g}}  # %s\n", type->mass,
		        type->diameter, type->normal, type->tangential, type->added_normal,
		        type->added_tangential, type->name);
	}
}

static void failures(FILE *stream, const struct cli_mooring *mooring)
{
	if (mooring->failures)
		fprintf(stream, "failures:\n");
	for (int i = 0; i < mooring->failures; i++) {
		const struct cli_mooring_failure *failure = &mooring->failure[i];
		int timed = failure->time > 0.0;

		fprintf(stream, "  - {cable: L%d, at: P%d, %s: %.12g}\n", mooring->line[failure->line].id,
		        mooring->point[failure->point].id, timed ? "time" : "tension",
		        timed ? failure->time : failure->tension);
	}
}

int cli_mooring_bed(struct cli_mooring *mooring, const char *name)
{
	const int folder = (int)(hawser__file_name(mooring->path) - mooring->path);
	FILE *file = NULL;

	for (int beside = 0; beside < 2 && !file && !strpbrk(name, "\"\\"); beside++) {
		int length = snprintf(mooring->bed, sizeof mooring->bed, "%.*s%s", beside ? folder : 0,
		                      mooring->path, name);

		file = (size_t)length < sizeof mooring->bed ? fopen(mooring->bed, "r") : NULL;
	}
	if (file)
		fclose(file);
	return file != NULL;
}

static void write_scene(FILE *stream, const struct cli_mooring *mooring)
{
	int deep = !isnan(mooring->depth);

	fprintf(stream, "# The mooring of %s. Try: hawser statics SCENE --plot SCENE.svg\n"
	        "# Of the file's axes, x is x, z is y, and y is -z here. Every key: man hawser-scene.\n"
	        "kind: net\ng: %.12g\n", hawser__file_name(mooring->path), mooring->g);
	fprintf(stream, "water:\n  density: %.12g\n", mooring->density);
	if (deep)
		fprintf(stream, "  depth: %.12g\n", mooring->depth);
	nodes(stream, mooring);
	buoys(stream, mooring);
	cables(stream, mooring);
	bodies(stream, mooring);
	failures(stream, mooring);
	if (*mooring->bed)
		fprintf(stream, "obstacles:\n  - {name: bed, grid: \"%s\"", mooring->bed);
	else if (deep)
		fprintf(stream, "obstacles:\n  - {name: bed, plane: {point: [0, %.12g], normal: [0, 1]}",
		        -mooring->depth);
	else
		return;
	if (mooring->stiffness > 0.0)
		fprintf(stream, ", stiffness: %.12g", mooring->stiffness);
	if (mooring->stiffness > 0.0 && mooring->damping > 0.0)
		fprintf(stream, ", damping: %.12g", mooring->damping);
	if (mooring->friction > 0.0)
		fprintf(stream, ", friction: %.12g", mooring->friction);
	fprintf(stream, "}\n");
}

/* Say why the scene that was made cannot be read as it is, such as a bathymetry that is none. */
static enum hawser_status check_scene(char *text, size_t size, struct hawser_report *report)
{
	FILE *stream = fmemopen(text, size, "r");
	struct hawser_document document = {.text = NULL};
	struct hawser_net net = {.nodes = 0};
	struct hawser_report why = {.message = ""};
	char all[CLI_WARNING_SIZE];
	enum hawser_status status = stream ? hawser_document_read(&document, stream, "scene", &why)
	                                   : HAWSER_ERR_MEMORY;

	if (!status)
		status = hawser_net_of(&net, &document, NULL, 0, &why);
	hawser_net_clear(&net);
	hawser_document_clear(&document);
	if (stream)
		fclose(stream);
	if (status == HAWSER_ERR_MEMORY)
		return hawser__no_memory(report, "init");
	snprintf(all, sizeof all, "mend the scene by hand: %s", why.message);
	if (status)
		cli_warn(all);
	return HAWSER_OK;
}

enum hawser_status cli_mooring_scene(char **text, size_t *size, const struct cli_mooring *mooring,
                                     struct hawser_report *report)
{
	FILE *stream = open_memstream(text, size);

	if (stream)
		write_scene(stream, mooring);
	return stream && fclose(stream) == 0 ? check_scene(*text, *size, report)
	                                     : hawser__no_memory(report, "init");
}
