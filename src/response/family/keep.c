/* response/family/keep.c - see smooth.h. The one that was not asked for longest gives way.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "response/family/smooth.h"

static enum hawser_status make_one(void *context, struct hawser_rom *rom, double p,
                                   struct hawser_report *report)
{
	struct hawser__keep *keep = context;

	return keep->make(keep->context, rom, (double[2]){p, 0.0}, report);
}

enum hawser_status hawser__keep_model(struct hawser__keep *keep, const struct hawser_rom **rom,
                                      const double p[2], struct hawser_report *report)
{
	const struct hawser__model_maker maker = {make_one, keep, keep->from, keep->to};
	struct hawser__kept_model *kept = &keep->kept[keep->kept[0].used > 0];
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < HAWSER__KEEP_MODELS; i++) {
		if (keep->kept[i].used > 0 && keep->kept[i].p[0] == p[0] && keep->kept[i].p[1] == p[1]) {
			keep->kept[i].used = ++keep->now;
			*rom = &keep->kept[i].rom;
			return HAWSER_OK;
		}
		if (i > 0 && keep->kept[i].used < kept->used)
			kept = &keep->kept[i];
	}
	*rom = NULL;
	if (keep->quick && keep->smooth.asked == 0)
		keep->smooth.asked = HAWSER__SMOOTH_PATIENCE;
	if (keep->to > keep->from)
		status = hawser__smooth_model(&keep->smooth, rom, &maker, p[0], report);
	if (status || *rom)
		return status;
	hawser_rom_clear(&kept->rom);
	kept->used = 0;
	if ((status = keep->make(keep->context, &kept->rom, p, report)))
		return status;
	memcpy(kept->p, p, sizeof kept->p);
	kept->used = ++keep->now;
	*rom = &kept->rom;
	return HAWSER_OK;
}

void hawser__keep_clear(struct hawser__keep *keep)
{
	for (int i = 0; i < HAWSER__KEEP_MODELS; i++)
		hawser_rom_clear(&keep->kept[i].rom);
	hawser__smooth_clear(&keep->smooth);
}
