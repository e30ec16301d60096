import { AUTOMATIC, SURFACES } from '../labels/automatic.ts'
import { cannotWrinkleLabel, INSPECTOR, NO_SHAPES } from '../labels/page.ts'
import type { PanelModel } from '../panels/model.ts'
import type { Viewer } from '../viewer/viewer.ts'

/** Kinds of surfaces that joints can fold. */
const FOLDING = ['skin', 'cloth'] as const

/** Tells why a skin cannot wrinkle, and how to change that. */
export function CannotWrinkle({ skin: { name, problem } }: { skin: Viewer['avatar']['skins'][number] }) {
  return <p class="hint no-shapes">{cannotWrinkleLabel(name, problem)}</p>
}

/** Tells what can be done with an avatar that has no blendshapes and no poses, and offers to fold it by its joints. */
export function NoShapes({ model, viewer }: { model: PanelModel; viewer: Viewer }) {
  const { source, auto, isBeginning, actions } = model
  const { avatar, wrinkles, skeleton } = viewer
  const skin = avatar.skins[avatar.skin]
  if (skin.problem !== null) return <CannotWrinkle skin={skin} />
  if (isBeginning.value) return <p class="hint no-shapes">{INSPECTOR.making}</p>
  const canFold = (source.value?.limbs.length ?? 0) > 0
  const isHard = (auto.value.kind ?? source.value?.surface.kind) === 'hard'
  return (
    <div class="no-shapes">
      <p class="hint">
        {NO_SHAPES.none} {canFold && (isHard ? NO_SHAPES.hard : AUTOMATIC.unknownSurface)}{' '}
        {skeleton.joints.length > 0 && NO_SHAPES.skeleton} {wrinkles ? NO_SHAPES.regions : NO_SHAPES.lines}
      </p>
      {canFold && (
        <div class="work">
          {FOLDING.map((kind) => (
            <button
              key={kind}
              type="button"
              title={SURFACES[kind].title}
              onClick={() => actions.makeAuto({ ...auto.peek(), kind })}
            >
              {SURFACES[kind].label}
            </button>
          ))}
        </div>
      )}
    </div>
  )
}
