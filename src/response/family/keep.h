/* response/family/keep.h - models that take long to make, kept by their parameters, or between others.
 * See keep.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_KEEP_H
#define HAWSER_RESPONSE_KEEP_H

#include "response/family/smooth.h"

enum { HAWSER__KEEP_MODELS = 11 };

/* All zero but for `make` and `context`: of two parameters, without interpolation. */
struct hawser__keep {
	enum hawser_status (*make)(void *context, struct hawser_rom *rom, const double p[2],
	                           struct hawser_report *report);
	void *context;
	double from, to; /* of the one parameter, if models are interpolated: from < to */
	int quick;       /* 1: interpolated from the first one on */
	struct hawser__smooth smooth;
	struct hawser__kept_model {
		double p[2];
		long used;
		struct hawser_rom rom;
	} kept[HAWSER__KEEP_MODELS];
	long now;
};

/* The model at p, which stays as it is until others have been asked for at ten other places; the first
 * one stays to the end. Statuses of `make`; HAWSER_ERR_MEMORY. */
enum hawser_status hawser__keep_model(struct hawser__keep *keep, const struct hawser_rom **rom,
                                      const double p[2], struct hawser_report *report);
void hawser__keep_clear(struct hawser__keep *keep);

#endif
