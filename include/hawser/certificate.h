/* hawser/certificate.h - folds and peaks of a model's response corrected in the structure itself: of
 * a net or a span, by harmonic balance of all nodes of its mesh with the exact law of its elements.
 * Their distance from those of the model is its error, without any estimate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CERTIFICATE_H
#define HAWSER_CERTIFICATE_H

#include <hawser/modes.h>
#include <hawser/net_rom.h>
#include <hawser/study.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A fold, or a peak of one component; that of the model and that of the structure. */
struct hawser_certified {
	enum hawser_landmark_kind kind;
	int probe, axis;       /* of a peak; of a fold -1 */
	int turn;              /* of a fold: as in struct hawser_landmark */
	double omega, size;    /* scaled, of the model; size of a peak */
	double exact_omega, exact_size; /* of the structure; NAN: not found near those */
	double distance;       /* the larger of their relative differences */
	double tension;        /* N: least one of that motion, of all elements, */
	int cable;             /* on this cable of the net */
};

enum { HAWSER_CERTIFIED_MOST = 10 };
struct hawser_certificate {
	int count;             /* the folds, then the largest peaks of all resonances */
	struct hawser_certified item[HAWSER_CERTIFIED_MOST];
	int refused;           /* of them, those that were not found */
	int omitted;           /* further folds and peaks, which were not looked for */
	double distance;       /* largest of all that were found; NAN: none was */
	double harmonics;      /* largest relative change of an Omega or a size by four more harmonics */
	double error;          /* of the model, stated: the distance and what is not known of it; NAN */
	double largest;        /* the same of folds and the two largest stable peaks; 0: not known */
	int order, unknowns;   /* harmonics; unknowns of the mesh */
	double lengths;        /* largest relative error that the length of elements leaves, estimated */
	double foreseen;       /* s of processor time, as counted: within a factor 2 on a core of 2 GHz */
	double seconds;        /* wall time */
};

/* The certificate of the response of `rom`, a model of the net by these options, with peaks as
 * hawser_peaks has them. bearable: nothing is corrected where `foreseen` is more, and count is 0; 0: no
 * limit. Statuses: HAWSER_ERR_MEMORY, those of hawser_net_rom_build and hawser_integrate. */
enum hawser_status hawser_net_certify(struct hawser_certificate *certificate,
                                      const struct hawser_net *net,
                                      const struct hawser_net_rom_options *options,
                                      const struct hawser_rom *rom, const struct hawser_frf *frf,
                                      const struct hawser_landmark *peak, int peaks, double bearable,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same of the response of a span's model with these modes, in a mesh of 48 elements. Also
 * HAWSER_ERR_SCENE for what a mesh does not have, as in net_span.h, but for damping ratios, which it
 * has without absorbers; HAWSER_ERR_ARGUMENT: the model is not one of modes, or has too many. */
enum hawser_status hawser_span_certify(struct hawser_certificate *certificate,
                                       const struct hawser_scene *scene,
                                       const struct hawser_modes *modes, const struct hawser_rom *rom,
                                       const struct hawser_frf *frf,
                                       const struct hawser_landmark *peak, int peaks, double bearable,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
