/* study/accuracy/certificate_start.c - where the corrections of certificate.c begin: motions of the
 * model, lifted to its mesh. SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <hawser/integrate.h>
#include <math.h>
#include <string.h>

#include "study/accuracy/certificate.h"
#include "study/accuracy/motions.h"

enum { PHASES = HAWSER__CERTIFIED_PHASES, WIDTH = HAWSER__CERTIFIED_WIDTH };
static const double faint = 3e-5;  /* part of a motion by the harmonics that are left out; chosen */

/* The series of the displacements. */
static void transform(struct hawser__certifying *w)
{
	double project[PHASES*WIDTH];
	int unknowns = w->both.source.modal.mesh.unknowns;

	for (int i = 0; i < PHASES*WIDTH; i++) {
		int t = i/WIDTH, c = i%WIDTH, k = (c + 1)/2;
		double angle = 2.0*M_PI*(k*t%PHASES)/PHASES;

		project[i] = (c ? 2.0 : 1.0)/PHASES*(c > 0 && c%2 == 0 ? sin(angle) : cos(angle));
	}
	cblas_dgemm(CblasRowMajor, CblasTrans, CblasNoTrans, unknowns, WIDTH, PHASES, 1.0, w->row, unknowns,
	            project, WIDTH, 0.0, w->series, WIDTH);
}

/* Displacements of the mesh in a period of the model's motion from that state. */
enum hawser_status hawser__certifying_lift(struct hawser__certifying *w, const double *state,
                                           double omega, struct hawser_report *report)
{
	double period = 2.0*M_PI/omega;
	const struct hawser_integrate_options options = {.omega = omega, .until = period,
		.every = period/PHASES, .rtol = 1e-8, .atol = 1e-12, .initial = state,
		.max_steps = hawser__steps_of_period(w->rom, omega)};
	size_t n = (size_t)w->rom->n;
	struct hawser_trajectory run;
	enum hawser_status status = hawser_integrate(&run, w->rom, &options, report);

	if (hawser__escapes(status)) { /* from rest no landmark is found */
		memset(w->series, 0, WIDTH*(size_t)w->both.source.modal.mesh.unknowns*sizeof *w->series);
		hawser_trajectory_clear(&run);
		return HAWSER_OK;
	}
	for (size_t t = 0; !status && t < PHASES; t++) {
		const double *own = run.state + 2*t*n;
		int to = w->both.source.n;

		if (w->both.turn)
			cblas_dgemv(CblasRowMajor, CblasNoTrans, to, w->both.turned, 1.0, w->both.turn,
			            w->both.turned, own, 1, 0.0, w->u + t*(size_t)to, 1);
		else
			memcpy(w->u + t*n, own, n*sizeof *w->u);
	}
	hawser_trajectory_clear(&run);
	if (!status)
		status = hawser__net_lift(w->row, &w->both.source, &w->both.answers, w->u, PHASES, 1,
		                          report);
	if (!status)
		transform(w);
	return status;
}

/* The highest harmonic that is not faint in the displacements. */
int hawser__certifying_order(const struct hawser__certifying *w)
{
	double square[HAWSER__CERTIFIED_ORDER + 2] = {0.0}, all = 0.0, rest;
	int order = HAWSER__CERTIFIED_ORDER;

	for (int i = 0; i < w->both.source.modal.mesh.unknowns*WIDTH; i++) {
		square[(i%WIDTH + 1)/2] += w->series[i]*w->series[i];
		all += w->series[i]*w->series[i];
	}
	for (rest = square[HAWSER__CERTIFIED_ORDER + 1]; order > HAWSER__CERTIFIED_LEAST; order--) {
		rest += square[order];
		if (rest > faint*faint*all)
			break;
	}
	return order;
}

void hawser__certifying_start(double *y, const struct hawser__certifying *w, double omega)
{
	const struct hawser__mesh_balance *balance = &w->first.balance;
	const struct hawser__mesh *mesh = w->first.mesh;

	memset(y, 0, balance->size*sizeof *y);
	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			memcpy(y + (3*balance->blocks.row[i/3] + i%3)*balance->width,
			       w->series + mesh->unknown[i/3][i%3]*WIDTH, (size_t)balance->width*sizeof *y);
	y[balance->size - 1] = omega/w->rom->time;
}
