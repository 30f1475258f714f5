/* rom/terms/ends.c - displacement and strain by given motions of the ends, to second order.
 *
 *    s_i      factor of the quasi-static shape psi_i (support_shape.c), a periodic function
 *    u_j      coordinates
 *    w_ij     displacement of the condensed modes by the product of two of them (condense.c)
 *
 * The shapes are coordinates of the energy like the modes, with given values (support_energy.c), and
 * they are in displacement and strain: the strains a, b, c of s_i psi_i join those of the modes before
 * squares are taken, and s_i u_j w_ij and s_i s_j w_ij (half of it for i = j) join the response of the
 * condensed modes to products of the coordinates. Either alone is far off: in a nearly inextensible
 * cable (b^2 + c^2)/2 of the ends' motion and of its products with the modes cancels with the
 * strain a of the w_ij to the order of H/EA. The displacement of psi_i itself is in `answer` of
 * harmonics (support.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/grid.h"
#include "rom/condense/condense.h"
#include "rom/terms/ends.h"
#include "rom/terms/history.h"

size_t hawser__ends_pairs(const struct hawser_rom_ends *ends)
{
	return (size_t)ends->count*(size_t)ends->modes + (size_t)ends->count*((size_t)ends->count + 1)/2;
}

void hawser__ends_free(struct hawser_rom_ends *ends)
{
	if (!ends)
		return;
	hawser__hold_clear(&ends->hold);
	free(ends);
}

static int make_second(struct hawser_rom_ends *ends, size_t points, size_t line)
{
	size_t pairs = hawser__ends_pairs(ends);

	ends->second_shape = hawser__hold(&ends->hold, 3*pairs*points + 1, sizeof(double));
	ends->second_slope = hawser__hold(&ends->hold, 3*pairs*points + 1, sizeof(double));
	ends->second_line = hawser__hold(&ends->hold, 3*pairs*line + 1, sizeof(double));
	return !ends->hold.short_of_memory;
}

enum hawser_status hawser__ends_make(struct hawser_rom *rom, int count, int terms, int second,
                                     struct hawser_report *report)
{
	struct hawser_rom_ends *ends = calloc(1, sizeof *ends);
	size_t many = (size_t)count, values = (size_t)terms*many, points = (size_t)rom->shapes.points,
	       line = (size_t)rom->line.points;

	if (!ends)
		return hawser__no_memory(report, "rom");
	rom->ends = ends;
	*ends = (struct hawser_rom_ends){.count = count, .terms = terms, .base = 1, .factor = 1.0,
		.modes = rom->n - rom->inertia.shapes};
	ends->k = hawser__hold(&ends->hold, (size_t)terms + 1, sizeof *ends->k);
	ends->cosine = hawser__hold(&ends->hold, values + 1, sizeof *ends->cosine);
	ends->sine = hawser__hold(&ends->hold, values + 1, sizeof *ends->sine);
	ends->slope = hawser__hold(&ends->hold, 3*many*points + 1, sizeof *ends->slope);
	ends->line = hawser__hold(&ends->hold, 3*many*line + 1, sizeof *ends->line);
	if (ends->hold.short_of_memory || (second && !make_second(ends, points, line)))
		return hawser__no_memory(report, "rom");
	return HAWSER_OK;
}

enum hawser_status hawser__ends_move(struct hawser_rom *rom, const struct hawser__signal *signal,
                                     int count, int second, struct hawser_report *report)
{
	int k[HAWSER__SUPPORT_TOP + 1] = {0}, terms = 0;
	enum hawser_status status;

	for (int h = 0; h <= HAWSER__SUPPORT_TOP; h++) {
		int any = 0;

		for (int i = 0; i < count; i++)
			any |= signal[i].c[h] != 0.0 || signal[i].s[h] != 0.0;
		if (any)
			k[terms++] = h;
	}
	status = hawser__ends_make(rom, count, terms, second, report);
	for (int t = 0; !status && t < terms; t++) {
		rom->ends->k[t] = k[t];
		for (int i = 0; i < count; i++) {
			rom->ends->cosine[t*count + i] = signal[i].c[k[t]];
			rom->ends->sine[t*count + i] = signal[i].s[k[t]];
		}
	}
	return status;
}

/* --- of a scene --- */

