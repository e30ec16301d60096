import { effect, signal } from '@preact/signals'
import { PLACES } from '../labels/page.ts'

/** Panels that share the sheet of a small page. */
const SHEETS = [
  { value: 'drawer', label: PLACES.regions },
  { value: 'inspector', label: PLACES.inspector },
  { value: 'poses', label: PLACES.expressions },
] as const

type Sheet = (typeof SHEETS)[number]['value']

/** Panel in the sheet, or null if the sheet is closed. */
const sheet = signal<Sheet | null>('poses')

// The style sheet shows only this panel on small pages, and all panels on large ones.
effect(() => {
  document.body.dataset.sheet = sheet.value ?? ''
})

/** Buttons that choose the panel in the sheet of a small page. A second press closes the sheet. */
export function SheetTabs() {
  return (
    <>
      {SHEETS.map(({ value, label }) => (
        <button
          key={value}
          type="button"
          aria-expanded={sheet.value === value}
          aria-controls={value}
          onClick={() => {
            sheet.value = sheet.peek() === value ? null : value
          }}
        >
          {label}
        </button>
      ))}
    </>
  )
}
