/* cli/frame/view.h - how results of a model are shown, and fields that several results have.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_VIEW_H
#define HAWSER_CLI_VIEW_H

#include "cli/frame/cli.h"
#include "output/fields/fields.h"

/* Factors to SI. */
struct hawser__scale cli_scale(const struct cli_model *model);
/* The view of a result of this model, with these options; and of results that are in SI. */
struct hawser__view cli_view(const struct cli_model *model, unsigned options);
struct hawser__view cli_si_view(unsigned options);

/* The name of a unit; "" without a model or if the model has no units. */
const char *cli_unit(const struct cli_model *model, const char *name);

/* The axis of a quantity of this model, see hawser__axis_of; without a unit if the model has none. */
struct hawser__axis cli_model_axis(const struct cli_model *model, const char *quantity, const char *si);

/* The first comments and members of a result, and how its fields are shown. */
struct cli_head {
	const struct cli_common *common;
	const char *command, *method;
	const struct hawser_scene *scene; /* or NULL: of a model file */
	struct hawser__view view;
	const void *rows; /* parent of the list of rows; NULL: the result */
	const char *also; /* text after the method; or NULL */
	const struct hawser__list *list; /* of rows, where it depends on the result; NULL: the showing's */
};
/* For a command whose results are in SI and without a struct hawser_scene; `context`: of the view. */
struct cli_head cli_si_head(const struct cli_common *common, const char *command, const char *method,
                            const void *context, unsigned options);
/* For a command on models. */
struct cli_head cli_model_head(const struct cli_common *common, const char *command,
                               const char *method, const struct cli_model *model, unsigned options);

/* Displacements at the probes [points][3] (an object of JSON), coordinates [n], and states [2n], u
 * then u'. Context: the model. */
extern const struct hawser__vector cli_probes, cli_coordinates, cli_states;

/* Components along x, y, z: double [3] in the row. */
extern const struct hawser__vector cli_axes;

/* Fields that responses have. `how`: HAWSER__VECTOR_ALONG, arrays along the points of a structure, or
 * HAWSER__VECTOR_AT, pointers of a row. */
#define CLI_AMPLITUDE(how, type, member) {"amplitude", "", "largest displacement over a period", \
	how(type, member, cli_probes), .unit = HAWSER__M}
#define CLI_COORDINATES(how, type, member) {"coordinates", "u_", "largest |u_j| over a period", \
	how(type, member, cli_coordinates), .unit = HAWSER__M}
#define CLI_STATE(how, type, member) {"state", NULL, "u and u' at the start of a period", \
	how(type, member, cli_states), .unit = HAWSER__M}

/* Fields of a struct cli_model, as members of the result. */
extern const struct hawser__field cli_si_field[], cli_naturals_field[], cli_choice_field[],
                                  cli_basis_field[], cli_exact_field[];
/* Of a struct cli_model_error. */
extern const struct hawser__field cli_fixed_field[], cli_certificate_field[];
/* Of a struct cli_frf_result: its peaks. */
extern const struct hawser__list cli_frf_peak_list;
/* The same as a table. */
extern const struct hawser__field cli_frf_peak_column[];
extern const struct hawser__list cli_frf_peak_rows, cli_frf_highest_rows;

/* Axes: Omega of a response; Omega or energy of a backbone. */
struct hawser__axis cli_frf_axis(const struct cli_model *model);
struct hawser__axis cli_backbone_axis(const char *column, const struct cli_model *model);

/* Tables of fields (output/fields/fields.h) of a command's results, each with a title; ended by
 * a row without title. json 1: keys of JSON; 0: columns. */
struct cli_listing {
	const char *title;
	const struct hawser__field *field;
	int json;
};

extern const struct cli_listing cli_beam_listing[], cli_campbell_listing[], cli_compare_listing[],
                                cli_folds_listing[], cli_frf_listing[], cli_modes_listing[],
                                cli_statics_listing[], cli_compare_mms_listing[],
                                cli_compare_motion_listing[], cli_map_listing[],
                                cli_plan_listing[], cli_irvine_listing[], cli_integrate_listing[],
                                cli_hill_listing[], cli_mms_listing[], cli_damping_listing[],
                                cli_compare_modes_listing[], cli_locus_listing[],
                                cli_rom_listing[], cli_identify_listing[],
                                cli_trajectory_listing[], cli_tow_listing[],
                                cli_tow_steady_listing[],
                                cli_transient_listing[];
/* Of hawser statics: its tables, and what a struct cli_curves or cli_speeds adds to JSON. */
extern const struct hawser__field cli_model_field[], cli_compatibility_field[], cli_speed_field[],
                                  cli_models_member[], cli_compatibility_member[],
                                  cli_speeds_member[];
extern const struct hawser__list cli_compatibility_list;

/* cli_outputs_check, and the user's ranges for a picture whose first panel has logarithmic axes: "",
 * "x", "y" or "xy". */
enum hawser_status cli_outputs_check_scales(const struct cli_common *common, const char *axes,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- picture.c: options about the picture of a command --- */

/* A title and "WxH" into a struct hawser__picture_choice, "A:B" into one of its ranges. */
enum hawser_status cli_store_title(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_size(void *field, const struct cli_option *option,
                                  const char *const *values, struct hawser_report *report);
enum hawser_status cli_store_range(void *field, const struct cli_option *option,
                                   const char *const *values, struct hawser_report *report);

/* Hand the choice to the pictures. Fails if there is a choice and no picture. --gp alone is --plot of
 * this file. */
enum hawser_status cli_picture_choose(struct cli_common *common,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
