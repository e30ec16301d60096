import { canonicalTargetName } from 'furrow/internal'
import type { Mesh, Object3D } from 'three'
import type { Wrinkles } from '../../../../stage/stage.ts'

/** Number in 0..1 controlled by a slider. */
export interface Dial {
  readonly name: string
  read(): number
  write(value: number): void
}

/** Blendshapes of one region of the face. */
export interface ShapeGroup<T extends { readonly name: string }> {
  readonly name: string
  readonly shapes: T[]
}

/** Groups by name prefix, in display order. The last one takes the rest. */
const GROUPS: readonly [name: string, prefix: RegExp][] = [
  ['Brows', /^brow/i],
  ['Eyes', /^eye/i],
  ['Cheeks & nose', /^(cheek|nose)/i],
  ['Mouth', /^mouth/i],
  ['Jaw', /^jaw/i],
  ['Tongue', /^tongue/i],
  ['Other', /^/],
]

export function areaDials(wrinkles: Wrinkles): Dial[] {
  return wrinkles.areaNames.map((name) => ({
    name,
    // The slider of a removed area exists until the next render.
    read: () => (wrinkles.hasArea(name) ? wrinkles.getActivation(name) : 0),
    write: (value) => wrinkles.setActivation(name, value),
  }))
}

/** Blendshape of a mesh: index by name, spelling of the name, and weights by index. */
interface Binding {
  indices: Record<string, number>
  spelling: string
  weights: number[]
}

/** Makes one dial per blendshape for all meshes that have it, so that skin, eyes, teeth and tongue move together. */
export function targetDials(root: Object3D): Dial[] {
  const bindings = new Map<string, Binding[]>()
  root.traverse((object) => {
    const { morphTargetDictionary: indices, morphTargetInfluences: weights } = object as Mesh
    if (!indices || !weights) return
    for (const spelling of Object.keys(indices)) {
      const name = canonicalTargetName(spelling)
      bindings.set(name, [...(bindings.get(name) ?? []), { indices, spelling, weights }])
    }
  })
  return [...bindings].map(([name, targets]) => ({
    name,
    // The slider of a removed muscle exists until the next render. Removal also changes other indices.
    read: () => {
      const [{ indices, spelling, weights }] = targets
      return weights[indices[spelling]] ?? 0
    },
    write: (value) => {
      for (const { indices, spelling, weights } of targets) {
        if (spelling in indices) weights[indices[spelling]] = value
      }
    },
  }))
}

/** Groups blendshapes by region, in display order. */
export function groupShapes<T extends { readonly name: string }>(shapes: readonly T[]): ShapeGroup<T>[] {
  const groups = GROUPS.map(([name]) => ({ name, shapes: [] as T[] }))
  for (const shape of shapes)
    groups[GROUPS.findIndex(([, prefix]) => prefix.test(shape.name))].shapes.push(shape)
  return groups.filter((group) => group.shapes.length > 0)
}
