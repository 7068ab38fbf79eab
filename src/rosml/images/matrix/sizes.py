"""Forecasts of disk and time: what images and parts are expected to take."""

from __future__ import annotations

from pydantic import Field

from rosml.images.matrix.patterns import Facts, Megabytes, Name, Rate


class Size(Facts):
    """Sizes in MB (10^6 bytes)."""

    unpacked: Megabytes = Field(description="MB on disk")
    compressed: Megabytes = Field(description="MB in the registry")

    @classmethod
    def total(cls, *sizes: Size) -> Size:
        """The sum of sizes."""
        return cls.model_construct(
            unpacked=sum(size.unpacked for size in sizes), compressed=sum(size.compressed for size in sizes)
        )

    def __sub__(self, other: Size) -> Size:
        return Size.model_construct(
            unpacked=self.unpacked - other.unpacked, compressed=self.compressed - other.compressed
        )


class Disk(Facts):
    """Forecast of sizes in MB, each without what it stands on."""

    os: Size = Field(description="operating system with the essentials")
    runtime: Size | None = Field(
        default=None, description="the same for components with runtime_of; that of 'os' if left out"
    )
    components: dict[Name, Size] = Field(description="component -> size")
    parts: dict[Name, dict[Name, Size]] = Field(description="stack -> part -> size")
    budgets: dict[Name, dict[Name, Megabytes]] = Field(
        default={},
        description="stack -> framework or add-on -> MB that its parts may have together in the registry, those of an add-on without"
        " what frameworks of the stack have; more fails the tests",
    )


class Rates(Facts):
    """The speed of a CI machine, for the estimates of a plan, and so that its shards take equally long."""

    packages: Rate = Field(default=25, description="MB unpacked per second while apt installs packages")
    parts: Rate = Field(default=60, description="MB unpacked per second while parts are built")
    test: Rate = Field(default=15, description="seconds for the tests of an image")
    carried: Rate = Field(
        default=120, description="seconds for the tests that one image of a distribution runs for the others"
    )
