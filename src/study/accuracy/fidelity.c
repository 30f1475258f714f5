/* study/accuracy/fidelity.c - the table of fidelities: how each builds its model and computes
 * its response; and the parser of lists of fidelities. SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/locale.h"
#include "core/report.h"
#include "study/accuracy/respond.h"
#include "study/accuracy/survey.h"

/* Condensed modes below this multiple of the highest kept frequency have their own response to the
 * load (hawser_rom_know_below). For modes above it and a forcing frequency up to the highest kept
 * one, the series omits at most (1/4)^4 of their static response. */
static const double known_to = 4.0;

static enum hawser_status build(struct hawser_rom *rom, const struct hawser_statics *statics,
                                const struct hawser_scene *scene, double n,
                                enum hawser_condensation condense, struct hawser_report *report)
{
	struct hawser_scene changed = *scene; /* its `name` is owned by the caller */
	struct hawser_modes_options options = {.n = (int)n, .basis = scene->model.basis};
	struct hawser_modes modes;
	enum hawser_status status;

	changed.model.condense = condense;
	if (hawser_scene_written(scene, "model.tolerance"))
		options.tolerance = scene->model.tolerance;
	status = hawser_modes_solve(&modes, statics, &options, report);
	if (status)
		return status;
	status = hawser_rom_build(rom, &modes, &changed, report);
	if (!status)
		status = hawser_rom_know_below(rom, &modes, &changed,
		                               known_to*modes.mode[modes.n - 1].omega, report);
	if (status)
		hawser_rom_clear(rom);
	hawser_modes_clear(&modes);
	return status;
}

static enum hawser_status build_raw(struct hawser_rom *rom, const struct hawser_statics *statics,
                                    const struct hawser_scene *scene, double n,
                                    struct hawser_report *report)
{
	return build(rom, statics, scene, n, HAWSER_CONDENSE_NONE, report);
}

static enum hawser_status build_condensed(struct hawser_rom *rom,
                                          const struct hawser_statics *statics,
                                          const struct hawser_scene *scene, double n,
                                          struct hawser_report *report)
{
	return build(rom, statics, scene, n, HAWSER_CONDENSE_STATIC, report);
}

static enum hawser_status build_full(struct hawser_rom *rom, const struct hawser_statics *statics,
                                     const struct hawser_scene *scene, double functions,
                                     struct hawser_report *report)
{
	return hawser_rom_build_full(rom, statics, scene, (int)functions, report);
}

static const struct hawser_fidelity rows[] = {
	{"multiple-scales", "each mode's primary resonance alone, in closed form, after condensation",
	 "Bertrand 2022, 4.3.2 (corrected); doc/theory-study.md", HAWSER_NUMBER_MODES, 0, 16,
	 build_condensed, hawser__study_scales, hawser__estimate_scales},
	{"raw", "the first N modes, all others at rest", "Bertrand 2022, 4.2", HAWSER_NUMBER_MODES, 0, 9,
	 build_raw, hawser__study_trace, hawser__estimate_raw},
	{"condensed", "the first N modes, all others following them statically",
	 "doc/theory-rom.md, Condensation", HAWSER_NUMBER_MODES, 1, 9, build_condensed,
	 hawser__study_trace, hawser__estimate_condensed},
	{"chosen", "the N modes that matter most to the response, all others following them statically",
	 "doc/theory-rom.md, Which modes are kept", HAWSER_NUMBER_MODES, 1, 9, NULL,
	 hawser__study_chosen, hawser__estimate_chosen},
	{"auto", "as many modes and such as an accuracy of A % needs, all others following",
	 "doc/theory-rom.md, Which modes are kept", HAWSER_NUMBER_PERCENT, 1, 0, NULL,
	 hawser__study_auto, hawser__estimate_auto},
	{"full", "the exact strain energy on all functions of a basis, by harmonic balance",
	 "doc/theory-rom.md, The full-order model", HAWSER_NUMBER_FUNCTIONS, 1, 16, build_full,
	 hawser__study_balance, hawser__estimate_full},
};
enum { row_count = sizeof rows/sizeof *rows };

const struct hawser_fidelity *hawser_fidelity(int index)
{
	return index >= 0 && index < row_count ? &rows[index] : NULL;
}

