/* study/accuracy/survey.h - the data for estimates: the lowest modes of a scene, their tensors without
 * condensation, and a condensed model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_SURVEY_H
#define HAWSER_STUDY_SURVEY_H

#include <hawser/accuracy.h>
#include <hawser/law.h>
#include <hawser/plan.h>

#include "rom/condense/support.h"


struct hawser_survey {
	const struct hawser_scene *scene;
	const struct hawser_plan *plan; /* modes, resonances, range */
	struct hawser_rom raw;          /* with all modes of the plan */
	const struct hawser_rom *condensed; /* of `choice`, or `own` */
	struct hawser_rom own;
	struct hawser_choice *choice;   /* the modes of the plan; NULL: they are not weighed */
	char unweighed[240];            /* why */
	int motions;                    /* foreseen, by which modes are weighed (foresee.c) */
	double *u, *omega;              /* [motions][ROWS][modes], [motions] */
	struct hawser_rom_inertia inertia; /* of the condensed modes of the scene's own model */
	struct hawser_accuracy_fixed fixed; /* of the scene's own modes; NAN: not foreseen */
	/* whether the exact energy takes their place, over a part of the range */
	enum { HAWSER__MODES, HAWSER__INSTEAD, HAWSER__PARTLY, HAWSER__TOO_LONG, HAWSER__NO_BASIS } instead;
	char range[160];                /* of its coordinates (law.h); "" if not sought */
	char forces[240];               /* what its forces are evaluated from; "" without modes */
	double slowness;                /* of this machine, relative to that of the constants of cost.c */
};

/* Whether the scene has a periodic response: a periodic excitation acts on the cable. */
static inline int hawser__scene_driven(const struct hawser_scene *scene)
{
	return (scene->load.present || scene->loads > 0 || scene->travel.fluctuation > 0.0 ||
	        hawser__support_moves(scene)) && !(scene->travel.braking > 0.0);
}

/* Size of a model of the modes at index [n]: number of coordinates, and of tensor entries that are
 * not zero by the symmetry to the plane. NULL: the first n. */
void hawser__count_entries(struct hawser_plan_row *row, const struct hawser_survey *survey,
                           const int *index, int n);

/* Which modes the wind of the scene makes grow, a text each; gallop.c. */
enum { HAWSER__GALLOPS = 6, HAWSER__GALLOP_TEXT = 240 };
enum hawser_status hawser__plan_gallop(char text[HAWSER__GALLOPS][HAWSER__GALLOP_TEXT], int *count,
                                       const struct hawser_survey *survey,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

double hawser__plan_slowness(void);
/* Points and seconds of a row: closed forms, one traced curve, with a given number of chosen modes, and
 * to an accuracy. */
void hawser__estimate_closed_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);
/* The row's seconds and this work, s as counted; longest: longest step of what is traced then, relative
 * to the range; 0: the points are those of the row. */
void hawser__estimate_work(struct hawser_plan_row *row, const struct hawser_survey *survey, double work,
                           double longest);
/* Work of a draft of full-order models, on n coordinates; and of the first one that is drafted for this
 * accuracy, which *full becomes, with more functions a component than full->choice.number and at most
 * `most` (0: the default). full->n is 0 if there is none. */
double hawser__draft_foreseen(const struct hawser_survey *survey, int n);
double hawser__draft_of(struct hawser_plan_row *full, const struct hawser_survey *survey, int most,
                        double accuracy);
/* Work of a search with its response and peaks over that of the first draft; median of 31 random and
 * shipped scenes (bench/defaults.py), where it was 2.0 to 9.0. */
#define HAWSER__SEARCHED 3.0
void hawser__estimate_chosen_cost(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_auto_cost(struct hawser_plan_row *row, const struct hawser_survey *survey,
                                double candidates, /* modes among which it chooses */
                                double longest); /* step of its curves, relative to the range */

/* Find the resonances and their effective cubic coefficients. */
enum hawser_status hawser__find_resonances(struct hawser_plan *plan,
                                           const struct hawser_survey *survey,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* The estimates of the rows: sizes, and, if the scene has a load, cost and error. */
void hawser__estimate_raw(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_condensed(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_chosen(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_auto(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_full(struct hawser_plan_row *row, const struct hawser_survey *survey);
void hawser__estimate_scales(struct hawser_plan_row *row, const struct hawser_survey *survey);

/* Largest amplitude of a resonance within the range, and its frequency there. */
double hawser__within(double *omega, const struct hawser_plan *plan,
                      const struct hawser_plan_resonance *at);

/* Set the motions of a survey with resonances; free them and the choice. */
enum hawser_status hawser__foresee_motions(struct hawser_survey *survey,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__foresee_clear(struct hawser_survey *survey);
/* The error of a condensed model of the modes kept [count]; NULL: the first ones. HAWSER_ERR_ARGUMENT:
 * modes are not weighed. */
enum hawser_status hawser__foresee(struct hawser_accuracy_fixed *fixed,
                                   const struct hawser_survey *survey, const int *kept, int count,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The row of what hawser frf answers with the scene as it is. */
enum hawser_status hawser__estimate_own(struct hawser_plan_row *row, struct hawser_survey *survey,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Which effects are modelled. */
enum hawser_status hawser__decide(struct hawser_plan *plan, const struct hawser_survey *survey,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
