import type { PanelModel } from '../model.ts'

/** Message about the state of saving in the browser, with buttons that solve problems. */
export function KeepStatus({ model: { saving, session, actions } }: { model: PanelModel }) {
  const state = saving.value
  if (!state) return null
  if (state.kind !== 'elsewhere') {
    const isFailed = state.kind === 'failed'
    return (
      <p class={isFailed ? 'hint warning' : 'hint'} role={isFailed ? 'alert' : 'status'}>
        {isFailed ? state.reason.message : 'Kept in this browser'}
      </p>
    )
  }
  const isChanged = session.undoLabel.value !== undefined
  return (
    <div class="elsewhere">
      <p class="hint warning" role="alert">
        Open in another tab, which alone keeps it: changes in this one are not kept
      </p>
      <div class="work">
        <button type="button" onClick={actions.keepCopy}>
          Keep a copy
        </button>
        {!isChanged && (
          <button type="button" onClick={actions.takeOver}>
            Go on here
          </button>
        )}
      </div>
    </div>
  )
}
