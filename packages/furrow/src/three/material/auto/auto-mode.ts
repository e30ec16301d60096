import {
  type Camera,
  type Mesh,
  type MeshStandardMaterial,
  type RenderTarget,
  type Scene,
  type Texture,
  Vector4,
} from 'three'
import { hasMoved } from '../../../runtime/atlas-cells.ts'
import { reachNothing } from '../../../runtime/reach.ts'
import { callAfterRender } from '../../mesh/before-render.ts'
import type { AnyRenderer } from '../../renderer.ts'
import type { Edit } from '../patch.ts'
import { ComposedFace, type View } from './composed-face.ts'
import { DualFace } from './dual-face.ts'
import type { AutoModeHost, FaceHost } from './face-host.ts'
import { isRepeated, isReplaceable } from './replaceable-map.ts'
import { pixelsOnScreen, sideOnScreen } from './screen-need.ts'
import { ShownEdit } from './shown-edit.ts'
import type { DrawnMesh, ReplacingMaps } from './standby-program.ts'

/** Frames in a row of other renderers after which the one that maps were made for no longer draws the face. */
const ABSENCE = 60

/** What a draw has replaced. */
interface Replaced {
  map: Texture
  aoMap: Texture | null
  /** What is in their place. */
  shown: ReplacingMaps
  /** How far wrinkles have faded. */
  fade: number
}

/**
 * Draws a face in the cheapest way that looks as the default mode does, with another map in place of its normal map: while it moves, with a dual
 * map, and while it holds still, or covers many more pixels than are redrawn of it, with a composed one. Both have programs, which are compiled beside the frames, as the maps are drawn; until then it is
 * the default mode's. Any draw may be in any way. The map is the material's only during the draw. Of several renderers that draw the face in turns one has
 * maps, and the others the default mode: each could have maps, but nothing tells when one is no longer used.
 */
