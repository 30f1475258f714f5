/* response/family/smooth.h - models between those at a few values of a parameter. See smooth.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_SMOOTH_H
#define HAWSER_RESPONSE_SMOOTH_H

#include <hawser/rom.h>

/* How the models are made, and of which range of the parameter. */
struct hawser__model_maker {
	enum hawser_status (*make)(void *context, struct hawser_rom *rom, double p,
	                           struct hawser_report *report);
	void *context;
	double from, to;
};

/* Models that are made before: fewer than interpolation takes. */
enum { HAWSER__SMOOTH_PATIENCE = 24 };
/* All zero: nothing is known yet. */
struct hawser__smooth {
	int asked;                      /* how often; set to HAWSER__SMOOTH_PATIENCE: none is made before */
	struct hawser__smooth_models *models; /* NULL: there are none */
};

/* *rom becomes the interpolated model at p, which stays as it is until the function has been called for
 * eight other values; NULL: make it. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__smooth_model(struct hawser__smooth *smooth,
                                        const struct hawser_rom **rom,
                                        const struct hawser__model_maker *maker, double p,
                                        struct hawser_report *report);
void hawser__smooth_clear(struct hawser__smooth *smooth);

/* --- keep.c: models that take long to make, kept by their parameters, or between others --- */

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