/* --- lists --- */

static enum hawser_status no_such(struct hawser_report *report, const char *entry)
{
	char names[200] = "";

	for (int i = 0; i < row_count; i++)
		hawser__append(names, sizeof names, ", ", "%s %s", rows[i].name,
		               rows[i].counts == HAWSER_NUMBER_PERCENT ? "A" : "N");
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "study",
	                    "there is no fidelity \"%s\": write %s, separated by commas", entry,
	                    names);
}

static enum hawser_status add(struct hawser_fidelity_choice *choice, int *count, int most,
                              const struct hawser_fidelity *row, double number,
                              struct hawser_report *report)
{
	if (*count == most)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "study",
		                    "more than %d fidelities: leave some out", most);
	choice += (*count)++;
	choice->fidelity = row;
	choice->number = number;
	if (number > 0.0)
		snprintf(choice->name, sizeof choice->name, "%s %.6g%s", row->name, number,
		         row->counts == HAWSER_NUMBER_PERCENT ? "%" : "");
	else
		snprintf(choice->name, sizeof choice->name, "%s", row->name);
	return HAWSER_OK;
}

/* An accuracy: "0.5", "0.5 %" or "0.5%". */
static enum hawser_status percent(double *number, const struct hawser_fidelity *row,
                                  const char *text, const char *entry,
                                  struct hawser_report *report)
{
	struct hawser__locale locale;
	char *end;

	hawser__locale_begin(&locale);
	*number = strtod(text, &end);
	hawser__locale_end(&locale);
	end += strspn(end, " ");
	if (end == text || strcmp(end + (*end == '%'), "") != 0 || !(*number >= 0.001) || *number > 50.0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "study",
		                    "\"%s\": write %s with an accuracy in percent, from 0.001 to 50",
		                    entry, row->name);
	return HAWSER_OK;
}

/* "9" or "5-9". */
static enum hawser_status whole(double *low, double *high, const struct hawser_fidelity *row,
                                const char *text, const char *entry, struct hawser_report *report)
{
	char *end;
	long first = strtol(text, &end, 10), last = first;

	if (end != text && *end == '-')
		last = strtol(end + 1, &end, 10);
	if (end == text || *end || first < 1 || last < first || last > 100000)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "study",
		                    "\"%s\": write %s with a number of %s from 1 on, or a range such as "
		                    "5-9", entry, row->name, row->counts == HAWSER_NUMBER_MODES ? "modes"
		                    : "functions a component");
	*low = (double)first;
	*high = (double)last;
	return HAWSER_OK;
}

/* One entry without surrounding blanks. */
static enum hawser_status read_entry(struct hawser_fidelity_choice *choice, int *count, int most,
                                     const char *entry, struct hawser_report *report)
{
	size_t length = strcspn(entry, " \t:");
	const char *rest = entry + length + strspn(entry + length, " \t:");

	for (int i = 0; i < row_count; i++) {
		enum hawser_status status = HAWSER_OK;
		double low = rows[i].usual, high = low;

		if (strlen(rows[i].name) != length || strncmp(rows[i].name, entry, length) != 0)
			continue;
		if (*rest && rows[i].counts == HAWSER_NUMBER_PERCENT) {
			status = percent(&low, &rows[i], rest, entry, report);
			high = low;
		} else if (*rest) {
			status = whole(&low, &high, &rows[i], rest, entry, report);
		}
		for (double n = low; !status && n <= high; n += 1.0)
			status = add(choice, count, most, &rows[i], n, report);
		return status;
	}
	return no_such(report, entry);
}

enum hawser_status hawser_fidelities_read(struct hawser_fidelity_choice *choice, int *count,
                                          const char *list, int most,
                                          struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	const char *end;

	*count = 0;
	for (; !status; list = end + 1) {
		char entry[64];
		size_t length;

		list += strspn(list, " \t");
		length = strcspn(list, ",");
		end = list + length;
		while (length > 0 && isspace((unsigned char)list[length - 1]))
			length--;
		snprintf(entry, sizeof entry, "%.*s", (int)length, list);
		status = read_entry(choice, count, most, entry, report);
		if (!*end)
			break;
	}
	return status;
}
