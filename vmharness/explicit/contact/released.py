"""What contacts have let through: nodes deeper than their rule of release allows (PENMAX, PENCHK), said after a run."""

import numpy as np

from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.model.model import Model


def released(model: Model) -> dict[str, str]:
    """By contact, how many nodes it has let go for their depth, those included that came so deep in one step."""
    found = {}
    for contact in model.forces:
        if isinstance(contact, Contact):
            gone = [one.nodes["row"][one.nodes["released"]] for one in contact.passes]
            rows = np.unique(np.concatenate(gone))
            if rows.size:
                count = f"{rows.size} nodes" if rows.size > 1 else "one node"
                found[f"Let through by {contact.name}"] = (
                    f"{count}, first of them {model.ids[rows].min()}: deeper than PENMAX or PENCHK allows"
                )
    return found
