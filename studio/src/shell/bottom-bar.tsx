import { signal } from '@preact/signals'
import { expressionLabel } from '../labels/names.ts'
import { PLACES } from '../labels/page.ts'
import { PosePicture } from '../panels/controls/pose-picture.tsx'
import type { PanelModel } from '../panels/model.ts'
import { Targets } from '../panels/targets.tsx'
import { Icon } from '../ui/icon.tsx'
import { NoShapes } from './no-shapes.tsx'

/** Number of expressions that have a key. */
export const KEYS = 9

const isOpen = signal(false)

/** Bar below the stage: the expressions of this avatar, and the sliders of its blendshapes. */
export function BottomBar({ model }: { model: PanelModel }) {
  const { viewer, revision, expression, pictures, actions } = model
  revision.value
  const names = viewer.value?.expressions.map(({ name }) => name) ?? []
  const hasTargets = (viewer.value?.targets.length ?? 0) > 0
  if (viewer.value && !hasTargets) return <NoShapes viewer={viewer.value} />
  const urls = pictures.urls.value
  return (
    <>
      <div class="strip">
        <fieldset id="expressions" class="poses" aria-label={PLACES.expressions}>
          {names.map((name, i) => (
            <button
              key={name}
              type="button"
              aria-pressed={expression.value === name}
              data-key={i < KEYS ? i + 1 : undefined}
              aria-keyshortcuts={i < KEYS ? `${i + 1}` : undefined}
              title={i < KEYS ? `${expressionLabel(name)} (${i + 1})` : expressionLabel(name)}
              onClick={() => actions.play(name)}
            >
              <PosePicture url={urls.get(name)} />
              {expressionLabel(name)}
            </button>
          ))}
        </fieldset>
        {hasTargets && (
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
      <div id="target-panel" hidden={!hasTargets || !isOpen.value}>
        <Targets model={model} />
      </div>
    </>
  )
}
