/* net/absorbers.c - absorbers of a net, as parts of its mesh: see net/net.h.
 *
 *   s  stroke: displacement relative to the node along the direction e
 *   u  displacement of the node
 *
 * The kinetic energy m |u' + e s'|^2/2 is that of a mass m at the node and m (e.u') s' + m s'^2/2. The
 * spring and the damper are those of s alone, so that no force follows from a static displacement of
 * the node.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "net/net.h"

enum { ENTRIES = 7 }; /* of the mass matrix: of s with s, and with the three directions, both ways */

void hawser__absorbers_open(struct hawser__mesh *mesh, const struct hawser_net *net, int first)
{
	mesh->absorbers = net->absorbers;
	for (int i = 0; i < net->absorbers; i++) {
		const struct hawser_net_absorber *from = &net->absorber[i];
		struct hawser__mesh_absorber *to = &mesh->absorber[i];

		*to = (struct hawser__mesh_absorber){.node = from->node, .at = first + i, .mass = from->mass};
		memcpy(to->e, from->direction, sizeof to->e);
		for (int k = 1; k < 3; k++)
			to->axis = fabs(to->e[k]) > fabs(to->e[to->axis]) ? k : to->axis;
		memcpy(mesh->q[to->at], mesh->q[to->node], sizeof mesh->q[to->at]);
		mesh->spring[to->at][to->axis] = from->stiffness;
		mesh->damper[to->at][to->axis] = from->damping;
		for (int k = 0; k < 3; k++)
			mesh->unknown[to->at][k] = -1;
	}
}

void hawser__absorbers_release(struct hawser__mesh *mesh, unsigned along)
{
	for (int i = 0; i < mesh->absorbers; i++)
		for (int k = 0; k < 3; k++)
			if (along & (1U << k) && mesh->absorber[i].e[k] != 0.0)
				mesh->unknown[mesh->absorber[i].at][mesh->absorber[i].axis] = 0;
	if (mesh->absorbers)
		hawser__mesh_number(mesh);
}

int hawser__absorbers_mass(struct hawser__mesh_pair *pair, const struct hawser__mesh *mesh, int j)
{
	const struct hawser__mesh_absorber *of = &mesh->absorber[j/ENTRIES];
	int k = j%ENTRIES;

	if (j >= ENTRIES*mesh->absorbers)
		return 0;
	*pair = (struct hawser__mesh_pair){of->at, of->axis, of->at, of->axis, of->mass};
	if (k > 0)
		pair->mass *= of->e[(k - 1)/2];
	if (k > 0 && k%2) {
		pair->other = of->node;
		pair->other_axis = (k - 1)/2;
	} else if (k > 0) {
		pair->node = of->node;
		pair->axis = (k - 1)/2;
	}
	return 1;
}
