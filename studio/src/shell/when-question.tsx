import { UNSET } from '../document/drivers.ts'
import { CARD, inExpression } from '../labels/stage.ts'
import type { PanelModel } from '../panels/model.ts'

/** Asks when a line shows that was drawn on bare skin: always, or with the expression that the face has. */
export function WhenQuestion({ model }: { model: PanelModel }) {
  const { lines, areas, viewer, frame, expression, actions } = model
  frame.value
  const isPosed = viewer.value?.targets.some((dial) => dial.read() > UNSET)
  const answer = (change?: () => void) => {
    change?.()
    lines.added.value = []
  }
  return (
    <fieldset class="when">
      <legend>{CARD.shows}</legend>
      <div class="work">
        <button type="button" onClick={() => answer()}>
          {CARD.always}
        </button>
        {isPosed && (
          <button
            type="button"
            onClick={() => answer(() => areas.showInPose(lines.added.peek(), actions.pose()))}
          >
            {inExpression(expression.value)}
          </button>
        )}
      </div>
      {!isPosed && <p class="hint">{CARD.noPose}</p>}
    </fieldset>
  )
}
