import { useId } from 'preact/hooks'
import { makingLabel } from '../labels/automatic.ts'
import { PAGE } from '../labels/page.ts'
import type { PanelModel } from './model.ts'

export function AutoProgress({ model: { autoRun, actions } }: { model: PanelModel }) {
  const id = useId()
  const run = autoRun.value
  if (!run) return null
  return (
    <div class="run">
      <label for={id}>{makingLabel(run.step)}</label>
      <progress id={id} max="1" value={run.fraction} />
      <button type="button" class="quiet" onClick={actions.cancelAuto}>
        {PAGE.cancel}
      </button>
    </div>
  )
}