export class AutoMode {
  readonly #host: FaceHost
  readonly #composed: ComposedFace
  readonly #dual: DualFace | null
  /** That has the maps, and frames of others since its last one. */
  #renderer: AnyRenderer | null = null
  #others = 0
  /** The activations of the frame before, and the version of what else wrinkles are drawn from. */
  #values = new Float32Array(0)
  #version = -1
  /** Of the last frame in which it was drawn, and of this one so far. */
  #seen: View = { pixels: 0, side: 0 }
  #view: View = { pixels: 0, side: 0 }
  /** The material's own, while others are set. */
  #own: Replaced | null = null
  /** Where there are wrinkles, meanwhile. */
  readonly #ownReach = new Vector4()
  readonly #watched = new Map<Mesh, () => void>()
  readonly #drawn = new Map<Mesh, DrawnMesh>()
  /** Shadows are drawn during the mesh's own draw on `WebGPURenderer`. */
  readonly #end = (_renderer: AnyRenderer, _camera: Camera, { overrideMaterial }: Scene) => {
    if (!overrideMaterial) this.end()
  }

  constructor(host: AutoModeHost) {
    const shown = new ShownEdit(host.material, host.patch)
    this.#host = { ...host, shown, end: () => this.end() }
    this.#composed = new ComposedFace(this.#host)
    this.#dual = host.hasOwnProgram ? new DualFace(this.#host) : null
  }

  /** Whether another map is the material's now. */
  get isReplaced(): boolean {
    return this.#own !== null
  }

  /** Called once in a frame, when the influence map is up to date. */
  step(renderer: AnyRenderer, values: Float32Array, isPossible: boolean): void {
    const isOther = renderer !== this.#renderer
    if (isOther && this.#renderer && this.#others++ < ABSENCE) return
    this.#renderer = renderer
    this.#others = 0
    if (isOther) this.#composed.drop()
    this.#takeView()
    const { material, inputs } = this.#host
    const { normalMap } = material
    const base = isPossible && normalMap && isReplaceable(normalMap) ? normalMap : null
    const isWhole = inputs.fade.value === 1
    const hasMoved = this.#follow(values)
    this.#composed.step(renderer, isWhole ? base : null, this.#seen, this.#values, hasMoved, this.#drawn)
    this.#dual?.step(renderer, this.#composed.isRedrawn ? null : base, this.#seen.pixels, this.#drawn)
  }

  /** Called before a mesh is drawn, after everything else is up to date. */
  begin(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    if (renderer !== this.#renderer) {
      this.pause()
      return
    }
    this.#note(renderer, camera, mesh)
    this.#host.shown.show(this.#replaceMap(renderer, camera, mesh))
  }

  /** Called before another mesh with the material is drawn. */
  pause(): void {
    this.#host.shown.show(this.#host.patch.edit)
  }

  /** Called after a mesh is drawn, and before one is prepared: whoever replaces `onAfterRender` costs nothing but what a page sees of the material. */
  end(): void {
    if (!this.#own) return
    const { material, inputs } = this.#host
    const { map, aoMap, shown, fade } = this.#own
    const lit = material as MeshStandardMaterial
    if (lit.normalMap === shown.normals) lit.normalMap = map
    if (shown.occlusion && lit.aoMap === shown.occlusion) lit.aoMap = aoMap
    inputs.fade.value = fade
    inputs.reach.value.copy(this.#ownReach)
    if (this.#dual) this.#dual.isDual.value = 0
    this.#own = null
  }

  dispose(): void {
    this.end()
    this.#composed.drop()
    this.#dual?.drop()
    this.pause()
    for (const unwatch of this.#watched.values()) unwatch()
    this.#watched.clear()
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

  /** Sets another map for a draw, if there is one that it is right for. Returns the edit that it is drawn by. */
  #replaceMap(renderer: AnyRenderer, camera: Camera, mesh: Mesh): Edit | null {
    const { material, patch } = this.#host
    const base = material.normalMap
    if (!base || !isRepeated(base, mesh)) return patch.edit
    const side = sideOnScreen(mesh, camera, renderer, base.channel)
    this.#addView(side, pixelsOnScreen(mesh, camera, renderer))
    const made = this.#composed.mapsFor(base, side)
    if (made) {
      this.#replace(mesh, base, made.maps)
      this.#rest()
      return made.program?.isReady ? made.program.edit : patch.edit
    }
    const dual = this.#dual
    if (!dual?.isReadyFor(renderer, base)) return patch.edit
    this.#replace(mesh, base, dual.maps)
    dual.isDual.value = 1
    return dual.edit
  }

  #replace(mesh: Mesh, base: Texture, shown: ReplacingMaps): void {
    const { material, inputs } = this.#host
    if (!this.#watched.has(mesh)) this.#watched.set(mesh, callAfterRender(mesh, this.#end))
    if (base.matrixAutoUpdate) base.updateMatrix()
    const { normals, occlusion } = shown
    normals.matrix.copy(base.matrix)
    occlusion?.matrix.copy(base.matrix)
    const lit = material as MeshStandardMaterial
    this.#own = { map: base, aoMap: lit.aoMap, shown, fade: inputs.fade.value }
    this.#ownReach.copy(inputs.reach.value)
    material.normalMap = normals
    if (occlusion) lit.aoMap = occlusion
  }

  /** The map has the wrinkles. */
  #rest(): void {
    const { inputs } = this.#host
    inputs.fade.value = 0
    // Vertices of relief have branches, and know by this that there is nothing to sample.
    reachNothing(inputs.reach.value)
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

  #takeView(): void {
    if (this.#view.pixels === 0) return
    ;[this.#seen, this.#view] = [this.#view, this.#seen]
    this.#view.pixels = this.#view.side = 0
  }

  #addView(side: number, pixels: number): void {
    this.#view.side = Math.max(this.#view.side, side)
    this.#view.pixels = Math.max(this.#view.pixels, pixels)
  }
}

/** What the page draws to. */
function targetOf(renderer: AnyRenderer): RenderTarget | null {
  const target = renderer.getRenderTarget() as RenderTarget & { isPostProcessingRenderTarget?: boolean }
  // `WebGPURenderer` maps tones from one of its own to the canvas.
  return target?.isPostProcessingRenderTarget ? null : target
}
