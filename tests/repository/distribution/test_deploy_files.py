"""tools/deploy/: its settings exist, its times and sizes fit, and its proxies work."""

import fnmatch
import re
import ssl
import tomllib
from pathlib import Path
from typing import Any

import httpx
import pytest
import yaml

from reference_server.http.connections.connection_limits import HEADER_BYTES
from reference_server.records.record_verifier import EXAMINE_S_MAX, WAIT_S_MAX
from reference_server.settings import Settings
from tests.support.kit.reverse_proxies import run_configuration
from tests.support.paths import ROOT
from tests.support.ports import free_port
from tests.support.server.certificates import create_certificate
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.servers import TOKENS, ReferenceServer
from tools.distributions.staging import DISTRIBUTIONS

DEPLOY = ROOT / "tools" / "deploy"
FILES = sorted(path for path in DEPLOY.rglob("*") if path.is_file())
CONTAINERFILE = (DEPLOY / "container" / "Containerfile").read_text()
COMPOSE = yaml.safe_load((DEPLOY / "container" / "compose.yaml").read_text())
UNIT = (DEPLOY / "systemd" / "proctor.service").read_text()
NGINX = (DEPLOY / "proxies" / "nginx.conf").read_text()
HAPROXY = (DEPLOY / "proxies" / "haproxy.cfg").read_text()
KUBERNETES = [*yaml.safe_load_all((DEPLOY / "kubernetes/proctor.yaml").read_text())]
POD = KUBERNETES[1]["spec"]["template"]["spec"]
DEFAULTS = Settings(_cli_parse_args=False)


def settings_of(pairs: dict[str, str]) -> Settings:
    """The settings that a file gives; raises ValidationError for a wrong one."""
    names: dict[str, Any] = {
        name.removeprefix("PROCTOR_").lower(): one for name, one in pairs.items()
    }
    return Settings(_cli_parse_args=False, **names)


def assignments(text: str, separator: str) -> dict[str, str]:
    found = re.findall(rf"(PROCTOR_[A-Z_]+){separator}[ ]?\"?([^\s\"\\]+)", text)
    return dict(found)


def compose_settings() -> Settings:
    given = COMPOSE["services"]["proctor"]["environment"]
    text = yaml.safe_dump(given)
    chosen = re.sub(r"\$\{[^}]*\}", "eval.example.org", text)
    return settings_of(yaml.safe_load(chosen))


def container_env() -> dict[str, str]:
    (container,) = POD["containers"]
    return {one["name"]: one["value"] for one in container["env"]}


def unit_settings() -> Settings:
    environment = (DEPLOY / "systemd" / "server.env").read_text()
    return settings_of(assignments(UNIT, "=") | assignments(environment, "="))


def bytes_of(text: str) -> int:
    """As nginx (`m`) and Caddy (`MB`, `MiB`) count them."""
    number, unit = re.fullmatch(r"(\d+)(\w+)", text).groups()  # type: ignore[union-attr]
    return int(number) * {"m": 2**20, "MiB": 2**20, "MB": 10**6}[unit]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_every_setting_that_is_named_exists(path: Path) -> None:
    named = set(re.findall(r"PROCTOR_([A-Z_]+)\b", path.read_text()))
    known = {name.upper() for name in Settings.model_fields}
    assert named - known <= {"DOMAIN"}, "of compose.yaml and its Caddyfile alone"
    flags = set(re.findall(r"--([a-z-]+-s)\b", path.read_text()))
    assert {flag.replace("-", "_") for flag in flags} <= set(Settings.model_fields)


def test_the_server_ends_in_the_time_that_it_is_given() -> None:
    """And one second to send answers, one to end simulators."""
    grace = [
        (compose_settings(), COMPOSE["services"]["proctor"]["stop_grace_period"]),
        (unit_settings(), re.findall(r"TimeoutStopSec=(\d+)", UNIT)[0]),
        (settings_of(container_env()), POD["terminationGracePeriodSeconds"]),
    ]
    for settings, seconds in grace:
        allowed = int(str(seconds).removesuffix("s"))
        assert allowed > settings.drain_notice_s + settings.drain_s + 2
    assert "KillMode=mixed" in UNIT, "else simulators end before their turns"


def test_kubernetes_changes_neither_settings_nor_keys() -> None:
    (service,) = (one for one in KUBERNETES if one["kind"] == "Service")
    prefix = service["metadata"]["name"].upper()
    assert f"{prefix}_PORT" == "PROCTOR_PORT", "else it sets nothing that is read"
    assert POD["enableServiceLinks"] is False
    assert POD["securityContext"]["fsGroupChangePolicy"] == "OnRootMismatch"


