"""The parameters of the operations, as spec/ describes them.

Written by `make generate`; never edited. A whole value matches its pattern. Of numbers,
the pattern bounds the digits and QUERY_RANGES the value: the least and the largest.
"""

PATH_PATTERNS: dict[str, str] = {
    "account": r"[a-z][a-z0-9]{2,31}",
    "benchmark_id": r"[a-z][a-z0-9_]{0,63}",
    "camera": r"[A-Za-z0-9_.-]{1,64}",
    "cell_id": r"[a-z][a-z0-9_]{0,63}",
    "digest": r"sha256:[0-9a-f]{64}",
    "entry_id": r"[A-Za-z0-9_-]{1,64}",
    "episode_id": r"[A-Za-z0-9_-]{1,64}",
    "import_id": r"[A-Za-z0-9_-]{1,64}",
    "judgement_id": r"[a-z][a-z0-9_]{0,63}",
    "key_id": r"[A-Za-z0-9_-]{1,64}",
    "number": r"[0-9]{1,6}",
    "organisation": r"[a-z][a-z0-9]{2,31}",
    "result_id": r"[A-Za-z0-9_-]{1,64}",
    "run_id": r"[A-Za-z0-9_-]{1,64}",
    "submission_id": r"[A-Za-z0-9_-]{1,64}",
    "track_id": r"[a-z][a-z0-9_-]{0,63}",
    "worker_id": r"[A-Za-z0-9_-]{1,64}",
}
HEADER_PATTERNS: dict[str, str] = {
    "idempotency-key": r"[\x21-\x7e]{1,128}",
    "if-none-match": r"(?s:.{0,200})",
    "last-event-id": r"[A-Za-z0-9_-]{1,128}",
    "prefer": r"wait=[0-9]{1,4}",
    "proctor-version": r"[0-9]{1,4}\.[0-9]{1,4}",
    "run_id": r"[A-Za-z0-9_-]{1,64}",
}
QUERY_PATTERNS: dict[str, str] = {
    "after": r"[0-9]{1,16}",
    "baseline": r"[A-Za-z0-9_-]{1,64}",
    "benchmark_id": r"[a-z][a-z0-9_]{0,63}",
    "cursor": r"[A-Za-z0-9_-]{1,128}",
    "leaf_index": r"[0-9]{1,15}",
    "limit": r"[0-9]{1,4}",
    "manifest_sha256": r"[0-9a-f]{64}",
    "new_size": r"[1-9][0-9]{0,14}",
    "offset": r"[0-9]{1,16}",
    "old_size": r"[1-9][0-9]{0,14}",
    "render_mode": r"(?s:.{0,20})",
    "request_id": r"[A-Za-z0-9_.-]{1,1040}",
    "request_ids": r"[A-Za-z0-9_.,-]{1,8000}",
    "run_id": r"[A-Za-z0-9_-]{1,64}",
    "runs": r"[A-Za-z0-9_-]{1,64}(,[A-Za-z0-9_-]{1,64}){0,15}",
    "session_id": r"(?s:.{1,128})",
    "size": r"[0-9]{1,16}",
    "subframes": r"(?s:.{0,20})",
    "tolerance": r"[0-9]{1,4}(\.[0-9]{1,40})?([Ee][+-]?[0-9]{1,3})?",
    "tree_size": r"[1-9][0-9]{0,14}",
    "user_id": r"(?s:.{0,200})",
}
QUERY_RANGES: dict[str, tuple[int, int]] = {
    "after": (0, 9007199254740991),
    "limit": (1, 1000),
    "offset": (0, 9007199254740991),
    "size": (1, 9007199254740991),
    "tolerance": (0, 1),
}
