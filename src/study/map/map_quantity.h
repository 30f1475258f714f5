/* study/map/map_quantity.h - the quantity of a map of a cable at a point: a row of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_QUANTITY_H
#define HAWSER_STUDY_MAP_QUANTITY_H

#include <hawser/map.h>

/* The workspace of a thread for models of up to n coordinates. */
struct hawser__map_room {
	int n;
	int finer; /* factor on the number of steps for multipliers; 0 and 1: unchanged */
	struct hawser_linear *linear;
	double *log_modulus, *argument; /* [2n] */
	double *frequency;              /* [n] */
	double *exponents;              /* [HAWSER__EXPONENTS(n)] */
};
enum hawser_status hawser__map_room_fit(struct hawser__map_room *room, int n,
                                        struct hawser_report *report);
void hawser__map_room_clear(struct hawser__map_room *room);

struct hawser__map_quantity {
	struct hawser_map_quantity about;
	double threshold;
	/* Computes value and number of the sample of a model at the scaled omega (0: none). A failure is
	 * that of the point, except for lack of memory and the like. */
	enum hawser_status (*measure)(struct hawser__map_room *room, struct hawser_map_sample *sample,
	                              const struct hawser_rom *rom, double omega,
	                              struct hawser_report *report);
	int resonant; /* parametric: 1: instabilities lie where sums of frequencies are multiples of
	               * Omega */
};
const struct hawser__map_quantity *hawser__map_quantity(const char *name);

#endif
