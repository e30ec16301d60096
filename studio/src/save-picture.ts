/**
 * Saves what a canvas shows. Call it in the same task as the drawing: a WebGPU canvas is blank afterwards.
 *
 * @throws Error when the browser cannot encode it.
 */
export async function savePicture(canvas: HTMLCanvasElement, name: string): Promise<void> {
  const file = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'))
  if (!file) {
    throw new Error(
      `Studio: the picture cannot be saved, got ${canvas.width} x ${canvas.height}; try a smaller window`,
    )
  }
  const link = document.createElement('a')
  link.href = URL.createObjectURL(file)
  link.download = name
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}
