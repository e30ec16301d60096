import { signal } from '@preact/signals'

/** Colour scheme of the page. `system` follows the system. */
export type Appearance = 'system' | 'light' | 'dark'

/** Storage key, also read by a script in `index.html` before the first paint. */
const KEY = 'appearance'

const { dataset } = document.documentElement
const appearance = signal(isAppearance(dataset.appearance) ? dataset.appearance : 'system')

/** Returns the chosen colour scheme. */
export function chosenAppearance(): Appearance {
  return appearance.value
}

/** Sets and stores the colour scheme. */
export function chooseAppearance(next: Appearance): void {
  appearance.value = next
  dataset.appearance = next
  try {
    localStorage.setItem(KEY, next)
  } catch {
    // Without storage, the choice applies to this visit.
  }
}

function isAppearance(value: string | undefined): value is Appearance {
  return value === 'system' || value === 'light' || value === 'dark'
}
