/* Invalid scenes: every failure, with the whole message. The text before the first colons is the
 * place: file, line and column, or the override.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/tap.h"
#include "tests/unit/scene-text.h"

#define CABLE "cable: {EA: 4e8, rho: 6}\n"
#define SPAN "span: {d: 250, h: 10}\n"
#define TENSION "tension: {T0: 8e4}\n"
#define WHOLE CABLE SPAN TENSION
#define TEN "xxxxxxxxxx"
#define LONG TEN TEN TEN TEN TEN TEN TEN TEN TEN TEN
#define NINES "99999999999999999999999999999999999999999999999999" \
	"99999999999999999999999999999999999999999999999999"

static const struct {
	const char *text, *set, *message;
} table[] = {
	/* YAML */
	{CABLE "span: {d: 250, h: 10\n" TENSION, NULL,
	 "s.yaml:2:19: span.h runs over several lines, up to line 3: is a bracket, quote or "
	 "colon missing?"},
	{"cable:\n\tEA: 3\n", NULL,
	 "s.yaml:2:1: YAML syntax: a tab, where only spaces may be: indent with spaces"},
	{"cable: {EA: 4e8}}\n", NULL,
	 "s.yaml:1:17: YAML syntax: did not find expected key while parsing a block mapping "
	 "(line 1)"},
	{"cable: \"EA\n", NULL,
	 "s.yaml:2:1: YAML syntax: found unexpected end of stream while scanning a quoted "
	 "scalar (line 1)"},
	{"cable: \001\n", NULL,
	 "s.yaml: not a text in UTF-8: control characters are not allowed at byte 8"},
	{"cable: \377\376\377\n", NULL,
	 "s.yaml: not a text in UTF-8: invalid leading UTF-8 octet at byte 8"},
	/* anchors, aliases, tags */
	{"cable: &c {EA: 4e8, rho: 6}\n", NULL,
	 "s.yaml:1:8: a scene has no anchors: remove &c"},
	{"cable: {EA: &e 4e8, rho: *e}\n", NULL,
	 "s.yaml:1:13: a scene has no anchors: remove &e"},
	{"cable: *c\n", NULL,
	 "s.yaml:1:8: a scene has no aliases: write the value out instead of *c"},
	{"cable: {EA: !!float 4e8, rho: 6}\n", NULL,
	 "s.yaml:1:13: a scene has no tags: remove tag:yaml.org,2002:float"},
	{"cable: !cable {EA: 4e8, rho: 6}\n", NULL,
	 "s.yaml:1:8: a scene has no tags: remove !cable"},
	{"load: {per_length: &l [1, 2, 3]}\n", NULL,
	 "s.yaml:1:20: a scene has no anchors: remove &l"},
	{"<<: {EA: 4e8}\n", NULL,
	 "s.yaml:1:1: unknown key <<: the scene takes g, cable, ends, span, tension, travel, support, "
	 "damping, wind, load, temperature, model, beam, attach, loads, cases, kind"},
	/* documents */
	{"", NULL,
	 "s.yaml: a scene is a mapping of keys to values, such as \"cable: {EA: 400 MN, rho: 6 "
	 "kg/m}\", and needs at least cable, span and tension (see hawser-scene(5))"},
	{"# nothing here\n\n", NULL,
	 "s.yaml: a scene is a mapping of keys to values, such as \"cable: {EA: 400 MN, rho: 6 "
	 "kg/m}\", and needs at least cable, span and tension (see hawser-scene(5))"},
	{"---\n", NULL,
	 "s.yaml: a scene is a mapping of keys to values, such as \"cable: {EA: 400 MN, rho: 6 "
	 "kg/m}\", and needs at least cable, span and tension (see hawser-scene(5))"},
	{"~\n", NULL,
	 "s.yaml: a scene is a mapping of keys to values, such as \"cable: {EA: 400 MN, rho: 6 "
	 "kg/m}\", and needs at least cable, span and tension (see hawser-scene(5))"},
	{"- cable\n- span\n", NULL,
	 "s.yaml: a scene is a mapping of keys to values, such as \"cable: {EA: 400 MN, rho: 6 "
	 "kg/m}\", and needs at least cable, span and tension (see hawser-scene(5))"},
	{"cable\n", NULL,
	 "s.yaml: a scene is a mapping of keys to values, such as \"cable: {EA: 400 MN, rho: 6 "
	 "kg/m}\", and needs at least cable, span and tension (see hawser-scene(5))"},
	{WHOLE "---\n" WHOLE, NULL,
	 "s.yaml:4:1: a second document begins here: a scene is one document, so remove what "
	 "follows"},
	/* unknown and duplicate keys */
	{"cable: {Ea: 4e8, rho: 6}\n", NULL,
	 "s.yaml:1:9: unknown key cable.Ea: did you mean EA? cable takes EA, rho, EI"},
	{CABLE "sapn: {d: 250, h: 10}\n", NULL,
	 "s.yaml:2:1: unknown key sapn: did you mean span? the scene takes g, cable, ends, span, "
	 "tension, travel, support, damping, wind, load, temperature, model, beam, attach, loads, cases, "
	 "kind"},
	{WHOLE "EA: 3\n", NULL,
	 "s.yaml:4:1: unknown key EA: did you mean EA under cable? the scene takes g, cable, ends, "
	 "span, tension, travel, support, damping, wind, load, temperature, model, beam, attach, loads, "
	 "cases, kind"},
	{WHOLE "cable.EA: 3\n", NULL,
	 "s.yaml:4:1: unknown key cable.EA: did you mean EA under cable? the scene takes g, cable, "
	 "ends, span, tension, travel, support, damping, wind, load, temperature, model, beam, attach, "
	 "loads, cases, kind"},
	{WHOLE "cable.Eb: 3\n", NULL,
	 "s.yaml:4:1: unknown key cable.Eb: did you mean EA under cable? the scene takes g, cable, "
	 "ends, span, tension, travel, support, damping, wind, load, temperature, model, beam, attach, "
	 "loads, cases, kind"},
	{WHOLE "railway: {speed: 5 m/s}\n", NULL,
	 "s.yaml:4:1: unknown key railway: the scene takes g, cable, ends, span, tension, travel, "
	 "support, damping, wind, load, temperature, model, beam, attach, loads, cases, kind"},
	{WHOLE "travel: {speed: 5 m/s, hold: length, final: 2}\n", NULL,
	 "s.yaml:4:38: travel.final is the speed after braking: give the time that braking takes with "
	 "travel.braking, or remove travel.final"},
	{WHOLE "travel: {speed: 5 m/s, hold: length, fluctuation: 1, braking: 3 s}\n", NULL,
	 "s.yaml:4:54: travel.braking contradicts travel.fluctuation: a speed either repeats itself or "
	 "changes once and for all"},
	{WHOLE "\"\": 3\n", NULL,
	 "s.yaml:4:1: unknown key \"\": the scene takes g, cable, ends, span, tension, travel, "
	 "support, damping, wind, load, temperature, model, beam, attach, loads, cases, kind"},
	{WHOLE "? [a, b]\n: 3\n", NULL,
	 "s.yaml:4:3: a key must be a word, not a list"},
	{WHOLE "? {a: b}\n: 3\n", NULL,
	 "s.yaml:4:3: a key must be a word, not a mapping"},
	{"cable: {EA: 4e8,\n  EA: 5e8, rho: 6}\n", NULL,
	 "s.yaml:2:3: duplicate key cable.EA, already given in line 1: keep one"},
	{WHOLE "cable: {EA: 4e8}\n", NULL,
	 "s.yaml:4:1: duplicate key cable, already given in line 1: keep one"},
	{LONG LONG LONG ": 3\n", NULL,
	 "s.yaml:1:1: this key is 300 characters long; 255 is the most"},
	{LONG ": 3\n", NULL,
	 "s.yaml:1:1: unknown key xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...: the scene takes g, cable, "
	 "ends, span, tension, travel, support, damping, wind, load, temperature, model, beam, attach, "
	 "loads, cases, kind"},
	{WHOLE "\"a\\0b\": 3\n", NULL,
	 "s.yaml:4:1: this key holds a NUL character: remove it"},
	/* missing */
	{"cable: {EA: 4e8}\n" SPAN TENSION, NULL,
	 "s.yaml:1:1: cable.rho is missing: give a number in kg/m (mass per unstretched length)"},
	{"cable: {rho: 6}\n" SPAN TENSION, NULL,
	 "s.yaml:1:1: cable.EA is missing: give a number in N (axial stiffness; .inf makes it "
	 "inextensible, for statics only)"},
	{"cable: {}\n" SPAN TENSION, NULL,
	 "s.yaml:1:1: cable.EA is missing: give a number in N (axial stiffness; .inf makes it "
	 "inextensible, for statics only)"},
	{SPAN TENSION, NULL,
	 "s.yaml:1:1: cable is missing: give a mapping with the keys EA, rho, EI (the cable, uniform "
	 "along its unstretched length)"},
	{CABLE TENSION, NULL,
	 "s.yaml:1:1: span is missing: give a mapping with the keys d, h (the positions of the ends: A "
	 "at the origin, B at (d, h))"},
	{CABLE "span: {h: 10}\n" TENSION, NULL,
	 "s.yaml:2:1: span.d is missing: give a number in m (horizontal distance between the ends)"},
	{CABLE "span: {d: 250}\n" TENSION, NULL,
	 "s.yaml:2:1: span.h is missing: give a number in m (height of end B above end A; negative if "
	 "B is lower)"},
	{CABLE SPAN, NULL,
	 "s.yaml:1:1: tension is missing: give a mapping with the keys H, T0, T1, length0, sag, "
	 "branch, state (the quantity that determines the tension at rest: one of H, T0, T1, length0 "
	 "and sag)"},
	{CABLE SPAN "tension: {}\n", NULL,
	 "s.yaml:3:1: tension needs one of H (N), T0 (N), T1 (N), length0 (m) and sag (m)"},
	{CABLE SPAN "tension: {branch: slack}\n", NULL,
	 "s.yaml:3:1: tension needs one of H (N), T0 (N), T1 (N), length0 (m) and sag (m)"},
	{WHOLE "damping: {}\n", NULL,
	 "s.yaml:4:1: the kind of damping is missing: give exactly one of alpha, rayleigh, ratio"},
	{WHOLE "damping: {rayleigh: {}}\n", NULL,
	 "s.yaml:4:11: damping.rayleigh.mass is missing: give a number in 1/s (factor of the mass "
	 "matrix)"},
	{WHOLE "damping: {rayleigh: {mass: 0.1}}\n", NULL,
	 "s.yaml:4:11: damping.rayleigh.stiffness is missing: give a number in s (factor of the "
	 "stiffness matrix)"},
	{WHOLE "damping:\n  rayleigh:\n    stiffness: 0.1\n", NULL,
	 "s.yaml:5:3: damping.rayleigh.mass is missing: give a number in 1/s (factor of the mass "
	 "matrix)"},
	{WHOLE "load: {}\n", NULL,
	 "s.yaml:4:1: load.frame is missing: give local or global (axes of the load: local is "
	 "tangent, normal, binormal (e, n, z), global is x, y, z)"},
	{WHOLE "load: {frame: local}\n", NULL,
	 "s.yaml:4:1: load.per_length is missing: give a list of 3 numbers in N/m (amplitude of the "
	 "harmonic load per unstretched length along the three axes)"},
	{WHOLE "load: {per_length: [1, 2, 3]}\n", NULL,
	 "s.yaml:4:1: load.frame is missing: give local or global (axes of the load: local is "
	 "tangent, normal, binormal (e, n, z), global is x, y, z)"},
	/* contradictory */
	{CABLE SPAN "tension: {T0: 8e4,\n          H: 9e4}\n", NULL,
	 "s.yaml:4:11: tension.H contradicts tension.T0 in line 3: give one of H, T0, T1, length0 and "
	 "sag"},
	{CABLE SPAN "tension: {sag: 2 m, length0: 251}\n", NULL,
	 "s.yaml:3:21: tension.length0 contradicts tension.sag in line 3: give one of H, T0, T1, "
	 "length0 and sag"},
	{WHOLE "damping: {alpha: 0.08, ratio: 0.01}\n", NULL,
	 "s.yaml:4:24: damping.ratio contradicts damping.alpha in line 4: give one of alpha, ratio and "
	 "rayleigh"},
	{WHOLE "damping: {ratio: 0.01, rayleigh: {mass: 0.1, stiffness: 1e-3}}\n", NULL,
	 "s.yaml:4:24: damping.rayleigh contradicts damping.ratio in line 4: give one of alpha, ratio "
	 "and rayleigh"},
	{CABLE SPAN "tension: {H: 8e4, branch: taut}\n", NULL,
	 "s.yaml:3:19: tension.branch contradicts tension.H, which has one equilibrium only: "
	 "remove tension.branch, or give T0 or T1"},
	{CABLE SPAN "tension: {branch: slack, sag: 2}\n", NULL,
	 "s.yaml:3:11: tension.branch contradicts tension.sag, which has one equilibrium "
	 "only: remove tension.branch, or give T0 or T1"},
	/* kinds of value */
	{"cable: 3\n", NULL,
	 "s.yaml:1:8: cable: \"3\" must be a mapping with the keys EA, rho, EI"},
	{"cable: [3]\n", NULL,
	 "s.yaml:1:8: cable is a list, but must be a mapping with the keys EA, rho, EI"},
	{"cable:\n", NULL,
	 "s.yaml:1:7: cable has no value: give a mapping with the keys EA, rho, EI"},
	{"cable: {EA: {N: 3}}\n", NULL,
	 "s.yaml:1:13: cable.EA is a mapping, but must be a number in N"},
	{"cable: {EA: [3]}\n", NULL,
	 "s.yaml:1:13: cable.EA is a list, but must be a number in N"},
	{"cable: {EA: , rho: 6}\n", NULL,
	 "s.yaml:1:13: cable.EA has no value: give a number in N"},
	{"cable: {EA: ~}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"~\" is not a number: give a number in N, or with a unit "
	 "that converts to N"},
	{"cable: {EA: |\n  3}\n", NULL,
	 "s.yaml:1:13: YAML syntax: found character that cannot start any token while "
	 "scanning for the next token (line 1)"},
	{"cable:\n  EA: |\n    400 MN\n", NULL,
	 "s.yaml:2:7: cable.EA runs over several lines, up to line 4: is a bracket, quote or "
	 "colon missing?"},
	{"cable:\n  EA: 400 MN\n   rho\n  d: 3\n", NULL,
	 "s.yaml:2:7: cable.EA runs over several lines, up to line 3: is a bracket, quote or "
	 "colon missing?"},
	{"cable: {EA: '" NINES NINES NINES "'}\n", NULL,
	 "s.yaml:1:13: cable.EA is 300 characters long; 255 is the most"},
	{"cable: {EA: \"4\\0\"}\n", NULL,
	 "s.yaml:1:13: cable.EA holds a NUL character: remove it"},
	{"tension: {branch: loose}\n", NULL,
	 "s.yaml:1:19: tension.branch: \"loose\" must be taut or slack"},
	{"tension: {branch: ta}\n", NULL,
	 "s.yaml:1:19: tension.branch: \"ta\" must be taut or slack"},
	{"tension: {branch: [taut]}\n", NULL,
	 "s.yaml:1:19: tension.branch is a list, but must be taut or slack"},
	{"tension: {branch: }\n", NULL,
	 "s.yaml:1:19: tension.branch has no value: give taut or slack"},
	{"load: {per_length: 0.8 N/m}\n", NULL,
	 "s.yaml:1:20: load.per_length: \"0.8 N/m\" must be a list of 3 numbers in N/m"},
	{"load: {per_length: }\n", NULL,
	 "s.yaml:1:20: load.per_length has no value: give a list of 3 numbers in N/m"},
	{"load: {per_length: []}\n", NULL,
	 "s.yaml:1:20: load.per_length has 0 values, but must be a list of 3 numbers in N/m (amplitude "
	 "of the harmonic load per unstretched length along the three axes)"},
	{"load: {per_length: [1]}\n", NULL,
	 "s.yaml:1:20: load.per_length has 1 value, but must be a list of 3 numbers in N/m (amplitude "
	 "of the harmonic load per unstretched length along the three axes)"},
	{"load: {per_length: [1, 2]}\n", NULL,
	 "s.yaml:1:20: load.per_length has 2 values, but must be a list of 3 numbers in N/m (amplitude "
	 "of the harmonic load per unstretched length along the three axes)"},
	{"load: {per_length: [1, 2, 3, 4]}\n", NULL,
	 "s.yaml:1:20: load.per_length has 4 values, but must be a list of 3 numbers in N/m (amplitude "
	 "of the harmonic load per unstretched length along the three axes)"},
	{"load: {per_length: [1, [2], 3]}\n", NULL,
	 "s.yaml:1:24: load.per_length[1] is a list, but must be a single value"},
	{"load: {per_length: [1, {a: 2}, 3]}\n", NULL,
	 "s.yaml:1:24: load.per_length[1] is a mapping, but must be a single value"},
	{"load: {per_length: [1, 2 m, 3]}\n", NULL,
	 "s.yaml:1:24: load.per_length[1]: \"2 m\" has a wrong unit \"m\", not convertible "
	 "to N/m: give a number in N/m, or with a unit that converts to N/m"},
	{"load: {per_length: [1, .inf, 3]}\n", NULL,
	 "s.yaml:1:24: load.per_length[1]: \".inf\" is out of range: it must be finite, in "
	 "N/m"},
	{"load: {per_length: {x: 1}}\n", NULL,
	 "s.yaml:1:20: load.per_length is a mapping, but must be a list of 3 numbers in N/m"},
	{"model: {modes: 2.5}\n", NULL,
	 "s.yaml:1:16: model.modes: 2.5 is not a whole number from 1 to 1000"},
	{"model: {modes: many}\n", NULL,
	 "s.yaml:1:16: model.modes: \"many\" must be a whole number, or auto"},
	{"model: {modes: [auto]}\n", NULL,
	 "s.yaml:1:16: model.modes is a list, but must be a whole number, or auto"},
	{"model: {modes: 0}\n", NULL,
	 "s.yaml:1:16: model.modes: 0 is not a whole number from 1 to 1000"},
	{"model: {modes: auto, accuracy: 100 %}\n", NULL,
	 "s.yaml:1:32: model.accuracy: \"100 %\" is out of range: it must be between 0 and 1"},
	{"model: {accuracy: 1 mm}\n", NULL,
	 "s.yaml:1:19: model.accuracy: \"1 mm\" has a wrong unit \"mm\", not convertible to "
	 "a pure number: give a pure number"},
	/* units and numbers */
	{"cable: {EA: 400 kg, rho: 6}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"400 kg\" is a mass (\"kg\"); a force is wanted: under standard gravity "
	 "it belongs to \"3922.66 N\", or \"881.84905 lbf\""},
	{"cable: {EA: 400 Mn, rho: 6}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"400 Mn\" has an unknown unit \"Mn\": did you mean "
	 "MN? give a number in N, "
	 "or with a unit that converts to N"},
	{"cable: {EA: foo, rho: 6}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"foo\" is not a number: give a number in N, or with a unit "
	 "that converts to N"},
	{"cable: {EA: 4,5 MN}\n", NULL,
	 "s.yaml:1:15: unknown key cable.5 MN: is it a decimal comma? A number has a decimal "
	 "point; cable takes EA, rho, EI"},
	{"cable: {EA: .nan}\n", NULL,
	 "s.yaml:1:13: cable.EA: \".nan\" is not a number (NaN): give a number in N, or with "
	 "a unit that converts to N"},
	{"cable: {EA: 1e400}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"1e400\" is beyond double precision: give a number in N, "
	 "or with a unit that converts to N"},
	{"cable: {rho: 6 kg}\n", NULL,
	 "s.yaml:1:14: cable.rho: \"6 kg\" has a wrong unit \"kg\", not convertible to kg/m: "
	 "give a number in kg/m, or with a unit that converts to kg/m"},
	{"damping: {ratio: 3 m}\n", NULL,
	 "s.yaml:1:18: damping.ratio: \"3 m\" has a wrong unit \"m\", not convertible to a "
	 "pure number: give a pure number"},
	{"damping: {rayleigh: {mass: 3 Hz}}\n", NULL,
	 "s.yaml:1:28: damping.rayleigh.mass: \"3 Hz\" has a wrong unit \"Hz\", not "
	 "convertible to 1/s: give a number in 1/s, or with a unit that converts to 1/s"},
	{"model: {modes: 3 m}\n", NULL,
	 "s.yaml:1:16: model.modes: \"3 m\" has a wrong unit \"m\", not convertible to a "
	 "pure number: give a pure number"},
	/* ranges */
	{"cable: {EA: 0}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"0\" is out of range: it must be > 0 or .inf, in N"},
	{"cable: {EA: -400 MN}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"-400 MN\" is out of range: it must be > 0 or .inf, in N"},
	{"cable: {EA: -.inf}\n", NULL,
	 "s.yaml:1:13: cable.EA: \"-.inf\" is out of range: it must be > 0 or .inf, in N"},
	{"cable: {rho: -6 kg/m}\n", NULL,
	 "s.yaml:1:14: cable.rho: \"-6 kg/m\" is out of range: it must be > 0, in kg/m"},
	{"cable: {rho: .inf}\n", NULL,
	 "s.yaml:1:14: cable.rho: \".inf\" is not finite: give a number that is > 0, in kg/m"},
	{"cable: {rho: 1e-400}\n", NULL,
	 "s.yaml:1:14: cable.rho: \"1e-400\" is out of range: it must be > 0, in kg/m"},
	{"span: {d: 0 m}\n", NULL,
	 "s.yaml:1:11: span.d: \"0 m\" is out of range: it must be > 0, in m; of a "
	 "vertical rope 1e-5 of its height, or take a net"},
	{"span: {d: -250}\n", NULL,
	 "s.yaml:1:11: span.d: \"-250\" is out of range: it must be > 0, in m"},
	{"span: {h: .inf}\n", NULL,
	 "s.yaml:1:11: span.h: \".inf\" is out of range: it must be finite, in m"},
	{"g: 0\n", NULL,
	 "s.yaml:1:4: g: \"0\" is out of range: it must be > 0, in m/s^2"},
	{"tension: {T0: 0}\n", NULL,
	 "s.yaml:1:15: tension.T0: \"0\" is out of range: it must be > 0, in N"},
	{"tension: {H: -1}\n", NULL,
	 "s.yaml:1:14: tension.H: \"-1\" is out of range: it must be > 0, in N"},
	{"tension: {T1: -1}\n", NULL,
	 "s.yaml:1:15: tension.T1: \"-1\" is out of range: it must be > 0, in N"},
	{"tension: {length0: -251 m}\n", NULL,
	 "s.yaml:1:20: tension.length0: \"-251 m\" is out of range: it must be > 0, in m"},
	{"tension: {sag: 0}\n", NULL,
	 "s.yaml:1:16: tension.sag: \"0\" is out of range: it must be > 0, in m"},
	{"damping: {alpha: -0.08}\n", NULL,
	 "s.yaml:1:18: damping.alpha: \"-0.08\" is out of range: it must be >= 0, in kg/m/s"},
	{"damping: {ratio: -1 %}\n", NULL,
	 "s.yaml:1:18: damping.ratio: \"-1 %\" is out of range: it must be >= 0"},
	{"damping: {rayleigh: {mass: -1}}\n", NULL,
	 "s.yaml:1:28: damping.rayleigh.mass: \"-1\" is out of range: it must be >= 0, in 1/s"},
	{"damping: {rayleigh: {stiffness: -1 s}}\n", NULL,
	 "s.yaml:1:33: damping.rayleigh.stiffness: \"-1 s\" is out of range: it must be >= "
	 "0, in s"},
	{"load: {extent: [0, 1.5]}\n", NULL,
	 "s.yaml:1:20: load.extent[1]: \"1.5\" is out of range: it must be within [0, 1], "
	 "increasing"},
	{"load: {extent: [-0.1, 1]}\n", NULL,
	 "s.yaml:1:17: load.extent[0]: \"-0.1\" is out of range: it must be within [0, 1], "
	 "increasing"},
	{"load: {extent: [0.7, 0.3]}\n", NULL,
	 "s.yaml:1:16: load.extent: [0.7, 0.3] does not increase: give the smaller number first"},
	{"load: {extent: [0.3, 0.3]}\n", NULL,
	 "s.yaml:1:16: load.extent: [0.3, 0.3] does not increase: give the smaller number first"},
	{"model: {modes: 0}\n", NULL,
	 "s.yaml:1:16: model.modes: 0 is not a whole number from 1 to 1000"},
	{"model: {modes: -3}\n", NULL,
	 "s.yaml:1:16: model.modes: -3 is not a whole number from 1 to 1000"},
	{"model: {modes: 1e10}\n", NULL,
	 "s.yaml:1:16: model.modes: 1e+10 is not a whole number from 1 to 1000"},
	{"model: {basis: -1}\n", NULL,
	 "s.yaml:1:16: model.basis: -1 is not a whole number from 0 to 100000"},
	{"model: {tolerance: 0}\n", NULL,
	 "s.yaml:1:20: model.tolerance: \"0\" is out of range: it must be between 0 and 1"},
	{"model: {tolerance: 1}\n", NULL,
	 "s.yaml:1:20: model.tolerance: \"1\" is out of range: it must be between 0 and 1"},
	/* overrides */
	{WHOLE, "cable.EA=foo",
	 "--set cable.EA=foo: cable.EA: \"foo\" is not a number: give a number in N, or with "
	 "a unit that converts to N"},
	{WHOLE, "cable.EA",
	 "--set cable.EA: write KEY=VALUE, such as cable.EA=400 MN"},
	{WHOLE, "",
	 "--set : write KEY=VALUE, such as cable.EA=400 MN"},
	{WHOLE, "=",
	 "--set =: the scene has no place \"\" here: write names and numbers joined by dots, such as "
	 "cable.EA=400 MN"},
	{WHOLE, "=3",
	 "--set =3: the scene has no place \"\" here: write names and numbers joined by dots, such as "
	 "cable.EA=400 MN"},
	{WHOLE, "cable.Ea=4e8",
	 "--set cable.Ea=4e8: unknown key cable.Ea: did you mean EA? cable takes EA, rho, EI"},
	{WHOLE, "cable.rho=16 N/m",
	 "--set cable.rho=16 N/m: cable.rho: \"16 N/m\" is a weight per length (\"N/m\"), a force; a mass "
	 "per length is wanted: under standard gravity it belongs to \"1.6315459 kg/m\", or "
	 "\"1.0963483 lb/ft\""},
	{WHOLE, "cable.rho=0.01 kip/ft",
	 "--set cable.rho=0.01 kip/ft: cable.rho: \"0.01 kip/ft\" is a weight per length (\"kip/ft\"), a "
	 "force; a mass per length is wanted: under standard gravity it belongs to \"14.881639 kg/m\", or "
	 "\"10 lb/ft\""},
	{WHOLE, "load.static.frame=local",
	 "--set load.static.frame=local: load.static.frame: \"local\" must be global"},
	{WHOLE, "load.static.mass=-1",
	 "--set load.static.mass=-1: load.static.mass: \"-1\" is out of range: it must be >= 0, in kg/m"},
	{WHOLE, "temperature.change=-20",
	 "--set temperature.change=-20: temperature.expansion is missing: give a number in 1/K "
	 "(relative change of the unstretched length per change of temperature)"},
	{WHOLE, "temperature.change=-20 degC",
	 "--set temperature.change=-20 degC: temperature.change: \"-20 degC\" has a wrong unit \"degC\", "
	 "not convertible to K: give a number in K, or with a unit that converts to K"},
	{WHOLE, "cable.EA=# none",
	 "--set cable.EA=# none: cable.EA has no value: write cable.EA=VALUE"},
	{WHOLE, "cable.EA=-1",
	 "--set cable.EA=-1: cable.EA: \"-1\" is out of range: it must be > 0 or .inf, in N"},
	{WHOLE, "cable.EA=3 kg",
	 "--set cable.EA=3 kg: cable.EA: \"3 kg\" is a mass (\"kg\"); a force is wanted: under standard "
	 "gravity it belongs to \"29.41995 N\", or \"6.6138679 lbf\""},
	{WHOLE, "cable.EA=[1]",
	 "--set cable.EA=[1]: cable.EA is a list, but must be a number in N"},
	{WHOLE, "cable=3",
	 "--set cable=3: cable: \"3\" must be a mapping with the keys EA, rho, EI"},
	{WHOLE, "tension={H: 3, T0: 4}",
	 "--set tension={H: 3, T0: 4}: tension.T0 contradicts tension.H in the same override: give one "
	 "of H, T0, T1, length0 and sag"},
	{WHOLE, "tension={branch: slack, H: 4}",
	 "--set tension={branch: slack, H: 4}: tension.branch contradicts tension.H, which "
	 "has one equilibrium only: remove tension.branch, or give T0 or T1"},
	{WHOLE, "cable={EA: 3, EA: 4}",
	 "--set cable={EA: 3, EA: 4}: duplicate key EA, already given in the same "
	 "override: keep one"},
	{CABLE SPAN "tension: {H: 8e4}\n", "tension.branch=slack",
	 "--set tension.branch=slack: tension.branch contradicts tension.H, which has one "
	 "equilibrium only: remove tension.branch, or give T0 or T1"},
	{WHOLE, "damping.rayleigh.mass=0.1",
	 "--set damping.rayleigh.mass=0.1: damping.rayleigh.stiffness is missing: give a number in s "
	 "(factor of the stiffness matrix)"},
	{WHOLE, "load.frame=local",
	 "--set load.frame=local: load.per_length is missing: give a list of 3 numbers in N/m "
	 "(amplitude of the harmonic load per unstretched length along the three axes)"},
	{WHOLE, "temperature={change: 301, expansion: 1.2e-5}",
	 "--set temperature={change: 301, expansion: ...: temperature.change: \"301\" is out of range: "
	 "it must be within [-300, 300], in K"},
	{WHOLE, "cases=[{name: hot, temperature: {change: -400, expansion: 1.2e-5}}]",
	 "--set cases=[{name: hot, temperature: {chan...: cases[0].temperature.change: \"-400\" is out "
	 "of range: it must be within [-300, 300], in K"},
	{WHOLE, "damping.ratio=[]",
	 "--set damping.ratio=[]: damping.ratio has 0 values: give a number, or a list of 1 to 32 "
	 "numbers"},
	{WHOLE, "damping.ratio=[1 %, -1 %]",
	 "--set damping.ratio=[1 %, -1 %]: damping.ratio[1]: \"-1 %\" is out of range: it must be >= 0"},
	{WHOLE, "load.per_length=[1, 2",
	 "--set load.per_length=[1, 2: YAML syntax: did not find expected ',' or ']' while "
	 "parsing a flow sequence (line 1)"},
	{WHOLE, "load.per_length=[1, 2]",
	 "--set load.per_length=[1, 2]: load.per_length has 2 values, but must be a list of 3 numbers "
	 "in N/m (amplitude of the harmonic load per unstretched length along the three axes)"},
	{WHOLE, "cable.EA=&x 3",
	 "--set cable.EA=&x 3: a scene has no anchors: remove &x"},
	{WHOLE, "cable.EA=3\n---\n4",
	 "--set cable.EA=3?---?4: a second document begins here: a scene is one document, so "
	 "remove what follows"},
	{WHOLE, "model.modes=0",
	 "--set model.modes=0: model.modes: 0 is not a whole number from 1 to 1000"},
	{WHOLE, LONG LONG LONG "=3",
	 "--set xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...: write KEY=VALUE, such as cable.EA=400 MN"},
	{WHOLE, "cable.EA=\377",
	 "--set cable.EA=\377: not a text in UTF-8: invalid leading UTF-8 octet at byte 1"},
};

