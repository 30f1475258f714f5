/* Values of a scene that are probably mistakes cause a warning with the key; unusual but real
 * values do not.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include <hawser/plausible.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

static const char cable[] =
	"cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, h: 10 m}\ntension: {T0: 80 kN}\n"
	"damping: {alpha: 0.08 kg/m/s}\nload: {frame: local, per_length: [0.8 N/m, 0.8, 0.8]}\n";
static const char beam[] =
	"beam: {EI: 4, rhoA: 1, L: 10, tension_end: 100, gravity: none}\n";

static int doubts(struct hawser_doubt *doubt, const char *text, const char *set)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	int count = -1;

	if (!read_text(&scene, text, *set ? set : NULL, &report))
		count = hawser_scene_doubts(doubt, &scene);
	else
		printf("# %s\n", report.message);
	hawser_scene_clear(&scene);
	return count;
}

/* One doubt, with these words. */
static void slip(const char *text, const char *set, const char *says)
{
	struct hawser_doubt doubt[HAWSER_DOUBTS];
	int count = doubts(doubt, text, set);

	ok(count == 1 && strstr(doubt[0].text, says), "%s: %s", set, count > 0 ? doubt[0].text : "-");
}

static void fine(const char *text, const char *set)
{
	struct hawser_doubt doubt[HAWSER_DOUBTS];
	int count = doubts(doubt, text, set);

	ok(count == 0, "%.40s %s: nothing is said%s%s", text, set, count > 0 ? ", but " : "",
	   count > 0 ? doubt[0].text : "");
}

static void slips(void)
{
	slip(cable, "cable.EA=400", "cable.EA = 400 N looks wrong: the speed of sound along the cable, "
	     "sqrt(EA/rho), is 8.16 m/s (plausible: 100 to 15000 m/s); it would be plausible with "
	     "400 MN");
	slip(cable, "cable.EA=400 mN", "plausible with 400 MN (m is milli, M is mega)");
	slip(cable, "cable.EA=400 kN", "the static strain, largest tension/EA, is 0.201");
	slip(cable, "cable.EA=400 GN", "plausible with 400 MN");
	slip(cable, "cable.EA=1.3 MN", "cable.EA = 1.3e+06 N, tension.T0 = 80000 N look wrong");
	slip(cable, "tension.H=30", "tension.H = 30 N looks wrong");
	slip(cable, "tension.H=30", "plausible with 30 kN");
	slip(cable, "tension.H=30 mN", "plausible with 30 kN (m is milli, M is mega)");
	slip(cable, "tension.T0=80", "the span is far from having a static shape; it would be plausible "
	     "with 80 kN");
	slip(cable, "cable.rho=6000", "plausible with 6 kg/m");
	slip(cable, "cable.rho=6 mg/m", "cable.rho = 6e-06 kg/m");
	slip(cable, "tension.sag=250e6", "tension.sag = 2.5e+08 m looks wrong");
	slip(cable, "span.d=250 km", "span.d = 250000 m");
	slip(cable, "g=981", "plausible with 9.81 m/s^2");
	slip(cable, "travel={speed: 5000, hold: length}", "travel.speed = 5000 m/s");
	slip(cable, "load.per_length=[0.8 kN/m, 0, 0.8]", "plausible with 0.8 N/m");
	slip(cable, "damping.alpha=80", "damping.alpha = 80 kg/m/s");
	slip(cable, "damping={ratio: 5}", "plausible with 0.05");
	slip(cable, "damping={rayleigh: {mass: 0.01, stiffness: 30}}", "damping.rayleigh.stiffness");
	slip(beam, "beam.EI=4e9", "beam.EI = 4e+09");
	slip(beam, "beam.L=1000 km", "beam.L = 1e+06 m");
	slip(beam, "beam.tension_end=100 GN", "beam.tension_end = 1e+11 N");
	slip(beam, "beam.speed=5000", "beam.speed = 5000 m/s");
}

