import { type Camera, type Mesh, type RenderTarget, type Scene, type Texture, Vector4 } from 'three'
import { hasMoved } from '../../../runtime/atlas-cells.ts'
import { nextTask } from '../../../runtime/next-task.ts'
import { reachNothing } from '../../../runtime/reach.ts'
import type { QuadMaterials } from '../../atlas/quad-materials.ts'
import { callAfterRender } from '../../mesh/before-render.ts'
import type { AnyRenderer } from '../../renderer.ts'
import {
  type ComposedFormat,
  ComposedMap,
  type ComposeMaterial,
  composedSize,
  levelsOf,
  type Size,
} from '../composed-map.ts'
import type { Patch } from '../patch.ts'
import type { ShaderInputs } from '../shader-inputs.ts'
import type { WrinkleMaterial } from '../wrinkle-material.ts'
import { ComposePolicy } from './compose-policy.ts'
import { bytesOfTexel, composedType } from './composed-type.ts'
import { type DrawnMesh, OwnProgram } from './own-program.ts'
import { isRepeated, isReplaceable } from './replaceable-map.ts'
import { halvingsOf, pixelsOnScreen, sideOnScreen } from './screen-need.ts'

/** How much finer than the screen needs a map is made, so that a camera that comes a little nearer keeps it. */
const RESERVE = 1.2

/** Frames in a row of other renderers after which the one that a map was made for no longer draws the face. */
const ABSENCE = 60

const NO_SIZE: Size = { width: 0, height: 0 }

/** Bytes on the GPU of the maps of all faces. */
let allocated = 0

/** The face that it is drawn for. */
export interface AutoModeHost {
  material: WrinkleMaterial
  inputs: ShaderInputs
  /** What makes the default mode of it. */
  patch: Patch
  /** Whether the material's own program may be drawn instead. */
  hasOwnProgram: boolean
  hasContents: QuadMaterials['hasContents']
  composeMaterial: ComposeMaterial
  /** Bytes that the maps of all faces may take together. */
  budget: number
}

/** A composed map, and what it was made from. */
interface Made {
  map: ComposedMap
  base: Texture
  baseVersion: number
  /** How often the sides of the full size were halved. */
  halvings: number
  bytes: number
  /** What draws the face meanwhile; null where that is always the default mode's. */
  program: OwnProgram | null
  state: 'new' | 'drawing' | 'drawn'
}

/** What the views of a frame need. */
interface View {
  /** That the face covers, at most. */
  pixels: number
  /** Texels of the finest level that is seen, if the whole map were as fine. */
  side: number
}

/**
 * Draws a face with a composed map in place of its normal map while that is cheaper: in the material's own program where that can be compiled
 * beforehand, else in the default mode's. Any draw may be either way. The map is the material's only during the draw. Of several renderers that draw
 * the face in turns one has a map, and the others the default mode: each could have a map, but nothing tells when one is no longer used.
 */
