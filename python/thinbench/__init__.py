"""Thinning, edges, objects, holes and graphs of images, exact to the pixel and fast.

>>> import numpy as np
>>> import thinbench
>>> skeleton = thinbench.thin(np.ones((3, 9), bool))
"""

from thinbench import compat
from thinbench._binarise import binarise
from thinbench._catalogue import cpu, named_rules, rules
from thinbench._graph import PIXEL_CLASSES, classify_pixels, graph, medial_axis, prune
from thinbench._images import (distance, edges, euler_number, fill_holes, fill_label_holes, label, label_values, localise,
                               regions)
from thinbench._label_graphs import graph_labels, prune_labels
from thinbench._library import release_memory
from thinbench._library import version as _version
from thinbench._midpoints import midpoint_scan
from thinbench._packed import thin_packed
from thinbench._path import path
from thinbench._rules import Rule
from thinbench._skeleton_graph import Cycle, Graph, GraphPath, Place
from thinbench._thinning import apply, thin, thin_labels, thin_many

__version__: str = _version().decode()
__all__ = [
    "PIXEL_CLASSES", "Cycle", "Graph", "GraphPath", "Place", "Rule", "apply", "binarise", "classify_pixels",
    "compat", "cpu", "distance", "edges", "euler_number", "fill_holes", "fill_label_holes", "graph",
    "graph_labels", "label", "label_values", "localise", "medial_axis", "midpoint_scan", "named_rules", "path",
    "prune", "prune_labels", "regions", "release_memory", "rules", "thin", "thin_labels", "thin_many", "thin_packed"]
