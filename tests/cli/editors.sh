#!/bin/sh
# hawser init, check, schema and completion: what they write is taken by the program, by a validator of
# schemas and by the shells.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# init: every kind runs through its first command, and check knows it
while read -r kind command; do
	run init "$kind"
	cp "$scratch/out" "$kind.yaml"
	# shellcheck disable=SC2086 # words
	works "init $kind: $command" $command "$kind.yaml" --quiet
	works "check of $kind" check "$kind.yaml"
	try "it names its commands" grep -q "^commands that take it: .*$command" "$scratch/out"
done <<END
cable statics
travelling statics
beam beam
net statics
obstacles statics
ropeway statics
rod statics
tow tow steady
stay modes
conductor statics
chairlift statics
footbridge modes
mooring statics
END
refuses_like 1 'init nets: must be one of .cable.travelling.*' init nets
refuses_like 1 '.*unknown key weights: .*' check net.yaml --set 'weights={J: 1 kg}'
refuses_like 2 '.*' check cable.yaml --set tension.T0=3kN

# schema
works "schema of all kinds" schema
cp "$scratch/out" all.json
works "schema of nets" schema net
cp "$scratch/out" net.json
refuses_like 1 'schema mesh: must be one of .cable.beam.*' schema mesh
python "the schema of nets has the keys of cables, and their unit" <<'END'
import json
net = json.load(open("net.json"))
cable = net["properties"]["cables"]["items"]
assert cable["additionalProperties"] is False and set(cable["required"]) == {"from", "to", "EA", "rho"}
assert cable["properties"]["EA"]["anyOf"][0]["description"] == "axial stiffness [N, > 0]"
assert {"required": ["sag"]} in cable["oneOf"]
END
works "schema of rods" schema rod
cp "$scratch/out" rod.json
python "the path of an end is a file's name" <<'END'
import json
rod = json.load(open("rod.json"))
assert all(rod["properties"][end]["properties"]["path"]["type"] == "string" for end in ("start", "end"))
END
# spans that are meshes have the keys of nets, and are valid below
cat >span-in-water.yaml <<'END'
cable: {EA: 20 MN, rho: 12 kg/m, diameter: 0.12 m, drag: {normal: 1.2, tangential: 0.02}}
span: {d: 200 m, h: 200 m}
tension: {length0: 300 m}
water: {density: 1025 kg/m^3, surface: 200 m, current: [0.8 m/s, 0, 0.6 m/s]}
dynamics: {step: 0.1}
END
cat >span-over-bed.yaml <<'END'
cable: {EA: 20 MN, rho: 12 kg/m, elements: 40}
span: {d: 200 m, h: 0}
tension: {length0: 205 m}
obstacles: [{name: bed, profile: [[-10, -20], [100, -15], [300, -20]], friction: 0.3, rounding: 3}]
contact: {restitution: 0.2}
damping: {alpha: 0.1}
END
works "a span in water" check span-in-water.yaml
works "a span over a profile" check span-over-bed.yaml
works "schema of spans over obstacles" schema obstacles
cp "$scratch/out" obstacles.json
python "a span over a bed has its profile, and damping" <<'END'
import json
mesh = json.load(open("obstacles.json"))["then"]["properties"]
assert {"profile", "grid", "rounding"} <= set(mesh["obstacles"]["items"]["properties"])
assert {"alpha"} <= set(mesh["damping"]["properties"]) and "density" in mesh["water"]["properties"]
END
# the validator takes a second to start
if [ -n "${HAWSER_LONG-}" ] && python3 -c 'import jsonschema, yaml' 2>/dev/null; then
	cat >validate.py <<'END'
import copy, glob, json, sys, jsonschema, yaml
schema = json.load(open("all.json"))
jsonschema.Draft7Validator.check_schema(schema)
check = jsonschema.Draft7Validator(schema)
scenes = glob.glob(sys.argv[1] + "/notebooks-data/scenes/*.yaml") + glob.glob("*.yaml")
assert len(scenes) > 70
for name in sorted(scenes):
    scene = yaml.safe_load(open(name))
    errors = list(check.iter_errors(scene))
    if errors:
        print(name, errors[0].message)
    # a key that is misspelt anywhere, but for names of the user
    def misspell(part, path):
        for key in list(part) if isinstance(part, dict) else range(len(part)) if isinstance(part, list) else []:
            user = path[-1:] in (["nodes"], ["supports"], ["masses"], ["buoys"]) or "nodes" in scene and path in (["loads"], ["contact", "path"])
            if isinstance(part, dict) and not user:
                part[key + "x"] = part.pop(key)
                if check.is_valid(scene):
                    print(name, "accepts", path, key + "x")
                part[key] = part.pop(key + "x")
            if key != "kind":
                misspell(part[key], path + [key])
    misspell(scene, [])
for text in ("cable: {EA: 1 MN, rho: 1}\nspan: {d: 1, h: 0}\ntension: {T0: 1, H: 1}",
             "cable: {EA: -1, rho: 1}\nspan: {d: 1, h: 0}\ntension: {T0: 1}",
             "cable: {EA: -1 MN, rho: 1}\nspan: {d: 1, h: 0}\ntension: {T0: 1}",
             "cable: {rho: 1}\nspan: {d: 1, h: 0}\ntension: {T0: 1}",
             "kind: net\nnodes: {A: [0, 0]}\ncables: []\nsupports: {}",
             "beam: {mu: 1, theta: 1, rho: 0}"):
    if check.is_valid(yaml.safe_load(text)):
        print("accepted:", text)
END
	python3 validate.py "$SRCDIR" 2>&1 | nothing "scenes of this tree are valid, misspelt keys are not"
else
	skip "scenes against the schema: HAWSER_LONG is not set, or python3-jsonschema, python3-yaml are missing"
fi

# completion
for shell in bash zsh fish; do
	works "completion $shell" completion $shell
	cp "$scratch/out" completion.$shell
	if command -v $shell >/dev/null; then
		try "$shell reads it" $shell -n completion.$shell
	fi
done
refuses_like 1 'completion tcsh: must be one of bash.*' completion tcsh
if command -v bash >/dev/null; then
	cat >complete.bash <<'END'
. ./completion.bash
try() { COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _hawser; echo "$*: ${COMPREPLY[*]}"; }
try hawser sta
try hawser compare mod
try hawser tow steady --ti
try hawser init ro
try hawser frf net.y
try hawser statics --json cab
try hawser statics --set cable.E
try hawser statics --set ropeway.towers.0.fr
END
	bash complete.bash >got
	cat >want <<'END'
hawser sta: statics
hawser compare mod: modes
hawser tow steady --ti: --title
hawser init ro: ropeway rod
hawser frf net.y: net.yaml
hawser statics --json cab: cable.yaml
hawser statics --set cable.E: cable.EA= cable.EI= cable.EA= cable.EA=
hawser statics --set ropeway.towers.0.fr: ropeway.towers.0.friction=
END
	try "bash completes commands, options and files" diff want got
fi
done_testing
