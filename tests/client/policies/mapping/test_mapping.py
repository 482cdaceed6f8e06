"""Mappings and references: what a third-party policy receives and returns.

The ready mappings are those of the manual. Two are played through a real
server by a policy that holds still in its own words and checks what it is given.
"""

import io
import re
import tomllib
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import msgspec
import numpy as np
import PIL.Image
import pytest
from proctor_client import Action, ImageChoice, PolicyInfo, Predict, SubmitRun

from reference_client import Observation, ProctorError
from reference_client.api.observation import observation_of
from reference_client.api.policy import chunk_of
from reference_client.evaluation.status_board import StatusBoard
from reference_client.generated import messages
from reference_client.policies import BadPolicy, PolicyMapping, load
from reference_client.policies.image_resize import resize_picture
from reference_client.policies.mapping import (
    ActionVector,
    InvalidPolicyAnswer,
    RequestEntry,
)
from reference_client.policies.policy_loader import _MappedPolicy
from reference_client.policies.servers.server_transport import reporting_repeats
from tests.support.client.command import Proctor
from tests.support.client.direct_client import DirectClient
from tests.support.paths import ROOT
from tests.support.servers import ReferenceServer

PAGES = (ROOT / "docs" / "evaluate" / "policies").glob("polic*.md")
PAGE = "".join(page.read_text() for page in PAGES)
READY = {
    re.findall(r"# (\w+)\.toml", text)[0]: tomllib.loads(text)
    for text in re.findall(r"```toml\n(.*?)```", PAGE, re.DOTALL)
}
SEEN = Observation(
    state={"joint_position": np.array([0.1, 0.2, 0.3]), "gripper": np.array([0.25])},
    images={"front": np.full((4, 8, 3), 255, np.uint8)},
    tensors={"depth": np.ones((2, 3), np.float16)},
    instruction="Lift.",
    episode_id="e0001",
    step=3,
)


def mapping(
    values: str = "a = {}", observation: str = "k = { value = 1 }"
) -> PolicyMapping:
    text = f"[observation]\n{observation}\n[action]\nfrom = 'out'\n[action.values]\n"
    return PolicyMapping.of(tomllib.loads(text + values))


def request(entry: str) -> Any:
    return mapping(observation=f"k = {{ {entry} }}").request(SEEN)["k"]


def rows(vector: str, out: Any) -> list[list[float]]:
    chunk = mapping(f"a = {{ {vector} }}").chunk({"out": out}, SEEN)
    return [np.asarray(action["a"]).tolist() for action in chunk]


# The request


@pytest.mark.parametrize(
    ("entry", "value"),
    [
        ("from = 'instruction'", "Lift."),
        ("from = 'instruction', leading = 1", ["Lift."]),
        ("from = 'step'", 3),
        ("from = 'first_step'", False),
        ("from = 'episode_id'", "e0001"),
        ("value = 'lift2'", "lift2"),
        ("from = 'step', scale = 50_000_000", 150_000_000),
        ("from = 'step', scale = 0.05, offset = 1", 1.15),
        ("from = 'attempt_id'", "dry-e0001"),
        ("value = [1, 2], encode = 'json'", "[1,2]"),
        ("from = 'state.gripper', encode = 'json'", "[0.25]"),
        (
            "from = 'state.gripper', encode = 'json-numpy'",
            '{"__numpy__":"AACAPg==","dtype":"<f4","shape":[1]}',
        ),
    ],
)
def test_text_entries_and_constants_are_mapped(entry: str, value: Any) -> None:
    assert request(entry) == value


