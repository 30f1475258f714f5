/* cli/tools/init_scenes.c - the scenes that hawser init writes. A test runs the first command of each.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/tools/init_scenes.h"

const char cli_init_cable[] =
	"# A span of cable. Try: hawser statics SCENE, hawser modes SCENE, hawser frf SCENE\n"
	"# Plain numbers are in SI units; others are written with theirs. Every key: man hawser-scene.\n"
	"cable:\n"
	"  EA: 400 MN            # axial stiffness\n"
	"  rho: 6 kg/m           # mass per unstretched length\n"
	"span:\n"
	"  d: 250 m              # horizontal distance of the ends\n"
	"  h: 10 m               # height of end B above end A\n"
	"tension:\n"
	"  T0: 80 kN             # at end A; or one of H, T1, length0, sag\n"
	"damping:\n"
	"  alpha: 0.08 kg/m/s    # force per length and velocity; or rayleigh, or ratio\n"
	"load:                   # times cos(Omega t), for hawser frf and integrate\n"
	"  frame: global         # axes x, y (upwards), z; or local\n"
	"  per_length: [0, 0.8 N/m, 0.8 N/m]\n"
	"  extent: [25 %, 75 %]  # loaded part of the cable\n"
	"model:\n"
	"  modes: 5              # kept in the reduced model; or auto\n";

const char cli_init_travelling[] =
	"# A cable that travels along itself. Try: hawser campbell SCENE, hawser modes SCENE\n"
	"cable:\n"
	"  EA: 40 MN             # axial stiffness\n"
	"  rho: 4 kg/m           # mass per unstretched length\n"
	"span:\n"
	"  d: 180 m              # horizontal distance of the ends\n"
	"  h: 35 m               # height of end B above end A\n"
	"tension:\n"
	"  T0: 85 kN             # at end A, at rest\n"
	"travel:\n"
	"  speed: 5 m/s          # from A to B\n"
	"  hold: tension         # keeps its value as the cable travels; or length\n"
	"damping:\n"
	"  alpha: 0.05 kg/m/s    # force per length and velocity\n";

const char cli_init_beam[] =
	"# A beam or string that travels between two supports. Try: hawser beam SCENE\n"
	"beam:\n"
	"  EI: 12 N.m^2          # bending stiffness; 0: a string\n"
	"  rhoA: 0.9 kg/m        # mass per length\n"
	"  L: 3.2 m              # distance of the supports\n"
	"  tension_end: 450 N    # at the outlet\n"
	"  gravity: along        # it travels upwards; across: horizontally; none\n"
	"  speed: 6 m/s\n";

const char cli_init_net[] =
	"# Cables between nodes. Try: hawser statics SCENE, hawser modes SCENE\n"
	"# --set takes names: --set cables.left.length0=\"151 m\"\n"
	"kind: net\n"
	"nodes:\n"
	"  A: [0 m, 0 m, 0 m]    # x, y (upwards), z\n"
	"  B: [300 m, 15 m, 0 m]\n"
	"  J: {}                 # its position is to be found\n"
	"cables:\n"
	"  - {name: left, from: A, to: J, EA: 100 MN, rho: 5.56 kg/m, length0: 150.2 m}\n"
	"  - {name: right, from: J, to: B, EA: 100 MN, rho: 5.56 kg/m, length0: 150.9 m}\n"
	"supports: {A: fixed, B: fixed}\n"
	"masses: {J: 12 kg}\n"
	"loads: {J: [0 N, -8 kN, 0 N]}\n";

const char cli_init_obstacles[] =
	"# A span over sheaves or other circles. Try: hawser statics SCENE\n"
	"cable: {EA: 40 MN, rho: 4 kg/m}\n"
	"span: {d: 300 m, h: 20 m}    # end B from end A\n"
	"tension: {T0: 60 kN}         # at end A; or T1, length0\n"
	"obstacles:                   # in the order of x\n"
	"  - {name: tower, circle: {centre: [150 m, 8 m], radius: 6 m}, side: above, friction: 0.03}\n"
	"contact: {sliding: none}     # or toward-A, toward-B\n";

const char cli_init_ropeway[] =
	"# The hauling rope of a ropeway. Try: hawser statics SCENE, hawser modes SCENE\n"
	"ropeway:\n"
	"  rope: {EA: 40 MN, rho: 4 kg/m}\n"
	"  bottom:\n"
	"    at: [0 m, 0 m]           # where the rope leaves the bullwheel\n"
	"    radius: 2.5 m\n"
	"    tension: {counterweight: 168 kN}  # of both lanes; or T0, length0, T_empty\n"
	"  top:\n"
	"    at: [300 m, 58 m]\n"
	"    radius: 2.5 m\n"
	"    drive: {speed: 4 m/s, friction: 0.2}\n"
	"  towers:                    # the summit of each battery\n"
	"    - {at: [80 m, 17 m], battery: support, radius: 12 m, friction: 0.03}\n"
	"    - {at: [190 m, 40 m], battery: support, radius: 12 m, friction: 0.03}\n"
	"  carriers: {spacing: 36.6 m, mass: {up: 400 kg, down: 250 kg}}\n";

const char cli_init_rod[] =
	"# A rod that bends, twists, shears and stretches by any amount. Try: hawser statics SCENE\n"
	"kind: rod\n"
	"rod:\n"
	"  length: 10 m\n"
	"  EA: 2 MN                   # axial stiffness\n"
	"  GA: 0.7 MN                 # shear stiffness\n"
	"  EI: 40 N.m^2               # bending stiffness; [e2, e3] if they differ\n"
	"  GJ: 30 N.m^2               # torsional stiffness\n"
	"  rho: 2 kg/m\n"
	"start: {at: [0 m, 0 m, 0 m], tangent: [1, 0.2, 0], hold: clamped}\n"
	"loads:\n"
	"  - {at: end, force: [0 N, -20 N, 5 N]}\n";

const char cli_init_tow[] =
	"# A body towed by a helicopter. Try: hawser tow steady SCENE, hawser trajectory SCENE\n"
	"tow:\n"
	"  speed: 27.8 m/s            # along x; or orbit, waypoints, file\n"
	"cable:\n"
	"  segments:                  # from the towing point on\n"
	"    - {length: 14 m, rho: 58 g/m, diameter: 8 mm, drag: {normal: 1.2}}\n"
	"air: {density: 1.2 kg/m^3, wind: [-5 m/s, 0, 0]}\n"
	"body:\n"
	"  ring: {radius: 11 m, tube: 7 cm, mass: 435 kg, offset: 16 m, drag: {normal: 1.2}}\n";
