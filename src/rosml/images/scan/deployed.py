"""What was deployed of a component: its file and hash, as BSI's TR-03183-2 v2.1.0 asks, with the names of its taxonomy:
https://github.com/BSI-Bund/tr-03183-cyclonedx-property-taxonomy

The hash is SHA-512, as BSI wants it, if there is one:

- of a .deb, what apt's signed lists say, which is SHA-256 alone in Debian's and ROS's; the .deb itself is gone when it is installed;
- of a wheel, the hash of its RECORD, which has the SHA-256 of each file. A lock has hashes of a release's files, and not which of them
  was installed; of some wheels, a part has fewer files;
- of a ROS package that an app builds, the hash of what sha512sum says of its files.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from urllib.parse import quote

from cyclonedx.model import ExternalReference, ExternalReferenceType, HashAlgorithm, HashType, XsUri

from rosml.images.scan.packages import Apt, Python, Ros

FILENAME = "bsi:component:filename"
EXECUTABLE = "bsi:component:executable"
ARCHIVE = "bsi:component:archive"
STRUCTURED = "bsi:component:structured"

NO_HASH = "io.rosml.lacks.hash"
"""The property with the reason why a component has no hash."""

_ALGORITHMS = {64: HashAlgorithm.SHA_256, 128: HashAlgorithm.SHA_512}
"""By the number of digits."""


@dataclass(frozen=True)
class Deployed:
    """The file of a component, or the folder in which it was unpacked."""

    file: str
    digest: str = ""
    place: str = ""  # of what has this hash, as a path in the image, or as a file name
    without: str = ""  # why there is no hash
    executable: bool = False

    def properties(self) -> Iterator[tuple[str, str]]:
        """Of archives, packages and folders one can list the content, so all are structured."""
        yield FILENAME, self.file
        yield EXECUTABLE, "executable" if self.executable else "non-executable"
        yield ARCHIVE, "archive" if self.file.endswith((".deb", ".whl")) else "no archive"
        yield STRUCTURED, "structured"
        if not self.digest:
            yield NO_HASH, self.without

    @property
    def hashes(self) -> list[HashType]:
        return [HashType(alg=_ALGORITHMS[len(self.digest)], content=self.digest)] if self.digest else []

    @property
    def references(self) -> list[ExternalReference]:
        """The place of what has the hash: BSI reads it there."""
        kind, hashes = ExternalReferenceType.DISTRIBUTION, self.hashes
        return [ExternalReference(type=kind, url=XsUri(self.place), hashes=hashes)] if hashes else []


SYSTEM = Deployed("os-release", without="an operating system is no file: its packages have hashes")


def of_apt(package: Apt) -> Deployed:
    version = package.version.partition(":")[2] or package.version
    file = f"{package.name}_{version}_{package.architecture}.deb"
    return Deployed(file, package.digest, quote(file), "no list of apt had its .deb when the image was built")


def of_python(wheel: Python) -> Deployed:
    return Deployed(
        wheel.file or wheel.name, wheel.digest, f"file:///{quote(wheel.record)}", "it was installed without RECORD"
    )


def of_ros(package: Ros) -> Deployed:
    among_others = "its files lie among those of others, or are too many to read"
    without = "the image has its sources, and nothing that was built of them" if package.is_source else among_others
    return Deployed(package.name, package.digest, f"file:///{quote(package.folder)}", without, package.executable)
