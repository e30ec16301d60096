import { effect, signal } from '@preact/signals'
import { POSES } from '../labels/joints.ts'
import { PLACES } from '../labels/page.ts'
import type { PanelModel } from '../panels/model.ts'

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
export function SheetTabs({ model: { viewer } }: { model: PanelModel }) {
  const isBodyOnly = viewer.value?.targets.length === 0
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
          {value === 'poses' && isBodyOnly ? POSES.title : label}
        </button>
      ))}
    </>
  )
}
