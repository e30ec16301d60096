import { isWebGL } from '../../../stage/light.ts'
import { createStage, type RendererKind, type Stage } from '../../../stage/stage.ts'

/** Canvas with a stage (renderer, scene and camera). Successive viewers reuse it. */
export interface CanvasStage {
  readonly canvas: HTMLCanvasElement
  readonly kind: RendererKind
  readonly stage: Stage
}

/** Replaces an element's content by a canvas with a stage. Throws Error if the browser lacks WebGL 2 or WebGPU. */
export async function openCanvas(viewport: HTMLElement, kind: RendererKind): Promise<CanvasStage> {
  const canvas = document.createElement('canvas')
  viewport.replaceChildren(canvas)
  return { canvas, kind, stage: await createStage(canvas, kind) }
}

export function closeCanvas({ canvas, stage }: CanvasStage): void {
  const { renderer } = stage
  stage.dispose()
  if (isWebGL(renderer)) renderer.forceContextLoss()
  canvas.remove()
}
