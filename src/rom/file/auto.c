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
 * Models of which equilibria and limit cycles are followed have no oscillator, and PAR(1) is a
 * parameter of theirs: each coefficient is a Chebyshev sum over it.
 *
 * Entries are stored in DATA statements, and loops run over them: written out term by term, the
 * cubic terms of 20 modes would take the compiler minutes. Both Jacobians are exact. The first
 * orbit is a converged one (cycle.c), since AUTO's first step has no globalisation.
 *
 * E. J. Doedel et al., AUTO-07P (2012), ch. 3, 10 and the demonstration `frc`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/file.h"
#include "core/report.h"
#include "core/settle.h"
#include "rom/auto_text.h" /* made of texts/auto.f90 */
#include "rom/file/auto.h"
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

static int degree_of(const struct hawser__auto *of)
{
	return of->coefficient ? of->degree : 0;
}

/* The rows, as declarations and DATA. */
static void put_rows(FILE *out, const struct hawser__auto *of)
{
	int degree = degree_of(of), n = of->rom->first ? 0 : of->rom->n;

	fprintf(out, "  INTEGER, PARAMETER :: NR = %d, DEG = %d\n"
	        "  INTEGER, SAVE :: RI(%d,%d)\n  DOUBLE PRECISION, SAVE :: A(0:DEG,%d)\n", of->rows, degree,
	        4 + HAWSER_TERM_FACTORS, of->rows, of->rows);
	for (int i = 0; i < of->rows; i++) {
		const struct hawser__row *row = &of->row[i];
		char text[32];

		/* a list of all the indices would be too long for a line */
		fprintf(out, "  DATA RI(:,%d)/%d,%d,%d,%d", i + 1, n + row->j + 1, row->h, row->damping,
		        row->factors);
		for (int f = 0; f < HAWSER_TERM_FACTORS; f++)
			fprintf(out, ",%d", f < row->factors ? row->factor[f] + 1 : 0);
		fputs("/\n", out);
		for (int k = 0; k <= degree; k++)
			fprintf(out, "  DATA A(%d,%d)/%s/\n", k, i + 1,
			        number(text, of->coefficient ? of->coefficient[i*(degree + 1) + k] : row->value));
	}
}

