# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Reference paths of the hypoplastic law of von Wolffersdorff (1996), integrated independently of the library.

Axisymmetric tests are written in principal stresses, compression positive, where the law reduces to two scalar
equations and the lateral rate of a drained triaxial test is the root of a quadratic. Simple shear at constant volume is
written in components. Runge-Kutta steps of fourth order, extrapolated from two step lengths; the difference of both is
printed. Only the standard library is needed:

    python3 hypoplastic_paths.py > hypoplastic_paths.hpp
"""
import math
import sys

# Sand of Hochstetten; Pa, rad.
PHI_C, H_S, N = math.radians(33), 1e9, 0.25
E_D0, E_C0, E_I0, ALPHA, BETA = 0.55, 0.95, 1.05, 0.25, 1.0
A = math.sqrt(3) * (3 - math.sin(PHI_C)) / (2 * math.sqrt(2) * math.sin(PHI_C))


def factors(trace, e):
    """f_b f_e, f_d for the sum of the principal stresses, compression positive."""
    fall = math.exp(-((trace / H_S) ** N))
    e_d, e_c, e_i = E_D0 * fall, E_C0 * fall, E_I0 * fall
    f_d = ((e - e_d) / (e_c - e_d)) ** ALPHA
    f_e = (e_c / e) ** BETA
    f_b = H_S / N * (E_I0 / E_C0) ** BETA * (1 + e_i) / e_i * (trace / H_S) ** (1 - N)
    f_b /= 3 + A * A - math.sqrt(3) * A * ((E_I0 - E_D0) / (E_C0 - E_D0)) ** ALPHA
    return f_b * f_e, f_d


def axisymmetric(lateral):
    """Rates of (axial stress, lateral stress, e) per axial strain; `lateral` gives the lateral strain rate."""

    def rate(y):
        axial, radial, e = y
        trace = axial + 2 * radial
        f, f_d = factors(trace, e)
        t1, t3 = axial / trace, radial / trace
        x = t1 - 1 / 3
        F = 1.0 if x >= 0 else 1 + 1.5 * x  # 1 - tan(psi)/sqrt(2), tan(psi) = -3 x/sqrt(2)
        f /= t1 * t1 + 2 * t3 * t3
        d3 = lateral(F, f_d, t1, t3)
        work, size = t1 + 2 * t3 * d3, math.sqrt(1 + 2 * d3 * d3)
        return (
            f * (F * F + A * A * t1 * work - f_d * A * F * (2 * t1 - 1 / 3) * size),
            f * (F * F * d3 + A * A * t3 * work - f_d * A * F * (2 * t3 - 1 / 3) * size),
            -(1 + e) * (1 + 2 * d3),
        )

    return rate


def held(F, f_d, t1, t3):
    return 0.0


def isotropic(F, f_d, t1, t3):
    return 1.0


def drained(F, f_d, t1, t3):
    """The lateral rate that keeps the lateral stress: b d + c = g sqrt(1 + 2 d^2)."""
    b, c, g = F * F + 2 * A * A * t3 * t3, A * A * t1 * t3, f_d * A * F * (2 * t3 - 1 / 3)
    # (b^2 - 2 g^2) d^2 + 2 b c d + c^2 - g^2 = 0, of the roots the one with the sign of g
    q, h, k = b * b - 2 * g * g, b * c, c * c - g * g
    root = math.sqrt(h * h - q * k)
    return min(((-h + s * root) / q for s in (1, -1)), key=lambda d: abs(b * d + c - g * math.sqrt(1 + 2 * d * d)))


def simple_shear(y):
    """Rates of (s11, s22, s33, s12, e) per shear L12 at constant volume, tension positive."""
    s11, s22, s33, s12, e = y
    trace = s11 + s22 + s33
    f, f_d = factors(-trace, e)
    t11, t22, t33, t12 = s11 / trace, s22 / trace, s33 / trace, s12 / trace
    f /= t11**2 + t22**2 + t33**2 + 2 * t12**2
    x11, x22, x33 = t11 - 1 / 3, t22 - 1 / 3, t33 - 1 / 3
    norm = math.sqrt(x11**2 + x22**2 + x33**2 + 2 * t12**2)
    cos_3theta = -math.sqrt(6) * 3 * x33 * (x11 * x22 - t12**2) / norm**3 if norm > 0 else 1.0  # tr(x^3) = 3 det(x)
    tan_psi = math.sqrt(3) * norm
    F = math.sqrt(tan_psi**2 / 8 + (2 - tan_psi**2) / (2 + math.sqrt(2) * tan_psi * cos_3theta))
    F -= tan_psi / (2 * math.sqrt(2))
    work = t12  # T : D with D12 = 1/2
    along = A * A * work
    across = f_d * A * F * math.sqrt(0.5)
    return (
        f * (along * t11 + across * (t11 + x11)) + s12,
        f * (along * t22 + across * (t22 + x22)) - s12,
        f * (along * t33 + across * (t33 + x33)),
        f * (F * F / 2 + along * t12 + across * 2 * t12) + (s22 - s11) / 2,
        0.0,
    )


def runge_kutta(rate, y, length, steps):
    h = length / steps
    for _ in range(steps):
        k1 = rate(y)
        k2 = rate([u + h / 2 * k for u, k in zip(y, k1)])
        k3 = rate([u + h / 2 * k for u, k in zip(y, k2)])
        k4 = rate([u + h * k for u, k in zip(y, k3)])
        y = [u + h / 6 * (p + 2 * q + 2 * r + s) for u, p, q, r, s in zip(y, k1, k2, k3, k4)]
    return y


def path(name, rate, start, ends, packed, per_unit=40000):
    """Rows (strain, s11, s22, s33, s12, e), tension positive, at the given strains."""
    coarse = fine = list(start)
    rows, worst, at = [], 0.0, 0.0
    for end in ends:
        steps = max(20, int(per_unit * (end - at)))
        coarse, fine = runge_kutta(rate, coarse, end - at, steps), runge_kutta(rate, fine, end - at, 2 * steps)
        best = [f + (f - c) / 15 for f, c in zip(fine, coarse)]
        worst = max(worst, max(abs(f - c) / abs(b) for f, c, b in zip(fine, coarse, best) if b))
        rows.append((end, *packed(best)))
        at = end
    print(f"{name}: steps of {1 / per_unit:g} and half of it differ by {worst:.1e}", file=sys.stderr)
    return name, rows


def axisymmetric_row(y):
    return (-y[1], -y[0], -y[1], 0.0, y[2])


def paths():
    few, oedometer = [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5], [0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.04]
    p = 1e5
    loosest = E_I0 * math.exp(-((3e4 / H_S) ** N))
    for name, e in (("loose", 0.85), ("dense", 0.62)):
        yield path(f"triaxial_{name}", axisymmetric(drained), (p, p, e), few, axisymmetric_row)
        yield path(f"oedometer_{name}", axisymmetric(held), (2e4, 1e4, e), oedometer, axisymmetric_row)
        start = (-p / 2, -p, -p / 2, 0.0, e)
        yield path(f"simple_shear_{name}", simple_shear, start, [0.005, 0.01, 0.02, 0.05, 0.1], lambda y: y)
    yield path("isotropic_loosest", axisymmetric(isotropic), (1e4, 1e4, loosest), [0.002, 0.005, 0.01, 0.02], axisymmetric_row)


def main():
    print("// SPDX-FileCopyrightText: The scree authors")
    print("// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception")
    print("// Written by hypoplastic_paths.py; do not edit.")
    print("// clang-format off\n#pragma once\n\n#include <vector>\n\nnamespace scree::test::reference {\n")
    print("/// Strain (axial and compressive, or shear), stresses (Pa, tension positive; 22 is axial) and void ratio.")
    print("struct State {\n  double strain, s11, s22, s33, s12, e;\n};\n")
    for name, rows in paths():
        print(f"inline std::vector<State> const {name}{{")
        print(",\n".join("    {" + ", ".join(f"{x:.12g}" for x in row) + "}" for row in rows))
        print("};")
    print("\n}  // namespace scree::test::reference")


main()
