"""Thinning, edges, objects, holes and graphs of images, exact to the pixel and fast.

An argument that does not fit raises TypeError or ValueError, which names it; then no result is written.

>>> import numpy as np
>>> import thinbench
>>> skeleton = thinbench.thin(np.ones((3, 9), bool))
"""

from thinbench import compat
from thinbench._binarise import binarise
from thinbench._catalogue import isas, named_rules, rules
from thinbench._graph import PIXEL_CLASSES, classify_pixels, medial_axis, prune, skeleton_graph
from thinbench._images import (detect_edges, distances, euler_number, fill_holes, fill_holes_of_labels, find_objects,
                               find_regions, label_image, label_objects, label_regions, label_values,
                               localise_objects, squared_distances)
from thinbench._label_graphs import graph_of_labels, prune_labels
from thinbench._library import UNLIMITED, release_memory
from thinbench._library import version as _version
from thinbench._midpoints import midpoint_scan
from thinbench._packed import thin_packed
from thinbench._path import find_path
from thinbench._rules import Rule
from thinbench._skeleton_graph import Graph, GraphPath, GraphPlace
from thinbench._thinning import apply, thin, thin_labels, thin_many

__version__: str = _version().decode()
__all__ = [
    "PIXEL_CLASSES", "UNLIMITED", "Graph", "GraphPath", "GraphPlace", "Rule", "apply", "binarise",
    "classify_pixels", "compat", "detect_edges", "distances", "euler_number", "fill_holes", "fill_holes_of_labels",
    "find_objects", "find_path", "find_regions", "graph_of_labels", "isas", "label_image", "label_objects",
    "label_regions", "label_values", "localise_objects", "medial_axis", "midpoint_scan", "named_rules", "prune",
    "prune_labels", "release_memory", "rules", "skeleton_graph", "squared_distances", "thin", "thin_labels",
    "thin_many", "thin_packed"]
