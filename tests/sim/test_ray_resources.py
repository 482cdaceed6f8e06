"""Amounts of resources by Ray's names: what is valid, and the sentence if it is not."""

import re
from dataclasses import replace
from typing import Any

import pytest

from reference_sim import benchmark_registry
from reference_sim.ray_resources import (
    NAMES_MAX,
    check_resources,
    format_resources,
    parse_resources,
)

AMOUNT = "the amount has to be a number from 0.0001 to 2^50"


def test_text_and_amounts_are_each_others() -> None:
    parsed = parse_resources("CPU=0.5, GPU=1,arm=1,")
    assert parsed == {"CPU": 0.5, "GPU": 1, "arm": 1}
    assert format_resources(parsed) == "CPU=0.5,GPU=1,arm=1"
    text = format_resources({"memory": 2.0**40, "CPU": 2})
    assert text == "CPU=2,memory=1099511627776"
    assert parse_resources(format_resources({"a": 0.0001})) == {"a": 0.0001}


@pytest.mark.parametrize(
    "declared", [{"CPU": 0.5}, {"GPU": 2}, {"memory": 2**30}, {"node:10.0.0.1": 0.001}]
)
def test_what_ray_can_place_is_valid(declared: Any) -> None:
    assert check_resources(declared) == declared


@pytest.mark.parametrize(
    ("declared", "sentence"),
    [
        ({}, "a simulator needs at least one resource, such as CPU = 1"),
        ("CPU=1", "a simulator needs at least one resource, such as CPU = 1"),
        (None, "a simulator needs at least one resource, such as CPU = 1"),
        (
            dict.fromkeys(map(str, range(NAMES_MAX + 1)), 1),
            "a simulator takes at most 16 kinds of resources",
        ),
        ({"": 1}, "'' is no name of a resource"),
        ({"a b": 1}, "'a b' is no name of a resource"),
        ({"a=b": 1}, "'a=b' is no name of a resource"),
        ({"a,b": 1}, "'a,b' is no name of a resource"),
        ({"CPU\n": 1}, r"'CPU\n' is no name of a resource"),
        ({"a" * 101: 1}, "is no name of a resource"),
        ({1: 1}, "1 is no name of a resource"),
        ({"CPU": 0}, f"CPU: {AMOUNT}"),
        ({"CPU": -1}, f"CPU: {AMOUNT}"),
        ({"CPU": 0.00009}, f"CPU: {AMOUNT}"),
        ({"CPU": float("nan")}, f"CPU: {AMOUNT}"),
        ({"CPU": float("inf")}, f"CPU: {AMOUNT}"),
        ({"CPU": 10**400}, f"CPU: {AMOUNT}"),
        ({"CPU": True}, f"CPU: {AMOUNT}"),
        ({"CPU": "1"}, f"CPU: {AMOUNT}"),
        ({"CPU": None}, f"CPU: {AMOUNT}"),
        ({"GPU": 1.5}, "GPU: Ray takes fractions below 1 only, of memory none"),
        ({"memory": 0.5}, "memory: Ray takes fractions below 1 only, of memory none"),
    ],
)
def test_what_ray_cannot_place_is_one_sentence(declared: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=re.escape(sentence)) as caught:
        check_resources(declared)
    said = str(caught.value)
    assert "\n" not in said
    assert len(said) < 200


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("CPU", "'CPU' is not NAME=AMOUNT"),
        ("CPU=one", "'CPU=one' is not NAME=AMOUNT"),
        ("CPU=1,CPU=2", "CPU is named twice"),
        (" , ", "at least one resource"),
    ],
)
def test_bad_text_is_one_sentence(text: str, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        parse_resources(text)


def test_a_definition_declares_what_ray_can_place() -> None:
    definition = benchmark_registry._BENCHMARKS["calibration"]
    assert definition.ray_resources == {}
    assert replace(definition, ray_resources={"GPU": 1}).ray_resources == {"GPU": 1}
    with pytest.raises(ValueError, match="GPU: the amount"):
        replace(definition, ray_resources={"GPU": -1})
