/* statics/loaded_solve.c - the equilibrium of a cable with point masses for one given quantity.
 *
 * With the complementary energy Phi(H, V0; L) = integral of T + T^2/(2 EA), x = dPhi/dH and
 * y = dPhi/dV0. Phi is strictly convex, so that at a given length
 *
 *   y increases with V0, and with V0(H) such that y = h, x increases with H:
 *
 * the equilibrium is unique, and found by one search inside another. For a given H the inner search
 * is the same, and the outer one is for the length; x passes d since it is 0 for L = 0 and unbounded.
 * For a tension or the sag, a third search is for H, with derivatives along the equilibria from
 * [xV xL; yV yL] (V', L') = -(xH, yH). As without masses, a tension is searched on the given side of
 * its minimum (tension.c). All are Newton's method in a bracket, and begin with the cable on which
 * the masses are spread evenly.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "statics/catenary.h"
#include "statics/loaded.h"
#include "statics/models.h"
#include "statics/search.h"

static const char where[] = "statics";
enum { ITERATIONS = 200 };

static void end_of(struct hawser__reach *r, const struct hawser__loaded *cable)
{
	hawser__loaded_reach(r, cable, cable->L, 1.0);
}

/* V0 such that y = h, at the H and L of *cable; *r is then the end. Newton's method in an interval
 * which is extended until it has the root. */
static void lift(struct hawser__loaded *cable, struct hawser__reach *r)
{
	double lo = -INFINITY, hi = INFINITY, step = INFINITY, wide = cable->H + cable->w*cable->L;
	const double round_off = 1e-12*wide; /* a step below this that does not decrease is round-off */

	for (int i = 0; i < ITERATIONS; i++) {
		double y, newton, V = cable->V0;

		end_of(r, cable);
		cable->iterations++;
		y = r->y - cable->h;
		if (y == 0.0 || !isfinite(y) || hi - lo <= 0.0)
			return;
		if (y > 0.0)
			hi = V;
		else
			lo = V;
		newton = -y/r->yV;
		if (fabs(newton) <= DBL_EPSILON*(fabs(V) + DBL_EPSILON*cable->H) ||
		    (fabs(newton) >= step && fabs(newton) < round_off))
			return;
		if (isinf(lo) || isinf(hi)) {
			newton = fmax(-wide, fmin(wide, newton));
			wide *= 4.0;
		} else if (!(V + newton > lo && V + newton < hi) ||
		           (fabs(newton) > 0.5*step && fabs(newton) >= round_off)) {
			newton = 0.5*(lo + hi) - V;
			if (newton == 0.0)
				return;
		}
		step = fabs(newton);
		cable->V0 = V + newton;
	}
}

/* Search for x = d with y = h: over H at the given length, or over L at the given H. */
static enum hawser__found close_span(struct hawser__loaded *cable, struct hawser__reach *r,
                                     int over_H)
{
	double *unknown = over_H ? &cable->H : &cable->L;
	struct hawser__search search = {.x = *unknown, .hi = INFINITY, .step = INFINITY};
	double miss, slope, newton;

	do {
		*unknown = search.x;
		lift(cable, r);
		miss = r->x - cable->d;
		slope = search.x*(over_H ? r->xH - r->xV*r->yH/r->yV : r->xL - r->xV*r->yL/r->yV);
		if (!isfinite(miss))
			return HAWSER__RANGE;
		if (miss == 0.0)
			break;
		newton = slope > 0.0 ? -miss/slope : 0.0;
	} while (hawser__search_next(&search, miss > 0.0, newton));
	return fabs(r->x - cable->d) <= 1e-9*(cable->d + r->length) &&
	       fabs(r->y - cable->h) <= 1e-9*(cable->d + r->length) ? HAWSER__FOUND : HAWSER__RANGE;
}

/* Derivatives of V0 and L by H along the equilibria. */
static void along(double *V_H, double *L_H, const struct hawser__reach *r)
{
	double det = r->xV*r->yL - r->xL*r->yV;

	*V_H = (r->xL*r->yH - r->yL*r->xH)/det;
	*L_H = (r->yV*r->xH - r->xV*r->yH)/det;
}

