import { saveFile } from './save-file.ts'

/**
 * Saves a canvas as a PNG file. Call it in the task that draws, because a WebGPU canvas is blank afterwards.
 *
 * @throws Error if the browser cannot encode the picture.
 */
export async function savePicture(canvas: HTMLCanvasElement, name: string): Promise<void> {
  const file = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'))
  if (!file) {
    throw new Error(
      `Studio: cannot save the picture, got ${canvas.width} x ${canvas.height} pixels; make the window smaller`,
    )
  }
  saveFile(file, name)
}
