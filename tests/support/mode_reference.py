"""Makes tests/reference/modes.json: mode problems solved with hundreds of digits, by another method than the crate's.

The four fundamental solutions and a particular one are grown from u = 0 as power series, with as many digits as the growth of the
fastest rate eats (0.87 digits per unit of rate) and sixty more, so no regime is special. Needs mpmath. Run from the repository's root:

    python3 tests/support/mode_reference.py
"""
import json
import random

from mpmath import mp, mpf, lu_solve, matrix

POINTS = [0.0, 0.001, 0.03125, 0.2, 0.5, 0.77, 0.9375, 1.0]


def series(start, b, c, order, force, u_list, rate):
    """Values and first two derivatives at every u of the series with the given initial data."""
    n_terms = int(3 * rate) + 120 + len(force)
    terms = [mpf(a) for a in start]
    for m in range(n_terms):
        f = mpf(force[m]) if m < len(force) else mpf(0)
        if order == 2:
            terms.append((f + b * terms[m]) / ((m + 1) * (m + 2)))
        else:
            terms.append((f + b * (m + 2) * (m + 1) * terms[m + 2] - c * terms[m]) / ((m + 1) * (m + 2) * (m + 3) * (m + 4)))
    rows = []
    for u in u_list:
        u = mpf(u)
        q = dq = ddq = mpf(0)
        for a in reversed(terms):
            ddq = ddq * u + 2 * dq
            dq = dq * u + q
            q = q * u + a
        rows.append((q, dq, ddq))
    return rows


def solve(case):
    s, t, w, k = (mpf(case[x]) for x in ("s", "t", "w", "k"))
    order = case["order"]
    mp.dps = 50
    rate = float(max(abs(t / s * k * k) ** mpf("0.5"), abs(w / s * k ** 4) ** mpf("0.25") if order == 4 else 0) * mpf("1.3"))
    mp.dps = int(0.87 * rate) + 60
    s, t, w, k = (mpf(case[x]) for x in ("s", "t", "w", "k"))
    b, c = t * k * k / s, w * k ** 4 / s
    force = [mpf(f) / s for f in case["force"]]
    zero = [0] * order
    points = [0.0, 1.0] + POINTS
    particular = series(zero, b, c, order, force, points, rate)
    units = []
    for j in range(order):
        start = list(zero)
        start[j] = mpf(1) / (6 if j == 3 else 2 if j == 2 else 1)
        units.append(series(start, b, c, order, [], points, rate))
    conditions = [(0, 0, "start"), (1, 0, "end")] + ([(0, 1, "start_u"), (1, 1, "end_u")] if order == 4 else [])
    A = matrix(order, order)
    r = matrix(order, 1)
    for i, (point, derivative, name) in enumerate(conditions):
        for j in range(order):
            A[i, j] = units[j][point][derivative]
        r[i] = mpf(case[name]) - particular[point][derivative]
    x = lu_solve(A, r)
    values = []
    for i in range(2, len(points)):
        values.append([float(particular[i][d] + sum(x[j] * units[j][i][d] for j in range(order))) for d in range(3)])
    case["u"] = POINTS
    case["q"] = values


def main():
    rng = random.Random(20260101)
    cases = []

    def add(order, s, t, w, k, force=(), why=""):
        case = dict(why=why, order=order, s=s, t=t, w=w, k=k, force=list(force))
        case["start"], case["end"] = rng.uniform(-1, 1), rng.uniform(-1, 1)
        case["start_u"], case["end_u"] = (rng.uniform(-3, 3), rng.uniform(-3, 3)) if order == 4 else (0.0, 0.0)
        solve(case)
        cases.append(case)

    rates = [1e-8, 1e-5, 1e-2, 0.5, 1.9, 2.1, 3.0, 3.9, 4.1, 5.0, 8.0, 20.0, 29.0, 31.0, 100.0, 400.0, 1000.0]
    forces = [(), (1.0,), (-2.0, 3.0), tuple(rng.uniform(-2, 2) for _ in range(6)), tuple(rng.uniform(-2, 2) for _ in range(15))]
    for rate in rates:
        scaled = [tuple(f * max(1.0, rate * rate) for f in force) for force in forces]
        add(2, 1.0, rate * rate, 0.0, 1.0, rng.choice(scaled), "order 2")
        add(2, -2.0, -2.0, 0.0, rate, rng.choice(scaled), "order 2, both negative")
        scaled = [tuple(f * max(1.0, rate ** 4) for f in force) for force in forces]
        for ratio in (0.0, 1e-14, 1e-9, 1e-5, 1e-2, 0.3, 0.9, 0.99999, 1 - 1e-9, 1.0):
            # Roots rate^2 and ratio rate^2.
            add(4, 1.0, 1.0 + ratio, ratio, rate, rng.choice(scaled), f"real roots, ratio {ratio}")
        for w in (1.0 + 1e-12, 1.0 + 1e-6, 1.01, 3.0, 1e3):
            add(4, 2.0, 4.0 / w ** 0.5, 2.0, rate, rng.choice(scaled), f"complex roots, {w}")
        add(4, 1.0, 0.0, 1.0, rate, rng.choice(scaled), "t = 0")
        add(4, 1.0, 1e-9, 1.0, rate, rng.choice(scaled), "t -> 0")
        add(4, 1.0, 1.0, 1e-12, rate, rng.choice(scaled), "w -> 0")
    for rate in (1e-8, 1e-3, 0.7, 2.0, 3.5, 5.0, 11.0, 40.0, 130.0):
        for w in (-1.0, -1e-3, -1e-9, -30.0):
            add(4, 1.0, rng.choice((0.0, 0.4, -0.4, 2.0)), w, rate, rng.choice(forces), "w < 0")
        for t, w in ((-1.2, 4.0), (-1.99999, 1.0), (-2.0, 1.0), (-2.00001, 1.0), (-2.6, 1.0), (-9.0, 1.0), (-1.0, 0.0), (-3.0, 1e-8)):
            add(4, 1.0, t, w, rate, rng.choice(forces), "t < 0")
        add(2, 1.0, -1.0, 0.0, rate * 1.01, rng.choice(forces), "order 2, oscillating")
    for order in (2, 4):
        add(order, 1.0, 3.0, 2.0, 0.0, forces[4], "k = 0")
        add(order, 3.0, 0.0, 0.0, 5.0, forces[4], "t = w = 0")
        add(order, 1.0, 1.0, 1.0, 12.0, tuple(rng.uniform(-100, 100) for _ in range(40)), "force of degree 39")
        add(order, 1.0, 1.0, 0.25, 33.0, tuple(rng.uniform(-1e4, 1e4) for _ in range(64)), "force of degree 63")
        add(order, 1.0, 1.0, 0.2, 4.5, tuple(rng.uniform(-100, 100) for _ in range(64)), "force of degree 63")
    with open("tests/reference/modes.json", "w") as out:
        json.dump(cases, out, indent=0)
    print(len(cases), "cases")


main()
