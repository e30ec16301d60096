import { KEEPING } from '../../labels/project.ts'
import type { PanelModel } from '../model.ts'

/** Message about the state of saving in the browser, with buttons that solve problems. */
export function KeepStatus({ model: { saving, session, actions } }: { model: PanelModel }) {
  const state = saving.value
  if (!state) return null
  if (state.kind !== 'elsewhere' && state.kind !== 'newer') {
    const isFailed = state.kind === 'failed'
    const text = isFailed ? state.reason.message : KEEPING.kept
    return (
      <p class={isFailed ? 'hint warning' : 'hint'} role={isFailed ? 'alert' : 'status'} title={text}>
        {text}
      </p>
    )
  }
  const isChanged = session.undoLabel.value !== undefined
  return (
    <div class="elsewhere">
      <p class="hint warning" role="alert" title={KEEPING[state.kind]}>
        {KEEPING[state.kind]}
      </p>
      <div class="work">
        <button type="button" onClick={actions.keepCopy}>
          {KEEPING.keepCopy}
        </button>
        {!isChanged && (
          <button type="button" onClick={actions.takeOver}>
            {KEEPING.takeOver}
          </button>
        )}
      </div>
    </div>
  )
}
