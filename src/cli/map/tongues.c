/* cli/map/tongues.c - see tongues.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "cli/frame/cli.h"
#include "cli/map/tongues.h"

static void describe(char *text, size_t size, const struct hawser_tongue *tongue)
{
	snprintf(text, size, "w%d %c w%d = %d Omega at %.9g, %.9g", tongue->of[0] + 1,
	         tongue->sign > 0 ? '+' : '-', tongue->of[1] + 1, tongue->order, tongue->at[0],
	         tongue->at[1]);
}

void cli_tongues_comment(struct hawser__table *table, const struct hawser_tongues *tongues)
{
	char text[120];

	for (int i = 0; i < tongues->count; i++) {
		describe(text, sizeof text, &tongues->item[i]);
		hawser__table_comment(table, "tongue %s: narrower than round-off of the multipliers", text);
	}
	if (tongues->beyond)
		hawser__table_comment(table, "tongues of an order above 12 were not searched");
}

void cli_tongues_warn(const struct hawser_tongues *tongues)
{
	char text[CLI_WARNING_SIZE], first[120];

	if (tongues->count == 0)
		return;
	describe(first, sizeof first, tongues->item);
	snprintf(text, sizeof text, "%d tongues are narrower than round-off of the multipliers and have no "
	         "boundary, the first: %s; the comments of the table list them", tongues->count, first);
	cli_warn(text);
}

#define OF(member) HAWSER__AT(struct hawser_tongue, member)
static const struct hawser__field tongue_field[] = {
	{"frequencies", NULL, "numbers j and k of the frequencies at rest", OF(of),
	 .flags = HAWSER__FROM_1},
	{"sign", NULL, "1: w_j + w_k = order Omega, -1: w_j - w_k", OF(sign)},
	{"order", NULL, "m", OF(order)},
	{"at", NULL, "where it was met: x, y", OF(at)},
	HAWSER__END,
};
#undef OF
const struct hawser__field cli_tongues_field[] = {
	{"unresolved", NULL, "tongues narrower than round-off of the multipliers",
	 HAWSER__STORED(struct hawser_tongues, item, count, tongue_field)},
	{"beyond", NULL, "whether tongues of an order above 12, which are not searched, may exist",
	 HAWSER__FLAG_AT(struct hawser_tongues, beyond)},
	HAWSER__END,
};
