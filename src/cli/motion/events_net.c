/* cli/motion/events_net.c - cables of a net that part, and winches, in the output of hawser integrate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/motion/integrate_net.h"

static const char *name_of(const struct cli_events *events, int cable)
{
	return events->net->cable[cable].name;
}

struct event {
	const char *cable;
	struct hawser_net_parted parted;
	struct hawser_net_wound wound;
};
#define OF(member) HAWSER__AT(struct event, member)
static const struct hawser__field parted_field[] = {
	{"cable", NULL, "its name", OF(cable)},
	{"time", NULL, "when it parted; null: it did not", OF(parted.time), .unit = HAWSER__SECOND,
	 .flags = HAWSER__NULL},
	{"tension", NULL, "its tension there then", OF(parted.tension), .unit = HAWSER__NEWTON,
	 .flags = HAWSER__NULL},
	HAWSER__END,
};
static const struct hawser__field wound_field[] = {
	{"cable", NULL, "its name", OF(cable)},
	{"length0", NULL, "its unstretched length at the end", OF(wound.length0), .unit = HAWSER__METRE},
	HAWSER__END,
};
#undef OF

static const void *parted_row(void *to, const void *of, size_t i)
{
	const struct cli_events *events = of;
	const struct hawser_net_parted *parted = &events->failure[i];

	*(struct event *)to = (struct event){.cable = name_of(events, parted->cable), .parted = *parted};
	return to;
}

static const void *wound_row(void *to, const void *of, size_t i)
{
	const struct cli_events *events = of;
	const struct hawser_net_wound *wound = &events->winch[i];

	*(struct event *)to = (struct event){.cable = name_of(events, wound->cable), .wound = *wound};
	return to;
}
static const struct hawser__list parted_list = HAWSER__MADE_ROWS(
	struct event, parted_field, struct cli_events, failures, parted_row);
static const struct hawser__list wound_list = HAWSER__MADE_ROWS(
	struct event, wound_field, struct cli_events, winches, wound_row);

const struct hawser__field cli_events_field[] = {
	{"failures", NULL, "in the order of the scene", HAWSER__OBJECTS_OF(parted_list),
	 .when = CLI_FAILURES},
	{"winches", NULL, "in the order of the scene", HAWSER__OBJECTS_OF(wound_list),
	 .when = CLI_WINCHES},
	HAWSER__END,
};

void cli_events_comments(struct hawser__table *table, const struct cli_events *events)
{
	for (int i = 0; i < events->failures; i++)
		if (isnan(events->failure[i].time))
			hawser__table_comment(table, "cable %s has not parted",
			                      name_of(events, events->failure[i].cable));
		else
			hawser__table_comment(table, "cable %s parted at %.9g s under %.9g N",
			                      name_of(events, events->failure[i].cable), events->failure[i].time,
			                      events->failure[i].tension);
	for (int i = 0; i < events->winches; i++)
		hawser__table_comment(table, "winch of %s: unstretched length %.9g m at the end",
		                      name_of(events, events->winch[i].cable), events->winch[i].length0);
}
