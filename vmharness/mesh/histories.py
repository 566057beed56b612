"""The nodes whose motion a deck asks for: *DATABASE_HISTORY_NODE, _NODE_ID and _NODE_SET."""

from vmharness.deck import Deck
from vmharness.mesh.nodes import Nodes
from vmharness.mesh.sets import node_set


def history_nodes(deck: Deck, nodes: Nodes) -> list[int]:
    """Their numbers, each once, in the order of the deck; raises DeckError for a node or set that is not defined."""
    found: dict[int, None] = {}
    for entry in deck.entries:
        name = entry.keyword.name
        if name == "DATABASE_HISTORY_NODE_SET":
            rows = [node_set(deck, nodes, entry, "ids", row) for row in range(entry.ids.size)]
        elif name in ("DATABASE_HISTORY_NODE", "DATABASE_HISTORY_NODE_ID"):
            field = "ids" if name == "DATABASE_HISTORY_NODE" else "id1"
            rows = [nodes.find(entry, field, getattr(entry, field))]
        else:
            continue
        found.update(dict.fromkeys(int(number) for some in rows for number in nodes.ids[some]))
    return list(found)
