// Roots of a quadratic with every digit that double precision allows.
#pragma once

namespace goniolux::geometry {

/// a b - c d with an error of 1.5 ulp. — Kahan's algorithm; Jeannerod, Louvet, Muller, Math. Comp. 82 (2013).
double differenceOfProducts(double a, double b, double c, double d);

/// Roots of a t^2 + 2 b t + c = 0 in ascending order; false when there are none. With a = 0 one root is at infinity and
/// falls out of every later range test. A discriminant that is negative only within the rounding of a, b and c (of
/// order `scale`) counts as 0: a ray from inside a cone through its apex must not escape.
bool solveQuadratic(double a, double b, double c, double scale, double& t0, double& t1);

}  // namespace goniolux::geometry
