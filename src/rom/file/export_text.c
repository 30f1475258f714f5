/* rom/file/export_text.c - see export_text.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "rom/file/export_text.h"

/* --- MATLAB: loops over the rows, for states x [2n x m] and waves W [1 + NH x m] --- */

#define MATLAB_SUMS \
	"function y = total(x, W)\n" \
	"[n, ~, T] = model();\n" \
	"y = zeros(2*n, size(x, 2));\n" \
	"y(1:n, :) = x(n+1:2*n, :);\n" \
	"for r = 1:size(T, 1)\n" \
	"    z = T(r, 3)*W(T(r, 2) + 1, :);\n" \
	"    for i = T(r, 4:end)\n" \
	"        if i > 0\n" \
	"            z = z.*x(i, :);\n" \
	"        end\n" \
	"    end\n" \
	"    y(n + T(r, 1), :) = y(n + T(r, 1), :) + z;\n" \
	"end\n" \
	"end\n\n" \
	"% The same without the first n rows and without terms of no wave: W is a derivative of waves.\n" \
	"function y = changed(x, W)\n" \
	"n = model();\n" \
	"W(1, :) = 0;\n" \
	"y = total(x, W);\n" \
	"y(1:n, :) = 0;\n" \
	"end\n\n" \
	"function J = slopes(x, W)\n" \
	"[n, ~, T] = model();\n" \
	"J = zeros(2*n, 2*n, size(x, 2));\n" \
	"for j = 1:n\n" \
	"    J(j, n + j, :) = 1;\n" \
	"end\n" \
	"for r = 1:size(T, 1)\n" \
	"    f = T(r, 4:end);\n" \
	"    f = f(f > 0);\n" \
	"    for d = 1:numel(f)\n" \
	"        z = T(r, 3)*W(T(r, 2) + 1, :);\n" \
	"        for i = f([1:d-1, d+1:end])\n" \
	"            z = z.*x(i, :);\n" \
	"        end\n" \
	"        j = n + T(r, 1);\n" \
	"        J(j, f(d), :) = J(j, f(d), :) + reshape(z, 1, 1, []);\n" \
	"    end\n" \
	"end\n" \
	"end\n\n"

/* --- COCO --- */

static const char coco_begin[] =
	"function F = $()\n";
static const char coco_middle[] =
	"%\n"
	"%   F = $();\n"
	"%   prob = coco_set(coco_prob(), 'ode', 'autonomous', false);\n"
	"%   prob = ode_isol2po(prob, '', F.f, F.dfdx, F.dfdp, F.dfdt, t0, x0, {'Omega' 'load'}, p0);\n"
	"%\n"
	"% and the period is to be kept at 2*pi/Omega: add a function of the problem for T*Omega - 2*pi.\n"
	"% x: coordinates, then velocities; p: Omega (scaled) and the factor of the load, 1 for this.\n"
	"% All are vectorised: t [1 x m], x [2n x m], p [2 x m].\n"
	"F.n = model();\n"
	"F.f = @(t, x, p) total(x, waves(t, p, 0));\n"
	"F.dfdx = @(t, x, p) slopes(x, waves(t, p, 0));\n"
	"F.dfdp = @by_parameters;\n"
	"F.dfdt = @(t, x, p) changed(x, waves(t, p, 3));\n"
	"end\n\n"
	"function J = by_parameters(t, x, p)\n"
	"J = zeros(size(x, 1), 2, size(x, 2));\n"
	"J(:, 1, :) = reshape(changed(x, waves(t, p, 1)), size(x, 1), 1, []);\n"
	"J(:, 2, :) = reshape(changed(x, waves(t, p, 2)), size(x, 1), 1, []);\n"
	"end\n\n"
	"% 1, then the waves; their derivatives by Omega (1), the load (2) or t (3).\n"
	"function W = waves(t, p, by)\n"
	"[~, H] = model();\n"
	"W = ones(1 + size(H, 1), numel(t));\n"
	"for h = 1:size(H, 1)\n"
	"    k = H(h, 1); a = H(h, 3); b = H(h, 4);\n"
	"    w = cos(k*p(1, :).*t); d = -sin(k*p(1, :).*t);\n"
	"    if H(h, 2)\n"
	"        w = sin(k*p(1, :).*t); d = cos(k*p(1, :).*t);\n"
	"    end\n"
	"    A = p(1, :).^a; B = p(2, :).^b;\n"
	"    if by == 0\n"
	"        W(h + 1, :) = A.*B.*w;\n"
	"    elseif by == 1\n"
	"        W(h + 1, :) = B.*(a*p(1, :).^max(a - 1, 0).*w + A.*d*k.*t);\n"
	"    elseif by == 2\n"
	"        W(h + 1, :) = b*p(2, :).^(b - 1).*A.*w;\n"
	"    else\n"
	"        W(h + 1, :) = A.*B.*d*k.*p(1, :);\n"
	"    end\n"
	"end\n"
	"end\n\n"
	MATLAB_SUMS;

