/* ropeway/modes/modes_fill.c - the public structure of modes of a rope over sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "ropeway/modes/modes.h"

void hawser_line_modes_clear(struct hawser_line_modes *modes)
{
	if (!modes)
		return;
	for (int i = 0; i < modes->pieces && modes->piece; i++)
		hawser__grid_clear(&modes->piece[i].grid);
	free(modes->piece);
	free(modes->point);
	free(modes->weight);
	free(modes->mode);
	free(modes->shape);
	free(modes->slope);
	free(modes->share);
	free(modes->mass_at);
	free(modes->freedom_at);
	*modes = (struct hawser_line_modes){0};
}

/* --- grids and points --- */

static void place_point(struct hawser_line_modes_point *to, const struct hawser__lmode *rope,
                        const struct hawser__lmode_piece *piece, double s)
{
	double T, g;

	to->S = (piece->s0 + s)*rope->length;
	hawser_line_at(rope->lane[piece->lane], to->x, &to->angle, &T, &g, &to->curvature, to->S);
	to->T = T;
	to->stretch = g;
}

static enum hawser_status place_grids(struct hawser_line_modes *modes, const struct hawser__lmode *rope,
                                      double omega, struct hawser_report *report)
{
	modes->piece = calloc((size_t)rope->pieces, sizeof *modes->piece);
	if (!modes->piece)
		return hawser__no_memory(report, "line modes");
	modes->pieces = rope->pieces;
	for (int i = 0; i < rope->pieces; i++) {
		const struct hawser__lmode_piece *from = &rope->piece[i];
		struct hawser_line_modes_piece *to = &modes->piece[i];
		enum hawser_status status = HAWSER_OK;

		*to = (struct hawser_line_modes_piece){.lane = from->lane, .piece = from->piece,
		                                       .sheave = from->sheave, .span = from->run,
		                                       .first = modes->points, .s0 = from->s0};
		if (from->length > 0.0)
			status = hawser__lmode_piece_grid(&to->grid, from, rope, omega,
			                                 rope->options.extra + HAWSER__LMODE_FINER, report);
		if (status)
			return status;
		modes->points += to->grid.points;
	}
	return HAWSER_OK;
}

static enum hawser_status allocate(struct hawser_line_modes *modes, struct hawser_report *report)
{
	size_t n = (size_t)modes->n*(size_t)hawser__lmode_parts(modes), points = (size_t)modes->points;

	modes->point = calloc(points, sizeof *modes->point);
	modes->weight = calloc(points, sizeof *modes->weight);
	modes->mode = calloc((size_t)modes->n, sizeof *modes->mode);
	modes->shape = calloc(n*points, 3*sizeof *modes->shape);
	modes->slope = calloc(n*points, 3*sizeof *modes->slope);
	modes->share = calloc((size_t)modes->n*(size_t)modes->spans + 1, sizeof *modes->share);
	modes->mass_at = calloc(n*(size_t)modes->masses + 1, 3*sizeof *modes->mass_at);
	modes->freedom_at = calloc(n*(size_t)modes->freedoms + 1, sizeof *modes->freedom_at);
	if (modes->point && modes->weight && modes->mode && modes->shape && modes->slope && modes->share &&
	    modes->mass_at && modes->freedom_at)
		return HAWSER_OK;
	return hawser__no_memory(report, "line modes");
}

static void place_points(struct hawser_line_modes *modes, const struct hawser__lmode *rope)
{
	for (int i = 0; i < modes->pieces; i++) {
		const struct hawser_line_modes_piece *piece = &modes->piece[i];

		for (int k = 0; k < piece->grid.points; k++) {
			place_point(&modes->point[piece->first + k], rope, &rope->piece[i], piece->grid.s[k]);
			modes->weight[piece->first + k] = piece->grid.weight[k];
		}
	}
}

/* --- one mode --- */

/* Shape and slope on one segment from state and strain. */
static void fill_segment(double *shape, double *slope, const struct hawser_line_modes *modes,
                         const struct hawser__lmode_segment *s, const double *x, const double *strain)
{
	const struct hawser_line_modes_piece *piece = &modes->piece[s->index];
	int points = s->grid.points;

	for (int i = 0; i < points; i++) {
		double *u = shape + 3*(piece->first + i), *v = slope + 3*(piece->first + i);

		if (s->D == 2) {
			double c = s->cosine[i], n = s->sine[i];

			u[0] = c*x[i] + n*x[points + i];
			u[1] = c*x[points + i] - n*x[i];
			v[0] = s->sa*strain[i];
			v[1] = s->sb[i]*strain[points + i];
		} else if (s->sb) {
			u[2] = x[i];
			v[2] = s->sb[i]*strain[i];
		} else {
			u[0] = x[i];
			v[0] = s->sa*strain[i];
			v[1] = modes->point[piece->first + i].curvature*modes->length_unit*x[i];
		}
	}
}

/* What an arc that does not deform moves by: the value of its node or border, [pieces] from the segment
 * before or behind it on the same sheave. */
