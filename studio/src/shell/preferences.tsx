import type { WrinkleMode } from 'furrow/three'
import type { RendererKind } from '../../../stage/stage.ts'
import { type Appearance, chooseAppearance, chosenAppearance } from '../appearance.ts'
import { PREFERENCES } from '../labels/page.ts'
import { FILE } from '../labels/project.ts'
import { Check } from '../panels/controls/check.tsx'
import { Choice } from '../panels/controls/choice.tsx'
import type { PanelModel } from '../panels/model.ts'
import { isStatisticsShown } from '../statistics.ts'
import { Dialog } from '../ui/dialog.tsx'

const RENDERERS: readonly { value: RendererKind; label: string }[] = [
  { value: 'webgl', label: PREFERENCES.webgl },
  { value: 'webgpu', label: PREFERENCES.webgpu },
]

const MODES: readonly { value: Exclude<WrinkleMode, 'composed'>; label: string; title?: string }[] = [
  { value: 'default', label: PREFERENCES.default, title: PREFERENCES.defaultHint },
  { value: 'paper', label: PREFERENCES.paper, title: PREFERENCES.paperHint },
  { value: 'off', label: PREFERENCES.off },
]

const APPEARANCES: readonly { value: Appearance; label: string; title?: string }[] = [
  { value: 'system', label: PREFERENCES.system, title: PREFERENCES.systemHint },
  { value: 'light', label: PREFERENCES.light },
  { value: 'dark', label: PREFERENCES.dark },
]

/** Dialog with settings that users change rarely. */
export function Preferences({ model: { viewer, revision, dialogs, actions } }: { model: PanelModel }) {
  revision.value
  return (
    <Dialog title={FILE.preferences} isOpen={dialogs.preferences}>
      <div class="settings">
        <Choice
          label={PREFERENCES.page}
          options={APPEARANCES}
          value={chosenAppearance()}
          onChange={chooseAppearance}
        />
        <Choice
          label={PREFERENCES.renderer}
          options={RENDERERS}
          value={viewer.value?.kind ?? 'webgl'}
          onChange={actions.setRenderer}
        />
        <Choice
          label={PREFERENCES.wrinkles}
          options={MODES}
          value={(viewer.value?.mode ?? 'default') as (typeof MODES)[number]['value']}
          onChange={actions.setMode}
        />
        <Check value={isStatisticsShown}>{PREFERENCES.statistics}</Check>
      </div>
    </Dialog>
  )
}
