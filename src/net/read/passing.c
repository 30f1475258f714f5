/* net/read/passing.c - carriers that pass along ropes of a net's scene, as loads of the cables.
 *
 * Weights W at the distance D that run along the rope, S its unstretched length from its begin: their
 * sum at the frequency Omega = 2 pi v/D is (Poisson) the force per length
 *
 *    - W/D - (2W/D) sum_k cos(k Omega t - 2 pi k (S - first)/D)
 *
 * each term of which is a constant load, or a wave of each cable.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "net/read/read.h"

enum { HARMONICS = 3, CALLED = 64 };

/* Of a rope: where it has come to. */
struct along {
	int cable, reversed; /* 1: it runs from the cable's end `to` */
	int node;            /* at which it leaves the cable; -1: not yet known */
	double S;            /* unstretched length before the cable */
};

/* The next cable, which begins where the last one ends; the first one's direction is known by the
 * second. */
static enum hawser_status next(struct hawser__reader *reader, struct along *at,
                               const struct hawser_net *net, const struct hawser__tree *one,
                               const char *what)
{
	int cable = one->text ? hawser__net_cable_of(net, one->text) : -1;
	const struct hawser_net_cable *own = cable < 0 ? NULL : &net->cable[cable];

	if (!own)
		return hawser__reader_fail(reader, &one->at, "%s.along: there is no cable %s", what,
		                           one->text ? one->text : "without a name");
	if (own->given != HAWSER_NET_LENGTH0)
		return hawser__reader_fail(reader, &one->at, "%s.along: cable %s has no length0, from which "
		                           "the places of the carriers follow", what, own->name);
	if (at->node < 0 && one->next && one->next->text) {
		int follows = hawser__net_cable_of(net, one->next->text);

		at->node = follows >= 0 && (own->from == net->cable[follows].from ||
		                            own->from == net->cable[follows].to) ? own->to : own->from;
	} else if (at->node < 0) {
		at->node = own->from;
	}
	if (at->node != own->from && at->node != own->to)
		return hawser__reader_fail(reader, &one->at, "%s.along: cable %s does not begin where the one "
		                           "before it ends", what, own->name);
	at->cable = cable;
	at->reversed = at->node == own->to;
	at->node = at->reversed ? own->from : own->to;
	return HAWSER_OK;
}

/* Harmonic k of the weights on the cable; 0: their mean. */
static enum hawser_status add(struct hawser__reader *reader, struct hawser_net *net,
                              const struct hawser__net_passing *of, const struct along *at, int k,
                              double weight)
{
	double number = 2.0*M_PI*k/of->spacing;
	enum hawser_status status = hawser__net_more(&net->load, net->loads, reader->report);
	struct hawser_net_load *load;

	if (status)
		return status;
	load = &net->load[net->loads++];
	*load = (struct hawser_net_load){.node = -1, .cable = at->cable, .harmonic = k > 0,
		.value = {0.0, -(k ? 2.0 : 1.0)*weight/of->spacing, 0.0}};
	if (k == 0)
		return HAWSER_OK;
	load->multiple = of->speed > 0.0 ? 0 : k;
	load->Omega = number*of->speed;
	load->wavelength = (at->reversed ? -1.0 : 1.0)*of->spacing/k;
	load->phase = -number*(at->S - of->first + (at->reversed ? net->cable[at->cable].value : 0.0));
	return HAWSER_OK;
}

static enum hawser_status rope(struct hawser__reader *reader, struct hawser_net *net,
                               const struct hawser__tree *tree, const char *what)
{
	struct hawser__net_passing of = {.harmonics = HARMONICS};
	struct along at = {.node = -1};
	const struct hawser__tree *list = hawser__tree_find(tree, "along");
	enum hawser_status status = hawser__tree_fill(reader, &of, tree, what, "net.passing[]");

	if (!status && (of.weight > 0.0) == (of.mass > 0.0))
		status = hawser__reader_fail(reader, &tree->at, "%s needs weight or mass, and not both", what);
	if (!status && (!list || list->kind != HAWSER__SEQUENCE || !list->child))
		status = hawser__reader_fail(reader, &tree->at, "%s.along must be a list of cables", what);
	for (const struct hawser__tree *one = status ? NULL : list->child; one && !status;
	     one = one->next) {
		status = next(reader, &at, net, one, what);
		if (status)
			break;
		net->cable[at.cable].rho += of.mass/of.spacing;
		for (int k = of.mass > 0.0; k <= of.harmonics && !status; k++)
			status = add(reader, net, &of, &at, k, of.mass > 0.0 ? of.mass*net->g : of.weight);
		at.S += net->cable[at.cable].value;
	}
	return status;
}

enum hawser_status hawser__net_passing(struct hawser__reader *reader, struct hawser_net *net,
                                       const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;
	int i = 0;

	if (tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->at, "passing must be a list of the carriers of each "
		                           "rope, such as [{along: [c0, c1], mass: 300 kg, spacing: 60 m}]");
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next) {
		char what[CALLED];

		snprintf(what, sizeof what, "passing[%d]", i++);
		status = rope(reader, net, one, what);
	}
	return status;
}
