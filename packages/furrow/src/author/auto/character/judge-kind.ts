import type { SurfaceKind } from './surface-kinds.ts'

/** Kind of a surface, and why. */
export interface JudgedKind {
  /** Undefined if nothing tells. */
  kind: SurfaceKind | undefined
  /** Clause for a message. */
  reason: string
}

/** Properties of a material in the JSON of a glTF file that tell its kind. */
export interface MaterialJson {
  pbrMetallicRoughness?: object | undefined
  extensions?: object | undefined
}

/** Names of a surface in its file. */
export interface SurfaceNames {
  /** Name of the mesh, or its index if it has none. */
  meshName: string
  /** Name of the material, or its index if it has none. */
  materialName: string
}

/** Words in the names of materials and meshes, tried in this order. */
const WORDS: readonly (readonly [SurfaceKind, RegExp])[] = [
  [
    'hard',
    /hair|brow|lash|eye(?!lid)|iris|pupil|sclera|cornea|teeth|tooth|tongue|gum|armou?r|metal|steel|iron|gold|helmet|headset|headphone|weapon|sword|shield|gun|glass|lens|goggle|plastic|robot|mech|shoe|boot|sneaker|sandal|buckle|jewel|earring|necklace|watch|horn|claw|beak|fur\b/i,
  ],
  [
    'cloth',
    /cloth|outfit|garment|costume|uniform|pants|trouser|jean|denim|short|skirt|dress|shirt|blouse|\btop\b|_top|bottom|jacket|coat|hoodie|sweater|jumper|vest|robe|cape|cuff|sleeve|collar|scarf|suit|kimono|tights|legging|sock|glove|hat\b|cap\b|fabric|cotton|linen|silk|wool|leather/i,
  ],
  ['skin', /skin|body|flesh|face|head|hand|neck|torso|human|nude/i],
]

/** A material without textures is hard from this metalness on. */
const METALLIC = 0.5

/**
 * Judges whether a surface is skin, cloth or hard: by the name of its material, then by the name of its mesh, then by the properties of its
 * material.
 *
 * @param material JSON of the material. Malformed properties are ignored.
 * @param stated kinds that the user stated, by name of a mesh or material.
 */
export function judgeKind(
  material: MaterialJson | undefined,
  { meshName, materialName }: SurfaceNames,
  stated: ReadonlyMap<string, SurfaceKind> = new Map(),
): JudgedKind {
  const own = stated.get(meshName) ?? stated.get(materialName)
  if (own) return { kind: own, reason: 'the user stated it' }
  for (const [subject, name] of [
    ['material', materialName],
    ['mesh', meshName],
  ]) {
    const found = WORDS.flatMap(([kind, words]) => {
      const match = words.exec(name)
      return match ? [{ kind, word: match[0] }] : []
    })[0]
    if (found) return { kind: found.kind, reason: `the name of the ${subject} contains "${found.word}"` }
  }
  const { pbrMetallicRoughness: pbr, extensions = {} } = material ?? {}
  if ('KHR_materials_transmission' in extensions)
    return { kind: 'hard', reason: 'the material transmits light' }
  const { metallicFactor, metallicRoughnessTexture } = (pbr ?? {}) as Record<string, unknown>
  if (
    typeof metallicFactor === 'number' &&
    metallicFactor >= METALLIC &&
    metallicRoughnessTexture === undefined
  )
    return { kind: 'hard', reason: 'the material is metallic' }
  return { kind: undefined, reason: 'neither names nor material tell' }
}
