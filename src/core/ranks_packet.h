/* core/ranks_packet.h - packets of tasks and their answers as messages.
 *
 *    WORK     first, count, then each question
 *    ANSWER   first, count, s of wall time, then for each task its status and its answer or its message
 *    READY    status, identity or message: a worker's first message
 *    END      rank 0's last one
 *    LAST     a worker's last one
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_RANKS_PACKET_H
#define HAWSER_CORE_RANKS_PACKET_H

#include "core/ranks.h"

enum { HAWSER__WORK = 1, HAWSER__ANSWER, HAWSER__READY, HAWSER__END, HAWSER__LAST_PACKET };

/* *message becomes the packet of tasks first to first + count - 1. */
enum hawser_status hawser__packet_ask(struct hawser__bytes *message, const struct hawser__tasks *tasks,
                                      long first, int count, struct hawser_report *report);
/* *answers becomes the message with the answers to the packet, computed by `threads` threads, which are
 * workers `worker` on. Failures are in the message. */
void hawser__packet_work(struct hawser__bytes *answers, const struct hawser__bytes *packet,
                         const struct hawser__tasks *tasks, int threads, int worker);

#endif
