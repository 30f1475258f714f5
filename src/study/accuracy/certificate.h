/* study/accuracy/certificate.h - the meshes in which the model of a net is corrected.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CERTIFICATE_H
#define HAWSER_STUDY_CERTIFICATE_H

#include "net/balance/balance.h"
#include "rom/build/net.h"
#include "study/accuracy/certify.h"

/* The mesh that the model was made of, and one with half as many elements. */
struct hawser__finites {
	struct hawser_net fine, half;
	struct hawser__net_source source; /* of the model, with the first mesh */
	struct hawser__answers answers;
	struct hawser__mesh coarse;       /* in equilibrium, as that one */
	int *from;                        /* [nodes of coarse] the same ones of the other mesh */
	int *node[2];                     /* [probes] nodes of the model's points, of both meshes */
	struct hawser__hold hold;
};
/* *all is zero; it must not be moved. Clear it, on failure too. */
enum hawser_status hawser__finites_open(struct hawser__finites *all, const struct hawser_net *net,
                                        const struct hawser_net_rom_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__finites_clear(struct hawser__finites *all);

/* One of these meshes with a number of harmonics, a motion and its tangent, and the second derivative
 * there of what is extreme. */
struct hawser__finite {
	struct hawser__mesh *mesh;
	struct hawser__mesh_balance balance;
	const int *node;
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
