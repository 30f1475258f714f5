/* cli/motion/integrate_fields.c - the fields of a time response. A new column is a row of a table here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "cli/motion/integrate_net.h"
#include "cli/motion/integrate_result.h"
#include "cli/motion/integrate_span.h"

enum { PROBED = 1, TENSIONS = 2, ERROR = 4, SPECTRUM = 8, KNOWN = 16, SURGES = 32, SWEPT = 64,
       EXPONENTS = 128 };

static double signal_at(const void *context, const void *parent, size_t row, int k)
{
	const struct cli_integrate_result *result = parent;

	(void)context;
	return cli_integrate_signal(result, k % result->signals, row, k >= result->signals);
}

static double tension_at(const void *context, const void *parent, size_t row, int k)
{
	(void)context;
	return cli_integrate_tension(parent, k, row);
}

static double amplitude_at(const void *context, const void *parent, size_t bin, int k)
{
	const struct cli_integrate_result *result = parent;

	(void)context;
	return result->amplitude[(size_t)k*(size_t)result->bins + bin];
}

/* x, vx, y, vy, z, vz and, if it is known, T of each probe. */
HAWSER__OF(shown_of, int, struct cli_integrate_result, of->tensions ? 7 : 6)

static double probed_at(const void *context, const void *parent, size_t row, int k)
{
	int p = k/shown_of(context), c = k % shown_of(context);

	return c == 6 ? cli_integrate_tension(parent, p, row)
	              : cli_integrate_signal(parent, 3*p + c/2, row, c % 2);
}

static enum hawser__unit probed_unit(const void *context, int k)
{
	int c = k % shown_of(context);

	return c == 6 ? HAWSER__NEWTON : c % 2 ? HAWSER__M_S : HAWSER__M;
}

static void probed_name(char *text, size_t size, const void *context, int k)
{
	static const char *const name[] = {"x", "vx", "y", "vy", "z", "vz", "T"};
	const struct cli_integrate_result *result = context;
	int p = k/shown_of(context), c = k % shown_of(context);

	snprintf(text, size, "%s%c%s", result->model->rom.shapes.name[p], HAWSER__NESTED, name[c]);
}

static int probed(const void *context)
{
	const struct cli_integrate_result *result = context;

	return result->model->rom.shapes.points*shown_of(context);
}

HAWSER__OF(signals, int, struct cli_integrate_result, of->signals)

static int rates_too(const void *context)
{
	return 2*signals(context);
}

static double omega_at(const void *context, const void *parent, size_t row, int k)
{
	const struct cli_integrate_result *result = parent;

	(void)context, (void)k;
	return hawser_integrate_moment(&result->forcing, result->run.time[row]).omega;
}

static int one(const void *context)
{
	(void)context;
	return 1;
}

static void omega_name(char *text, size_t size, const void *context, int k)
{
	(void)context, (void)k;
	snprintf(text, size, "Omega");
}

HAWSER__OF(states, int, struct cli_integrate_result, 2*of->model->rom.n)

static int probes(const void *context)
{
	return signals(context)/3;
}

static void signal_name(char *text, size_t size, const void *context, int k)
{
	char name[CLI_NAME_SIZE];

	cli_signal_name(name, context, k % signals(context));
	snprintf(text, size, "%s%s", k < signals(context) ? "" : "v", name);
}

static void probe_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_integrate_result *result = context;

	snprintf(text, size, "%s", result->model->rom.shapes.name[k]);
}

static void state_name(char *text, size_t size, const void *context, int k)
{
	int n = states(context)/2;

	snprintf(text, size, "%c_%d", k < n ? 'u' : 'v', k % n + 1);
}
static const struct hawser__vector
	signal_vector = {.shown = "x_PROBE", .count = rates_too, .name = signal_name,
	                 .number = signal_at, .rate = HAWSER__M_S},
	tension_vector = {.shown = "PROBE", .count = probes, .name = probe_name, .number = tension_at},
	state_vector = {.shown = "u_J", .count = states, .name = state_name, .rate = HAWSER__M_S},
	omega_vector = {.shown = "Omega", .count = one, .name = omega_name, .number = omega_at},
	probed_vector = {.count = probed, .name = probed_name, .number = probed_at, .unit = probed_unit,
	                 .object = 1},
	amplitude_vector = {.shown = "x_PROBE", .count = signals, .name = signal_name,
	                    .number = amplitude_at, .object = 1};

#define OF(member) HAWSER__ALONG(struct cli_integrate_result, run.member)
#define STATES HAWSER__VECTOR_ALONG(struct cli_integrate_result, run.state, state_vector), \
	.unit = HAWSER__M