/* The given quantity at the equilibrium, and its logarithmic derivative by H. */
static double quantity(const struct hawser__loaded *cable, const struct hawser__reach *r,
                       enum hawser_given given, double *derivative)
{
	double V_H, L_H, V = cable->V0, value;

	along(&V_H, &L_H, r);
	if (given == HAWSER_GIVEN_SAG) {
		value = hawser__loaded_sag(cable, V_H, L_H, derivative);
		*derivative *= cable->H/value;
		return value;
	}
	if (given == HAWSER_GIVEN_T1) {
		V += cable->w*cable->L + cable->weight;
		V_H += cable->w*L_H;
	}
	value = hypot(cable->H, V);
	*derivative = cable->H*(cable->H + V*V_H)/(value*value);
	return value;
}

/* Move to the least tension, where its derivative changes its sign. */
static enum hawser__found least(struct hawser__loaded *cable, enum hawser_given given)
{
	struct hawser__search search = {.x = cable->H, .hi = INFINITY, .step = INFINITY};
	struct hawser__reach r;
	double slope;

	do {
		cable->H = search.x;
		if (close_span(cable, &r, 0))
			return HAWSER__RANGE;
		quantity(cable, &r, given, &slope);
	} while (hawser__search_next(&search, slope > 0.0, 0.0));
	return HAWSER__NOT_FOUND;
}

/* Search over H for a tension or the sag. */
static enum hawser__found over_H(struct hawser__loaded *cable, struct hawser__reach *r,
                                 enum hawser_given given, double wanted,
                                 enum hawser_branch branch)
{
	int sag = given == HAWSER_GIVEN_SAG, taut = branch == HAWSER_BRANCH_TAUT, below;
	struct hawser__search search = {.x = cable->H, .hi = sag ? INFINITY : wanted*(1.0 + 1e-15),
	                                .step = INFINITY};
	double F, slope, newton, tolerance;

	if (!(search.x < search.hi))
		search.x = 0.5*search.hi;
	do {
		cable->H = search.x;
		if (close_span(cable, r, 0))
			return HAWSER__RANGE;
		F = log(quantity(cable, r, given, &slope)/wanted);
		tolerance = 4.0*DBL_EPSILON*(2.0 + fmin(fabs(slope), 1e3));
		if (fabs(F) <= tolerance)
			return HAWSER__FOUND;
		if (sag)
			below = F < 0.0;
		else
			below = taut ? F > 0.0 && slope > 0.0 : F <= 0.0 || slope > 0.0;
		newton = (slope < 0.0) == (sag || !taut) ? -F/slope : 0.0;
	} while (hawser__search_next(&search, below, newton));
	if (fabs(F) <= fmin(256.0*tolerance, 1e-11))
		return HAWSER__FOUND;
	return sag || F < 0.0 ? HAWSER__RANGE : least(cable, given);
}

/* --- from and to the public structures --- */

void hawser__loaded_sort(struct hawser__loaded *cable, int *order)
{
	double unused;

	for (int i = 1; i < cable->count; i++)
		for (int j = i; j > 0 && hawser__load_place(cable, j - 1, &unused) >
		                         hawser__load_place(cable, j, &unused); j--) {
			struct hawser__load_point load = cable->load[j];
			int at = order[j];

			cable->load[j] = cable->load[j - 1];
			cable->load[j - 1] = load;
			order[j] = order[j - 1];
			order[j - 1] = at;
		}
}

void hawser__loaded_begin(struct hawser__loaded *cable, int *order, const struct hawser_span *span,
                          const struct hawser_attachment *attach, int count, const double gravity[3],
                          double length)
{
	*cable = (struct hawser__loaded){.EA = span->EA, .w = span->rho*span->g, .d = span->d,
	                                 .h = span->h, .count = count, .L = length};
	for (int i = 0; i < count; i++) {
		struct hawser__load_point *load = &cable->load[i];

		*load = (struct hawser__load_point){.at = attach[i].at, .fixed = attach[i].by_length};
		for (int c = 0; c < 3; c++)
			load->force[c] = (attach[i].mass + attach[i].absorber_mass)*gravity[c] +
			                 attach[i].force[c];
		load->W = 0.0 - load->force[1];
		cable->weight += load->W;
		order[i] = i;
	}
	hawser__loaded_sort(cable, order);
}

