# What is the same in all models that are exported to BifurcationKit. Lines of #@ begin the parts that export.c
# writes, with the name of the model for $; this heading is not written.
# SPDX-License-Identifier: GPL-3.0-or-later
#@ julia_begin
#
#   include("$.jl")
#   par = (Omega = 1.0, load = 1.0)
#   prob = BifurcationProblem($.F, $.start, par, (@optic _.Omega); J = $.J)
#
# The last two states are sin and cos of the phase: an oscillator on the attracting circle,
# since BifurcationKit takes autonomous systems. Omega is scaled; load is the factor of the
# load, 1 for the model.
module $

#@ julia_end
const start = [zeros(2n); 0.0; 1.0]

# 1, then the waves, parts of (c + i s)^k; their derivatives by s (1) and c (2).
function waves(s, c, p, by = 0)
    W = [one(s*p.Omega*p.load)]
    for (k, sine, a, b) in harmonics
        w = by == 0 ? complex(c, s)^k : k*complex(c, s)^max(k - 1, 0)*(by == 1 ? im : 1)
        push!(W, p.Omega^a*p.load^b*(sine == 1 ? imag(w) : real(w)))
    end
    by == 0 || (W[1] = 0)
    return W
end

function add!(f, x, W)
    for (j, h, value, factors) in rows
        f[n + j] += value*W[h + 1]*prod((x[i] for i in factors); init = one(eltype(x)))
    end
    return f
end

function F(x, p)
    s, c = x[2n + 1], x[2n + 2]
    q = s^2 + c^2
    W = waves(s, c, p)
    f = zeros(promote_type(eltype(x), eltype(W)), 2n + 2)
    f[1:n] .= x[n + 1:2n]
    add!(f, x, W)
    f[2n + 1] = s + p.Omega*c - s*q
    f[2n + 2] = c - p.Omega*s - c*q
    return f
end

function J(x, p)
    s, c = x[2n + 1], x[2n + 2]
    W = waves(s, c, p)
    A = zeros(promote_type(eltype(x), eltype(W)), 2n + 2, 2n + 2)
    for j in 1:n
        A[j, n + j] = 1
    end
    for (j, h, value, factors) in rows, d in eachindex(factors)
        others = (x[factors[i]] for i in eachindex(factors) if i != d)
        A[n + j, factors[d]] += value*W[h + 1]*prod(others; init = one(eltype(x)))
    end
    A[:, 2n + 1] .= add!(zero(A[:, 1]), x, waves(s, c, p, 1))
    A[:, 2n + 2] .= add!(zero(A[:, 1]), x, waves(s, c, p, 2))
    A[2n + 1, 2n + 1:2n + 2] .= (1 - 3s^2 - c^2, p.Omega - 2s*c)
    A[2n + 2, 2n + 1:2n + 2] .= (-p.Omega - 2s*c, 1 - s^2 - 3c^2)
    return A
end

end