def test_own_benchmarks_have_one_place() -> None:
    """Where a line is a comment, it works when its sign is taken away."""
    place = "/etc/proctor/benchmarks"
    environment = (DEPLOY / "systemd" / "server.env").read_text()
    assert f"#PROCTOR_BENCHMARKS={place}\n" in environment
    uncommented = re.compile(r"(?m)^(\s*)# (?=PROCTOR_BENCH|- |  configMap)")
    compose = (DEPLOY / "container" / "compose.yaml").read_text()
    server = yaml.safe_load(uncommented.sub(r"\1", compose))["services"]["proctor"]
    assert server["environment"]["PROCTOR_BENCHMARKS"] == place
    assert f"./benchmarks:{place}:ro" in server["volumes"]
    text = (DEPLOY / "kubernetes" / "proctor.yaml").read_text()
    deployment = list(yaml.safe_load_all(uncommented.sub(r"\1", text)))[1]
    pod = deployment["spec"]["template"]["spec"]
    (container,) = pod["containers"]
    given = {one["name"]: one["value"] for one in container["env"]}
    assert given["PROCTOR_BENCHMARKS"] == place
    mounts = {one["name"]: one["mountPath"] for one in container["volumeMounts"]}
    assert mounts["benchmarks"] == place
    assert {one["name"] for one in pod["volumes"]} == mounts.keys()
    assert (
        f"COPY benchmarks {place}\n"
        in (ROOT / "docs/host/run-for-others.md").read_text()
    )


def test_a_proxy_waits_longer_than_the_server() -> None:
    longest = max(DEFAULTS.turn_timeout_s, DEFAULTS.wait_s_max)
    found = re.findall(r"proxy_(?:read|send)_timeout (\d+)s", NGINX)
    found += re.findall(r"timeout (?:client|server) (\d+)s", HAPROXY)
    assert len(found) == 6
    assert min(map(int, found)) > longest
    of_records = re.findall(r"location = /v1/records {[^}]*_read_timeout (\d+)s", NGINX)
    of_records += re.findall(r"set-timeout server (\d+)s if { path /v1/rec", HAPROXY)
    assert len(of_records) == 2
    assert min(map(int, of_records)) > WAIT_S_MAX + EXAMINE_S_MAX
    # HAProxy sees the 503 of /readyz before the server stops listening.
    interval, falls = re.findall(r"inter (\d+)s fall (\d+)", HAPROXY)[0]
    notice = float(re.findall(r"--drain-notice-s (\d+)", HAPROXY)[0])
    assert notice > int(interval) * int(falls)


def test_a_proxy_takes_what_the_server_takes() -> None:
    caddy = (DEPLOY / "container" / "Caddyfile").read_text()
    sizes = re.findall(r"client_max_body_size (\w+);", NGINX)
    sizes += re.findall(r"max_size (\w+)", caddy)
    largest = max(DEFAULTS.max_record_bytes, DEFAULTS.max_body_bytes)
    assert [size for size in sizes if bytes_of(size) < largest] == []
    small = re.findall(r"(?:; |to )(\d+(?:m|MB))\b", NGINX + caddy)
    assert len(small) == 2
    assert all(bytes_of(one) > DEFAULTS.max_body_bytes for one in small)
    (buffer,) = re.findall(r"tune\.bufsize (\d+)", HAPROXY)
    assert int(buffer) >= HEADER_BYTES + 1024, "it keeps 1 KiB for headers that it adds"


def test_ports_and_paths_are_those_of_the_server() -> None:
    assert f"EXPOSE {DEFAULTS.port}\n" in CONTAINERFILE
    assert f"http://127.0.0.1:{DEFAULTS.port}/livez" in CONTAINERFILE
    for text in (NGINX, HAPROXY):
        assert f"127.0.0.1:{DEFAULTS.port}" in text
    (container,) = POD["containers"]
    assert [one["containerPort"] for one in container["ports"]] == [
        DEFAULTS.port,
        DEFAULTS.metrics_port,
    ]
    probes = [container[f"{one}Probe"]["httpGet"] for one in ("liveness", "readiness")]
    assert [one["path"] for one in probes] == ["/livez", "/readyz"]
    image = settings_of(assignments(CONTAINERFILE, "="))
    volume = re.findall(r"VOLUME (\S+)", CONTAINERFILE)[0]
    assert str(Path(image.database).parent) == volume
    assert container["volumeMounts"][0]["mountPath"] == volume


