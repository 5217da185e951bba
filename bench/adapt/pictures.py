# SPDX-License-Identifier: MIT
"""Draws errors against vertices: the parts that several pictures share."""


def dress(axis, title):
    axis.set_title(title, fontsize=10)
    axis.tick_params(labelsize=8)
    axis.grid(True, which="major", linewidth=0.3)


def save(figure, legend_of, beside, path):
    """Writes the picture. The same data give the same bytes."""
    legend_of.legend(fontsize=8)
    figure.supxlabel("vertices", fontsize=10)
    figure.supylabel(beside, fontsize=10)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
