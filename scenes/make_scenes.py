#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the scene files whose objects stand in long rows: chain.toml and crowd.toml. Run it from anywhere."""
import math
import pathlib

OUT = pathlib.Path(__file__).resolve().parent


def model(path, **entries):
    lines = ["[[models]]", f'path = "cages/{path}"']
    for key, value in entries.items():
        if isinstance(value, bool):
            lines.append(f"{key} = {'true' if value else 'false'}")
        elif isinstance(value, str):
            lines.append(f'{key} = "{value}"')
        elif isinstance(value, tuple):
            lines.append(f"{key} = [{', '.join(f'{v:.4g}' for v in value)}]")
        else:
            lines.append(f"{key} = {value:.4g}")
    return "\n".join(lines)


def write(file, comment, head, models):
    text = f"# SPDX-License-Identifier: Apache-2.0\n# {comment} Written by make_scenes.py.\n{head.strip()}\n\n"
    (OUT / file).write_text(text + "\n\n".join(models) + "\n")


def closed_curve(at, count):
    """Points and headings (degrees about y) at equal steps along a closed curve of the plane."""
    fine = [at(2 * math.pi * i / 20000) for i in range(20001)]
    length = [0.0]
    for (x0, z0), (x1, z1) in zip(fine, fine[1:]):
        length.append(length[-1] + math.hypot(x1 - x0, z1 - z0))
    step, places, i = length[-1] / count, [], 0
    for k in range(count):
        while length[i] < k * step:
            i += 1
        (x0, z0), (x1, z1) = fine[max(i - 1, 0)], fine[i + 1]
        places.append((fine[i], math.degrees(math.atan2(-(z1 - z0), x1 - x0))))
    return step, places


def chain():
    """A necklace of links that go through each other, around a star."""
    count, wanted = 20, 0.88
    scale = 1.0
    for _ in range(20):  # the curve that is just as long as the links reach
        step, places = closed_curve(
            lambda a: (scale * (1 + 0.13 * math.cos(3 * a)) * math.cos(a), scale * (1 + 0.13 * math.cos(3 * a)) * math.sin(a)),
            count)
        scale *= wanted / step
    models = [model("star.obj", translate=(0, 0, 0), rotate=(-24, 25, 0), scale=1.5, rest=True)]
    for k, ((x, z), heading) in enumerate(places):
        models.append(model("ring.obj", name=f"link {k + 1}", rotate=(45 if k % 2 else -45, heading, 0),
                            translate=(x, 0, z), rest=True))
    write("chain.toml", f"A chain of {count} links around a star: each link lies in two others and on their shadows.",
          '[[lights]]\ntype = "directional"\ndirection = [0.62, -0.75, -0.35]\n\n'
          '[camera]\neye = [7, 7, 11]\ntarget = [0.6, 0.1, 0]', models)


def crowd():
    """Fifty figures on a spiral, the tall ones in the middle."""
    models = []
    for k in range(50):
        radius, a = 0.66 * math.sqrt(k + 0.5), k * math.pi * (3 - math.sqrt(5))
        kind = ("pawn.obj", "cone.obj", "pawn.obj", "drum.obj")[k % 4]
        size = 1.35 - 0.075 * radius + 0.1 * math.sin(2.4 * k)
        models.append(model(kind, name=f"{kind[:-4]} {k + 1}", scale=size, rotate=(0, 37.0 * k % 360, 0),
                            translate=(radius * math.cos(a), 0, radius * math.sin(a)), rest=True))
    write("crowd.toml", "A crowd of fifty: long shadows that fall on many others.",
          '[parameters]\nres = 512\n\n[[lights]]\ntype = "directional"\ndirection = [0.8, -0.62, -0.45]\n\n'
          '[camera]\neye = [10, 8.5, 14]\ntarget = [0.8, 0.2, -0.3]', models)


if __name__ == "__main__":
    chain()
    crowd()
