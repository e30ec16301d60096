import {
  CENTRAL,
  isCentral,
  isShifted,
  labelOf,
  mirroredLabel,
  SHIFTED,
  type ShapeLabel,
  SIDED,
  SPLIT,
} from '../families.ts'
import { halfField, mirroredField, sumOf } from '../fields/field-operations.ts'
import { MIRRORED } from '../fields/sample-points.ts'
import type { ShapeFields } from '../fields/shape-fields.ts'

/**
 * ARKit shapes of a reference head. The blendshapes of other heads are compared with these shapes. Families that have a left and a right
 * shape are stored once, as the left shape. All other shapes are symmetric, except `jawLeft` and `mouthLeft`.
 */
export interface TemplateHead {
  /** Weight of each sample point; see `ShapeFields`. */
  weights: Float64Array
  shapes: readonly TemplateShape[]
}

/** Shape of a head. `ShapeField` describes `field` and `strength`. */
export interface TemplateShape {
  family: string
  field: Float64Array
  strength: number
}

/** Shape of a head for one side or for both sides of the face. */
export interface Template extends ShapeLabel {
  field: Float64Array
  strength: number
}

/**
 * Creates a reference head from a head with ARKit shapes. The left half and the mirrored right half of the head are averaged.
 *
 * @param names ARKit name of each target.
 */
export function templateHead({ weights, shapes }: ShapeFields, names: readonly string[]): TemplateHead {
  const known = new Map<string, { field: Float64Array; strength: number }[]>()
  const add = (family: string, field: Float64Array, strength: number) =>
    known.set(family, [...(known.get(family) ?? []), { field, strength }])
  for (const { target, field, strength } of shapes) {
    const label = labelOf(names[target])
    if (!label || strength < 0.02) continue
    const { family, side } = label
    const mirrored = mirroredField(field)
    if (isShifted(family)) {
      if (family.endsWith('Left')) add(family, field, strength)
      else add(mirroredLabel(label).family, mirrored, strength)
    } else if (!isCentral(family)) {
      if (side !== 'both') add(family, side === 'left' ? field : mirrored, strength)
    } else if (side === 'both')
      add(
        family,
        sumOf(field, mirrored).map((x) => x / 2),
        strength,
      )
    // The rig splits this central shape. This half and its mirror image add up to the shape.
    else add(family, sumOf(field, mirrored), strength)
  }
  const symmetric = weights.map((weight, i) => (weight + weights[MIRRORED[i]]) / 2)
  const order = [...SIDED, ...CENTRAL, ...SHIFTED]
  const one = ({ family, ...shape }: TemplateShape): TemplateHead => ({
    weights: symmetric,
    shapes: [{ family, ...shape }],
  })
  return meanHead(
    order.flatMap((family) => (known.get(family) ?? []).map((shape) => one({ family, ...shape }))),
  )
}

/**
 * Returns the templates of a head. Families in `SIDED` and `SPLIT` have templates for the left side, the right side and both sides. Other
 * families in `CENTRAL` have one template for both sides. Shapes in `SHIFTED` also have mirror images.
 */
export function templatesOf({ shapes }: TemplateHead): Template[] {
  return shapes.flatMap(({ family, field, strength }): Template[] => {
    const mirrored = mirroredField(field)
    const own = { family, strength, field }
    if (isShifted(family)) {
      const other = mirroredLabel({ family, side: 'both' })
      return [
        { ...own, side: 'both' },
        { ...other, strength, field: mirrored },
      ]
    }
    if (!isCentral(family))
      return [
        { ...own, side: 'left' },
        { ...own, side: 'right', field: mirrored },
        { ...own, side: 'both', field: sumOf(field, mirrored) },
      ]
    const both: Template[] = [{ ...own, side: 'both' }]
    if (!SPLIT.includes(family)) return both
    const half = (side: 'left' | 'right'): Template => ({ ...own, side, field: halfField(field, side) })
    return [...both, half('left'), half('right')]
  })
}

export function meanHead(heads: readonly TemplateHead[]): TemplateHead {
  const families = [...new Set(heads.flatMap(({ shapes }) => shapes.map(({ family }) => family)))]
  return {
    weights: meanOf(heads.map(({ weights }) => weights)),
    shapes: families.map((family): TemplateShape => {
      const same = heads.flatMap(({ shapes }) => shapes.filter((shape) => shape.family === family))
      const strength = same.reduce((sum, shape) => sum + shape.strength / same.length, 0)
      return { family, strength, field: meanOf(same.map(({ field }) => field)) }
    }),
  }
}

function meanOf(fields: readonly Float64Array[]): Float64Array {
  return fields[0].map((_, k) => fields.reduce((sum, field) => sum + field[k], 0) / fields.length)
}
