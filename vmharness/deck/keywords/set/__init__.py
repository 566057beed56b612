"""*SET: nodes, parts, segments and shells by number."""
