/* cli/backbone/mms_result.h - results of multiple scales as table, JSON and picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MMS_RESULT_H
#define HAWSER_CLI_MMS_RESULT_H

#include "cli/frame/view.h"

struct cli_mms_result {
	const struct cli_common *common;
	const struct cli_model *model;
	const struct hawser_modulation *modulation;
	int base;                 /* b: the frequency of the motion is 1/b of that of the load */
	/* the closed form of one mode; NULL if equilibria were followed */
	const struct hawser_primary *primary;
	const struct hawser_primary_curve *curve;
	double from, to;          /* scaled frequencies of the load */
};
/* The modulation equations, and what was neglected. */
void cli_mms_equations(struct hawser__table *table, const struct cli_mms_result *result);
extern const struct hawser__field cli_modulation_field[]; /* of a struct cli_mms_result */
extern const struct cli_showing cli_mms_showing;
enum hawser_status cli_mms_draw(const char *path, const void *result, struct hawser_report *report);

/* --- mms_options.c, for hawser compare mms too --- */

/* Reads "1:1, 4:2", mode:order in any order; of fractions, as 1:1/2, the orders become those of the
 * load's frequency over *base. omega0 follows from the first mode of order 1, else
 * from the first mode. */
enum hawser_status cli_mms_read(struct hawser_resonance *resonance, int *base, const char *text,
                                const struct hawser_rom *rom,
                                struct hawser_report *report) HAWSER_MUST_CHECK;
/* The resonant mode: number `asked` (0: not asked for) or the one that the load drives the most. */
enum hawser_status cli_mms_mode(int *mode, int asked, const struct hawser_rom *rom,
                                struct hawser_report *report) HAWSER_MUST_CHECK;
/* A range, scaled; `centre` and `half` give the ends that the user did not give. */
struct cli_mms_range {
	double centre, half;
	const char *from, *to;
};
enum hawser_status cli_mms_range(double *from, double *to, const struct cli_mms_range *range,
                                 const struct cli_model *model,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- mms_marks.c, for hawser compare mms --- */

enum { CLI_MMS_FOLDS = 8 };
/* Folds of a curve in descending order of the amplitude, and its peak; scaled. */
struct cli_mms_marks {
	int folds;
	double omega[CLI_MMS_FOLDS], a[CLI_MMS_FOLDS];
	double peak_omega, peak;
};
/* Measured by the amplitude of coordinate `mode`. */
void cli_mms_marks(struct cli_mms_marks *marks, const struct hawser_frf *frf, int mode);

#endif
