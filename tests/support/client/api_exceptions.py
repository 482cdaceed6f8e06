"""Failed calls of the generated client."""

from proctor_client import ApiException, Problem


def api_exception(
    code: str,
    status: int,
    *,
    retryable: bool,
    retry_after_s: int | None = None,
    **members: str,
) -> ApiException:
    problem = Problem.from_dict(
        {
            "type": "about:blank",
            "title": code,
            "status": status,
            "detail": f"It is {code}.",
            "code": code,
            "retryable": retryable,
            "side_effects": "none",
            "errors": [{"pointer": "/a", "detail": "is wrong"}],
            **members,
        }
    )
    headers = {"Retry-After": str(retry_after_s)} if retry_after_s else {}
    return ApiException(status, "No", data=problem, headers=headers)