static const struct hawser__field history_field[] = {
	{"times", "t", "time", OF(time), .unit = HAWSER__S, .axis = "Time {/:Italic t}"},
	{NULL, "", "forcing frequency, with --Omega-to", HAWSER__VECTOR_OF(omega_vector),
	 .unit = HAWSER__RAD_S, .when = SWEPT},
	{"states", NULL, "a list a time: coordinates, then velocities", STATES},
	{NULL, "", "displacement at a probe; vx_PROBE_m_s: its velocity",
	 HAWSER__VECTOR_OF(signal_vector), .unit = HAWSER__M, .when = PROBED},
	{NULL, "T_", "tension at a probe", HAWSER__VECTOR_OF(tension_vector), .unit = HAWSER__NEWTON,
	 .when = TENSIONS},
	{NULL, "", "coordinate; v_J_m_s: its velocity", STATES},
	{NULL, "energy", "of the model", OF(energy), .unit = HAWSER__J},
	{NULL, "error", "estimated error of the state, relative to the largest, with --error",
	 HAWSER__ALONG(struct cli_integrate_result, error), .when = ERROR},
	HAWSER__END,
};
static const struct hawser__field probes_field[] = {
	{"PROBE", NULL, "lists x, vx, y, vy, z, vz, T", HAWSER__VECTOR_OF(probed_vector)},
	HAWSER__END,
};
static const struct hawser__field energy_field[] = {
	{"energy", NULL, "of the model", OF(energy), .unit = HAWSER__J},
	{"error", NULL, "estimated error of the state, relative to the largest, with --error",
	 HAWSER__ALONG(struct cli_integrate_result, error), .when = ERROR},
	HAWSER__END,
};
static const struct hawser__field spectrum_field[] = {
	{"frequency", "frequency", "of the bin", HAWSER__ALONG(struct cli_integrate_result, frequency),
	 .unit = HAWSER__HZ},
	{"SIGNAL", "", "amplitude of the displacement at a probe, or of a coordinate u_J",
	 HAWSER__VECTOR_OF(amplitude_vector), .unit = HAWSER__M_ALREADY},
	HAWSER__END,
};
static const struct hawser__field exponent_field[] = {
	{"exponent", NULL, "mean rates of growth of disturbances, from the largest",
	 HAWSER__ALONG(struct cli_integrate_result, lyapunov.exponent),
	 .unit = HAWSER__PER_S},
	{"error", NULL, "their errors: scatter of the mean (95 %), and integration",
	 HAWSER__ALONG(struct cli_integrate_result, lyapunov.error),
	 .unit = HAWSER__PER_S},
	HAWSER__END,
};
#undef OF
#define ROWS(number, fields) \
	{.field = (fields), .count_at = offsetof(struct cli_integrate_result, number)}
static const struct hawser__list history_list = ROWS(run.rows, history_field),
                                 probes_list = ROWS(run.rows, probes_field),
                                 energy_list = ROWS(run.rows, energy_field),
                                 exponent_list = ROWS(lyapunov.m, exponent_field),
                                 spectrum_list = ROWS(bins, spectrum_field);

static int coordinates(const void *context)
{
	return states(context)/2;
}

static int multipliers(const void *context)
{
	return 2*states(context);
}
static const struct hawser__vector
	harmonic_vector = {.count = coordinates},
	multiplier_vector = {.count = multipliers, .pair = {"log_modulus", "argument"}};

static const struct hawser__field harmonic_field[] = {
	{"k", NULL, "multiple of the frequency of the motion", HAWSER__ALONG(struct cli_orbit, k)},
	{"amplitude", NULL, "of each coordinate",
	 HAWSER__VECTOR_ALONG(struct cli_orbit, amplitude, harmonic_vector), .unit = HAWSER__M},
	HAWSER__END,
};
static const struct hawser__list harmonic_list = {
	.field = harmonic_field, .count_at = offsetof(struct cli_orbit, harmonics)};

#define OF(member) HAWSER__AT(struct cli_orbit, member)
static const struct hawser__field orbit_field[] = {
	{"orbit.label", NULL, "hawser orbit: label of the motion", OF(label)},
	{"orbit.kind", NULL, "of the event, if it is one", OF(kind), .flags = HAWSER__OMIT},
	{"orbit.period", NULL, "periods of the load in one of the motion", OF(period)},
	{"orbit.closure", NULL, "change of the state over a period of the motion, relative",
	 OF(closure)},
	{"orbit.normal_form.coefficient", NULL, "of an event: of the normal form of the period "
	 "map, in 1/m of a fold, else 1/m^2, or in the units of the model", OF(form),
	 .flags = HAWSER__OMIT},
	{"orbit.normal_form.error", NULL, "its estimated error", OF(form_error), .flags = HAWSER__OMIT},
	{"orbit.normal_form.verdict", NULL, "supercritical or subcritical; quadratic of a fold",
	 OF(verdict), .flags = HAWSER__OMIT},
	{"orbit.normal_form.reason", NULL, "why an event has none", OF(formless), .flags = HAWSER__OMIT},
	{"orbit.harmonics", NULL, "its Fourier coefficients", HAWSER__OBJECTS_OF(harmonic_list)},
	{"orbit.multipliers", NULL, "Floquet multipliers: logarithm of the modulus, argument",
	 .kind = HAWSER__VECTOR, HAWSER__PLACE(struct cli_orbit, multiplier),
	 .vector = &multiplier_vector},
	HAWSER__END,
};
#undef OF

