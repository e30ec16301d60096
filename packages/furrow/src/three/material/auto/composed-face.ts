import { type MeshStandardMaterial, RedFormat, type Texture } from 'three'
import { nextTask } from '../../../runtime/next-task.ts'
import type { AreaArray } from '../../atlas/area-array.ts'
import type { AnyRenderer } from '../../renderer.ts'
import { ComposedMap, composedSize, levelsOf, type Size, shareOf } from '../composed-map.ts'
import type { Edit } from '../patch.ts'
import { ComposePolicy } from './compose-policy.ts'
import { bytesOfTexel, composedType } from './composed-type.ts'
import type { FaceHost } from './face-host.ts'
import { OwnMaps } from './own-maps.ts'
import { isReplaceable, isSampledAlike } from './replaceable-map.ts'
import { halvingsOf } from './screen-need.ts'
import { type DrawnMeshes, type ReplacingMaps, StandbyProgram } from './standby-program.ts'
import { allocate, bytesOfMap, free } from './texture-budget.ts'

/** How much finer than the screen needs a map is made, so that a camera that comes a little nearer keeps it. */
const RESERVE = 1.2

const NO_SIZE: Size = { width: 0, height: 0 }

/** Composed maps, and what they were made from. */
interface Made {
  normals: ComposedMap
  /** The material's own occlusion with that of the layers; null where one of them has none. */
  occlusion: ComposedMap | null
  maps: ReplacingMaps
  own: OwnMaps
  /** How often the sides of the full size were halved. */
  halvings: number
  bytes: number
  /** What draws the face meanwhile; null where that is always the default mode's. */
  program: StandbyProgram | null
  state: 'new' | 'drawing' | 'drawn'
  /** Whether its program could not be made when it was last prepared. */
  isRefused: boolean
}

/** What the views of a frame need. */
export interface View {
  /** That the face covers, at most. */
  pixels: number
  /** Texels of the finest level that is seen, if the whole map were as fine. */
  side: number
}

/**
 * What a face is drawn with while it holds still, and while it moves where it covers many more pixels than its map has texels: a map of normals that
 * are mixed already, and the material's own program. Where layers have occlusion and blood, the map has these too, in blue and alpha, and a program
 * is compiled that reads them.
 */
export class ComposedFace {
  readonly #host: FaceHost
  readonly #policy = new ComposePolicy()
  readonly #edit: Edit | null
  /** Whether the edit turned out not to be possible. */
  #isRefused = false
  #made: Made | null = null
  #isRedrawn = false
  /** What the influence map shows: what a page has changed since is not in it. */
  #areas: AreaArray | null = null
  #values: Float32Array = new Float32Array(0)
  #version = 0
  /** Version of that map's texture, which is empty when it has grown. */
  #atlasVersion = 0
  /** Part of the map that areas of this version reach. */
  #share = 0
  #shareVersion = -1

  constructor(host: FaceHost) {
    this.#host = host
    const { hasValues, shaders, material, inputs, patch, channels } = host
    const refuse = () => {
      this.#isRefused = true
    }
    this.#edit = hasValues ? shaders.composedEdit(material, inputs, { patch, channels, refuse }) : null
  }

  /** Whether the face has a map, which is shown while it moves too. */
  get isRedrawn(): boolean {
    return this.#isRedrawn
  }