@pytest.mark.parametrize(
    ("entry", "value"),
    [
        ("from = 'state.joint_position'", [0.1, 0.2, 0.3]),
        ("from = ['state.joint_position', 'state.gripper']", [0.1, 0.2, 0.3, 0.25]),
        ("from = 'state.joint_position', take = '1:3'", [0.2, 0.3]),
        ("from = 'state.joint_position', take = [2, 0]", [0.3, 0.1]),
        ("from = 'state.gripper', scale = -1, offset = 1", [0.75]),
        ("from = 'state.joint_position', scale = [1, 2, 0]", [0.1, 0.4, 0.0]),
        ("from = 'state.gripper', leading = 2", [[[0.25]]]),
    ],
)
def test_state_vectors_are_mapped(entry: str, value: Any) -> None:
    """Expect float32, which is what policies are trained on; and what is asked for."""
    given = request(entry)
    assert given.dtype == np.float32
    assert given.tolist() == np.asarray(value, np.float32).tolist()
    assert request(f"{entry}, dtype = 'float64'").dtype == np.float64


def test_images_are_resized_and_converted() -> None:
    """A wide white picture into a square. Expect bars above and below."""
    picture = request("from = 'images.front', resize = [8, 8]")
    assert (picture.shape, picture.dtype) == ((8, 8, 3), np.uint8)
    assert picture[:, 0, 0].tolist() == [0, 0, 255, 255, 255, 255, 0, 0]
    flat = request("from = 'images.front', resize = [8, 8], pad = false")
    assert flat.min() == 255
    unit = "unit = true, layout = 'chw', leading = 1"
    batch = request(f"from = 'images.front', {unit}")
    assert (batch.shape, batch.dtype, batch.max()) == ((1, 3, 4, 8), np.float32, 1.0)
    assert resize_picture(SEEN.images["front"], 4, 8) is SEEN.images["front"]
    gray = resize_picture(SEEN.images["front"][:, :, :1], 2, 2)
    assert gray.shape == (2, 2, 1)


@pytest.mark.parametrize("codec", ["jpeg", "png"])
def test_an_image_may_be_a_file(codec: str) -> None:
    data = request(f"from = 'images.front', resize = [8, 8], encode = '{codec}'")
    with PIL.Image.open(io.BytesIO(data)) as picture:
        assert (picture.format, picture.size) == (codec.upper(), (8, 8))


def test_requests_nest_by_dots_without_quotes_and_by_lists() -> None:
    """Also for sources whose names have dots: there, quotes make no difference."""
    made = mapping(
        observation="""
        a.b = { from = "step" }
        "c.d" = { from = "step" }
        list = [{ from = "step" }, { x.y = { value = 1 } }]
        """
    )
    nested = {"a": {"b": 3}, "c.d": 3, "list": [3, {"x": {"y": 1}}]}
    assert made.request(SEEN) == nested
    assert list(made.flat().request(SEEN)) == ["a.b", "c.d", "list.0", "list.1.x.y"]


def test_the_id_of_an_attempt_differs_and_does_not_show_the_session() -> None:
    def attempt_id(session: str, attempt: int) -> str:
        episode = SimpleNamespace(attempt=attempt)
        turn: Any = SimpleNamespace(session_id=session, episode=episode)
        made = mapping(observation='k = { from = "attempt_id" }')
        text: str = made.request(replace(SEEN, turn=turn))["k"]
        return text

    ids = {attempt_id(s, attempt) for s in ("secret", "other") for attempt in (1, 2)}
    assert len(ids) == 4
    assert not any("secret" in text for text in ids)


def test_tensors_keep_their_dtype() -> None:
    assert request("from = 'tensors.depth'").dtype == np.float16


# The answer


@pytest.mark.parametrize(
    ("vector", "out", "chunk"),
    [
        ("", [[1, 2], [3, 4]], [[1, 2], [3, 4]]),
        ("", [1, 2], [[1, 2]]),
        ("columns = '1:2'", [[1, 2], [3, 4]], [[2], [4]]),
        ("from = 'out.1'", [[1, 2], [3, 4]], [[3, 4]]),
        ("columns = [1, 0]", [[1, 2]], [[2, 1]]),
        ("threshold = 0.5, scale = -1, offset = 1", [[0.4], [0.6]], [[1], [0]]),
        ("clip = [0, 1]", [[-1], [2]], [[0], [1]]),
        ("cumulate = true, scale = 2", [[1], [1], [2]], [[2], [4], [8]]),
        ("relative_to = 'state.gripper'", [[1], [2]], [[1.25], [2.25]]),
        ("value = [1, 2]", [[9]], [[1, 2]]),
    ],
)
def test_answers_are_mapped_to_chunks(vector: str, out: Any, chunk: Any) -> None:
    played = np.asarray(rows(vector, np.asarray(out, np.float32)))
    assert played == pytest.approx(np.asarray(chunk))


