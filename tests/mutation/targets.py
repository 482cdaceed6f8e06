"""The servers that are changed: where their files are, how one is built and started."""

import shlex
import shutil
from dataclasses import dataclass
from pathlib import Path

from tests.mutation.operators import find_mutants
from tests.mutation.syntax import MutantSource, has_same_tree
from tests.support.processes import run_program
from tools.example_servers import NODE

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True, slots=True)
class Target:
    """A server in one folder. `{}` in a command is a copy of that folder."""

    name: str
    folder: str
    suffix: str
    check: str  # a command that fails when a changed file is no program
    start: str

    def sources(self) -> list[Path]:
        """The files that are changed: all of its code, but no tests."""
        found = sorted((ROOT / self.folder).rglob(f"*{self.suffix}"))
        return [path for path in found if not path.stem.endswith(("_test", ".test"))]

    def mutants(self) -> list[MutantSource]:
        """Every mutant of the server; the file is relative to the folder."""
        return [
            mutant
            for path in self.sources()
            for mutant in find_mutants(
                path.relative_to(ROOT / self.folder).as_posix(), path.read_bytes()
            )
        ]

    def copy_to(self, directory: Path) -> None:
        """Put the unchanged server there."""
        shutil.rmtree(directory, ignore_errors=True)
        shutil.copytree(ROOT / self.folder, directory)

    def change(self, mutant: MutantSource, directory: Path) -> str | None:
        """Change a copy. Gives why the result is no program, or None."""
        path = directory / mutant.file
        before = (ROOT / self.folder / mutant.file).read_bytes()
        after = mutant.apply(before)
        if has_same_tree(self.suffix, before, after):
            return "the change is none"
        path.write_bytes(after)
        command = self.check.replace("{file}", shlex.quote(mutant.file))
        return self._run(command, directory)

    def restore(self, mutant: MutantSource, directory: Path) -> None:
        """Undo a change of a copy."""
        shutil.copy(ROOT / self.folder / mutant.file, directory / mutant.file)

    def build(self, directory: Path) -> None:
        """Build the unchanged server; an error is ours."""
        first = self.sources()[0].relative_to(ROOT / self.folder).as_posix()
        problem = self._run(self.check.replace("{file}", first), directory)
        assert problem is None, problem

    def start_command(self, directory: Path) -> str:
        """What the kit starts."""
        return self.start.replace("{}", shlex.quote(str(directory)))

    def _run(self, command: str, directory: Path) -> str | None:
        done = run_program(
            shlex.split(command.replace("{}", shlex.quote(str(directory)))),
            cwd=directory,
        )
        return None if done.returncode == 0 else done.stderr[-400:] or "failed"


TARGETS = {
    "js": Target(
        *("js", "examples/server_js", ".js"),
        check=f"{NODE} --check {{file}}",
        start=f"{NODE} {{}}/server.js",
    ),
    "go": Target(
        *("go", "examples/server_go", ".go"),
        check="go build -trimpath -o {}/mutant-server .",
        start="{}/mutant-server",
    ),
}
