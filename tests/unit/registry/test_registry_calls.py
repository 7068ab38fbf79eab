"""Imitations of a registry do what the real one does: the same calls, with the same assertions, as in tests/e2e."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from fakes.http_registry import local_registry
from fakes.memory_registry import MemoryRegistry
from rosml.registry.client import Registry
from tests.registry_calls import CALLS


@pytest.fixture(params=["memory", "http", "http with the referrers API"])
def client(request: pytest.FixtureRequest) -> Iterator[Registry]:
    if request.param == "memory":
        yield MemoryRegistry()
        return
    with local_registry() as server, Registry(server.address) as registry:
        server.referrers = "API" in request.param
        yield registry


@pytest.mark.parametrize("name", CALLS)
def test_call(client: Registry, name: str) -> None:
    CALLS[name](client, "a/b")
