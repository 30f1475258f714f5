/* rom/energy/compile_cable.c - the kernel of a cable's model: tensors, functions, or both.
 *
 * Each task (kernel.h) is done from tensors unless functions are estimated to be faster. If functions
 * are faster in all tasks, the tensors are not compiled; they remain lists, for files, exports and what
 * is computed of single entries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "rom/energy/exact.h"
#include "rom/energy/kernel.h"
#include "rom/energy/quartic.h"

/* Largest estimated time of functions, relative to that of tensors, with which they are taken: the
 * estimates may be wrong by as much (bench/kernel). */
#define WORTH 0.8

/* Which tasks are done by function; returns whether all are. */
static int choose(int by_function[HAWSER__TASKS], const struct hawser__size *size)
{
	struct hawser__effort effort;
	int all = 1;

	hawser__effort(&effort, size);
	for (int task = 0; task < HAWSER__TASKS; task++) {
		by_function[task] = effort.functions[task] < WORTH*effort.tensors[task];
		all = all && by_function[task];
	}
	return all;
}

enum hawser_status hawser__rom_compile_cable(struct hawser_rom *rom,
                                             const struct hawser_modes *modes,
                                             const struct hawser__condensed *condensed,
                                             struct hawser_report *report)
{
	struct hawser__quartic *quartic = NULL;
	int by_function[HAWSER__TASKS] = {0}, bare = 0;
	struct hawser__size size = {0};
	/* its tables are those of two planes, which a cable in space does not have */
	enum hawser_status status = modes->statics.space
		? HAWSER_OK : hawser__quartic_new(&quartic, rom, modes, condensed, report);

	if (status)
		return status;
	if (quartic) {
		size = (struct hawser__size){rom->n, quartic->moving_in, quartic->moving_out,
		                             quartic->points, quartic->condensed, rom->cubics};
		bare = choose(by_function, &size);
	}
	status = hawser__rom_compile(rom, bare, report);
	if (status) {
		hawser__quartic_free(quartic);
		return status;
	}
	rom->kernel->quartic = quartic;
	rom->kernel->size = size;
	memcpy(rom->kernel->by_function, by_function, sizeof by_function);
	return HAWSER_OK;
}

/* --- as text --- */

struct line {
	char *text;
	size_t size, length;
};

static void say(struct line *line, const char *format, ...) HAWSER_PRINTF(2, 3);

static void say(struct line *line, const char *format, ...)
{
	va_list args;
	int more;

	va_start(args, format);
	more = vsnprintf(line->text + line->length, line->size - line->length, format, args);
	va_end(args);
	if (more > 0)
		line->length += (size_t)more;
	if (line->length >= line->size)
		line->length = line->size - 1;
}

/* The tasks that are done by function, or not; with how much faster functions are. */
static void list(struct line *line, const struct hawser_rom_kernel *kernel, int by_function)
{
	static const char *const name[HAWSER__TASKS] = {
		"one force", "one tangent", "many forces", "many tangents",
	};
	struct hawser__effort effort;
	int count = 0;

	hawser__effort(&effort, &kernel->size);
	for (int task = 0; task < HAWSER__TASKS; task++) {
		if (kernel->by_function[task] != by_function)
			continue;
		say(line, "%s%s", count++ ? ", " : "", name[task]);
		if (by_function)
			say(line, " %.2g times", effort.tensors[task]/effort.functions[task]);
	}
}

void hawser_rom_forces_text(const struct hawser_rom *rom, char *text, size_t size)
{
	const struct hawser_rom_kernel *kernel = rom->kernel;
	struct line line = {text, size, 0};
	int functions = 0;

	*text = '\0';
	if (rom->exact) {
		say(&line, "from strains at %d points of the cable, without expansion", rom->exact->points);
		return;
	}
	if (!kernel)
		return;
	for (int task = 0; task < HAWSER__TASKS; task++)
		functions += kernel->by_function[task];
	if (!kernel->quartic || functions == 0) {
		say(&line, "from tensors%s", kernel->quartic ? ", which is faster with so few modes" : "");
		return;
	}
	say(&line, "from strains at %d points of the cable where that is faster (", kernel->size.points);
	list(&line, kernel, 1);
	say(&line, ")%s", functions < HAWSER__TASKS ? ", else from tensors (" : "");
	if (functions == HAWSER__TASKS)
		return;
	list(&line, kernel, 0);
	say(&line, ")");
}
