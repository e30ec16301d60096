import { type Color, NoToneMapping } from 'three'
import { isWebGL } from '../../../../stage/light.ts'
import type { Stage } from '../../../../stage/stage.ts'
import type { Looks, Side } from './looks.ts'

/** Draws both sides of the divider in one frame: without wrinkles on the left, with wrinkles on the right. */
export class Sides {
  readonly #canvas: HTMLCanvasElement
  readonly #stage: Stage
  readonly #background: Color
  readonly #toneMapping: Stage['renderer']['toneMapping']

  constructor(canvas: HTMLCanvasElement, stage: Stage) {
    this.#canvas = canvas
    this.#stage = stage
    this.#background = (stage.scene.background as Color).clone()
    this.#toneMapping = stage.renderer.toneMapping
  }

  /** @param split position of the divider, as a fraction of the canvas's width. */
  draw(looks: Looks, split: number): void {
    this.#drawBoth(looks, split)
    looks.restore()
  }

  #drawBoth(looks: Looks, split: number): void {
    const { renderer } = this.#stage
    const { clientWidth: width, clientHeight: height } = this.#canvas
    const edge = Math.round(split * width)
    if (edge === 0 || edge === width) {
      renderer.setScissorTest(false)
      this.#drawSide(looks, edge === 0 ? 'with' : 'without')
      return
    }
    renderer.setScissorTest(true)
    renderer.setScissor(0, 0, edge, height)
    this.#drawSide(looks, 'without')
    renderer.setScissor(edge, 0, width - edge, height)
    this.#drawSide(looks, 'with')
  }

  /** Restores the stage's settings. */
  dispose(): void {
    const { renderer, scene } = this.#stage
    scene.background = this.#background
    renderer.toneMapping = this.#toneMapping
    renderer.setScissorTest(false)
  }

  #drawSide(looks: Looks, side: Side): void {
    const { renderer, scene } = this.#stage
    const isLit = looks.isLit(side)
    looks.apply(side)
    ;(scene.background as Color).copy(isLit ? this.#background : looks.technicalBackground)
    // WebGPURenderer tone-maps the complete frame and ignores `toneMapped` of materials.
    if (!isWebGL(renderer)) renderer.toneMapping = isLit ? this.#toneMapping : NoToneMapping
    this.#stage.render()
  }
}
