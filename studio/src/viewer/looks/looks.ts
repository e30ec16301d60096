import type { GrayImage } from 'furrow'
import { movingCopy, StrainView } from 'furrow/internal/three'
import {
  Color,
  type Material,
  type Mesh,
  MeshBasicMaterial,
  MeshNormalMaterial,
  MeshStandardMaterial,
  Mesh as ThreeMesh,
} from 'three'
import type { Face } from '../../../../stage/face.ts'
import type { Wrinkles } from '../../../../stage/stage.ts'
import { AreaOverlay } from './area-overlay.ts'
import { Headlit } from './headlit.ts'
import type { Look } from './look.ts'
import { createNoOnsetMaterial, createOnsetMaterial } from './onset-material.ts'

/** Look that shows areas in orange, for areas that the user points at or paints. */
interface Marked {
  name: 'marked'
  area: readonly string[]
}

/** Side of the divider: without wrinkles (left), or with wrinkles (right). */
export type Side = 'without' | 'with'

/** Background of an unlit look. */
const TECHNICAL_BACKGROUND = new Color(0x131518)
const WIRE_COLOUR = 0xe6b48c
const SURFACE_COLOUR = 0x202328
const OTHER_MESHES_COLOUR = 0x1b1e22
/** Clay: a uniform colour, so that only the shape is visible. */
const CLAY = { color: 0xa39a92, roughness: 0.62 } as const

/** One material, or several if three-vrm draws an outline. */
type Materials = Mesh['material']

type NormalMaps = Pick<MeshStandardMaterial, 'normalMap' | 'normalScale' | 'side'>

/** Creates another `Wrinkles` object for the same renderer, to show `wrinkles` on `mesh`. */
type CreateMirror = (mesh: Mesh, wrinkles: Wrinkles) => Wrinkles

/** Appearance of the face on one side of the divider. */
interface SideLook {
  /** Material of each mesh. Null hides the mesh. */
  materials: Map<Mesh, Materials | null>
  /** Whether the materials are lit. Only lit materials are tone-mapped. */
  isLit: boolean
  /** Additional mesh that is drawn over the skin or instead of it. */
  extra: 'wireframe' | 'strain' | 'marked' | null
}

/**
 * Materials of the face on both sides of the divider. A frame renders the face once for each side and swaps the materials in between. Moving
 * the divider therefore compiles and uploads nothing.
 */
export class Looks {
  readonly #face: Face
  readonly #wrinkles: Wrinkles | null
  readonly #createMirror: CreateMirror
  readonly #onsets: ReadonlyMap<string, GrayImage>
  readonly #originals: ReadonlyMap<Mesh, Materials>
  /** The skin's material without wrinkles. */
  readonly #plain: Materials
  readonly #wireframeMesh: Mesh
  #strain: StrainView | null = null
  #overlay: AreaOverlay | null = null
  readonly #headlit = new Headlit()
  #sides: Record<Side, SideLook>
  #materials: Material[] = []
  #mirror: Wrinkles | null = null

  /**
   * @param plain clone of the skin's material without wrinkles. `dispose` disposes of the clone.
   * @param wrinkles wrinkles of the face, or null if it has none.
   * @param onsets onset maps. The keys are names of layers.
   */
  constructor(
    face: Face,
    wrinkles: Wrinkles | null,
    plain: Materials,
    createMirror: CreateMirror,
    onsets: ReadonlyMap<string, GrayImage>,
  ) {
    this.#face = face
    this.#wrinkles = wrinkles
    this.#plain = plain
    this.#createMirror = createMirror
    this.#onsets = onsets
    const originals = new Map<Mesh, Materials>()
    face.root.traverse((object) => {
      if ((object as Mesh).isMesh) originals.set(object as Mesh, (object as Mesh).material)
    })
    this.#originals = originals
    this.#wireframeMesh = createWireframe(face.skin)
    this.#sides = { without: this.#shaded(plain), with: this.#shaded(originals.get(face.skin)!) }
  }