/* All numbers of the model. */
static void put_model(FILE *out, const struct hawser__auto *of)
{
	const struct hawser_rom *rom = of->rom;
	int highest = 1, many = rom->harmonics ? rom->harmonics : 1;
	char from[32], to[32];

	for (int h = 0; h < rom->harmonics; h++)
		highest = rom->harmonic[h].k > highest ? rom->harmonic[h].k : highest;
	fprintf(out, "  INTEGER, PARAMETER :: N = %d, NV = %d, NH = %d, KH = %d\n"
	        "  LOGICAL, PARAMETER :: OWN = .%s.\n"
	        "  DOUBLE PRECISION, PARAMETER :: FROM = %s, TO = %s\n", rom->n, rom->first ? 0 : rom->n,
	        rom->harmonics, highest, of->name ? "TRUE" : "FALSE", number(from, of->options->from),
	        number(to, of->options->to));
	fprintf(out, "  INTEGER, SAVE :: HK(%d), HS(%d), HP(%d), HL(%d)\n", many, many, many, many);
	for (int h = 0; h < rom->harmonics; h++)
		fprintf(out, "  DATA HK(%d),HS(%d),HP(%d),HL(%d)/%d,%d,%d,%d/\n", h + 1, h + 1, h + 1, h + 1,
		        rom->harmonic[h].k, rom->harmonic[h].phase == HAWSER_SIN,
		        rom->harmonic[h].omega_power,
		        rom->harmonic[h].load_power > 1 ? rom->harmonic[h].load_power : 1);
	put_rows(out, of);
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

/* The first equilibrium. */
static void put_rest(FILE *out, const struct hawser__auto *of)
{
	char text[32];

	fprintf(out, "  PAR(1) = %s\n", number(text, of->begin));
	for (int j = 0; j < of->rom->n; j++)
		fprintf(out, "  U(%d) = %s\n", j + 1, number(text, of->rest[j]));
}

static void put_equations(FILE *out, const struct hawser__auto *of)
{
	fprintf(out, "! A reduced model of %d coordinates, written by hawser %s (hawser-rom(5)).\n",
	        of->rom->n, hawser_version());
	put_lines(out, of->name ? auto_own : auto_forced);
	put_lines(out, auto_head);
	put_model(out, of);
	put_lines(out, auto_func);
	if (!of->name)
		put_start(out, of->cycle, of->options->from);
	put_lines(out, of->name ? auto_rest : auto_orbit);
	if (of->name)
		put_rest(out, of);
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

static void put_constants(FILE *out, const struct hawser__auto *of)
{
	const struct hawser_auto_options *o = of->options;
	char a[32], b[32], c[32];
	double low = fmin(o->from, o->to), high = fmax(o->from, o->to);
	double sign = o->to > o->from ? 1.0 : -1.0;
	int n = of->rom->n;

	fprintf(out, "# %s of a reduced model, written by hawser %s.\n",
	        of->name ? "Equilibria" : "Forced response", hawser_version());
	fprintf(out, "NDIM=%d, IPS=%d, IRS=0, ILP=1, ISP=2, ISW=1\n",
	        of->rom->first ? n : of->name ? 2*n : 2*n + 2, of->name ? 1 : 2);
	fprintf(out, "parnames={1:'%s', 2:'load', 3:'damping', 11:'period'}\n",
	        of->name ? of->name : "Omega");
	fprintf(out, "ICP=[1%s]\n", of->name ? "" : ",11");
	fprintf(out, "NTST=%d, NCOL=%d, IAD=3, JAC=1\n", o->ntst, o->ncol);
	fprintf(out, "NMX=%d, NPR=%d, MXBF=0, IID=2, ITMX=20, ITNW=4, NWTN=3\n", o->nmx, o->nmx);
	fprintf(out, "EPSL=%s, EPSU=%s, EPSS=%s\n", number(a, o->tolerance),
	        number(b, o->tolerance), number(c, 100.0*o->tolerance));
	fprintf(out, "DS=%s, DSMIN=%s, DSMAX=%s, IADS=1\n", number(a, sign*o->ds),
	        number(b, 1e-5*o->ds), number(c, o->dsmax));
	fprintf(out, "RL0=%s, RL1=%s\n", number(a, low), number(b, high));
	if (!of->name)
		put_weights(out, of->rom, of->cycle, o);
}

/* --- files --- */

enum { EQUATIONS, CONSTANTS, SCRIPT, FILES };

static void put_file(FILE *out, int kind, const struct hawser__auto *of, const char *base)
{
	if (kind == EQUATIONS)
		put_equations(out, of);
	else if (kind == CONSTANTS)
		put_constants(out, of);
	else if (of->name) /* equilibria, those that begin on them, limit cycles from Hopf points */
		fprintf(out, "# Run with: auto-07p %s.auto\nall = run('%s')\nfor point in all('BP'):\n"
		        "    all = all + run(point, ISW=-1)\nfor hopf in all('HB'):\n"
		        "    all = all + run(hopf, IPS=2, ICP=[1,11])\nsave(all, '%s')\n", base, base, base);
	else
		fprintf(out, "# Run with: auto-07p %s.auto\nrun('%s')\nsave('%s')\n", base, base, base);
}

/* The last part of the name of files. */
static const char *base_of(const char *stem)
{
	const char *slash = strrchr(stem, '/');

	return slash ? slash + 1 : stem;
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

static enum hawser_status write_file(const char *path, int kind, const struct hawser__auto *of,
                                     const char *base, struct hawser_report *report)
{
	enum hawser_status status;
	char *text = NULL;
	size_t size = 0;
	FILE *out = open_memstream(&text, &size);

	if (out)
		put_file(out, kind, of, base);
	/* when memory is short, glibc's fclose returns 0 but sets no text */
	if (!out || fclose(out) != 0 || !text)
		status = hawser__no_memory(report, "rom");
	else
		status = hawser__file_put(path, text, size, report);
	free(text);
	return status;
}

enum hawser_status hawser__auto_write(const struct hawser__auto *of, const char *stem,
                                      struct hawser_report *report)
{
	const char *base = base_of(stem);
	enum hawser_status status = HAWSER_OK;
	char *path[FILES] = {NULL};
	int old[FILES] = {0}, done = 0;

	for (int kind = 0; !status && kind < FILES; kind++) {
		path[kind] = path_of(stem, base, kind);
		if (!path[kind])
			status = hawser__no_memory(report, "rom");
		else
			old[kind] = access(path[kind], F_OK) == 0;
	}
	while (!status && done < FILES) {
		status = write_file(path[done], done, of, base, report);
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

/* What a forced response needs besides. */
static enum hawser_status check_forced(const struct hawser_rom *rom,
                                       const struct hawser_auto_options *o,
                                       struct hawser_report *report)
{
	if (!(o->from > 0.0) || !(o->to > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a response from Omega = %g to %g (scaled): two different positive "
		                    "frequencies are needed", o->from, o->to);
	return hawser_rom_autonomous(rom)
	       ? hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
	                      "nothing excites the model, so it has no forced response to export: its "
	                      "equilibria and limit cycles go with --over KEY=FROM:TO") : HAWSER_OK;
}

enum hawser_status hawser__auto_check(const struct hawser_rom *rom, const char *stem,
                                      struct hawser_auto_options *o, struct hawser_report *report)
{
	const char *base = base_of(stem);

	hawser_auto_settle(o);
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
	if (o->from == o->to || !isfinite(o->from + o->to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a range from %g to %g: two different numbers are needed", o->from, o->to);
	if (!(o->tolerance > 0.0 && o->tolerance < 1.0) || o->ntst < 1 || o->ncol < 2 ||
	    o->ncol > 7 || o->nmx < 1 || !(o->ds >= 0.0) || !(o->dsmax >= 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "AUTO's constants: tolerance %g (0 to 1), NTST %d (1 or more), "
		                    "NCOL %d (2 to 7), NMX %d (1 or more), DS %g and DSMAX %g (0 or "
		                    "more)", o->tolerance, o->ntst, o->ncol, o->nmx, o->ds, o->dsmax);
	if (o->dsmax == 0.0)
		o->dsmax = fabs(o->to - o->from)/400.0;
	if (o->ds == 0.0)
		o->ds = o->dsmax/10.0;
	return HAWSER_OK;
}

enum hawser_status hawser_rom_export_auto(const struct hawser_rom *rom, const char *stem,
                                          const struct hawser_auto_options *options,
                                          struct hawser_report *report)
{
	struct hawser_auto_options filled = *options;
	struct hawser__cycle cycle;
	struct hawser__row *row;
	struct hawser__auto of = {.rom = rom, .cycle = &cycle, .options = &filled};
	enum hawser_status status = hawser__auto_check(rom, stem, &filled, report);

	if (!status)
		status = check_forced(rom, &filled, report);
	if (status)
		return status;
	hawser__rows(&row, &of.rows, rom);
	of.row = row;
	status = row ? hawser__cycle_find(&cycle, rom, filled.from, report)
	             : hawser__no_memory(report, "rom");
	if (!status)
		status = hawser__auto_write(&of, stem, report);
	if (row)
		hawser__cycle_clear(&cycle);
	free(row);
	return status;
}
