/* study/accuracy/full_bases.c - the bases of full-order models, one after another.
 *
 * The agreement of two bases that do not resolve the linear modes of the range, or the load, means
 * nothing. Such a basis is skipped without a draft. So is one with as many coordinates as the
 * last: attachments divide the cable into elements, which share the functions out, so that 6 and 8
 * of them may give the same model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/accuracy/accuracy.h"

#define RESOLVED 0.1     /* largest error of the frequencies in the range, relative to the accuracy;
                          * chosen */
#define ROUGHLY 1.0      /* the same for modes up to REACH times the upper end of the range; chosen */
#define LACKS 0.02       /* largest part of the static response to the load that a basis lacks;
                          * chosen */
#define REACH 2.0        /* 2: the second harmonic of the response may be in resonance with them */

#define EACH 6           /* fewest functions between attachments; chosen */

/* Numbers of functions per component, in the order in which they are tried; the last one with bending
 * stiffness alone, where three elements or more share them and many may be the fewest. */
static const int bases[] = {6, 8, 10, 12, 14, 16, 20, 24, 30};
enum { BASES = sizeof bases/sizeof *bases, LARGEST = 24 };

int hawser__accuracy_largest(int asked, const struct hawser_statics *st)
{
	return (asked > 0 ? asked : LARGEST) + (st->bending.EI > 0.0 ? bases[BASES - 1] - LARGEST : 0);
}

int hawser__accuracy_fewest(const struct hawser_statics *st)
{
	return EACH*(st->attachments + 1);
}

/* Whether the basis of the model holds the linear modes and the load. */
static enum hawser_status resolves(int *good, const struct hawser_rom *full,
                                   const struct hawser_accuracy_bases *of, int functions,
                                   struct hawser_report *report)
{
	double lacks = 0.0;
	enum hawser_status status = HAWSER_OK;
	int worst;

	*good = hawser_rom_full_error(&worst, full, of->modes, of->to) <= RESOLVED*of->accuracy &&
	        hawser_rom_full_error(&worst, full, of->modes, REACH*of->to) <= ROUGHLY*of->accuracy;
	if (*good)
		status = hawser_rom_full_lacks(&lacks, &of->modes->statics, of->scene, functions, report);
	*good &= lacks <= LACKS;
	return status;
}

enum hawser_status hawser_accuracy_basis(struct hawser_rom *rom, int *functions,
                                         const struct hawser_accuracy_bases *of, int coordinates,
                                         struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int most = hawser__accuracy_largest(of->most, &of->modes->statics);

	*rom = (struct hawser_rom){.n = 0};
	for (int i = 0; !status && i < BASES && bases[i] <= most; i++) {
		int good = 0;

		if (bases[i] <= *functions)
			continue;
		*functions = bases[i];
		status = hawser_rom_build_full(rom, &of->modes->statics, of->scene, bases[i], report);
		if (!status && rom->n > coordinates)
			status = resolves(&good, rom, of, bases[i], report);
		/* the largest basis of all is tried whatever it resolves */
		if (!status && rom->n > coordinates && (good || (of->most == 0 && bases[i] == most)))
			return HAWSER_OK;
		hawser_rom_clear(rom);
	}
	return status;
}