static void refused(const char *text, const char *set, const char *message)
{
	struct hawser_scene scene;
	struct hawser_report report = {.message = ""};
	static const struct hawser_scene zero;

	memset(&scene, 0x55, sizeof scene);
	ok(read_text(&scene, text, set, &report) == HAWSER_ERR_SCENE &&
	   report.status == HAWSER_ERR_SCENE, "refused: %.60s", message);
	if (!ok(!strcmp(report.message, message), "with its message"))
		printf("# got  %s\n# want %s\n", report.message, message);
	ok(!memcmp(&scene, &zero, sizeof scene), "and nothing left in the scene");
	ok(read_text(&scene, text, set, NULL) == HAWSER_ERR_SCENE, "without a report too");
}

/* 1 MiB of brackets, of nested aliases, or of a single line: refused without delay. */
static void hostile(void)
{
	enum { N = 1000000 };
	static const char *const units[] = {"[", "{", "? ", "- ", "{a: ", "a: [", "!", "&", "\"", "#", "\n",
	                                    "%", "a", "a:\n ", "*a ", "'", "|", "---\n", ","};
	char *text = malloc(N + 1);

	for (size_t i = 0; i < sizeof units/sizeof *units; i++) {
		struct hawser_scene scene;
		struct hawser_report report = {.message = ""};
		size_t length = strlen(units[i]);

		for (size_t at = 0; at < N; at++)
			text[at] = units[i][at%length];
		text[N] = '\0';
		ok(read_text(&scene, text, NULL, &report) == HAWSER_ERR_SCENE, "a megabyte of \"%c\": %s",
		   units[i][0] == '\n' || units[i][0] == '#' ? ' ' : units[i][0], report.message);
	}
	free(text);
}

CASE(unit_scene_errors)
{
	for (size_t i = 0; i < sizeof table/sizeof *table; i++)
		refused(table[i].text, table[i].set, table[i].message);
	hostile();
	return done_testing();
}
