/* tests/friction-siconos.h - a step with contact and friction by methods of Siconos (INRIA,
 * Apache-2.0), which share nothing with hawser's own but the problem.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_FRICTION_SICONOS_H
#define HAWSER_TESTS_FRICTION_SICONOS_H

#include <hawser/friction.h>

/* The methods: "lemke", for problems without friction, "nsgs" and "nsn_ac". NULL beyond the last, and
 * where the tests were built without Siconos, or its library cannot be loaded. */
const char *siconos_method(int index);

/* Impulses, velocities and states of a problem whose links are link [links]. Returns NULL, or what
 * went wrong. */
const char *siconos_solve(struct hawser_contact_reply *reply /* [contacts] */,
                          const struct hawser_friction_problem *problem, int nodes,
                          const int (*link)[2] /* [links] */, int links, const char *method);

#endif
