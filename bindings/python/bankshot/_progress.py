# SPDX-License-Identifier: MIT
"""A progress bar on standard error, by tqdm if it is installed."""
from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import Callable, Iterator, Optional

Tell = Optional[Callable[[int], None]]


@contextmanager
def bar(total: int, wanted: Optional[bool]) -> Iterator[Tell]:
    """Yields a function to report the number done. `wanted` None: only on a terminal or in a notebook."""
    if wanted is None:
        wanted = sys.stderr.isatty() or "ipykernel" in sys.modules
    if not wanted:
        yield None
        return
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield _line(total)
        sys.stderr.write(f"\r{total} of {total}\n")
        return
    with tqdm(total=total) as drawn:
        yield lambda done: None if drawn.update(done - drawn.n) else None
        drawn.update(total - drawn.n)


def _line(total: int) -> Callable[[int], None]:
    def tell(done: int) -> None:
        sys.stderr.write(f"\r{done} of {total}")
        sys.stderr.flush()

    return tell
