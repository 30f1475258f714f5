/* beam/integrals.c - the table of discretisations, and the memory of their integrals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "beam/sample.h"
#include "core/report.h"

static const struct hawser_beam_method *const rows[] = {&hawser__beam_legendre, &hawser__beam_sine,
	&hawser__beam_hermite};
#define ROWS ((int)(sizeof rows/sizeof *rows))

const struct hawser_beam_method *hawser_beam_method(int index)
{
	return index >= 0 && index < ROWS ? rows[index] : NULL;
}

enum hawser_status hawser__beam_integrals_init(struct hawser_beam_integrals *integrals, int n,
                                               int band, struct hawser_report *report)
{
	size_t size = (size_t)n*(size_t)n;
	double *room;

	memset(integrals, 0, sizeof *integrals);
	room = calloc(6*size, sizeof *room);
	if (!room)
		return hawser__no_memory(report, "beam");
	integrals->n = n;
	integrals->band = band < n ? band : n - 1;
	integrals->ss = room;
	integrals->s1s1 = room + size;
	integrals->s2s2 = room + 2*size;
	integrals->xs1s1 = room + 3*size;
	integrals->ss1 = room + 4*size;
	integrals->s1s2 = room + 5*size;
	return HAWSER_OK;
}

void hawser_beam_integrals_clear(struct hawser_beam_integrals *integrals)
{
	if (!integrals)
		return;
	free(integrals->ss);
	memset(integrals, 0, sizeof *integrals);
}
