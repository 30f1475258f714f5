/* net/statics/solution.h - what the solutions of meshes and of exact catenaries share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_SOLUTION_H
#define HAWSER_NET_SOLUTION_H

#include "net/statics/solve.h"

/* Fail for a part without support, with the names of its nodes. */
enum hawser_status hawser__net_supported(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* The arrays of st, whose numbers of nodes and cables are set. */
enum hawser_status hawser__net_statics_open(struct hawser_net_statics *st, size_t elements,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
/* hawser_net_solve by a method, which need not be a row of the table. */
enum hawser_status hawser__net_solve_by(struct hawser_net_statics *st, const struct hawser_net *net,
                                        const struct hawser__net_method *method,
                                        const struct hawser_net_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* The method `catenary`. */
enum hawser_status hawser__exact_statics(struct hawser_net_statics *st, const struct hawser_net *net,
                                         const struct hawser_net_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* By exact catenaries, with the unstretched lengths of `st`; *found is 0 if there is no solution, or if
 * there are obstacles. */
enum hawser_status hawser__net_exact(struct hawser_net_statics *exact, int *found,
                                     const struct hawser_net *net, const struct hawser_net_statics *st,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif
