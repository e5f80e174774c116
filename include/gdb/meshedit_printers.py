# Lets gdb print handles as the report names them: "h3 (bc -> v2)" is half-edge 3, from corner b
# to corner c, which ends at vertex 2. `meshgrade replay --debug` loads this file by itself;
# elsewhere: (gdb) source include/gdb/meshedit_printers.py
#
# Reads the memory of the program and calls nothing in it, so that a broken mesh can be printed,
# too.

import gdb
import gdb.printing

# SlotState in meshedit/detail/pool.h
LOOSE, LIVE, DELETED, LINK, END = range(5)

PREFIX = {"Halfedge": "h", "Vertex": "v", "Edge": "e", "Face": "f"}

# Letters of the corners around the edge that the case is about, by the numbers of vertices.
corners = {}


def set_corners(text):
    """Takes "a=3 b=0 c=1 d=2": letters of vertices, as in the report."""
    corners.clear()
    for word in text.split():
        letter, number = word.split("=")
        corners[int(number)] = letter


def kind_of(element):
    return element.type.strip_typedefs().unqualified().name.split("::")[-1]


def pointed(handle):
    """The element of a handle, or None if it was never set."""
    address = handle["element_"]
    return None if int(address) == 0 else address.dereference()


def word_of(element):
    return int(element["tag_"]["word_"])


def state_of(element):
    return word_of(element) & 7


def number_of(element):
    return word_of(element) >> 3


def short_name(element):
    """h3, v2, e5, f1, or b0 for a boundary loop."""
    kind = kind_of(element)
    prefix = PREFIX.get(kind, "?")
    if kind == "Face" and bool(element["_isBoundary"]):
        prefix = "b"
    return prefix + str(number_of(element))


def vertex_text(element):
    number = number_of(element)
    return corners.get(number, short_name(element))


def start_and_end(halfedge):
    """The vertices that a half-edge leads from and to; None where a pointer is not set."""
    start = pointed(halfedge["_vertex"])
    twin = pointed(halfedge["_twin"])
    end = None if twin is None or state_of(twin) != LIVE else pointed(twin["_vertex"])
    return start, end


def path_text(halfedge):
    """bc -> v2 between two corners, v0 -> v2 elsewhere."""
    start, end = start_and_end(halfedge)
    if end is None:
        return "its twin is not set" if start is None else "from %s, its end is not known" % (
            vertex_text(start))
    if start is None:
        return "? -> " + short_name(end)
    if number_of(start) in corners and number_of(end) in corners:
        return "%s%s -> %s" % (vertex_text(start), vertex_text(end), short_name(end))
    return "%s -> %s" % (short_name(start), short_name(end))


def element_text(element):
    state = state_of(element)
    if state == END or state == LINK:
        return "the end of the list"
    name = short_name(element)
    if state == DELETED:
        return name + " (deleted)"
    kind = kind_of(element)
    if kind == "Halfedge":
        return "%s (%s)" % (name, path_text(element))
    if kind == "Vertex" and number_of(element) in corners:
        return "%s (%s)" % (name, corners[number_of(element)])
    if kind in ("Edge", "Face"):
        halfedge = pointed(element["_halfedge"])
        if halfedge is None:
            return name + " (its halfedge is not set)"
        if kind == "Edge" and state_of(halfedge) == LIVE:
            return "%s (%s)" % (name, path_text(halfedge))
    return name


class HandlePrinter:
    def __init__(self, handle):
        self.handle = handle

    def to_string(self):
        element = pointed(self.handle)
        if element is None:
            return "not set"
        try:
            return element_text(element)
        except gdb.MemoryError:
            return "a handle to memory that is not there"


class VectorPrinter:
    def __init__(self, vector):
        self.vector = vector

    def to_string(self):
        names = [f.name for f in self.vector.type.strip_typedefs().fields()]
        return "(%s)" % ", ".join("%g" % float(self.vector[n]) for n in names if n in "xyz")


def build_printers():
    printers = gdb.printing.RegexpCollectionPrettyPrinter("meshedit")
    printers.add_printer("Handle", "^meshedit::Handle<.*>$", HandlePrinter)
    printers.add_printer("Vector", "^meshedit::Vector[23]D$", VectorPrinter)
    return printers


gdb.printing.register_pretty_printer(None, build_printers(), replace=True)
