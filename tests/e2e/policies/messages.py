"""All types of messages of ROS 2 that are here, with arrays of numpy both ways."""

import contextlib
import importlib

import numpy
from ament_index_python.packages import get_packages_with_prefixes
from rclpy.serialization import deserialize_message, serialize_message


def modules():
    for package in get_packages_with_prefixes():
        with contextlib.suppress(ModuleNotFoundError):
            yield importlib.import_module(f"{package}.msg")


types = [
    value for module in modules() for value in vars(module).values() if hasattr(value, "get_fields_and_field_types")
]
with_arrays = 0
for kind in types:
    message = kind()
    arrays = [name for name in kind.get_fields_and_field_types() if isinstance(getattr(message, name), numpy.ndarray)]
    for name in arrays:
        zeros = getattr(message, name)
        setattr(message, name, numpy.arange(zeros.size).astype(zeros.dtype))
    again = deserialize_message(serialize_message(message), kind)
    for name in arrays:
        assert (getattr(again, name) == getattr(message, name)).all(), (kind, name)
    with_arrays += bool(arrays)
assert len(types) > 100 and with_arrays > 5, (len(types), with_arrays)
print(f"messages: {len(types)} types, {with_arrays} with arrays, numpy {numpy.__version__}")