  /**
   * Called once in a frame, when the influence map is up to date.
   *
   * @param values the activations that the influence map shows.
   * @param hasMoved whether they have changed.
   */
  step(
    renderer: AnyRenderer,
    base: Texture | null,
    { pixels, side }: View,
    values: Float32Array,
    hasMoved: boolean,
    meshes: DrawnMeshes,
  ): void {
    const isUsable = base !== null && this.#canCompose(base)
    this.#note(values)
    const size = isUsable ? this.#sizeFor(base) : NO_SIZE
    const made = this.#made
    const isLost = made?.state === 'drawn' && !this.#host.hasContents(renderer, made.normals.target)
    const isFit = isUsable && (!made || this.#isKept(made, base, halvingsOf(size, side)))
    if (!isFit || isLost) {
      this.drop()
      this.#policy.reset()
    }
    // Occlusion and blood take as long as normals.
    const maps = this.#host.hasValues ? 2 : 1
    const texels = this.#canRedraw ? size.width * size.height * this.#share * maps : Infinity
    const isWanted = this.#policy.step(hasMoved, pixels, texels)
    if (!isWanted && this.#made) this.#made.state = 'new'
    if (isWanted && isUsable) {
      this.#made ??= this.#make(base, size, side)
      if (this.#made?.state === 'new') this.#prepare(this.#made, renderer, meshes)
      else if (this.#made?.state === 'drawn') this.#draw(this.#made, renderer)
    }
    this.#isRedrawn = isWanted && this.#made !== null && this.#policy.isRedrawn(pixels, texels)
  }

  /** The maps to draw with, if they are fine enough for a view; null else. */
  mapsFor(base: Texture, side: number): Made | null {
    const made = this.#made
    if (made?.state !== 'drawn' || made.own.base !== base || this.#isRefused) return null
    if (this.#host.hasValues && !made.program?.isReady) return null
    // Another view of this frame may be nearer than those of the last.
    return halvingsOf(this.#sizeFor(base), side) < made.halvings ? null : made
  }

  drop(): void {
    if (!this.#made) return
    this.#host.end()
    const { normals, occlusion, program, bytes } = this.#made
    this.#made = null
    free(bytes)
    normals.dispose()
    occlusion?.dispose()
    program?.dispose()
  }

  /** Whether the shader then saves something. */
  get #canRedraw(): boolean {
    return this.#host.hasOwnProgram && !this.#made?.isRefused
  }

  #sizeFor(base: Texture): Size {
    return composedSize(base, this.#host.inputs.textures.normals.texture)
  }

  /** The material's map of occlusion, if the layers have occlusion too. */
  get #ownOcclusion(): Texture | null {
    const { material, inputs } = this.#host
    const { aoMap = null } = material as Partial<MeshStandardMaterial>
    return inputs.textures.values.occlusion ? aoMap : null
  }

  /** Whether a map of its own can have all that the layers change. */
  #canCompose(base: Texture): boolean {
    const { inputs, hasValues, hasOwnProgram } = this.#host
    if (!hasValues) return true
    const { baseColor, roughness } = inputs.textures.values
    const aoMap = this.#ownOcclusion
    const isOccluded = !aoMap || (isReplaceable(aoMap) && isSampledAlike(aoMap, base))
    return hasOwnProgram && !this.#isRefused && !baseColor && !roughness && isOccluded
  }

  /** Makes maps as fine as the screen needs; null if there is not the memory for them. */
  #make(base: Texture, { width, height }: Size, side: number): Made | null {
    const { material, hasOwnProgram, hasValues, inputs, hasContents, shaders, channels, budget } = this.#host
    const halvings = halvingsOf({ width, height }, RESERVE * side)
    const size = { width: width >> halvings, height: height >> halvings }
    const type = composedType(base, material, inputs.textures)
    const format = { ...size, levels: levelsOf(size) }
    const aoMap = this.#ownOcclusion
    const bytes = bytesOfMap(size, bytesOfTexel(type) + (aoMap ? 1 : 0))
    if (!allocate(bytes, budget)) return null
    // The face's own fade is 0 while the map is drawn in its place.
    const whole = { ...inputs, fade: { value: 1 } }
    const added = hasValues ? channels : null
    const normals = new ComposedMap(
      base,
      { ...format, type },
      shaders.composeMaterial(base, whole, undefined, added),
      hasContents,
    )
    const occlusion =
      aoMap &&
      new ComposedMap(
        aoMap,
        { ...format, format: RedFormat },
        shaders.occlusionMaterial(aoMap, whole, channels!),
        hasContents,
      )
    for (const map of [normals, occlusion]) if (map) map.target.texture.matrixAutoUpdate = false
    const maps = { normals: normals.target.texture, occlusion: occlusion?.target.texture ?? null }
    const program = hasOwnProgram ? new StandbyProgram(this.#host, this.#edit, maps) : null
    return {
      normals,
      occlusion,
      maps,
      own: new OwnMaps(base, aoMap),
      halvings,
      bytes,
      program,
      state: 'new',
      isRefused: false,
    }
  }

  /** After this frame, so that it does not wait for it; what cannot be drawn is not shown. */
  #prepare(made: Made, renderer: AnyRenderer, meshes: DrawnMeshes): void {
    made.state = 'drawing'
    const { normals, occlusion, program } = made
    const isCurrent = () => this.#made === made && made.state === 'drawing'
    const draw = () => {
      if (!isCurrent()) return
      made.isRefused = program !== null && !program.isReady
      const isEmpty = this.#host.inputs.influence.value.version !== this.#atlasVersion
      if (!isEmpty) this.#draw(made, renderer)
      made.state = isEmpty ? 'new' : 'drawn'
    }
    const refuse = () => {
      made.isRefused = true
    }
    const compile = async () => {
      await nextTask()
      if (!isCurrent()) return
      await normals.compile(renderer)
      if (isCurrent()) await occlusion?.compile(renderer)
      if (isCurrent()) await program?.prepare(renderer, meshes)
    }
    compile().then(draw, refuse)
  }

  /** Keeps what the influence map shows. */
  #note(values: Float32Array): void {
    const { areas, textures, influence } = this.#host.inputs
    if (areas !== this.#areas || areas.version !== this.#shareVersion) {
      this.#share = shareOf(areas)
      this.#shareVersion = areas.version
    }
    this.#areas = areas
    this.#values = values
    this.#version = areas.version + textures.version
    this.#atlasVersion = influence.value.version
  }

  /** What has changed of it. */
  #draw({ normals, occlusion }: Made, renderer: AnyRenderer): void {
    normals.update(renderer, this.#areas!, this.#values, 1, this.#version)
    occlusion?.update(renderer, this.#areas!, this.#values, 1, this.#version)
  }

  /** Whether maps still serve. */
  #isKept(made: Made, base: Texture, halvings: number): boolean {
    const { material, inputs } = this.#host
    if (!made.own.are(base, this.#ownOcclusion)) return false
    if (made.normals.target.texture.type !== composedType(base, material, inputs.textures)) return false
    return halvings === made.halvings || halvings === made.halvings + 1
  }
}
