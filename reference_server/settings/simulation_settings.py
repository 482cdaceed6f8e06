"""Benchmarks, and where their simulators are executed."""

from __future__ import annotations

from pydantic import BaseModel, Field, field_validator

from reference_sim.ray_resources import parse_resources


class SimulationSettings(BaseModel):
    """Benchmarks, and where their simulators are executed."""

    benchmarks: str = Field(
        "",
        description="Additional benchmarks, comma-separated: gymnasium:ID, a TOML "
        "file, a folder of TOML files, FILE.py:CLASS, a question file FILE.jsonl, or "
        "metaworld_mt50.",
    )
    simulator: str = Field(
        "",
        description="A program that speaks the simulator protocol, with its arguments: "
        "one more benchmark. A TOML file can say more about it.",
    )
    simulators: str = Field(
        "local",
        pattern=r"^(local|ray|ray://[^\s/:]+:\d{1,5})$",
        description="Where simulators are executed. local: in processes of this "
        "machine. ray: on the Ray cluster that this machine is in. ray://HOST:PORT: on "
        "another one, by its server for Ray clients, usually port 10001. Ray needs "
        "the same software on all machines. The server writes their recordings.",
    )
    ray_resources: str = Field(
        "CPU=1",
        description="Ray: what one simulator takes of a machine, comma-separated, each "
        "NAME=AMOUNT with Ray's names, for example CPU=0.5,GPU=0.25. For benchmarks "
        "that declare none themselves.",
    )
    max_simulators: int = Field(
        64, ge=1, description="Maximum simulator processes, over all runs."
    )
    spare_simulators: int = Field(
        2,
        ge=0,
        description="Idle simulator processes that are kept started. On Ray none "
        "unless this is set: each holds its share of the cluster.",
    )
    turn_timeout_s: float = Field(
        60.0,
        gt=0,
        allow_inf_nan=False,
        description="Maximum time of a simulator for one turn; then it is killed.",
    )

    @field_validator("simulator")
    @classmethod
    def _check_simulator(cls, command: str) -> str:
        if "," in command:
            raise ValueError("a command with a comma belongs in a TOML file")
        return command

    @field_validator("ray_resources")
    @classmethod
    def _check_resources(cls, text: str) -> str:
        parse_resources(text)  # raises ValueError
        return text

    @property
    def benchmark_references(self) -> str:
        """`benchmarks`, and the one of `simulator`."""
        program = self.simulator and f"simulator:{self.simulator}"
        return ",".join(filter(None, (self.benchmarks, program)))

    @property
    def spares(self) -> int:
        """`spare_simulators`, where they cost no other server its place."""
        is_set = "spare_simulators" in self.model_fields_set
        return self.spare_simulators if is_set or self.simulators == "local" else 0
