/* contact/friction-methods.c - the table of methods.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stddef.h>
#include <string.h>

#include "contact/friction.h"
#include "core/report.h"

#ifdef HAVE_SICONOS
enum { SICONOS = 1 };
#else
enum { SICONOS = 0 };
#endif

static const struct hawser__friction_row rows[] = {
	{{"newton", "semismooth Newton along a path of smoothed laws; O(n) on chains",
	  "P. Alart, A. Curnier, Comput. Methods Appl. Mech. Engrg. 92 (1991) 353-375", 0, 1, 1},
	 hawser__friction_newton},
	{{"lemke", "Lemke's pivots on Delassus' operator (Siconos); without friction only",
	  "R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity Problem (2009)", 200, 0,
	  SICONOS},
	 hawser__friction_lemke},
	{{"nsgs", "nonsmooth Gauss-Seidel, contact by contact (Siconos)",
	  "V. Acary, M. Bremond, O. Huber, Advanced Topics in Nonsmooth Dynamics (2018) 375-457", 200, 1,
	  SICONOS},
	 hawser__friction_nsgs},
	{{"nsn_ac", "semismooth Newton on Delassus' operator (Siconos)",
	  "V. Acary, M. Bremond, O. Huber, Advanced Topics in Nonsmooth Dynamics (2018) 375-457", 200, 1,
	  SICONOS},
	 hawser__friction_nsn_ac},
};

static const struct hawser__friction_row *row(int index)
{
	return index >= 0 && index < (int)(sizeof rows/sizeof *rows) ? &rows[index] : NULL;
}

const struct hawser_friction_method *hawser_friction_method(int index)
{
	const struct hawser__friction_row *at = row(index);

	return at ? &at->shown : NULL;
}

const struct hawser__friction_row *hawser__friction_row(const char *name,
                                                        struct hawser_report *report)
{
	const struct hawser__friction_row *at = row(0);

	for (int i = 0; name && at && strcmp(at->shown.name, name) != 0; i++)
		at = row(i + 1);
	if (!at)
		(void)hawser__fail(report, HAWSER_ERR_ARGUMENT, "friction",
		                   "contact: there is no method \"%s\"", name);
	return at;
}
