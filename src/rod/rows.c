/* rod/rows.c - the rows of a motion: places, forces, energies, momenta at one time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "rod/run.h"
#include "rod/so3.h"

enum hawser_status hawser__rod_rows_open(struct hawser_rod_motion *to, size_t rows, size_t probes,
                                         size_t nodes, struct hawser_report *report)
{
	double **const plain[] = {&to->time, &to->kinetic, &to->strain, &to->height, &to->work,
	                          &to->support, &to->damped, &to->lost, &to->turned,
	                          &to->winch, &to->water, &to->length};
	/* cppcheck-suppress uninitvar ; sizeof of its elements alone */
	double (**const three[])[3] = {&to->momentum, &to->angular, &to->force, &to->moment};
	struct hawser__hold hold = {0};

	for (size_t i = 0; i < sizeof plain/sizeof *plain; i++)
		*plain[i] = hawser__hold(&hold, rows, sizeof **plain[i]);
	for (size_t i = 0; i < sizeof three/sizeof *three; i++)
		*three[i] = hawser__hold(&hold, rows, sizeof **three[i]);
	to->x = hawser__hold(&hold, rows*probes + 1, sizeof *to->x);
	to->v = hawser__hold(&hold, rows*probes + 1, sizeof *to->v);
	to->T = hawser__hold(&hold, rows*probes + 1, sizeof *to->T);
	to->M = hawser__hold(&hold, rows*probes + 1, sizeof *to->M);
	to->shape = hawser__hold(&hold, rows*nodes, sizeof *to->shape);
	to->probes = (int)probes;
	to->nodes = (int)nodes;
	to->held = hold.last;
	return hold.short_of_memory ? hawser__no_memory(report, "rod") : HAWSER_OK;
}

static double size(const double v[3])
{
	return sqrt(hawser__dot(v, v));
}

static void probe(struct hawser_rod_motion *to, size_t at, const struct hawser__rod_twin *twin,
                  double s)
{
	const struct hawser__rod_mesh *mesh = &twin->mesh;
	const double (*v)[6] = (const double (*)[6])twin->motion.velocity;
	const struct hawser__rod_winch *winch = &twin->motion.winch;
	int e = 0;
	double part;

	if (winch->as)
		s = s < winch->first ? s*winch->length/winch->first : s + winch->length - winch->first;
	while (e < mesh->elements - 1 && mesh->s[e + 1] <= s)
		e++;
	part = fmin(fmax((s - mesh->s[e])/(mesh->s[e + 1] - mesh->s[e]), 0.0), 1.0);
	for (int k = 0; k < 3; k++) {
		to->x[at][k] = (1.0 - part)*mesh->node[e].x[k] + part*mesh->node[e + 1].x[k];
		to->v[at][k] = (1.0 - part)*v[e][k] + part*v[e + 1][k];
	}
	to->T[at] = mesh->strain[e].N[0];
	to->M[at] = size(mesh->strain[e].M);
}

/* What the caller's function gets. */
static enum hawser_status frame(struct hawser_rod_motion *to, const struct hawser__rod_twin *twin,
                                const struct hawser_rod_motion_options *options,
                                struct hawser_report *report)
{
	const struct hawser__rod_mesh *mesh = &twin->mesh;
	struct hawser_rod_frame frame = {.t = twin->motion.t, .row = to->rows - 1, .nodes = mesh->nodes};
	double (*q)[4] = calloc((size_t)mesh->nodes, sizeof *q);
	double *T = calloc(2*(size_t)mesh->elements, sizeof *T), *M = T ? T + mesh->elements : NULL;

	if (!q || !T) {
		free(q);
		free(T);
		return hawser__no_memory(report, "rod");
	}
	for (int i = 0; i < mesh->nodes; i++)
		memcpy(q[i], mesh->node[i].q, sizeof q[i]);
	for (int e = 0; e < mesh->elements; e++) {
		T[e] = mesh->strain[e].N[0];
		M[e] = size(mesh->strain[e].M);
	}
	frame.x = (const double (*)[3])(to->shape + (size_t)(to->rows - 1)*(size_t)to->nodes);
	frame.q = (const double (*)[4])q;
	frame.T = T;
	frame.M = M;
	to->interrupted = options->frame(options->data, &frame) != 0;
	free(q);
	free(T);
	return HAWSER_OK;
}

enum hawser_status hawser__rod_row(struct hawser_rod_motion *to, struct hawser__rod_twin *twin,
                                   double turned, const struct hawser_rod_motion_options *options,
                                   struct hawser_report *report)
{
	struct hawser__rod_motion *motion = &twin->motion;
	const struct hawser__rod_mesh *mesh = &twin->mesh;
	double R[9];
	int i = to->rows++;

	to->time[i] = motion->t;
	to->kinetic[i] = motion->energy.kinetic;
	to->strain[i] = motion->energy.strain;
	to->height[i] = motion->energy.height;
	to->work[i] = motion->energy.work;
	to->support[i] = motion->energy.support;
	to->damped[i] = motion->energy.damped;
	to->water[i] = motion->energy.pushed;
	to->winch[i] = motion->energy.winch;
	to->length[i] = mesh->s[mesh->nodes - 1];
	to->lost[i] = motion->energy_lost;
	to->turned[i] = turned;
	memcpy(to->momentum[i], motion->momentum.linear, sizeof to->momentum[i]);
	memcpy(to->angular[i], motion->momentum.angular, sizeof to->angular[i]);
	memcpy(to->force[i], motion->reaction[0], sizeof to->force[i]);
	hawser__quaternion_matrix(R, mesh->node[0].q);
	hawser__apply(to->moment[i], R, motion->reaction[0] + 3);
	for (int n = 0; n < mesh->nodes; n++)
		memcpy(to->shape[(size_t)i*(size_t)mesh->nodes + (size_t)n], mesh->node[n].x,
		       sizeof *to->shape);
	for (int p = 0; p < to->probes; p++)
		probe(to, (size_t)i*(size_t)to->probes + (size_t)p, twin, options->probe[p]);
	for (int e = 0; e < mesh->elements; e++)
		for (int k = 0; k < 3; k++)
			to->strain_most = fmax(to->strain_most,
			                       fabs(mesh->strain[e].w[k] - mesh->element[e].w0[k]));
	/* a run that goes on from this state has no factors either */
	motion->factor_h = 0.0;
	return options->frame ? frame(to, twin, options, report) : HAWSER_OK;
}
