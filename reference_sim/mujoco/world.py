"""The only module that imports MuJoCo: a physical world with parts found by name.

Nothing here knows of a task, a robot or a policy. mujoco comes without types, so `Any`
ends in this file: everything public takes and returns plain numbers and NumPy arrays.

Three things that are not obvious, all measured:

- mujoco is imported when the first world is made, with graphics switched off, because
  `import mujoco` fails when MUJOCO_GL names a backend this machine lacks. Graphics are
  switched on by the first image.
- A snapshot holds the solver's warm start. `mj_forward` overwrites it in MuJoCo 3.3
  (4.0 leaves it alone), so a restored state is set twice, around `mj_forward`; the
  continuation is then exact to the bit.
- An EGL context belongs to the thread that made it: a world draws in one thread only,
  and a process that has drawn must not fork (spawn instead).
"""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reference_sim.mujoco import rendering
from reference_sim.shared_frame_buffer import FRAME_BUFFER

Vector = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Quality:
    """Rendering quality; it changes pixels and thereby scores.

    samples: anti-aliasing samples per pixel. shadow_map: its side in texels.
    slices, stacks: of round shapes.
    """

    shadows: bool
    samples: int
    shadow_map: int
    slices: int
    stacks: int


QUALITIES = {
    "fast": Quality(shadows=False, samples=0, shadow_map=512, slices=16, stacks=8),
    "standard": Quality(shadows=True, samples=4, shadow_map=2048, slices=28, stacks=16),
}


class SimulationDiverged(RuntimeError):
    """The integrator met invalid numbers; the state is unusable."""


