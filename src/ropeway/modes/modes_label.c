/* ropeway/modes/modes_label.c - shares, family, sign and participation of modes of a rope over sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "ropeway/modes/modes.h"

/* As in label.c: the sign is set where the dominant component first reaches this part of its
 * largest. */
static const double sign_at = 0.3;

/* The span of a mass, or -1: that of the piece behind it, or before. */
static int span_of(const struct hawser__lmode *rope, int piece)
{
	return rope->piece[piece].run >= 0 ? rope->piece[piece].run : rope->piece[piece - 1].run;
}

static double mass_of(const struct hawser__lmode *rope, const struct hawser__lmode_piece *piece)
{
	const struct hawser_line *line = rope->lane[piece->lane]->line;

	return (line->mass[piece->mass].mass + line->mass[piece->mass].body)/(line->rho*rope->length);
}

/* Shares of |P|^2, |Q|^2, |B|^2 of the rope, then of the masses along their axes, and those of
 * spans. */
static void shares(double share[3], struct hawser_line_modes *modes, const struct hawser__lmode *rope,
                   int k, int part)
{
	const double *shape = hawser__lmode_row(modes->shape, modes, k, part);
	const double *at = modes->mass_at + (size_t)(k*hawser__lmode_parts(modes) +
	                                             part)*3*(size_t)modes->masses;
	double *span = modes->share + (size_t)k*(size_t)modes->spans;

	for (int i = 0; i < modes->pieces; i++) {
		const struct hawser_line_modes_piece *piece = &modes->piece[i];
		double own[3] = {0.0};
		int to = piece->span;

		for (int p = piece->first; p < piece->first + piece->grid.points; p++)
			for (int c = 0; c < 3; c++)
				own[c] += modes->weight[p]*shape[3*p + c]*shape[3*p + c];
		if (rope->piece[i].mass >= 0 && i > 0) {
			const double *u = at + 3*hawser__lmode_carrier(rope, piece->lane, rope->piece[i].mass);
			double m = mass_of(rope, &rope->piece[i]), angle = rope->piece[i].angle[0];
			double P = u[0]*cos(angle) + u[1]*sin(angle), Q = u[1]*cos(angle) - u[0]*sin(angle);

			share[0] += m*P*P;
			share[1] += m*Q*Q;
			share[2] += m*u[2]*u[2];
			if (span_of(rope, i) >= 0)
				span[span_of(rope, i)] += m*(u[0]*u[0] + u[1]*u[1] + u[2]*u[2]);
		}
		for (int c = 0; c < 3; c++)
			share[c] += own[c];
		if (to >= 0)
			span[to] += own[0] + own[1] + own[2];
	}
}

static double sign_of(const struct hawser_line_modes *modes, int k, int f)
{
	const double *shape = hawser__lmode_row(modes->shape, modes, k, 0);
	double largest = 0.0;

	for (int i = 0; i < modes->points; i++)
		largest = fmax(largest, fabs(shape[3*i + f]));
	for (int i = 0; i < modes->points; i++)
		if (fabs(shape[3*i + f]) >= sign_at*largest)
			return shape[3*i + f] < 0.0 ? -1.0 : 1.0;
	return 1.0;
}

static void participate(struct hawser_mode *mode, const struct hawser_line_modes *modes,
                        const struct hawser__lmode *rope, int k)
{
	const double *shape = hawser__lmode_row(modes->shape, modes, k, 0);
	double *Gamma = mode->participation, all = 0.0;

	for (int p = 0; p < modes->points; p++) {
		double c = cos(modes->point[p].angle), s = sin(modes->point[p].angle), w = modes->weight[p];

		all += w;
		Gamma[0] += w*(c*shape[3*p] - s*shape[3*p + 1]);
		Gamma[1] += w*(s*shape[3*p] + c*shape[3*p + 1]);
		Gamma[2] += w*shape[3*p + 2];
	}
	for (int i = 1; i < modes->pieces; i++) {
		const double *u;
		double m;

		if (rope->piece[i].mass < 0)
			continue;
		m = mass_of(rope, &rope->piece[i]);
		u = modes->mass_at + 3*((size_t)k*(size_t)modes->masses +
		                        (size_t)hawser__lmode_carrier(rope, rope->piece[i].lane,
		                                                     rope->piece[i].mass));
		all += m;
		for (int c = 0; c < 3; c++)
			Gamma[c] += m*u[c];
	}
	for (int c = 0; c < 3; c++)
		mode->effective_mass[c] = Gamma[c]*Gamma[c]/all;
}