#define OF(member) HAWSER__AT(struct cli_integrate_result, member)
static const struct hawser__field integrate_field[] = {
	{"", NULL, "", HAWSER__THROUGH(struct cli_integrate_result, model, cli_si_field)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_integrate_result, model, cli_choice_field)},
	{"", NULL, "", HAWSER__PART_OF(struct cli_integrate_result, model_error, cli_fixed_field)},
	{"method", NULL, "integrator", OF(run.method)},
	{"Omega", NULL, "forcing frequency; 0: none", OF(omega), .unit = HAWSER__RAD_S},
	{"Omega_to", NULL, "with --Omega-to: that at the end", OF(forcing.omega_to),
	 .unit = HAWSER__RAD_S, .when = SWEPT},
	{"end", NULL, "complete, interrupted or failed", HAWSER__TEXT_BY(cli_integrate_end)},
	{"", NULL, "", HAWSER__THROUGH(struct cli_integrate_result, orbit, orbit_field)},
	{"", NULL, "", HAWSER__ARRAYS_OF(history_list), .flags = HAWSER__STREAM},
	{"probes", NULL, "by name", HAWSER__ARRAYS_OF(probes_list), .flags = HAWSER__STREAM},
	{"", NULL, "", HAWSER__ARRAYS_OF(energy_list), .flags = HAWSER__STREAM},
	{"tension.min", NULL, "least tension anywhere on the cable, at the times of the output",
	 OF(least), .unit = HAWSER__NEWTON, .when = KNOWN},
	{"tension.max", NULL, "greatest", OF(most), .unit = HAWSER__NEWTON, .when = KNOWN},
	{"", NULL, "", HAWSER__PART_OF(struct cli_integrate_result, surge, cli_surge_field),
	 .when = SURGES},
	{"lyapunov", NULL, "Lyapunov exponents, with --lyapunov", HAWSER__ARRAYS_OF(exponent_list),
	 .when = EXPONENTS},
	{"lyapunov_periods", NULL, "number of periods of which they are averages", OF(lyapunov.averaged),
	 .when = EXPONENTS},
	{"spectrum", NULL, "with --spectrum", HAWSER__ARRAYS_OF(spectrum_list),
	 .when = SPECTRUM},
	{"spectrum_periods", NULL, "periods of which the spectrum is", OF(window.periods),
	 .when = SPECTRUM},
	{"spectrum_loss", NULL, "part of its amplitude that the forcing lacks on its bin",
	 OF(window.loss), .when = SPECTRUM},
	HAWSER__END,
};
static const struct hawser__field cost_field[] = {
	{"steps", NULL, "of the integrator", OF(run.steps)},
	{"evaluations", NULL, "of the equations", OF(run.evaluations)},
	{"jacobians", NULL, "of the equations", OF(run.jacobians)},
	HAWSER__END,
};
#undef OF
const struct cli_listing cli_integrate_listing[] = {
	{"Columns of the table:", history_field, 0},
	{"Columns with --spectrum:", spectrum_field, 0},
	{"Columns with --model fe:", cli_span_history_field, 0},
	{"Keys of JSON:", integrate_field, 1},
	{"Keys of JSON with --model fe:", cli_span_field, 1},
	{"Columns of a net:", cli_net_motion_field, 0},
	{"Keys of JSON of a net:", cli_net_motion_field, 1},
	{"Columns of a rod:", cli_rod_motion_field, 0},
	{"Keys of JSON of a rod:", cli_rod_motion_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct cli_integrate_result *result = of;
	struct cli_head head = cli_model_head(
		result->common, result->orbit ? "orbit" : "integrate", result->run.method, result->model,
		(result->probed ? PROBED : 0u) | (result->tensions ? TENSIONS : 0u) |
		(result->error ? ERROR : 0u) | (result->spectrum ? SPECTRUM : 0u) |
		(isfinite(result->least) ? KNOWN : 0u) | (result->surges ? SURGES : 0u) |
		(result->forcing.omega_to > 0.0 ? SWEPT : 0u) |
		(result->lyapunov.averaged > 0 ? EXPONENTS : 0u));

	head.view.context = result;
	head.list = result->spectrum ? &spectrum_list : &history_list;
	return head;
}

struct hawser__axis cli_integrate_axis(const struct cli_integrate_result *result)
{
	const struct hawser__view view = head(result).view;

	return hawser__fields_axis(history_field, "t", &view, 0.0);
}

const struct cli_showing cli_integrate_showing = {
	.head = head, .comments = cli_integrate_comments, .fields = integrate_field,
	.stats = cost_field, .draw = cli_integrate_draw};
