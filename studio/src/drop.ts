/**
 * Accepts files that the user drops or pastes on the page. `overlay` is visible while the user drags files over the page.
 *
 * @param onFiles must read its argument synchronously, because browsers empty it after the event.
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
    // Another element has already handled the drop.
    if (event.defaultPrevented) return
    event.preventDefault()
    onFiles(event.dataTransfer!)
  })
  addEventListener('paste', ({ clipboardData }) => {
    if (clipboardData?.types.includes('Files')) onFiles(clipboardData)
  })
}