  /** @throws FurrowError if `look` names an unknown area. The face then keeps its look. */
  choose(look: Look | Marked): void {
    const influence = look.name === 'influence' || look.name === 'marked' ? this.#influence(look.area) : null
    this.#discard()
    const without = this.#shaded(this.#plain)
    if (look.name === 'normals') this.#sides = this.#normals()
    else if (look.name === 'clay') this.#sides = this.#clay()
    else if (look.name === 'strain') this.#sides = { without, with: this.#strained() }
    else if (look.name === 'marked') this.#sides = { without, with: this.#marked(influence!) }
    else if (influence) this.#sides = { without, with: this.#technical(influence) }
    else if (look.name === 'onset') this.#sides = { without, with: this.#technical(this.#onset(look.layer)) }
    else if (look.name === 'wireframe') this.#sides = { without, with: this.#wireframe() }
    else this.#sides = { without, with: this.#shaded(this.#originals.get(this.#face.skin)!) }
  }

  /** Whether the materials of a side are lit. Otherwise, the side needs the technical background. */
  isLit(side: Side): boolean {
    return this.#sides[side].isLit
  }

  get technicalBackground(): Color {
    return TECHNICAL_BACKGROUND
  }

  /** Recomputes the strain colours for the current pose. This is slow: call it only while the face does not move. */
  follow(): void {
    this.#strain?.follow()
  }

