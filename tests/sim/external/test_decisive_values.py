"""A simulator reports a truth or a number of a score or an end, or it is a fault."""

import subprocess
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

from reference_sim.external import LIBRARIES
from reference_sim.external.program import Program
from reference_sim.external.simulator_messages import EpisodeBegun, StepDone, read_reply
from reference_sim.interface import ProgramFault, number_of, truth_of
from tests.support.sim.breakable_simulator import proctor_simulator

TRUTHS: list[tuple[Any, bool]] = [
    (True, True),
    (False, False),
    (1, True),
    (0, False),
    (1.0, True),
    (0.0, False),
    (-0.0, False),
    (np.True_, True),
    (np.int64(0), False),
    (np.float32(1), True),
    (np.array(False), False),
    (np.array(1.0), True),
]
NO_TRUTHS: list[Any] = [
    *("no", "False", "", "1", b"", b"\x00"),
    *(None, (), [], [False], {}, {"goal": False}, {True}, ..., bool),
    *(0.3, 2, -1, 1e-300, float("nan"), float("inf"), 1j),
    *(np.float32(0.3), np.float64("nan"), np.array(2), np.array("no"), np.str_("1")),
    *(np.array([False]), np.array([[True]]), np.array([False, False]), np.array([])),
]
NUMBERS: list[tuple[Any, float]] = [
    *((0.25, 0.25), (-3, -3.0), (True, 1.0)),
    *((np.float32(0.5), 0.5), (np.int8(-1), -1.0), (np.array(2.5), 2.5)),
    (np.bool_(True), 1.0),
]
NO_NUMBERS: list[Any] = [
    *("0.5", b"1", None, [], [0.5], {"reward": 1.0}, 1j, ...),
    *(np.array([0.5]), np.array([0.5, 0.5]), np.array("0.5"), np.complex64(1)),
]
NOT_FINITE = [float("nan"), float("inf"), np.float32("-inf"), np.array(np.nan)]


def library_step(**members: Any) -> dict[str, Any]:
    """The reply of the library for Python to a step with these members."""

    class World(proctor_simulator.Simulator):
        def step(self, action: Any) -> dict[str, Any]:
            return {"state": {}, "success": False, **members}

    session = proctor_simulator._Session(World())
    session._is_reset = True
    answer: dict[str, Any] = session.answer({"call": "step", "action": {}})
    return answer


@pytest.mark.parametrize(("value", "truth"), TRUTHS, ids=repr)
def test_a_truth_is_a_truth(value: Any, truth: bool) -> None:
    assert truth_of(value, "success") is truth
    assert library_step(success=value)["success"] is truth
    assert library_step(terminated=value)["terminated"] is truth


@pytest.mark.parametrize("value", NO_TRUTHS, ids=repr)
def test_every_other_value_is_no_truth(value: Any) -> None:
    kind = type(value).__name__
    said = rf"success is .* \({kind}\), and must be true or false, or 0 or 1"
    with pytest.raises(ValueError, match=said):
        truth_of(value, "success")
    assert f"({kind}), and must be true" in library_step(success=value)["fault"]
    assert "terminated is " in library_step(terminated=value)["fault"]


@pytest.mark.parametrize(("value", "number"), NUMBERS, ids=repr)
def test_a_number_is_a_number(value: Any, number: float) -> None:
    done = library_step(reward=value, score=value)
    found = [number_of(value, "reward"), done["reward"], done["score"]]
    assert [(type(n), n) for n in found] == [(float, number)] * 3


def test_a_score_of_none_is_a_score_not_given() -> None:
    assert library_step(score=None) == library_step()


@pytest.mark.parametrize("value", [*NO_NUMBERS, *NOT_FINITE], ids=repr)
def test_every_other_value_is_no_number(value: Any) -> None:
    """The library leaves it to the server whether a number is finite."""
    with pytest.raises(ValueError, match=r"reward is .*, and must be a finite number"):
        number_of(value, "reward")
    done = library_step(reward=value)
    assert ("fault" in done) is not any(value is given for given in NOT_FINITE)


def test_a_shown_value_is_one_short_line() -> None:
    with pytest.raises(ValueError, match="success is") as raised:
        truth_of(np.zeros((40, 40)), "success")
    assert len(str(raised.value)) < 150
    assert "\n" not in str(raised.value)


@pytest.mark.parametrize(
    ("member", "value", "said"),
    [
        ("success", "no", "Expected `bool`, got `str` - at `$.success`: 'no'"),
        ("success", 1, "Expected `bool`, got `int` - at `$.success`: 1"),
        ("terminated", [], "Expected `bool`, got `array` - at `$.terminated`: []"),
        ("reward", "1", "Expected `float`, got `str` - at `$.reward`: '1'"),
        ("score", True, "Expected `float | null`, got `bool` - at `$.score`: True"),
    ],
)
def test_the_server_reads_no_other_value(member: str, value: Any, said: str) -> None:
    reply = {"number": 1, "state": {}, "success": False, member: value}
    with pytest.raises(msgspec.ValidationError) as raised:
        read_reply(msgspec.msgpack.encode(reply), StepDone, 1)
    assert str(raised.value) == said


