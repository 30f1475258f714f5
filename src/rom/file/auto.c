/* rom/file/auto.c - a model as AUTO-07p equations and constants.
 *
 * AUTO requires an autonomous system. Therefore an oscillator with the attracting circle x =
 * sin(Omega t), y = cos(Omega t) is appended. Its own multipliers are 1 (AUTO's trivial one) and
 * exp(-4 pi/Omega), which never cross the unit circle. cos(k Omega t) and sin(k Omega t) are the
 * parts of (y + i x)^k.
 *
 *    U(1..n) u     U(n+1..2n) du/dt     U(2n+1) sin     U(2n+2) cos     PAR(1) Omega     PAR(11) period
 *    PAR(2), PAR(3) factors of the load and of D, 1 for the model
 *
 * Entries are stored in DATA statements, and loops run over them: written out term by term, the
 * cubic terms of 20 modes would take the compiler minutes. Both Jacobians are exact. The first
 * orbit is a converged one (cycle.c), since AUTO's first step has no globalisation.
 *
 * E. J. Doedel et al., AUTO-07P (2012), ch. 3, 10 and the demonstration `frc`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/file.h"
#include "core/report.h"
#include "core/settle.h"
#include "rom/auto_text.h" /* made of texts/auto.f90 */
#include "rom/choose/cycle.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

/* A double in Fortran, or in Python with mark 'e', whatever the locale's decimal point is. */
static const char *number_in(char out[32], double value, char mark)
{
	snprintf(out, 32, "%.17e", value);
	for (char *c = out; *c; c++) {
		if (*c == 'e')
			*c = mark;
		else if (!isdigit((unsigned char)*c) && *c != '-' && *c != '+')
			*c = '.';
	}
	return out;
}

static const char *number(char out[32], double value)
{
	return number_in(out, value, 'D');
}

/* "DATA Ai(1,7),Ai(2,7),A(7)/1,2,3.0D0/": entry `at` (from 1) of list `name`, indices from 0. */
static void put_entry(FILE *out, const char *name, int at, const int *index, int count, double value)
{
	char text[32];

	fprintf(out, "  DATA ");
	for (int i = 0; i < count; i++)
		fprintf(out, "%sI(%d,%d),", name, i + 1, at);
	fprintf(out, "%s(%d)/", name, at);
	for (int i = 0; i < count; i++)
		fprintf(out, "%d,", index[i] + 1);
	fprintf(out, "%s/\n", number(text, value));
}

static void declare(FILE *out, const char *name, int count, int indices)
{
	fprintf(out, "  INTEGER, PARAMETER :: N%s = %d\n", name, count);
	fprintf(out, "  INTEGER, SAVE :: %sI(%d,%d)\n", name, indices, count ? count : 1);
	fprintf(out, "  DOUBLE PRECISION, SAVE :: %s(%d)\n", name, count ? count : 1);
}

/* Nonzero entries of matrix [n][columns], each with the third index `harmonic` if that is >= 0;
 * written to `out` unless it is NULL. Returns their number. */
static int entries(FILE *out, const char *name, int at, const double *value, int n, int columns,
                   int harmonic)
{
	int count = 0;

	for (int i = 0; value && i < n*columns; i++) {
		const int index[3] = {i/columns, columns > 1 ? i%columns : harmonic, harmonic};

		if (value[i] == 0.0)
			continue;
		count++;
		if (out)
			put_entry(out, name, at + count, index,
			          1 + (columns > 1) + (harmonic >= 0), value[i]);
	}
	return count;
}

static const double *part_of(const struct hawser_harmonic *h, char part)
{
	return part == 'f' ? h->f : part == 'D' ? h->D : h->K;
}

/* f, D or K of the harmonics. */
static void put_harmonics(FILE *out, const struct hawser_rom *rom, const char *name, char part)
{
	int count = 0, columns = part == 'f' ? 1 : rom->n;

	for (int h = 0; h < rom->harmonics; h++)
		count += entries(NULL, name, 0, part_of(&rom->harmonic[h], part), rom->n, columns, h);
	declare(out, name, count, columns > 1 || part != 'f' ? 3 : 2);
	count = 0;
	for (int h = 0; h < rom->harmonics; h++) {
		const double *value = part_of(&rom->harmonic[h], part);

		if (part == 'f' || rom->n > 1) {
			count += entries(out, name, count, value, rom->n, columns, h);
		} else if (value && value[0] != 0.0) {
			const int index[3] = {0, 0, h};

			put_entry(out, name, ++count, index, 3, value[0]);
		}
	}
}

