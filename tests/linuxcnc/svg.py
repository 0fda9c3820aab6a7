# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Curves as a picture, in the look of docs/images/fidelity."""

import math

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#555555"]
WIDTH, HEIGHT = 720, 430
LEFT, RIGHT, TOP = 76, 700, 40
ROW = 20  # of the legend, below the axes


def ticks(low, high):
    """Round numbers from low to high, about six."""
    raw = (high - low) / 6.0
    unit = 10.0 ** math.floor(math.log10(raw))
    step = next(factor * unit for factor in (1.0, 2.0, 5.0, 10.0) if factor * unit >= raw)
    first = math.ceil(low / step - 1e-9)
    return [i * step for i in range(first, math.floor(high / step + 1e-9) + 1)], step


def thin(points, width):
    """Of many points per column of the picture only its first, least, greatest and last."""
    columns = {}
    for x, y in points:
        columns.setdefault(int(x * width), []).append((x, y))
    for column in columns.values():
        kept = {0, len(column) - 1}
        kept.add(min(range(len(column)), key=lambda i: column[i][1]))
        kept.add(max(range(len(column)), key=lambda i: column[i][1]))
        for i in sorted(kept):
            yield column[i]


def plot(file, title, x_name, y_name, curves):
    """Writes the picture and the licence file beside it. @param curves  [(name, [(x, y)])]"""
    bottom = HEIGHT - 80 - ROW * len(curves)
    low_x = min(x for _, points in curves for x, _ in points)
    high_x = max(x for _, points in curves for x, _ in points)
    low_y = 0.0
    high_y = 1.08 * max(y for _, points in curves for _, y in points)

    def at_x(x):
        return LEFT + (x - low_x) / (high_x - low_x) * (RIGHT - LEFT)

    def at_y(y):
        return bottom - (y - low_y) / (high_y - low_y) * (bottom - TOP)

    out = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" height="%d" '
        'font-family="DejaVu Sans, Arial, sans-serif" font-size="13" fill="#222222">'
        % (WIDTH, HEIGHT, WIDTH, HEIGHT),
        "<title>%s</title>" % title,
        '<rect width="%d" height="%d" fill="#ffffff"/>' % (WIDTH, HEIGHT),
        '<text x="%d" y="24" font-size="15" font-weight="bold">%s</text>' % (LEFT, title),
        '<clipPath id="inside"><rect x="%d" y="%d" width="%d" height="%d"/></clipPath>'
        % (LEFT, TOP, RIGHT - LEFT, bottom - TOP),
    ]
    values, step = ticks(low_x, high_x)
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    for value in values:
        out.append('<path d="M%.2f %dV%d" stroke="#e3e3e3"/>' % (at_x(value), TOP, bottom))
        out.append(
            '<text x="%.2f" y="%d" text-anchor="middle">%.*f</text>'
            % (at_x(value), bottom + 19, digits, value)
        )
    values, step = ticks(low_y, high_y)
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    for value in values:
        out.append('<path d="M%d %.2fH%d" stroke="#e3e3e3"/>' % (LEFT, at_y(value), RIGHT))
        out.append(
            '<text x="%d" y="%.2f" text-anchor="end">%.*f</text>'
            % (LEFT - 8, at_y(value) + 4.5, digits, value)
        )
    out.append('<path d="M%d %dV%dH%d" fill="none" stroke="#222222"/>' % (LEFT, TOP, bottom, RIGHT))
    middle = (LEFT + RIGHT) // 2
    out.append('<text x="%d" y="%d" text-anchor="middle">%s</text>' % (middle, bottom + 42, x_name))
    out.append(
        '<text transform="translate(18 %d) rotate(-90)" text-anchor="middle">%s</text>'
        % ((TOP + bottom) // 2, y_name)
    )
    # Where curves lie on each other, the earlier, wider ones remain visible.
    for number, (name, points) in enumerate(curves):
        colour = COLOURS[number % len(COLOURS)]
        points = thin(points, (RIGHT - LEFT) / (high_x - low_x))
        places = "L".join("%.2f %.2f" % (at_x(x), at_y(y)) for x, y in points)
        out.append(
            '<path clip-path="url(#inside)" d="M%s" fill="none" stroke="%s" stroke-width="%.1f"/>'
            % (places, colour, 1.3 + 1.7 * (len(curves) - 1 - number))
        )
        y = bottom + 42 + ROW * (number + 1)
        out.append('<path d="M%d %dh24" stroke="%s" stroke-width="3"/>' % (LEFT, y - 4, colour))
        out.append('<text x="%d" y="%d">%s</text>' % (LEFT + 32, y, name))
    out.append("</svg>")
    file.write_text("\n".join(out) + "\n", encoding="utf-8")
    licence = "SPDX-FileCopyrightText: 2026 The Rivulet authors\n"
    licence += "SPDX-License-Identifier: GPL-3.0-or-later\n"
    file.with_name(file.name + ".license").write_text(licence, encoding="utf-8")
