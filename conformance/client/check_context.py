"""The argument of every check: one server, its accounts, and verbs of the protocol.

    @requirement("ATT-003")
    def test_att_003_cannot_attach_with_another_key_on_a_live_worker(context):
        \"\"\"Another key on a live worker. Expect worker_busy.\"\"\"
        worker = context.submit("count").worker()
        worker.attach()
        expect.refused(worker.try_attach(), "worker_busy")
        expect.ok(worker.try_predict(context.action()))

A context is cheap, belongs to one check, and is safe for several threads.
"""

from collections.abc import Mapping
from typing import Any

from conformance.client.http_client import HttpClient
from conformance.client.request_context import RequestContext
from conformance.client.run_client import RunClient, adopt_run
from conformance.exchanges.answer import Answer
from conformance.verdicts.expect import KitError, SetUpFailed

# Capacity may have to be made first: a simulator started, a robot freed.
_READY_TIMEOUT_S = 30.0


class CheckContext(RequestContext):
    """One check's view of the server."""

    def submit(
        self,
        *tasks: str,
        wait_ready: bool = True,
        http_client: HttpClient | None = None,
        max_workers: int | None = None,
        idle_timeout_s: float | None = None,
        images: Mapping[str, Any] | None = None,
        headers: Mapping[str, str] | None = None,
        policy: Mapping[str, Any] | None = None,
        any_policy: bool | None = None,
        select: Mapping[str, Any] | None = None,
        **options: Any,
    ) -> RunClient:
        """Submit a calibration run, one episode per task; wait until it is ready.

        options: those of calibration; None where one is left out.
        """
        options = {name: value for name, value in options.items() if value is not None}
        if tasks:
            options["tasks"] = list(tasks)
        members: dict[str, Any] = {
            "max_workers": max_workers,
            "idle_timeout_s": idle_timeout_s,
            "images": images,
            "options": options or None,
            "policy": policy,
            "any_policy": any_policy,
            "select": select,
        }
        body = self.submit_body(**members)
        faults = self.spec.request_faults(self.spec.operations["submit_run"], body)
        if faults:
            raise KitError(f"the kit's own submit_run is invalid: {faults}")
        accepted = self.require(
            lambda: self.require_admitted(
                self.call(
                    "submit_run", json=body, http_client=http_client, headers=headers
                )
            ),
            201,
            "submit_run",
        )
        run = self.adopt(accepted, http_client)
        if wait_ready and run.body["state"] != "ready":
            run.until("ready", _READY_TIMEOUT_S)
        return run

    def require_admitted(self, answer: Answer) -> Answer:
        """Give the answer of a `submit_run`, unless a track forbids the run (HST-010).

        Such a refusal breaks no other rule, and judges none.
        """
        if self.offers("hosting") and answer.status == 403:
            raise SetUpFailed(
                "the tracks of this account do not take such a run: judge it with "
                "tokens that no track limits (the reference host: `proctor admin "
                "token`)"
            )
        return answer

    def adopt(
        self, body: dict[str, Any], http_client: HttpClient | None = None
    ) -> RunClient:
        """Handle a run that a raw request submitted; it is stopped after the check."""
        return adopt_run(self, body, http_client)

    def for_base_url(self, base_url: str) -> "CheckContext":
        """Give a context for another server, with the same log and tally."""
        return CheckContext(self.shared, self.name, base_url, self)
