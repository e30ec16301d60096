import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { hasSeen, remember } from './seen.ts'

/** Hints in their order. */
const HINT_NAMES = ['click', 'drag', 'keys'] as const

export type HintName = (typeof HINT_NAMES)[number]

/** Text that is remembered when a user has followed or dismissed the hints. */
const SEEN = 'hints'

export interface HintParts {
  /** Whether a region or a line is selected. */
  isSelected: ReadonlySignal<boolean>
  /** Label of the last change of the document. */
  undoLabel: ReadonlySignal<string | undefined>
  /** Expression of the face. */
  expression: ReadonlySignal<string | null>
}

/** Three hints, one after the other. Each disappears when the user has done what it says. */
export class Hints {
  readonly #shown = signal<HintName | null>(null)

  constructor({ isSelected, undoLabel, expression }: HintParts) {
    let before: { label: string | undefined; name: string | null } | undefined
    effect(() => {
      const [label, name] = [undoLabel.value, expression.value]
      const isDone: Record<HintName, boolean> = {
        click: isSelected.value,
        drag: label !== undefined && label !== before?.label,
        keys: name !== null && name !== before?.name,
      }
      before = { label, name }
      const shown = this.#shown.peek()
      if (shown && isDone[shown]) this.#next(shown)
    })
  }

  /** Hint to show, or null. */
  get shown(): ReadonlySignal<HintName | null> {
    return this.#shown
  }

  /** Shows the first hint, unless the user has seen all hints before. */
  start(): void {
    if (!hasSeen(SEEN)) this.#shown.value ??= HINT_NAMES[0]
  }

  /** Hides the hints for good. */
  dismiss(): void {
    remember(SEEN)
    this.#shown.value = null
  }

  #next(done: HintName): void {
    const next = HINT_NAMES[HINT_NAMES.indexOf(done) + 1]
    if (next) this.#shown.value = next
    else this.dismiss()
  }
}