/* Light and heavy, short and long, deep and taut, fast: all of them are real. */
static void real(void)
{
	static const char *const scene[] = {
		"cable: {EA: 30 MN, rho: 1.6}\nspan: {d: 400, h: 12}\ntension: {T0: 24 kN}\n"
		"damping: {ratio: 0.005}\nload: {frame: global, per_length: [0, 0.15, 0.25]}\n",
		"cable: {EA: 90 kN, rho: 4 g/m}\nspan: {d: 0.5, h: 0.04}\ntension: {T1: 30 N}\n"
		"damping: {ratio: 0.004}\nload: {frame: local, per_length: [0, 0.03, 0.02]}\n",
		"cable: {EA: 40 kN, rho: 0.15}\nspan: {d: 30, h: 1.5}\ntension: {H: 1.2 kN}\n"
		"damping: {ratio: 0.006}\nload: {frame: global, per_length: [0.05, 0.25, 0.3]}\n",
		"cable: {EA: 1800 MN, rho: 78}\nspan: {d: 180, h: 87}\ntension: {T0: 5200 kN}\n"
		"damping: {ratio: 0.002}\nload: {frame: local, per_length: [0, 25, 18]}\n",
		"cable: {EA: 40 MN, rho: 18}\nspan: {d: 120, h: -6}\ntension: {sag: 30}\n"
		"damping: {alpha: 1.5}\nload: {frame: global, per_length: [0, 2, 3]}\n",
		"cable: {EA: 12 MN, rho: 1.2}\nspan: {d: 50, h: 3}\ntension: {sag: 15}\n"
		"damping: {ratio: 0.01}\nload: {frame: global, per_length: [0, 0.1, 0.12]}\n",
		/* a violin string, a lift's hanging cable, a tape machine, a suspension bridge, a slack
		 * line with a tension just below the least one */
		"cable: {EA: 30 kN, rho: 0.6 g/m}\nspan: {d: 0.33, h: 0}\ntension: {H: 55}\n"
		"damping: {ratio: 0.002}\n",
		"cable: {EA: 1 MN, rho: 1.1}\nspan: {d: 0.6, h: 20}\ntension: {sag: 40}\n"
		"damping: {ratio: 0.02}\n",
		"cable: {EA: 6 kN, rho: 0.3 g/m}\nspan: {d: 0.2, h: 0}\ntension: {T0: 2}\n"
		"travel: {speed: 40, hold: length}\ndamping: {ratio: 0.002}\n",
		"cable: {EA: 1.7e11, rho: 8000}\nspan: {d: 1990, h: 0}\ntension: {sag: 200}\n"
		"damping: {ratio: 0.003}\n",
		"cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, h: 10 m}\ntension: {T0: 5 kN}\n"
		"damping: {alpha: 0.08 kg/m/s}\n",
		"cable: {EA: .inf, rho: 6}\nspan: {d: 250, h: 0}\ntension: {H: 8e4}\n"
		"damping: {ratio: 0.003}\n",
		"beam: {EI: 2.1e6, rhoA: 78, L: 12, tension_end: 4e5, gravity: across, speed: 20}\n",
		"beam: {mu: 1, rho: 10, c: 0}\n",
	};

	fine(cable, "");
	fine(beam, "");
	for (size_t i = 0; i < sizeof scene/sizeof *scene; i++)
		fine(scene[i], "");
}

/* Two mistakes at once cannot be corrected by one factor: both are reported. */
static void both(void)
{
	struct hawser_doubt doubt[HAWSER_DOUBTS];
	int count = doubts(doubt, cable, "cable={EA: 400, rho: 6 g/m}");
	int rules = 0;

	ok(count >= 1, "EA and rho: %d doubts", count);
	while (hawser_plausible_rule(rules))
		rules++;
	ok(hawser_plausible_rule(0)->low > 0.0 && rules <= HAWSER_DOUBTS, "%d rules", rules);
}

CASE(unit_plausible)
{
	slips();
	real();
	both();
	return done_testing();
}
