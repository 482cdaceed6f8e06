"""Finds the rendering backend of this machine, without a screen.

MuJoCo renders through EGL or OSMesa, reads its choice from MUJOCO_GL while it is
imported, and reacts to a wrong choice with an AttributeError, a ctypes error or the end
of the process. So each backend is tested: it has to render 8x8 pixels in its own
process, and MUJOCO_GL is set only to one that succeeded.

The result is stored in PROCTOR_GL, which child processes inherit: a server with sixteen
simulator processes tests once. This module must not import mujoco: benchmarks without
cameras have to work on machines without graphics.

`python -m reference_sim.mujoco.rendering` prints the backend, or what to install.
"""

from __future__ import annotations

import os
import subprocess
import sys

BACKENDS = ("egl", "osmesa")  # EGL first: Mesa 25.1 dropped OSMesa
APT_COMMAND = "apt-get install libegl1 libopengl0 libgl1-mesa-dri"

_FOUND = "PROCTOR_GL"  # a backend's name, or "none" and why
_PROBE_TIMEOUT_S = 60
_PROBE = """
import mujoco

model = mujoco.MjModel.from_xml_string(
    "<mujoco><worldbody><light pos='0 0 3'/><geom size='1'/></worldbody></mujoco>"
)
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
with mujoco.Renderer(model, 8, 8) as renderer:
    renderer.update_scene(data)
    assert renderer.render().any(), "drew a black picture"
"""


class RenderingUnavailable(RuntimeError):
    """No backend renders without a screen; the text is one line with the remedy."""


def find_backend() -> str:
    """The backend of this machine, exported as MUJOCO_GL before mujoco is imported.

    Takes 0.3 s the first time in a tree of processes.
    Raises RenderingUnavailable, with MUJOCO_GL removed, if there is none.
    """
    backend = os.environ.get(_FOUND) or _probe_backends()
    os.environ[_FOUND] = backend
    if backend in BACKENDS:
        os.environ["MUJOCO_GL"] = backend
        return backend
    os.environ.pop("MUJOCO_GL", None)
    raise RenderingUnavailable(
        f"cameras need headless OpenGL ({backend}): {APT_COMMAND}; without root, a "
        "module of the cluster or an environment of conda that has libEGL, in "
        "LD_LIBRARY_PATH"
    )


def _probe_backends() -> str:
    preferred = os.environ.get("MUJOCO_GL", "").strip().lower()
    failures = []
    for backend in sorted(BACKENDS, key=lambda name: name != preferred):
        failure = _failure_of(backend)
        if failure is None:
            return backend
        failures.append(f"{backend}: {failure}")
    return "none; " + "; ".join(failures)


def _failure_of(backend: str) -> str | None:
    """Renders in its own process: None on success, else the reason, in one line."""
    try:
        probe = subprocess.run(
            [sys.executable, "-c", _PROBE],
            env={**os.environ, "MUJOCO_GL": backend},
            capture_output=True,
            text=True,
            check=False,
            timeout=_PROBE_TIMEOUT_S,
        )
    except subprocess.TimeoutExpired:
        return f"no image rendered within {_PROBE_TIMEOUT_S} s"
    if probe.returncode == 0:
        return None
    error_lines = probe.stderr.strip().splitlines() or [f"exit {probe.returncode}"]
    return error_lines[-1][:120]


def main() -> None:
    try:
        sys.stdout.write(f"{find_backend()}\n")
    except RenderingUnavailable as unavailable:
        sys.exit(str(unavailable))  # on stderr, with exit code 1


if __name__ == "__main__":
    main()
