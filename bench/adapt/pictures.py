# SPDX-License-Identifier: MIT
"""What the pictures of errors against vertices have in common."""


def dress(axis, title):
    axis.set_title(title, fontsize=10)
    axis.tick_params(labelsize=8)
    axis.grid(True, which="major", linewidth=0.3)


def save(figure, legend_of, beside, path):
    """Writes the picture, the same bytes at every time."""
    legend_of.legend(fontsize=8)
    figure.supxlabel("vertices", fontsize=10)
    figure.supylabel(beside, fontsize=10)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
