"""Push runs: the server calls the policy (`push`, docs/evaluate/policies/push.md).

`driver` plays each run as workers would. `policy_calls` is the protocol of
spec/policy.yaml, `chat_calls` that of chat completions; both send their calls through
`calls_with_retries`, which bounds every call. `egress` decides which addresses may be
connected to, `key_encryption` keeps API keys unreadable in the database, and
`policy_server_validator` checks what a submission says of its policy server.
"""
