/* rod/element.h - the element of geometrically exact rods: two nodes, one point; see element.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_ELEMENT_H
#define HAWSER_ROD_ELEMENT_H

enum { HAWSER__ROD_FREE = 6, HAWSER__ROD_PAIR = 12 }; /* unknowns of a node, of an element */

struct hawser__rod_node {
	double x[3], q[4]; /* m; from the section's axes to those of the scene */
};

/* At the middle of an element, in the section's axes: along e1, e2, e3. */
struct hawser__rod_strain {
	double w[3], k[3];  /* Rm'x', 1/m: curvature and twist, those at rest too */
	double N[3], M[3];  /* N, N m */
	double psi[3];      /* rad, turn from one node to the other */
	double half[4];     /* exp(psi/2) */
	double R[9];        /* of the middle */
};

struct hawser__rod_element {
	double h;           /* m, unstretched length */
	double EA[3];       /* N: axial and shear stiffness, along e1, e2, e3 */
	double EI[3];       /* N m^2: torsion and bending, about e1, e2, e3 */
	double w0[3], k0[3]; /* w and k at rest */
};

/* w and k of the state. Returns 1 if the element turns by pi or more, else 0. */
int hawser__rod_strain(struct hawser__rod_strain *at, const struct hawser__rod_element *el,
                       const struct hawser__rod_node node[2]);
/* h, and w0 of a rod at rest with the curvature k0. */
void hawser__rod_stretch(struct hawser__rod_element *el, double h);
/* N and M of `at` become their derivatives by h, at the same nodes. */
void hawser__rod_strain_by_length(struct hawser__rod_strain *at, const struct hawser__rod_element *el);
/* N: derivative of the energy by h, at the same nodes. */
double hawser__rod_energy_by_length(const struct hawser__rod_element *el,
                                    const struct hawser__rod_strain *at);
/* J */
double hawser__rod_energy(const struct hawser__rod_element *el, const struct hawser__rod_strain *at);
/* f [HAWSER__ROD_PAIR]: derivative of the energy, of each node with respect to x (N) and to a turn in
 * the section's axes, R exp(theta) (N m). K [PAIR][PAIR]: derivative of f; may be NULL. */
void hawser__rod_forces(double *f, double *K, const struct hawser__rod_element *el,
                        const struct hawser__rod_strain *at);

#endif
