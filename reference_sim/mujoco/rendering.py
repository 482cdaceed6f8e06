"""Finds out what draws pictures on this machine, without a screen.

MuJoCo draws through EGL or OSMesa, takes its choice from MUJOCO_GL while it is being
imported, and answers a wrong choice with an AttributeError, a ctypes error or the end
of the process. So nothing is guessed here: each backend has to draw 8x8 pixels in a
process of its own, and MUJOCO_GL is set only to one that did.

The answer is kept in PROCTOR_GL, which child processes inherit: a server with sixteen
simulator processes looks once. This file must not import mujoco: state-only use has to
work where nothing can be drawn.

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
    """Nothing here can draw without a screen; the text is one line with the remedy."""


def find_backend() -> str:
    """The backend that draws here, exported as MUJOCO_GL for mujoco to come.

    Costs a third of a second the first time in a tree of processes, nothing after.
    Raises RenderingUnavailable, with MUJOCO_GL removed, if there is none.
    """
    found = os.environ.get(_FOUND) or _probe_backends()
    os.environ[_FOUND] = found
    if found in BACKENDS:
        os.environ["MUJOCO_GL"] = found
        return found
    os.environ.pop("MUJOCO_GL", None)
    raise RenderingUnavailable(
        f"cameras need OpenGL without a screen ({found}): {APT_COMMAND}"
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
    """Draws in a process of its own: None if that worked, else why not, in one line."""
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
        return f"no picture within {_PROBE_TIMEOUT_S} s"
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