/* Q of the harmonics. */
static void put_varying(FILE *out, const struct hawser_rom *rom)
{
	int count = 0;

	for (int h = 0; h < rom->harmonics; h++)
		count += rom->harmonic[h].quads;
	declare(out, "EQ", count, 4);
	count = 0;
	for (int h = 0; h < rom->harmonics; h++)
		for (int i = 0; i < rom->harmonic[h].quads; i++) {
			const struct hawser_quad *q = &rom->harmonic[h].Q[i];

			put_entry(out, "EQ", ++count, (int[]){q->j, q->k, q->l, h}, 4, q->value);
		}
}

/* Terms of the model, h = -1, or of a harmonic: entries from `at` on. Returns the last one. */
static int put_terms(FILE *out, const struct hawser_term *term, int terms, int h, int at, int n)
{
	for (int i = 0; i < terms; i++) {
		const struct hawser_term *t = &term[i];
		char text[32];

		at++; /* a list of all its indices would be too long for a line */
		fprintf(out, "  DATA T(%d)/%s/\n  DATA TI(:,%d)/%d,%d,%d", at, number(text, t->value), at,
		        t->j + 1, h + 1, t->factors);
		for (int f = 0; f < HAWSER_TERM_FACTORS; f++)
			fprintf(out, ",%d", f >= t->factors ? 0
			        : t->factor[f] + 1 + (f >= t->factors - t->rates ? n : 0));
		fputs("/\n", out);
	}
	return at;
}

static void put_all_terms(FILE *out, const struct hawser_rom *rom)
{
	int count = rom->terms;

	for (int h = 0; h < rom->harmonics; h++)
		count += rom->harmonic[h].terms;
	declare(out, "T", count, 3 + HAWSER_TERM_FACTORS);
	count = put_terms(out, rom->term, rom->terms, -1, 0, rom->n);
	for (int h = 0; h < rom->harmonics; h++)
		count = put_terms(out, rom->harmonic[h].term, rom->harmonic[h].terms, h, count, rom->n);
}

static void put_matrix(FILE *out, const char *name, const double *value, int n)
{
	const int first[2] = {0, 0};

	declare(out, name, entries(NULL, name, 0, value, n, n, -1), 2);
	if (n > 1)
		entries(out, name, 0, value, n, n, -1);
	else if (value[0] != 0.0)
		put_entry(out, name, 1, first, 2, value[0]);
}

/* All numbers of the model, as declarations and DATA. */
static void put_model(FILE *out, const struct hawser_rom *rom)
{
	int highest = 1, many = rom->harmonics ? rom->harmonics : 1;

	for (int h = 0; h < rom->harmonics; h++)
		highest = rom->harmonic[h].k > highest ? rom->harmonic[h].k : highest;
	fprintf(out, "  INTEGER, PARAMETER :: N = %d, NH = %d, KH = %d\n", rom->n, rom->harmonics,
	        highest);
	fprintf(out, "  INTEGER, SAVE :: HK(%d), HS(%d), HP(%d), HL(%d)\n", many, many, many, many);
	for (int h = 0; h < rom->harmonics; h++)
		fprintf(out, "  DATA HK(%d),HS(%d),HP(%d),HL(%d)/%d,%d,%d,%d/\n", h + 1, h + 1, h + 1, h + 1,
		        rom->harmonic[h].k, rom->harmonic[h].phase == HAWSER_SIN,
		        rom->harmonic[h].omega_power,
		        rom->harmonic[h].load_power > 1 ? rom->harmonic[h].load_power : 1);
	put_matrix(out, "D", rom->D, rom->n);
	put_matrix(out, "K", rom->K, rom->n);
	declare(out, "Q", rom->quads, 3);
	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		put_entry(out, "Q", i + 1, (int[]){q->j, q->k, q->l}, 3, q->value);
	}
	declare(out, "C", rom->cubics, 4);
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		put_entry(out, "C", i + 1, (int[]){c->j, c->k, c->l, c->m}, 4, c->value);
	}
	put_harmonics(out, rom, "EF", 'f');
	put_harmonics(out, rom, "ED", 'D');
	put_harmonics(out, rom, "EK", 'K');
	put_varying(out, rom);
	put_all_terms(out, rom);
}

