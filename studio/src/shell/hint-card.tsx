import { FILE } from '../labels/project.ts'
import { HINTS } from '../labels/stage.ts'
import type { PanelModel } from '../panels/model.ts'

/** Hint over the face, for users who open their first avatar. */
export function HintCard({ model: { hints } }: { model: PanelModel }) {
  const shown = hints.shown.value
  if (!shown) return null
  return (
    <div class="hint-card" role="status">
      <p>{HINTS[shown]}</p>
      <button
        type="button"
        class="dismiss"
        aria-label={FILE.close}
        title={FILE.close}
        onClick={() => hints.dismiss()}
      >
        ×
      </button>
    </div>
  )
}