def test_a_chunk_may_be_a_list_of_dicts() -> None:
    out = [{"out": np.array([1.0])}, {"out": np.array([2.0])}]
    assert [a["a"] for a in mapping().chunk(out, SEEN)] == [[1.0], [2.0]]


def test_execute_cuts_a_chunk_and_leading_a_batch() -> None:
    table = {"leading": 1, "execute": 2, "values": {"a": {"columns": "0:1"}}}
    made = PolicyMapping.of({"observation": {"k": {"value": 1}}, "action": table})
    answer = np.arange(8.0).reshape(1, 4, 2)
    assert [a["a"] for a in made.chunk(answer, SEEN)] == [[0.0], [2.0]]


@pytest.mark.parametrize("shape", [(2, 4, 2), (4, 2)])
def test_leading_drops_no_batch_of_several(shape: tuple[int, ...]) -> None:
    table = {"leading": 1, "values": {"a": {}}}
    made = PolicyMapping.of({"observation": {"k": {"value": 1}}, "action": table})
    with pytest.raises(InvalidPolicyAnswer, match="drops dimensions of size 1 alone"):
        made.chunk(np.zeros(shape), SEEN)


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        ({"actions": [1]}, "has no out, but actions"),
        ("nothing", "The policy answered the text 'nothing', where mapping expects an"),
        (None, "The policy answered null, where mapping expects an object with `out`"),
        (
            {"out": "x"},
            "The policy answered the text 'x' in `out`, where mapp",
        ),
        ({"out": [["0.1"]]}, "a list with the text '0.1' in `out`"),
        ({"out": None}, "answered null in `out`"),
        ({"out": [[None, 1.0]]}, "a list with null in"),
        ({"out": {"x": 1}}, "an object with 'x' in"),
        ({"out": [[1.0], [1.0, 2.0]]}, "lists of different lengths in"),
        ({"out": msgspec.msgpack.Ext(1, b"")}, "a value of the type msgspec.*Ext in"),
        ({"out": np.array([["a"]])}, "an array of dtype <U1 in"),
        (
            {"out": np.zeros((1, 9, 2))},
            r"the shape \(1, 9, 2\) in `out`; .*; `leading = 1` in .* drops the first,",
        ),
        ({"out": np.zeros((1, 1, 9, 2))}, "`leading = 2` in .* drops the first 2, of"),
        ({"out": np.zeros((2, 9, 2))}, "`leading` in .* drops dimensions of size 1 "),
        ({"out": []}, "no action: `out` is empty"),
        ({"out": [[]]}, "no action: `out` is empty"),
        ({"out": np.zeros((0, 2))}, "no action: `out` is empty"),
        (
            {"out": [[1.0]]},
            '"a": columns is "0:2"; it chooses from 1 number of the answer',
        ),
    ],
)
def test_an_invalid_answer_is_a_policy_failure(answer: Any, message: str) -> None:
    """Expect what the file wanted and what came."""
    made = mapping("a = { columns = '0:2' }")
    with pytest.raises(ProctorError, match=message) as caught:
        _MappedPolicy(lambda _request: answer, made).act(SEEN)
    assert caught.value.code == "policy_failed"


def test_the_members_of_a_mapping_are_documented() -> None:
    members = {
        field.name
        for kind in (RequestEntry, ActionVector)
        for field in msgspec.structs.fields(kind)
    }
    for member in members - {"source"} | {"from", "execute", "leading"}:
        assert f"`{member}`" in PAGE, member


