import { signal } from '@preact/signals'
import { poseLabel } from '../labels/joints.ts'
import { expressionLabel } from '../labels/names.ts'
import { PLACES } from '../labels/page.ts'
import { PosePicture } from '../panels/controls/pose-picture.tsx'
import type { PanelModel } from '../panels/model.ts'
import { Poses } from '../panels/poses.tsx'
import { Targets } from '../panels/targets.tsx'
import { Icon } from '../ui/icon.tsx'
import { shownPoses } from '../viewer/shown-poses.ts'
import { NoShapes } from './no-shapes.tsx'

/** Number of expressions that have a key. */
export const KEYS = 9

const isOpen = signal(false)

/** Bar below the stage: the expressions of this avatar, the poses of its joints, and the sliders behind them. */
export function BottomBar({ model }: { model: PanelModel }) {
  const { viewer, revision, expression, bodyPose, pictures, actions } = model
  revision.value
  const poses = viewer.value ? shownPoses(viewer.value) : []
  if (viewer.value && poses.length === 0) return <NoShapes model={model} viewer={viewer.value} />
  const urls = pictures.urls.value
  return (
    <>
      <div class="strip">
        <fieldset id="expressions" class="poses" aria-label={PLACES.expressions}>
          {poses.map(({ kind, name }, i) => {
            const isExpression = kind === 'expression'
            const label = isExpression ? expressionLabel(name) : poseLabel(name)
            return (
              <button
                key={`${kind} ${name}`}
                type="button"
                aria-pressed={(isExpression ? expression : bodyPose).value === name}
                data-key={i < KEYS ? i + 1 : undefined}
                aria-keyshortcuts={i < KEYS ? `${i + 1}` : undefined}
                title={i < KEYS ? `${label} (${i + 1})` : label}
                onClick={() => (isExpression ? actions.play(name) : actions.playPose(name))}
              >
                <PosePicture url={urls.get(name)} />
                {label}
              </button>
            )
          })}
        </fieldset>
        {poses.length > 0 && (
          <button
            type="button"
            class="sliders"
            aria-expanded={isOpen.value}
            aria-controls="target-panel"
            onClick={() => {
              isOpen.value = !isOpen.value
            }}
          >
            <Icon name="sliders" />
            {PLACES.sliders}
          </button>
        )}
      </div>
      <div id="target-panel" hidden={poses.length === 0 || !isOpen.value}>
        <Poses model={model} />
        <Targets model={model} />
      </div>
    </>
  )
}
