"""Failed calls of the generated client."""

from proctor_client import ApiException, Problem


def api_exception(
    code: str,
    status: int,
    *,
    retryable: bool,
    retry_after_s: int | None = None,
    fault: tuple[str, str] = ("/a", "is wrong"),
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
            "errors": [dict(zip(("pointer", "detail"), fault, strict=True))],
            **members,
        }
    )
    headers = {"Retry-After": str(retry_after_s)} if retry_after_s else {}
    return ApiException(status, "No", data=problem, headers=headers)
