/* The whole net in a motion of its model, against the places of its shape points by the model's file:
 * with a load and a support that moves, over one and three periods of the load, and without what the
 * frequency makes of the response. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/document.h>
#include <hawser/net_rom.h>

#include "tests/tap.h"

enum { ROWS = 12, MODES = 4, MOST = 16 }; /* MOST: with those for inertia */

static struct hawser_report report;

struct seen {
	const struct hawser_rom *rom;
	const double *u;
	int periods, rows;
	double rest[3], worst, size; /* m, of node J */
};

/* Node J, whose shape point is the only one with the name of a node. */
static int look(void *data, const struct hawser_net_frame *frame)
{
	struct seen *seen = data;
	const struct hawser_rom_moment moment = {
		.tau = 2.0*M_PI*frame->row*seen->periods/ROWS, .omega = 1e-9};
	double u[3];

	hawser_rom_displacement_at(seen->rom, u, 0, seen->u + frame->row*seen->rom->n, &moment);
	for (int k = 0; k < 3; k++) {
		double here = frame->x[1][k] - u[k]*seen->rom->length;

		if (frame->row == 0)
			seen->rest[k] = here;
		seen->worst = fmax(seen->worst, fabs(here - seen->rest[k]));
		seen->size = fmax(seen->size, fabs(u[k]*seen->rom->length));
	}
	close_to(frame->t, 2.385*frame->row/ROWS, 1e-14, "time");
	close_to(frame->x[2][1], 15.0 + 0.05*cos(moment.tau), 1e-12, "the support");
	seen->rows++;
	return frame->row == ROWS - 2;
}

static const char scene[] =
	"nodes: {A: [0, 0, 0], J: {}, B: [300, 15, 0]}\n"
	"cables:\n"
	"  - {name: c1, from: A, to: J, EA: 1e8, rho: 5.56, length0: 123.85, elements: 8}\n"
	"  - {name: c2, from: J, to: B, EA: 1e8, rho: 5.56, length0: 176.81, elements: 8}\n"
	"supports: {A: fixed, B: {motion: {y: {amplitude: 0.05, multiple: 1}}}}\n"
	"masses: {J: 23.85 kg}\n"
	"loads: {c1: {per_length: [0, 2, 3], harmonic: {multiple: 2, phase: 0.7}}}\n";

static void show(const struct hawser_rom *rom, const struct hawser_net *net,
                 const struct hawser_net_rom_options *options, const double *u, int periods)
{
	struct seen seen = {.rom = rom, .u = u, .periods = periods};
	const struct hawser_net_rom_motion motion = {.u = u, .rows = ROWS, .periods = periods,
		.duration = 2.385, .frame = look, .data = &seen};

	ok(!hawser_net_rom_show(net, options, &motion, &report), "%d periods %s", periods, report.message);
	ok(seen.rows == ROWS - 1, "it ends when told");
	ok(seen.size > 0.5, "J moves by %.3g m", seen.size);
	ok(seen.worst < 1e-9*seen.size, "off by %.1e m", seen.worst);
}

CASE(property_net_show)
{
	const struct hawser_net_rom_options options = {.n = MODES, .raw = 1};
	FILE *file = fmemopen((void *)(size_t)scene, sizeof scene - 1, "r");
	struct hawser_document document;
	struct hawser_net net = {.nodes = 0};
	struct hawser_modes modes;
	struct hawser_rom rom;
	double u[ROWS*MOST];

	ok(!hawser_document_read(&document, file, "show", &report) &&
	   !hawser_net_of(&net, &document, NULL, 0, &report), "scene %s", report.message);
	fclose(file);
	hawser_document_clear(&document);
	if (ok(!hawser_net_rom_build(&rom, &modes, &net, &options, &report), "model %s", report.message) &&
	    ok(rom.n <= MOST && strcmp(rom.shapes.name[0], "J") == 0, "%d coordinates", rom.n)) {
		for (int i = 0; i < ROWS*rom.n; i++)
			u[i] = 0.005*sin(2.385*i + 0.3)/(1 + i%rom.n);
		show(&rom, &net, &options, u, 1);
		show(&rom, &net, &options, u, 3);
	}
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_net_clear(&net);
	return done_testing();
}