/* --- MATCONT --- */

static const char matcont_begin[] =
	"function out = $\n";
static const char matcont_middle[] =
	"% A system file of MATCONT. The last two states are sin and cos of the phase: an oscillator on\n"
	"% the attracting circle, since MATCONT takes autonomous systems. Parameters: Omega (scaled) and\n"
	"% the factor of the load, 1 for the model.\n"
	"out{1} = @init;\n"
	"out{2} = @fun_eval;\n"
	"out{3} = @jacobian;\n"
	"out{4} = @jacobianp;\n"
	"out{5} = [];\n"
	"out{6} = [];\n"
	"out{7} = [];\n"
	"out{8} = [];\n"
	"out{9} = [];\n"
	"end\n\n"
	"function dydt = fun_eval(t, kmrgd, par_Omega, par_load)\n"
	"n = model();\n"
	"s = kmrgd(2*n + 1); c = kmrgd(2*n + 2); q = s*s + c*c;\n"
	"dydt = [total(kmrgd(1:2*n), waves(s, c, par_Omega, par_load, 0))\n"
	"        s + par_Omega*c - s*q\n"
	"        c - par_Omega*s - c*q];\n"
	"end\n\n"
	"function [tspan, y0, options] = init\n"
	"handles = feval(@$);\n"
	"n = model();\n"
	"y0 = [zeros(2*n, 1); 0; 1];\n"
	"options = odeset('Jacobian', handles(3), 'JacobianP', handles(4));\n"
	"tspan = [0 10];\n"
	"end\n\n"
	"function jac = jacobian(t, kmrgd, par_Omega, par_load)\n"
	"n = model();\n"
	"x = kmrgd(1:2*n); s = kmrgd(2*n + 1); c = kmrgd(2*n + 2);\n"
	"jac = zeros(2*n + 2);\n"
	"jac(1:2*n, 1:2*n) = slopes(x, waves(s, c, par_Omega, par_load, 0));\n"
	"jac(1:2*n, 2*n + 1) = changed(x, waves(s, c, par_Omega, par_load, 3));\n"
	"jac(1:2*n, 2*n + 2) = changed(x, waves(s, c, par_Omega, par_load, 4));\n"
	"jac(2*n + 1, 2*n + 1:end) = [1 - 3*s*s - c*c, par_Omega - 2*s*c];\n"
	"jac(2*n + 2, 2*n + 1:end) = [-par_Omega - 2*s*c, 1 - s*s - 3*c*c];\n"
	"end\n\n"
	"function jacp = jacobianp(t, kmrgd, par_Omega, par_load)\n"
	"n = model();\n"
	"x = kmrgd(1:2*n); s = kmrgd(2*n + 1); c = kmrgd(2*n + 2);\n"
	"V = waves(s, c, par_Omega, par_load, 1);\n"
	"W = waves(s, c, par_Omega, par_load, 2);\n"
	"jacp = [changed(x, V), changed(x, W)\n"
	"        c, 0\n"
	"        -s, 0];\n"
	"end\n\n"
	"% 1, then the waves, parts of (c + i s)^k; derivatives by Omega (1), load (2), s (3), c (4).\n"
	"function W = waves(s, c, Omega, load, by)\n"
	"[~, H] = model();\n"
	"W = ones(1 + size(H, 1), 1);\n"
	"for h = 1:size(H, 1)\n"
	"    k = H(h, 1); a = H(h, 3); b = H(h, 4);\n"
	"    w = (c + 1i*s)^k; A = Omega^a; B = load^b;\n"
	"    if by == 1\n"
	"        A = a*Omega^max(a - 1, 0);\n"
	"    elseif by == 2\n"
	"        B = b*load^(b - 1);\n"
	"    elseif by > 2\n"
	"        w = k*(c + 1i*s)^max(k - 1, 0);\n"
	"        if by == 3\n"
	"            w = 1i*w;\n"
	"        end\n"
	"    end\n"
	"    if H(h, 2)\n"
	"        W(h + 1) = A*B*imag(w);\n"
	"    else\n"
	"        W(h + 1) = A*B*real(w);\n"
	"    end\n"
	"end\n"
	"end\n\n"
	MATLAB_SUMS;