/* Masses at lengths may change places with masses at fractions while the length is searched: the
 * search is repeated with the order of its result until the order stays. */
static int sorted(const struct hawser__loaded *cable)
{
	double unused;

	for (int i = 1; i < cable->count; i++)
		if (hawser__load_place(cable, i - 1, &unused) > hawser__load_place(cable, i, &unused))
			return 0;
	return 1;
}

static enum hawser__found search(struct hawser__loaded *cable, int *order, struct hawser__reach *r,
                                 enum hawser_given given, double value, enum hawser_branch branch)
{
	enum hawser__found outcome = HAWSER__RANGE;

	for (int i = 0; i <= HAWSER_ATTACH_MAX; i++) {
		if (given == HAWSER_GIVEN_LENGTH0 || given == HAWSER_GIVEN_H)
			outcome = close_span(cable, r, given == HAWSER_GIVEN_LENGTH0);
		else
			outcome = over_H(cable, r, given, value, branch);
		if (outcome || sorted(cable))
			break;
		hawser__loaded_sort(cable, order);
	}
	return outcome;
}

/* Returns 0 if its direction has no length. */
static int absorber(struct hawser_attached *to, const struct hawser_attachment *a,
                    const struct hawser_statics *st)
{
	const double *way = a->absorber_direction;
	double length = sqrt(way[0]*way[0] + way[1]*way[1] + way[2]*way[2]);

	if (!(a->absorber_mass > 0.0))
		return 1;
	to->absorber = a->absorber_mass/(st->span.rho*st->span.d);
	to->absorber_stiffness = a->absorber_stiffness;
	to->absorber_damping = a->absorber_damping;
	to->absorber_cubic = a->absorber_cubic;
	for (int c = 0; c < 3; c++)
		to->absorber_axis[c] = way[c]/length;
	return length > 0.0;
}

/* Of the weight alone the jump is m, to the last bit. */
static void jump_of(struct hawser_attached *to, const double force[3], const double dead[3],
                    const struct hawser_statics *st)
{
	double scale = st->span.rho*st->span.d*st->span.g;
	int weight = dead[0] == 0.0 && dead[1] == 0.0 && dead[2] == 0.0;

	for (int c = 0; c < 3; c++)
		if (!weight)
			to->jump[c] = 0.0 - force[c]/scale;
		else if (to->mass > 0.0)
			to->jump[c] = 0.0 - to->m*(force[c]/(to->mass*st->span.g));
}

/* The attachments of the solved cable. HAWSER_ERR_ARGUMENT if one is outside, or two are at a point. */
static enum hawser_status loaded_place(struct hawser_statics *st, const struct hawser__loaded *cable,
                                       const int *order, const struct hawser_attachment *attach,
                                       struct hawser_report *report)
{
	st->attachments = cable->count;
	for (int i = 0; i < cable->count; i++) {
		const struct hawser_attachment *a = &attach[order[i]];
		double unused, S = hawser__load_place(cable, i, &unused);
		struct hawser_attached *to = &st->attached[i];

		if (!(S > 0.0 && S < st->length0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "attach[%d] is %g m from end A, but the cable is only %.10g m long: "
			                    "change its position", order[i], a->at, st->length0);
		if (i > 0 && !(S - to[-1].S > 1e-9*st->length0))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "attach[%d] and attach[%d] are at the same point, %.10g m from end "
			                    "A: make one of them", order[i - 1], order[i], S);
		*to = (struct hawser_attached){.index = order[i], .S = S, .s = S/st->span.d,
		                               .mass = a->mass + a->absorber_mass};
		to->m = to->mass/(st->span.rho*st->span.d);
		jump_of(to, cable->load[i].force, a->force, st);
		memcpy(to->spring, a->spring, sizeof to->spring);
		memcpy(to->damper, a->damper, sizeof to->damper);
		to->damper_local = a->damper_local;
		to->damper_to = a->damper_to;
		if (!absorber(to, a, st))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
			                    "attach[%d] has an absorber without direction: give "
			                    "absorber_direction, such as [0, 1, 0]", order[i]);
	}
	return HAWSER_OK;
}

