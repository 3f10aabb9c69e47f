"""What checks of a measurement find beyond its error model."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ConsistencyCheck:
    """One check: the deviations it found beside those that the error model expects, as standard deviations of a point in mm."""

    name: str  # what deviations were sorted by: "camera pixel", "surface direction", …
    observed_mm: float  # rms of the mean deviations
    expected_mm: float  # rms that the error model expects of them
    unexplained_mm: float  # what the model does not explain; 0 where chance explains the difference
    probability: float  # of so large deviations if the model is right
    cause: str  # the likely cause, in words

    @property
    def sentence(self) -> str:
        """The check in words."""
        found = f"{self.observed_mm:.4f} mm found, {self.expected_mm:.4f} mm expected"
        if not self.unexplained_mm:
            return f"{found}: explained"
        return f"{found}: {self.unexplained_mm:.4f} mm not explained; likely cause: {self.cause}"


@dataclass(frozen=True, slots=True)
class Consistency:
    """All checks of one measurement against its error model."""

    checks: tuple[ConsistencyCheck, ...] = ()

    @property
    def worst(self) -> ConsistencyCheck | None:
        """The check that leaves most unexplained; None where all deviations are explained."""
        left = [check for check in self.checks if check.unexplained_mm > 0]
        return max(left, key=lambda check: check.unexplained_mm, default=None)

    @property
    def unexplained_mm(self) -> float:
        """Unexplained standard deviation of a point: the largest of all checks, because they sort the same deviations differently."""
        return 0.0 if self.worst is None else self.worst.unexplained_mm

    @property
    def sentence(self) -> str:
        """The result of all checks in words; empty without checks."""
        if not self.checks:
            return ""
        if self.worst is None:
            return "The measurement agrees with its error model."
        return (
            f"Deviations by {self.worst.name} exceed the error model by {self.worst.unexplained_mm:.4f} mm (k = 1), which is added to U. "
            f"Likely cause: {self.worst.cause}."
        )
