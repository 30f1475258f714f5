/* Loci of bifurcations: what is refused, and names.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/locus.h>

#include "tests/tap.h"

static void refused(const struct hawser_rom_family *family, const struct hawser_locus_options *options,
                    const char *what)
{
	struct hawser_locus locus = {.n = 0};
	struct hawser_report report = {.message = ""};
	enum hawser_status status = hawser_locus_trace(&locus, family, options, &report);

	ok(status == HAWSER_ERR_ARGUMENT && strstr(report.message, what), "%s", report.message);
	hawser_locus_clear(&locus);
}

CASE(unit_locus)
{
	const struct hawser_locus_options good = {.kind = HAWSER_FOLD, .from = 0.8, .to = 1.8,
		.parameter_from = 0.5, .parameter_to = 2.0, .at = 1.0};
	struct hawser_locus_options bad = good;
	struct hawser_rom_family family;
	struct hawser_locus locus;
	struct hawser_rom rom;
	struct hawser_report report = {.message = ""};
	const char *path = source_file("tests/reference/duffing-nlvib-01.json");

	if (!ok(!hawser_rom_open(&rom, path, NULL), "%s read", path) ||
	    !ok(!hawser_factor_open(&family, &rom, HAWSER_FACTOR_LOAD, 1.0, NULL), "a family"))
		return done_testing();
	bad.kind = HAWSER_SLACK;
	refused(&family, &bad, "loci are those of folds");
	bad = good;
	bad.from = -1.0;
	refused(&family, &bad, "frequencies positive");
	bad = good;
	bad.parameter_to = bad.parameter_from;
	refused(&family, &bad, "not empty");
	bad = good;
	bad.at = 2.5;
	refused(&family, &bad, "outside its range");
	ok(strcmp(hawser_locus_special_name(HAWSER_TORUS, HAWSER_LOCUS_WITH_FOLD), "fold-torus") == 0 &&
	   strcmp(hawser_locus_special_name(HAWSER_FOLD, HAWSER_LOCUS_WITH_TORUS), "fold-torus") == 0 &&
	   strcmp(hawser_locus_special_name(HAWSER_FOLD, HAWSER_LOCUS_SPECIALS), "unknown") == 0, "names");
	bad = good;
	bad.max_points = 7;
	ok(!hawser_locus_trace(&locus, &family, &bad, &report), "traced %s", report.message);
	ok(locus.curves == 2 && locus.curve[0].end[0] == HAWSER_LOCUS_MAX_POINTS &&
	   locus.curve[0].points == 13, "a limit of points counts in each direction");
	bad = good;
	bad.most_work = 1.05*hawser_orbit_work(&locus.response.cost, &rom);
	hawser_locus_clear(&locus);
	ok(!hawser_locus_trace(&locus, &family, &bad, &report) && locus.costly && locus.curves > 0 &&
	   locus.curve[locus.curves - 1].end[0] == HAWSER_LOCUS_WORK, "and one of work for all");
	hawser_locus_clear(&locus);
	bad.most_work *= 0.1;
	ok(hawser_locus_trace(&locus, &family, &bad, &report) == HAWSER_ERR_CONVERGENCE &&
	   strstr(report.message, "before a locus was begun"), "%s", report.message);
	hawser_locus_clear(&locus);
	hawser_locus_clear(NULL);
	hawser_factor_close(&family);
	hawser_rom_clear(&rom);
	return done_testing();
}
