"""The CycloneDX bill of materials of a wheel, made from its lock.

It names the wheel by its hash, every locked package with the hashes that may be
installed, which package requires which, and scripts of third parties inside the wheel.
The same wheel and lock give the same bytes.
"""

import re
import uuid
import zipfile
from collections.abc import Iterator, Mapping
from datetime import UTC, datetime
from pathlib import Path

from cyclonedx.model import (
    ExternalReference,
    ExternalReferenceType,
    HashAlgorithm,
    HashType,
    Property,
    XsUri,
)
from cyclonedx.model.bom import Bom
from cyclonedx.model.component import Component, ComponentType
from cyclonedx.model.license import LicenseExpression
from cyclonedx.output.json import JsonV1Dot6
from packageurl import PackageURL

from tools.distributions.locks import LockedPackage, parse_lock
from tools.distributions.staging import VERSION, Distribution
from tools.locks.complete import complete_lock

# `htmx.min.js: htmx.org 2.0.8, Zero-Clause BSD`
_SCRIPT = re.compile(r"(?m)^\S.*\.(?:js|css): (?P<name>\S+) (?P<version>[\d.]+), .+$")


def write_bill(
    distribution: Distribution, wheel: Path, sha256: str, epoch: int, to: Path
) -> None:
    """Write it as CycloneDX 1.6 in JSON; `epoch` is the time in seconds since 1970."""
    subject = _component(distribution.name, VERSION, sha256=[sha256])
    subject.licenses.add(LicenseExpression("Apache-2.0"))
    bill = Bom(serial_number=uuid.uuid5(uuid.NAMESPACE_URL, sha256))
    bill.metadata.component = subject
    bill.metadata.timestamp = datetime.fromtimestamp(epoch, UTC)
    packages = parse_lock(complete_lock(distribution.lock))
    found = [(package, _locked(package)) for package in packages]
    names = [name for name in distribution.requires if not name.endswith(".in")]
    ours = [_component(name, VERSION) for name in names]
    scripts = list(_scripts(wheel))
    for component in [*ours, *scripts, *(component for _, component in found)]:
        bill.components.add(component)
    bill.register_dependency(subject, [*ours, *scripts])
    _add_dependencies(bill, subject, found)
    text = JsonV1Dot6(bill).output_as_string(indent=1)
    to.write_text(text + "\n", encoding="utf-8")


def _add_dependencies(
    bill: Bom, subject: Component, found: list[tuple[LockedPackage, Component]]
) -> None:
    components: Mapping[str, list[Component]] = {
        package.name: [c for other, c in found if other.name == package.name]
        for package, _ in found
    }
    for package, component in found:
        for name in package.required_by:
            if name.startswith("-r "):
                bill.register_dependency(subject, [component])
            for parent in components.get(name.partition("[")[0], []):
                bill.register_dependency(parent, [component])


def _locked(package: LockedPackage) -> Component:
    component = _component(package.name, package.version)
    component.external_references.add(
        ExternalReference(
            type=ExternalReferenceType.DISTRIBUTION,
            url=XsUri(str(component.purl)),
            comment="any file with one of these hashes",
            hashes=[_sha256(digest) for digest in package.hashes],
        )
    )
    if package.marker:
        marker = Property(name="python:environment-marker", value=package.marker)
        component.properties.add(marker)
    return component


def _scripts(wheel: Path) -> Iterator[Component]:
    with zipfile.ZipFile(wheel) as packed:
        for name in packed.namelist():
            if name.endswith("static/vendor/NOTICE.txt") and ".dist-info" not in name:
                for line in _SCRIPT.finditer(packed.read(name).decode()):
                    yield _component(line["name"], line["version"], kind="npm")


def _component(
    name: str, version: str, *, kind: str = "pypi", sha256: list[str] | None = None
) -> Component:
    purl = PackageURL(kind, name=name, version=version)
    return Component(
        name=name,
        version=version,
        type=ComponentType.LIBRARY,
        purl=purl,
        bom_ref=str(purl),
        hashes=[_sha256(digest) for digest in sha256 or ()],
    )


def _sha256(digest: str) -> HashType:
    return HashType(alg=HashAlgorithm.SHA_256, content=digest)
