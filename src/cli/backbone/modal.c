/* cli/backbone/modal.c - models whose K is not diagonal, in the coordinates of their modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "cli/backbone/backbone.h"
#include "core/append.h"
#include "core/report.h"

enum { SAID = 600, NAMED = 6 }; /* characters; modes whose shapes are said */

/* "mode 1 = 0.707 u_1 + 0.707 u_2; ..." */
static void say(const double *V, int n)
{
	char text[SAID];

	snprintf(text, sizeof text, "K is not diagonal: the coordinates of this result are those of the "
	         "model's modes");
	for (int i = 0; i < n && i < NAMED; i++) {
		hawser__append(text, sizeof text, i ? "; " : ", ", "mode %d =", i + 1);
		for (int j = 0; j < n && j < NAMED; j++)
			hawser__append(text, sizeof text, " ", "%+.4g u_%d", V[j*n + i], j + 1);
	}
	if (n > NAMED)
		hawser__append(text, sizeof text, "", " ...");
	cli_warn(text);
}

enum hawser_status cli_model_load_modal(struct cli_model *model, const struct cli_common *common,
                                        int n, struct hawser_report *report)
{
	enum hawser_status status = cli_model_load(model, common, n, report);
	double *V;

	if (status || model->automatic || hawser_rom_off_diagonal(&model->rom) <= 1e-12)
		return status;
	V = malloc((size_t)model->rom.n*(size_t)model->rom.n*sizeof *V);
	status = V ? hawser_rom_modal(&model->rom, V, report) : hawser__no_memory(report, "rom");
	if (!status)
		say(V, model->rom.n);
	free(V);
	return status;
}
