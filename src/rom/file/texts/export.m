% What is the same in all models that are exported to COCO and MATCONT. Lines of %@ begin the parts that export.c
% writes, with the name of the model for $; this heading is not written.
% SPDX-License-Identifier: GPL-3.0-or-later
%@ coco_begin
function F = $()
%@ coco_middle
%
%   F = $();
%   prob = coco_set(coco_prob(), 'ode', 'autonomous', false);
%   prob = ode_isol2po(prob, '', F.f, F.dfdx, F.dfdp, F.dfdt, t0, x0, {'Omega' 'load'}, p0);
%
% and the period is to be kept at 2*pi/Omega: add a function of the problem for T*Omega - 2*pi.
% x: coordinates, then velocities; p: Omega (scaled) and the factor of the load, 1 for this.
% All are vectorised: t [1 x m], x [2n x m], p [2 x m].
F.n = model();
F.f = @(t, x, p) total(x, waves(t, p, 0));
F.dfdx = @(t, x, p) slopes(x, waves(t, p, 0));
F.dfdp = @by_parameters;
F.dfdt = @(t, x, p) changed(x, waves(t, p, 3));
end

function J = by_parameters(t, x, p)
J = zeros(size(x, 1), 2, size(x, 2));
J(:, 1, :) = reshape(changed(x, waves(t, p, 1)), size(x, 1), 1, []);
J(:, 2, :) = reshape(changed(x, waves(t, p, 2)), size(x, 1), 1, []);
end

% 1, then the waves; their derivatives by Omega (1), the load (2) or t (3).
function W = waves(t, p, by)
[~, H] = model();
W = ones(1 + size(H, 1), numel(t));
for h = 1:size(H, 1)
    k = H(h, 1); a = H(h, 3); b = H(h, 4);
    w = cos(k*p(1, :).*t); d = -sin(k*p(1, :).*t);
    if H(h, 2)
        w = sin(k*p(1, :).*t); d = cos(k*p(1, :).*t);
    end
    A = p(1, :).^a; B = p(2, :).^b;
    if by == 0
        W(h + 1, :) = A.*B.*w;
    elseif by == 1
        W(h + 1, :) = B.*(a*p(1, :).^max(a - 1, 0).*w + A.*d*k.*t);
    elseif by == 2
        W(h + 1, :) = b*p(2, :).^(b - 1).*A.*w;
    else
        W(h + 1, :) = A.*B.*d*k.*p(1, :);
    end
end
end

%@ matcont_begin
function out = $
%@ matcont_middle
% A system file of MATCONT. The last two states are sin and cos of the phase: an oscillator on
% the attracting circle, since MATCONT takes autonomous systems. Parameters: Omega (scaled) and
% the factor of the load, 1 for the model.
out{1} = @init;
out{2} = @fun_eval;
out{3} = @jacobian;
out{4} = @jacobianp;
out{5} = [];
out{6} = [];
out{7} = [];
out{8} = [];
out{9} = [];
end

function dydt = fun_eval(t, kmrgd, par_Omega, par_load)
n = model();
s = kmrgd(2*n + 1); c = kmrgd(2*n + 2); q = s*s + c*c;
dydt = [total(kmrgd(1:2*n), waves(s, c, par_Omega, par_load, 0))
        s + par_Omega*c - s*q
        c - par_Omega*s - c*q];
end

function [tspan, y0, options] = init
handles = feval(@$);
n = model();
y0 = [zeros(2*n, 1); 0; 1];
options = odeset('Jacobian', handles(3), 'JacobianP', handles(4));
tspan = [0 10];
end

function jac = jacobian(t, kmrgd, par_Omega, par_load)
n = model();
x = kmrgd(1:2*n); s = kmrgd(2*n + 1); c = kmrgd(2*n + 2);
jac = zeros(2*n + 2);
jac(1:2*n, 1:2*n) = slopes(x, waves(s, c, par_Omega, par_load, 0));
jac(1:2*n, 2*n + 1) = changed(x, waves(s, c, par_Omega, par_load, 3));
jac(1:2*n, 2*n + 2) = changed(x, waves(s, c, par_Omega, par_load, 4));
jac(2*n + 1, 2*n + 1:end) = [1 - 3*s*s - c*c, par_Omega - 2*s*c];
jac(2*n + 2, 2*n + 1:end) = [-par_Omega - 2*s*c, 1 - s*s - 3*c*c];
end

function jacp = jacobianp(t, kmrgd, par_Omega, par_load)
n = model();
x = kmrgd(1:2*n); s = kmrgd(2*n + 1); c = kmrgd(2*n + 2);
V = waves(s, c, par_Omega, par_load, 1);
W = waves(s, c, par_Omega, par_load, 2);
jacp = [changed(x, V), changed(x, W)
        c, 0
        -s, 0];
end

% 1, then the waves, parts of (c + i s)^k; derivatives by Omega (1), load (2), s (3), c (4).
function W = waves(s, c, Omega, load, by)
[~, H] = model();
W = ones(1 + size(H, 1), 1);
for h = 1:size(H, 1)
    k = H(h, 1); a = H(h, 3); b = H(h, 4);
    w = (c + 1i*s)^k; A = Omega^a; B = load^b;
    if by == 1
        A = a*Omega^max(a - 1, 0);
    elseif by == 2
        B = b*load^(b - 1);
    elseif by > 2
        w = k*(c + 1i*s)^max(k - 1, 0);
        if by == 3
            w = 1i*w;
        end
    end
    if H(h, 2)
        W(h + 1) = A*B*imag(w);
    else
        W(h + 1) = A*B*real(w);
    end
end
end

%@ matlab_sums
function y = total(x, W)
[n, ~, T] = model();
y = zeros(2*n, size(x, 2));
y(1:n, :) = x(n+1:2*n, :);
for r = 1:size(T, 1)
    z = T(r, 3)*W(T(r, 2) + 1, :);
    for i = T(r, 4:end)
        if i > 0
            z = z.*x(i, :);
        end
    end
    y(n + T(r, 1), :) = y(n + T(r, 1), :) + z;
end
end

% The same without the first n rows and without terms of no wave: W is a derivative of waves.
function y = changed(x, W)
n = model();
W(1, :) = 0;
y = total(x, W);
y(1:n, :) = 0;
end

function J = slopes(x, W)
[n, ~, T] = model();
J = zeros(2*n, 2*n, size(x, 2));
for j = 1:n
    J(j, n + j, :) = 1;
end
for r = 1:size(T, 1)
    f = T(r, 4:end);
    f = f(f > 0);
    for d = 1:numel(f)
        z = T(r, 3)*W(T(r, 2) + 1, :);
        for i = f([1:d-1, d+1:end])
            z = z.*x(i, :);
        end
        j = n + T(r, 1);
        J(j, f(d), :) = J(j, f(d), :) + reshape(z, 1, 1, []);
    end
end
end