/* --- BifurcationKit --- */

static const char julia_begin[] =
	"#\n"
	"#   include(\"$.jl\")\n"
	"#   par = (Omega = 1.0, load = 1.0)\n"
	"#   prob = BifurcationProblem($.F, $.start, par, (@optic _.Omega); J = $.J)\n"
	"#\n"
	"# The last two states are sin and cos of the phase: an oscillator on the attracting circle,\n"
	"# since BifurcationKit takes autonomous systems. Omega is scaled; load is the factor of the\n"
	"# load, 1 for the model.\n"
	"module $\n\n";
static const char julia_middle[] = "";
static const char julia_end[] =
	"const start = [zeros(2n); 0.0; 1.0]\n\n"
	"# 1, then the waves, parts of (c + i s)^k; their derivatives by s (1) and c (2).\n"
	"function waves(s, c, p, by = 0)\n"
	"    W = [one(s*p.Omega*p.load)]\n"
	"    for (k, sine, a, b) in harmonics\n"
	"        w = by == 0 ? complex(c, s)^k : k*complex(c, s)^max(k - 1, 0)*(by == 1 ? im : 1)\n"
	"        push!(W, p.Omega^a*p.load^b*(sine == 1 ? imag(w) : real(w)))\n"
	"    end\n"
	"    by == 0 || (W[1] = 0)\n"
	"    return W\n"
	"end\n\n"
	"function add!(f, x, W)\n"
	"    for (j, h, value, factors) in rows\n"
	"        f[n + j] += value*W[h + 1]*prod((x[i] for i in factors); init = one(eltype(x)))\n"
	"    end\n"
	"    return f\n"
	"end\n\n"
	"function F(x, p)\n"
	"    s, c = x[2n + 1], x[2n + 2]\n"
	"    q = s^2 + c^2\n"
	"    W = waves(s, c, p)\n"
	"    f = zeros(promote_type(eltype(x), eltype(W)), 2n + 2)\n"
	"    f[1:n] .= x[n + 1:2n]\n"
	"    add!(f, x, W)\n"
	"    f[2n + 1] = s + p.Omega*c - s*q\n"
	"    f[2n + 2] = c - p.Omega*s - c*q\n"
	"    return f\n"
	"end\n\n"
	"function J(x, p)\n"
	"    s, c = x[2n + 1], x[2n + 2]\n"
	"    W = waves(s, c, p)\n"
	"    A = zeros(promote_type(eltype(x), eltype(W)), 2n + 2, 2n + 2)\n"
	"    for j in 1:n\n"
	"        A[j, n + j] = 1\n"
	"    end\n"
	"    for (j, h, value, factors) in rows, d in eachindex(factors)\n"
	"        others = (x[factors[i]] for i in eachindex(factors) if i != d)\n"
	"        A[n + j, factors[d]] += value*W[h + 1]*prod(others; init = one(eltype(x)))\n"
	"    end\n"
	"    A[:, 2n + 1] .= add!(zero(A[:, 1]), x, waves(s, c, p, 1))\n"
	"    A[:, 2n + 2] .= add!(zero(A[:, 1]), x, waves(s, c, p, 2))\n"
	"    A[2n + 1, 2n + 1:2n + 2] .= (1 - 3s^2 - c^2, p.Omega - 2s*c)\n"
	"    A[2n + 2, 2n + 1:2n + 2] .= (-p.Omega - 2s*c, 1 - s^2 - 3c^2)\n"
	"    return A\n"
	"end\n\n"
	"end\n";

const char *const hawser__export_text[3][3] = {
	{coco_begin, coco_middle, ""},
	{matcont_begin, matcont_middle, ""},
	{julia_begin, julia_middle, julia_end},
};
