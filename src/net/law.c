/* net/law.c - cables with a table of strains and tensions.
 *
 * On one piece of the table an element is as one with another EA and unstretched length, whose mass is
 * the same. Statics solves with the pieces as they are, and takes new ones where the strains ask for
 * them. The energy is convex, and that of the pieces touches it: on the way to the next equilibrium it
 * falls at first, and the way ends where it would rise again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/net.h"

#define SAME (64.0*DBL_EPSILON) /* difference of tensions over EA that is round-off */
enum { HALVES = 40 }; /* of the way */

int hawser__mesh_creeps(const struct hawser_net *net)
{
	for (int c = 0; net && c < net->cables; c++)
		if (net->cable[c].dynamic > 0.0)
			return 1;
	return 0;
}

enum hawser_status hawser__mesh_lawless(const struct hawser_net *net, const char *what,
                                        struct hawser_report *report)
{
	for (int c = 0; c < net->cables; c++)
		if (net->cable[c].rows || net->cable[c].dynamic > 0.0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: cable %s has %s, which %s "
			                    "cannot use: give a number, such as the slope at its tension",
			                    net->name ? net->name : "net", net->cable[c].name,
			                    net->cable[c].rows ? "a table of EA" : "EA.dynamic", what);
	return HAWSER_OK;
}

double hawser__mesh_length(const struct hawser__mesh *mesh, int element)
{
	return mesh->length0[element]/(1.0 + mesh->offset[element]);
}

/* A piece of the law of a cable: T = slope*(strain - offset), and J/m beyond T^2/(2 slope). */
struct piece {
	double slope, offset, stored;
};

static struct piece piece_of(const struct hawser_net_cable *cable, double strain)
{
	struct piece piece = {.slope = cable->EA};
	double area = 0.0, from[2] = {0.0, 0.0};

	for (int i = 0; i < cable->rows && (i == 0 || strain > from[0]); i++) {
		const double *to = cable->law[i];

		piece.slope = (to[1] - from[1])/(to[0] - from[0]);
		piece.offset = i ? from[0] - from[1]/piece.slope : 0.0;
		piece.stored = area - 0.5*from[1]*from[1]/piece.slope;
		area += 0.5*(to[1] + from[1])*(to[0] - from[0]);
		memcpy(from, to, sizeof from);
	}
	return piece;
}

/* Tension of an element of the length l, m. */
static double tension_of(const struct hawser__mesh *mesh, int i, double l)
{
	double strain = l/hawser__mesh_length(mesh, i) - 1.0;
	struct piece piece = piece_of(&mesh->net->cable[mesh->cable[i]], strain);

	return mesh->density[i] > 0.0 ? mesh->density[i]*l : piece.slope*fmax(strain - piece.offset, 0.0);
}

int hawser__mesh_follow(struct hawser__mesh *mesh)
{
	int others = 0;

	for (int i = 0; i < mesh->elements; i++) {
		const struct hawser_net_cable *cable = &mesh->net->cable[mesh->cable[i]];
		double e[3], l = hawser__mesh_direction(e, mesh, i), L = hawser__mesh_length(mesh, i);
		struct piece piece = piece_of(cable, l/L - 1.0);
		double T = piece.slope*fmax(l/L - 1.0 - piece.offset, 0.0);
		double now = mesh->EA[i]*fmax(l/mesh->length0[i] - 1.0, 0.0);

		if (!cable->rows || fabs(T - now) <= SAME*(piece.slope + mesh->EA[i]))
			continue;
		others++;
		mesh->offset[i] = piece.offset;
		mesh->length0[i] = L*(1.0 + piece.offset);
		mesh->EA[i] = piece.slope*(1.0 + piece.offset);
		mesh->rho[i] = cable->rho/(1.0 + piece.offset);
		mesh->stored[i] = L*piece.stored;
	}
	return others;
}

/* Derivative of the energy along d [nodes][3] at mesh->q. */
static double slope_along(const struct hawser__mesh *mesh, double (*d)[3])
{
	double sum = 0.0, e[3];

	for (int i = 0; i < mesh->nodes; i++)
		sum -= hawser__dot(mesh->force[i], d[i]);
	for (int i = 0; i < mesh->elements; i++) {
		double l = hawser__mesh_direction(e, mesh, i);
		const double *a = d[mesh->end[i][0]], *b = d[mesh->end[i][1]];

		sum += tension_of(mesh, i, l)*(hawser__dot(b, e) - hawser__dot(a, e));
	}
	return sum;
}

void hawser__mesh_descend(struct hawser__mesh *mesh, double (*from)[3], double (*d)[3])
{
	double part = 0.0, step = 1.0;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			d[i][k] = mesh->q[i][k] - from[i][k];
	for (int n = 0; n < HALVES && part < 1.0; n++, step *= 0.5) {
		for (int i = 0; i < mesh->nodes; i++)
			for (int k = 0; k < 3; k++)
				mesh->q[i][k] = from[i][k] + (part + step)*d[i][k];
		part += slope_along(mesh, d) <= 0.0 ? step : 0.0;
	}
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			mesh->q[i][k] = from[i][k] + part*d[i][k];
}
