/* cli/model/made_choice.c - the modes that a model of a ropeway or of a net leaves out, weighed in the
 * motions of its response, and a model of those that matter.
 *
 * Weights of carriers act at the first harmonics of their frequency, and products of the motion at all.
 * Which of the many modes of a line with several spans that concerns, their number does not tell. The
 * candidates are the lowest modes, a model of all of which is made once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/model/made.h"

/* Fewest candidates, within which those lie that the second and third harmonics drive, and how many
 * there are if the model is to have the best of them. */
enum { MANY = 24, CHOICE = 32 };
enum { CANDIDATES = 90 };            /* at most: those of a model */
enum { MOST = 20, TRIES = 5 };      /* modes of a model that is chosen, and models tried; chosen */
static const double wanted = 0.05;  /* error that ends the search; chosen, half of what is warned of */
static const double next = 0.2;     /* what the next model may leave out, over it; as in accuracy.c */

struct candidates {
	struct cli_made_modes modes;
	struct hawser_choice choice;
	struct cli_made_modes kept; /* of the model of the kept ones, */
	struct hawser_rom rom;         /* and its response */
	struct hawser_frf frf;
};

static void clear_model(struct candidates *c)
{
	hawser_frf_clear(&c->frf);
	hawser_rom_clear(&c->rom);
	cli_made_modes_clear(&c->kept);
}

static void clear(struct candidates *c)
{
	clear_model(c);
	hawser_choice_clear(&c->choice);
	cli_made_modes_clear(&c->modes);
}

/* At least `fewest`, of which the kept ones are those of the model. */
static enum hawser_status open(struct candidates *c, const struct cli_model *model, int fewest,
                               double from, double to, struct hawser_report *report)
{
	const struct cli_made *of = model->made;
	const struct hawser_modes *own = &of->modes.modes;
	int n = own->mode[own->n - 1].place;
	struct hawser_rom all = {.n = 0};
	enum hawser_status status;

	n = n + n/2 > fewest ? n + n/2 : fewest;
	n = n < of->by->most ? n : of->by->most;
	status = of->by->again(&all, &c->modes, of, n, NULL, 0, report);
	if (!status)
		status = hawser_choice_of(&c->choice, &all, &c->modes.modes, from, to, report);
	for (int j = 0; j < c->choice.n; j++)
		c->choice.mode[j].kept = 0;
	for (int k = 0; !status && k < own->n; k++)
		c->choice.mode[own->mode[k].place - 1].kept = 1;
	hawser_rom_clear(&all);
	return status;
}

enum hawser_status cli_made_error(struct hawser_accuracy_fixed *fixed, const struct cli_model *model,
                                     const struct hawser_frf *frf, double from, double to,
                                     struct hawser_report *report)
{
	double start = cli_seconds();
	struct candidates c = {.rom = {.n = 0}};
	/* NOLINTNEXTLINE(clang-analyzer-unix.API): open() of this file */
	enum hawser_status status = open(&c, model, MANY, from, to, report);

	if (!status)
		status = hawser_accuracy_among(fixed, &c.choice, &model->rom, frf, report);
	fixed->seconds = cli_seconds() - start;
	clear(&c);
	return status;
}

/* Keep all modes of clusters of which one is kept. */
static int join(struct hawser_choice *choice)
{
	int changed = 0;

	for (int pass = 0; pass < 2; pass++)
		for (int i = 1; i < choice->n; i++) {
			int j = pass ? choice->n - i : i; /* upwards, then downwards */

			if (choice->mode[j].kept == choice->mode[j - 1].kept ||
			    !hawser_modes_near(choice->modes, j))
				continue;
			choice->mode[j].kept = choice->mode[j - 1].kept = 1;
			changed = 1;
		}
	return changed;
}

/* Keep what matters in the motions that were weighed; 0: the same as before. `first`: modes at rest are
 * dropped. */
static int choose(struct hawser_choice *choice, int first, int clusters)
{
	int changed = 0, kept[CANDIDATES];

	for (int j = 0; first && j < choice->n; j++)
		if (choice->mode[j].kept && choice->mode[j].measure == 0.0) {
			choice->mode[j].kept = 0;
			changed = 1;
		}
	changed |= hawser_choice_raise(choice, next*wanted) > 0;
	if (clusters)
		changed |= join(choice);
	if (hawser_choice_kept(kept, choice) > MOST)
		hawser_choice_first(choice, MOST);
	return changed;
}

/* The model of the kept modes, and a draft of its response. */
static enum hawser_status again(struct candidates *c, const struct cli_made *of,
                                const struct hawser_frf_options *options, struct hawser_report *report)
{
	int kept[CANDIDATES], count = hawser_choice_kept(kept, &c->choice);
	struct hawser_frf_options draft = *options;
	enum hawser_status status;

	draft.method = "balance";
	draft.tolerance = 1e-6; /* far below the errors */
	draft.skip_events = draft.unjudged = 1;
	clear_model(c);
	status = of->by->again(&c->rom, &c->kept, of, c->choice.n, kept, count, report);
	return status ? status : hawser_frf_trace(&c->frf, &c->rom, &draft, report);
}

/* The response of the last model, in place of what *frf and `model` have. */
static enum hawser_status take(struct hawser_frf *frf, struct cli_model *model, struct candidates *c,
                               const struct hawser_frf_options *options, struct hawser_report *report)
{
	enum hawser_status status;

	hawser_frf_clear(&c->frf);
	status = hawser_frf_trace(&c->frf, &c->rom, options, report);
	if (status || cli_interrupted())
		return status;
	hawser_frf_clear(frf);
	hawser_rom_clear(&model->rom);
	cli_made_modes_clear(&model->made->modes);
	*frf = c->frf;
	model->rom = c->rom;
	model->made->modes = c->kept;
	model->made->chosen = c->choice.n;
	c->frf = (struct hawser_frf){.n = 0};
	c->rom = (struct hawser_rom){.n = 0};
	c->kept = (struct cli_made_modes){.modes = {.n = 0}};
	return HAWSER_OK;
}

enum hawser_status cli_made_response(struct hawser_frf *frf, struct cli_model *model,
                                        struct cli_frf_result *result,
                                        const struct hawser_frf_options *options,
                                        struct hawser_report *report)
{
	struct candidates c = {.rom = {.n = 0}};
	struct hawser_accuracy_fixed fixed;
	int tries = 0;
	struct hawser_report why; /* where the search ends, what there is stays */
	/* NOLINTNEXTLINE(clang-analyzer-unix.API): open() of this file */
	enum hawser_status status = open(&c, model, CHOICE, result->from, result->to, &why);

	for (; tries < TRIES && !status && !cli_interrupted(); tries++) {
		status = hawser_accuracy_among(&fixed, &c.choice, c.rom.n ? &c.rom : &model->rom,
		                               c.rom.n ? &c.frf : frf, &why);
		if (status || fixed.estimated <= wanted ||
		    !choose(&c.choice, tries == 0, model->made->by->clusters))
			break;
		status = again(&c, model->made, options, &why);
	}
	if (!status && c.rom.n > 0 && !cli_interrupted())
		status = take(frf, model, &c, options, &why);
	if (!status && !cli_interrupted() && tries < TRIES) { /* the last model has been weighed */
		result->error = cli_fixed_unknown(model, "folds and peaks", !result->common->reproducible);
		result->error.fixed = fixed;
	}
	clear(&c);
	if (status != HAWSER_ERR_MEMORY)
		return cli_natural(model, report);
	*report = why;
	return status;
}
