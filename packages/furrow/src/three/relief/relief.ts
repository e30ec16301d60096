import type { Material, Mesh, Sphere, Texture } from 'three'
import { FurrowError } from '../../core/error.ts'
import { HeightField, weightedTexels } from '../../relief/height-fields.ts'
import { TOLERANCES } from '../../relief/needed-halvings.ts'
import { SPLIT_DEFAULTS } from '../../relief/split-mesh.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import { instancesOf } from '../mesh/instances.ts'
import { CoarsePass } from './coarse-pass.ts'
import { type Raised, ringTexture, type Split, splitGeometry } from './dense-geometry.ts'
import { checkReach, createHeightMaps, type HeightMaps } from './height-maps.ts'
import type { MeshUnits } from './mesh-units.ts'
import { outlinesOf } from './outlines-of.ts'
import type { RaisedFace } from './raised-face.ts'
import type { ReliefInputs } from './relief-inputs.ts'
import { createReliefMesh } from './relief-mesh.ts'
import type { ReliefParts } from './relief-parts.ts'
import { inSlices } from './slices.ts'
import { StandIn } from './stand-in.ts'

/** Face of a `Relief`, with its units and a callback. */
export interface ReliefHost {
  readonly face: RaisedFace
  readonly units: MeshUnits
  /** Called during a frame if a shader cannot be patched. Relief must then be turned off. */
  refuse(error: unknown): void
}

/** Dense geometry of one mesh, and the texel of the mesh's first vertex in the textures of `CoarsePass`. */
type MeshSplit = Split & { mesh: Mesh; first: number }

/**
 * Relief of one face. Relief displaces the surface by height maps, and needs dense geometries, in which the triangles of the meshes are split.
 * Children of the meshes draw the dense geometries in place of the meshes.
 */
export class Relief {
  /** Uniform with the strength of the displacement: 0 = none, 1 = full. */
  readonly amount = { value: 0 }
  /** Pixels per metre in the current picture. */
  pixelsPerMetre = Infinity
  /** Reason why the triangles are larger than intended, or null. */
  readonly limitation: FurrowError | null
  readonly #host: ReliefHost
  readonly #parts: ReliefParts
  readonly #heights: HeightMaps
  readonly #ring: Texture
  readonly #pass: CoarsePass
  readonly #inputs: ReliefInputs
  readonly #standIns: StandIn[]
  readonly #onDispose: (() => void)[] = []
  #isRefused = false

  private constructor(
    host: ReliefHost,
    parts: ReliefParts,
    heights: HeightMaps,
    splits: readonly MeshSplit[],
  ) {
    this.#host = host
    this.#parts = parts
    this.#heights = heights
    this.limitation = longEdges(splits)
    this.#ring = ringTexture(splits)
    this.#pass = new CoarsePass(splits, this.#ring, parts)
    const [positions, directions] = this.#pass.target.textures
    this.#inputs = {
      heights,
      coarse: { positions, directions },
      unitsPerMetre: 1 / host.units.deformed,
      amount: this.amount,
      refuse: (error) => {
        this.#isRefused = true
        host.refuse(error)
      },
    }
    this.#standIns = splits.flatMap((split) => this.#standInsOf(split))
  }

  /**
   * Splits the meshes of a face, in time slices, so that the page stays responsive.
   *
   * @param isWanted called between slices; if it returns false, the work stops and the result is null.
   * @throws FurrowError if the meshes or height maps are invalid.
   */
  static async create(host: ReliefHost, parts: ReliefParts, isWanted: () => boolean): Promise<Relief | null> {
    const { face, units } = host
    const { meshes, shaderInputs } = face
    const { material } = face.material
    for (const mesh of meshes) checkPositions(mesh)
    const heights = await createHeightMaps(shaderInputs.textures.layers)
    try {
      checkReach(heights, units.atRest * Math.max(...meshes.map(radiusOf)))
      const raised = raisedBy(shaderInputs, heights)
      const splits: MeshSplit[] = []
      let first = 0
      for (const mesh of meshes) {
        const { reach } = heights
        const map = heights.texture.image as { width: number; height: number }
        const request = { mesh, material, raised, first, metresPerUnit: units.atRest, reach, map }
        const split = await inSlices(splitGeometry(request), isWanted)
        if (!split) break
        splits.push({ ...split, mesh, first })
        first += split.next.length
      }
      if (splits.length === meshes.length) return new Relief(host, parts, heights, splits)
    } catch (error) {
      heights.dispose()
      throw error
    }
    heights.dispose()
    return null
  }

  patch(material: Material): () => void {
    const { mesh, shaderInputs } = this.#host.face
    return this.#parts.patch(material, this.#inputs, shaderInputs, instancesOf(mesh))
  }

  /** Switches between the dense geometries and the original meshes. Must not be called during a frame. */
  show(isShown: boolean): void {
    // Each `StandIn` of a mesh wraps the callbacks of the previous one, so the callbacks must be removed in reverse order.
    for (const standIn of isShown ? this.#standIns : this.#standIns.toReversed()) standIn.show(isShown)
  }

  /** Copies the render settings of the meshes, for the next frame. */
  follow(): void {
    for (const standIn of this.#standIns) standIn.follow()
  }

  dispose(): void {
    this.show(false)
    for (const free of this.#onDispose) free()
    this.#pass.dispose()
    this.#ring.dispose()
    this.#heights.dispose()
  }

  /** Creates the objects that draw the dense geometry with the material of the surface and with its outline materials. */
  #standInsOf(split: MeshSplit): StandIn[] {
    const { shaderInputs } = this.#host.face
    const { material } = this.#host.face.material
    const { mesh, geometry } = split
    this.#onDispose.push(() => geometry.dispose())
    const outlines = outlinesOf(mesh, material).flatMap((outline) => {
      const copy = this.#parts.outlineMaterial(outline, this.#inputs, shaderInputs, instancesOf(mesh))
      if (!copy) return []
      this.#onDispose.push(() => copy.dispose())
      return this.#standInOf(split, outline, copy)
    })
    return [this.#standInOf(split, material, material), ...outlines]
  }

  /**
   * @param material material whose triangles in the mesh are replaced.
   * @param drawn material that draws the dense geometry instead.
   */
  #standInOf({ mesh, geometry }: MeshSplit, material: Material, drawn: Material): StandIn {
    const { face } = this.#host
    const dense = createReliefMesh(mesh, geometry, drawn)
    this.#onDispose.push(
      this.#parts.addShadowMaterials(dense, mesh, this.#inputs, face.shaderInputs, instancesOf(mesh)),
    )
    return new StandIn(mesh, dense, {
      material,
      isOn: () => !this.#isRefused && face.mode !== 'off',
      prepare: (renderer, camera, drawn) => face.prepare(renderer, camera, drawn),
      deform: (renderer, isShadow) => {
        if (isShadow) this.#parts.duringShadow(renderer, () => this.#pass.update(renderer))
        else this.#pass.update(renderer)
      },
      version: () => versionFor(this.pixelsPerMetre),
    })
  }
}

