import { CLOTH_KINDS, type ClothKind } from 'furrow/author'
import { SURFACE_KINDS } from 'furrow/internal'
import { AUTOMATIC, CLOTHS, SURFACES } from '../labels/automatic.ts'
import { Choice } from './controls/choice.tsx'
import type { PanelModel } from './model.ts'

const KINDS = SURFACE_KINDS.map((value) => ({ value, ...SURFACES[value] }))

/** Kind of a surface that joints move, and the kind of cloth. Asks for the kind if nothing tells it. */
export function SurfaceChoice({ model }: { model: PanelModel }) {
  const { auto, source, actions } = model
  if (!source.value || source.value.limbs.length === 0) return null
  const { surface } = source.value
  const settings = auto.value
  const kind = settings.kind ?? surface.kind
  return (
    <>
      {kind === undefined && <p class="hint">{AUTOMATIC.unknownSurface}</p>}
      <Choice
        label={AUTOMATIC.surface}
        options={KINDS}
        value={kind}
        onChange={(next) => actions.makeAuto({ ...settings, kind: next })}
      />
      {kind === 'cloth' && (
        <div class="settings">
          <div class="setting">
            <label for="cloth">{AUTOMATIC.cloth}</label>
            <select
              id="cloth"
              value={settings.cloth ?? surface.cloth}
              onChange={({ currentTarget }) =>
                actions.makeAuto({ ...settings, cloth: currentTarget.value as ClothKind })
              }
            >
              {CLOTH_KINDS.map((cloth) => (
                <option key={cloth} value={cloth}>
                  {CLOTHS[cloth]}
                </option>
              ))}
            </select>
          </div>
        </div>
      )}
    </>
  )
}
