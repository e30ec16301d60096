import { movingCopy, StrainView } from 'furrow/internal/three'
import type { WrinkleMode } from 'furrow/three'
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

/** Display mode of the side with wrinkles. */
export type LookName = Look['name']

/** @property area shows only these areas, as if fully active. */
export type Look =
  | { name: 'shaded' | 'clay' | 'normals' | 'strain' | 'wireframe' }
  | { name: 'influence'; area?: string | readonly string[] }

/** Shows areas in orange on the face, for finding and painting them. */
interface Marked {
  name: 'marked'
  area: readonly string[]
}

export type Side = 'without' | 'with'

/** Background of an unlit look. */
const TECHNICAL_BACKGROUND = new Color(0x131518)
const WIRE_COLOUR = 0xe6b48c
const SURFACE_COLOUR = 0x202328
const OTHER_MESHES_COLOUR = 0x1b1e22
/** Clay: a uniform colour that shows only shape. */
const CLAY = { color: 0xa39a92, roughness: 0.62 } as const

/** A mesh has several materials if three-vrm draws an outline. */
type Materials = Mesh['material']

type NormalMaps = Pick<MeshStandardMaterial, 'normalMap' | 'normalScale' | 'side'>

/** Applies the same wrinkles to another mesh on the same renderer. */
type CreateMirror = (mesh: Mesh, wrinkles: Wrinkles) => Wrinkles

/** Appearance of one side. */
interface SideLook {
  /** Material of each mesh; null hides it. */
  materials: Map<Mesh, Materials | null>
  /** Whether the materials are lit, and so tone-mapped. */
  isLit: boolean
  /** Mesh drawn in place of the skin or over it. */
  extra: 'wireframe' | 'strain' | 'marked' | null
}

/**
 * Draws the face differently on each side of the divider by swapping materials between the two draws of a frame.
 * Nothing is compiled or uploaded while the divider moves.
 */
export class Looks {
  readonly #face: Face
  readonly #wrinkles: Wrinkles | null
  readonly #createMirror: CreateMirror
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
   * @param plain clone of the skin's material from before wrinkles were added; disposed with this.
   * @param wrinkles null for a plain face.
   */
  constructor(face: Face, wrinkles: Wrinkles | null, plain: Materials, createMirror: CreateMirror) {
    this.#face = face
    this.#wrinkles = wrinkles
    this.#plain = plain
    this.#createMirror = createMirror
    const originals = new Map<Mesh, Materials>()
    face.root.traverse((object) => {
      if ((object as Mesh).isMesh) originals.set(object as Mesh, (object as Mesh).material)
    })
    this.#originals = originals
    this.#wireframeMesh = createWireframe(face.skin)
    this.#sides = { without: this.#shaded(plain), with: this.#shaded(originals.get(face.skin)!) }
  }

  /** @throws FurrowError if the look names an unknown area; the look then does not change. */
  choose(look: Look | Marked): void {
    const influence = look.name === 'influence' || look.name === 'marked' ? this.#influence(look.area) : null
    this.#discard()
    const without = this.#shaded(this.#plain)
    if (look.name === 'normals') this.#sides = this.#normals()
    else if (look.name === 'clay') this.#sides = this.#clay()
    else if (look.name === 'strain') this.#sides = { without, with: this.#strained() }
    else if (look.name === 'marked') this.#sides = { without, with: this.#marked(influence!) }
    else if (influence) this.#sides = { without, with: this.#technical(influence) }
    else if (look.name === 'wireframe') this.#sides = { without, with: this.#wireframe() }
    else this.#sides = { without, with: this.#shaded(this.#originals.get(this.#face.skin)!) }
  }

  /** Whether a side is lit. An unlit side has the technical background. */
  isLit(side: Side): boolean {
    return this.#sides[side].isLit
  }

  get technicalBackground(): Color {
    return TECHNICAL_BACKGROUND
  }

  /** Recomputes the strain of the current pose when the face stops moving. */
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

  /** Creates a material that shows influence as gray. A plain face is black. */
  #influence(area?: string | readonly string[]): Material {
    if (this.#wrinkles) return this.#wrinkles.createInfluenceMaterial(area)
    return this.#keep(new MeshBasicMaterial({ color: 0x000000, toneMapped: false }))
  }

  /** Shows the normals used for lighting. */
  #normals(): Record<Side, SideLook> {
    return this.#wrinkled((maps) => new MeshNormalMaterial(maps), new MeshNormalMaterial())
  }

  /** Shows only the shape, lit like the face. */
  #clay(): Record<Side, SideLook> {
    const clay = new MeshStandardMaterial(CLAY)
    const sides = this.#wrinkled((maps) => new MeshStandardMaterial({ ...CLAY, ...maps }), clay)
    return { without: { ...sides.without, isLit: true }, with: { ...sides.with, isLit: true } }
  }

  /** Shows the skin in a material without and with wrinkles. A second `Wrinkles` patches the material. */
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
    // The surface is pushed back, because WebGPU has no depth bias for lines.
    const surface = new MeshBasicMaterial({ color: SURFACE_COLOUR, polygonOffset: true, toneMapped: false })
    surface.polygonOffsetFactor = 1
    surface.polygonOffsetUnits = 1
    return { ...this.#technical(this.#keep(surface)), extra: 'wireframe' }
  }

  /** Shows the skin in one material and other meshes in another. Hides alpha-cut meshes such as lashes. */
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

/** Makes a hidden wireframe copy of the skin that shares its morph weights. */
function createWireframe(skin: Mesh): Mesh {
  const material = new MeshBasicMaterial({ color: WIRE_COLOUR, wireframe: true, toneMapped: false })
  const wireframe = movingCopy(skin, material)
  wireframe.name = 'wireframe'
  return wireframe
}

/** Returns the label of the side with wrinkles. */
export function lookLabel(look: Look, mode: WrinkleMode): string {
  if (look.name === 'influence') return look.area === undefined ? 'Influence' : [look.area].flat().join(', ')
  if (look.name === 'wireframe') return 'Wireframe'
  if (look.name === 'strain') return 'Strain'
  return mode === 'off' ? 'Wrinkles off' : 'With wrinkles'
}