/* Round-off of x and y is a few units relative to the length; what it does to H at a given length,
 * or to the length at a given H, follows from the derivatives. */
static double round_off(const struct hawser__loaded *cable, const struct hawser__reach *r,
                        enum hawser_given given)
{
	double slope = 1.0, V_H, L_H, error = 4.0*DBL_EPSILON*(1 + cable->count);

	along(&V_H, &L_H, r);
	if (given == HAWSER_GIVEN_LENGTH0)
		return error*(1.0 + fabs(cable->L/(cable->H*L_H)));
	if (given != HAWSER_GIVEN_H)
		quantity(cable, r, given, &slope);
	return error*(1.0 + 1.0/fmax(fabs(slope), DBL_EPSILON));
}

static enum hawser_status fill(struct hawser_statics *st, const struct hawser__loaded *cable,
                               const struct hawser__reach *r, enum hawser_given given,
                               enum hawser_branch branch, struct hawser_report *report)
{
	double d = cable->d, H = cable->H, unused;
	struct hawser_statics spread;
	struct hawser_span span = st->span;
	enum hawser_status status;

	span.rho += cable->weight/span.g/cable->L;
	status = hawser_statics_solve(&spread, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, report);
	if (status)
		return status;
	st->given = given;
	st->branch = given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1 ? branch : HAWSER_BRANCH_TAUT;
	st->H = H;
	st->V0 = cable->V0;
	st->V1 = cable->V0 + cable->w*cable->L + cable->weight;
	st->T0 = hypot(H, st->V0);
	st->T1 = hypot(H, st->V1);
	st->eta = st->V0/H;
	st->epsilon = H/cable->EA;
	st->delta = cable->w*d/H;
	st->length0 = cable->L;
	st->l = cable->L/d;
	st->hs = cable->h/d;
	st->length = r->length;
	st->sag = hawser__loaded_sag(cable, 0.0, 0.0, &unused);
	st->irvine = spread.irvine;
	st->irvine_source = spread.irvine_source;
	st->motion.tension = st->T0;
	st->motion.tension1 = st->T1;
	st->error = round_off(cable, r, given);
	st->iterations = cable->iterations;
	return HAWSER_OK;
}

static enum hawser_status failed(const struct hawser__loaded *cable, enum hawser__found outcome,
                                 enum hawser_given given, double value, struct hawser_report *report)
{
	double V1 = cable->V0 + cable->w*cable->L + cable->weight;

	if (outcome == HAWSER__NOT_FOUND)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
		                    "the tension %s = %.10g N is below the least one with which this span "
		                    "and its attachments can hang, %.10g N (at H = %.10g N, length0 = %.10g "
		                    "m): give at least that", given == HAWSER_GIVEN_T0 ? "T0" : "T1", value,
		                    hypot(cable->H, given == HAWSER_GIVEN_T0 ? cable->V0 : V1), cable->H,
		                    cable->L);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, where,
	                    "no equilibrium of this span with its attachments was found within the range "
	                    "of double-precision numbers: check masses, tension and EA");
}

/* The masses spread over the span: the initial values. An inextensible cable shorter than the chord
 * fails here. */
static enum hawser_status spread(struct hawser__loaded *cable, const struct hawser_span *span,
                                 enum hawser_given given, double value, enum hawser_branch branch,
                                 struct hawser_report *report)
{
	double chord = hypot(span->d, span->h);
	double length = given == HAWSER_GIVEN_LENGTH0 ? value : chord;
	struct hawser_span heavy = *span;
	struct hawser_statics st;
	enum hawser_status status;

