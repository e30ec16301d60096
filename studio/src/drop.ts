/**
 * Accepts files dropped or pasted anywhere on the page; `overlay` is visible while files are dragged over it.
 *
 * @param onFiles must read what it gets at once.
 */
export function acceptFiles(overlay: HTMLElement, onFiles: (files: DataTransfer) => void): void {
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false
  addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return
    event.preventDefault()
    event.dataTransfer!.dropEffect = 'copy'
    overlay.hidden = false
  })
  addEventListener('dragleave', (event) => {
    // Null when the pointer leaves the page, an element when it moves from one to another.
    if (event.relatedTarget === null) overlay.hidden = true
  })
  addEventListener('drop', (event) => {
    if (!hasFiles(event)) return
    overlay.hidden = true
    // Something on the page took them.
    if (event.defaultPrevented) return
    event.preventDefault()
    onFiles(event.dataTransfer!)
  })
  addEventListener('paste', ({ clipboardData }) => {
    if (clipboardData?.types.includes('Files')) onFiles(clipboardData)
  })
}
