/* output/structures/plot_net.h - a net in perspective, its cables coloured by their tension.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PLOT_NET_H
#define HAWSER_OUTPUT_PLOT_NET_H

#include <hawser/net.h>

#include "output/drawing/figure.h"
#include "output/output.h"

enum hawser_status hawser__plot_net(const char *path, const struct hawser_net *net,
                                    const struct hawser_net_statics *st, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* plot_mooring.c: the same of a net in water, in side and plan view. */
enum hawser_status hawser__plot_mooring(const char *path, const struct hawser_net *net,
                                        const struct hawser_net_statics *st,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* plot_bed.c: a bed with heights in its views, of the box from low [3] to high [3]: put below the
 * cables, y over x; and drawn as contours, z over x. */
void hawser__plot_bed_section(struct hawser__figure *figure, const struct hawser_surface *bed,
                              const struct hawser_net_statics *st, const double low[3],
                              const double high[3]);
void hawser__plot_bed_contours(struct hawser__figure *figure, const struct hawser_surface *bed,
                               const double low[3], const double high[3]);

#endif
