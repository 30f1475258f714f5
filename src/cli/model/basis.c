/* cli/model/basis.c - the basis of a full-order model (model.energy: exact), checked against the linear
 * modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/frame/view.h"
#include "core/report.h"

enum { FEWEST = 12, MOST = 48 }; /* largest number of modes computed: beyond them a range is
                                  * reported as far as it was checked */

/* Quadratic terms cause motions at twice the forcing frequency. */
static const double reach = 2.0;
/* Larger errors of a frequency are a warning, since the response's width is of that order or less; so
 * is a larger lack of the load. */
static const double coarse = 0.01;

enum hawser_status cli_modes_up_to(struct hawser_modes *modes, const struct hawser_statics *statics,
                                   double to, struct hawser_report *report)
{
	struct hawser_modes_options options = {.n = FEWEST};
	enum hawser_status status = hawser_modes_solve(modes, statics, &options, report);

	while (!status && modes->mode[modes->n - 1].omega < to && options.n < MOST) {
		options.n *= 2;
		hawser_modes_clear(modes);
		status = hawser_modes_solve(modes, statics, &options, report);
	}
	return status;
}

static enum hawser_status refuse(const struct cli_basis *basis, const struct hawser_mode *mode,
                                 double omega, struct hawser_report *report)
{
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "basis", basis->functions, basis->error,
	                       "the full-order model of %d functions a component is off by %.1e (relative) "
	                       "in the frequency of %s mode %d, %.6g rad/s, and from 1 on nothing is known "
	                       "of the cable's motion: raise model.basis, or leave it out",
	                       basis->functions, basis->error, hawser_plane_name(mode->plane),
	                       mode->number, omega);
}

enum hawser_status cli_basis_check(struct cli_model *model, double omega, struct hawser_report *report)
{
	struct cli_basis *basis = &model->basis;
	struct hawser_modes modes;
	enum hawser_status status;
	double to = reach*omega;
	int worst;

	if (!model->has_scene || model->automatic ||
	    model->scene.model.energy != HAWSER_ENERGY_EXACT)
		return HAWSER_OK;
	status = cli_modes_up_to(&modes, &model->statics, to, report);
	if (!status) {
		basis->functions = (model->rom.n + 2)/3; /* three components */
		basis->to = fmin(to, modes.mode[modes.n - 1].omega);
		basis->error = hawser_rom_full_error(&worst, &model->rom, &modes, to);
		basis->plane = modes.mode[worst].plane;
		basis->number = modes.mode[worst].number;
		if (!(basis->error < 1.0))
			status = refuse(basis, &modes.mode[worst], modes.mode[worst].omega/modes.time_unit, report);
	}
	hawser_modes_clear(&modes);
	return status ? status : hawser_rom_full_lacks(&basis->lacks, &model->statics, &model->scene,
	                                               basis->functions, report);
}

static int basis_says(char *text, size_t size, const struct cli_model *model)
{
	const struct cli_basis *basis = &model->basis;
	char load[80] = "";

	if (basis->functions == 0)
		return 0;
	if (basis->lacks > coarse)
		snprintf(load, sizeof load, ", and lack %.1e of the static response to the load",
		         basis->lacks);
	snprintf(text, size, "%d functions a component are off by %.1e at most in the natural frequencies "
	                     "up to %.6g rad/s (%s mode %d)%s", basis->functions, basis->error,
	         basis->to*cli_per_omega(model), hawser_plane_name(basis->plane), basis->number, load);
	return 1;
}

void cli_basis_comment(struct hawser__table *table, const struct cli_model *model)
{
	char text[CLI_WARNING_SIZE];

	if (basis_says(text, sizeof text, model))
		hawser__table_comment(table, "basis: %s", text);
}

void cli_basis_warn(const struct cli_model *model)
{
	char text[CLI_WARNING_SIZE];

	if (fmax(model->basis.error, model->basis.lacks) > coarse && basis_says(text, sizeof text, model))
		cli_warn(text);
}

HAWSER__GIVEN(is_checked, struct cli_model, of->basis.functions > 0)

#define OF(member) HAWSER__AT(struct cli_model, basis.member)
static const struct hawser__field basis_field[] = {
	{"functions", NULL, "functions a component", OF(functions)},
	{"frequency_error", NULL, "largest error of a natural frequency, relative", OF(error)},
	{"up_to", NULL, "frequency up to which they were looked at", OF(to), .unit = HAWSER__RAD_S},
	{"load_lacking", NULL, "part of the static response to the load that the basis lacks", OF(lacks)},
	HAWSER__END,
};
#undef OF
const struct hawser__field cli_basis_field[] = {
	{"basis", NULL, "of a full-order model", HAWSER__OBJECT_OF(basis_field), .given = is_checked},
	HAWSER__END,
};