static void put_start(FILE *out, const struct hawser__cycle *cycle, double omega)
{
	char a[32], b[32];

	fprintf(out, "  INTEGER, PARAMETER :: N = %d, H = %d\n", cycle->n, cycle->order);
	fprintf(out, "  DOUBLE PRECISION, SAVE :: A(0:%d,%d), B(0:%d,%d)\n", cycle->order, cycle->n,
	        cycle->order, cycle->n);
	for (int h = 0; h <= cycle->order; h++)
		for (int j = 0; j < cycle->n; j++)
			fprintf(out, "  DATA A(%d,%d),B(%d,%d)/%s,%s/\n", h, j + 1, h, j + 1,
			        number(a, cycle->cosine[h*cycle->n + j]),
			        number(b, cycle->sine[h*cycle->n + j]));
	fprintf(out, "  DOUBLE PRECISION, PARAMETER :: OMEGA = %s\n", number(a, omega));
}

static void put_lines(FILE *out, const char *const *line)
{
	for (; *line; line++)
		fputs(*line, out);
}

static void put_equations(FILE *out, const struct hawser_rom *rom, const struct hawser__cycle *cycle,
                          double omega)
{
	fprintf(out, "! A reduced model of %d coordinates, written by hawser %s (hawser-rom(5)).\n",
	        rom->n, hawser_version());
	put_lines(out, auto_head);
	put_model(out, rom);
	put_lines(out, auto_func);
	put_start(out, cycle, omega);
	put_lines(out, auto_tail);
}

/* --- the constants --- */

/* The same as below of terms, whose velocities are of a motion of frequency omega. */
static double length_of_terms(const struct hawser_rom *rom, int j, int own, double omega)
{
	double stiffness = fabs(rom->K[j*rom->n + j]), length = INFINITY;

	for (int i = 0; i < rom->terms; i++) {
		const struct hawser_term *t = &rom->term[i];
		int counts = t->j == j && t->factors > 1;

		for (int f = 0; own && f < t->factors; f++)
			counts &= t->factor[f] == j;
		if (counts)
			length = fmin(length, pow(stiffness/fabs(t->value*pow(omega, t->rates)),
			                          1.0/(t->factors - 1)));
	}
	return length;
}

/* Amplitude at which the nonlinear terms of equation j equal the linear one: for its own coordinate
 * if `own`, otherwise for any. INFINITY if there is none. */
static double nonlinear_length(const struct hawser_rom *rom, int j, int own, double omega)
{
	double stiffness = fabs(rom->K[j*rom->n + j]), length = length_of_terms(rom, j, own, omega);

	for (int i = 0; i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		if (q->j == j && (!own || (q->k == j && q->l == j)))
			length = fmin(length, stiffness/fabs(q->value));
	}
	for (int i = 0; i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		if (c->j == j && (!own || (c->k == j && c->m == j)))
			length = fmin(length, sqrt(stiffness/fabs(c->value)));
	}
	return length;
}

/* The amplitude of coordinate j that is large for a continuation. */
static double length_of(const struct hawser_rom *rom, const struct hawser__cycle *cycle, int j,
                        double omega)
{
	double length = nonlinear_length(rom, j, 1, omega);

	if (!(length > 0.0 && length < INFINITY))
		length = nonlinear_length(rom, j, 0, omega);
	if (length > 0.0 && length < INFINITY)
		return length;
	length = 0.0;
	for (int h = 0; h <= cycle->order; h++)
		length += fabs(cycle->cosine[h*rom->n + j]) + fabs(cycle->sine[h*rom->n + j]);
	return length > 0.0 ? 10.0*length : 1.0;
}