	heavy.rho += cable->weight/span->g/length;
	status = hawser_statics_solve(&st, &heavy, given, value, branch, report);
	if (status == HAWSER_ERR_NO_SOLUTION && (given == HAWSER_GIVEN_T0 || given == HAWSER_GIVEN_T1))
		status = hawser_statics_solve(&st, &heavy, HAWSER_GIVEN_H, value, branch, report);
	if (status)
		return status;
	cable->H = st.H;
	cable->V0 = st.V0;
	cable->L = given == HAWSER_GIVEN_LENGTH0 ? value : st.length0;
	return HAWSER_OK;
}

/* Loads that act downwards in the plane: the searches above. */
static enum hawser_status solve_plane(struct hawser_statics *st, struct hawser__loaded *cable,
                                      int *order, const struct hawser__load_case *of,
                                      struct hawser_report *report)
{
	struct hawser__reach reach;
	enum hawser__found outcome;
	enum hawser_status status = spread(cable, of->span, of->given, of->value, of->branch, report);

	if (status)
		return status;
	hawser__loaded_sort(cable, order);
	outcome = search(cable, order, &reach, of->given, of->value, of->branch);
	if (outcome)
		return failed(cable, outcome, of->given, of->value, report);
	*st = (struct hawser_statics){.span = *of->span};
	return fill(st, cable, &reach, of->given, of->branch, report);
}

/* Of forces across y, or upwards, the searches over H say nothing. */
static int in_plane(const struct hawser__loaded *cable, const double gravity[3])
{
	int plane = gravity[0] == 0.0 && gravity[2] == 0.0 && gravity[1] < 0.0;

	for (int i = 0; i < cable->count; i++)
		plane &= cable->load[i].force[0] == 0.0 && cable->load[i].force[2] == 0.0 &&
		         cable->load[i].W >= 0.0;
	return plane;
}

static int without_loads(const struct hawser__loaded *cable)
{
	int none = 1;

	for (int i = 0; i < cable->count; i++)
		for (int c = 0; c < 3; c++)
			none &= cable->load[i].force[c] == 0.0;
	return none;
}

enum hawser_status hawser_statics_weighted(struct hawser_statics *st, const struct hawser_span *span,
                                           enum hawser_given given, double value,
                                           enum hawser_branch branch,
                                           const struct hawser_attachment *attach, int count,
                                           const double gravity[3], struct hawser_report *report)
{
	const struct hawser__load_case of = {span, given, value, branch, attach};
	enum hawser_status status = hawser__statics_check(span, given, value, branch, report);
	int order[HAWSER_ATTACH_MAX];
	struct hawser__loaded cable;

	if (!status && (count < 0 || count > HAWSER_ATTACH_MAX))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, where,
		                      "%d attachments: give 0 to %d", count, HAWSER_ATTACH_MAX);
	if (status)
		return status;
	hawser__loaded_begin(&cable, order, span, attach, count, gravity,
	                     hypot(span->d, span->h));
	if (without_loads(&cable)) {
		status = hawser_statics_solve(st, span, given, value, branch, report);
		cable.L = st->length0;
		if (!status)
			hawser__loaded_sort(&cable, order);
		return status ? status : loaded_place(st, &cable, order, attach, report);
	}
	status = (in_plane(&cable, gravity) ? solve_plane : hawser__space_solve)(st, &cable, order, &of,
	                                                                         report);
	if (!status)
		status = loaded_place(st, &cable, order, attach, report);
	if (!status && st->space) {
		const double n[3] = {span->h/span->d, -1.0, 0.0};

		hawser_statics_farthest(&st->sag, st, n);
	}
	if (!status)
		st->closure = hawser__statics_closure(st);
	return status;
}

enum hawser_status hawser_statics_loaded(struct hawser_statics *st, const struct hawser_span *span,
                                         enum hawser_given given, double value,
                                         enum hawser_branch branch,
                                         const struct hawser_attachment *attach, int count,
                                         struct hawser_report *report)
{
	const double gravity[3] = {0.0, -span->g, 0.0};

	return hawser_statics_weighted(st, span, given, value, branch, attach, count, gravity, report);
}