static void turn(struct hawser_line_modes *modes, int k)
{
	size_t row = 3*(size_t)modes->points, masses = 3*(size_t)modes->masses;

	for (size_t i = 0; i < row; i++) {
		modes->shape[(size_t)k*row + i] *= -1.0;
		modes->slope[(size_t)k*row + i] *= -1.0;
	}
	for (size_t i = 0; i < masses; i++)
		modes->mass_at[(size_t)k*masses + i] *= -1.0;
	for (int i = 0; i < modes->freedoms; i++)
		modes->freedom_at[k*modes->freedoms + i] *= -1.0;
}

/* Share of the kinetic energy that belongs to waves running downstream, as in gyroscopic.c, of the rope
 * between its sheaves. */
static double downstream_of(const struct hawser_line_modes *modes, const struct hawser__lmode *rope,
                            int k)
{
	const double *x = hawser__lmode_row(modes->shape, modes, k, 0),
		*y = hawser__lmode_row(modes->shape, modes, k, 1);
	const double *dx = hawser__lmode_row(modes->slope, modes, k, 0),
		*dy = hawser__lmode_row(modes->slope, modes, k, 1);
	double with = 0.0, against = 0.0, omega = modes->mode[k].omega;

	for (int i = 0; i < modes->pieces; i++) {
		const struct hawser_line_modes_piece *piece = &modes->piece[i];
		double nu = hawser__lmode_nu(rope, piece->lane);

		for (int p = piece->first; p < piece->first + piece->grid.points && piece->sheave < 0; p++) {
			const struct hawser_line_modes_point *at = &modes->point[p];
			double across = at->T/modes->force_unit/at->stretch - nu*nu;
			const double speed2[3] = {modes->epsilon > 0.0 ? 1.0/modes->epsilon - nu*nu : 0.0, across,
			                          across};

			for (int c = modes->epsilon > 0.0 ? 0 : 1; c < 3; c++) {
				double own = sqrt(speed2[c] + nu*nu), a = (own - nu)/omega, b = (own + nu)/omega;
				int j = 3*p + c;

				with += modes->weight[p]*(pow(a*dx[j] + y[j], 2.0) + pow(a*dy[j] - x[j], 2.0));
				against += modes->weight[p]*(pow(b*dx[j] - y[j], 2.0) + pow(b*dy[j] + x[j], 2.0));
			}
		}
	}
	return with + against > 0.0 ? with/(with + against) : 0.5;
}

void hawser__lmode_label(struct hawser_line_modes *modes, const struct hawser__lmode *rope, int k)
{
	struct hawser_mode *mode = &modes->mode[k];
	double share[3] = {0.0}, all;
	int f;

	for (int part = 0; part < hawser__lmode_parts(modes); part++)
		shares(share, modes, rope, k, part);
	all = share[0] + share[1] + share[2];
	all = all > 0.0 ? all : 1.0;
	mode->axial_share = share[0]/all;
	mode->normal_share = share[1]/all;
	mode->out_of_plane_share = share[2]/all;
	f = mode->plane == HAWSER_OUT_OF_PLANE ? 2 : share[0] > share[1] ? 0 : 1;
	mode->family = f == 0 ? HAWSER_LONGITUDINAL : HAWSER_TRANSVERSE;
	mode->symmetry = HAWSER_MIXED;
	if (modes->gyroscopic) {
		mode->downstream = downstream_of(modes, rope, k);
		return;
	}
	mode->condition = 1.0;
	mode->downstream = 0.5;
	if (sign_of(modes, k, f) < 0.0)
		turn(modes, k);
	participate(mode, modes, rope, k);
}
