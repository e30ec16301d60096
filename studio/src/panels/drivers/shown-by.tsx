import { useMemo } from 'preact/hooks'
import { shownByLabel, WHEN } from '../../labels/drivers.ts'
import { poseLabel } from '../../labels/joints.ts'
import { expressionLabel } from '../../labels/names.ts'
import { PosePicture } from '../controls/pose-picture.tsx'
import type { PanelModel } from '../model.ts'

/** Maximum number of pictures. Avatars can have hundreds of expressions. */
const MOST = 9

/** Pictures of the expressions that show an area, the strongest first, and of the poses of joints that fold it. Pressing one plays it. */
export function ShownBy({ area, model }: { area: string; model: PanelModel }) {
  const { viewer, revision, expression, bodyPose, pictures, actions } = model
  revision.value
  const face = viewer.value
  const drivers = face?.driven.drivers.list
  const expressions = face?.expressions
  // The lists of drivers and expressions are new objects after each change.
  const shown = useMemo(
    () => face?.expressionsShowing(area).slice(0, MOST) ?? [],
    [face, area, drivers, expressions],
  )
  const urls = pictures.urls.value
  const poses = face?.posesShowing(area) ?? []
  if (shown.length === 0 && poses.length === 0) return <p class="hint">{WHEN.noExpression}</p>
  return (
    <fieldset class="poses shown-by" aria-label={WHEN.expressions}>
      {shown.map(({ name, activation }) => {
        const label = expressionLabel(name)
        const text = shownByLabel(label, activation)
        return (
          <button
            key={name}
            type="button"
            aria-label={text}
            title={text}
            aria-pressed={expression.value === name}
            onClick={() => actions.play(name)}
          >
            <PosePicture url={urls.get(name)} />
            {label}
          </button>
        )
      })}
      {poses.map(({ name }) => (
        <button
          key={`pose ${name}`}
          type="button"
          aria-pressed={bodyPose.value === name}
          onClick={() => actions.playPose(name)}
        >
          <PosePicture url={urls.get(name)} />
          {poseLabel(name)}
        </button>
      ))}
    </fieldset>
  )
}
