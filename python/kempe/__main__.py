"""`python -m kempe COMMAND ...` is `kempe COMMAND ...` (docs/commands.md), also where the program is not on the path."""
from ._program import main

if __name__ == "__main__":
    main()
