#!/bin/sh
# Equations for COCO, MATCONT and BifurcationKit, at random states against those of the model: the MATLAB files by
# Octave, which differentiates them by differences too; that for Julia by its table of rows, read back in Python.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/../checks/lib.sh"
values=$here/tests/reference/rom-export-values
cd "$scratch" || exit 1

cat >own.json <<'JSON'
{"n": 3, "K": [[1, 0.2, 0], [0.1, 2, 0], [0, 0, 5]], "D": [[0.05, 1, 0], [-1, 0.04, 0], [0, 0, 0.1]],
 "Q": [[0, 0, 1, 0.3], [2, 1, 1, -0.7]], "C": [[0, 0, 0, 0, 1.1], [1, 0, 1, 2, 0.4]],
 "terms": [[0, [], [0, 0, 0], 0.13], [1, [0, 0], [1], 2], [2, [2, 2, 2, 2, 2], [], 0.01]],
 "harmonics": [{"k": 1, "f": [1, 0, 0.3], "omega_power": 1},
  {"k": 3, "phase": "sin", "f": [0, 2, 0], "load_power": 2, "omega_power": 2, "K": [[0, 0, 0.2], [0, 0, 0], [0.1, 0, 0]]},
  {"k": 2, "D": [[0, 0, 0], [0, 0.3, 0], [0, 0, 0]], "Q": [[0, 0, 2, 0.5]]}, {"k": 0, "f": [0, 0, 0.7], "load_power": 3},
  {"k": 1, "phase": "sin", "omega_power": 1, "C": [[1, 0, 0, 1, 0.4]], "terms": [[2, [1], [0], 0.6]]}]}
JSON
for name in duffing-nlvib-01 pair-2to1; do
	cp "$SRCDIR/tests/reference/$name.json" "$(echo $name | tr -d -).json"
done
models="own duffingnlvib01 pair2to1"
for model in $models; do
	try "$model: written" "$values" $model.json $model
done

cat >check.m <<'OCTAVE'
function check(name)
A = dlmread([name '.txt']);
n = A(1, 1);
F = feval([name '_coco']);
M = feval([name '_matcont']);
worst = 0; rough = 0; h = 1e-3;
for r = 2:size(A, 1)
    row = A(r, :);
    t = row(1); w = row(2); x = row(3:2 + 2*n)'; row = row(3 + 2*n:end);
    a = row(1:n)'; row = row(n + 1:end);
    J = [zeros(n) eye(n); reshape(row(1:n*n), n, n)' reshape(row(n*n + 1:2*n*n), n, n)'];
    byw = row(2*n*n + 1:2*n*n + n)';
    p = [w; 1];
    f = [x(n + 1:end); a];
    z = [x; sin(w*t); cos(w*t)];
    worst = max([worst; abs(F.f(t, x, p) - f); abs(F.dfdx(t, x, p) - J)(:)]);
    g = M{2}(0, z, w, 1);
    G = M{3}(0, z, w, 1);
    P = M{4}(0, z, w, 1);
    worst = max([worst; abs(g(1:2*n) - f); abs(G(1:2*n, 1:2*n) - J)(:); abs(P(n + 1:2*n, 1) - byw)]);
    worst = max([worst; abs(g(2*n + 1:end) - w*[z(end); -z(end - 1)])]);
    p = [w; 1.3];
    dp = F.dfdp(t, x, p);
    G = M{3}(0, z, w, 1.3); P = M{4}(0, z, w, 1.3);
    rough = max([rough; abs(slope(@(e) F.f(t, x, p + [e; 0]), h) - dp(:, 1))
                 abs(slope(@(e) F.f(t, x, p + [0; e]), h) - dp(:, 2))
                 abs(slope(@(e) F.f(t + e, x, p), h) - F.dfdt(t, x, p))
                 abs(slope(@(e) M{2}(0, z, w, 1.3 + e), h) - P(:, 2))
                 abs(slope(@(e) M{2}(0, z, w + e, 1.3), h) - P(:, 1))]);
    for i = 1:2*n + 2
        along = (1:2*n + 2)' == i;
        rough = max([rough; abs(slope(@(e) M{2}(0, z + e*along, w, 1.3), h) - G(:, i))]);
    end
    both = F.f([t t], [x 2*x], [p p]) - [F.f(t, x, p) F.f(t, 2*x, p)];
    many = F.dfdx([t t], [x 2*x], [p p]);
    worst = max([worst; abs(both(:)); abs(many(:, :, 2) - F.dfdx(t, 2*x, p))(:)]);
end
printf('%.1e %.1e\n', worst, rough);
if !(worst < 2e-14 && rough < 1e-8)
    exit(1);
end
end

% of fourth order
function d = slope(f, h)
d = (8*(f(h) - f(-h)) - f(2*h) + f(-2*h))/(12*h);
end
OCTAVE
if command -v octave-cli >/dev/null; then
	for model in $models; do
		try "$model: COCO's and MATCONT's equations by Octave" \
			octave-cli --no-init-file --eval "check('$model')"
	done
else
	skip "octave-cli is not installed"
fi

cat >check.py <<'PYTHON'
import math, re, sys
name = sys.argv[1]
text = open(name + "_julia.jl").read()
n = int(re.search(r"const n = (\d+)", text)[1])
def table(start):
    return eval("[" + text.split(start, 1)[1].split("]\n", 1)[0] + "]")
harmonics, rows = table("NTuple{4,Int}["), table("Vector{Int}}[")
assert text.count("module " + name + "_julia") == 1 and "J = " + name + "_julia.J" in text
lines = [[float(x) for x in line.split()] for line in open(name + ".txt")]
assert lines[0] == [n]
worst = 0.0
for line in lines[1:]:
    t, w, x, given = line[0], line[1], line[2:2 + 2*n], line[2 + 2*n:]
    wave = [1.0] + [w**a*(math.sin if sine else math.cos)(k*w*t) for k, sine, a, b in harmonics]
    f, J = [0.0]*n, [[0.0]*(2*n) for _ in range(n)]
    for j, h, value, factors in rows:
        f[j - 1] += value*wave[h]*math.prod(x[i - 1] for i in factors)
        for d, i in enumerate(factors):
            J[j - 1][i - 1] += value*wave[h]*math.prod(x[m - 1] for e, m in enumerate(factors) if e != d)
    for j in range(n):
        worst = max(worst, abs(f[j] - given[j]))
        for k in range(2*n):
            i = n + (j*n + k if k < n else n*n + j*n + k - n)
            worst = max(worst, abs(J[j][k] - given[i]))
print(f"{worst:.1e}")
sys.exit(worst > 2e-14)
PYTHON
if python3 -c '' 2>/dev/null; then
	for model in $models; do
		try "$model: BifurcationKit's rows" python3 check.py $model
	done
else
	skip "python3 is not there"
fi
if command -v julia >/dev/null; then
	try "own: Julia reads it" julia -e 'include("own_julia.jl"); own_julia.F(own_julia.start, (Omega = 1.0, load = 1.0))'
else
	skip "julia is not installed"
fi
done_testing