static double rigid_arc(const struct hawser__lmode *rope, const struct hawser__lmode_system *system,
                        int i,
                        const double *x)
{
	const struct hawser__lmode_piece *piece = &rope->piece[i];

	for (int k = 0; k < system->borders; k++)
		if (system->border[k].sheave == piece->sheave && system->border[k].lane == piece->lane)
			return x[system->border[k].at];
	for (int k = 0; k < system->segments; k++) {
		const struct hawser__lmode_segment *s = &system->segment[k];
		int near = s->index, end = near < i, node = s->node[end];

		if (s->piece->lane != piece->lane || node < 0)
			continue;
		for (int j = end ? near + 1 : i; j <= (end ? i : near - 1); j++)
			if (rope->piece[j].sheave != piece->sheave)
				node = -1;
		if (node >= 0)
			return x[system->node[node].at];
	}
	return 0.0;
}

static void fill_arcs(double *shape, double *slope, const struct hawser_line_modes *modes,
                      const struct hawser__lmode *rope, const struct hawser__lmode_system *system,
                      const double *x)
{
	for (int i = 0; i < rope->pieces; i++) {
		const struct hawser_line_modes_piece *piece = &modes->piece[i];
		double u;

		if (piece->sheave < 0)
			continue;
		u = rigid_arc(rope, system, i, x);
		for (int k = piece->first; k < piece->first + piece->grid.points; k++) {
			shape[3*k] = u;
			slope[3*k + 1] = modes->point[k].curvature*modes->length_unit*u;
		}
	}
}

/* Value of the shape at the beginning (or end) of the piece of a lane that begins (ends) at a mass. */
static void edge_value(double u[3], const struct hawser_line_modes *modes, const double *shape,
                       int piece,
                       int end)
{
	const struct hawser_line_modes_piece *at = &modes->piece[piece];

	if (at->grid.points > 0)
		hawser__grid_at(u, &at->grid, shape + 3*at->first, 3, 3,
		                end ? at->grid.edge[at->grid.elements] : 0.0);
}

/* Displacements of the masses along x, y, z; those of pendulums by their own coordinate. */
static void fill_masses(double *at, const struct hawser_line_modes *modes,
                        const struct hawser__lmode *rope,
                        const struct hawser__lmode_system *system, const double *shape, const double *x)
{
	for (int i = 1; i < rope->pieces; i++) {
		const struct hawser__lmode_piece *piece = &rope->piece[i];
		double u[3] = {0.0}, angle;
		int carrier, from = modes->piece[i].grid.points > 0 ? i : i - 1;

		if (piece->mass < 0 || piece->lane != rope->piece[i - 1].lane)
			continue;
		carrier = hawser__lmode_carrier(rope, piece->lane, piece->mass);
		edge_value(u, modes, shape, from, from < i);
		angle = from < i ? rope->piece[from].angle[1] : piece->angle[0];
		at[3*carrier] = u[0]*cos(angle) - u[1]*sin(angle);
		at[3*carrier + 1] = u[0]*sin(angle) + u[1]*cos(angle);
		at[3*carrier + 2] = u[2];
	}
	for (int i = 0; i < system->pendulums; i++)
		at[3*system->pendulum[i].carrier + (system->plane == HAWSER_OUT_OF_PLANE ? 2 :
		                                    system->pendulum[i].vertical)] = x[system->pendulum[i].at];
}

static void fill_state(struct hawser_line_modes *modes, const struct hawser__lmode *rope,
                       const struct hawser__lmode_system *system, int k, int part, const double *x,
                       const double *strain)
{
	double *shape = hawser__lmode_row(modes->shape, modes, k, part),
		*slope = hawser__lmode_row(modes->slope, modes, k, part);
	int row = k*hawser__lmode_parts(modes) + part;

	if (system->plane == HAWSER_IN_PLANE && rope->options.contact == HAWSER_LINE_ROLL)
		fill_arcs(shape, slope, modes, rope, system, x);
	for (int i = 0; i < system->segments; i++)
		fill_segment(shape, slope, modes, &system->segment[i], x + system->segment[i].at,
		             strain + system->segment[i].strain);
	fill_masses(modes->mass_at + (size_t)row*3*(size_t)modes->masses, modes, rope, system, shape, x);
	for (int i = 0; i < system->borders; i++)
		if (system->border[i].freedom >= 0)
			modes->freedom_at[row*modes->freedoms + system->border[i].freedom] =
				x[system->border[i].at];
}

/* The members that do not depend on a mode. */
static void describe(struct hawser_line_modes *modes, const struct hawser__lmode *rope)
{
	for (int i = 0; i < rope->lanes; i++)
		modes->lane[i] = rope->lane[i];
	modes->lanes = rope->lanes;
	modes->contact = rope->options.contact;
	modes->spans = rope->runs;
	modes->masses = rope->masses;
	modes->freedoms = rope->options.freedoms;
	modes->length_unit = rope->length;
	modes->force_unit = rope->force;
	modes->rho = rope->lane[0]->line->rho;
	modes->time_unit = rope->length*sqrt(modes->rho/rope->force);
	modes->epsilon = rope->epsilon;
	modes->delta = rope->piece[0].delta;
	modes->nu = rope->nu;
	for (int i = 0; i < rope->systems; i++)
		modes->unknowns += rope->system[i].size;
}

