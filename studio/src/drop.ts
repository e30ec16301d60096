/** Takes files that are dropped anywhere on the page; `overlay` shows meanwhile. */
export function takeDrops(overlay: HTMLElement, onFiles: (files: File[]) => void): void {
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false
  addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return
    event.preventDefault()
    event.dataTransfer!.dropEffect = 'copy'
    overlay.hidden = false
  })
  addEventListener('dragleave', (event) => {
    // Null when the pointer leaves the page, an element when it only passes from one to the next.
    if (event.relatedTarget === null) overlay.hidden = true
  })
  addEventListener('drop', (event) => {
    if (!hasFiles(event)) return
    event.preventDefault()
    overlay.hidden = true
    onFiles([...event.dataTransfer!.files])
  })
}
