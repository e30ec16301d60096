import { signal } from '@preact/signals'

/** Whether the page is light or dark; `system` follows the system. */
export type Appearance = 'system' | 'light' | 'dark'

/** In the browser's storage, which a script in `index.html` reads before the page is drawn. */
const KEY = 'appearance'

const { dataset } = document.documentElement
const appearance = signal(isAppearance(dataset.appearance) ? dataset.appearance : 'system')

/** What was chosen, now or on an earlier visit. */
export function chosenAppearance(): Appearance {
  return appearance.value
}

/** Draws the page so, now and on the next visit. */
export function chooseAppearance(next: Appearance): void {
  appearance.value = next
  dataset.appearance = next
  try {
    localStorage.setItem(KEY, next)
  } catch {
    // Where nothing may be kept, it is chosen for this visit.
  }
}

function isAppearance(value: string | undefined): value is Appearance {
  return value === 'system' || value === 'light' || value === 'dark'
}
