/* rom/build/net.h - the parts of a model of a net: see net.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_NET_H
#define HAWSER_ROM_NET_H

#include <hawser/net_rom.h>

#include "net/expand/expand.h"
#include "rom/build/expanded.h"

/* Between two nodes of the mesh, with the strains of two elements. */
struct hawser__net_place {
	int node[2], element[2];
	double weight[2];  /* of the strains */
	double share, s;   /* of the second node; m, unstretched length from the beginning of the first
	                    * cable, over all of them */
};

/* A force on the unknowns, row*Omega^power*cos(k Omega t), or sine. */
struct hawser__net_wave {
	int k, sine, power;
	double *row;           /* [unknowns] N s^power */
};

/* The displacement by moving supports, at rest else: shape*cos(k Omega t), or sine. */
struct hawser__net_lift {
	int k, sine;
	double (*shape)[3];    /* [nodes] m */
};

struct hawser__net_source {
	struct hawser__net_modal modal;
	struct hawser__nexpand t;
	const struct hawser_net *net;
	int n, *kept;              /* coordinates, and their modes */
	double *mode;              /* [n][unknowns] m, the modes per coordinate */
	double length, time, force, mass, EA; /* units; that of the model's shapes */
	int places, shapes;        /* shape points, then the line */
	struct hawser__net_place *place;
	int waves, lifts;
	struct hawser__net_wave *wave;
	struct hawser__net_lift *lift;
	struct hawser__inertia inertia; /* coordinates behind the modes; rows in m */
	double *scratch;           /* [unknowns] */
	struct hawser__hold hold;
};

/* net_fill.c: frequency of coordinate j, a mode; mass of a coordinate, kg m^2; the model, of whose
 * coordinates, loads and answers all are known. */
double hawser__net_omega(const struct hawser__net_source *source, int j);
double hawser__net_unit(const struct hawser__net_source *source);
enum hawser_status hawser__net_fill(struct hawser_rom *rom, struct hawser__net_source *source,
                                    const struct hawser__answers *answers,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* The unknowns of a coordinate. */
const double *hawser__net_row(const struct hawser__net_source *source, int j);
/* Units, K and D, and with `whole` what the wind adds to higher orders. */
enum hawser_status hawser__net_fill_first(struct hawser_rom *rom,
                                          const struct hawser__net_source *source, int whole,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* net_wind.c: the force of the wind, if the net has one, to first order or in its form. */
enum hawser_status hawser__net_wind_fill(struct hawser_rom *rom,
                                         const struct hawser__net_source *source, int whole,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* net_water.c: whether models take the water of the net; and its force, to a model that is complete but
 * not compiled. linear: to K and D, of small motions without waves. */
enum hawser_status hawser__net_water_check(const struct hawser_net *net,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_water_fill(struct hawser_rom *rom,
                                          const struct hawser__net_source *source, int linear,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* net.c: what a model with these options is made of, but its tensors, and the mesh `fine`, whose cables
 * are to be freed; the source must not be moved. Clear it and the answers, on failure too. */
enum hawser_status hawser__net_source_open(struct hawser__net_source *source, struct hawser_net *fine,
                                           struct hawser__answers *answers,
                                           const struct hawser_net *net,
                                           const struct hawser_net_rom_options *options,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__net_source_clear(struct hawser__net_source *source);
/* The same kept, and a model whose coordinates are most like those, in its units: of the same net with
 * other values (NULL: hawser_net_rom_build). All zero before; clear it, on failure too. */
struct hawser__net_like {
	struct hawser_net fine;
	struct hawser__net_source source;
	struct hawser__answers answers;
};
enum hawser_status hawser__net_like_open(struct hawser__net_like *like, const struct hawser_net *net,
                                         const struct hawser_net_rom_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_rom_like(struct hawser_rom *rom, struct hawser_modes *modes,
                                        const struct hawser_net *net,
                                        const struct hawser_net_rom_options *options,
                                        const struct hawser__net_like *like,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__net_like_clear(struct hawser__net_like *like);
/* net_lift.c: displacements [rows][unknowns], m, at equidistant phases from 0 of a motion u [rows][n]
 * of its model over so many periods of the load. */
enum hawser_status hawser__net_lift(double *to, const struct hawser__net_source *source,
                                    const struct hawser__answers *answers, const double *u, int rows,
                                    int periods, struct hawser_report *report) HAWSER_MUST_CHECK;

/* net_load.c: waves and lifts of the scene; and the multiples of waves and motions. */
enum hawser_status hawser__net_multiples(struct hawser__mesh *mesh, const char *name,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_loads_of(struct hawser__net_source *source,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
/* x'M y of each of the rows x [count][unknowns], in part [count], of a coordinate's mass; and, of
 * nodes' displacements x and a row y, x'D y of all damping but by ratio, kg m^2/s. `of`: a source. */
void hawser__net_masses(const void *of, double *part, const double *x, int count, const double *y);
double hawser__net_damping(const struct hawser__net_source *source, const double (*x)[3],
                           const double *y);
/* shape [nodes][3] of a row. */
void hawser__net_spread(double (*shape)[3], const struct hawser__net_source *source, const double *row);

/* net_inertia.c: which shapes matter, from what follows; and those, whose part of it is taken out. */
enum hawser_status hawser__net_inertia_find(struct hawser__net_source *source,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__net_inertia_make(struct hawser__net_source *source,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* net_finer.c: the net with the elements that models have, halved up to three times; free its
 * `cable`. */
enum hawser_status hawser__net_finer(struct hawser_net *to, const struct hawser_net *net, int halvings,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* The modes of a mesh most like the coordinates of a finer one, in kept and mode; *aligned 0: there are
 * none. */
enum hawser_status hawser__net_align(int *aligned, struct hawser__net_source *coarse,
                                     const struct hawser__net_source *fine,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* The model of the finer mesh becomes that without its error; where the loads of both matter
 * differently, it stays, and *mixed is 0. */
enum hawser_status hawser__net_mix(struct hawser_rom *to, int *mixed, const struct hawser_rom *from,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

/* u and slope at a place of a row of unknowns. net_place.c. */
void hawser__net_at(double u[3], double slope[3], const struct hawser__net_source *source,
                    const double *row, int place);
/* net_place.c: most places; the places; the expansion as that of a model. */
size_t hawser__net_points(const struct hawser_net *net);
enum hawser_status hawser__net_places(struct hawser__net_source *source, char **name,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
struct hawser__expanded hawser__net_expanded(const struct hawser__net_source *source);
/* Stretch of a place, of a cable of the model's EA. */
double hawser__net_place_stretch(const struct hawser__net_source *source, int place);

#endif
