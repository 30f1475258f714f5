/* bench/kernel-cable.c - forces and tangents of cables from tensors and from functions
 * (rom/energy/quartic.h): measured times, and the estimates by which rom/energy/effort.c chooses
 * between the two. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/rom.h>
#include "bench/clock.h"
#include "bench/kernel.h"
#include "rom/energy/kernel.h"
#include "rom/energy/quartic.h"

enum { states = 32, turns = 3 };
static const double time_limit_secs = 0.02; /* of each timing */
static const double error_allowed = 1e-13;  /* relative to the largest component */

static const struct cable {
	const char *name, *text;
	int most; /* coordinates */
} cables[] = {
	{"chairlift, raw", "cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, h: 10 m}\n"
	 "tension: {T0: 80 kN}\nload: {frame: local, per_length: [0.8 N/m, 0.8, 0.8]}\n"
	 "damping: {alpha: 0.08 kg/m/s}\nmodel: {condense: none}\n", 60},
	{"chairlift, condensed", "cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, h: 10 m}\n"
	 "tension: {T0: 80 kN}\nload: {frame: local, per_length: [0.8 N/m, 0.8, 0.8]}\n"
	 "damping: {alpha: 0.08 kg/m/s}\nmodel: {condense: static}\n", 60},
	{"deep sag, condensed", "cable: {EA: 60 MN, rho: 3 kg/m}\nspan: {d: 200 m, h: 5 m}\n"
	 "tension: {sag: 40 m}\nload: {frame: global, per_length: [0, 0.8 N/m, 0.8 N/m]}\n"
	 "damping: {alpha: 0.06 kg/m/s}\nmodel: {condense: static}\n", 40},
};

static const int sizes[] = {5, 9, 16, 20, 30, 40, 60};

/* What is timed. */
struct bench {
	const struct hawser_rom *rom;
	double *u, *force, *tangent, *work;
};

static enum hawser_status model(struct hawser_rom *rom, const struct cable *cable, int n,
                                struct hawser_report *report)
{
	struct hawser_scene scene;
	struct hawser_statics statics;
	struct hawser_modes modes = {.n = 0};
	struct hawser_modes_options options = {.n = n};
	char text[512];
	FILE *stream;
	enum hawser_status status;

	snprintf(text, sizeof text, "%s", cable->text);
	stream = fmemopen(text, strlen(text), "r");
	if (!stream)
		return HAWSER_ERR_MEMORY;
	status = hawser_scene_read(&scene, stream, cable->name, NULL, 0, report);
	fclose(stream);
	if (status)
		return status;
	if (!(status = hawser_statics_scene(&statics, &scene, report)) &&
	    !(status = hawser_modes_solve(&modes, &statics, &options, report)) &&
	    !(status = hawser_rom_build(rom, &modes, &scene, report)) && rom->kernel->rows == 0) {
		/* compile the tensors beside the functions */
		struct hawser__quartic *quartic = rom->kernel->quartic;
		struct hawser__size size = rom->kernel->size;

		rom->kernel->quartic = NULL;
		status = hawser_rom_compile(rom, report);
		rom->kernel->quartic = quartic;
		rom->kernel->size = size;
	}
	hawser_modes_clear(&modes);
	hawser_scene_clear(&scene);
	return status;
}

static void take(const struct hawser_rom *rom, int by_function)
{
	for (int task = 0; task < HAWSER__TASKS; task++)
		rom->kernel->by_function[task] = by_function;
}

static void perform(const struct bench *b, enum hawser__effort_task task)
{
	size_t n = (size_t)b->rom->n;

	if (task == HAWSER__FORCES || task == HAWSER__TANGENTS) {
		hawser__rom_tangents(b->rom, b->force, task == HAWSER__TANGENTS ? b->tangent : NULL,
		                     b->u, states, b->work);
		return;
	}
	for (size_t s = 0; s < states; s++) {
		if (task == HAWSER__TANGENT)
			hawser_rom_tangent(b->rom, b->force + s*n, b->tangent + s*n*n, b->u + s*n);
		else
			hawser_rom_restoring(b->rom, b->force + s*n, b->u + s*n);
	}
}

/* Nanoseconds of processor time a state. */
static double timing(const struct bench *b, enum hawser__effort_task task)
{
	double best = INFINITY;

	for (int turn = 0; turn < turns; turn++) {
		double start = cpu_secs(), spent = 0.0;
		long calls = 0;

		for (; spent < time_limit_secs; spent = cpu_secs() - start, calls++)
			perform(b, task);
		best = fmin(best, 1e9*spent/((double)calls*states));
	}
	return best;
}

