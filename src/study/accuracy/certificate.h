/* study/accuracy/certificate.h - the meshes in which the model of a net is corrected.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CERTIFICATE_H
#define HAWSER_STUDY_CERTIFICATE_H

#include "net/balance/balance.h"
#include "rom/build/net.h"
#include "study/accuracy/certify.h"

/* Harmonics, at least and at most, and in the check of these; phases of a motion of the model, and the
 * coefficients of its series. */
enum { HAWSER__CERTIFIED_LEAST = 5, HAWSER__CERTIFIED_ORDER = 11, HAWSER__CERTIFIED_MORE = 4,
       HAWSER__CERTIFIED_PHASES = 32, HAWSER__CERTIFIED_WIDTH = 2*(HAWSER__CERTIFIED_ORDER + 1) + 1 };
/* Points of a curve between peaks of one resonance, at most; chosen. */
enum { HAWSER__CERTIFIED_NEAR = 5 };
/* A point of the model: sum of weights times the motions of nodes, 0 where there are fewer. */
enum { HAWSER__FINITE_NODES = 4 };
struct hawser__finite_place {
	int node[HAWSER__FINITE_NODES];
	double weight[HAWSER__FINITE_NODES];
};

/* The mesh that the model was made of, and ones with half and a quarter of its elements. */
enum { HAWSER__FINITE_MESHES = 3 };
struct hawser__finites {
	struct hawser_net fine;
	struct hawser__net_source source; /* of the model, with the first mesh */
	struct hawser__answers answers;
	struct hawser__finite_mesh {      /* the first one is that of `source` */
		struct hawser_net net;
		struct hawser__mesh own;      /* in equilibrium, as that one */
		double *T;                    /* [elements] N, there */
		int modes;                    /* that have a damping ratio; 0: none */
		double *mode, *rated;         /* shapes times the mass, and rates: those of `balance` */
		int *from;                    /* [nodes] the same ones of the first mesh */
		struct hawser__finite_place *place; /* [probes] the model's points */
		int opened;
	} mesh[HAWSER__FINITE_MESHES];
	double *turn;                     /* [source.n][turned] coordinates of the mesh by those of a
	                                   * span's model; NULL: they are the same */
	int turned;
	struct hawser__hold hold;
};
/* What is certified. */
struct hawser__certified_by {
	const struct hawser_net *net, *halved; /* halved: with half the elements; NULL: made of net */
	const struct hawser_net_rom_options *options; /* of the model, or of one of the same mesh */
	const struct hawser_modes *modes; /* of a span's model; NULL: it is the net's */
};
/* Both meshes, and the third one. *all is zero; it must not be moved. Clear it, on failure too. */
enum hawser_status hawser__finites_open(struct hawser__finites *all,
                                        const struct hawser__certified_by *by,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__finites_third(struct hawser__finites *all,
                                         const struct hawser__certified_by *by,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* certificate_span.c: the coordinates and the points of a span's model. */
enum hawser_status hawser__finites_turn(struct hawser__finites *all, const struct hawser_modes *modes,
                                        const struct hawser_rom *rom,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* certificate.c: as hawser_net_certify. */
enum hawser_status hawser__certified(struct hawser_certificate *certificate,
                                   const struct hawser__certified_by *by, const struct hawser_rom *rom,
                                   const struct hawser_frf *frf, const struct hawser_landmark *peak,
                                   int peaks, double bearable,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__finites_clear(struct hawser__finites *all);

/* One of these meshes with a number of harmonics, a motion and its tangent, and the second derivative
 * there of what is extreme. */
struct hawser__finite {
	struct hawser__mesh *mesh;
	struct hawser__mesh_balance balance;
	const struct hawser__finite_place *place;
	double *y, *along, bend;
	struct hawser__hold hold;
};
/* number: of the mesh. *finite is zero. Clear it, on failure too. */
enum hawser_status hawser__finite_open(struct hawser__finite *finite, struct hawser__finites *all,
                                       int number, int order,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__finite_clear(struct hawser__finite *finite);
struct hawser__corrector hawser__finite_corrector(struct hawser__finite *finite);
/* off [points][3]: relative changes from sizes [points][3] of a model to those of y, where that of a
 * peak grows by the factor `grown`; 0: of those that are less than half of that. */
void hawser__finite_others(double *off, struct hawser__finite *finite,
                           const struct hawser_certified *peak, double grown, const double *size,
                           int points);
/* The motion y of `other`, on this mesh; from: its nodes there, or NULL: the same. */
void hawser__finite_copy(double *to, const struct hawser__finite *of, const double *y,
                         const struct hawser__finite *other, const int *from);
/* Part of the motion by its two last harmonics. */
double hawser__finite_last(const struct hawser__finite *finite);

/* The corrections of a response. */
struct hawser__certifying {
	struct hawser_certificate *to;
	const struct hawser_rom *rom;
	const struct hawser_frf *frf;
	struct hawser__finites both;
	const struct hawser__certified_by *by;
	struct hawser__finite first, second, third, checked; /* third: where it is needed */
	double *row, *series;          /* [PHASES][unknowns], [unknowns][WIDTH] m */
	double *start[3];              /* [size of first] */
	double *size;                  /* [2][probes][3] of the model at a landmark, and their errors */
	double arc[HAWSER_CERTIFIED_MOST]; /* of the landmarks on the curve */
	double *u;                     /* [PHASES][n] */
	double left;                   /* of the difference of the meshes */
	double others;                 /* largest relative error at peaks of other points of a span */
	double folds;                  /* the same of folds, */
	struct hawser_landmark largest[2]; /* the two largest stable peaks, */
	double off[2];                 /* and their relative errors alone; NAN: not found */
	double worst;                  /* largest part of the last harmonics in a motion of `second`: */
	struct hawser_certified at;    /* its landmark, */
	double *worst_y, *worst_along, worst_bend; /* motion and tangent */
	struct hawser__hold hold, ordered; /* ordered: what depends on the number of harmonics */
};
/* certificate_start.c: displacements of the mesh in a period of the model's motion from that state, in
 * `series`; their highest harmonic that is not faint; and they as a motion of the first mesh. */
enum hawser_status hawser__certifying_lift(struct hawser__certifying *w, const double *state,
                                           double omega, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* certificate_span.c: the errors of other displacements at a peak, which the model has at omega, size
 * near that point; of the two largest peaks with those by which they are read from the curve, unless it
 * is this one. */
void hawser__certifying_others(struct hawser__certifying *w, const struct hawser_certified *item,
                               double omega, double size, int point);
int hawser__certifying_order(const struct hawser__certifying *w);
void hawser__certifying_start(double *y, const struct hawser__certifying *w, double omega);

#endif
