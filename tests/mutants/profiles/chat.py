"""Mutants of the protocol openai_chat: its requests, and how answers are read."""

from __future__ import annotations

from typing import Any

from reference_server.push import chat_calls
from reference_server.push.calls_with_retries import PolicyFault
from reference_server.push.chat_calls import ChatPolicy, CompletionPolicy
from tests.mutants import instead_of, mutant, put


@mutant("CHAT-001", through=instead_of(chat_calls, "_message"))
def sends_no_picture(right: Any, turn: Any) -> Any:
    """A model is scored for a question without its picture."""
    message = right(turn)
    texts = [part for part in message["content"] if part["type"] == "text"]
    return message | {"content": texts}


@mutant("CHAT-001", "CHAT-005", through=instead_of(ChatPolicy, "_generation"))
def sends_no_parameter_that_is_zero(right: Any, self: ChatPolicy) -> Any:
    """A model is sampled at random where its author chose the likeliest words."""
    return {name: value for name, value in right(self).items() if value != 0}


@mutant("CHAT-002", "FLE-022", through=instead_of(chat_calls, "read_answer"))
def takes_the_first_line_for_the_answer(right: Any, text: str) -> Any:
    """A model that reasons first is scored for its first thought."""
    return right(text.strip().partition("\n")[0])


@mutant("CHAT-003", "FLE-021", "FLE-022", through=instead_of(chat_calls, "read_answer"))
def counts_an_unreadable_answer_as_a_fault(right: Any, text: str) -> Any:
    """A model that cannot answer three questions ends its whole evaluation."""
    answer = right(text)
    if answer["number"] == [chat_calls.NO_ANSWER]:
        raise PolicyFault("The model's words are no answer.")
    return answer


@mutant("CHAT-004", through=instead_of(chat_calls, "_content"))
def takes_an_error_for_an_answer(right: Any, answer: Any) -> Any:
    """A broken model server is published as a model without correct answers."""
    try:
        return right(answer)
    except PolicyFault:
        return ""


@mutant("CHAT-005", "FLE-019")
def asks_a_completions_server_for_a_chat() -> None:
    """A base model without a chat template answers every question with an error."""
    put(CompletionPolicy, "_ask", ChatPolicy._ask)
