"""Mutants of the protocol openai_chat: its requests, and how answers are read."""

from __future__ import annotations

from typing import Any

from reference_server.push import chat_calls
from reference_server.push.chat_calls import ChatPolicy, CompletionPolicy
from reference_server.push.http_calls import PolicyFault
from tests.mutants import mutant, put


@mutant("CHAT-001")
def sends_no_picture() -> None:
    """A model is scored for a question without its picture."""
    right = chat_calls._message

    def wrong(turn: Any) -> dict[str, Any]:
        message = right(turn)
        texts = [part for part in message["content"] if part["type"] == "text"]
        return message | {"content": texts}

    put(chat_calls, "_message", wrong)


@mutant("CHAT-001", "CHAT-005")
def sends_no_parameter_that_is_zero() -> None:
    """A model is sampled at random where its author chose the likeliest words."""
    right = ChatPolicy._generation

    def wrong(self: ChatPolicy) -> dict[str, Any]:
        return {name: value for name, value in right(self).items() if value != 0}

    put(ChatPolicy, "_generation", wrong)


@mutant("CHAT-002", "FLE-022")
def takes_the_first_line_for_the_answer() -> None:
    """A model that reasons first is scored for its first thought."""
    right = chat_calls.read_answer

    def wrong(text: str) -> dict[str, list[float]]:
        return right(text.strip().partition("\n")[0])

    put(chat_calls, "read_answer", wrong)


@mutant("CHAT-002")
def cuts_a_long_answer() -> None:
    """A model that reasons at length is scored for a thought on the way."""
    right = chat_calls.read_answer

    def wrong(text: str) -> dict[str, list[float]]:
        return right(text[:5_000])

    put(chat_calls, "read_answer", wrong)


@mutant("CHAT-003", "FLE-021", "FLE-022")
def counts_an_unreadable_answer_as_a_fault() -> None:
    """A model that cannot answer three questions ends its whole evaluation."""
    right = chat_calls.read_answer

    def wrong(text: str) -> dict[str, list[float]]:
        answer = right(text)
        if answer["number"] == [chat_calls.NO_ANSWER]:
            raise PolicyFault("The model's words are no answer.")
        return answer

    put(chat_calls, "read_answer", wrong)


@mutant("CHAT-004")
def takes_an_error_for_an_answer() -> None:
    """A broken model server is published as a model without correct answers."""
    right = chat_calls._content

    def wrong(answer: Any) -> str:
        try:
            return right(answer)
        except PolicyFault:
            return ""

    put(chat_calls, "_content", wrong)


@mutant("CHAT-005", "FLE-019")
def asks_a_completions_server_for_a_chat() -> None:
    """A base model without a chat template answers every question with an error."""
    put(CompletionPolicy, "_ask", ChatPolicy._ask)
