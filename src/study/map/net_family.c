/* study/map/net_family.c - the models of a net over one of its keys; see hawser/scene_family.h. The
 * modes at a value are those most like the modes at the first one, by their products with its masses.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/scene_family.h>

#include "core/report.h"
#include "response/family/smooth.h"
#include "rom/build/net.h"

struct net_family {
	struct hawser__keep keep;
	struct hawser_net_at at;
	struct hawser_net net;            /* at the first value */
	struct hawser__net_like like;     /* of it */
	struct hawser_net_rom_options options; /* without kept modes */
};

static enum hawser_status make(void *context, struct hawser_rom *rom, const double p[2],
                               struct hawser_report *report)
{
	const struct net_family *family = context;
	struct hawser_net net;
	struct hawser_modes modes = {.n = 0};
	enum hawser_status status = family->at.make(family->at.context, &net, p[0], report);

	*rom = (struct hawser_rom){.n = 0};
	if (status)
		return status;
	status = hawser__net_rom_like(rom, &modes, &net, &family->options, &family->like, report);
	hawser_modes_clear(&modes);
	hawser_net_clear(&net);
	return status;
}

static enum hawser_status model(void *context, const struct hawser_rom **rom, double p,
                                struct hawser_report *report)
{
	struct net_family *family = context;

	return hawser__keep_model(&family->keep, rom, (double[2]){p, 0.0}, report);
}

void hawser_net_family_close(struct hawser_rom_family *closed)
{
	struct net_family *family = closed->context;

	if (family) {
		hawser__keep_clear(&family->keep);
		hawser__net_like_clear(&family->like);
		hawser_net_clear(&family->net);
	}
	free(family);
	*closed = (struct hawser_rom_family){0.0, NULL, NULL};
}

enum hawser_status hawser_net_family_open(struct hawser_rom_family *opened,
                                          const struct hawser_net_at *at,
                                          const struct hawser_net_rom_options *options, double from,
                                          double to, double first, double omega,
                                          struct hawser_report *report)
{
	struct net_family *family = calloc(1, sizeof *family);
	enum hawser_status status;

	*opened = (struct hawser_rom_family){omega, model, family};
	if (!family)
		return hawser__no_memory(report, "frf");
	family->keep.make = make;
	family->keep.context = family;
	family->keep.from = from;
	family->keep.to = to;
	family->keep.quick = 1;
	family->at = *at;
	family->options = *options;
	status = at->make(at->context, &family->net, first, report);
	if (!status)
		status = hawser__net_like_open(&family->like, &family->net, options, report);
	family->options.kept = NULL; /* the caller's: the modes are those of `like` from here on */
	family->options.count = 0;
	if (status)
		hawser_net_family_close(opened);
	return status;
}
