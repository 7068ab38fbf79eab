"""Imitations of a registry do what the real one does: the same calls, with the same assertions, as in tests/e2e."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from fakes.http_registry import standing_in
from fakes.memory_registry import MemoryRegistry
from rosml.registry.client import Registry
from tests.registry_calls import CALLS


@pytest.fixture(params=["memory", "http", "http with the referrers API"])
def client(request: pytest.FixtureRequest) -> Iterator[Registry]:
    if request.param == "memory":
        yield MemoryRegistry()
        return
    with standing_in() as server, Registry(server.address) as local_registry:
        server.referrers = "API" in request.param
        yield local_registry


@pytest.mark.parametrize("name", CALLS)
def test_call(client: Registry, name: str) -> None:
    CALLS[name](client, "a/b")
