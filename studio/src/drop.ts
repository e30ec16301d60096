/** Accepts files dropped anywhere on the page; `overlay` is visible while files are dragged over it. */
export function acceptDrops(overlay: HTMLElement, onFiles: (files: File[]) => void): void {
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
    event.preventDefault()
    overlay.hidden = true
    onFiles([...event.dataTransfer!.files])
  })
}
