/* examples/frf.c - from a scene file to the folds of its frequency response.
 *
 *     cc frf.c $(pkg-config --cflags --libs hawser) -o frf && ./frf b-table-4.2.yaml 0.9 1.1
 *
 * The two numbers bound the forcing frequency, as multiples of the first natural one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <hawser/hawser.h>

/* The stages in the order of the data. Each takes what the one before it made. */
static enum hawser_status respond(struct hawser_frf *frf, struct hawser_rom *rom,
                                  struct hawser_modes *modes, struct hawser_scene *scene,
                                  const char *path, double from, double to,
                                  struct hawser_report *report)
{
	struct hawser_statics statics;
	struct hawser_modes_options wanted = {.tolerance = 1e-10};
	struct hawser_frf_options options = {.method = NULL};
	enum hawser_status status;

	status = hawser_scene_open(scene, path, NULL, 0, report);
	if (status == HAWSER_OK)
		status = hawser_statics_scene(&statics, scene, report);
	if (status == HAWSER_OK) {
		wanted.n = scene->model.modes;
		status = hawser_modes_solve(modes, &statics, &wanted, report);
	}
	if (status == HAWSER_OK)
		status = hawser_rom_build(rom, modes, scene, report);
	if (status == HAWSER_OK) {
		options.from = from*modes->mode[0].omega;
		options.to = to*modes->mode[0].omega;
		status = hawser_frf_trace(frf, rom, &options, report);
	}
	return status;
}

int main(int argc, char **argv)
{
	struct hawser_scene scene = {0};
	struct hawser_modes modes = {0};
	struct hawser_rom rom = {0};
	struct hawser_frf frf = {0};
	struct hawser_report report;
	enum hawser_status status;

	if (argc != 4) {
		fprintf(stderr, "usage: frf SCENE FROM TO\n");
		return 1;
	}
	status = respond(&frf, &rom, &modes, &scene, argv[1], atof(argv[2]), atof(argv[3]), &report);
	if (status == HAWSER_OK) {
		printf("%d points, stopped: %s\n", frf.points, hawser_frf_end_name(frf.end));
		/* Frequencies in the library are scaled; rom.time is their unit of time in seconds. */
		for (int i = 0; i < frf.events; i++)
			printf("%-15s %.9f rad/s\n", hawser_event_name(frf.event[i].kind),
			       frf.event[i].omega/rom.time);
	} else {
		fprintf(stderr, "frf: %s\n", report.message);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return hawser_status_exit(status);
}
