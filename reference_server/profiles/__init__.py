"""Third-party API profiles, enabled by the setting `profiles`.

A profile offers the HTTP API of another evaluation system over the runs of this server.
Its handlers translate requests into calls of `runs/service.py`, like those of
`http/handlers.py`, and the results into that system's responses. It has no SQL and no
decision on the lifecycle of its own: whether a run or a session allows something is
decided by the rules. State of its own is only in `ebench/lost_answers.py` and
`ebench/long_chunks.py`.
"""
