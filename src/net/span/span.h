/* net/span/span.h - spans as nets: what their statics, modes and motions share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SPAN_LOADS_H
#define HAWSER_NET_SPAN_LOADS_H

#include <hawser/net_span.h>

/* Room for constant loads of a part of the cable: of the scene, of the attachment at its end, and two
 * that hawser__net_span_turn adds. */
enum { HAWSER__SPAN_LOADS = 4 };

/* hawser_net_span, of several parts with multiples of two units of elements; if `halved` is 1, with
 * half the elements: each is as long as two. */
enum hawser_status hawser__net_span(struct hawser_net *net, const struct hawser_scene *scene,
                                    const struct hawser_statics *statics,
                                    const struct hawser_net_span_options *options, int unit,
                                    int halved, struct hawser_report *report) HAWSER_MUST_CHECK;

/* The place of the unstretched length S (m from end A) of the statics on that net: *cable, and *part
 * of its unstretched length, 0 to 1. */
void hawser__net_span_place(int *cable, double *part, const struct hawser_net *net, double S);

#endif
