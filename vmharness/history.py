"""A history: named channels over time, the same for every solver."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    import pandas as pd

Array = NDArray[np.float64]


class HistoryError(ValueError):
    """Channels and time do not fit together, or a channel is missing."""


@dataclass(frozen=True)
class History:
    """Channels over time, in the consistent units of the case.

    `time` is (n,) and increases; every channel is (n,), sampled at these instants. A channel of another file may have
    its own instants (m,), and then is (m,). Raises HistoryError where that does not hold.
    """

    time: Array
    channels: Mapping[str, Array]
    own: Mapping[str, Array] = field(
        default_factory=dict
    )  # instants of channels that are not sampled at `time`

    def __post_init__(self) -> None:
        for time in (self.time, *self.own.values()):
            if np.any(np.diff(time) <= 0.0):
                raise HistoryError("time does not increase from sample to sample")
        for name, values in self.channels.items():
            if values.shape != self.time_of(name).shape:
                size = self.time_of(name).size
                raise HistoryError(f"channel {name} has {values.size} samples, time has {size}")

    def __getitem__(self, name: str) -> Array:
        """The samples of channel `name`, (n,); `time` is a channel too."""
        if name == "time":
            return self.time
        try:
            return self.channels[name]
        except KeyError:
            raise HistoryError(f"no channel {name}; recorded: {', '.join(self.channels)}") from None

    def __contains__(self, name: object) -> bool:
        """Whether there is a channel `name`; `time` is a channel too."""
        return name == "time" or name in self.channels

    def __len__(self) -> int:
        return self.time.size

    def time_of(self, name: str) -> Array:
        """The instants at which channel `name` is sampled."""
        return self.own.get(name, self.time)

    def samples(self, chosen: NDArray[np.intp] | slice) -> "History":
        """The history of the chosen samples alone, in their order; channels with instants of their own are left out."""
        channels = {name: values[chosen] for name, values in self.channels.items() if name not in self.own}
        return History(self.time[chosen], channels)

    def at(self, name: str, t: ArrayLike) -> Array:
        """Channel `name` at the times `t` (m,) within the run, by cubic Hermite interpolation.

        Slopes are second-order differences of the samples, so that the error is O(dt^3), and O(dt^2) times the jump
        of the second derivative in a step that contains one.
        """
        from scipy.interpolate import CubicHermiteSpline

        t = np.asarray(t, float)
        values, time = self[name], self.time_of(name)
        if not (t.size and time[0] <= t.min() and t.max() <= time[-1]):
            raise HistoryError(f"{name} is asked for outside the run, {time[0]:g} to {time[-1]:g}")
        # Slopes need two neighbours on either side; the rest of a long history is not touched.
        first = max(int(np.searchsorted(time, t.min())) - 3, 0)
        last = int(np.searchsorted(time, t.max())) + 4
        time, values = time[first:last], values[first:last]
        slopes = np.gradient(values, time, edge_order=2 if time.size > 2 else 1)
        return np.asarray(CubicHermiteSpline(time, values, slopes)(t))

    def to_frame(self) -> "pd.DataFrame":
        """A pandas frame: one column a channel, indexed by time."""
        import pandas as pd

        return pd.DataFrame(dict(self.channels), index=pd.Index(self.time, name="time"))

    @classmethod
    def from_frame(cls, frame: "pd.DataFrame") -> "History":
        """The history in a frame made as `to_frame` does."""
        columns = {str(name): frame[name].to_numpy(float) for name in frame.columns}
        return cls(frame.index.to_numpy(float), columns)

    def to_csv(self, file: Path | IO[str]) -> None:
        """Write all samples with every digit they have, so that `from_csv` gives the same numbers."""
        table = np.column_stack([self.time, *self.channels.values()])
        np.savetxt(
            file, table, fmt="%.17g", delimiter=",", header=",".join(["time", *self.channels]), comments=""
        )

    @classmethod
    def from_csv(cls, path: Path) -> "History":
        """Read what `to_csv` wrote: a line of names, the first of them time, and a line a sample."""
        with path.open() as lines:
            names = lines.readline().strip().split(",")
            table = np.loadtxt(lines, delimiter=",", ndmin=2)
        return cls(table[:, 0], dict(zip(names[1:], table[:, 1:].T, strict=True)))