class World:
    """A model, its state and its rendered images."""

    def __init__(self, mjcf: str, quality: str = "fast") -> None:
        """mjcf: the model's XML text. quality: a key of QUALITIES."""
        self._mj = _mujoco()
        self._quality = QUALITIES[quality]
        self._model = self._mj.MjModel.from_xml_string(mjcf)
        self._data = self._mj.MjData(self._model)
        self._renderers: dict[tuple[int, int], Any] = {}
        self._addresses: dict[tuple[str, ...], NDArray[np.intp]] = {}
        self._originals: dict[str, NDArray[Any]] = {}  # of the model's edited fields
        # All that the future depends on, and how many numbers that is.
        self._state_kind = self._mj.mjtState.mjSTATE_INTEGRATION
        self._state_size = self._mj.mj_stateSize(self._model, self._state_kind)
        warning = self._mj.mjtWarning
        self._divergences = [
            int(warning.mjWARN_BADQPOS),
            int(warning.mjWARN_BADQVEL),
            int(warning.mjWARN_BADQACC),
        ]
        visual = self._model.vis.quality
        visual.offsamples = self._quality.samples
        visual.shadowsize = self._quality.shadow_map
        visual.numslices = self._quality.slices
        visual.numstacks = self._quality.stacks
        self.forward()

    # Time

    @property
    def timestep_s(self) -> float:
        return float(self._model.opt.timestep)

    def reset(self) -> None:
        """The model's initial state, warm start included; call `forward` when set.

        Edits of the model are undone.
        """
        for field, original in self._originals.items():
            getattr(self._model, field)[:] = original
        self._mj.mj_resetData(self._model, self._data)

    def forward(self) -> None:
        """Brings poses and contacts in line with the joint positions."""
        self._mj.mj_forward(self._model, self._data)

    def forward_poses(self) -> None:
        """The cheap part of `forward`: poses and Jacobians, no contacts."""
        self._mj.mj_kinematics(self._model, self._data)
        self._mj.mj_comPos(self._model, self._data)

    def advance(self, steps: int) -> None:
        """Integrates; the poses read afterwards belong to the new state."""
        self._mj.mj_step(self._model, self._data, nstep=steps)
        self.forward()
        # MuJoCo restarts a diverged world by itself; an episode must not survive that.
        if self._data.warning.number[self._divergences].any():
            raise SimulationDiverged(f"at {self._data.time:.3f} s")

    def snapshot(self) -> Vector:
        """All that the future depends on."""
        state = np.empty(self._state_size)
        self._mj.mj_getState(self._model, self._data, state, self._state_kind)
        return state

    def restore(self, state: Vector) -> None:
        """Continues from a snapshot of a world of the same model, exactly.

        Edits of the model are not in a snapshot: make them first.
        """
        self._mj.mj_setState(self._model, self._data, state, self._state_kind)
        self.forward()
        self._mj.mj_setState(self._model, self._data, state, self._state_kind)

    # Joints and actuators

    def joint_ranges(self, joints: tuple[str, ...]) -> Vector:
        """(n, 2): lowest and highest position, rad or m."""
        ranges = [self._model.joint(joint).range for joint in joints]
        return np.array(ranges, dtype=np.float64)

    def joint_positions(self, joints: tuple[str, ...]) -> Vector:
        """(n,), rad or m, of joints with one degree of freedom."""
        positions: Vector = self._data.qpos[self._qpos_addresses(joints)]
        return positions

    def set_joint_positions(
        self, joints: tuple[str, ...], positions: Sequence[float] | Vector
    ) -> None:
        """Sets without passing time; call `forward` when everything is set."""
        self._data.qpos[self._qpos_addresses(joints)] = positions

    def set_free_pose(self, joint: str, pose: Sequence[float] | Vector) -> None:
        """Moves the body of a free joint: position, quaternion wxyz, world frame."""
        start = int(self._model.joint(joint).qposadr[0])
        self._data.qpos[start : start + 7] = pose

    def set_mocap_pose(self, body: str, pose: Sequence[float] | Vector) -> None:
        """Moves a mocap body, which nothing else moves: position, quaternion wxyz."""
        mocap = self._data.mocap_pos, self._data.mocap_quat
        index = int(self._model.body(body).mocapid[0])
        mocap[0][index], mocap[1][index] = pose[:3], pose[3:]

    def controls(self) -> Vector:
        """The last targets of all actuators, in the model's order; a copy."""
        controls: Vector = self._data.ctrl.copy()
        return controls

    def set_controls(self, controls: Sequence[float] | Vector) -> None:
        """All actuators, in the model's order; beyond their range they saturate."""
        self._data.ctrl[:] = controls

    # Bodies

    def body_pose(self, body: str) -> Vector:
        """(7,): position in m and quaternion wxyz, world frame."""
        view = self._data.body(body)
        return np.concatenate([view.xpos, view.xquat])

    def body_error(self, body: str, pose: Vector) -> Vector:
        """(6,): the way from the body to a pose, m and rotation vector, world."""
        view = self._data.body(body)
        back, turn, rotation = np.empty(4), np.empty(4), np.empty(3)
        self._mj.mju_negQuat(back, view.xquat)
        self._mj.mju_mulQuat(turn, pose[3:], back)
        self._mj.mju_quat2Vel(rotation, turn, 1.0)
        return np.concatenate([pose[:3] - view.xpos, rotation])

    def bodies_touch(self, first: str, second: str) -> bool:
        pair = {self._model.body(first).id, self._model.body(second).id}
        bodies = self._model.geom_bodyid[self._data.contact.geom]
        return any(set(touching) == pair for touching in bodies.tolist())

    def body_jacobian(self, body: str, joints: tuple[str, ...]) -> Vector:
        """(6, n): velocity and angular velocity per joint velocity, world frame."""
        jacobian = np.empty((6, self._model.nv))
        self._mj.mj_jacBody(
            self._model,
            self._data,
            jacobian[:3],
            jacobian[3:],
            self._model.body(body).id,
        )
        columns = [int(self._model.joint(joint).dofadr[0]) for joint in joints]
        return jacobian[:, columns]

    # Edits of the model, undone by `reset`

    def set_gravity_compensation(self, body: str, share: float) -> None:
        """The compensated share of a body's weight: 1 floats, 0 falls."""
        self._edit("body_gravcomp")[self._model.body(body).id] = share

    def scale_body(self, body: str, factor: float) -> None:
        """Makes a free body of one geom larger or smaller; its mass stays."""
        index = self._model.body(body).id
        geom = int(self._model.body_geomadr[index])
        for length in ("geom_size", "geom_rbound", "geom_aabb"):
            self._edit(length)[geom] *= factor
        self._edit("bvh_aabb")[int(self._model.body_bvhadr[index])] *= factor
        turning = int(self._model.body_dofadr[index]) + 3
        self._edit("body_inertia")[index] *= factor**2
        self._edit("dof_M0")[turning : turning + 3] *= factor**2
        self._edit("body_invweight0")[index, 1] /= factor**2
        self._edit("dof_invweight0")[turning : turning + 3] /= factor**2

    def set_geom_rgba(self, geom: str, rgba: Sequence[float]) -> None:
        """Colours a geom; a texture of its material shows through."""
        self._edit("geom_rgba")[self._model.geom(geom).id] = rgba

    def set_camera_position(
        self, camera: str, position: Sequence[float] | Vector
    ) -> None:
        """Metres, in the frame of the body that carries the camera."""
        self._edit("cam_pos")[self._model.camera(camera).id] = position

    def set_light(
        self,
        light: str,
        direction: Sequence[float] | Vector,
        diffuse: Sequence[float] | Vector,
    ) -> None:
        """direction: where it shines, unit length. diffuse: red, green, blue."""
        index = self._model.light(light).id
        self._edit("light_dir")[index] = direction
        self._edit("light_diffuse")[index] = diffuse

    def _edit(self, field: str) -> Any:
        """A field of the model to write into; its old value is kept for `reset`."""
        values = getattr(self._model, field)
        self._originals.setdefault(field, values.copy())
        return values

    # Rendering

    def render(self, camera: str, width: int, height: int) -> NDArray[np.uint8]:
        """(height, width, 3) RGB, row 0 on top; rendered into the frame buffer.

        Raises RenderingUnavailable without a backend.
        """
        renderer = self._renderers.get((width, height))
        if renderer is None:
            renderer = self._new_renderer(width, height)
            self._renderers[width, height] = renderer
        renderer.update_scene(self._data, camera)
        picture: NDArray[np.uint8] = renderer.render(
            out=FRAME_BUFFER.allocate(height, width)
        )
        return picture

    def body_at(self, camera: str, spot: Sequence[float], aspect: float) -> str | None:
        """The body visible at a point of an image, by ray casting, without rendering.

        spot: x to the right and y down, (0, 0) to (1, 1). aspect: width over height.
        """
        eye, turned, half = self._camera(camera)
        right, down = (2 * spot[0] - 1) * half * aspect, (2 * spot[1] - 1) * half
        ray, hit = turned @ np.array([right, -down, -1.0]), np.empty(1, np.int32)
        geom_groups = np.array(
            [1, 1, 1, 0, 0, 0], np.uint8
        )  # the groups that are drawn
        self._mj.mj_ray(self._model, self._data, eye, ray, geom_groups, 1, -1, hit)
        if hit[0] < 0:
            return None
        return str(self._model.body(self._model.geom_bodyid[hit[0]]).name)

    def spot_of(
        self, camera: str, position: Sequence[float] | Vector, aspect: float
    ) -> tuple[float, float]:
        """The image coordinates of a point in front of the camera; see `body_at`."""
        eye, turned, half = self._camera(camera)
        right, up, back = turned.T @ (np.asarray(position) - eye)
        x, y = right / -back / half / aspect, up / back / half
        return float((x + 1) / 2), float((y + 1) / 2)

    def _camera(self, camera: str) -> tuple[Vector, Vector, float]:
        """Position, rotation matrix, and the tangent of half its height's angle."""
        index = self._model.camera(camera).id
        half = float(np.tan(np.radians(self._model.cam_fovy[index]) / 2))
        turned = self._data.cam_xmat[index].reshape(3, 3)
        return self._data.cam_xpos[index], turned, half

    def close(self) -> None:
        """Free the renderers; the world may still be stepped."""
        while self._renderers:
            self._renderers.popitem()[1].close()

    def _new_renderer(self, width: int, height: int) -> Any:
        draw = _renderer_class()
        # The size of the offscreen buffer: memory is reserved per renderer.
        self._model.vis.global_.offwidth = width
        self._model.vis.global_.offheight = height
        renderer = draw(self._model, height, width)
        shadow = self._mj.mjtRndFlag.mjRND_SHADOW
        renderer.scene.flags[shadow] = self._quality.shadows
        return renderer

    def _qpos_addresses(self, joints: tuple[str, ...]) -> NDArray[np.intp]:
        if joints not in self._addresses:
            self._addresses[joints] = np.array(
                [int(self._model.joint(joint).qposadr[0]) for joint in joints]
            )
        return self._addresses[joints]


@cache
def _mujoco() -> Any:
    """mujoco, imported without loading any graphics library."""
    exported = os.environ.get("MUJOCO_GL")
    os.environ["MUJOCO_GL"] = "disabled"
    try:
        return importlib.import_module("mujoco")
    finally:
        if exported is None:
            del os.environ["MUJOCO_GL"]
        else:
            os.environ["MUJOCO_GL"] = exported


@cache
def _renderer_class() -> Any:
    """mujoco's renderer, once graphics are switched on."""
    rendering.find_backend()
    mujoco = _mujoco()
    # The renderer asks this module for its context, and this module reads MUJOCO_GL
    # while it is loaded: that is the switch.
    importlib.reload(sys.modules[mujoco.Renderer.__module__].gl_context)
    return mujoco.Renderer
