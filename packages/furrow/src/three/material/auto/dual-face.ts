import type { Texture } from 'three'
import { nextTask } from '../../../runtime/next-task.ts'
import type { AnyRenderer } from '../../renderer.ts'
import type { Edit } from '../patch.ts'
import { ComposePolicy } from './compose-policy.ts'
import { isOfBytes } from './composed-type.ts'
import { DualMap } from './dual-map.ts'
import type { FaceHost } from './face-host.ts'
import { type DrawnMeshes, StandbyProgram } from './standby-program.ts'

interface Made {
  map: DualMap
  program: StandbyProgram
  /** Whether it is being drawn and compiled. */
  isPending: boolean
}

/** What a face is drawn with while it moves: a dual map, and a program that reads it. */
export class DualFace {
  /** See `DualParts`. */
  readonly isDual = { value: 0 }
  readonly #host: FaceHost
  readonly #policy = new ComposePolicy()
  #isRefused = false
  #made: Made | null = null

  constructor(host: FaceHost) {
    this.#host = host
  }

  /** Whether a draw can have it. */
  isReadyFor(renderer: AnyRenderer, base: Texture): boolean {
    if (!this.#isReady || this.#isRefused) return false
    return this.#made!.map.isOf(renderer, base, this.#host.inputs.textures)
  }

  get edit(): Edit | null {
    return this.#made!.program.edit
  }

  get #isReady(): boolean {
    return this.#made?.program.isReady === true
  }

  get texture(): Texture {
    return this.#made!.map.texture
  }

  /**
   * Called once in a frame.
   *
   * @param base the material's own map, if a dual map may take its place; else null.
   * @param pixels that the face covers, at most.
   */
  step(renderer: AnyRenderer, base: Texture | null, pixels: number, meshes: DrawnMeshes): void {
    const { material, inputs } = this.#host
    const isUsable = base !== null && !this.#isRefused && isOfBytes(base, material)
    const isCurrent = isUsable && (this.#made?.map.isOf(renderer, base, inputs.textures) ?? true)
    if (!isCurrent) this.drop()
    if (!this.#policy.step(!isCurrent, pixels) || !isUsable || this.#isReady) return
    this.#policy.reset()
    this.#made ??= this.#make(renderer, base)
    if (this.#made && !this.#made.isPending) this.#prepare(this.#made, renderer, meshes)
  }

  drop(): void {
    if (!this.#made) return
    this.#host.end()
    this.#made.program.dispose()
    this.#made.map.release()
    this.#made = null
  }

  #make(renderer: AnyRenderer, base: Texture): Made | null {
    const { material, inputs, patch, shaders } = this.#host
    const map = DualMap.take(this.#host, renderer, base, inputs.textures)
    if (!map) return null
    const refuse = () => {
      this.#isRefused = true
    }
    // Not before, since it is made for the material's normal map.
    const edit = shaders.dualEdit(material, inputs, { patch, isDual: this.isDual, refuse })
    return { map, program: new StandbyProgram(this.#host, edit, map.texture), isPending: false }
  }

  /** Beside the frames, so that none waits for it; what cannot be drawn is not shown. */
  async #prepare(made: Made, renderer: AnyRenderer, meshes: DrawnMeshes) {
    made.isPending = true
    try {
      await nextTask()
      if (this.#made === made) await made.map.draw(this.#host.inputs)
      if (this.#made === made) await made.program.prepare(renderer, meshes)
    } catch {
      // The default mode goes on.
    }
    made.isPending = false
  }
}
