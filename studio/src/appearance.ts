import { signal } from '@preact/signals'

/** Colour scheme of the page. `system` follows the system. */
export type Appearance = 'system' | 'light' | 'dark'

/** Storage key, also read by a script in `index.html` before the first paint. */
const KEY = 'appearance'

const { dataset } = document.documentElement
const appearance = signal(isAppearance(dataset.appearance) ? dataset.appearance : 'system')

export function chosenAppearance(): Appearance {
  return appearance.value
}

export function chooseAppearance(next: Appearance): void {
  appearance.value = next
  dataset.appearance = next
  try {
    localStorage.setItem(KEY, next)
  } catch {
    // If the browser blocks storage, the choice lasts until the page closes.
  }
}

function isAppearance(value: string | undefined): value is Appearance {
  return value === 'system' || value === 'light' || value === 'dark'
}
