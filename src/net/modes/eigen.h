/* net/modes/eigen.h - the eigenproblem K*phi = omega^2*M*phi of a mesh at its equilibrium.
 *
 * K has k*e*e' + T/l*(I - e*e') of each taut element and nothing of a slack one, M the mean of the
 * consistent and the lumped mass matrix. Unknowns without mass follow the others.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_NET_EIGEN_H
#define HAWSER_NET_EIGEN_H

#include "net/net.h"

struct hawser__eigen {
	const struct hawser__mesh *mesh;
	const double *T;  /* [elements] N */
	const char *name; /* of the scene, for messages */
	int n;            /* modes asked for */
	int massive;      /* unknowns with mass: as many modes there are */
	int slack;        /* elements without stiffness */
	double lift;      /* rad^2/s^2: all below is of K + lift*M, whose eigenvalues are higher by it; 0
	                   * where K is positive definite */
	double *work;     /* [unknowns] with lift; else NULL */
	struct hawser__sparse *sparse; /* the factors of K, without the motions of rigid bodies */
	struct hawser__border *border; /* with those; NULL: there are none */

	int found;        /* n, and more where modes beyond have the frequency of the last one */
	double *x;        /* [found][unknowns] x'*M*x = 1 */
	double *value;    /* [found] omega^2, ascending */
	double *error;    /* [found] bound of the relative error of omega */
	double shift;     /* rad^2/s^2: as many modes as `found` lie below, by the inertia of K - shift*M
	                   * or since all modes are known; 0 if all modes are found */
	int iterations;   /* solutions with the factors of K */
	int dense;        /* 1: found by dense matrices */
};
#define HAWSER__EIGEN_EQUAL 1e-7 /* relative gap of omega^2 up to which modes belong together */
#define HAWSER__EIGEN_ABOVE 0.01 /* relative distance of the shift from the last mode, at most */
/* n: 0 for the default, 6; negative: -n, or all if there are fewer. Refuses more than there are, and an
 * equilibrium without stiffness. */
enum hawser_status hawser__eigen_open(struct hawser__eigen *eigen, const struct hawser__mesh *mesh,
                                      const double *T, const struct hawser_net *net, int n,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__eigen_solve(struct hawser__eigen *eigen, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* error [found], for vectors that have been changed. */
enum hawser_status hawser__eigen_bound(struct hawser__eigen *eigen, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__eigen_clear(struct hawser__eigen *eigen);

/* y = M*x, K*x [unknowns]; `along`: of motions along these directions only (bit k: direction k). */
void hawser__eigen_mass(double *y, const double *x, const struct hawser__mesh *mesh, unsigned along);
void hawser__eigen_stiffness(double *y, const double *x, const struct hawser__eigen *eigen);
/* The matrix K - shift*M is added to what `sparse` has. */
void hawser__eigen_assemble(struct hawser__sparse *sparse, const struct hawser__eigen *eigen,
                            double shift);
/* Number of modes below a shift, rad^2/s^2; *sure 0: round-off may have changed it. */
enum hawser_status hawser__eigen_count(int *below, int *sure, const struct hawser__eigen *eigen,
                                       double shift, const double *near, /* [unknowns] a mode nearby */
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Displacement of a node of the mesh. */
void hawser__eigen_place(double x[3], const double *phi, const struct hawser__mesh *mesh, int node);

/* eigen-border.c: rigid bodies beside the factors `sparse` of K - shift*M, and how many pivots are
 * negative there, or round-off; and the solution of K - shift*M by both (`border` may be NULL). */
enum hawser_status hawser__border_open(struct hawser__border **border, int *negative,
                                       const struct hawser__eigen *eigen,
                                       struct hawser__sparse *sparse, double shift,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__border_clear(struct hawser__border *border);
enum hawser_status hawser__border_solve(double *x, struct hawser__border *border,
                                        struct hawser__sparse *sparse,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* eigen-dense.c: the same as the next function for few unknowns. */
enum hawser_status hawser__eigen_dense(struct hawser__eigen *eigen, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* lanczos.c: the first found eigenvectors, to the accuracy of the factors. */
enum hawser_status hawser__eigen_lanczos(struct hawser__eigen *eigen, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* An equilibrium, the factors of K there, and modes. */
struct hawser__net_modal {
	struct hawser_net seated;       /* with its bodies in equilibrium */
	struct hawser__mesh mesh;
	double *T;                      /* [elements] N */
	struct hawser__eigen eigen;     /* of mesh: the structure must not be moved. The vectors x of the
	                                 * modes have the scale of modes.mass */
	struct hawser_net_modes modes;
};
/* n modes along `axes` (hawser__net_modes). Clear it, on failure too. */
enum hawser_status hawser__net_modal_open(struct hawser__net_modal *modal, const struct hawser_net *net,
                                          int n, unsigned axes,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__net_modal_clear(struct hawser__net_modal *modal);

#endif
