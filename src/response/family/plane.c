/* response/family/plane.c - the models of a family, multiplied by a factor; see hawser/family.h.
 *
 * A model of the family is asked for at every call, so that it is there as long as one is kept that is
 * made from it. What is kept is made anew where the family has made its model anew. The first model
 * stays to the end: a response that is traced over the first parameter has it as its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/family.h>

#include "core/report.h"

enum { KEPT = 10 };

struct plane {
	const struct hawser_rom_family *family;
	enum hawser_factor factor;
	int place, next;
	struct kept {
		const struct hawser_rom *from;
		double p[2];
		struct hawser_rom_family family; /* over the factor */
		const struct hawser_rom *rom;
	} kept[KEPT];
};

static enum hawser_status model(void *context, const struct hawser_rom **rom, const double p[2],
                                struct hawser_report *report)
{
	struct plane *plane = context;
	const struct hawser_rom *from;
	struct kept *kept = &plane->kept[plane->next];
	enum hawser_status status = plane->family->model(plane->family->context, &from, p[!plane->place],
	                                                 report);

	if (status)
		return status;
	for (int i = 0; i < KEPT; i++)
		if (plane->kept[i].from == from && plane->kept[i].p[0] == p[0] && plane->kept[i].p[1] == p[1]) {
			*rom = plane->kept[i].rom;
			return HAWSER_OK;
		}
	if (kept->from)
		hawser_factor_close(&kept->family);
	*kept = (struct kept){.from = NULL};
	status = hawser_factor_open(&kept->family, from, plane->factor, plane->family->omega, report);
	if (status)
		return status;
	*kept = (struct kept){.from = from, .p = {p[0], p[1]}, .family = kept->family};
	plane->next = plane->next%(KEPT - 1) + 1;
	status = kept->family.model(kept->family.context, &kept->rom, p[plane->place], report);
	*rom = kept->rom;
	return status;
}

static void end(void *context)
{
	struct plane *plane = context;

	for (int i = 0; plane && i < KEPT; i++)
		if (plane->kept[i].from)
			hawser_factor_close(&plane->kept[i].family);
	free(plane);
}

void hawser_plane_close(struct hawser_rom_plane *plane)
{
	if (plane->close)
		plane->close(plane->context);
	*plane = (struct hawser_rom_plane){.omega = 0.0};
}

enum hawser_status hawser_plane_open(struct hawser_rom_plane *opened,
                                     const struct hawser_rom_family *family,
                                     enum hawser_factor factor, int place,
                                     struct hawser_report *report)
{
	struct plane *plane = calloc(1, sizeof *plane);

	*opened = (struct hawser_rom_plane){family->omega, model, plane, end};
	if (!plane)
		return hawser__no_memory(report, "locus");
	*plane = (struct plane){.family = family, .factor = factor, .place = place};
	/* cppcheck-suppress memleak ; *opened has it */
	return HAWSER_OK;
}
