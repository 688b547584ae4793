"""Reads the VTU files of `Output/Field samples`."""

import base64
import struct
import zlib
import xml.etree.ElementTree

import numpy as np

TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "UInt8": "u1"}


def numbers(array):
    """Those of a DataArray in VTK's binary format: zlib in base64."""
    text = array.text.strip()
    n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    head_size = 4 * (3 + n_blocks)  # number and sizes of blocks
    head_chars = -(-head_size // 3) * 4
    sizes = struct.unpack(f"<{3 + n_blocks}I", base64.b64decode(text[:head_chars])[:head_size])
    data, raw, at = base64.b64decode(text[head_chars:]), b"", 0
    for size in sizes[3:]:
        raw += zlib.decompress(data[at:at + size])
        at += size
    return np.frombuffer(raw, "<" + TYPES[array.get("type")])


def field(path, name):
    """x, y [m], triangles by their points, and the field of a name at the points."""
    arrays = {array.get("Name") or "points": array
              for array in xml.etree.ElementTree.parse(path).iter("DataArray")}
    x, y, _ = numbers(arrays["points"]).reshape(-1, 3).T
    cells = numbers(arrays["connectivity"]).reshape(-1, 4)
    triangles = np.vstack([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
    return x, y, triangles, numbers(arrays[name])
