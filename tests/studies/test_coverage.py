"""Scores, and the lists of what no case catches."""

from vmharness.studies.faults.record import FaultsRecord, Finding, Noticed, coverage


def finding(fault, noticed, share=None, kind="physics"):
    return Finding(fault, f"What is wrong with {fault}", kind, noticed, "x", share)


def test_the_score_counts_what_changes_anything():
    found = FaultsRecord(
        "A",
        "0",
        [
            finding("one", Noticed.CAUGHT, 3.0),
            finding("two", Noticed.MISSED, 0.5),
            finding("three", Noticed.UNSEEN),
            finding("RHO +1 %", Noticed.HARMLESS, 0.1, "deck"),
        ],
    )
    assert (found.caught, found.applicable) == (1, 2)
    assert [one.fault for one in found.missed] == ["two"]


def test_a_fault_is_caught_by_the_manual_if_one_case_catches_it():
    blind = FaultsRecord("A", "0", [finding("k", Noticed.MISSED, 0.2), finding("friction", Noticed.UNSEEN)])
    nearer = FaultsRecord("B", "0", [finding("k", Noticed.MISSED, 0.7), finding("friction", Noticed.UNSEEN)])
    found = coverage([blind, nearer])
    assert [(one.fault, one.share) for one in found.missed] == [("k", 0.7)]  # the nearest to being caught
    assert [one.fault for one in found.unseen] == ["friction"]
    assert found.caught == 0
    sees = FaultsRecord(
        "C", "0", [finding("k", Noticed.CAUGHT, 9.0), finding("friction", Noticed.MISSED, 0.1)]
    )
    found = coverage([blind, sees])
    assert found.missed == [sees.findings[1]]
    assert found.unseen == []
    assert found.caught == 1


def test_deck_faults_are_each_case_own():
    own = FaultsRecord("A", "0", [finding("K +1 %", Noticed.MISSED, 0.3, "deck")])
    assert coverage([own]).matrix == {}
