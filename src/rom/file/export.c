/* rom/file/export.c - the equations for COCO, MATCONT and BifurcationKit.
 *
 *    x        state (u, v), indices from 1: u_1 ... u_n, v_1 ... v_n
 *    row      j, h, value, i_1 ... i_d: value * wave_h * x_i1 ... x_id on the right side of equation j,
 *             with h = 0 for none and i = 0 for no factor
 *    wave_h   load^load_power Omega^omega_power cos|sin(k theta)
 *
 * Every force of a model is such a row. The files have the rows as a table, and loops over it for the
 * right side and its derivatives, which are the same in all: a loop is shorter than thousands of
 * products written out, and no compiler has to read those. COCO takes theta = Omega t. The other two
 * continue autonomous systems only, so that an oscillator with the attracting circle (sin, cos) is
 * appended, as for AUTO-07p (auto.c).
 *
 * H. Dankowicz and F. Schilder, Recipes for Continuation (2013); W. Govaerts, Yu. A. Kuznetsov et al.,
 * MATCONT; R. Veltz, BifurcationKit.jl (2020).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/file.h"
#include "core/report.h"
#include "rom/export_text.h" /* made of texts/export.m and export.jl */
#include "rom/file/auto.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"

enum { LONGEST = 60 }; /* of a name of a function in MATLAB, which allows 63 */

static const struct hawser_export_format formats[] = {
	{"auto", "AUTO-07p", ".f90"},
	{"coco", "COCO", ".m"},
	{"matcont", "MATCONT", ".m"},
	{"bifurcationkit", "BifurcationKit", ".jl"},
};
enum { AUTO, COCO, MATCONT, BIFURCATIONKIT, FORMATS };

const struct hawser_export_format *hawser_export_format(int index)
{
	return index >= 0 && index < FORMATS ? &formats[index] : NULL;
}

/* value, with a decimal point in every locale. */
static void put_number(FILE *out, double value)
{
	char text[40];

	snprintf(text, sizeof text, "%.17e", value);
	for (char *c = text; *c; c++)
		if (!isdigit((unsigned char)*c) && !strchr("+-e", *c))
			*c = '.';
	fputs(text, out);
}

static void put_row(FILE *out, const struct hawser__row *row, int julia, int widest)
{
	fprintf(out, julia ? "    (%d, %d, " : "    %d %d ", row->j + 1, row->h);
	put_number(out, row->value);
	fputs(julia ? ", [" : "", out);
	for (int i = 0; i < (julia ? row->factors : widest); i++)
		fprintf(out, julia ? "%s%d" : "%s %d", julia && i ? ", " : "",
		        i < row->factors ? row->factor[i] + 1 : 0);
	fputs(julia ? "]),\n" : "\n", out);
}

struct exported {
	const struct hawser_rom *rom;
	struct hawser__row *row; /* [rows] */
	int rows, format;
	const char *name;
};

/* The function or constants with the numbers of the model. */
static void put_model(FILE *out, const struct exported *of)
{
	const struct hawser_rom *rom = of->rom;
	int julia = of->format == BIFURCATIONKIT, widest = 0;

	for (int i = 0; i < of->rows; i++)
		widest = of->row[i].factors > widest ? of->row[i].factors : widest;
	if (julia)
		fprintf(out, "const n = %d\n# k, 1 for a sine, power of Omega, power of the load\n"
		             "const harmonics = NTuple{4,Int}[\n", rom->n);
	else
		fprintf(out, "function [n, H, T] = model()\nn = %d;\n%% k, 1 for a sine, power of Omega, "
		        "power of "
		             "the load\nH = [\n", rom->n);
	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *harmonic = &rom->harmonic[h];
		int load = harmonic->load_power > 1 ? harmonic->load_power : 1;

		fprintf(out, julia ? "    (%d, %d, %d, %d),\n" : "    %d %d %d %d\n", harmonic->k,
		        harmonic->phase == HAWSER_SIN, harmonic->omega_power, load);
	}
	fputs(julia ? "]\n# equation, harmonic or 0, value, factors\n"
	              "const rows = Tuple{Int,Int,Float64,Vector{Int}}[\n"
	            : "];\n% equation, harmonic or 0, value, factors\nT = [\n", out);
	for (int i = 0; i < of->rows; i++)
		put_row(out, &of->row[i], julia, widest);
	fputs(julia ? "]\n" : "];\nend\n", out);
}

