import { isSided, SHAPE_NAMES } from 'furrow/internal'
import { useState } from 'preact/hooks'
import { automaticShapeLabel, bothSidesLabel, SHAPES, shapeChoiceLabel } from '../../labels/blendshapes.ts'
import type { ShapeRow } from '../../session/shape-editor.ts'
import { groupShapes } from '../../viewer/pose/dials.ts'
import type { PanelModel } from '../model.ts'
import { recognisedLabel } from './recognised.ts'

/** Values of the options that are not ARKit shapes. */
const AUTOMATIC = ''
const NONE = '-'

const GROUPS = groupShapes(SHAPE_NAMES.map((name) => ({ name })))

/** Select by which the user corrects the ARKit shape that was recognised for a blendshape. */
export function ShapeChoice({ row, model: { shapes } }: { row: ShapeRow; model: PanelModel }) {
  const { name, recognised, correction } = row
  const label = recognisedLabel(recognised)
  // Fill the list only when the user opens it, because a thousand full lists would take seconds.
  const [isFull, setIsFull] = useState(false)
  const fill = () => setIsFull(true)
  return (
    <select
      aria-label={shapeChoiceLabel(name)}
      value={correction === undefined ? AUTOMATIC : (correction ?? NONE)}
      onPointerDown={fill}
      onFocus={fill}
      onBlur={() => shapes.settle()}
      onChange={({ currentTarget: { value } }) =>
        shapes.correct(name, value === AUTOMATIC ? undefined : value === NONE ? null : value)
      }
    >
      <option value={AUTOMATIC}>{automaticShapeLabel(label)}</option>
      {(isFull || correction === null) && <option value={NONE}>{SHAPES.noneOfThese}</option>}
      {isFull
        ? GROUPS.map((group) => (
            <optgroup key={group.name} label={group.name}>
              {group.shapes.map(({ name }) => (
                <option key={name} value={name}>
                  {isSided(name) ? bothSidesLabel(name) : name}
                </option>
              ))}
            </optgroup>
          ))
        : correction && <option value={correction}>{correction}</option>}
    </select>
  )
}
