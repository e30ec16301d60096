/**
 * Accepts files dropped or pasted on the page. `overlay` is visible while files are dragged over it.
 *
 * @param onFiles must read its argument synchronously.
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
    // relatedTarget is null when the pointer leaves the page, and an element when it moves between elements.
    if (event.relatedTarget === null) overlay.hidden = true
  })
  addEventListener('drop', (event) => {
    if (!hasFiles(event)) return
    overlay.hidden = true
    // An element of the page handled the drop.
    if (event.defaultPrevented) return
    event.preventDefault()
    onFiles(event.dataTransfer!)
  })
  addEventListener('paste', ({ clipboardData }) => {
    if (clipboardData?.types.includes('Files')) onFiles(clipboardData)
  })
}
