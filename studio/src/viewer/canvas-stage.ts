import { isWebGL } from '../../../stage/light.ts'
import { createStage, type RendererKind, type Stage } from '../../../stage/stage.ts'

/** A canvas and the stage that draws on it, for one viewer after the other. */
export interface CanvasStage {
  readonly canvas: HTMLCanvasElement
  readonly kind: RendererKind
  readonly stage: Stage
}

/** Replaces what is in an element by a canvas with a stage. Throws Error if the browser has no WebGL 2 or WebGPU. */
export async function openCanvas(viewport: HTMLElement, kind: RendererKind): Promise<CanvasStage> {
  const canvas = document.createElement('canvas')
  viewport.replaceChildren(canvas)
  return { canvas, kind, stage: await createStage(canvas, kind) }
}

/** Frees all that the stage has on the GPU. */
export function closeCanvas({ canvas, stage }: CanvasStage): void {
  const { renderer } = stage
  stage.dispose()
  if (isWebGL(renderer)) renderer.forceContextLoss()
  canvas.remove()
}
