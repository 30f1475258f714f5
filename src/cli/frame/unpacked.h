/* cli/frame/unpacked.h - a program that was unpacked from a tarball, with its data beside it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_UNPACKED_H
#define HAWSER_CLI_UNPACKED_H

/* Let udunits2 find its units in ../share/hawser/udunits, if they are there (packaging/static.sh). The
 * environment's UDUNITS2_XML_PATH has priority. */
void cli_unpacked_units(void);

#endif