@pytest.mark.parametrize(
    ("arm", "grip", "played"),
    [
        (2, 2, 2),
        (1, 1, 1),
        (3, 2, "3 rows in `arm`, 2 rows in `grip`, where mapping expects a row of eac"),
        (3, 1, "3 rows in `arm`, 1 row in `grip`, where mapping expects a row of each"),
        (1, 3, "1 row in `arm`, 3 rows in `grip`, where mapping expects a row of each"),
    ],
)
@pytest.mark.parametrize(
    "vectors", ["a = { from = ['arm', 'grip'] }", "a.from = 'arm'\nb.from = 'grip'"]
)
def test_all_vectors_of_an_answer_have_as_many_rows(
    vectors: str, arm: int, grip: int, played: int | str
) -> None:
    """An answer that contradicts itself is not cut to its shortest part."""
    made = mapping(vectors)
    answer = {"arm": np.zeros((arm, 2)), "grip": np.zeros((grip, 1))}
    if isinstance(played, int):
        assert len(made.chunk(answer, SEEN)) == played
        return
    with pytest.raises(InvalidPolicyAnswer, match=f"^The policy answered {played}"):
        made.chunk(answer, SEEN)


@pytest.mark.parametrize(
    ("vectors", "shape", "notes"),
    [
        ("a.columns = '0:7'\nb.columns = '7:8'", (10, 8), []),
        ("a.columns = '0:7'", (10, 8), []),
        ("a.columns = '0:7'\nb.columns = '7:8'", (1, 9), []),
        ("a.columns = '0:8'", (10, 32), ["32 numbers; the mapping reads 8 of them."]),
        (
            "a.columns = '0:8'",
            (8, 10),
            [
                "reads 8 of them, and there are 8 rows. A chunk is answered as",
            ],
        ),
        (
            "a.columns = '0:7'\nb.columns = '7:8'",
            (1, 16),
            ["reads 8 of them. It is one row: a chunk is answered as"],
        ),
        (
            "a.columns = [0, 1, 2, 3, 4, 5, 5]\nb.columns = '7:8'",
            (10, 8),
            ["reads 7 of them, column 5 more than once, 6 never."],
        ),
        (
            "a.columns = '0:3'\nb.columns = '2:3'",
            (1, 8),
            ["column 2 more than once, 3, 4, 5, 6 … never."],
        ),
        ("a.columns = '0:3'\nb.columns = [3, 3]", (10, 4), []),
        ("a.columns = '0:3'\nb = { value = [1] }", (10, 4), []),
        (
            "a = { from = ['out', 'more'], columns = [0, 1, 8] }",
            (10, 8),
            [
                "`out` has 8 numbers; the mapping reads 2 of them.",
                "`more` has 8 numbers; the mapping reads 1 of them.",
            ],
        ),
    ],
)
def test_numbers_that_are_not_read_are_noted_once(
    vectors: str, shape: tuple[int, ...], notes: list[str]
) -> None:
    """By the first answer alone. Expect no refusal: a model may pad its rows."""
    answer = {"out": np.zeros(shape), "more": np.zeros(shape)}
    policy = _MappedPolicy(lambda _request: answer, mapping(vectors))
    board = StatusBoard()
    with reporting_repeats(board.repeat_reporter("worker-0")):
        for _ in range(2):
            assert len(policy.act(SEEN)) == shape[0]
    for warning, note in zip(board.pop_notes(), notes, strict=True):
        assert warning.startswith("warning: mapping: each row of `")
        assert note in warning


# The ready ones

