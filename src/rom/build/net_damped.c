/* rom/build/net_damped.c - damped modes of a net: eigenvalues of u'' + D u' + K u = 0 in the basis of
 * its lowest modes, with some more than are asked for. The error is estimated by a smaller basis.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include <hawser/net_rom.h>

#include "core/hold.h"
#include "core/report.h"

enum { MORE = 8, ROW = 101 /* LAPACK_ROW_MAJOR */ };

/* Eigenvalues re, im [2n] and, unless NULL, their vectors [2n][2n] of the leading n coordinates. */
static enum hawser_status solve(double *re, double *im, double *vector, const struct hawser_rom *rom,
                                int n, struct hawser_report *report)
{
	int m = 2*n;
	double *A = hawser__numbers((size_t)m, (size_t)m);
	lapack_int info;

	if (!A)
		return hawser__no_memory(report, "modes");
	for (int j = 0; j < n; j++) {
		A[j*m + n + j] = 1.0;
		for (int k = 0; k < n; k++) {
			A[(n + j)*m + k] = -rom->K[j*rom->n + k];
			A[(n + j)*m + n + k] = -rom->D[j*rom->n + k];
		}
	}
	info = LAPACKE_dgeev(ROW, 'N', vector ? 'V' : 'N', m, A, m, re, im, NULL, m, vector, m);
	free(A);
	return info ? hawser__fail(report, HAWSER_ERR_CONVERGENCE, "modes", "the eigenvalues of the damped "
	                           "net were not found: ask for fewer modes") : HAWSER_OK;
}

/* Distance of the nearest of `count` eigenvalues, over the modulus. */
static double nearest(double x, double y, const double *re, const double *im, int count)
{
	double least = INFINITY;

	for (int i = 0; i < count; i++)
		least = fmin(least, hypot(re[i] - x, im[i] - y));
	return least/hypot(x, y);
}

static int by_frequency(const void *a, const void *b)
{
	const struct hawser_damped_mode *x = a, *y = b;

	return (x->omega > y->omega) - (x->omega < y->omega);
}

/* The plane of an eigenvector: that of the larger share of the kinetic energy. */
static enum hawser_plane plane_of(const double *vector, int i, const struct hawser_modes *modes)
{
	double share[2] = {0.0};
	int m = 2*modes->n;

	for (int j = 0; j < modes->n; j++)
		share[modes->mode[j].plane == HAWSER_OUT_OF_PLANE] +=
			vector[j*m + i]*vector[j*m + i] + vector[j*m + i + 1]*vector[j*m + i + 1];
	return share[1] > share[0] ? HAWSER_OUT_OF_PLANE : HAWSER_IN_PLANE;
}

/* The n lowest that oscillate. */
static enum hawser_status fill(struct hawser_damped *damped, int n, const struct hawser_rom *rom,
                               const struct hawser_modes *modes, double *number,
                               struct hawser_report *report)
{
	int m = 2*rom->n, fewer = rom->n > MORE ? rom->n - MORE/2 : rom->n, count = 0, found[2] = {0};
	double *re = number, *im = re + m, *other = im + m, *with = other + m, *vector = with + m;
	enum hawser_status status = solve(re, im, vector, rom, rom->n, report);

	if (!status)
		status = solve(other, with, NULL, rom, fewer, report);
	for (int i = 0; i < m && !status; i++)
		if (im[i] > 0.0)
			damped->mode[count++] = (struct hawser_damped_mode){.omega = im[i], .re = re[i],
				.ratio = -re[i]/hypot(re[i], im[i]), .plane = plane_of(vector, i, modes),
				.residual = nearest(re[i], im[i], other, with, 2*fewer)};
	qsort(damped->mode, (size_t)count, sizeof *damped->mode, by_frequency);
	damped->n = count < n ? count : n;
	for (int i = 0; i < damped->n; i++)
		damped->mode[i].number = ++found[damped->mode[i].plane == HAWSER_OUT_OF_PLANE];
	for (int i = 0; i < m && !status && damped->n > 0; i++)
		if (im[i] == 0.0 && fabs(re[i]) <= damped->mode[damped->n - 1].omega)
			damped->slowest = damped->overdamped++ ? fmax(damped->slowest, re[i]) : re[i];
	return status;
}

enum hawser_status hawser_net_damped_solve(struct hawser_damped *damped, const struct hawser_net *net,
                                           int n, struct hawser_report *report)
{
	const struct hawser_net_rom_options options = {
		.n = n + MORE < HAWSER_NET_ROM_MODES ? n + MORE : HAWSER_NET_ROM_MODES, .linear = 1};
	struct hawser_modes modes;
	struct hawser_rom rom;
	enum hawser_status status = hawser_net_rom_build(&rom, &modes, net, &options, report);
	size_t m = 2*(size_t)rom.n;
	double *number = status ? NULL : hawser__numbers(m, m + 4);

	*damped = (struct hawser_damped){.n = 0};
	if (status)
		return status;
	damped->mode = calloc((size_t)rom.n + 1, sizeof *damped->mode);
	damped->time_unit = rom.time;
	damped->basis = rom.n;
	status = number && damped->mode ? fill(damped, n, &rom, &modes, number, report)
	                                : hawser__no_memory(report, "modes");
	free(number);
	hawser_rom_clear(&rom);
	hawser_modes_clear(&modes);
	if (status)
		hawser_damped_clear(damped);
	return status;
}