static void fill_pair(struct hawser_line_modes *modes, const struct hawser__lmode *rope,
                      const struct hawser__lmode_pairs *from, const struct hawser__lmode_system *system,
                      int k, int pair)
{
	modes->mode[k].omega = from->omega[pair];
	modes->mode[k].residual = from->error[pair];
	if (from->condition)
		modes->mode[k].condition = from->condition[pair];
	modes->iterations = modes->iterations > from->iterations ? modes->iterations : from->iterations;
	for (int part = 0; part < from->parts; part++)
		fill_state(modes, rope, system, k, part,
		           from->x + (size_t)(from->parts*pair + part)*(size_t)system->size,
		           from->strain + (size_t)(from->parts*pair + part)*(size_t)system->strains);
}

enum hawser_status hawser__lmode_fill(struct hawser_line_modes *modes,
                                      const struct hawser__lmode_search *search, double omega,
                                      struct hawser_report *report)
{
	const struct hawser__lmode *rope = search->rope;
	const struct hawser__lmode_choice *choice = search->choice;
	int number[2] = {0}, n = search->n;
	enum hawser_status status;

	modes->n = n;
	modes->gyroscopic = search->pairs[choice->system].parts > 1;
	describe(modes, rope);
	status = place_grids(modes, rope, omega, report);
	if (!status)
		status = allocate(modes, report);
	if (status)
		return status;
	place_points(modes, rope);
	for (int k = 0; k < n; k++) {
		int i = choice[k].system;
		const struct hawser__lmode_system *system = &rope->system[i];

		modes->mode[k].plane = system->plane;
		modes->mode[k].place = k + 1;
		modes->mode[k].number = ++number[system->plane];
		fill_pair(modes, rope, &search->pairs[i], system, k, choice[k].pair);
		hawser__lmode_label(modes, rope, k);
	}
	return HAWSER_OK;
}

void hawser_line_modes_at(double *shape, double *slope, const struct hawser_line_modes *modes, int k,
                          int lane, double s)
{
	int found = -1, parts = hawser__lmode_parts(modes);

	for (int i = 0; i < modes->pieces; i++)
		if (modes->piece[i].lane == lane && modes->piece[i].grid.points > 0 &&
		    (found < 0 || modes->piece[i].s0 <= s))
			found = i;
	for (int part = 0; part < parts; part++) {
		const struct hawser_line_modes_piece *piece = &modes->piece[found];
		double u[3], end = piece->grid.edge[piece->grid.elements];
		double at = fmin(fmax(s - piece->s0, 0.0), end);

		hawser__grid_at(u, &piece->grid, hawser__lmode_row(modes->shape, modes, k, part) +
		                3*piece->first, 3, 3,
		                at);
		for (int c = 0; c < 3; c++)
			shape[3*part + c] = u[c];
		if (!slope)
			continue;
		hawser__grid_at(u, &piece->grid, hawser__lmode_row(modes->slope, modes, k, part) +
		                3*piece->first, 3, 3,
		                at);
		for (int c = 0; c < 3; c++)
			slope[3*part + c] = u[c];
	}
}

enum hawser_status hawser__lmode_add_parts(struct hawser_line_modes *modes,
                                           struct hawser_report *report)
{
	size_t row = 3*(size_t)modes->points, masses = 3*(size_t)modes->masses;
	size_t freedoms = (size_t)modes->freedoms, n = (size_t)modes->n;
	double *shape = calloc(2*n*row + 1, sizeof *shape), *slope = calloc(2*n*row + 1, sizeof *slope);
	double *mass_at = calloc(2*n*masses + 1, sizeof *mass_at);
	double *freedom_at = calloc(2*n*freedoms + 1, sizeof *freedom_at);

	if (!shape || !slope || !mass_at || !freedom_at) {
		free(shape);
		free(slope);
		free(mass_at);
		free(freedom_at);
		return hawser__no_memory(report, "line modes");
	}
	for (size_t k = 0; k < n; k++) {
		memcpy(shape + 2*k*row, modes->shape + k*row, row*sizeof *shape);
		memcpy(slope + 2*k*row, modes->slope + k*row, row*sizeof *slope);
		memcpy(mass_at + 2*k*masses, modes->mass_at + k*masses, masses*sizeof *mass_at);
		memcpy(freedom_at + 2*k*freedoms, modes->freedom_at + k*freedoms, freedoms*sizeof *freedom_at);
	}
	free(modes->shape);
	free(modes->slope);
	free(modes->mass_at);
	free(modes->freedom_at);
	modes->shape = shape;
	modes->slope = slope;
	modes->mass_at = mass_at;
	modes->freedom_at = freedom_at;
	modes->gyroscopic = 1;
	return HAWSER_OK;
}