DROID = """
import numpy as np

class Policy:
    def infer(self, request):
        for key in ("exterior_image_1_left", "wrist_image_left"):
            picture = request[f"observation/{key}"]
            assert (picture.shape, picture.dtype) == ((224, 224, 3), np.uint8)
        assert request["observation/joint_position"].shape == (7,)
        assert request["observation/gripper_position"].shape == (1,)
        assert request["prompt"].endswith(".")
        return {"actions": np.zeros((15, 8), np.float32)}
"""
EBENCH = """
import numpy as np

class Model:
    def __call__(self, seen):
        for name in ("top", "left", "right", "overlook"):
            assert seen[f"video.{name}_camera_view"].shape == (480, 640, 3)
        assert seen["reset"] == (seen["timestep"] == 0)
        joints, fingers = seen["state.joints"], np.zeros(2)
        arms = [joints[:6], fingers, joints[6:], fingers]
        action = {"action": np.concatenate(arms), "base_motion": np.zeros(3)}
        return [action] * 40
"""


@pytest.mark.parametrize(
    ("name", "source", "reference"),
    ids=["droid", "ebench"],
    argvalues=[("droid", DROID, "droid:Policy"), ("ebench", EBENCH, "ebench:Model")],
)
def test_a_documented_mapping_plays_a_turn(
    direct: DirectClient, policy_folder: Path, name: str, source: str, reference: str
) -> None:
    """One turn of the real benchmark by a policy of that library, which checks its
    request. Expect that the actions are accepted and executed."""
    (policy_folder / f"{name}.py").write_text(source)
    made = PolicyMapping.of(READY[name], name)
    benchmark = "mobile_bimanual" if name == "ebench" else "tabletop"
    made.check(direct.control.get_benchmark(benchmark))
    policy = load(reference, made)()
    turn = _first_turn(direct, benchmark, policy)
    assert turn.executed_steps in (8, 40)


def test_the_manual_s_function_plays(direct: DirectClient, policy_folder: Path) -> None:
    """Both pages have it. Expect that it is the same, and that it is accepted."""
    command = (ROOT / "docs" / "evaluate" / "command.md").read_text()
    (program,) = re.findall(r"```python\n(def hold.*?)```", PAGE, re.DOTALL)
    assert program in command
    (policy_folder / "hold.py").write_text(program)
    turn = _first_turn(direct, "tabletop_state", load("hold.py:hold")())
    assert turn.executed_steps == 1


def _first_turn(direct: DirectClient, benchmark: str, policy: Any) -> Any:
    size = direct.control.get_benchmark(benchmark).image_sizes[-1]
    run = direct.control.submit_run(
        SubmitRun(
            benchmark_id=benchmark,
            policy=PolicyInfo(name="p"),
            images=ImageChoice(codec="raw", width=size.width, height=size.height),
        )
    )
    turn = direct.attach(run.run_id, "w")
    seen = observation_of(msgspec.json.decode(turn.to_json(), type=messages.Turn))
    policy.reset(seen.instruction)
    actions = [Action.model_validate(one) for one in chunk_of(policy.act(seen))]
    turn = direct.data.predict(
        run.run_id, "w", Predict(session_id=turn.session_id, seq=1, actions=actions)
    )
    direct.data.detach_worker(run.run_id, "w", turn.session_id)
    return turn


def test_a_mapping_is_checked_before_there_is_a_run(
    server: ReferenceServer, policy_folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    proctor = Proctor(server.url, capsys)
    text = "[observation]\nk = {value = 1}\n[action.values]\nno = {value = 1}"
    (policy_folder / "m.toml").write_text(text)
    before = proctor.json("status")
    run = ["--policy", "policies:best", "--mapping", "m.toml"]
    for flags in ([], ["--processes"]):
        printed = proctor.json("run", "--benchmark", "calibration", *run, *flags)
        assert "action.values" in printed["error"]["detail"]
        assert proctor.code == 2
    assert proctor.json("status") == before


def test_a_failed_import_in_a_module_is_reported_as_such(policy_folder: Path) -> None:
    (policy_folder / "needs.py").write_text("import not_there_at_all\n")
    with pytest.raises(ModuleNotFoundError, match="not_there_at_all"):
        load("needs:X")
    with pytest.raises(BadPolicy, match="no module"):
        load("needs_not_there:X")