enum hawser_status hawser__ends_set(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser__support_shapes *shapes,
                                    const struct hawser_scene *scene, struct hawser_report *report)
{
	struct hawser__signal signal[HAWSER__SUPPORT_MOST];
	int number[HAWSER__SUPPORT_MOST] = {0}, count = 0, given = hawser__support_given(scene);
	int points = rom->shapes.points, line = rom->line.points;
	size_t each = 3*(size_t)modes->grid.points;
	enum hawser_status status;

	for (int i = 0; i < shapes->count; i++)
		if (hawser__support_factor(&signal[count], scene, i, &modes->statics))
			number[count++] = i;
	if (count == 0)
		return HAWSER_OK;
	status = given ? hawser__ends_make(rom, count, 0, 0, report)
	         : hawser__ends_move(rom, signal, count, 0, report);
	if (status)
		return status;
	rom->ends->given = given;
	memcpy(rom->ends->number, number, sizeof number);
	for (int i = 0; i < count; i++)
		for (int p = 0; p < points + line; p++)
			hawser__grid_at(p < points ? rom->ends->slope + 3*((size_t)i*(size_t)points + (size_t)p)
			                : rom->ends->line + 3*((size_t)i*(size_t)line + (size_t)(p - points)),
			                &modes->grid, shapes->strain + (size_t)number[i]*each, 3, 3,
			                p < points ? rom->shapes.s[p] : rom->line.s[p - points]);
	return HAWSER_OK;
}

enum hawser_status hawser__ends_condensed(struct hawser_rom *rom, const struct hawser_modes *wide,
                                          const struct hawser__condensed *condensed,
                                          struct hawser_report *report)
{
	struct hawser_rom_ends *ends = rom->ends;

	if (!ends->second_shape && !make_second(ends, (size_t)rom->shapes.points, (size_t)rom->line.points))
		return hawser__no_memory(report, "rom");
	return hawser__condensed_second(ends->second_shape, ends->second_slope, ends->second_line, rom,
	                                condensed, wide, ends->modes*(ends->modes + 1)/2,
	                                (int)hawser__ends_pairs(ends), report);
}

/* --- at an instant --- */

static void given(const struct hawser_rom *rom, double *s, double t, int rate)
{
	for (int i = 0; i < rom->ends->count && rom->history; i++)
		s[i] = hawser__history_value(rom->history, rom->ends->number[i], t, rate);
}

void hawser__ends_at(const struct hawser_rom *rom, double *s, const struct hawser_rom_moment *moment)
{
	const struct hawser_rom_ends *ends = rom->ends;

	memset(s, 0, (size_t)ends->count*sizeof *s);
	if (ends->given)
		given(rom, s, moment->time, 0);
	for (int t = 0; t < ends->terms; t++) {
		double k = (double)ends->k[t]*ends->base;
		double c = ends->factor*cos(k*moment->tau), sine = ends->factor*sin(k*moment->tau);

		for (int i = 0; i < ends->count; i++)
			s[i] += c*ends->cosine[t*ends->count + i] + sine*ends->sine[t*ends->count + i];
	}
}

void hawser__ends_rate(const struct hawser_rom *rom, double *rate,
                       const struct hawser_rom_moment *moment)
{
	const struct hawser_rom_ends *ends = rom->ends;

	memset(rate, 0, (size_t)ends->count*sizeof *rate);
	if (ends->given)
		given(rom, rate, moment->time, 1);
	for (int t = 0; t < ends->terms; t++) {
		double k = (double)ends->k[t]*ends->base, W = k*moment->omega*ends->factor;
		double c = W*cos(k*moment->tau), sine = W*sin(k*moment->tau);

		for (int i = 0; i < ends->count; i++)
			rate[i] += c*ends->sine[t*ends->count + i] - sine*ends->cosine[t*ends->count + i];
	}
}

static void add(double out[3], const double *at, double factor)
{
	for (int i = 0; i < 3; i++)
		out[i] += factor*at[i];
}

void hawser__ends_second(const struct hawser_rom_ends *ends, double out[3], const double *field,
                         int points, int p, const double *u, const double *s)
{
	const double *at = field + 3*(size_t)p;
	size_t stride = 3*(size_t)points;

	for (int i = 0; i < ends->count; i++) {
		for (int k = 0; k < ends->modes; k++, at += stride)
			add(out, at, s[i]*u[k]);
		for (int k = 0; k <= i; k++, at += stride)
			add(out, at, k == i ? 0.5*s[i]*s[i] : s[i]*s[k]);
	}
}

void hawser__ends_second_rate(const struct hawser_rom_ends *ends, double out[3], const double *field,
                              int points, int p, const double *u, const double *s, const double *v,
                              const double *rate)
{
	const double *at = field + 3*(size_t)p;
	size_t stride = 3*(size_t)points;

	for (int i = 0; i < ends->count; i++) {
		for (int k = 0; k < ends->modes; k++, at += stride)
			add(out, at, s[i]*v[k] + rate[i]*u[k]);
		for (int k = 0; k <= i; k++, at += stride)
			add(out, at, k == i ? s[i]*rate[i] : s[i]*rate[k] + rate[i]*s[k]);
	}
}
