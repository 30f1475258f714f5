/* study/map_quantity.h - what a map of a cable shows at a point: a row of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_QUANTITY_H
#define HAWSER_STUDY_MAP_QUANTITY_H

#include <hawser/linear.h>
#include <hawser/map.h>

/* A thread's room for models of up to n coordinates. */
struct hawser__map_room {
	int n;
	int finer; /* steps of the multipliers, times; 0 and 1: as they are */
	struct hawser_linear *linear;
	double *log_modulus, *argument; /* [2n] */
	double *frequency;              /* [n] */
};
enum hawser_status hawser__map_room_fit(struct hawser__map_room *room, int n,
                                        struct hawser_report *report);
void hawser__map_room_clear(struct hawser__map_room *room);

struct hawser__map_quantity {
	struct hawser_map_quantity about;
	double threshold;
	/* The sample's value and number, and frequencies [n] unless that is NULL, of a model at scaled
	 * omega (0: none). A failure is the point's own but for memory and the like. */
	enum hawser_status (*measure)(struct hawser__map_room *room, struct hawser_map_sample *sample,
	                              double *frequency, const struct hawser_rom *rom, double omega,
	                              struct hawser_report *report);
	int resonant; /* parametric: instabilities lie where frequencies add up to a multiple of Omega */
};
const struct hawser__map_quantity *hawser__map_quantity(const char *name);

#endif
