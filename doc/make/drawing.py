"""What all pictures of the pages are made with."""

import base64
import io
import re

import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np

plt.rcParams["svg.hashsalt"] = "plate-impact"
plt.rcParams["svg.fonttype"] = "none"


def alike(picture, other, tolerance=0.1):
    """Whether two pictures differ by no more than the last digits of their coordinates
    [pt], and their images by a hundredth on average; identifiers, which are made from
    coordinates, do not count."""
    number, image = r"-?\d+(?:\.\d+)?(?:e-?\d+)?", r'base64,([^"]*)"'
    images = [[pixels(found) for found in re.findall(image, text)] for text in (picture, other)]
    if any(a.shape != b.shape or abs(a - b).mean() > 0.01 for a, b in zip(*images)):
        return False
    texts = [re.sub(r'(id="|#)[^")]*', r"\1", re.sub(image, '"', text))
             for text in (picture, other)]
    shapes = [re.sub(number, "0", text) for text in texts]
    values = [np.array(re.findall(number, text), float) for text in texts]
    return shapes[0] == shapes[1] and np.all(abs(values[0] - values[1]) < tolerance)


def pixels(base64_png):
    return plt.imread(io.BytesIO(base64.b64decode(base64_png)), format="png")


def new_figure(n_axes=1, **options):
    return plt.subplots(1, n_axes, figsize=(4.2 * n_axes, 3.2), **options)


def svg(figure):
    text = io.StringIO()
    figure.tight_layout()
    figure.savefig(text, format="svg", metadata={"Date": None})
    plt.close(figure)
    return "\n".join(map(str.rstrip, text.getvalue().splitlines())) + "\n"
