import type { MeshStandardMaterial, Texture } from 'three'
import { nextTask } from '../../../runtime/next-task.ts'
import type { AnyRenderer } from '../../renderer.ts'
import type { Edit } from '../patch.ts'
import { ComposePolicy } from './compose-policy.ts'
import { isOfBytes } from './composed-type.ts'
import { DualMap } from './dual-map.ts'
import type { FaceHost } from './face-host.ts'
import { type FirstValues, firstValues } from './first-values.ts'
import { isReplaceable, isSampledAlike } from './replaceable-map.ts'
import { type DrawnMeshes, type ReplacingMaps, StandbyProgram } from './standby-program.ts'

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
  readonly #values: FirstValues | null
  #isRefused = false
  #made: Made | null = null

  constructor(host: FaceHost) {
    this.#host = host
    this.#values = firstValues(host.inputs.textures)
  }

  /** Whether a draw can have it. */
  isReadyFor(renderer: AnyRenderer, base: Texture): boolean {
    if (!this.#isReady || this.#isRefused) return false
    return this.#isOf(this.#made!.map, renderer, base)
  }

  get edit(): Edit | null {
    return this.#made!.program.edit
  }

  get #isReady(): boolean {
    return this.#made?.program.isReady === true
  }

  /** Takes the place of the material's own. */
  get maps(): ReplacingMaps {
    return this.#made!.map.maps
  }

  /**
   * Called once in a frame.
   *
   * @param base the material's own map, if a dual map may take its place; else null.
   * @param pixels that the face covers, at most.
   */
  step(renderer: AnyRenderer, base: Texture | null, pixels: number, meshes: DrawnMeshes): void {
    const isUsable = base !== null && !this.#isRefused && isOfBytes(base, this.#host.material)
    const isCurrent = isUsable && (!this.#made || this.#isOf(this.#made.map, renderer, base))
    if (!isCurrent) this.drop()
    if (!this.#policy.step(!isCurrent, pixels, Infinity) || !isUsable || this.#isReady) return
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

  #isOf(map: DualMap, renderer: AnyRenderer, base: Texture): boolean {
    return map.isOf(renderer, base, this.#aoMapBeside(base), this.#host.inputs.textures)
  }

  /** The material's map of occlusion, where one that holds values of the first layer too can replace it unseen; else null. */
  #aoMapBeside(base: Texture): Texture | null {
    const { aoMap } = this.#host.material as Partial<MeshStandardMaterial>
    const isPossible = this.#values && aoMap && isReplaceable(aoMap) && isSampledAlike(aoMap, base)
    return isPossible ? aoMap : null
  }

  #make(renderer: AnyRenderer, base: Texture): Made | null {
    const { material, inputs, patch, shaders } = this.#host
    const aoMap = this.#aoMapBeside(base)
    const map = DualMap.take(this.#host, renderer, base, aoMap, inputs.textures)
    if (!map) return null
    const refuse = () => {
      this.#isRefused = true
    }
    const values = aoMap && this.#values
    // Not before, since it is made for the material's normal map.
    const edit = shaders.dualEdit(material, inputs, { patch, isDual: this.isDual, values, refuse })
    return { map, program: new StandbyProgram(this.#host, edit, map.maps), isPending: false }
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
