/* response/switch/slower.h - a model, or the models of a family, whose base frequency is a fraction of
 * that of the load, for motions of several of its periods.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_SLOWER_H
#define HAWSER_RESPONSE_SLOWER_H

#include <hawser/family.h>

struct hawser__slower_model;

struct hawser__slower {
	const struct hawser_rom *rom;
	struct hawser_rom_family family; /* .model is NULL if there is none */
	int b;
	/* the rest is private */
	const struct hawser_rom_family *of;
	struct hawser__slower_model *model; /* the first one is `rom` */
	int count, next;
};

/* The base frequency is that of `rom` over b; of `family`, or NULL, as well. Both are used until
 * hawser__slower_close, before which *slower must not move. */
enum hawser_status hawser__slower_open(struct hawser__slower *slower, const struct hawser_rom *rom,
                                       const struct hawser_rom_family *family, int b,
                                       struct hawser_report *report);
void hawser__slower_close(struct hawser__slower *slower);

#endif
