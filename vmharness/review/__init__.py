"""What a case and its deck must be before a run can judge anything: checks that need the deck, and no solver.

`deck_values` data and deck, `own_input` results that only read the deck's input, `run_length` events and states of the
run, `published` printed values, `region` data for which events do not happen.
"""
