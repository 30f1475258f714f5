/* net/net.c - a net as the scene has it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/net.h>

void hawser_net_clear(struct hawser_net *net)
{
	if (!net)
		return;
	for (int i = 0; i < net->nodes; i++)
		free(net->node[i].table);
	for (int i = 0; i < net->loads; i++)
		free(net->load[i].along);
	free(net->name);
	free(net->node);
	free(net->cable);
	free(net->order);
	free(net->load);
	free(net->motion);
	free(net->dynamics.from);
	free(net->dynamics.release);
	for (int i = 0; i < net->surfaces; i++) {
		hawser_heights_free(net->surface[i].heights);
		free(net->surface[i].file);
	}
	free(net->surface);
	for (int i = 0; i < net->contact.paths; i++)
		free(net->contact.path[i].x);
	free(net->contact.path);
	free(net->failure);
	free(net->winch);
	free(net->absorber);
	free(net->wind);
	for (int i = 0; i < net->bodies; i++)
		free(net->body[i].node);
	free(net->body);
	hawser_water_clear(&net->water);
	memset(net, 0, sizeof *net);
}
