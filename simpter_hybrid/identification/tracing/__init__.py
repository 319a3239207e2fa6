"""From what is left to what may be missing: dependences, rivals, verdicts and their rounds."""