export class AutoMode {
  readonly #host: AutoModeHost
  readonly #policy = new ComposePolicy()
  /** That has the map, and frames of others since its last one. */
  #renderer: AnyRenderer | null = null
  #others = 0
  /** The activations of the frame before, and the version of what else wrinkles are drawn from. */
  #values = new Float32Array(0)
  #version = -1
  #made: Made | null = null
  /** Of the last frame in which it was drawn, and of this one so far. */
  #seen: View = { pixels: 0, side: 0 }
  #view: View = { pixels: 0, side: 0 }
  /** The material's own map, and how far wrinkles have faded, while another is set. */
  #own: { map: Texture; fade: number } | null = null
  /** Where there are wrinkles, meanwhile. */
  readonly #ownReach = new Vector4()
  /** Whether the material's own program is drawn instead of the default mode's. */
  #isOwn = false
  readonly #watched = new Map<Mesh, () => void>()
  readonly #drawn = new Map<Mesh, DrawnMesh>()
  /** Shadows are drawn during the mesh's own draw on `WebGPURenderer`. */
  readonly #end = (_renderer: AnyRenderer, _camera: Camera, { overrideMaterial }: Scene) => {
    if (!overrideMaterial) this.end()
  }

  constructor(host: AutoModeHost) {
    this.#host = host
  }

  /** Whether the composed map is the material's now. */
  get isComposed(): boolean {
    return this.#own !== null
  }

  /** Called once in a frame, when the influence map is up to date. */
  step(renderer: AnyRenderer, values: Float32Array, isPossible: boolean): void {
    const isOther = renderer !== this.#renderer
    if (isOther && this.#renderer && this.#others++ < ABSENCE) return
    this.#renderer = renderer
    this.#others = 0
    this.#takeView()
    const { material, inputs, hasContents } = this.#host
    const base = material.normalMap
    const isUsable = isPossible && inputs.fade.value === 1 && base !== null && isReplaceable(base)
    const size = isUsable ? composedSize(base, inputs.textures.normals.texture) : NO_SIZE
    const made = this.#made
    const isLost = made?.state === 'drawn' && !hasContents(renderer, made.map.target)
    const isFit =
      isUsable && !isOther && (!made || this.#isKept(made, base, halvingsOf(size, this.#seen.side)))
    if (!isFit || isLost) this.#drop()
    const hasChanged = this.#follow(values) || !isFit || isLost
    const isWanted = this.#policy.step(hasChanged, this.#seen.pixels)
    if (!isWanted && this.#made) this.#made.state = 'new'
    if (!isWanted || !isUsable) return
    this.#made ??= this.#make(base, size)
    if (this.#made?.state === 'new') this.#draw(this.#made, renderer, values)
  }

  /** Called before a mesh is drawn, after everything else is up to date. */
  begin(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    if (renderer !== this.#renderer) {
      this.pause()
      return
    }
    this.#note(renderer, camera, mesh)
    const isReplaced = this.#replaceMap(renderer, camera, mesh)
    this.#showProgram(isReplaced && this.#made?.program?.isReady === true)
  }

  /** Called before another mesh with the material is drawn. */
  pause(): void {
    this.#showProgram(false)
  }

  #showProgram(isOwn: boolean): void {
    if (isOwn === this.#isOwn) return
    this.#isOwn = isOwn
    this.#host.patch.setShown(!isOwn)
    this.#host.material.needsUpdate = true
  }

  #note(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    const target = targetOf(renderer)
    const drawn = this.#drawn.get(mesh)
    if (!drawn) {
      this.#drawn.set(mesh, { camera, target })
      return
    }
    drawn.camera = camera
    drawn.target = target
  }

  /** Sets the composed map for a draw, if it is one that it is right for. */
  #replaceMap(renderer: AnyRenderer, camera: Camera, mesh: Mesh): boolean {
    const { material, inputs } = this.#host
    const base = material.normalMap
    if (!base || !isRepeated(base, mesh)) return false
    const side = sideOnScreen(mesh, camera, renderer, base.channel)
    this.#addView(side, pixelsOnScreen(mesh, camera, renderer))
    const made = this.#made
    if (made?.state !== 'drawn' || made.base !== base) return false
    // Another view of this frame may be nearer than those of the last.
    if (halvingsOf(composedSize(base, inputs.textures.normals.texture), side) < made.halvings) return false
    if (!this.#watched.has(mesh)) this.#watched.set(mesh, callAfterRender(mesh, this.#end))
    const { texture } = made.map.target
    if (base.matrixAutoUpdate) base.updateMatrix()
    texture.matrix.copy(base.matrix)
    this.#own = { map: base, fade: inputs.fade.value }
    this.#ownReach.copy(inputs.reach.value)
    material.normalMap = texture
    inputs.fade.value = 0
    // Where shaders have branches, they know by this that there is nothing to sample.
    reachNothing(inputs.reach.value)
    return true
  }

  /** Called after a mesh is drawn, and before one is prepared: whoever replaces `onAfterRender` costs nothing but what a page sees of the material. */
  end(): void {
    if (!this.#own) return
    const { material, inputs } = this.#host
    if (material.normalMap === this.#made?.map.target.texture) material.normalMap = this.#own.map
    inputs.fade.value = this.#own.fade
    inputs.reach.value.copy(this.#ownReach)
    this.#own = null
  }

  dispose(): void {
    this.end()
    this.#drop()
    this.#showProgram(false)
    for (const unwatch of this.#watched.values()) unwatch()
    this.#watched.clear()
  }

  /** Makes a map as fine as the screen needs; null if there is not the memory for it. */
  #make(base: Texture, { width, height }: Size): Made | null {
    const { material: shown, patch, hasOwnProgram, inputs, hasContents, composeMaterial, budget } = this.#host
    const halvings = halvingsOf({ width, height }, RESERVE * this.#seen.side)
    const halved = { width: width >> halvings, height: height >> halvings }
    const type = composedType(base, shown)
    const format: ComposedFormat = { ...halved, type, levels: levelsOf(halved) }
    // With mipmaps, which take a third.
    const bytes = Math.ceil((format.width * format.height * bytesOfTexel(type) * 4) / 3)
    if (allocated + bytes > budget) return null
    allocated += bytes
    // The face's own fade is 0 while the map is drawn in its place.
    const material = composeMaterial(base, { ...inputs, fade: { value: 1 } })
    const map = new ComposedMap(base, format, material, hasContents)
    map.target.texture.matrixAutoUpdate = false
    const program = hasOwnProgram ? new OwnProgram(shown, patch, map.target.texture) : null
    return { map, base, baseVersion: base.version, halvings, bytes, program, state: 'new' }
  }

  /** After this frame, so that it does not wait for it; what cannot be drawn is not shown. */
  #draw(made: Made, renderer: AnyRenderer, values: Float32Array): void {
    made.state = 'drawing'
    const { areas, textures } = this.#host.inputs
    const isCurrent = () => this.#made === made && made.state === 'drawing'
    const draw = () => {
      if (!isCurrent()) return
      made.map.update(renderer, areas, values, 1, areas.version + textures.version)
      made.state = 'drawn'
    }
    const compile = async () => {
      await nextTask()
      if (!isCurrent()) return
      const { map, program } = made
      await map.compile(renderer)
      if (isCurrent()) await program?.prepare(renderer, this.#drawn)
    }
    compile().then(draw, () => {})
  }

  /** Whether wrinkles have changed since the last call. */
  #follow(values: Float32Array): boolean {
    const { areas, textures } = this.#host.inputs
    const version = areas.version + textures.version
    let hasChanged = version !== this.#version || values.length !== this.#values.length
    this.#version = version
    if (values.length !== this.#values.length) this.#values = values.slice()
    for (let i = 0; i < values.length; i++) {
      if (!hasMoved(values[i], this.#values[i])) continue
      this.#values[i] = values[i]
      hasChanged = true
    }
    return hasChanged
  }

  /** Whether a map still serves. */
  #isKept(made: Made, base: Texture, halvings: number): boolean {
    if (made.base !== base || made.baseVersion !== base.version) return false
    if (made.map.target.texture.type !== composedType(base, this.#host.material)) return false
    return halvings === made.halvings || halvings === made.halvings + 1
  }

  #takeView(): void {
    if (this.#view.pixels === 0) return
    ;[this.#seen, this.#view] = [this.#view, this.#seen]
    this.#view.pixels = this.#view.side = 0
  }

  #addView(side: number, pixels: number): void {
    this.#view.side = Math.max(this.#view.side, side)
    this.#view.pixels = Math.max(this.#view.pixels, pixels)
  }

  #drop(): void {
    if (!this.#made) return
    this.end()
    allocated -= this.#made.bytes
    this.#made.map.dispose()
    this.#made.program?.dispose()
    this.#made = null
  }
}

/** What the page draws to. */
function targetOf(renderer: AnyRenderer): RenderTarget | null {
  const target = renderer.getRenderTarget() as RenderTarget & { isPostProcessingRenderTarget?: boolean }
  // `WebGPURenderer` maps tones from one of its own to the canvas.
  return target?.isPostProcessingRenderTarget ? null : target
}