  /** Sets the materials of a side before drawing it. */
  apply(side: Side): void {
    const { materials, extra } = this.#sides[side]
    for (const [mesh, material] of materials) {
      mesh.visible = material !== null
      if (material) mesh.material = material
    }
    this.#wireframeMesh.visible = extra === 'wireframe'
    if (this.#strain) this.#strain.visible = extra === 'strain'
    if (this.#overlay) this.#overlay.visible = extra === 'marked'
    this.#copyActivations()
  }

  /** Restores the original materials after drawing, because other code reads them. */
  restore(): void {
    for (const [mesh, material] of this.#originals) {
      mesh.material = material
      mesh.visible = true
    }
    this.#wireframeMesh.visible = false
    if (this.#strain) this.#strain.visible = false
    if (this.#overlay) this.#overlay.visible = false
  }

  dispose(): void {
    this.#discard()
    this.restore()
    this.#wireframeMesh.removeFromParent()
    ;(this.#wireframeMesh.material as Material).dispose()
    for (const material of [this.#plain].flat()) material.dispose()
    this.#headlit.dispose()
  }

  #shaded(skin: Materials): SideLook {
    const materials = new Map<Mesh, Materials | null>(this.#originals)
    for (const mesh of this.#skin) materials.set(mesh, skin)
    return { materials, isLit: true, extra: null }
  }

  get #skin(): Mesh[] {
    return [this.#face.skin, ...this.#face.parts]
  }

  /** Creates a material that shows influence in gray. The material is black if the face has no wrinkles. */
  #influence(area?: string | readonly string[]): Material {
    if (this.#wrinkles) return this.#wrinkles.createInfluenceMaterial(area)
    return this.#keep(new MeshBasicMaterial({ color: 0x000000, toneMapped: false }))
  }

  #onset(layer: string | undefined): Material {
    const onset = layer === undefined ? [...this.#onsets.values()][0] : this.#onsets.get(layer)
    if (!onset) return createNoOnsetMaterial()
    const [plain] = [this.#plain].flat()
    return createOnsetMaterial(onset, (plain as MeshStandardMaterial).normalMap ?? null)
  }

  /** Shows the normals that lighting uses, on both sides. */
  #normals(): Record<Side, SideLook> {
    return this.#wrinkled((maps) => new MeshNormalMaterial(maps), new MeshNormalMaterial())
  }

  /** Shows only the shape on both sides, with the lights of the stage. */
  #clay(): Record<Side, SideLook> {
    const clay = new MeshStandardMaterial(CLAY)
    const sides = this.#wrinkled((maps) => new MeshStandardMaterial({ ...CLAY, ...maps }), clay)
    return { without: { ...sides.without, isLit: true }, with: { ...sides.with, isLit: true } }
  }

  /** Shows the skin with a new material on each side. A second `Wrinkles` object adds wrinkles to the material of the right side. */
  #wrinkled(create: (maps: NormalMaps) => Material, others: Material): Record<Side, SideLook> {
    const { skin } = this.#face
    const [plain] = [this.#plain].flat()
    const { normalMap, normalScale, side } = plain as MeshStandardMaterial
    const createMaterial = () => this.#keep(create({ normalMap, normalScale, side }))
    const rest = this.#keep(others)
    const without = this.#technical(createMaterial(), rest)
    if (!this.#wrinkles) return { without, with: without }
    const standIn = new ThreeMesh(skin.geometry, createMaterial())
    this.#mirror = this.#createMirror(standIn, this.#wrinkles)
    for (const mesh of this.#skin) this.#mirror.addMesh(mesh)
    this.#mirror.mode = this.#wrinkles.mode === 'off' ? 'off' : 'default'
    return { without, with: this.#technical(standIn.material, rest) }
  }

  #strained(): SideLook {
    this.#strain = new StrainView(this.#skin)
    this.#strain.follow()
    const { materials, ...look } = this.#technical(this.#keep(new MeshBasicMaterial()))
    const others = new Map(materials)
    for (const mesh of this.#skin) others.set(mesh, null)
    return { ...look, materials: others, extra: 'strain' }
  }

  #marked(influence: Material): SideLook {
    this.#overlay = new AreaOverlay(this.#skin, this.#keep(influence))
    const materials = new Map<Mesh, Materials | null>()
    for (const [mesh, original] of this.#originals) {
      const [material] = [original].flat()
      const isHidden = isCutOut(material) && !this.#skin.includes(mesh)
      materials.set(mesh, isHidden ? null : this.#headlit.materialOf(mesh, material))
    }
    return { materials, isLit: true, extra: 'marked' }
  }

  #wireframe(): SideLook {
    // Push the surface back instead of pulling the lines forward, because WebGPU has no depth bias for lines.
    const surface = new MeshBasicMaterial({ color: SURFACE_COLOUR, polygonOffset: true, toneMapped: false })
    surface.polygonOffsetFactor = 1
    surface.polygonOffsetUnits = 1
    return { ...this.#technical(this.#keep(surface)), extra: 'wireframe' }
  }

  /** Shows the skin in one material and other meshes in another. Hides meshes with transparency, such as lashes. */
  #technical(skin: Material, others?: Material): SideLook {
    if (!this.#materials.includes(skin)) this.#keep(skin)
    const rest =
      others ?? this.#keep(new MeshBasicMaterial({ color: OTHER_MESHES_COLOUR, toneMapped: false }))
    const materials = new Map<Mesh, Materials | null>()
    for (const [mesh, original] of this.#originals) {
      const hidden = isCutOut([original].flat()[0])
      materials.set(mesh, this.#skin.includes(mesh) ? skin : hidden ? null : rest)
    }
    return { materials, isLit: false, extra: null }
  }

  #copyActivations(): void {
    const [mirror, wrinkles] = [this.#mirror, this.#wrinkles]
    if (!mirror || !wrinkles) return
    for (const name of mirror.areaNames) {
      if (wrinkles.hasArea(name)) mirror.setActivation(name, wrinkles.getActivation(name))
    }
  }

  #keep<T extends Material>(material: T): T {
    this.#materials.push(material)
    return material
  }

  #discard(): void {
    this.#strain?.dispose()
    this.#strain = null
    this.#overlay?.dispose()
    this.#overlay = null
    this.#mirror?.dispose()
    this.#mirror = null
    for (const material of this.#materials) material.dispose()
    this.#materials = []
  }
}

function isCutOut({ transparent, alphaTest, alphaHash }: Material): boolean {
  return transparent || alphaTest > 0 || alphaHash
}

/** Makes a hidden wireframe copy of the skin. The copy uses the blendshape weights of the skin. */
function createWireframe(skin: Mesh): Mesh {
  const material = new MeshBasicMaterial({ color: WIRE_COLOUR, wireframe: true, toneMapped: false })
  const wireframe = movingCopy(skin, material)
  wireframe.name = 'wireframe'
  return wireframe
}