/* Text in which every $ stands for the name. */
static void put_text(FILE *out, const char *const *text, const char *name)
{
	for (; text && *text; text++)
		for (const char *c = *text; *c; c++)
			if (*c == '$')
				fputs(name, out);
			else
				fputc(*c, out);
}

static void put_file(FILE *out, const struct exported *of)
{
	const struct hawser_rom *rom = of->rom;
	const char *name = of->name;
	int format = of->format;
	const char *mark = format == BIFURCATIONKIT ? "#" : "%";
	static const char *const *const texts[][4] = {{coco_begin, coco_middle, matlab_sums, NULL},
	                                              {matcont_begin, matcont_middle, matlab_sums, NULL},
	                                              {julia_begin, NULL, NULL, julia_end}};
	const char *const *const *text = texts[format - COCO];

	if (format == BIFURCATIONKIT)
		fprintf(out, "# A reduced model of %d coordinates, written by hawser %s (hawser-rom(5)).\n",
		        rom->n,
		        hawser_version());
	put_text(out, text[0], name);
	if (format != BIFURCATIONKIT)
		fprintf(out, "%s A reduced model of %d coordinates, written by hawser %s (hawser-rom(5)).\n",
		        mark,
		        rom->n, hawser_version());
	put_text(out, text[1], name);
	put_text(out, text[2], name);
	put_model(out, of);
	put_text(out, text[3], name);
}

static enum hawser_status check(const struct hawser_rom *rom, const char *name,
                                struct hawser_report *report)
{
	size_t length = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_");

	if (rom->drag)
		return hawser__drag_refuse(rom, "an export", report);
	if (rom->plug)
		return hawser__more_refuse(rom, "an export", report);
	if (rom->periods > 1)
		return hawser__periods_refuse(rom, "an export", report);
	if (rom->exact || rom->ramp)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "only models with polynomial equations and periodic forces are "
		                    "exported: this one has %s", rom->exact
		                    ? "the exact strain energy: take model.energy: quartic"
		                    : "a ramp (travel.braking)");
	if (!isalpha((unsigned char)name[0]) || name[length] || length > LONGEST)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "\"%s\" can't name a function: use a letter, then up to %d letters, digits "
		                    "and _", name, LONGEST - 1);
	return HAWSER_OK;
}

enum hawser_status hawser_rom_export(const struct hawser_rom *rom, const char *format, const char *stem,
                                     struct hawser_report *report)
{
	const char *slash = strrchr(stem, '/'), *name = slash ? slash + 1 : stem;
	enum hawser_status status = check(rom, name, report);
	struct exported content = {.rom = rom, .name = name};
	char *text = NULL, *path;
	size_t size = 0;
	FILE *out;
	int k = COCO;

	while (k < FORMATS && strcmp(formats[k].name, format) != 0)
		k++;
	if (k == FORMATS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "%s is no format of hawser_rom_export: write coco, "
			"matcont or bifurcationkit",
		                    format);
	if (status)
		return status;
	content.format = k;
	hawser__rows(&content.row, &content.rows, rom);
	path = malloc(strlen(stem) + 8);
	out = open_memstream(&text, &size);
	if (out && content.row)
		put_file(out, &content);
	/* when memory is short, glibc's fclose returns 0 but sets no text */
	if (!out || fclose(out) != 0 || !text || !path || !content.row) {
		status = hawser__no_memory(report, "rom");
	} else {
		snprintf(path, strlen(stem) + 8, "%s%s", stem, formats[k].suffix);
		status = hawser__file_put(path, text, size, report);
	}
	free(content.row);
	free(path);
	free(text);
	return status;
}