/** Maximum distance between a level of detail and the exact surface, pixels. Below 0.5, so that two levels differ by less than one pixel. */
const MAX_PIXELS = 0.45

/**
 * Returns the index of the coarsest level of detail within `MAX_PIXELS`, or 0 (the finest) if none is. Small triangles are expensive, see
 * bench/README.md.
 */
function versionFor(pixelsPerMetre: number): number {
  const tooCoarse = TOLERANCES.findIndex((tolerance) => tolerance * pixelsPerMetre > MAX_PIXELS)
  return tooCoarse < 0 ? TOLERANCES.length - 1 : Math.max(tooCoarse - 1, 0)
}

/** @throws FurrowError if a mesh has positions that are not finite. */
function checkPositions(mesh: Mesh): void {
  if (Number.isFinite(radiusOf(mesh))) return
  throw new FurrowError({
    who: `Wrinkles.relief of mesh "${mesh.name}"`,
    problem: 'the mesh has positions that are not numbers',
    remedy: 'export the mesh again; until then it has no relief',
  })
}

function raisedBy({ areas }: ShaderInputs, { array, layers }: HeightMaps): Raised {
  const { texture, slots, channels, width, height } = areas
  const { data, depth } = texture.image as { data?: Uint8Array; depth: number }
  // The texels of compressed areas are not in CPU memory.
  const weights = channels === 1 && data ? { data, width, height, depth, channels } : null
  const raised = layers.map((raisedLayer) => ({
    ...raisedLayer,
    areas: slots.flatMap(({ layer, slice }) => (layer === raisedLayer.layer ? slice : [])),
  }))
  if (array) return raised.map((layer) => new HeightField(layer, array, weights))
  const slices = raised.flatMap((layer) => layer.areas)
  return weights && weightedTexels(weights, slices)
}

function radiusOf({ geometry }: Mesh): number {
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere()
  return (geometry.boundingSphere as Sphere).radius
}

/** Returns an error if the maximum number of triangles makes the edges of a mesh longer than intended, otherwise null. */
function longEdges(splits: readonly MeshSplit[]): FurrowError | null {
  const long = splits.find(({ edge }) => edge > SPLIT_DEFAULTS.edge)
  if (!long) return null
  const millimetres = (length: number) => `${(1000 * length).toPrecision(2)} mm`
  return new FurrowError({
    code: 'out-of-range',
    who: `Wrinkles.relief of mesh "${long.mesh.name}"`,
    problem: `relief would need more than ${SPLIT_DEFAULTS.budget} triangles, so the edges of its triangles are longer`,
    value: millimetres(long.edge),
    limit: millimetres(SPLIT_DEFAULTS.edge),
    remedy: 'use fewer areas on layers with heights',
  })
}