@pytest.mark.parametrize(
    ("written", "read", "place"),
    [
        (b"Reach", b"Re\xffch", "`$.instruction` is not UTF-8: 0xff at byte 2"),
        (b"grasped", b"\xe9rasped", "`$.stages[1]` is not UTF-8: 0xe9 at byte 0"),
        (b"joints", b"joint\xff", "`$.state` is not UTF-8: 0xff at byte 5"),
    ],
)
def test_a_text_that_is_not_utf_8_is_named(
    written: bytes, read: bytes, place: str
) -> None:
    reply = {"number": 1, "instruction": "Reach", "state": {"joints": [0.5]}}
    body = msgspec.msgpack.encode(reply | {"stages": ["touched", "grasped"]})
    with pytest.raises(msgspec.DecodeError) as raised:
        read_reply(body.replace(written, read), EpisodeBegun, 1)
    assert str(raised.value) == place


# A truth is read as a bool, in every way in which a bool is.
CPP_USES = """
Result made(bool near) { return {State{}, near, near, 0.5}; }
Result empty() { return {State{}}; }
bool read(Result& result, bool is_known) {
  bool held = is_known ? result.success : false;
  const bool done = is_known ? true : result.terminated;
  result.success = is_known ? result.success : false;
  result.terminated = is_known ? result.success : result.terminated;
  result.terminated = result.success || done;
  result.success = result.terminated;
  result.reward = result.success ? 1.0 : 0.0;
  if (!result.success && held) return result.terminated;
  return is_known ? result.success : false;
}
"""


CPP_CRASHES = """
#include "proctor_simulator.hpp"
struct World : proctor_simulator::Simulator {
  proctor_simulator::Value benchmark() override {
    std::printf("%s", "printed by C and ");
    std::cout << "by C++\\n";
    std::abort();
  }
  proctor_simulator::Beginning reset(const std::string&, std::uint64_t,
                                     const std::string&) override { return {}; }
  proctor_simulator::StepResult step(const proctor_simulator::NumbersByName&) override {
    return {};
  }
};
int main() {
  World world;
  return proctor_simulator::serve(world);
}
"""


@pytest.mark.slow("compiles")
def test_the_last_print_of_cpp_before_a_crash_is_in_the_fault(tmp_path: Path) -> None:
    (tmp_path / "crash.cpp").write_text(CPP_CRASHES)
    command = ["c++", "-std=c++17", f"-I{LIBRARIES}", "crash.cpp", "-o", "crash"]
    subprocess.run(command, cwd=tmp_path, check=True)
    said = "crash ended by SIGABRT; its last line: printed by C and by C\\+\\+"
    with pytest.raises(ProgramFault, match=said):
        Program(["./crash"], str(tmp_path))


@pytest.mark.slow("compiles")
def test_cpp_takes_nothing_but_a_bool(tmp_path: Path) -> None:
    """What C++ would convert to a bool does not compile, but what stands for one."""
    kinds = (
        *("double", "float", "int", "unsigned char", "const char*", "std::nullptr_t"),
        *("std::atomic<double>", "std::optional<bool>", "std::shared_ptr<int>"),
    )
    proxies = ("std::vector<bool>::reference", "std::atomic<bool>&", "std::true_type")
    refused = "".join(
        f"static_assert(!std::is_assignable_v<Truth&, {kind}>);\n"
        f"static_assert(!std::is_constructible_v<Truth, {kind}>);\n"
        f"static_assert(!std::is_constructible_v<Result, State, {kind}>);\n"
        for kind in kinds
    )
    taken = "".join(
        f"static_assert(std::is_assignable_v<Truth&, {kind}>);\n"
        f"static_assert(std::is_constructible_v<Result, State, {kind}>);\n"
        for kind in ("bool", *proxies)
    )
    source = tmp_path / "truths.cpp"
    source.write_text(
        '#include "proctor_simulator.hpp"\n'
        "#include <type_traits>\n"
        "using proctor_simulator::Truth;\n"
        "using Result = proctor_simulator::StepResult;\n"
        "using State = proctor_simulator::NumbersByName;\n"
        f"{refused}{taken}{CPP_USES}"
        "static_assert(std::is_same_v<decltype(Result::success), Truth>);\n"
        "static_assert(std::is_same_v<decltype(Result::terminated), Truth>);\n"
    )
    command = ["c++", "-std=c++17", "-fsyntax-only", f"-I{LIBRARIES}", str(source)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("drawn", "fault"),
    [
        (np.zeros((6, 8, 3), np.uint8), None),
        (bytes(144), None),
        (
            np.zeros((6, 8, 3)),
            "draw of 'top' returned float64, and uint8 (6, 8, 3) is needed: (255 * pi",
        ),
        (np.zeros((6, 8, 3), np.int8), "returned int8, and uint8 (6, 8, 3) is needed"),
        (np.zeros((8, 6, 3), np.uint8), "returned (8, 6, 3), and (6, 8, 3) is needed"),
        (None, "World has no draw(camera, width, height), which `images` of its bench"),
    ],
)
def test_the_library_says_what_is_wrong_with_an_image(
    drawn: Any, fault: str | None
) -> None:
    class World(proctor_simulator.Simulator):
        benchmark = {"observation_space": {"images": {"top": {"channels": 3}}}}  # noqa: RUF012
        if drawn is not None:

            def draw(self, camera: str, width: int, height: int) -> Any:
                return drawn

    session = proctor_simulator._Session(World())
    session._is_reset = True
    request = {"call": "observe", "images": ["top"], "width": 8, "height": 6}
    reply: dict[str, Any] = session.answer(request)
    if fault is None:
        assert reply["images"]["top"]["shape"] == [6, 8, 3]
    else:
        assert fault in reply["fault"]


def test_a_class_in_the_place_of_an_object_is_named() -> None:
    with pytest.raises(TypeError, match=r"needs an object: serve\(Simulator\(\)\)"):
        proctor_simulator.serve(proctor_simulator.Simulator)  # type: ignore[arg-type]
