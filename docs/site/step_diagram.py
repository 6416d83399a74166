#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws docs/figures/step.svg, one step of Solver with Granular<> and the integrator Midpoint: step_diagram.py"""
from pathlib import Path

WIDTH, LEFT, BOX, ROW, GAP = 860, 40, 330, 44, 16
SOLVER, PAIRS, POINTS = "#dfe5ea", "#fde3d3", "#dcefe4"
LICENCE = "<!--\n" + "\n".join(line[2:] for line in Path(__file__).read_text(encoding="utf8").split("\n")[1:3]) + "\n-->"

STEP = [  # colour, what happens, what it reads and changes
    (SOLVER, "neighbour lists", "all built again when a particle has moved too far"),
    (PAIRS, "walls: velocity and stress", "each wall particle takes those of the material in front of it"),
    (PAIRS, "rates of stress and velocity", "sums over neighbours, material and walls; law, viscosity, gravity"),
    (SOLVER, "limits → time step", "acoustic, force, viscous; checks: finite values, validity of the model"),
    (POINTS, "update to t + dt/2", "position, velocity, stress; the stress returns to the yield surface"),
    (POINTS, "walls to t + dt/2", "by the prescribed motion"),
    (PAIRS, "walls, then rates again", "as above, with the state at t + dt/2"),
    (POINTS, "update to t + dt", "from the state at t, with the rates at t + dt/2; walls move, too"),
    (PAIRS, "filter of the stress", "at every 30th step, where the material yields"),
]


def svg():
    height = len(STEP) * (ROW + GAP) + 110
    out = [LICENCE, f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="15">',
           '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto">'
           '<path d="M0 0 L8 4 L0 8 z" fill="#555"/></marker></defs>',
           f'<rect width="{WIDTH}" height="{height}" fill="#fff"/>']
    y, middle = 20, LEFT + BOX / 2
    for k, (colour, title, text) in enumerate(STEP):
        out.append(f'<rect x="{LEFT}" y="{y}" width="{BOX}" height="{ROW}" rx="5" fill="{colour}" stroke="#777"/>')
        out.append(f'<text x="{middle:g}" y="{y + 27}" text-anchor="middle" font-weight="bold">{title}</text>')
        out.append(f'<text x="{LEFT + BOX + 20}" y="{y + 27}" font-size="13">{text}</text>')
        if k + 1 < len(STEP):
            out.append(f'<path d="M{middle:g} {y + ROW} v{GAP - 1}" stroke="#555" marker-end="url(#tip)"/>')
        y += ROW + GAP
    first, last = 20 + ROW / 2, y - GAP - ROW / 2
    out.append(f'<path d="M{LEFT} {last:g} H14 V{first:g} H{LEFT - 1}" fill="none" stroke="#555" marker-end="url(#tip)"/>')
    out.append(f'<text x="{LEFT}" y="{y + 8}" font-size="13">Then the next step. Observers (output, tables, checkpoints) are '
               'called between steps.</text>')
    for k, (colour, text) in enumerate(((PAIRS, "loops over pairs"), (POINTS, "loops over particles"), (SOLVER, "solver"))):
        x = LEFT + 190 * k
        out.append(f'<rect x="{x}" y="{y + 28}" width="22" height="16" fill="{colour}" stroke="#777"/>')
        out.append(f'<text x="{x + 30}" y="{y + 41}" font-size="13">{text}</text>')
    return "\n".join([*out, "</svg>"]) + "\n"


if __name__ == "__main__":
    path = Path(__file__).resolve().parents[1] / "figures/step.svg"
    path.parent.mkdir(exist_ok=True)
    path.write_text(svg(), encoding="utf8")
