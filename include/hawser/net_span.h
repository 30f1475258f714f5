/* hawser/net_span.h - the cable of a span as a net: a chain of cable elements between the two ends.
 *
 * The unstretched length is that of the span's statics, so that it does not matter what gives the
 * tension. Forces of the mesh differ from those of the statics by its error, which falls with the
 * square of the number of elements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SPAN_H
#define HAWSER_NET_SPAN_H

#include <hawser/net.h>
#include <hawser/statics.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What has no counterpart in a mesh is refused by HAWSER_ERR_SCENE, which names the key: an
 * inextensible cable, bending stiffness, travel, elastic supports, springs, dampers, absorbers. */
struct hawser_net_span_options {
	int elements; /* of the whole cable, at least one between two attachments; 0: 100 */
	int still;    /* 1: without load, moving ends and damping, which are not looked at: for
	               * statics and modes. 0: damping other than alpha is refused too */
	double Omega; /* rad/s, of the load and of moving ends; > 0 if the scene has them, but with
	               * `still` */
};
void hawser_net_span_settle(struct hawser_net_span_options *options);

/* *net: the span of `scene`, whose statics (hawser_statics_scene) are given. Nodes: the ends A and B,
 * then the attachments along the cable; cables: the parts between them, from A to B, whose elements
 * have nearly equal lengths. A local load is along e, n and z of the static shape; its forces on
 * the nodes have the same work as the load on displacements that are linear between nodes. Release
 * by hawser_net_clear. Statuses: HAWSER_ERR_SCENE, HAWSER_ERR_ARGUMENT (elements, Omega),
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_net_span(struct hawser_net *net, const struct hawser_scene *scene,
                                   const struct hawser_statics *statics,
                                   const struct hawser_net_span_options *options,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* The place of the unstretched length S (m from end A) of the statics on that net: *cable, and *part
 * of its unstretched length, 0 to 1. */
void hawser_net_span_place(int *cable, double *part, const struct hawser_net *net, double S);

#ifdef __cplusplus
}
#endif
#endif
