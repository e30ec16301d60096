import type { WrinkleMode } from 'furrow/three'
import {
  Color,
  type Material,
  type Mesh,
  MeshBasicMaterial,
  MeshNormalMaterial,
  type MeshStandardMaterial,
  Mesh as ThreeMesh,
} from 'three'
import type { Face } from '../../stage/face.ts'
import type { Wrinkles } from '../../stage/stage.ts'

/** What the side with wrinkles shows: the lit face, or something about it that light hides. */
export type LookName = 'shaded' | 'normals' | 'influence' | 'wireframe'

/** @property area shows the influence of this one alone, or these, whatever their activations. */
export type Look =
  | { name: Exclude<LookName, 'influence'> }
  | { name: 'influence'; area?: string | readonly string[] }

export type Side = 'without' | 'with'

/** Behind a look that is not lit. */
const TECHNICAL_BACKGROUND = new Color(0x131518)
const WIRE = 0xe6b48c
const HIDDEN_LINES = 0x202328
const OTHER_PARTS = 0x1b1e22

/** One side's clothes: materials by mesh; a mesh without one is hidden. */
interface Dress {
  materials: Map<Mesh, Material | null>
  /** Whether its colours are light, to be tone-mapped. */
  lit: boolean
  wires: boolean
}

/**
 * Dresses the face for each side of the divider by swapping materials between two draws of one frame: no
 * program is compiled anew and nothing is uploaded while the divider stands or moves.
 */
export class Looks {
  readonly #face: Face
  readonly #wrinkles: Wrinkles
  readonly #mirrorOn: (mesh: Mesh) => Wrinkles
  readonly #own: ReadonlyMap<Mesh, Material>
  /** The skin as it was before it wrinkled. */
  readonly #plain: Material
  readonly #wires: Mesh
  #sides: Record<Side, Dress>
  #made: { dispose(): void }[] = []
  #mirror: Wrinkles | null = null

  /**
   * @param plain a clone of the skin's material, taken before it wrinkled; disposed with this.
   * @param mirrorOn puts the same wrinkles on a stand-in of the skin, by the renderer's own class.
   */
  constructor(face: Face, wrinkles: Wrinkles, plain: Material, mirrorOn: (mesh: Mesh) => Wrinkles) {
    this.#face = face
    this.#wrinkles = wrinkles
    this.#plain = plain
    this.#mirrorOn = mirrorOn
    const own = new Map<Mesh, Material>()
    face.root.traverse((object) => {
      if ((object as Mesh).isMesh) own.set(object as Mesh, (object as Mesh).material as Material)
    })
    this.#own = own
    this.#wires = wiresOf(face.skin)
    this.#sides = { without: this.#shaded(plain), with: this.#shaded(own.get(face.skin)!) }
  }

  /** @throws FurrowError when no area has the look's name; the look then stays as it was. */
  choose(look: Look): void {
    const influence = look.name === 'influence' ? this.#wrinkles.createInfluenceMaterial(look.area) : null
    this.#discard()
    const without = this.#shaded(this.#plain)
    if (look.name === 'normals') this.#sides = this.#normals()
    else if (influence) this.#sides = { without, with: this.#technical(influence) }
    else if (look.name === 'wireframe') this.#sides = { without, with: this.#wireframe() }
    else this.#sides = { without, with: this.#shaded(this.#own.get(this.#face.skin)!) }
  }

  /** Whether a side is lit, and the colour behind it where it is not. */
  lit(side: Side): boolean {
    return this.#sides[side].lit
  }

  get technicalBackground(): Color {
    return TECHNICAL_BACKGROUND
  }

  /** Puts a side's materials on. */
  wear(side: Side): void {
    const { materials, wires } = this.#sides[side]
    for (const [mesh, material] of materials) {
      mesh.visible = material !== null
      if (material) mesh.material = material
    }
    this.#wires.visible = wires
    this.#followActivations()
  }

  /** Gives every mesh its own material back. */
  dispose(): void {
    this.#discard()
    for (const [mesh, material] of this.#own) {
      mesh.material = material
      mesh.visible = true
    }
    this.#wires.removeFromParent()
    ;(this.#wires.material as Material).dispose()
    this.#plain.dispose()
  }

  #shaded(skin: Material): Dress {
    const materials = new Map<Mesh, Material | null>(this.#own)
    materials.set(this.#face.skin, skin)
    return { materials, lit: true, wires: false }
  }

  /** The normals that light sees, wrinkles mixed in: a second component does to this material what the first does. */
  #normals(): Record<Side, Dress> {
    const { skin } = this.#face
    const { normalMap, normalScale, side } = this.#plain as MeshStandardMaterial
    const make = () => this.#keep(new MeshNormalMaterial({ normalMap, normalScale, side }))
    const flat = this.#keep(new MeshNormalMaterial())
    const standIn = new ThreeMesh(skin.geometry, make())
    this.#mirror = this.#mirrorOn(standIn)
    this.#mirror.addMesh(skin)
    this.#mirror.mode = this.#wrinkles.mode === 'off' ? 'off' : 'default'
    return { without: this.#technical(make(), flat), with: this.#technical(standIn.material, flat) }
  }

  #wireframe(): Dress {
    // Lines lie on the surface; the surface is pushed back, since WebGPU cannot pull lines forward.
    const surface = new MeshBasicMaterial({ color: HIDDEN_LINES, polygonOffset: true, toneMapped: false })
    surface.polygonOffsetFactor = 1
    surface.polygonOffsetUnits = 1
    return { ...this.#technical(this.#keep(surface)), wires: true }
  }

  /** Skin as told, all else in one material; lashes and the like, which are cut out of cards, are hidden. */
  #technical(skin: Material, others?: Material): Dress {
    if (!this.#made.includes(skin)) this.#keep(skin)
    const rest = others ?? this.#keep(new MeshBasicMaterial({ color: OTHER_PARTS, toneMapped: false }))
    const materials = new Map<Mesh, Material | null>()
    for (const [mesh, own] of this.#own) {
      const cutOut = own.transparent || own.alphaTest > 0 || own.alphaHash
      materials.set(mesh, mesh === this.#face.skin ? skin : cutOut ? null : rest)
    }
    return { materials, lit: false, wires: false }
  }

  #followActivations(): void {
    if (!this.#mirror) return
    for (const name of this.#mirror.areaNames) {
      if (this.#wrinkles.hasArea(name)) this.#mirror.setActivation(name, this.#wrinkles.getActivation(name))
    }
  }

  #keep<T extends Material>(material: T): T {
    this.#made.push(material)
    return material
  }

  #discard(): void {
    this.#mirror?.dispose()
    this.#mirror = null
    for (const material of this.#made) material.dispose()
    this.#made = []
  }
}

/** The skin's edges, moving as it moves; hidden until worn. */
function wiresOf(skin: Mesh): Mesh {
  const wires = skin.clone(false)
  wires.name = 'wires'
  wires.material = new MeshBasicMaterial({ color: WIRE, wireframe: true, toneMapped: false })
  wires.morphTargetInfluences = skin.morphTargetInfluences
  wires.visible = false
  skin.parent?.add(wires)
  return wires
}

/** What stands beside the divider, on the side with wrinkles. */
export function lookLabel(look: Look, mode: WrinkleMode): string {
  if (look.name === 'influence') return look.area === undefined ? 'Influence' : [look.area].flat().join(', ')
  if (look.name === 'wireframe') return 'Wireframe'
  return mode === 'off' ? 'Wrinkles off' : 'With wrinkles'
}
