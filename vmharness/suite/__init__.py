"""Many runs: which cases, in which processes, and what is to be said of them all."""
