/* cli/model/certificate.h - the certificate of a response (hawser/certificate.h), as results show it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_CERTIFICATE_H
#define HAWSER_CLI_CERTIFICATE_H

#include <hawser/certificate.h>

struct cli_frf_result;
struct hawser__table;

struct cli_certificate {
	const char *how;                   /* "auto", "yes", "no" */
	struct hawser_certificate own;     /* count 0: none was made */
	const struct hawser_rom *rom;
	const char *cable[HAWSER_CERTIFIED_MOST]; /* with the least tension in each motion */
};

/* Corrects folds and peaks of a result that has a certificate and whose model can be certified: the
 * error of the model is their distance then. Where that takes too long, nothing is done. Statuses of
 * hawser_net_certify. */
enum hawser_status cli_certify(struct cli_frf_result *result,
                               struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_certificate_comments(struct hawser__table *table, const struct cli_frf_result *result);

#endif