def test_the_image_is_made_of_the_wheels() -> None:
    """From a base with a tag, with hashes, for an account that is not root."""
    server = next(one for one in DISTRIBUTIONS if one.name == "proctor-server")
    client = next(one for one in DISTRIBUTIONS if one.name == "proctor-eval")
    copied = re.findall(r"dist/(\S+)", CONTAINERFILE)
    names = [
        f"{server.file_stem}-requirements.txt",
        f"{client.file_stem}-py3-none-any.whl",
        f"{server.file_stem}-py3-none-any.whl",
    ]
    assert all(map(fnmatch.fnmatch, names, copied))
    assert len(copied) == len(names)
    assert re.search(r"PYTHON_IMAGE=\S+/python:3\.\d+-slim-\w+\n", CONTAINERFILE)
    assert "--require-hashes" in CONTAINERFILE
    assert re.search(r"^USER 10001$", CONTAINERFILE, re.MULTILINE)
    source = ROOT / "tools" / "distributions" / "proctor-server" / "pyproject.toml"
    (script,) = tomllib.loads(source.read_text())["project"]["scripts"]
    assert f'ENTRYPOINT ["{script}"]' in CONTAINERFILE
    assert f"ExecStart=/opt/proctor/bin/{script}\n" in UNIT


# --- the proxies, run ---


def nginx_main(directory: Path, site: str) -> str:
    """The file of conf.d within what any user can run."""
    paths = "".join(
        f"{one}_temp_path {directory}/{one};\n"
        for one in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
    )
    return (
        f"daemon off;\nmaster_process off;\npid {directory}/pid;\nevents {{}}\n"
        f"http {{\naccess_log off;\n{paths}{site}}}\n"
    )


def configuration(name: str, directory: Path, port: int, upstream: str) -> str:
    """The file in deploy/ with this machine's ports and certificate, nothing else."""
    create_certificate(directory, "localhost")
    pem, key = directory / "certificate.pem", directory / "key.pem"
    (directory / "both.pem").write_bytes(pem.read_bytes() + key.read_bytes())
    changes: dict[str, str] = {
        "127.0.0.1:8460": upstream.removeprefix("http://"),
        "listen 443": f"listen 127.0.0.1:{port}",
        "bind :443": f"bind 127.0.0.1:{port}",
        "ssl crt /etc/ssl/eval.example.org.pem": f"ssl crt {directory}/both.pem",
        "/etc/ssl/eval.example.org.pem": str(pem),
        "/etc/ssl/eval.example.org.key": str(key),
    }
    text = {"nginx": NGINX, "haproxy": HAPROXY}[name]
    for old, new in changes.items():
        text = text.replace(old, new)
    return nginx_main(directory, text) if name == "nginx" else text


@pytest.mark.slow("starts a server and a proxy")
@pytest.mark.parametrize("name", ["nginx", "haproxy"])
def test_a_run_is_played_through_the_proxy(name: str, tmp_path: Path) -> None:
    """With TLS, events at once, and a body of the largest size."""
    directory, port = tmp_path / name, free_port()
    directory.mkdir()
    headers = {"Authorization": f"Bearer {TOKENS['alice']}"}
    with ReferenceServer(tmp_path) as server:
        text = configuration(name, directory, port, server.url)
        with (
            run_configuration(name, directory, port, text),
            httpx.Client(
                base_url=f"https://localhost:{port}",
                headers=headers,
                verify=ssl.create_default_context(cafile=directory / "certificate.pem"),
                trust_env=False,
                timeout=30,
            ) as client,
        ):
            assert client.get("/readyz").json() == {"status": "ready"}
            long = {"X-First": "1" * 15_000, "X-Second": "2" * 15_000}
            assert client.get("/v1", headers=long).status_code == 200
            run_id = submit(client, "score")
            shown: dict[str, Any] = client.get(f"/v1/runs/{run_id}").json()
            assert f"localhost:{port}" in shown["endpoint"]
            with client.stream("GET", f"/v1/runs/{run_id}/events") as events:
                chunks = events.iter_text()
                assert "run" in next(chunks)
                turn = attach(client, run_id)
                assert "running" in "".join(next(chunks) for _ in range(1))
            body = predict_body(turn, score=1, end=1)
            path = f"{worker_path(run_id)}/predict"
            large = b" " * (DEFAULTS.max_body_bytes + 1)
            json_type = {"Content-Type": "application/json"}
            refused = client.post(path, content=large, headers=json_type)
            assert refused.json()["code"] == "body_too_large"
            played = client.post(path, json=body)
            assert played.json()["done"], played.text
            assert played.headers["x-request-id"]
