/* study/accuracy/certificate.h - the meshes in which the model of a net is corrected.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CERTIFICATE_H
#define HAWSER_STUDY_CERTIFICATE_H

#include "net/balance/balance.h"
#include "rom/build/net.h"
#include "study/accuracy/certify.h"

enum { HAWSER__CERTIFIED_ORDER = 11, HAWSER__CERTIFIED_MORE = 4 }; /* harmonics, at most; in the check
                                                                    * of these */
/* A point of the model: sum of weights times the motions of nodes, 0 where there are fewer. */
enum { HAWSER__FINITE_NODES = 4 };
struct hawser__finite_place {
	int node[HAWSER__FINITE_NODES];
	double weight[HAWSER__FINITE_NODES];
};

/* The mesh that the model was made of, and one with half as many elements. */
struct hawser__finites {
	struct hawser_net fine, half;
	struct hawser__net_source source; /* of the model, with the first mesh */
	struct hawser__answers answers;
	struct hawser__mesh coarse;       /* in equilibrium, as that one */
	int *from;                        /* [nodes of coarse] the same ones of the other mesh */
	struct hawser__finite_place *place[2]; /* [probes] the model's points, of both meshes */
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
/* *all is zero; it must not be moved. Clear it, on failure too. */
enum hawser_status hawser__finites_open(struct hawser__finites *all,
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
/* second 1: the mesh with fewer elements. *finite is zero. Clear it, on failure too. */
enum hawser_status hawser__finite_open(struct hawser__finite *finite, struct hawser__finites *all,
                                       int second, int order,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__finite_clear(struct hawser__finite *finite);
struct hawser__corrector hawser__finite_corrector(struct hawser__finite *finite);
/* The motion y of `other`, on this mesh; from: its nodes there, or NULL: the same. */
void hawser__finite_copy(double *to, const struct hawser__finite *of, const double *y,
                         const struct hawser__finite *other, const int *from);
/* Part of the motion by its two last harmonics. */
double hawser__finite_last(const struct hawser__finite *finite);

#endif
