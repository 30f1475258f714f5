/* cli/motion/warnings_net.c - what is warned of after a motion of a net: waves along the cables.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include "cli/frame/cli.h"
#include "cli/motion/integrate_net.h"

/* Least number of changes between slack and taut, without axial damping, that gives a warning; chosen:
 * a line that slackens once or twice has fewer, a riser in a storm far more. */
enum { SWITCHES = 100 };

/* The error of fronts, if it is more than a tenth of the way of the probes; returns 0 if it is not. */
static int shock_warning(char *text, const struct hawser_net_motion *motion)
{
	double most = 0.0;

	for (int i = 0; i < motion->rows*motion->probes; i++)
		for (int k = 0; k < 3; k++)
			most = fmax(most, fabs(motion->x[i][k] - motion->x[i%motion->probes][k]));
	if (!(motion->shock > 0.1*most))
		return 0;
	if (motion->front_axial > 0.0)
		snprintf(text, CLI_WARNING_SIZE, "positions are wrong by up to %.2g m, as elements are too "
		         "long for fronts behind which the cable is slack: give more elements", motion->shock);
	else
		snprintf(text, CLI_WARNING_SIZE, "positions are wrong by up to %.2g m, as axial waves that "
		         "make the cable slack have no damping: give damping.axial, such as %.3g s, the time "
		         "in which a wave passes an element", motion->shock, motion->shock_axial);
	return 1;
}

/* In water: returns 0 if axial waves are damped, or nothing makes them. */
static int slack_warning(char *text, const struct hawser_net *net,
                         const struct hawser_net_motion *motion)
{
	int damped = net->axial_given || motion->front_axial > 0.0 || !(net->water.density > 0.0);

	for (int c = 0; c < net->cables; c++)
		damped |= net->cable[c].axial > 0.0 || net->cable[c].viscosity > 0.0;
	snprintf(text, CLI_WARNING_SIZE, "elements became slack and taut %ld times, and the waves along "
	         "the cables that this makes have no damping: tensions may be several times too large; "
	         "give damping.axial, such as 0.01 s", motion->switches);
	return !damped && motion->switches >= SWITCHES;
}

void cli_motion_warnings(const struct hawser_net *net, const struct hawser_net_motion *motion)
{
	char text[CLI_WARNING_SIZE];

	if (motion->unbalanced)
		cli_warn("the motion does not begin at rest: no equilibrium was found near that of statics "
		         "with cables that lie in part on beds that give way: it swings from there on; give "
		         "more elements, or obstacles.NAME.rounding where the bed is bent");
	if (shock_warning(text, motion))
		cli_warn(text);
	if (slack_warning(text, net, motion))
		cli_warn(text);
}
