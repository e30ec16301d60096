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

/** Face that the relief belongs to. */
export interface ReliefHost {
  readonly face: RaisedFace
  readonly units: MeshUnits
  /** Called during a frame if a shader does not support relief, which must then be dropped. */
  refuse(error: unknown): void
}

/** Dense geometry of one mesh, and the texel of its first vertex in the coarse textures. */
type MeshSplit = Split & { mesh: Mesh; first: number }

/** Relief of one face: dense geometries drawn in place of its meshes. */
export class Relief {
  /** Uniform: 0 = no relief, 1 = full relief. */
  readonly amount = { value: 0 }
  /** Pixels per metre in the current picture. */
  pixelsPerMetre = Infinity
  /** Reason why the relief is coarser than intended, or null. */
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
   * Splits the meshes of a face, in time slices.
   *
   * @param isWanted polled between slices; if false, the work stops and the result is null.
   * @throws FurrowError if the meshes or heights are invalid.
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

  /** Patches the material to draw relief; see `ReliefParts.patch`. */
  patch(material: Material): () => void {
    const { mesh, shaderInputs } = this.#host.face
    return this.#parts.patch(material, this.#inputs, shaderInputs, instancesOf(mesh))
  }

  /** Switches between the dense geometries and the original meshes. Must not be called during a frame. */
  show(isShown: boolean): void {
    // Stand-ins of one mesh wrap each other's hooks, and must unhook in reverse order.
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

  /** Creates the stand-ins for a mesh's surface and outlines. */
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
   * @param material material of the mesh.
   * @param drawn material that draws the dense geometry.
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

/** Maximum error of a level of detail, pixels. Below half a pixel, so that two levels differ by less than one pixel. */
const MAX_PIXELS = 0.45

/** Index of the coarsest sufficient level of detail. Small triangles are expensive, see bench/README.md. */
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
  // Compressed areas have no texels in CPU memory.
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

/** Returns the limitation of the first mesh whose edges are longer than intended, because of the triangle budget. */
function longEdges(splits: readonly MeshSplit[]): FurrowError | null {
  const long = splits.find(({ edge }) => edge > SPLIT_DEFAULTS.edge)
  if (!long) return null
  const millimetres = (length: number) => `${(1000 * length).toPrecision(2)} mm`
  return new FurrowError({
    code: 'out-of-range',
    who: `Wrinkles.relief of mesh "${long.mesh.name}"`,
    problem: `more than ${SPLIT_DEFAULTS.budget} triangles needed, so their edges are longer`,
    value: millimetres(long.edge),
    limit: millimetres(SPLIT_DEFAULTS.edge),
    remedy: 'use fewer areas on layers with heights',
  })
}