/* AUTO's arclength is sum THU U^2 + Omega^2. With coordinates of 1e-3, an Omega of 10 and unit
 * weights, it would not depend on the coordinates, and steps would jump between the branches of the
 * response. The weights therefore make the nonlinear length count as `share` of the middle
 * frequency, and the oscillator not at all. */
static void put_weights(FILE *out, const struct hawser_rom *rom, const struct hawser__cycle *cycle,
                        const struct hawser_auto_options *o)
{
	const double share = 0.14;
	double middle = 0.5*(o->from + o->to);
	char text[32];

	fprintf(out, "THL={11:0.0}\nTHU={");
	for (int i = 0; i < 2*rom->n; i++) {
		double weight = share*middle/length_of(rom, cycle, i%rom->n, middle);

		if (i >= rom->n)
			weight /= middle;
		fprintf(out, "%d:%s, ", i + 1, number_in(text, weight*weight, 'e'));
	}
	fprintf(out, "%d:0.0, %d:0.0}\n", 2*rom->n + 1, 2*rom->n + 2);
}

static void put_constants(FILE *out, const struct hawser_rom *rom, const struct hawser__cycle *cycle,
                          const struct hawser_auto_options *o)
{
	char a[32], b[32], c[32];
	double low = fmin(o->from, o->to), high = fmax(o->from, o->to);
	double sign = o->to > o->from ? 1.0 : -1.0;

	fprintf(out, "# Forced response of a reduced model, written by hawser %s.\n",
	        hawser_version());
	fprintf(out, "NDIM=%d, IPS=2, IRS=0, ILP=1, ISP=2, ISW=1\n", 2*rom->n + 2);
	fprintf(out, "parnames={1:'Omega', 2:'load', 3:'damping', 11:'period'}\n");
	fprintf(out, "ICP=[1,11]\n");
	fprintf(out, "NTST=%d, NCOL=%d, IAD=3, JAC=1\n", o->ntst, o->ncol);
	fprintf(out, "NMX=%d, NPR=%d, MXBF=0, IID=2, ITMX=20, ITNW=4, NWTN=3\n", o->nmx, o->nmx);
	fprintf(out, "EPSL=%s, EPSU=%s, EPSS=%s\n", number(a, o->tolerance),
	        number(b, o->tolerance), number(c, 100.0*o->tolerance));
	fprintf(out, "DS=%s, DSMIN=%s, DSMAX=%s, IADS=1\n", number(a, sign*o->ds),
	        number(b, 1e-5*o->ds), number(c, o->dsmax));
	fprintf(out, "RL0=%s, RL1=%s\n", number(a, low), number(b, high));
	put_weights(out, rom, cycle, o);
}

/* --- files --- */

/* The parts of an exported file. */
struct content {
	const struct hawser_rom *rom;
	const struct hawser__cycle *cycle;
	const struct hawser_auto_options *options;
	const char *base; /* the stem without its folder */
};

enum { EQUATIONS, CONSTANTS, SCRIPT, FILES };

static void put_file(FILE *out, int kind, const struct content *c)
{
	if (kind == EQUATIONS)
		put_equations(out, c->rom, c->cycle, c->options->from);
	else if (kind == CONSTANTS)
		put_constants(out, c->rom, c->cycle, c->options);
	else
		fprintf(out, "# Run with: auto-07p %s.auto\nrun('%s')\nsave('%s')\n", c->base, c->base,
		        c->base);
}

static char *path_of(const char *stem, const char *base, int kind)
{
	size_t size = strlen(stem) + 8;
	char *path = malloc(size);

	if (path && kind == CONSTANTS)
		snprintf(path, size, "%.*sc.%s", (int)(base - stem), stem, base);
	else if (path)
		snprintf(path, size, "%s%s", stem, kind == EQUATIONS ? ".f90" : ".auto");
	return path;
}

static enum hawser_status write_file(const char *path, int kind, const struct content *c,
                                     struct hawser_report *report)
{
	enum hawser_status status;
	char *text = NULL;
	size_t size = 0;
	FILE *out = open_memstream(&text, &size);

