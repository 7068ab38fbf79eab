"""Stands in for rclpy: nodes of one process hear what it publishes."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any


class Message:
    """Any message."""

    def __init__(self, **fields: Any) -> None:
        self.__dict__.update(fields)


class Node:
    """A node; what was published waits until it spins."""

    def __init__(self, name: str) -> None:
        self.waiting: list[tuple[Callable[[Any], object], Any]] = []
        self.listeners: dict[str, list[Callable[[Any], object]]] = {}

    def create_subscription(self, kind: type, topic: str, callback: Callable[[Any], object], depth: int) -> None:
        self.listeners.setdefault(topic, []).append(callback)

    def create_publisher(self, kind: type, topic: str, depth: int) -> Publisher:
        return Publisher(self, kind, topic)

    def destroy_node(self) -> None:
        self.listeners.clear()


class Publisher:
    """Of a node."""

    def __init__(self, node: Node, kind: type, topic: str) -> None:
        self.node, self.kind, self.topic = node, kind, topic

    def publish(self, message: Any) -> None:
        assert isinstance(message, self.kind)
        self.node.waiting += [(callback, message) for callback in self.node.listeners.get(self.topic, ())]


create_node = Node


def init() -> None: ...


def shutdown() -> None: ...


def spin_once(node: Node, timeout_sec: float) -> None:
    waiting, node.waiting = node.waiting, []
    for callback, message in waiting:
        callback(message)


def get_rmw_implementation_identifier() -> str:
    return os.environ.get("RMW_IMPLEMENTATION") or "rmw_fastrtps_cpp"
