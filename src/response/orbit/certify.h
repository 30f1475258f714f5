/* response/orbit/certify.h - a sample of a response's orbits, computed again by another method.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_CERTIFY_H
#define HAWSER_RESPONSE_CERTIFY_H

#include <hawser/frf.h>

/* Sets sampled, sample_gap and sample_disagreements of a traced *frf (frf.h). Statuses of the other
 * method. */
enum hawser_status hawser__certify(struct hawser_frf *frf, const struct hawser_rom *rom,
                                   const struct hawser_frf_options *options,
                                   struct hawser_report *report);

#endif