	if (out)
		put_file(out, kind, c);
	/* when memory is short, glibc's fclose returns 0 but sets no text */
	if (!out || fclose(out) != 0 || !text)
		status = hawser__no_memory(report, "rom");
	else
		status = hawser__file_put(path, text, size, report);
	free(text);
	return status;
}

/* Write all files; on failure remove those that did not exist before. */
static enum hawser_status write_files(const char *stem, const struct content *c,
                                      struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	char *path[FILES] = {NULL};
	int old[FILES] = {0}, done = 0;

	for (int kind = 0; !status && kind < FILES; kind++) {
		path[kind] = path_of(stem, c->base, kind);
		if (!path[kind])
			status = hawser__no_memory(report, "rom");
		else
			old[kind] = access(path[kind], F_OK) == 0;
	}
	while (!status && done < FILES) {
		status = write_file(path[done], done, c, report);
		done += !status;
	}
	for (int kind = 0; kind < FILES; kind++) {
		if (status && kind < done && !old[kind])
			unlink(path[kind]);
		free(path[kind]);
	}
	return status;
}

void hawser_auto_settle(struct hawser_auto_options *options)
{
	hawser__settle(&options->tolerance, 1e-9);
	hawser__settle_count(&options->ntst, 80);
	hawser__settle_count(&options->ncol, 4);
	hawser__settle_count(&options->nmx, 20000);
}

static enum hawser_status check(const struct hawser_rom *rom, const char *base,
                                const struct hawser_auto_options *o, struct hawser_report *report)
{
	if (rom->drag)
		return hawser__drag_refuse(rom, "an export to AUTO", report);
	if (rom->plug)
		return hawser__more_refuse(rom, "an export to AUTO", report);
	if (rom->periods > 1)
		return hawser__periods_refuse(rom, "an export", report);
	if (rom->exact)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a model with the exact strain energy can't be exported: its "
		                    "equations are not polynomials, take model.energy: quartic");
	if (rom->ramp)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a model whose speed changes once and for all (travel.braking) has no "
		                    "periodic response to export");
	if (!base[0] || strspn(base, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-")
	    != strlen(base))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "\"%s\" can't name an AUTO run: use letters, digits, _ and - only",
		                    base);
	if (!(o->from > 0.0) || !(o->to > 0.0) || o->from == o->to || !isfinite(o->from + o->to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a response from Omega = %g to %g (scaled): two different positive "
		                    "frequencies are needed", o->from, o->to);
	if (!(o->tolerance > 0.0 && o->tolerance < 1.0) || o->ntst < 1 || o->ncol < 2 ||
	    o->ncol > 7 || o->nmx < 1 || !(o->ds >= 0.0) || !(o->dsmax >= 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "AUTO's constants: tolerance %g (0 to 1), NTST %d (1 or more), "
		                    "NCOL %d (2 to 7), NMX %d (1 or more), DS %g and DSMAX %g (0 or "
		                    "more)", o->tolerance, o->ntst, o->ncol, o->nmx, o->ds, o->dsmax);
	if (rom->harmonics == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "the model has no harmonics, so it has no forced response to export");
	return HAWSER_OK;
}

enum hawser_status hawser_rom_export_auto(const struct hawser_rom *rom, const char *stem,
                                          const struct hawser_auto_options *options,
                                          struct hawser_report *report)
{
	const char *slash = strrchr(stem, '/');
	struct hawser_auto_options filled = *options;
	struct hawser__cycle cycle;
	const struct content content = {rom, &cycle, &filled, slash ? slash + 1 : stem};
	enum hawser_status status;

	hawser_auto_settle(&filled);
	status = check(rom, content.base, &filled, report);
	if (status)
		return status;
	if (filled.dsmax == 0.0)
		filled.dsmax = fabs(filled.to - filled.from)/400.0;
	if (filled.ds == 0.0)
		filled.ds = filled.dsmax/10.0;
	status = hawser__cycle_find(&cycle, rom, filled.from, report);
	if (!status)
		status = write_files(stem, &content, report);
	hawser__cycle_clear(&cycle);
	return status;
}
