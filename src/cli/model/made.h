/* cli/model/made.h - models of scenes that are no spans: how they are made, and made again with other
 * modes. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MADE_H
#define HAWSER_CLI_MADE_H

#include <hawser/family.h>
#include <hawser/net_rom.h>

#include "cli/frame/cli.h"
#include "cli/model/certificate.h"

/* The modes that are coordinates of a model. */
struct cli_made_modes {
	struct hawser_modes modes;       /* n, mode and time_unit */
	struct hawser_line_modes lines;  /* of a ropeway, to which `mode` belongs then */
	int alone;                       /* of a net: as in struct hawser_net_rom_options */
};
void cli_made_modes_clear(struct cli_made_modes *modes);

struct cli_maker {
	const char *called, *many;  /* "a ropeway", "ropeways" */
	const char *still;          /* why no table moves it, for a message */
	int most;                   /* coordinates of a model */
	int clusters;               /* 1: modes of nearly equal frequencies are kept together */
	/* model->made and model->rom; n: number of modes, 0 for the default. */
	enum hawser_status (*load)(struct cli_model *model, const struct cli_common *common, int n,
	                           struct hawser_report *report);
	/* The same with n modes, or those of them that kept[count] are the indices of; modes: without
	 * `name`. Release them with hawser_rom_clear and cli_made_modes_clear. */
	enum hawser_status (*again)(struct hawser_rom *rom, struct cli_made_modes *modes,
	                            const struct cli_made *made, int n, const int *kept, int count,
	                            struct hawser_report *report);
	void (*comments)(struct hawser__table *table, const struct cli_model *model);
	/* Correct folds and peaks of a result of such a model (certificate.h), also `cable`; or NULL. */
	enum hawser_status (*certify)(struct cli_certificate *certificate,
	                              const struct cli_frf_result *result, double bearable,
	                              struct hawser_report *report);
	/* Write the motion of such a model as an animation of what it is of; or NULL. */
	enum hawser_status (*animate)(const char *path, const struct cli_model *model,
	                              const struct hawser_net_rom_motion *motion,
	                              struct hawser_report *report);
	/* Its models over a key of its scene, or NULL; close is the one that releases them. */
	enum hawser_status (*family)(struct hawser_rom_family *family,
	                             void (**close)(struct hawser_rom_family *), struct cli_made *made,
	                             const char *key, const double range[2], double at, double omega,
	                             struct hawser_report *report);
	void (*clear)(struct cli_made *made); /* without the modes */
};

/* The first member of what it is made from. */
struct cli_made {
	const struct cli_maker *by;
	struct cli_made_modes modes;
	int chosen;                  /* candidates of a choice of modes; 0: none was made */
	double passing;              /* rad/s, at which carriers of a net pass by its scene; 0: not said */
	double breaking;             /* rad/s, above which the regular waves of a net break; 0: none */
	int joints;                  /* shape points that come first and are joints of a net */
};
void cli_made_free(struct cli_made *made);
/* --keep: "1,4,6", as indices kept[by->most]; *count, and n, the last of them. */
enum hawser_status cli_made_keep(int *kept, int *count, int *n, const char *list,
                                 const struct cli_maker *by,
                                 struct hawser_report *report) HAWSER_MUST_CHECK;
/* Says on standard error that a net's model is of one mesh. */
void cli_made_warn(const struct cli_model *model);
/* Comments on a choice, and where a range ends. */
void cli_made_chosen(struct hawser__table *table, const struct cli_model *model);
/* The inertia of what follows, where it matters. */
/* Warn if regular waves of the scene's height break at this frequency of the model. */
void cli_made_breaking_warn(const struct cli_model *model, double omega);
void cli_made_inertia(struct hawser__table *table, const struct hawser_rom *rom);
/* The object "made" of a result of frf (row): how its model was made, with --set; and take from a
 * result what is not given, the modes with n = 0 only. *common lasts as long as the result. */
void cli_made_json(struct hawser__json *json, json_t *into, const void *row);
void cli_made_as(struct cli_common *common, int n, const json_t *root);
/* Whether a harmonic acts on coordinate j by more than round-off. */
int cli_made_loaded(const struct hawser_rom *rom, int j);

/* made_choice.c: the error by the modes that the model of the response leaves out, and a response of
 * a model of those modes that matter, in place of both where there is one. */
enum hawser_status cli_made_error(struct hawser_accuracy_fixed *fixed, const struct cli_model *model,
                                  const struct hawser_frf *frf, double from, double to,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_made_response(struct hawser_frf *frf, struct cli_model *model,
                                     struct cli_frf_result *result,
                                     const struct hawser_frf_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

extern const struct cli_maker cli_maker_ropeway, cli_maker_net;

#endif
