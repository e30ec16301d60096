/** What shortcuts do. */
export interface ShortcutActions {
  undo(): void
  redo(): void
}

/** Listens to Ctrl+Z, Ctrl+Shift+Z and Ctrl+Y, with Command on a Mac. Text fields keep their own undo. */
export function addShortcuts({ undo, redo }: ShortcutActions): void {
  addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || isTextField(event.target)) return
    const key = event.key.toLowerCase()
    const action = key === 'y' || (key === 'z' && event.shiftKey) ? redo : key === 'z' ? undo : null
    if (!action) return
    event.preventDefault()
    action()
  })
}

/** Whether keys pressed in an element are text. */
export function isTextField(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement && !['range', 'checkbox', 'radio'].includes(target.type)
}