static double apart(const double *x, const double *y, size_t count)
{
	double worst = 0.0, largest = 0.0;

	for (size_t i = 0; i < count; i++) {
		worst = fmax(worst, fabs(x[i] - y[i]));
		largest = fmax(largest, fabs(y[i]));
	}
	return worst/largest;
}

/* Largest difference of forces and tangents. */
static double disagreement(struct bench *b)
{
	size_t n = (size_t)b->rom->n, forces = states*n, tangents = forces*n;
	double *kept = malloc((forces + tangents)*sizeof *kept), worst = INFINITY;

	if (!kept)
		return worst;
	take(b->rom, 0);
	perform(b, HAWSER__TANGENT);
	memcpy(kept, b->force, forces*sizeof *kept);
	memcpy(kept + forces, b->tangent, tangents*sizeof *kept);
	take(b->rom, 1);
	perform(b, HAWSER__TANGENT);
	worst = fmax(apart(b->force, kept, forces), apart(b->tangent, kept + forces, tangents));
	perform(b, HAWSER__FORCE);
	worst = fmax(worst, apart(b->force, kept, forces));
	free(kept);
	return worst;
}

static void show(const struct bench *b, const char *name, int n, double error)
{
	static const char *const task_name[] = {"force", "tangent", "forces", "tangents"};
	const struct hawser__size *size = &b->rom->kernel->size;
	struct hawser__effort estimate;

	hawser__effort(&estimate, size);
	printf("  %s, %d modes: %d coordinates, %d points, %d entries, error %.1e\n", name, n, b->rom->n,
	       size->points, b->rom->quads + b->rom->cubics, error);
	for (int task = 0; task < HAWSER__TASKS; task++) {
		double tensors, functions;

		take(b->rom, 0);
		tensors = timing(b, task);
		take(b->rom, 1);
		functions = timing(b, task);
		printf("    %-9s %8.3f us from tensors (%8.3f) %8.3f from functions (%8.3f) %6.2f "
		       "times (%6.2f)%s\n", task_name[task], 1e-3*tensors, 1e-3*estimate.tensors[task],
		       1e-3*functions, 1e-3*estimate.functions[task], tensors/functions,
		       estimate.tensors[task]/estimate.functions[task],
		       (estimate.functions[task] < estimate.tensors[task] ? functions : tensors) >
		       1.25*fmin(functions, tensors) ? "  wrong choice" : "");
	}
}

static int run(const struct cable *cable, int n)
{
	struct hawser_rom rom = {.n = 0};
	struct hawser_report report = {.message = ""};
	struct bench b = {.rom = &rom};
	uint64_t seed = 88172645463325252u;
	double error = INFINITY;
	size_t size;

	if (model(&rom, cable, n, &report)) {
		fprintf(stderr, "kernel: %s: %s\n", cable->name, report.message);
		return 0;
	}
	size = states*(size_t)rom.n;
	b.u = malloc(size*sizeof *b.u);
	b.force = malloc(size*sizeof *b.force);
	b.tangent = malloc(size*(size_t)rom.n*sizeof *b.tangent);
	b.work = malloc((hawser__rom_tangents_work(&rom, states) + 1)*sizeof *b.work);
	if (b.u && b.force && b.tangent && b.work) {
		for (size_t i = 0; i < size; i++) {
			seed = seed*6364136223846793005u + 1442695040888963407u;
			b.u[i] = 2e-3*((double)(seed >> 11)/4503599627370496.0 - 1.0);
		}
		error = disagreement(&b);
		if (error < error_allowed)
			show(&b, cable->name, n, error);
	}
	free(b.u);
	free(b.force);
	free(b.tangent);
	free(b.work);
	hawser_rom_clear(&rom);
	return error < error_allowed;
}

int bench_cables(void)
{
	int good = 1;

	puts("kernel: from tensors and from functions, time a state (in parentheses the estimates)");
	for (size_t c = 0; c < sizeof cables/sizeof *cables; c++)
		for (size_t i = 0; i < sizeof sizes/sizeof *sizes; i++)
			if (sizes[i] <= cables[c].most)
				good &= run(&cables[c], sizes[i]);
	return good;
}
